"""NumPy ``.npy``/``.npz`` and MATLAB level-5 files as plain lists and numbers."""

from __future__ import annotations

import io
import math
import re
import struct
import tokenize
import warnings
import zipfile
import zlib
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.json_values import is_camera_key
from procc_annotator.formats.strict_json import printable

MAGIC = b"MATLAB 5.0 MAT-file"
_HEADER = 128
_ORDERS = {b"IM": "<", b"MI": ">"}
_NUMBERS = {
    1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8",
}  # fmt: skip
_MATRIX, _COMPRESSED = 14, 15
_TEXTS = {1: "latin-1", 2: "latin-1", 4: "utf-16", 16: "utf-8", 17: "utf-16", 18: "utf-32"}
_CELL, _STRUCTURE, _CHARACTERS = 1, 2, 4
_CLASSES = {
    6: "f8", 7: "f4", 8: "i1", 9: "u1", 10: "i2", 11: "u2", 12: "i4", 13: "u4", 14: "i8", 15: "u8",
}  # fmt: skip
_COMPLEX = 0x0800
_LARGEST = 64 * 1024 * 1024  # once decompressed
_DEEPEST = 16
_MOST_DIMENSIONS = 32
_MOST_NUMBERS = 1_000_000  # of one array


class _DamagedError(Exception):
    """The file is damaged; the message says how."""


class _Element(NamedTuple):
    kind: int
    data: bytes


def matlab_content(data: bytes, path: str) -> dict[str, Any]:
    """The variables of a file by name.

    Returns:
        Arrays as nested lists without axes of length 1, a single value as itself, texts, cell
        arrays as lists, structures as objects or lists of them; None for anything else.

    Raises:
        CameraError: damaged, cut off, or too large.
    """
    try:
        return _File(data).variables()
    except _DamagedError as error:
        raise CameraError(
            path,
            f"is not a readable MATLAB file of level 5: {error}",
            advice="the file may be cut off: save it again",
        ) from error


