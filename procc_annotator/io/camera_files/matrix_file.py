"""Files of bare numbers nobody named: what their shape and the view they give tell of them.

12 numbers are a projection matrix, 9 a homography. A homography says nothing of its world, so that
those of the World Cup's set are expected, as they are published: ``.npy`` in CARWC's yards, text in
World Cup 2014's. One that plainly shows no soccer field is told.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from procc_annotator.camera.base import FloatArray
from procc_annotator.camera.homography import HomographyCamera
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

_FIELD = "soccer"
# Half the field's length and width, and how far beside it a camera may look: metres.
_SEEN = np.array([52.5 + 50, 34.0 + 50])
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
    return assumed_homography(read_homography(data, path=path, convention=convention), convention)


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


def assumed_homography(loaded: LoadedCamera, convention: str) -> LoadedCamera:
    """A homography read by a convention nobody named: with the field that is taken for granted, and
    a remark where it plainly shows something else."""
    camera = loaded.camera
    assert isinstance(camera, HomographyCamera)
    notices = loaded.notices
    if not _shows_field(camera):
        turned = _turned(camera, convention)
        doubt = f"does not look at a soccer field when read as {convention}: name the camera format"
        if turned is not None:
            camera, doubt = turned, "takes the ground to the picture, not the picture to the ground"
        notices = (*notices, doubt)
    return replace(loaded, camera=camera, notices=notices, assumed_field=_FIELD)


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
    camera = camera_from_homography(content, world, HOMOGRAPHY_SIZE, path=path, place=inside)
    loaded = LoadedCamera(camera, "homography", HOMOGRAPHY_SIZE, size_is_usual=True)
    return assumed_homography(loaded, "carwc")


def _shows_field(camera: HomographyCamera) -> bool:
    """Whether the middle of a picture's lower edge is ground within sight of a soccer field."""
    width, height = HOMOGRAPHY_SIZE
    ground = camera.ground_from_px(np.array([[(width - 1) / 2, height - 1.0]]))
    with np.errstate(invalid="ignore"):
        return bool((np.abs(ground) < _SEEN).all())


def _turned(camera: HomographyCamera, convention: str) -> HomographyCamera | None:
    """The camera of the same nine numbers read the other way round, where that shows a field."""
    world = CONVENTIONS[convention].world_from_units
    # world_from_image = world @ units_from_image; those units are what the picture is now.
    image_from_units = np.linalg.inv(world) @ np.linalg.inv(camera.image_from_world)
    try:
        turned = HomographyCamera.from_world_from_image(
            world @ np.linalg.inv(image_from_units), HOMOGRAPHY_SIZE
        )
    except (ValueError, np.linalg.LinAlgError):
        return None
    return turned if _shows_field(turned) else None
