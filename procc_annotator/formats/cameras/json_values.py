"""Numbers, vectors and matrices from decoded JSON, errors with their place."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass
from typing import Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.errors import CameraError
from procc_annotator.formats.strict_json import is_finite_number, json_kind, json_repr, printable

_CORRECT = "correct the file"
_WIDEST = 1_000_000
SIZE_KEYS = (("image_width", "image_height"), ("image_Width", "image_Height"), ("width", "height"))
# Keys, as words joined by "_", that other programs use for the lens, the pose or the picture size.
_CAMERA_KEY = re.compile(
    r"(^|_)(dist(ortions?)?|coef+s?|coefficients?|radial|tangential|prism|lens|fisheye|intrinsics?|"
    r"focal|principal|fov|skew|rotations?|rot|rvecs?|translations?|tvecs?|pose|extrinsics?|position|"
    r"orientation|quat(ernion)?|euler|pan|tilt|roll|yaw|transform|projection|homography|units?|lambda|"
    r"division|omega|tau|zoom|crop(ped)?|shift|aspect|pupil|mirror(ed)?|camera_matrix)(_|\d|$)|"
    r"^(k\d|p[12]|s[1-4]|f|fl|f[xy]|c[xy]|[uv]0|kc|xi|mtx|c2w|w2c|camera_(model|cent(er|re)))$|"
    r"^((image|img|im|picture|frame|video|sensor|camera|original)_?)?"
    r"(size|resolution|shape|width|height|[wh])$"
)
_CAMERA_LETTER = re.compile(r"[kdrtcpq]", re.IGNORECASE)  # where a list stands under it
_NO_PARAMETER = re.compile(
    r"(^|_)(errors?|scores?|loss|std|sd|sigma|cov|covariance|confidence|rms|ids?|names?)(_|$)"
)


@dataclass(frozen=True)
class JsonValues:
    """An object of a camera file.

    Args:
        path: the file, for messages.
        inside: where in the file the object stands; empty for all of it.
        kind: what it should be (``a SoccerNet camera``).
        nested: whether values may stand in lists of one (tensors that were written as they were).
    """

    content: Mapping[str, Any]
    path: str
    inside: str = ""
    kind: str = "a camera"
    nested: bool = False

    @classmethod
    def of(
        cls,
        value: object,
        path: str,
        inside: str = "",
        kind: str = "a camera",
        nested: bool = False,
    ) -> JsonValues:
        """The object that a decoded value is. `CameraError` if it is no object."""
        if type(value) is not dict:
            raise CameraError(
                path,
                f"expected an object with the keys of {kind}, found {json_kind(value)}",
                place=inside or "top level",
                advice="is this a camera?",
            )
        return cls(value, path, inside, kind, nested)

    def part(self, key: str, index: int | None = None) -> JsonValues:
        """The object under a key, or in the list under it. `CameraError` if there is none."""
        value = self.content.get(key)
        place = f"{self.inside}.{key}" if self.inside else key
        if index is not None:
            value = value[index] if type(value) is list else None
            place += f"[{index}]"
        return JsonValues.of(value, self.path, place, self.kind)

    def __contains__(self, key: str) -> bool:
        return key in self.content

    def error(self, problem: str, key: str = "", advice: str = _CORRECT) -> CameraError:
        """Return what is wrong with a key, or with the object."""
        place = ": ".join(part for part in (self.inside, key) if part)
        return CameraError(self.path, problem, place=place, advice=advice)

    def first_of(self, *keys: str) -> str | None:
        """The first of several spellings of a key that is there."""
        return next((key for key in keys if key in self.content), None)

    def need(self, expected: str, *keys: str) -> str:
        """The first of several spellings of a key.

        Raises:
            CameraError: none is there.
        """
        found = self.first_of(*keys)
        if found is None:
            raise self.missing(expected, *keys)
        return found

    def missing(self, expected: str, *keys: str) -> CameraError:
        """That none of several spellings of a key is there."""
        names = " or ".join(repr(key) for key in keys[:3])
        return self.error(
            f"the key {names} is missing, expected {expected}", advice=f"is this {self.kind}?"
        )

    def number(self, key: str) -> float:
        """A finite number. `CameraError` if the key is missing or holds something else."""
        if key not in self.content:
            raise self.missing("a number", key)
        return self.finite(self.bare(self.content[key]), key)

    def radians(self, *keys: str) -> tuple[float, ...]:
        """Angles in radians from keys that hold degrees; errors as `number`."""
        return tuple([math.radians(self.number(key)) for key in keys])

    def focal(self, key: str) -> float:
        """A number of pixels that is not zero. `CameraError` as `number`, or 0."""
        value = self.number(key)
        if value == 0:
            raise self.error("expected a focal length in pixels, found 0", key)
        return value

    def vector(self, key: str, length: int, advice: str = _CORRECT) -> tuple[float, ...]:
        """A list of a known number of finite numbers. `CameraError` if the key is missing or holds
        something else."""
        if key not in self.content:
            raise self.missing(f"{length} numbers", key)
        value = self.bare(self.content[key], length)
        if type(value) is not list or len(value) != length:
            found = f"{len(value)} values" if type(value) is list else json_repr(value)
            raise self.error(f"expected {length} numbers, found {found}", key, advice)
        return tuple([self.finite(number, f"{key}[{i}]") for i, number in enumerate(value)])

    def numbers(self, key: str) -> tuple[float, ...]:
        """All finite numbers of a list, or of a list of lists, row by row. `CameraError` if the key
        holds something else."""
        value = self.content.get(key)
        if type(value) is not list:
            raise self.error(f"expected a list of numbers, found {json_kind(value)}", key)
        flat: list[float] = []
        for i, part in enumerate(value):
            if type(part) is list:
                flat += [self.finite(v, f"{key}[{i}][{j}]") for j, v in enumerate(part)]
            else:
                flat.append(self.finite(part, f"{key}[{i}]"))
        return tuple(flat)

    def matrix(self, key: str, rows: int, columns: int) -> FloatArray:
        """A matrix, as a list of rows or of all its numbers row by row. `CameraError` if the key is
        missing or holds something else."""
        if key not in self.content:
            raise self.missing(f"{rows} x {columns} numbers", key)
        flat = self.numbers(key)
        ragged = any(type(row) is list and len(row) != columns for row in self.content[key])
        if len(flat) != rows * columns or (ragged and columns > 1):
            raise self.error(
                f"expected {rows} x {columns} numbers, found {len(flat)}"
                + (" in uneven rows" if len(flat) == rows * columns else ""),
                key,
            )
        return np.array(flat).reshape(rows, columns)

    def unused(self, *used: str) -> tuple[str, ...]:
        """Return a notice that names the keys that are not used although they look like a lens, a
        pose or a picture size, and hold something but zeros; the size's spellings are used."""
        known = {*used, *(key for pair in SIZE_KEYS for key in pair)}
        left = sorted(_camera_keys(self.content, known))
        named = ", ".join(printable(key, 40) for key in left)
        return (f"not used, though it looks like lens, pose or size: {named}",) if left else ()

    def size(self) -> tuple[int, int] | None:
        """(width, height) px where the object gives it. `CameraError` if it is no picture size."""
        return self.size_under(*SIZE_KEYS)

    def size_under(self, *spellings: tuple[str, str]) -> tuple[int, int] | None:
        """(width, height) px under the first pair of keys that is there. `CameraError` if it is no
        picture size, or only one of a pair is there."""
        for keys in spellings:
            if all(key in self.content for key in keys):
                return self.size_of(*keys)
        for keys in spellings:
            for key, other in (keys, keys[::-1]):
                if key in self.content:
                    raise self.error(
                        f"has {key!r} without {other!r}, expected both or neither",
                        key,
                        advice="add the other one",
                    )
        return None

    def size_of(self, *keys: str) -> tuple[int, int]:
        """(width, height) px under two keys that are there. `CameraError` if it is no picture
        size."""
        width, height = (self.bare(self.content[key]) for key in keys)
        # A larger picture does not exist; scaling by it would leave a camera of nothing.
        if all(is_finite_number(n) and n == int(n) and 2 <= n <= _WIDEST for n in (width, height)):
            return int(width), int(height)
        raise self.error(
            f"expected whole pixels, found {json_repr(width)} x {json_repr(height)}",
            " and ".join(keys),
        )

    def bare(self, value: Any, length: int = 0) -> Any:
        """A value out of the lists of one it may stand in."""
        while self.nested and type(value) is list and len(value) == 1:
            if length == 1 and type(value[0]) is not list:
                break
            value = value[0]
        return value

    def finite(self, value: object, key: str) -> float:
        """A value that is a finite number; the error names the key."""
        if not is_finite_number(value):
            raise self.error(f"expected a finite number, found {json_repr(value)}", key)
        return float(value)


