"""Back-projection of pixels to the ground and to viewing rays, for any camera model."""

from __future__ import annotations

from itertools import product
from typing import NamedTuple, cast

import cv2
import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.camera.base import (
    Camera,
    CameraOrProjections,
    ElementProjections,
    ScaledCamera,
)
from procc_annotator.camera.models import (
    FisheyeCamera,
    HomographyCamera,
    PinholeCamera,
    as_pixels,
)

_NEWTON_ITERATIONS = 40
_MIN_STEP_SHARE = 1 / 64
_CONVERGED_M = 1e-9
_REACHED_PX = 1e-5
_DIFFERENCE_STEP_M = 1e-3
_ONE_KD_TREE = 4  # of the algorithms of OpenCV's FLANN
_FARTHEST_PX = 1e6
# Where to start, and how far the ground counts: dense about the field, then coarser. Farther out
# the ground is next to the horizon, where folds of a lens model can no longer be distinguished.
MAX_GROUND_DISTANCE_M = 300.0
_GRID_HALF_AXIS_M = np.concatenate(
    (
        np.arange(0.0, 80.0, 2.0),
        np.arange(80.0, 120.0, 4.0),
        np.arange(120.0, 200.0, 8.0),
        np.linspace(200.0, MAX_GROUND_DISTANCE_M, 9),
    )
)
_GRID_AXIS_M = np.concatenate((-_GRID_HALF_AXIS_M[:0:-1], _GRID_HALF_AXIS_M))
# Where to start for a place at any height: about a field, from its ground to its roof.
_START_AXIS_M = (-120.0, -70.0, -40.0, -20.0, -8.0, 0.0, 8.0, 20.0, 40.0, 70.0, 120.0)
_START_HEIGHTS_M = (0.0, -3.0, -12.0, -40.0)
_START_COUNT = 6


def projection_jacobian(
    camera: Camera, points_world: FloatArray, free: int = 3
) -> tuple[FloatArray, FloatArray]:
    """Project places, with derivatives by the place from differences.

    Args:
        points_world: (N, 3) metres.
        free: coordinates to derive by, of x, y, z.

    Returns:
        (N, 2) px and (N, 2, free) px a metre; NaN where the camera shows nothing. Next to the edge
        of what it shows the differences are one-sided.
    """
    points = np.asarray(points_world, dtype=np.float64)
    steps = _DIFFERENCE_STEP_M * np.vstack((np.zeros(3), np.eye(3)[:free], -np.eye(3)[:free]))
    px, shown = camera.project((points[:, None] + steps).reshape(-1, 3))
    shown = shown & np.isfinite(px).all(axis=1)
    px = np.where(shown[:, None], px, np.nan).reshape(-1, len(steps), 2)
    shown = shown.reshape(-1, len(steps))
    middle = px[:, :1]
    is_ahead, is_back = np.split(shown[:, 1:], 2, axis=1)
    ahead, back = np.split(np.where(shown[:, 1:, None], px[:, 1:], middle), 2, axis=1)
    width = _DIFFERENCE_STEP_M * np.maximum(is_ahead.astype(int) + is_back, 1)
    return px[:, 0], ((ahead - back) / width[:, :, None]).transpose(0, 2, 1)


def places_by_newton(
    camera: Camera, points_px: FloatArray, starts: FloatArray, free: int
) -> FloatArray:
    """Find places that appear at pixels, by damped Newton steps on the projection.

    Args:
        points_px: (N, 2) px.
        starts: (N, 3) metres.
        free: coordinates that may change: 2 for places on the ground, else 3; of the places of a
            viewing ray one near the start is found.

    Returns:
        (N, 3) metres; NaN where the search does not arrive.
    """
    found = np.full_like(starts, np.nan)
    rows, places, share = np.arange(len(starts)), starts.copy(), np.ones(len(starts))
    px, slopes = projection_jacobian(camera, places, free)
    for _ in range(_NEWTON_ITERATIONS):
        off = points_px[rows] - px
        error = np.hypot(off[:, 0], off[:, 1])
        usable = np.isfinite(slopes).all(axis=(1, 2))
        step = share[:, None] * _least_step(slopes, off)
        # At the horizon a pixel is worth any distance: there the share of it counts.
        reach = _CONVERGED_M * np.maximum(1.0, np.hypot(places[:, 0], places[:, 1]) / 10)
        settled = (np.abs(step).max(axis=1) <= reach) | (share < _MIN_STEP_SHARE)
        good = settled & usable & (error <= _REACHED_PX)
        found[rows[good]] = places[good]
        going = ~settled & usable
        if not going.any():
            break
        rows, places, share = rows[going], places[going], share[going]
        px, slopes, error = px[going], slopes[going], error[going]
        tried = places.copy()
        tried[:, :free] += step[going]
        tried_px, tried_slopes = projection_jacobian(camera, tried, free)
        left = tried_px - points_px[rows]
        better = np.hypot(left[:, 0], left[:, 1]) < error  # False for NaN
        places = np.where(better[:, None], tried, places)
        px = np.where(better[:, None], tried_px, px)
        slopes = np.where(better[:, None, None], tried_slopes, slopes)
        share = np.where(better, np.minimum(2 * share, 1.0), share / 4)
    return found


