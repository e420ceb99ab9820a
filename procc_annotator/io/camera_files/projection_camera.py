"""Cameras as 3 x 4 projection matrices: K [R | t] in one, times any number.

The world is this project's, in metres. What such a matrix cannot say: lens distortion, and the size
of the picture. See docs/camera-formats.md.
"""

from __future__ import annotations

from typing import Any

from procc_annotator.camera.base import FloatArray
from procc_annotator.camera.matrices import (
    intrinsics_from_matrix,
    pinhole_from_parts,
    pose_from_rt,
    decompose_projection,
)
from procc_annotator.errors import CameraError
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera, with_notices
from procc_annotator.io.json_values import JsonValues

PROJECTION_KIND = "a projection matrix"
PROJECTION_KEYS = ("P", "projection_matrix", "projection", "proj", "camera_projection_matrix")


def is_projection(content: object) -> bool:
    """Whether a decoded value is such a matrix, or an object with one and no K beside it."""
    if type(content) is dict:
        found = [content[key] for key in PROJECTION_KEYS if key in content]
        return "K" not in content and any(_is_3x4(value) or _are_twelve(value) for value in found)
    return _is_3x4(content)


def projection_from(content: object, path: str, inside: str = "") -> LoadedCamera:
    """Read a camera from a decoded matrix, or from an object with one.

    Raises:
        CameraError: names the place and what was expected.
    """
    values = JsonValues.of({"P": content} if type(content) is list else content, path, inside, PROJECTION_KIND)
    key = values.need("3 x 4 numbers", *PROJECTION_KEYS)
    size = values.size()
    loaded = camera_of_projection(values.matrix(key, 3, 4), size, values.error)
    return with_notices(loaded, values.unused(key))


def camera_of_projection(
    matrix: FloatArray, size: tuple[int, int] | None, error: Any
) -> LoadedCamera:
    """The pinhole camera of a matrix.

    Args:
        matrix: (3, 4), metres of this project's world -> px.
        size: (width, height) px where it is known.
        error: makes the error of a problem.

    Raises:
        CameraError: no camera, or one with a skew.
    """
    try:
        k, rotation, t = decompose_projection(matrix)
        inside, pose = intrinsics_from_matrix(k, size), pose_from_rt(rotation, t)
        camera = pinhole_from_parts(inside, pose, ())
    except ValueError as problem:
        raised: CameraError = error(str(problem))
        raise raised from problem
    return LoadedCamera(camera, "pinhole", size, notices=(*inside.notices, *pose.notices))


def _are_twelve(content: object) -> bool:
    """Whether it is such a matrix row by row in one list."""
    return (
        type(content) is list
        and len(content) == 12
        and not any(type(number) in (list, dict, str) for number in content)
    )


def _is_3x4(content: object) -> bool:
    return (
        type(content) is list
        and len(content) == 3
        and all(type(row) is list and len(row) == 4 for row in content)
        and not any(type(number) in (list, dict, str) for row in content for number in row)
    )