class _File:
    def __init__(self, data: bytes) -> None:
        order = _ORDERS.get(data[126:128])
        if len(data) < _HEADER or order is None:
            raise _DamagedError("its header of 128 bytes is cut off or damaged")
        self._data = data
        self._order = order
        self._skipped_frames = _LARGEST

    def variables(self) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for element in self._elements(self._data, _HEADER):
            if element.kind == _COMPRESSED:
                inner = list(self._elements(self._inflated(element.data)))
                if len(inner) != 1:
                    raise _DamagedError(f"expected one variable in a part, found {len(inner)}")
                element = inner[0]
            if element.kind != _MATRIX:
                raise _DamagedError(f"expected a variable, found an element of type {element.kind}")
            name, value = self._variable(element.data, 0)
            if name and not name.startswith("__"):
                found[name] = value
        return found

    def _inflated(self, data: bytes) -> bytes:
        reader = zlib.decompressobj()
        try:
            found = reader.decompress(data, self._skipped_frames + 1)
        except zlib.error as error:
            raise _DamagedError(f"a compressed part is damaged ({error})") from error
        self._skipped_frames -= len(found)
        if self._skipped_frames < 0 or not reader.eof:
            what = "is too large" if self._skipped_frames < 0 else "is cut off"
            raise _DamagedError(f"a compressed part {what}")
        return found

    def _elements(self, data: bytes, at: int = 0) -> Iterator[_Element]:
        while at < len(data):
            if at + 8 > len(data):
                raise _DamagedError(f"it ends within an element, at byte {at}")
            word, size = struct.unpack_from(f"{self._order}II", data, at)
            kind, start, following = word, at + 8, 0
            if word >> 16:  # so little data that it stands in the element's head
                kind, size, start, following = word & 0xFFFF, word >> 16, at + 4, at + 8
                if size > 4:
                    raise _DamagedError(f"a small element of {size} bytes, at byte {at}")
            if start + size > len(data):
                raise _DamagedError(f"it ends within an element of {size} bytes, at byte {at}")
            yield _Element(kind, data[start : start + size])
            padding = 0 if kind == _COMPRESSED else -size % 8
            at = following or start + size + padding

    def _variable(self, data: bytes, depth: int) -> tuple[str, Any]:
        """Name and value of an element of the type miMATRIX."""
        if depth > _DEEPEST:
            raise _DamagedError("it is nested too deeply")
        if not data:  # an empty cell or field
            return "", []
        parts = self._elements(data)
        flags = self._whole(_next(parts, "flags"), "flags")
        kind = flags[0] & 0xFF if flags else 0
        if kind not in _CLASSES and kind not in (_CELL, _STRUCTURE, _CHARACTERS):
            return _name_of(parts), None  # objects, functions, sparse matrices
        shape = self._whole(_next(parts, "dimensions"), "dimensions")
        if not 2 <= len(shape) <= _MOST_DIMENSIONS or min(shape) < 0:
            raise _DamagedError(f"dimensions {shape} of a variable")
        name = self._text(_next(parts, "name"))
        if kind == _CELL:
            return name, _alone(self._values(parts, math.prod(shape), depth))
        if kind == _STRUCTURE:
            return name, _alone(self._structures(parts, math.prod(shape), depth))
        if kind == _CHARACTERS:
            return name, self._characters(_next(parts, "characters"), shape)
        if flags[0] & _COMPLEX:
            return name, None
        return name, self._numbers(_next(parts, "numbers"), shape, _CLASSES[kind])

    def _values(self, parts: Iterator[_Element], count: int, depth: int) -> list[Any]:
        found = []
        for element in parts:
            if element.kind != _MATRIX:
                raise _DamagedError(f"expected a variable in a cell, found type {element.kind}")
            found.append(self._variable(element.data, depth + 1)[1])
        if len(found) != count:
            raise _DamagedError(f"expected {count} cells or fields, found {len(found)}")
        return found

    def _structures(self, parts: Iterator[_Element], count: int, depth: int) -> list[Any]:
        lengths = self._whole(_next(parts, "length of field names"), "length of field names")
        text = _next(parts, "field names").data
        length = lengths[0] if lengths else 0
        if length < 1 or len(text) % length:
            raise _DamagedError("the names of a structure's fields")
        names = [
            text[i : i + length].split(b"\0")[0].decode("latin-1")
            for i in range(0, len(text), length)
        ]
        values = self._values(parts, count * len(names), depth)
        if not names:
            return []
        return [
            dict(zip(names, values[i : i + len(names)], strict=True))
            for i in range(0, len(values), len(names))
        ]

    def _characters(self, element: _Element, shape: list[int]) -> Any:
        rows, text = shape[0], self._text(element)
        if rows < 2 or not text:
            return text
        if math.prod(shape) != len(text):
            raise _DamagedError(f"expected {math.prod(shape)} characters, found {len(text)}")
        return [text[row::rows].rstrip() for row in range(rows)]

    def _numbers(self, element: _Element, shape: list[int], dtype: str) -> Any:
        array = self._array(element, "numbers")
        if len(array) != math.prod(shape):
            raise _DamagedError(f"expected {math.prod(shape)} numbers, found {len(array)}")
        if not len(array):
            return []  # whatever its dimensions: a list of so many empty ones may fill the memory
        with np.errstate(all="ignore"):
            array = array.astype(dtype).reshape(shape, order="F").squeeze()
            if array.ndim == 0:
                return array.item()
            if array.size > _MOST_NUMBERS:
                return None  # a picture, say: no part of a camera
            return array.astype(np.float64).tolist()

    def _whole(self, element: _Element, what: str) -> list[int]:
        array = self._array(element, what)
        if array.dtype.kind == "f":
            raise _DamagedError(f"expected whole numbers as {what}")
        return [int(value) for value in array.tolist()]

    def _array(self, element: _Element, what: str) -> Any:
        dtype = _NUMBERS.get(element.kind)
        if dtype is None:
            raise _DamagedError(f"expected {what}, found an element of type {element.kind}")
        known = np.dtype(f"{self._order}{dtype}")
        if len(element.data) % known.itemsize:
            raise _DamagedError(f"{len(element.data)} bytes are no {what}")
        return np.frombuffer(element.data, known)

    def _text(self, element: _Element) -> str:
        coding = _TEXTS.get(element.kind)
        if coding is None:
            raise _DamagedError(f"expected a text, found an element of type {element.kind}")
        if coding in ("utf-16", "utf-32"):
            coding += "-le" if self._order == "<" else "-be"
        try:
            return element.data.decode(coding)
        except UnicodeDecodeError as error:
            raise _DamagedError(
                f"a text that cannot be read ({printable(str(error), 80)})"
            ) from error


def _next(parts: Iterator[_Element], what: str) -> _Element:
    found = next(parts, None)
    if found is None:
        raise _DamagedError(f"a variable without {what}")
    return found


def _name_of(parts: Iterator[_Element]) -> str:
    named = [part.data for part in parts if part.kind in (1, 2)]
    return named[0].decode("latin-1") if named else ""


def _alone(values: list[Any]) -> Any:
    """Return what a cell array or an array of structures is: of one thing that thing."""
    return values[0] if len(values) == 1 else values


