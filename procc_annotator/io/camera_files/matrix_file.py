"""Files of bare numbers nobody named: what their shape and the view they give tell of them.

12 numbers are a projection matrix, 9 a homography. A homography says nothing of its world, so that
those of the World Cup's set are expected, as they are published: ``.npy`` in CARWC's yards, text in
World Cup 2014's.
"""

from __future__ import annotations

import numpy as np

from procc_annotator.camera.base import FloatArray
from procc_annotator.errors import CameraError
from procc_annotator.io.camera_files.array_files import NPY_MAGIC, npy_array
from procc_annotator.io.camera_files.camera_records import CameraRecord, CameraRecords
from procc_annotator.io.camera_files.homography_file import (
    CONVENTIONS,
    HOMOGRAPHY_SIZE,
    camera_from_homography,
    numbers_of_text,
    read_homography,
)
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.camera_files.nested_cameras import BY_ORDER
from procc_annotator.io.camera_files.projection_camera import projection_from

_LARGEST_TEXT = 4096  # of twelve numbers


def read_matrix_file(data: bytes, *, path: str) -> LoadedCamera:
    """The camera of a matrix in a file that nobody named the format of.

    Raises:
        CameraError: no matrix of a camera.
    """
    rows = _projection(data, path)
    if rows is not None:
        return projection_from(rows, path)
    is_npy = data.startswith(NPY_MAGIC) or path.lower().endswith(".npy")
    convention = "carwc" if is_npy else "wc14"
    if not is_npy and len(data) <= _LARGEST_TEXT:
        _check_count(numbers_of_text(data, path), path)
    return read_homography(data, path=path, convention=convention, assumed=True)


def matrix_records(data: bytes, *, path: str) -> CameraRecords | None:
    """The cameras of an ``.npy`` with a matrix a frame; None for a file of one.

    Raises:
        CameraError: damaged.
    """
    if not data.startswith(NPY_MAGIC):
        return None
    array = npy_array(data, path, "3 x 3 numbers")
    if array.ndim != 3 or array.dtype.kind not in "fiu" or array.shape[1:] not in ((3, 3), (3, 4)):
        return None
    found = [
        (str(i), CameraRecord(f"[{i}]", matrix)) for i, matrix in enumerate(array.astype(float))
    ]
    return CameraRecords.of(path, found, _of_stack, (BY_ORDER,))


def _projection(data: bytes, path: str) -> list[list[float]] | None:
    """The rows of a projection matrix, where that is what a file holds."""
    if data.startswith(NPY_MAGIC):
        array = npy_array(data, path, "3 x 3 numbers")
        if array.shape != (3, 4) or array.dtype.kind not in "fiu":
            return None
        rows: list[list[float]] = array.astype(np.float64).tolist()
        return rows
    if len(data) > _LARGEST_TEXT or len(data.replace(b",", b" ").split()) != 12:
        return None
    numbers = np.array(numbers_of_text(data, path))
    return [[float(number) for number in row] for row in numbers.reshape(3, 4)]


def _check_count(numbers: list[float], path: str) -> None:
    """Raises CameraError: these are the numbers of no matrix."""
    if len(numbers) not in (9, 12):
        worlds = ", ".join(CONVENTIONS)
        raise CameraError(
            path,
            f"{worlds}: expected 9 numbers (3 x 3), found {len(numbers)};"
            " projection: expected 12 (3 x 4)",
            advice="the file may be cut off",
        )


def _of_stack(content: FloatArray, path: str, inside: str) -> LoadedCamera:
    if not np.isfinite(content).all():
        raise CameraError(path, "expected finite numbers", place=inside, advice="correct the file")
    if content.shape == (3, 4):
        return projection_from(content.tolist(), path, inside)
    world = CONVENTIONS["carwc"].world_from_units
    return camera_from_homography(
        content, world, HOMOGRAPHY_SIZE, path=path, place=inside, assumed=True
    )
