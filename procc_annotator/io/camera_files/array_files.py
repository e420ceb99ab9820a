"""numpy's and MATLAB's files as plain content: objects, lists and numbers, as JSON has them.

Nothing is ever unpickled. MATLAB's files of level 5 need scipy, which is an extra.
"""

from __future__ import annotations

import io
import tokenize
import warnings
import zipfile
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.errors import CameraError
from procc_annotator.extras import how_to_have
from procc_annotator.io.json_text import printable

NPY_MAGIC = b"\x93NUMPY"
_NPZ_MAGIC = b"PK"
_MAT5, _MAT73 = b"MATLAB 5.0 MAT-file", b"MATLAB 7.3 MAT-file"
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
_DEEPEST = 16
_NO_PICKLES = "it holds pickled objects, which are never read: they may run any program"


def is_array_file(data: bytes) -> bool:
    """Whether bytes are an ``.npz`` or a MATLAB file, whatever it is called."""
    return data.startswith((_NPZ_MAGIC, _MAT5, _MAT73))


def array_content(data: bytes, path: str) -> dict[str, Any]:
    """The arrays of an ``.npz`` or a MATLAB file by name, as nested lists.

    Raises:
        CameraError: damaged, or of a kind that is not read; or scipy is not there.
    """
    if data.startswith(_NPZ_MAGIC):
        return _npz(data, path)
    if data.startswith(_MAT5):
        return _mat(data, path)
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

    Args:
        data: the file. path: for messages.
        expected: what numbers, for messages.

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
                if member.file_size > _LARGEST_MEMBER:
                    raise CameraError(path, "is too large for numbers of cameras", place=place)
                with archive.open(member) as file:
                    array = npy_array(file.read(member.file_size + 1), path, "arrays")
                content[name] = _plain(array, path, place)
    except CameraError:
        raise
    except _NPZ_ERRORS as error:
        why = printable(str(error) or type(error).__name__, 160)
        raise CameraError(
            path, f"is not a readable .npz archive: {why}", advice="write it again with numpy.savez"
        ) from error
    return content


def _mat(data: bytes, path: str) -> dict[str, Any]:
    try:
        from scipy.io import loadmat  # type: ignore[import-untyped]
        from scipy.io.matlab import MatReadError  # type: ignore[import-untyped]
    except ImportError as error:
        raise CameraError(
            path,
            "is a MATLAB file, and reading it needs scipy",
            advice=how_to_have("mat"),
        ) from error
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = loadmat(io.BytesIO(data), simplify_cells=True)
    except (*_NPZ_ERRORS, MatReadError, UnicodeError, AssertionError) as error:
        why = printable(str(error) or type(error).__name__, 160)
        raise CameraError(
            path,
            f"is not a readable MATLAB file of level 5: {why}",
            advice="the file may be cut off: save it again",
        ) from error
    return {
        name: _plain(value, path, printable(name))
        for name, value in found.items()
        if not name.startswith("__")
    }


def _plain(value: Any, path: str, place: str, depth: int = 0) -> Any:
    """What JSON would have for an array, a structure or a cell array."""
    if depth > _DEEPEST:
        raise CameraError(path, "is nested too deeply to be read", place=place)
    if isinstance(value, dict):
        return {
            str(key): _plain(entry, path, f"{place}.{printable(str(key))}", depth + 1)
            for key, entry in value.items()
        }
    if isinstance(value, list | tuple) or (isinstance(value, np.ndarray) and value.dtype == object):
        return [
            _plain(entry, path, f"{place}[{i}]", depth + 1) for i, entry in enumerate(list(value))
        ]
    if isinstance(value, str | int | float) or value is None:
        return value
    array = np.asarray(value)
    if array.dtype.kind == "U":
        return array.tolist()
    if array.dtype.kind == "S":
        return np.char.decode(array, "latin-1").tolist()
    if array.dtype.kind not in "fiu":
        return None  # flags, moments, complex numbers: no part of a camera
    with np.errstate(over="ignore"):
        return array.astype(np.float64).tolist()
