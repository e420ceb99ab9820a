"""The field rectangle on the ground, ground homographies of cameras, and convex polygons."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import Camera, CameraOrProjections, ElementProjections
from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import sample_evenly

_CURVE_SPACING_M = 0.1


@dataclass(frozen=True, slots=True)
class GroundRectangle:
    """A rectangle on the ground, metres, world frame; its border belongs to it."""

    left: float
    top: float
    right: float
    bottom: float

    @property
    def corners(self) -> FloatArray:
        """(4, 2) metres, around the rectangle."""
        return np.array(
            [
                (self.left, self.top),
                (self.right, self.top),
                (self.right, self.bottom),
                (self.left, self.bottom),
            ]
        )

    def holds(self, points: FloatArray) -> BoolArray:
        """(...,) whether points (..., 2) lie in it; not a number does not."""
        x, y = points[..., 0], points[..., 1]
        inside: BoolArray = (
            (x >= self.left) & (x <= self.right) & (y >= self.top) & (y <= self.bottom)
        )
        return inside


def field_rectangle(field: Field) -> GroundRectangle:
    """The field of play: its length and width about the centre.

    A field without these dimensions has the smallest rectangle along the axes that holds every
    element on the ground; optional ones, which may be anywhere, count where there are no others.
    `UsageError` if there is nothing on the ground either.
    """
    length, width = field.dimension("length"), field.dimension("width")
    if length is not None and width is not None:
        x, y = length.value / 2, width.value / 2
        return GroundRectangle(-x, -y, x, y)
    samples = sample_evenly(field, _CURVE_SPACING_M)
    rows = [i for i, element in enumerate(field.elements) if element.on_ground]
    needed = [i for i in rows if not field.elements[i].optional]
    ground = [samples.of(i)[:, :2] for i in needed or rows]
    if not ground:
        raise UsageError(f"the field {field.title} has no element on the ground to compare over")
    points = np.concatenate(ground)
    (left, top), (right, bottom) = points.min(axis=0), points.max(axis=0)
    return GroundRectangle(float(left), float(top), float(right), float(bottom))


def require_camera_model(camera: CameraOrProjections) -> Camera:
    """The camera itself; a source that shares only projections is refused by `UsageError`."""
    if isinstance(camera, ElementProjections):
        raise UsageError(
            "one of the sources shares only projections, there is no ground to compare;"
            " choose a source with a camera model"
        )
    return camera


def ground_points_seen(camera: CameraOrProjections, points_px: FloatArray) -> FloatArray:
    """The ground points (z = 0), (N, 2) metres, that pixels (N, 2) show; NaN where one shows no
    ground. `UsageError` for a source that shares only projections."""
    return ground_from_px(require_camera_model(camera), points_px)


def polygon_area(polygon: FloatArray) -> float:
    """The area of a polygon (n, 2), whichever way around; 0 for fewer than three points."""
    if len(polygon) < 3:
        return 0.0
    x, y = (polygon - polygon[0]).T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def clip_by_half_planes(polygon: FloatArray, half_planes: Iterable[FloatArray]) -> FloatArray:
    """The part (m, 2) of a convex polygon (n, 2) where ``a x + b y + c >= 0`` for all half planes
    (a, b, c) (Sutherland and Hodgman 1974); (0, 2) if nothing is left."""
    for half_plane in half_planes:
        if not len(polygon):
            break
        side = polygon @ half_plane[:2] + half_plane[2]
        following, side_after = np.roll(polygon, -1, axis=0), np.roll(side, -1)
        kept: list[FloatArray] = []
        for i, point in enumerate(polygon):
            if side[i] >= 0:
                kept.append(point)
            if (side[i] >= 0) != (side_after[i] >= 0):
                k = side[i] / (side[i] - side_after[i])
                kept.append(point + k * (following[i] - point))
        polygon = np.array(kept).reshape(-1, 2)
    return polygon


def convex_intersection(polygon: FloatArray, other: FloatArray) -> FloatArray:
    """The intersection of two convex polygons, (n, 2) and (m, 2), whichever way around."""
    if len(other) < 3:
        return np.empty((0, 2))
    start, along = other, np.roll(other, -1, axis=0) - other
    inward = np.column_stack((-along[:, 1], along[:, 0]))
    x, y = (other - other[0]).T
    if x @ np.roll(y, -1) < y @ np.roll(x, -1):
        inward = -inward
    return clip_by_half_planes(polygon, np.column_stack((inward, -(inward * start).sum(axis=1))))


def transform_points(matrix: FloatArray, points: FloatArray) -> tuple[FloatArray, BoolArray]:
    """Return what a homography (3, 3) makes of points (n, 2), and (n,) whether they stay in
    front."""
    homogeneous = points @ matrix[:, :2].T + matrix[:, 2]
    in_front = homogeneous[:, 2] > 0
    return homogeneous[:, :2] / np.where(in_front, homogeneous[:, 2], 1.0)[:, None], in_front


_FIT_GRID = (48, 27)
_MIN_SAMPLES = 8
_ERROR_GRID = 200  # places along each side of a region at which a homography is compared
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
    """Reduce a camera of any model, in px of ``size``, to a homography of the ground.

    A homography and a pinhole without distortion are one. Any other model is replaced by the
    homography that fits it best (least squares of pixels) over what the picture shows of the
    field's rectangle: beyond the picture a distortion means nothing.

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


