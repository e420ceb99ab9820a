"""Cameras from the numbers and functions that other programs have."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from procc_annotator.annotation import as_size
from procc_annotator.api.given import as_optional_size
from procc_annotator.camera.base import Camera
from procc_annotator.camera.checked import ValidatedCamera, FunctionCamera
from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.matrices import (
    fisheye_from_parts,
    intrinsics_from_matrix,
    pinhole_from_parts,
    pose_from_rt,
    decompose_projection,
)
from procc_annotator.camera.matrix_camera import MatrixCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import UsageError

FloatArray = NDArray[np.float64]


def camera_from_krt(
    k: ArrayLike,
    r: ArrayLike,
    t: ArrayLike,
    *,
    distortion: ArrayLike | None = None,
    fisheye: bool = False,
    size: tuple[int, int] | None = None,
) -> PinholeCamera | FisheyeCamera:
    """A camera from OpenCV's matrices: x_cam = R x_world + t, pixel = K x_cam / depth.

    The world frame is that of `Field`: metres, origin at the field's centre, x along its length, y
    across towards the main camera, **z down**. A camera of a world with z up is brought there by
    R @ diag(1, -1, -1).

    Args:
        k: (3, 3) px, without skew.
        r: (3, 3) rotation world -> camera, or (3,) rad, OpenCV's rotation vector.
        t: (3,) metres.
        distortion: OpenCV's k1 k2 p1 p2 [k3 [k4 k5 k6 [s1 s2 s3 s4]]], in a row or a column;
            k1 k2 k3 k4 of a fisheye; None for none.
        fisheye: whether the lens is OpenCV's fisheye.
        size: (width, height) px of the picture; tells how far a skew would move its pixels.

    Returns:
        The camera, in px of the picture that K belongs to.

    Raises:
        UsageError: a matrix of another shape, one that is not what it should be (with what is
            wrong), or a skew: `camera_from_projection` takes those.
    """
    rotation = _numbers("r", r)
    if rotation.size == 3:
        import cv2

        rotation = np.asarray(cv2.Rodrigues(rotation.reshape(3))[0], dtype=np.float64)
    try:
        inside = intrinsics_from_matrix(_numbers("k", k), as_optional_size(size))
        pose = pose_from_rt(rotation, _numbers("t", t).reshape(-1))
        coefficients = _numbers("distortion", () if distortion is None else distortion).reshape(-1)
        return (fisheye_from_parts if fisheye else pinhole_from_parts)(inside, pose, coefficients.tolist())
    except ValueError as error:
        raise UsageError(f"no camera: {error}") from None


def camera_from_projection(
    matrix: ArrayLike, *, size: tuple[int, int] | None = None
) -> PinholeCamera | MatrixCamera:
    """A camera from a projection matrix, P = K [R | t] times any number.

    Args:
        matrix: (3, 4), metres in the world (x, y, z, 1; world frame of `Field`, z down) to px. It
            may have a skew; its sign does not matter.
        size: (width, height) px of the picture; tells how far a skew moves its pixels.

    Returns:
        The camera, in px of the picture that the matrix is for: a pinhole with angles, position and
        focal lengths, unless the matrix has a skew that moves a pixel by more than 0.01 px, which
        only the matrix itself can say.

    Raises:
        UsageError: not (3, 4) finite numbers, or a camera that is infinitely far away.
    """
    known = as_optional_size(size)
    try:
        camera = MatrixCamera.of(_numbers("matrix", matrix))
    except ValueError as error:
        raise UsageError(f"matrix: no projection matrix: {error}") from None
    try:
        k, rotation, t = decompose_projection(camera.image_from_world)
        return pinhole_from_parts(intrinsics_from_matrix(k, known), pose_from_rt(rotation, t), ())
    except ValueError:  # a skew, or numbers too near to no camera to be taken apart
        return camera


def camera_from_homography(
    matrix: ArrayLike, size: tuple[int, int], *, to_ground: bool = False
) -> HomographyCamera:
    """A camera that knows the ground only, from a homography.

    Args:
        matrix: (3, 3), metres on the ground (x, y, 1; world frame of `Field`) to px.
        size: (width, height) px of the picture. A homography does not tell in front from behind:
            the lower edge of the picture is taken to show ground in front of the camera.
        to_ground: whether the matrix is the other way, px to metres.

    Returns:
        The camera, in px of ``size``.

    Raises:
        UsageError: not (3, 3) finite numbers, or a matrix that cannot be inverted.
    """
    given = _numbers("matrix", matrix)
    try:
        if not to_ground and given.shape == (3, 3):
            given = np.linalg.inv(given).astype(np.float64)
        return HomographyCamera.from_world_from_image(given, as_size(size))
    except (ValueError, np.linalg.LinAlgError) as error:
        raise UsageError(f"matrix: no homography: {error}") from None


def camera_from_function(
    function: Callable[[FloatArray], Any], *, ground_only: bool = False
) -> Camera:
    """A camera that is a function of places in the world.

    Args:
        function: takes (N, 3) metres, world frame of `Field` (z down), and returns (N, 2) px; NaN
            for points that have no projection: behind the camera, or where the lens model folds.
            Or it returns those and (N,) bool, which points have one. Pixels of points behind the
            camera are lines where there are none: ``cv2.projectPoints``, say, does not tell them.
        ground_only: whether it knows the plane z = 0 only, as a homography does.

    Returns:
        The camera, in px of the picture that the function is for. Whatever the function returns is
        checked, each time: another shape or kind, or a point that is said to be valid without
        finite pixels, is a `UsageError`.

    Raises:
        UsageError: it is no function.
    """
    if not callable(function):
        raise UsageError(f"expected a function, found {type(function).__name__}")
    return ValidatedCamera(FunctionCamera(function, ground_only), "the camera")


def _numbers(name: str, values: ArrayLike) -> FloatArray:
    try:
        return np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise UsageError(f"{name}: expected numbers, found {type(values).__name__}") from None
