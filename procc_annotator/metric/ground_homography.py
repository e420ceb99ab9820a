"""The homography between ground and picture that a camera is, or comes nearest to."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from procc_annotator.camera.base import Camera, FloatArray
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.metric.ground import GroundRectangle, ground_points_seen

_FIT_GRID = (48, 27)
_MIN_SAMPLES = 8
_ON_GROUND_TOLERANCE_M = 1e-6


@dataclass(frozen=True, eq=False)
class GroundHomography:
    """A homography from the ground to the picture.

    Attributes:
        image_from_ground: (3, 3), metres to px; the third coordinate is positive for ground in
            front of the camera.
        is_exact: whether it is the camera itself, not the nearest homography to a bent one.
    """

    image_from_ground: FloatArray
    is_exact: bool

    def half_planes(self, size: tuple[int, int]) -> FloatArray:
        """(5, 3) a, b, c: the ground with ``a x + b y + c >= 0`` in all is in the picture."""
        x, y, w = self.image_from_ground
        planes = np.array([w, x, (size[0] - 1) * w - x, y, (size[1] - 1) * w - y])
        return np.asarray(planes, dtype=np.float64)


def ground_homography_of(
    camera: Camera, rectangle: GroundRectangle, size: tuple[int, int]
) -> GroundHomography | None:
    """Reduce a camera to a homography of the ground.

    A homography and a pinhole without distortion are one. Any other model is replaced by the
    homography that fits it best (least squares of pixels) over what the picture shows of the
    field: beyond the picture a distortion means nothing.

    Args:
        camera: any model, in px of ``size``.
        rectangle: the field.
        size: (width, height) px.

    Returns:
        None where the picture shows too little of the field to fit one, and for a pinhole in the
        ground itself, to which the ground is a line.
    """
    if isinstance(camera, HomographyCamera):
        return GroundHomography(camera.image_from_world, True)
    if isinstance(camera, PinholeCamera) and not camera.is_distorted:
        in_the_ground = abs(camera.position_world[2]) < _ON_GROUND_TOLERANCE_M
        return None if in_the_ground else GroundHomography(_homography_of_pinhole(camera), True)
    return _fit_homography(camera, rectangle, size)


def _homography_of_pinhole(camera: PinholeCamera) -> FloatArray:
    (fx, fy), (cx, cy) = camera.focal_px, camera.principal_point_px
    intrinsic = np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])
    rotation = camera.rotation_cam_from_world
    shift = -rotation @ np.array(camera.position_world)
    return np.asarray(intrinsic @ np.column_stack((rotation[:, :2], shift)), dtype=np.float64)


def _fit_homography(camera: Camera, rectangle: GroundRectangle, size: tuple[int, int]) -> GroundHomography | None:
    x, y = np.meshgrid(*(np.linspace(0.0, n - 1.0, k) for n, k in zip(size, _FIT_GRID, strict=True)))
    points_px = np.column_stack((x.ravel(), y.ravel()))
    ground = ground_points_seen(camera, points_px)
    on_field = rectangle.holds(ground)
    if np.count_nonzero(on_field) < _MIN_SAMPLES:
        return None
    found, _ = cv2.findHomography(ground[on_field], points_px[on_field], 0)
    if found is None or not np.isfinite(found).all():
        return None
    matrix = np.asarray(found, dtype=np.float64)
    depth = ground[on_field] @ matrix[2, :2] + matrix[2, 2]
    return GroundHomography(matrix if np.median(depth) > 0 else -matrix, False)