def _fit_homography(
    camera: Camera, rectangle: GroundRectangle, size: tuple[int, int]
) -> GroundHomography | None:
    x, y = np.meshgrid(
        *(np.linspace(0.0, n - 1.0, k) for n, k in zip(size, _FIT_GRID, strict=True))
    )
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


def region_of(region: str | Sequence[float], field: Field) -> GroundRectangle:
    """The rectangle of ``field`` (its field of play) or of X0, Y0, X1, Y1 (metres), as text or
    numbers; `UsageError` if it is neither."""
    if region == "field":
        return field_rectangle(field)
    try:
        numbers = [float(v) for v in (region.split(",") if isinstance(region, str) else region)]
        (x0, x1), (y0, y1) = sorted(numbers[::2]), sorted(numbers[1::2])
    except (TypeError, ValueError):
        x0 = x1 = y0 = y1 = np.nan
    if not (x0 < x1 and y0 < y1 and np.isfinite((x0, x1, y0, y1)).all()):
        raise UsageError(f"region: expected field, or X0,Y0,X1,Y1 in metres, found {region!r}")
    return GroundRectangle(x0, y0, x1, y1)


@dataclass(frozen=True)
class NearestHomography:
    """The homography nearest to a camera over a region, as a camera, and how far it is off there.

    Attributes:
        camera: px of the picture.
        max_m, mean_m: distance on the ground of what a pixel of the region means to both.
        max_px, mean_px: distance in the picture of where both show a place of the region.
    """

    camera: HomographyCamera
    max_m: float
    mean_m: float
    max_px: float
    mean_px: float


def nearest_homography(
    camera: Camera, region: GroundRectangle, size: tuple[int, int]
) -> NearestHomography | None:
    """The homography of a camera by least squares of pixels over what the picture shows of a
    region; None where that is too little, and for a camera in the ground."""
    found = ground_homography_of(camera, region, size)
    if found is None:
        return None
    (left, top), (right, bottom) = region.corners[0], region.corners[2]
    axes = np.linspace(left, right, _ERROR_GRID), np.linspace(top, bottom, _ERROR_GRID)
    ground = np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, 2)
    px, shown = camera.project(np.column_stack((ground, np.zeros(len(ground)))))
    shown &= ((px >= 0) & (px <= np.subtract(size, 1))).all(axis=1)
    nearest = HomographyCamera(found.image_from_ground)
    by_matrix = transform_points(found.image_from_ground, ground[shown])[0]
    off_px = np.hypot(*(by_matrix - px[shown]).T)
    off_m = np.hypot(*(nearest.ground_from_px(px[shown]) - ground[shown]).T)
    if not len(off_px):
        return None
    worst = [float(v.max()) for v in (off_m, off_px)]
    return NearestHomography(nearest, worst[0], float(off_m.mean()), worst[1], float(off_px.mean()))