NPY_MAGIC = b"\x93NUMPY"
_NPZ_MAGIC = b"PK"
_MAT73 = b"MATLAB 7.3 MAT-file"
# What numpy raises for headers that are wrong in one way or another; one that announces terabytes
# is a MemoryError.
NPY_ERRORS = (
    ValueError,
    TypeError,
    LookupError,
    AttributeError,
    EOFError,
    OSError,
    SyntaxError,
    tokenize.TokenError,
    MemoryError,
    ArithmeticError,
    RecursionError,
)
# And what opening an archive adds; RuntimeError is an encrypted member.
_NPZ_ERRORS = (*NPY_ERRORS, zipfile.BadZipFile, zlib.error, RuntimeError, NotImplementedError)
_LARGEST_MEMBER = 4 * 1024 * 1024  # the projection matrices of 40,000 frames
_MOST_MEMBERS = 20_000
_DEPTHS = ("depth", "depths")  # (frames, height, width)
_HEADER_BYTES = 512
_PARTS = frozenset("KRtPkTCDd")
_NO_PICKLES = "it holds pickled objects, which are never read: they may run any program"


def is_array_file(data: bytes) -> bool:
    """Return whether bytes are an ``.npz`` or a MATLAB file, whatever it is called."""
    return data.startswith((_NPZ_MAGIC, MAGIC, _MAT73))


def array_content(data: bytes, path: str) -> dict[str, Any]:
    """The arrays of an ``.npz`` or a MATLAB file by name, as nested lists. `CameraError` if it is
    damaged, or of a kind that is not read."""
    if data.startswith(_NPZ_MAGIC):
        return _npz(data, path)
    if data.startswith(MAGIC):
        return matlab_content(data, path)
    if data.startswith(_MAT73):
        raise CameraError(
            path, "is a MATLAB file of version 7.3 (HDF5), expected level 5",
            advice="save it in MATLAB with: save(name, '-v7')",
        )  # fmt: skip
    raise CameraError(
        path,
        "is neither an .npz archive nor a MATLAB file of level 5",
        advice="it may be cut off, or be called wrongly: write it again",
    )


def npy_array(data: bytes, path: str, expected: str) -> NDArray[Any]:
    """The array of an ``.npy`` file, whatever its numbers are.

    Raises:
        CameraError: damaged, or pickled objects.
    """
    try:
        # Remarks on headers of old versions are nothing a user could act on.
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            array: NDArray[Any] = np.load(io.BytesIO(data), allow_pickle=False)
    except NPY_ERRORS as error:
        why = printable(str(error) or type(error).__name__, 160)
        why = _NO_PICKLES if "pickle" in why else why
        raise CameraError(
            path,
            f"is not a readable .npy file with {expected}: {why}",
            advice="write it again with numpy.save",
        ) from error
    return array


def _npz(data: bytes, path: str) -> dict[str, Any]:
    content: dict[str, Any] = {}
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            members = archive.infolist()
            if len(members) > _MOST_MEMBERS or not members:
                raise CameraError(path, f"holds {len(members)} arrays, expected those of cameras")
            for member in members:
                name = member.filename.removesuffix(".npy")
                place = printable(name)
                with archive.open(member) as file:
                    if name in _DEPTHS:  # a network's: as large as the pictures it was given
                        shape = _shape(file.read(_HEADER_BYTES))
                        content |= dict(zip(("height", "width"), shape[1:3], strict=False))
                    if name in _DEPTHS or member.file_size > _LARGEST_MEMBER:
                        if is_needed(name):
                            problem = "is too large for numbers of cameras"
                            raise CameraError(path, problem, place=place)
                        continue  # pictures or point clouds
                    array = npy_array(file.read(member.file_size + 1), path, "arrays")
                content[name] = _plain(array)
    except CameraError:
        raise
    except _NPZ_ERRORS as error:
        why = printable(str(error) or type(error).__name__, 160)
        raise CameraError(
            path, f"is not a readable .npz archive: {why}", advice="write it again with numpy.savez"
        ) from error
    return content


def is_needed(name: str) -> bool:
    """Return whether an array's name is that of a part of a camera."""
    return name in _PARTS or is_camera_key(name)


def _shape(head: bytes) -> tuple[int, ...]:
    """The shape in the head of an ``.npy`` file of one network's run, without its batch axis."""
    found = re.search(rb"'shape': \(([0-9, ]*)\)", head)
    shape = tuple(map(int, found[1].replace(b",", b" ").split())) if found else ()
    return shape[1:] if len(shape) == 5 else shape


def _plain(array: NDArray[Any]) -> Any:
    if array.dtype.kind == "U":
        return array.tolist()
    if array.dtype.kind == "S":
        return np.char.decode(array, "latin-1").tolist()
    if array.dtype.kind not in "fiu":
        return None  # flags, moments, complex numbers: no part of a camera
    with np.errstate(over="ignore"):
        return array.astype(np.float64).tolist()
