"""``landmarks.json``: the landmarks of a dataset, beside its pictures (docs/landmarks.md).

An object with a list ``landmarks``; of each entry only ``name`` is needed::

    {"landmarks": [{"name": "Floodlight NE", "position": [61.2, -45.0, -28.4]}]}

Keys that are not known are kept and written back.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from procc_annotator.errors import InputError
from procc_annotator.field.landmarks import Covariance, Landmark, is_moving
from procc_annotator.field.values import FARTHEST_M
from procc_annotator.io.atomic import write_atomic
from procc_annotator.io.json_text import decode_strict, is_finite_number, kind_of, printable, shown
from procc_annotator.io.source import read_file

LANDMARKS_FILE = "landmarks.json"

_LONGEST_TEXT = 200
_MOST = 10_000
_COLOUR = re.compile(r"#[0-9a-fA-F]{6}\Z")
_PLACE = re.compile(r" - at `\$(?P<place>[^`]*)`\Z")
_CORRECT = "correct the file"
# Of the largest entry: what rounding leaves of a matrix that was symmetric and positive.
_ROUNDING = 1e-9


class _Entry(msgspec.Struct, omit_defaults=True):
    """A landmark as it is written; keys in this order."""

    name: str
    title: str = ""
    position: tuple[float, float, float] | None = None
    covariance: (
        tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]
        | None
    ) = None
    instant: str | None = None
    moving: bool = False
    surveyed: bool = True
    colour: str = ""
    shortcut: str = ""
    note: str = ""
    frames: tuple[str, ...] = ()


_KEYS = frozenset(_Entry.__struct_fields__)


@dataclass(frozen=True)
class LandmarkFile:
    """What a ``landmarks.json`` holds.

    Attributes:
        landmarks: in the file's order; at most one entry a name and instant.
        extra: top-level keys that we do not know.
    """

    landmarks: tuple[Landmark, ...] = ()
    extra: tuple[tuple[str, Any], ...] = field(default=())

    def with_landmark(self, landmark: Landmark) -> LandmarkFile:
        """With an entry replaced in place, or appended if there is none of its name and instant."""
        key = landmark.name, landmark.instant
        there = any((mark.name, mark.instant) == key for mark in self.landmarks)
        kept = [landmark if (m.name, m.instant) == key else m for m in self.landmarks]
        return replace(self, landmarks=(*kept, *(() if there else (landmark,))))

    def without(self, name: str) -> LandmarkFile:
        """Without every entry of a name."""
        return replace(self, landmarks=tuple(m for m in self.landmarks if m.name != name))


def load_landmarks(path: Path) -> LandmarkFile:
    """Read a file of landmarks; one that is not there holds none.

    Raises:
        InputError: it cannot be read, or what is wrong in it and where.
    """
    try:
        data = read_file(path)
    except InputError as error:
        if isinstance(error.__cause__, FileNotFoundError):
            return LandmarkFile()
        raise
    return read_landmarks(data, path=str(path))


def save_landmarks(path: Path, landmarks: LandmarkFile) -> None:
    """Write a file of landmarks in one step; the old one stays if that fails.

    Raises:
        SaveError: it could not be written.
    """
    write_atomic(path, write_landmarks(landmarks), inside=path.parent)


def read_landmarks(data: bytes, *, path: str) -> LandmarkFile:
    """The landmarks of a file's content.

    Args:
        data: JSON.
        path: for errors.

    Raises:
        InputError: what is wrong and where (``landmarks[2].position[1]``).
    """
    content = decode_strict(data, path=path, error=InputError)
    if type(content) is not dict or type(content.get("landmarks")) is not list:
        found = kind_of(content) if type(content) is not dict else "an object without it"
        raise InputError(
            path,
            f"expected an object with a list 'landmarks', found {found}",
            advice="is this a file of landmarks?",
        )
    entries = content["landmarks"]
    if len(entries) > _MOST:
        raise InputError(path, f"holds {len(entries)} landmarks, expected at most {_MOST}")
    landmarks: list[Landmark] = []
    seen: dict[tuple[str, str | None], int] = {}
    for i, entry in enumerate(entries):
        landmark = _Reader(path, f"landmarks[{i}]").landmark(entry)
        key = landmark.name.strip(), landmark.instant
        if key in seen:
            again = f" at instant {shown(key[1])}" if key[1] is not None else ""
            raise InputError(
                path,
                f"the landmark {shown(key[0])}{again} again, after landmarks[{seen[key]}]",
                place=f"landmarks[{i}].name",
                advice="keep one of them",
            )
        seen[key] = i
        landmarks.append(landmark)
    extra = tuple((k, v) for k, v in content.items() if k != "landmarks")
    return LandmarkFile(tuple(landmarks), extra)


def write_landmarks(landmarks: LandmarkFile) -> bytes:
    """The content of the file; reading it gives the same landmarks, to the last digit."""
    entries = []
    for mark in landmarks.landmarks:
        known = msgspec.to_builtins(
            _Entry(
                mark.name,
                mark.title,
                mark.position,
                mark.covariance,
                mark.instant,
                mark.moving,
                mark.surveyed,
                mark.colour,
                mark.shortcut,
                mark.note,
                mark.frames,
            )
        )
        entries.append({**known, **dict(mark.extra)})
    content = {**dict(landmarks.extra), "landmarks": entries}
    return msgspec.json.format(msgspec.json.encode(content), indent=1) + b"\n"


class _Reader:
    """Reads one entry; every error names its place in the file."""

    def __init__(self, path: str, place: str) -> None:
        self._path = path
        self._place = place

    def landmark(self, entry: object) -> Landmark:
        try:
            read = msgspec.convert(entry, _Entry)
        except msgspec.ValidationError as error:
            raise self._wrong_type(str(error)) from error
        for key in ("name", "title", "colour", "shortcut", "note", "instant"):
            self._text(key, getattr(read, key))
        for i, frame in enumerate(read.frames):
            self._text(f"frames[{i}]", frame)
        if not read.name.strip():
            raise self._error("name", "is empty")
        if read.colour and not _COLOUR.match(read.colour):
            raise self._error("colour", f"expected #rrggbb, found {shown(read.colour)}")
        self._position(read.position)
        if read.covariance is not None:
            self._covariance(read.covariance, read.position is not None)
        assert isinstance(entry, dict)  # msgspec takes objects only
        landmark = Landmark(
            **{key: getattr(read, key) for key in _KEYS},
            extra=tuple((k, v) for k, v in entry.items() if k not in _KEYS),
        )
        if is_moving(landmark) and landmark.position is not None and landmark.instant is None:
            raise self._error("instant", "is missing: a moving landmark's position holds for one")
        return landmark

    def _position(self, position: Sequence[float] | None) -> None:
        for i, value in enumerate(position or ()):
            if not is_finite_number(value) or abs(value) > FARTHEST_M:
                raise self._error(
                    f"position[{i}]",
                    f"expected metres from the field's centre, at most {FARTHEST_M:g},"
                    f" found {shown(value)}",
                )

    def _covariance(self, covariance: Covariance, placed: bool) -> None:
        if not placed:
            raise self._error("covariance", "is of no use without a position")
        for i, row in enumerate(covariance):
            for j, value in enumerate(row):
                if not is_finite_number(value):
                    raise self._error(
                        f"covariance[{i}][{j}]", f"expected a finite number, found {shown(value)}"
                    )
        matrix = np.array(covariance)
        limit = _ROUNDING * max(float(np.abs(matrix).max()), 1e-300)
        if np.abs(matrix - matrix.T).max() > limit:
            raise self._error("covariance", "expected a symmetric matrix")
        if np.linalg.eigvalsh(matrix)[0] < -limit:
            raise self._error("covariance", "expected no negative variance in any direction")

    def _text(self, key: str, text: str | None) -> None:
        if text and (len(text) > _LONGEST_TEXT or not text.isprintable()):
            raise self._error(
                key, f"expected one printable line of at most {_LONGEST_TEXT} characters"
            )

    def _wrong_type(self, said: str) -> InputError:
        found = _PLACE.search(said)
        inner = printable(found["place"].removeprefix("."), 120) if found else ""
        problem = said[: found.start()] if found else said
        return self._error(inner, problem[:1].lower() + problem[1:])

    def _error(self, key: str, problem: str) -> InputError:
        place = f"{self._place}.{key}" if key else self._place
        return InputError(self._path, problem, place=place, advice=_CORRECT)