def lists_objects(content: object, keys: Set[str], under: str = "") -> bool:
    """Return whether decoded content, or what is under a key of it, is a list with an object that
    has some keys."""
    if under:
        content = content.get(under) if type(content) is dict else None
    return type(content) is list and any(type(o) is dict and o.keys() >= keys for o in content)


def maps_objects(content: object, keys: Set[str]) -> bool:
    """Return whether decoded content is an object with an object in it that has some keys."""
    return type(content) is dict and lists_objects([*content.values()], keys)


def is_camera_key(key: str) -> bool:
    """Return whether a key looks like a lens, a pose or a picture size."""
    words = re.sub(r"[^A-Za-z0-9]+|(?<=[a-z0-9])(?=[A-Z])", "_", key).strip("_").lower()
    return bool(_CAMERA_KEY.search(words)) and not _NO_PARAMETER.search(words)


def _camera_keys(content: Mapping[str, Any], known: set[str]) -> Iterator[str]:
    for key, value in content.items():
        if key in known or not _holds_something(value):
            continue
        letter = _CAMERA_LETTER.fullmatch(key) and type(value) is list and len(value) > 1
        if letter or is_camera_key(key):
            yield key
        elif type(value) is dict:
            yield from (f"{key}.{inner}" for inner in _camera_keys(value, known))


def _holds_something(value: object) -> bool:
    if isinstance(value, list | dict):
        return any(map(_holds_something, value.values() if isinstance(value, dict) else value))
    return bool(value)
