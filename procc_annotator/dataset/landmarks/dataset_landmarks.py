"""Landmarks of a dataset: read with its field, edit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from procc_annotator.dataset.landmarks.view_groups import ViewGroups, load_views
from procc_annotator.dataset.layout import VIEWS_FILE, folder_of_dataset
from procc_annotator.errors import FieldError, InputError, UsageError
from procc_annotator.field.geometry import Vector
from procc_annotator.field.landmarks import is_moving, with_landmarks, without_landmarks
from procc_annotator.field.model import Field, Landmark
from procc_annotator.formats.file_listing import ANNOTATIONS_FOLDER, frame_in_tree
from procc_annotator.formats.file_source import suffix_of, walk
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.formats.landmark_file import (
    LANDMARKS_FILE,
    LandmarkFile,
    encode_landmarks,
    load_landmarks,
    read_landmarks,
)

if TYPE_CHECKING:
    from procc_annotator.dataset.workspace import Workspace


def with_new_landmark(file: LandmarkFile, name: str, field: Field) -> LandmarkFile:
    """With a new landmark without a known position. `UsageError` if the name cannot be one, or is
    taken."""
    name = name.strip()
    require_free(name, field)
    if any(mark.name.strip() == name for mark in file.landmarks):
        raise UsageError(f"there is a landmark {name!r} already")
    return checked_landmarks(replace(file, landmarks=(*file.landmarks, Landmark(name))))


def require_free(name: str, field: Field) -> None:
    """Refuse, by `UsageError`, a landmark with the name of a class of the field."""
    plain = without_landmarks(field)
    if plain.knows(plain.canonical_name(name)):
        raise UsageError(f"{name!r} is a class of the field: give the landmark another name")


def with_surveyed_position(file: LandmarkFile, name: str, position: Vector) -> LandmarkFile:
    """With the place of a landmark that a person measured; one that is not known yet is added.
    `UsageError` if it moves, or it cannot be a landmark's name or place."""
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
    """With what people call a landmark; its class keeps its name. `UsageError` if it cannot be
    called so."""
    entries = _entries(file, name)
    if not entries:
        raise UsageError(f"there is no landmark {name!r}")
    own = _appearance_entry(entries)
    title = title.strip()
    return checked_landmarks(
        file.with_landmark(replace(own, title="" if title == name.strip() else title))
    )


def parse_position(text: str) -> Vector:
    """Read ``x, y, z``, metres; `UsageError` if it is something else."""
    try:
        x, y, z = (float(part) for part in text.replace(";", ",").split(","))
    except ValueError as error:
        raise UsageError(
            f"{text!r} is no place: write x, y, z in metres from the field's centre, z down"
        ) from error
    return x, y, z


def parse_surveyed(text: str) -> tuple[str, Vector]:
    """Read ``NAME=x,y,z``: a landmark and its place, metres; else `UsageError`."""
    name, _, place = text.rpartition("=")
    if not name.strip():
        raise UsageError(f"{text!r} names no landmark: expected NAME=X,Y,Z")
    return name.strip(), parse_position(place)


def checked_landmarks(file: LandmarkFile) -> LandmarkFile:
    """The landmarks, if a file may hold them; else `UsageError`."""
    try:
        return read_landmarks(encode_landmarks(file), path="landmarks")
    except InputError as error:
        raise UsageError(f"not a landmark: {error.problem}") from error


def _entries(file: LandmarkFile, name: str) -> list[Landmark]:
    return [mark for mark in file.landmarks if mark.name.strip() == name.strip()]


def _appearance_entry(entries: Sequence[Landmark]) -> Landmark:
    return next((mark for mark in entries if mark.instant is None), entries[0])


def read_dataset_landmarks(dataset: Path) -> tuple[LandmarkFile, ViewGroups]:
    """Return what the files of a dataset, see `folder_of_dataset`, say; nothing where there are
    none. `InputError` if one of them cannot be used."""
    folder = folder_of_dataset(dataset)
    return (LandmarkFile(), ViewGroups()) if folder is None else read_landmarks_in(folder)


def read_landmarks_in(folder: Path) -> tuple[LandmarkFile, ViewGroups]:
    """As `read_dataset_landmarks`, of the files in a dataset's folder."""
    return load_landmarks(folder / LANDMARKS_FILE), load_views(folder / VIEWS_FILE)


def unknown_frames_message(groups: ViewGroups, workspace: Workspace) -> str:
    """Return the remark on rows of a ``views.csv`` that name a frame which a dataset has not, in
    one sentence; empty where there are none. Safe from any thread."""
    if not workspace.frames or not groups.unknown_frames(workspace.index):
        return ""
    there = {*workspace.index, *_annotated_in(workspace.annotations)}
    count = len(groups.unknown_frames(there))
    if not count:
        return ""
    (first,) = groups.unknown_rows(there, 1)
    if count == 1:
        return first
    return f"{first} (and {count - 1:,} more {'row' if count == 2 else 'rows'} like it)"


def _annotated_in(folder: Path) -> Iterator[str]:
    for below, names in walk(folder, lambda _: None) if folder.is_dir() else ():
        for name in names:
            if suffix_of(name) == ".json":
                yield frame_in_tree(below + name, ANNOTATIONS_FOLDER)


def field_with(field: Field, landmarks: LandmarkFile, groups: ViewGroups, path: Path) -> Field:
    """The field with a dataset's landmarks, from a file at a path. `InputError`, with the entry, if
    a landmark has the name of a class of the field."""
    instants = FrameTable((frame, of.instant) for frame, of in groups.frames.items())
    try:
        return with_landmarks(field, landmarks.landmarks, None, instants)
    except FieldError as error:
        raise InputError(path, error.problem, place=error.place, advice=error.advice) from error


def field_of_dataset_with_landmarks(field: Field, *datasets: Path) -> Field:
    """The field with the landmarks of the first of these datasets that has any. `InputError` if
    their file cannot be used."""
    for dataset in datasets:
        landmarks, groups = read_dataset_landmarks(dataset)
        if landmarks.landmarks:
            folder = folder_of_dataset(dataset) or dataset
            return field_with(field, landmarks, groups, folder / LANDMARKS_FILE)
    return field