def _least_step(slopes: FloatArray, off: FloatArray) -> FloatArray:
    """(N, n) shortest steps that move pixels by (N, 2), of slopes (N, 2, n)."""
    a, b, c = ((slopes[:, i] * slopes[:, j]).sum(axis=1) for i, j in ((0, 0), (0, 1), (1, 1)))
    x, y = off.T
    weights = np.stack((c * x - b * y, a * y - b * x)) / (a * c - b * b)
    return np.asarray((weights.T[:, :, None] * slopes).sum(axis=1))


def ground_by_search(camera: Camera, points_px: FloatArray) -> FloatArray:
    """(N, 2) metres on the ground that pixels show, from the nearest of the places of a grid; NaN
    where none is found within `MAX_GROUND_DISTANCE_M`."""
    ground = np.full((len(points_px), 2), np.nan)
    rows = np.flatnonzero(np.isfinite(points_px).all(axis=1))
    if not len(rows):
        return ground
    x, y = np.meshgrid(_GRID_AXIS_M, _GRID_AXIS_M)
    nodes = np.column_stack((x.ravel(), y.ravel(), np.zeros(x.size)))
    with np.errstate(all="ignore"):
        nodes_px, slopes = projection_jacobian(camera, nodes, 2)
        part = _part_of_ground(nodes_px, slopes, points_px[rows])
        if not part.any():
            return ground
        starts = nodes[part][_nearest_nodes(nodes_px[part], points_px[rows])]
        found = places_by_newton(camera, points_px[rows], starts, 2)[:, :2]
    # In a cell of the grid that has a corner in the part that counts.
    inside = part.reshape(x.shape)
    column, row = np.clip(np.searchsorted(_GRID_AXIS_M, found), 1, len(_GRID_AXIS_M) - 1).T
    near = inside[row, column] | inside[row - 1, column]
    near |= inside[row, column - 1] | inside[row - 1, column - 1]
    near &= (np.abs(found) <= MAX_GROUND_DISTANCE_M).all(axis=1)  # False for NaN
    ground[rows[near]] = found[near]
    return ground


def _nearest_nodes(nodes_px: FloatArray, points_px: FloatArray) -> IntArray:
    """(N,) node that appears nearest to each pixel."""
    both = np.clip(nodes_px, -_FARTHEST_PX, _FARTHEST_PX), points_px
    nodes, points = (np.ascontiguousarray(px, dtype=np.float32) for px in both)
    tree = cv2.flann.Index(nodes, {"algorithm": _ONE_KD_TREE})
    nearest = tree.knnSearch(points, 1, params={"checks": -1})[0]  # -1: exact
    return np.asarray(nearest.ravel(), dtype=np.intp)


