"""Metrics of earlier papers: IoU, projection and reprojection error against a reference camera.

Definitions, sources and choices are in docs/explanation/metric.md. Whatever a paper leaves to
chance (random samples) is a regular grid here, so that a figure can be had again.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.camera.base import Camera
from procc_annotator.field.model import Field
from procc_annotator.metrics.ground_plane import (
    GroundHomography,
    GroundRectangle,
    clip_by_half_planes,
    convex_intersection,
    field_rectangle,
    ground_homography_of,
    ground_points_seen,
    polygon_area,
    require_camera_model,
    transform_points,
)

RASTER_M = 0.25
"""Side of the squares that stand for the ground where no exact polygon exists, metres."""

_PIXEL_STEP = 8.0
_GROUND_STEP_M = 1.0
_ROUND_TRIP_TOLERANCE_M = 0.05
_CM_PER_M = 100.0

# The picture's points that the basketball challenge compares, as shares of width and height.
_SIX_GROUND_POINTS = np.array(
    [(1.0, 1.0), (1.0, 0.5), (0.5, 1.0), (0.5, 0.5), (0.0, 1.0), (0.0, 0.5)]
)


@dataclass(frozen=True, slots=True)
class LegacyMetrics:
    """One frame's camera against its reference; None where a figure is undefined.

    Attributes:
        iou_whole: in [0, 1]: the field, and the field projected with the reference and traced
            back to the ground with the camera.
        iou_part: in [0, 1]: the parts of the field that either shows.
        projection_m: metres: mean distance on the ground of pixels of the visible field.
        projection_lost: share of those pixels, in [0, 1], that show the camera no ground and are in
            no mean.
        reprojection: share of the picture's height: mean distance in the picture of points of the
            visible field. reprojection_lost: share of the points the camera does not project.
        six_point_mse_cm2: cm²: mean of the squared coordinate differences of six points.
        six_point_rmse_cm: cm: its root, the figure the basketball challenge prints as MSE.
    """

    iou_whole: float | None
    iou_part: float | None
    projection_m: float | None
    projection_lost: float | None
    reprojection: float | None
    reprojection_lost: float | None
    six_point_mse_cm2: float | None
    six_point_rmse_cm: float | None


LEGACY_METRIC_NAMES = ("iou_whole", "iou_part", "projection_m", "reprojection", "six_point_rmse_cm")
"""The figures a set is summed up by."""


@dataclass(frozen=True, slots=True)
class MetricAverage:
    """Mean and median over the frames that have the figure; ``frames`` says how many do."""

    mean: float | None
    median: float | None
    frames: int

    @classmethod
    def of(cls, values: Iterable[float | None]) -> MetricAverage:
        found = np.array([v for v in values if v is not None], dtype=np.float64)
        if not len(found):
            return cls(None, None, 0)
        return cls(float(found.mean()), float(np.median(found)), len(found))


def legacy_averages(frames: Iterable[LegacyMetrics]) -> dict[str, MetricAverage]:
    """Mean and median of each of `LEGACY_METRIC_NAMES` over a set."""
    found = list(frames)
    return {name: MetricAverage.of(getattr(f, name) for f in found) for name in LEGACY_METRIC_NAMES}


def legacy_metrics(
    camera: Camera, reference: Camera, field: Field, size: tuple[int, int]
) -> LegacyMetrics:
    """Compare a camera of any model to a reference, taken as true, as earlier papers do.

    Args:
        field: its rectangle is the template of the papers.
        size: (width, height) px of both cameras; the picture is [0, width - 1] x [0, height - 1].

    Raises:
        UsageError: a source that shares only projections, or a field without ground.
    """
    for one in (camera, reference):
        require_camera_model(one)
    rectangle = field_rectangle(field)
    ours = ground_homography_of(camera, rectangle, size)
    theirs = ground_homography_of(reference, rectangle, size)
    projection = _projection_error(camera, reference, rectangle, size)
    reprojection = _reprojection_error(camera, reference, rectangle, size)
    squared = _six_point_mse(camera, reference, size)
    return LegacyMetrics(
        None if ours is None or theirs is None else _iou_whole(ours, theirs, rectangle),
        _iou_part((camera, reference), (ours, theirs), rectangle, size),
        *projection,
        *reprojection,
        squared,
        None if squared is None else math.sqrt(squared),
    )


# ------------------------------------------------------------------------------------------- IoU


def _iou_whole(
    ours: GroundHomography, theirs: GroundHomography, rectangle: GroundRectangle
) -> float:
    """The field against the field that went through both cameras.

    Where that one reaches our horizon it is infinitely large, and the IoU 0.
    """
    through_both = np.linalg.solve(ours.image_from_ground, theirs.image_from_ground)
    mapped, in_front = transform_points(through_both.astype(np.float64), rectangle.corners)
    if not in_front.all():
        return 0.0
    return _iou(rectangle.corners, mapped)


def _iou_part(
    cameras: tuple[Camera, Camera],
    homographies: tuple[GroundHomography | None, GroundHomography | None],
    rectangle: GroundRectangle,
    size: tuple[int, int],
) -> float | None:
    """The parts of the field that either camera shows; None where neither shows any."""
    ours, theirs = homographies
    if ours is not None and theirs is not None and ours.is_exact and theirs.is_exact:
        shown = [
            clip_by_half_planes(rectangle.corners, h.half_planes(size)) for h in (ours, theirs)
        ]
        return _iou(*shown) if any(len(polygon) for polygon in shown) else None
    centres = _ground_cells(rectangle, RASTER_M)
    masks = [_in_view(camera, centres, size) for camera in cameras]
    either = np.count_nonzero(masks[0] | masks[1])
    return float(np.count_nonzero(masks[0] & masks[1]) / either) if either else None


def _iou(a: FloatArray, b: FloatArray) -> float:
    """Intersection over union of two convex polygons."""
    both = polygon_area(convex_intersection(a, b))
    either = polygon_area(a) + polygon_area(b) - both
    return both / either if either > 0 else 0.0


def _ground_cells(rectangle: GroundRectangle, widest_m: float) -> FloatArray:
    """(N, 2) centres of equal cells that fill a rectangle of the ground."""
    return _cells((rectangle.left, rectangle.right), (rectangle.top, rectangle.bottom), widest_m)


def _cells(x: tuple[float, float], y: tuple[float, float], widest: float) -> FloatArray:
    """(N, 2) centres of equal cells, at most so wide, that fill x by y.

    Each stands for the same area. Samples on the borders would count those twice in a mean.
    """
    axes = []
    for low, high in (x, y):
        count = math.ceil((high - low) / widest)
        axes.append(low + (np.arange(count) + 0.5) * (high - low) / count)
    columns, rows = np.meshgrid(*axes)
    return np.column_stack((columns.ravel(), rows.ravel()))


def _in_view(camera: Camera, ground: FloatArray, size: tuple[int, int]) -> BoolArray:
    """(N,) whether ground points (N, 2) are in the picture.

    A distortion far from its centre may fold the ground back into the picture: a point counts only
    if its pixel is traced back to it.
    """
    px, valid = _projected(camera, ground)
    found = np.flatnonzero(valid & _in_picture(px, size))
    back = ground_points_seen(camera, px[found])
    apart = np.hypot(*(back - ground[found]).T)
    shown = np.zeros(len(ground), dtype=bool)
    shown[found[apart <= _ROUND_TRIP_TOLERANCE_M]] = True
    return shown


# ---------------------------------------------------------------------------------------- errors


def _projection_error(
    camera: Camera, reference: Camera, rectangle: GroundRectangle, size: tuple[int, int]
) -> tuple[float | None, float | None]:
    """Metres over the pixels that show the field to the reference, and the share of them lost."""
    points_px = _cells((0.0, size[0] - 1.0), (0.0, size[1] - 1.0), _PIXEL_STEP)
    truth = ground_points_seen(reference, points_px)
    on_field = rectangle.holds(truth)
    if not on_field.any():
        return None, None
    found = ground_points_seen(camera, points_px[on_field])
    return _mean_and_lost(np.hypot(*(found - truth[on_field]).T))


def _reprojection_error(
    camera: Camera, reference: Camera, rectangle: GroundRectangle, size: tuple[int, int]
) -> tuple[float | None, float | None]:
    """Of points of the field that the reference shows, over the picture's height."""
    ground = _ground_cells(rectangle, _GROUND_STEP_M)
    ground = ground[_in_view(reference, ground, size)]
    if not len(ground):
        return None, None
    truth, _ = _projected(reference, ground)
    found, valid = _projected(camera, ground)
    apart = np.where(valid, np.hypot(*(found - truth).T), np.nan)
    return _mean_and_lost(apart / size[1])


def _mean_and_lost(distances: FloatArray) -> tuple[float | None, float]:
    known = distances[np.isfinite(distances)]
    lost = 1.0 - len(known) / len(distances)
    return (float(known.mean()) if len(known) else None), lost


def _six_point_mse(camera: Camera, reference: Camera, size: tuple[int, int]) -> float | None:
    """cm², over the 18 coordinates of six ground points (those of z are 0, as in the source)."""
    points_px = _SIX_GROUND_POINTS * size
    apart = ground_points_seen(camera, points_px) - ground_points_seen(reference, points_px)
    squared = np.square(_CM_PER_M * apart).sum() / (3 * len(points_px))
    return float(squared) if np.isfinite(squared) else None


def _projected(camera: Camera, ground: FloatArray) -> tuple[FloatArray, BoolArray]:
    px, valid = camera.project(np.column_stack((ground, np.zeros(len(ground)))))
    valid = valid & np.isfinite(px).all(axis=1)
    return np.where(valid[:, None], px, 0.0), valid


def _in_picture(px: FloatArray, size: tuple[int, int]) -> BoolArray:
    x, y = px.T
    inside: BoolArray = (x >= 0) & (x <= size[0] - 1) & (y >= 0) & (y <= size[1] - 1)
    return inside
