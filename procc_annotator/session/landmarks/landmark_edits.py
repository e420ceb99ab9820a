"""Edits of a dataset's landmarks, as the hand of a person makes them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.geometry import Vector
from procc_annotator.field.landmarks import is_moving, without_landmarks
from procc_annotator.field.model import Field, Landmark
from procc_annotator.io.landmark_file import LandmarkFile, encode_landmarks, read_landmarks


def with_new_landmark(file: LandmarkFile, name: str, field: Field) -> LandmarkFile:
    """With a new landmark whose position is not known yet.

    Raises:
        UsageError: the name cannot be one, or is taken.
    """
    name = name.strip()
    require_free(name, field)
    if any(mark.name.strip() == name for mark in file.landmarks):
        raise UsageError(f"there is a landmark {name!r} already")
    return checked_landmarks(replace(file, landmarks=(*file.landmarks, Landmark(name))))


def require_free(name: str, field: Field) -> None:
    """Refuse a landmark with the name of a class of the field.

    Raises:
        UsageError: it is one.
    """
    plain = without_landmarks(field)
    if plain.knows(plain.canonical_name(name)):
        raise UsageError(f"{name!r} is a class of the field: give the landmark another name")


def with_surveyed_position(file: LandmarkFile, name: str, position: Vector) -> LandmarkFile:
    """With the place of a landmark that somebody measured; one that is not known yet is added.

    Raises:
        UsageError: it moves, or it cannot be a landmark's name or place.
    """
    entries = _entries(file, name) or [Landmark(name)]
    own = _appearance_entry(entries)
    if any(map(is_moving, entries)):
        raise UsageError(f"{own.shown_title} moves: its positions hold for an instant each")
    return checked_landmarks(
        file.with_landmark(
            replace(own, position=position, covariance=None, surveyed=True, frames=())
        )
    )


def with_title(file: LandmarkFile, name: str, title: str) -> LandmarkFile:
    """With what people call a landmark; its class keeps its name.

    Raises:
        UsageError: it cannot be called so.
    """
    entries = _entries(file, name)
    if not entries:
        raise UsageError(f"there is no landmark {name!r}")
    own = _appearance_entry(entries)
    title = title.strip()
    return checked_landmarks(
        file.with_landmark(replace(own, title="" if title == name.strip() else title))
    )


def parse_position(text: str) -> Vector:
    """Read ``x, y, z``, metres.

    Raises:
        UsageError: it is something else.
    """
    try:
        x, y, z = (float(part) for part in text.replace(";", ",").split(","))
    except ValueError as error:
        raise UsageError(
            f"{text!r} is no place: write x, y, z in metres from the field's centre, z down"
        ) from error
    return x, y, z


def parse_surveyed(text: str) -> tuple[str, Vector]:
    """Read ``NAME=x,y,z``: a landmark and its place, metres.

    Raises:
        UsageError: it is something else.
    """
    name, _, place = text.rpartition("=")
    if not name.strip():
        raise UsageError(f"{text!r} names no landmark: expected NAME=X,Y,Z")
    return name.strip(), parse_position(place)


def checked_landmarks(file: LandmarkFile) -> LandmarkFile:
    """The landmarks, if a file may hold them.

    Raises:
        UsageError: it may not.
    """
    try:
        return read_landmarks(encode_landmarks(file), path="landmarks")
    except InputError as error:
        raise UsageError(f"not a landmark: {error.problem}") from error


def _entries(file: LandmarkFile, name: str) -> list[Landmark]:
    return [mark for mark in file.landmarks if mark.name.strip() == name.strip()]


def _appearance_entry(entries: Sequence[Landmark]) -> Landmark:
    """The entry that says what a landmark is called and how it looks."""
    return next((mark for mark in entries if mark.instant is None), entries[0])