def _part_of_ground(nodes_px: FloatArray, slopes: FloatArray, points_px: FloatArray) -> BoolArray:
    """(M,) which nodes of the grid on the ground pixels may mean.

    A lens model that folds shows far-off ground a second time, mirrored, or a third time, turned;
    no pixel means that. So only one connected part of the ground counts, seen from one side: that
    of which most appears among the pixels in question.
    """
    side = np.nan_to_num(np.sign(np.linalg.det(slopes)))
    low, high = points_px.min(axis=0), points_px.max(axis=0)
    margin = 0.1 * (high - low).max() + 1
    among = ((nodes_px >= low - margin) & (nodes_px <= high + margin)).all(axis=1)
    best, most = np.zeros(len(side), dtype=bool), -1
    for sign in (1.0, -1.0):
        mask = (side == sign).reshape(len(_GRID_AXIS_M), -1).astype(np.uint8)
        labels = np.asarray(cv2.connectedComponents(mask, connectivity=4)[1]).ravel()
        counts = np.bincount(labels, weights=among)
        counts[0] = -1  # what is seen from the other side, or not at all
        largest = int(np.argmax(counts))
        if counts[largest] > most:
            best, most = labels == largest, int(counts[largest])
    return best


def ground_from_px(camera: CameraOrProjections, points_px: FloatArray) -> FloatArray:
    """The world points on the ground (z = 0), (N, 2) metres, that pixels (N, 2) show; NaN for
    pixels that do not show the ground. Projections alone have no ground.

    Exact to 1e-6 m inside the picture: rays for pinhole and fisheye cameras, the matrix for
    homographies, a model's own ``ground_from_px`` where it has one, and a search for all others.

    Raises:
        UsageError: the pixels are not (N, 2) numbers.
    """
    points_px = as_pixels(points_px)
    if isinstance(camera, ElementProjections):
        return np.full((len(points_px), 2), np.nan)
    if isinstance(camera, ScaledCamera):
        return ground_from_px(camera.camera, points_px / np.array(camera.factors))
    if callable(getattr(camera, "ground_from_px", None)):
        return np.asarray(cast(HomographyCamera, camera).ground_from_px(points_px))
    return ground_by_search(camera, points_px)


def ground_covariance(camera: Camera, ground: FloatArray, covariance_px: FloatArray) -> FloatArray:
    """Covariance (N, 2, 2), square metres, of ground points (N, 2), metres, from that of their
    pixels, (N, 2, 2) or (2, 2) square px, to first order; NaN for points that the camera does not
    show."""
    slopes = projection_jacobian(camera, np.column_stack((ground, np.zeros(len(ground)))), 2)[1]
    with np.errstate(invalid="ignore"):
        singular = ~(np.abs(np.linalg.det(slopes)) > 0)  # also NaN
    by_pixel = np.linalg.inv(np.where(singular[:, None, None], np.eye(2), slopes))
    by_pixel[singular] = np.nan
    return np.asarray(by_pixel @ covariance_px @ by_pixel.transpose(0, 2, 1))


class ViewingRay(NamedTuple):
    """A line in space: (3,) metres of a place on it, and (3,) its direction, a unit vector."""

    place: FloatArray
    direction: FloatArray


def viewing_ray(camera: Camera, point_px: FloatArray) -> ViewingRay | None:
    """The line whose points appear at a pixel (2,); None where the model shows nothing there. Any
    model that projects points off the ground has one.

    Exact for pinhole and fisheye cameras. For all others a place that appears there is searched
    by Newton's method; along the line the projection does not change, so its direction is what the
    derivatives there take to zero.
    """
    point_px = np.asarray(point_px, dtype=np.float64)
    if isinstance(camera, ScaledCamera):
        return viewing_ray(camera.camera, point_px / np.array(camera.factors))
    if isinstance(camera, PinholeCamera | FisheyeCamera):
        ray = camera.rotation_cam_from_world.T @ camera.rays_cam(point_px[None])[:, 0]
        length = float(np.linalg.norm(ray))
        if not (np.isfinite(length) and length > 0):
            return None
        return ViewingRay(np.array(camera.position_world), ray / length)
    nodes = np.array(list(product(_START_AXIS_M, _START_AXIS_M, _START_HEIGHTS_M)))
    px, shown = camera.project(nodes)
    away = np.where(shown, ((px - point_px) ** 2).sum(axis=1), np.inf)
    starts = np.argsort(away, kind="stable")[:_START_COUNT]
    targets = np.tile(point_px, (_START_COUNT, 1))
    places = places_by_newton(camera, targets, nodes[starts], 3)
    places = places[np.isfinite(places).all(axis=1)]
    if not len(places):
        return None
    slopes = projection_jacobian(camera, places[:1])[1]
    return ViewingRay(places[0], np.linalg.svd(slopes[0])[2][2])
