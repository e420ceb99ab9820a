"""Read and write ``landmarks.json``, the landmarks of a dataset.

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
from procc_annotator.field.formulas import MAX_COORDINATE_M
from procc_annotator.field.geometry import Covariance, Vector
from procc_annotator.field.model import Landmark
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.file_source import read_file
from procc_annotator.formats.strict_json import (
    decode_strict,
    is_finite_number,
    json_kind,
    json_repr,
)

LANDMARKS_FILE = "landmarks.json"

_LONGEST_TEXT = 200
_MOST = 10_000
_COLOUR = re.compile(r"#[0-9a-fA-F]{6}\Z")
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
_TEXTS = ("name", "title", "colour", "shortcut", "note")


@dataclass(frozen=True)
class LandmarkFile:
    """Content of a ``landmarks.json``.

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
    write_atomic(path, encode_landmarks(landmarks), inside=path.parent)


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
        found = json_kind(content) if type(content) is not dict else "an object without it"
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
            again = f" at instant {json_repr(key[1])}" if key[1] is not None else ""
            raise InputError(
                path,
                f"the landmark {json_repr(key[0])}{again} again, after landmarks[{seen[key]}]",
                place=f"landmarks[{i}].name",
                advice="keep one of them",
            )
        seen[key] = i
        landmarks.append(landmark)
    _check_motion(path, landmarks)
    extra = tuple((k, v) for k, v in content.items() if k != "landmarks")
    return LandmarkFile(tuple(landmarks), extra)


def encode_landmarks(landmarks: LandmarkFile) -> bytes:
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
        if type(entry) is not dict:
            raise self._error("", f"expected an object, found {json_kind(entry)}")
        if "name" not in entry:
            raise self._error("", "the key 'name' is missing")
        name, title, colour, shortcut, note = (
            self._text(key, entry.get(key, "")) for key in _TEXTS
        )
        landmark = Landmark(
            name,
            title,
            colour=colour,
            shortcut=shortcut,
            note=note,
            moving=self._flag("moving", entry.get("moving", False)),
            surveyed=self._flag("surveyed", entry.get("surveyed", True)),
            position=self._position(entry.get("position")),
            covariance=self._covariance(entry.get("covariance")),
            instant=self._instant(entry.get("instant")),
            frames=self._frames(entry.get("frames", [])),
            extra=tuple((k, v) for k, v in entry.items() if k not in _KEYS),
        )
        if not landmark.name.strip():
            raise self._error("name", "is empty")
        if landmark.colour and not _COLOUR.match(landmark.colour):
            raise self._error("colour", f"expected #rrggbb, found {json_repr(landmark.colour)}")
        if landmark.covariance is not None and landmark.position is None:
            raise self._error("covariance", "is of no use without a position")
        return landmark

    def _text(self, key: str, value: object) -> str:
        if type(value) is not str:
            raise self._error(key, f"expected text, found {json_repr(value)}")
        if len(value) > _LONGEST_TEXT or not value.isprintable():
            raise self._error(
                key, f"expected one printable line of at most {_LONGEST_TEXT} characters"
            )
        return value

    def _flag(self, key: str, value: object) -> bool:
        if type(value) is not bool:
            raise self._error(key, f"expected true or false, found {json_repr(value)}")
        return value

    def _instant(self, value: object) -> str | None:
        return None if value is None else self._text("instant", value)

    def _frames(self, value: object) -> tuple[str, ...]:
        if type(value) is not list:
            raise self._error("frames", f"expected a list of names, found {json_kind(value)}")
        return tuple([self._text(f"frames[{i}]", frame) for i, frame in enumerate(value)])

    def _position(self, value: object) -> Vector | None:
        if value is None:
            return None
        position = self._vector("position", value)
        for i, metres in enumerate(position):
            if abs(metres) > MAX_COORDINATE_M:
                raise self._error(
                    f"position[{i}]",
                    f"expected metres from the field's centre, at most {MAX_COORDINATE_M:g},"
                    f" found {metres:g}",
                )
        return position

    def _vector(self, key: str, value: object) -> Vector:
        if type(value) is not list or len(value) != 3:
            found = f"{len(value)} values" if type(value) is list else json_repr(value)
            raise self._error(key, f"expected 3 numbers, found {found}")
        for i, number in enumerate(value):
            if not is_finite_number(number):
                raise self._error(
                    f"{key}[{i}]", f"expected a finite number, found {json_repr(number)}"
                )
        x, y, z = (float(number) for number in value)
        return x, y, z

    def _covariance(self, value: object) -> Covariance | None:
        if value is None:
            return None
        if type(value) is not list or len(value) != 3:
            found = f"{len(value)} values" if type(value) is list else json_repr(value)
            raise self._error("covariance", f"expected 3 rows of 3 numbers, found {found}")
        first, second, third = (
            self._vector(f"covariance[{i}]", row) for i, row in enumerate(value)
        )
        matrix = np.array((first, second, third))
        limit = _ROUNDING * max(float(np.abs(matrix).max()), 1e-300)
        if np.abs(matrix - matrix.T).max() > limit:
            raise self._error("covariance", "expected a symmetric matrix")
        if np.linalg.eigvalsh(matrix)[0] < -limit:
            raise self._error("covariance", "expected no negative variance in any direction")
        return first, second, third

    def _error(self, key: str, problem: str) -> InputError:
        place = f"{self._place}.{key}" if key else self._place
        return InputError(self._path, problem, place=place, advice=_CORRECT)


def _check_motion(path: str, landmarks: Sequence[Landmark]) -> None:
    """Refuse what may as well stay as move: one cannot know where it is at other instants."""
    moving = {mark.name.strip() for mark in landmarks if mark.moving}
    for i, mark in enumerate(landmarks):
        name = mark.name.strip()
        if name in moving and mark.position is not None and mark.instant is None:
            raise InputError(
                path,
                "is missing: a moving landmark's position holds for one",
                place=f"landmarks[{i}].instant",
                advice=_CORRECT,
            )
        if name not in moving and mark.instant is not None:
            raise InputError(
                path,
                f"is for what moves, and nothing says that {json_repr(name)} does",
                place=f"landmarks[{i}].instant",
                advice=f'add {{"name": {json_repr(name)}, "moving": true}},'
                " or leave out the instant",
            )
