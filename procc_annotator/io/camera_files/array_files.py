"""numpy's and MATLAB's files as plain content: objects, lists and numbers, as JSON has them.

Nothing is ever unpickled.
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
from procc_annotator.io.camera_files.matlab_file import MAGIC as MATLAB_MAGIC
from procc_annotator.io.camera_files.matlab_file import matlab_content
from procc_annotator.io.json_text import printable

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
_NO_PICKLES = "it holds pickled objects, which are never read: they may run any program"


def is_array_file(data: bytes) -> bool:
    """Whether bytes are an ``.npz`` or a MATLAB file, whatever it is called."""
    return data.startswith((_NPZ_MAGIC, MATLAB_MAGIC, _MAT73))


def array_content(data: bytes, path: str) -> dict[str, Any]:
    """The arrays of an ``.npz`` or a MATLAB file by name, as nested lists.

    Raises:
        CameraError: damaged, or of a kind that is not read.
    """
    if data.startswith(_NPZ_MAGIC):
        return _npz(data, path)
    if data.startswith(MATLAB_MAGIC):
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
                content[name] = _plain(array)
    except CameraError:
        raise
    except _NPZ_ERRORS as error:
        why = printable(str(error) or type(error).__name__, 160)
        raise CameraError(
            path, f"is not a readable .npz archive: {why}", advice="write it again with numpy.savez"
        ) from error
    return content


def _plain(array: NDArray[Any]) -> Any:
    """What JSON would have for an array."""
    if array.dtype.kind == "U":
        return array.tolist()
    if array.dtype.kind == "S":
        return np.char.decode(array, "latin-1").tolist()
    if array.dtype.kind not in "fiu":
        return None  # flags, moments, complex numbers: no part of a camera
    with np.errstate(over="ignore"):
        return array.astype(np.float64).tolist()
