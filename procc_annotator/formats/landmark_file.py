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
from typing import Annotated, Any

import msgspec
import numpy as np

from procc_annotator.errors import InputError
from procc_annotator.field.formulas import MAX_COORDINATE_M
from procc_annotator.field.model import Landmark
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.file_source import read_file
from procc_annotator.formats.strict_json import convert_as, decode_strict, json_kind, json_repr

LANDMARKS_FILE = "landmarks.json"

_MOST = 10_000
_COLOUR = re.compile(r"(#[0-9a-fA-F]{6})?")
_CORRECT = "correct the file"
# Of the largest entry: what rounding leaves of a matrix that was symmetric and positive.
_ROUNDING = 1e-9

_Text = Annotated[str, msgspec.Meta(max_length=200)]
_Metres = Annotated[float, msgspec.Meta(ge=-MAX_COORDINATE_M, le=MAX_COORDINATE_M)]
_Finite = Annotated[float, msgspec.Meta(ge=-1e300, le=1e300)]
_Row = tuple[_Finite, _Finite, _Finite]


class _Entry(msgspec.Struct, omit_defaults=True):
    """A landmark in the file; keys are written in this order."""

    name: _Text
    title: _Text = ""
    position: tuple[_Metres, _Metres, _Metres] | None = None
    covariance: tuple[_Row, _Row, _Row] | None = None
    instant: _Text | None = None
    moving: bool = False
    surveyed: bool = True
    colour: _Text = ""
    shortcut: _Text = ""
    note: _Text = ""
    frames: tuple[_Text, ...] = ()


_KEYS = _Entry.__struct_fields__
_TEXTS = ("name", "title", "instant", "shortcut", "note")


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
        """With an entry replaced in place, or appended if its name and instant are new."""
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
    """Write a file of landmarks in one step; the old one stays if that fails. `SaveError` if it
    could not be written."""
    write_atomic(path, encode_landmarks(landmarks), inside=path.parent)


def read_landmarks(data: bytes, *, path: str) -> LandmarkFile:
    """The landmarks of a file's content.

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
        landmark = _landmark(entry, path, f"landmarks[{i}]")
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
        known = msgspec.to_builtins(_Entry(*(getattr(mark, key) for key in _KEYS)))
        entries.append({**known, **dict(mark.extra)})
    content = {**dict(landmarks.extra), "landmarks": entries}
    return msgspec.json.format(msgspec.json.encode(content), indent=1) + b"\n"


def _landmark(entry: object, path: str, place: str) -> Landmark:
    def wrong(key: str, problem: str) -> InputError:
        return InputError(path, problem, place=f"{place}.{key}", advice=_CORRECT)

    found = convert_as(entry, _Entry, path=path, place=place)
    assert type(entry) is dict
    extra = tuple((k, v) for k, v in entry.items() if k not in _KEYS)
    landmark = Landmark(**msgspec.structs.asdict(found), extra=extra)
    texts = ((key, getattr(found, key) or "") for key in _TEXTS)
    frames = ((f"frames[{i}]", frame) for i, frame in enumerate(found.frames))
    for key, text in (*texts, *frames):
        if not text.isprintable():
            raise wrong(key, "expected one printable line")
    if not found.name.strip():
        raise wrong("name", "is empty")
    if not _COLOUR.fullmatch(found.colour):
        raise wrong("colour", f"expected #rrggbb, found {json_repr(found.colour)}")
    if found.covariance is not None:
        if found.position is None:
            raise wrong("covariance", "is of no use without a position")
        matrix = np.array(found.covariance)
        limit = _ROUNDING * max(float(np.abs(matrix).max()), 1e-300)
        if np.abs(matrix - matrix.T).max() > limit:
            raise wrong("covariance", "expected a symmetric matrix")
        if np.linalg.eigvalsh(matrix)[0] < -limit:
            raise wrong("covariance", "expected no negative variance in any direction")
    return landmark


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
