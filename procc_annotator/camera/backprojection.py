"""Undistort pixels to viewing rays, and back-project them to the ground, for any camera model.

Lens models are given forwards only. Backwards, a table of the radial part gives a start that is off
by its linear interpolation, and Newton's method does the rest, to the last digits.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from typing import NamedTuple, cast

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.camera.base import (
    Camera,
    CameraOrProjections,
    ElementProjections,
    ScaledCamera,
)
from procc_annotator.camera.models import (
    NEAREST_DEPTH_M,
    FisheyeCamera,
    HomographyCamera,
    PinholeCamera,
)

Values = NDArray[np.float64]

_TABLE_NODES = 2048
_LENS_ITERATIONS = 30
_TABLE_MARGIN = 1.2
# Newton's method squares the error with each step: after one of this size less than 1e-10 is left.
_CONVERGED = 1e-6
# Points handled at once: the arrays of one round stay in the processor's cache.
_BLOCK_PIXELS = 8192


def rays_cam(camera: PinholeCamera | FisheyeCamera, points_px: FloatArray) -> FloatArray:
    """(3, N) directions in the camera frame that pixels show; NaN outside the model's domain.

    Where a model folds, the part about the axis counts.

    Args:
        camera: its model.
        points_px: (N, 2) px.
    """
    rays = np.empty((3, len(points_px)))
    px_x, px_y = points_px.T
    x = (px_x - camera.principal_point_px[0]) / camera.focal_px[0]
    y = (px_y - camera.principal_point_px[1]) / camera.focal_px[1]
    with np.errstate(all="ignore"):
        if isinstance(camera, FisheyeCamera):
            _fisheye_rays(camera, x, y, rays)
        elif camera.is_distorted:
            rays[2] = 1.0
            _undistort(camera, x, y, rays)
        else:
            rays[0], rays[1], rays[2] = x, y, 1.0
    return rays


def _fisheye_rays(camera: FisheyeCamera, x: Values, y: Values, out: FloatArray) -> None:
    radius = np.hypot(x, y)
    table = _MonotonicTable(camera.radius_of, camera.slope_of, camera.largest_angle_rad)
    theta = table.inverse(radius)
    # The step may have left the domain, and beyond it the model folds.
    theta[theta > camera.largest_angle_rad * (1 + 1e-12)] = np.nan
    sine = np.sin(theta) / np.where(radius > 0, radius, 1.0)
    out[0], out[1], out[2] = x * sine, y * sine, np.cos(theta)


def _undistort(camera: PinholeCamera, x: Values, y: Values, out: FloatArray) -> None:
    lens = _DistortionModel(camera)
    radius = np.hypot(x, y)
    finite = radius[np.isfinite(radius)]
    table = _MonotonicTable(
        lens.radial, lens.radial_slope, _bracket_radius(lens, float(finite.max(initial=0.0)))
    )
    for start in range(0, len(x), _BLOCK_PIXELS):
        part = slice(start, start + _BLOCK_PIXELS)
        inner = table.inverse(radius[part], polished=lens.only_radial)
        ratio = inner / np.where(radius[part] > 0, radius[part], 1.0)
        found = x[part] * ratio, y[part] * ratio
        if not lens.only_radial:
            found = lens.newton(x[part], y[part], *found, table.limit)
        out[0, part], out[1, part] = found


def _bracket_radius(lens: _DistortionModel, radius: float) -> float:
    """A radius in front of the lens at least as far out as a distorted one, if there is any."""
    reach = max(radius, 1e-6)
    for _ in range(12):
        if float(lens.radial(np.array([reach]))[0]) >= radius:
            break
        reach *= 1.5
    # The other terms of the model may pull a point a little further out.
    return _TABLE_MARGIN * reach


class _MonotonicTable:
    """A function of one variable with g(0) = 0, tabulated up to where it stops growing."""

    def __init__(
        self, function: Callable[[Values], Values], slope: Callable[[Values], Values], top: float
    ) -> None:
        self._function = function
        self._slope = slope
        nodes = np.linspace(0.0, top, _TABLE_NODES)
        values = function(nodes)
        grows = (slope(nodes) > 0) & np.isfinite(values)
        grows[1:] &= values[1:] > values[:-1]
        count = _TABLE_NODES if grows.all() else max(int(np.argmin(grows)), 1)
        self._nodes, self._values = nodes[:count], values[:count]
        self.top = float(self._nodes[-1])
        # Where the function turns, or infinity: beyond, another point would look alike.
        self.limit = float("inf") if count == _TABLE_NODES else float(nodes[count])

    def inverse(self, values: Values, *, polished: bool = True) -> Values:
        """(N,) arguments; NaN where the function has no such value before it turns."""
        # The other terms of a model may still bring a point back that lies a little beyond.
        most = self._values[-1] * (1.0 if polished else _TABLE_MARGIN)
        guess = np.interp(values, self._values, self._nodes)
        guess[~(values <= most)] = np.nan
        if not polished:
            return guess
        for _ in range(_LENS_ITERATIONS):
            step = (self._function(guess) - values) / self._slope(guess)
            guess -= step
            settled = np.abs(step) <= _CONVERGED * (1 + np.abs(guess))
            if (settled | np.isnan(guess)).all():
                break
            # Beyond the turning point nothing converges; those are not waited for.
            lost = ~((guess >= -1e-9) & (guess <= self.limit))
            guess[lost] = np.nan
        guess[~(settled & (guess <= self.limit))] = np.nan
        return np.asarray(guess, dtype=np.float64)


class _DistortionModel:
    """OpenCV's full distortion (without tilt) and its derivatives."""

    def __init__(self, camera: PinholeCamera) -> None:
        self._k = camera.radial
        self._p = camera.tangential
        self._s = camera.thin_prism
        self.only_radial = not (any(camera.tangential) or any(camera.thin_prism))

    def _factor(self, r2: Values) -> tuple[Values, Values]:
        """The radial factor f(r^2) and its derivative by r^2."""
        k1, k2, k3, k4, k5, k6 = self._k
        top = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        top_slope = k1 + r2 * (2 * k2 + r2 * (3 * k3))
        if not (k4 or k5 or k6):
            return np.asarray(top), np.asarray(top_slope)
        under = 1 + r2 * (k4 + r2 * (k5 + r2 * k6))
        under_slope = k4 + r2 * (2 * k5 + r2 * (3 * k6))
        f = top / under
        # Behind a pole the model starts anew; nothing of it counts.
        f = np.where(under > 0, f, np.nan)
        return np.asarray(f), np.asarray((top_slope - f * under_slope) / under)

    def radial(self, r: Values) -> Values:
        """Distorted radius."""
        return np.asarray(r * self._factor(r * r)[0])

    def radial_slope(self, r: Values) -> Values:
        """Derivative of `radial`."""
        r2 = r * r
        f, slope = self._factor(r2)
        return np.asarray(f + 2 * r2 * slope)

    def newton(
        self, xd: Values, yd: Values, x: Values, y: Values, limit: float
    ) -> tuple[Values, Values]:
        """Undistorted coordinates of distorted ones (xd, yd), from the start (x, y); or NaN."""
        done_x, done_y = np.full(len(x), np.nan), np.full(len(x), np.nan)
        active: NDArray[np.intp] | None = None  # all, at first
        for _ in range(_LENS_ITERATIONS):
            step_x, step_y, grows = self._step(xd, yd, x, y)
            x, y = x - step_x, y - step_y
            size2 = x * x + y * y
            step2 = step_x * step_x + step_y * step_y
            settled = step2 <= _CONVERGED**2 * (1 + size2)
            good = settled & grows & (size2 <= limit * limit)
            if active is None and good.all():
                return x, y
            places = np.arange(len(x)) if active is None else active
            done_x[places[good]], done_y[places[good]] = x[good], y[good]
            going = ~settled & (size2 <= 4 * limit * limit) & (step2 < 1e6)
            if not going.any():
                break
            active, x, y = places[going], x[going], y[going]
            xd, yd = xd[going], yd[going]
        return done_x, done_y

    def _step(
        self, xd: Values, yd: Values, x: Values, y: Values
    ) -> tuple[Values, Values, BoolArray]:
        p1, p2 = self._p
        s1, s2, s3, s4 = self._s
        xx, yy, xy = x * x, y * y, x * y
        r2 = xx + yy
        f, slope = self._factor(r2)
        off_x = x * f + 2 * p1 * xy + p2 * (r2 + 2 * xx) - xd
        off_y = y * f + p1 * (r2 + 2 * yy) + 2 * p2 * xy - yd
        twice = 2 * slope
        cross = twice * xy + 2 * (p1 * x + p2 * y)
        a = f + twice * xx + 2 * p1 * y + 6 * p2 * x
        d = f + twice * yy + 6 * p1 * y + 2 * p2 * x
        b = c = cross
        if s1 or s2:
            off_x += r2 * (s1 + s2 * r2)
            prism = 2 * (s1 + 2 * s2 * r2)
            a, b = a + x * prism, b + y * prism
        if s3 or s4:
            off_y += r2 * (s3 + s4 * r2)
            prism = 2 * (s3 + 2 * s4 * r2)
            c, d = c + x * prism, d + y * prism
        area = a * d - b * c
        grows: BoolArray = area > 0
        return (
            np.asarray((d * off_x - b * off_y) / area),
            np.asarray((a * off_y - c * off_x) / area),
            grows,
        )


_NEWTON_ITERATIONS = 40
_MIN_STEP_SHARE = 1 / 64
_CONVERGED_M = 1e-9
_REACHED_PX = 1e-5
_DIFFERENCE_STEP_M = 1e-3
_CELLS = 64  # along the longer side of the pixels
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


def projection_jacobian(camera: Camera, points_world: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Project places, with derivatives by the place from differences.

    Args:
        camera: any model.
        points_world: (N, 3) metres.

    Returns:
        (N, 2) px and (N, 2, 3) px a metre; NaN where the camera shows nothing. Next to the edge of
        what it shows the differences are one-sided.
    """
    points = np.asarray(points_world, dtype=np.float64)
    steps = _DIFFERENCE_STEP_M * np.concatenate((np.zeros((1, 3)), np.eye(3), -np.eye(3)))
    px, shown = camera.project((points[:, None] + steps).reshape(-1, 3))
    shown = shown & np.isfinite(px).all(axis=1)
    px = np.where(shown[:, None], px, np.nan).reshape(len(points), 7, 2)
    shown = shown.reshape(len(points), 7)
    middle = px[:, :1]
    ahead = np.where(shown[:, 1:4, None], px[:, 1:4], middle)
    back = np.where(shown[:, 4:, None], px[:, 4:], middle)
    width = _DIFFERENCE_STEP_M * np.maximum(shown[:, 1:4].astype(int) + shown[:, 4:], 1)
    return px[:, 0], ((ahead - back) / width[:, :, None]).transpose(0, 2, 1)


def places_by_newton(
    camera: Camera, points_px: FloatArray, starts: FloatArray, free: int
) -> FloatArray:
    """Find places that appear at pixels, by damped Newton steps on the projection.

    Args:
        camera: any model.
        points_px: (N, 2) px.
        starts: (N, 3) metres.
        free: coordinates that may change: 2 for places on the ground, else 3; of the places of a
            viewing ray one near the start is found.

    Returns:
        (N, 3) metres; NaN where the search does not arrive.
    """
    found = np.full_like(starts, np.nan)
    rows, places, share = np.arange(len(starts)), starts.copy(), np.ones(len(starts))
    px, slopes = projection_jacobian(camera, places)
    for _ in range(_NEWTON_ITERATIONS):
        off = points_px[rows] - px
        error = np.hypot(off[:, 0], off[:, 1])
        usable = np.isfinite(slopes).all(axis=(1, 2))
        step = share[:, None] * _least_step(slopes[:, :, :free], off)
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
        tried_px, tried_slopes = projection_jacobian(camera, tried)
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
        nodes_px, slopes = projection_jacobian(camera, nodes)
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
    """(N,) node that appears nearest to the middle of each pixel's cell, of some 64 x 64 cells."""
    low = points_px.min(axis=0)
    width = max(float((points_px.max(axis=0) - low).max()) / _CELLS, 1e-6)
    cells, of_point = np.unique(np.floor((points_px - low) / width), axis=0, return_inverse=True)
    middles = low + (cells + 0.5) * width
    off = (((middle - nodes_px) ** 2).sum(axis=1) for middle in middles)
    return np.array([int(np.argmin(squares)) for squares in off])[of_point]


def _part_of_ground(nodes_px: FloatArray, slopes: FloatArray, points_px: FloatArray) -> BoolArray:
    """(M,) which nodes of the grid on the ground pixels may mean.

    A lens model that folds shows far-off ground a second time, mirrored, or a third time, turned;
    no pixel means that. So only one connected part of the ground counts, seen from one side: that
    of which most appears among the pixels in question.
    """
    side = np.nan_to_num(np.sign(np.linalg.det(slopes[:, :, :2])))
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
    """The world points on the ground (z = 0) that pixels show.

    Exact to 1e-6 m inside the picture: rays for pinhole and fisheye cameras, the matrix for
    homographies, a model's own ``ground_from_px`` where it has one, and a search for all others.

    Args:
        camera: any source; projections alone have no ground.
        points_px: (N, 2) px.

    Returns:
        (N, 2) metres (x, y), NaN for pixels that do not show the ground.
    """
    points_px = np.asarray(points_px, dtype=np.float64)
    if isinstance(camera, ElementProjections):
        return np.full((len(points_px), 2), np.nan)
    if isinstance(camera, ScaledCamera):
        return ground_from_px(camera.camera, points_px / np.array(camera.factors))
    if callable(getattr(camera, "ground_from_px", None)):
        return np.asarray(cast(HomographyCamera, camera).ground_from_px(points_px))
    return ground_by_search(camera, points_px)


def ground_covariance(camera: Camera, ground: FloatArray, covariance_px: FloatArray) -> FloatArray:
    """Covariance of ground points from that of their pixels, to first order.

    Args:
        camera: any model.
        ground: (N, 2) metres. covariance_px: (N, 2, 2) or (2, 2) square px.

    Returns:
        (N, 2, 2) square metres; NaN for points that the camera does not show.
    """
    slopes = projection_jacobian(camera, np.column_stack((ground, np.zeros(len(ground)))))[1]
    with np.errstate(invalid="ignore"):
        singular = ~(np.abs(np.linalg.det(slopes[:, :, :2])) > 0)  # also NaN
    by_pixel = np.linalg.inv(np.where(singular[:, None, None], np.eye(2), slopes[:, :, :2]))
    by_pixel[singular] = np.nan
    return np.asarray(by_pixel @ covariance_px @ by_pixel.transpose(0, 2, 1))


def intersect_rays_with_ground(
    camera: PinholeCamera | FisheyeCamera, points_px: FloatArray
) -> FloatArray:
    """(N, 2) metres, see `ground_from_px`."""
    rays = rays_cam(camera, points_px)
    rotation, position = camera.rotation_cam_from_world, camera.position_world
    with np.errstate(all="ignore"):
        along_x, along_y, down = rotation.T @ rays
        distance = -position[2] / down
        # What is nearer than this counts as behind the camera.
        distance[~((distance > 0) & (distance * rays[2] > NEAREST_DEPTH_M))] = np.nan
        ground = np.empty((len(points_px), 2))
        ground[:, 0] = position[0] + distance * along_x
        ground[:, 1] = position[1] + distance * along_y
        ground[~np.isfinite(ground).all(axis=1)] = np.nan
    return ground


class ViewingRay(NamedTuple):
    """A line in space: (3,) metres of a place on it, and (3,) its direction, a unit vector."""

    place: FloatArray
    direction: FloatArray


def viewing_ray(camera: Camera, point_px: FloatArray) -> ViewingRay | None:
    """The line whose points appear at a pixel.

    Exact for pinhole and fisheye cameras. For all others a place that appears there is searched
    by Newton's method; along the line the projection does not change, so its direction is what the
    derivatives there take to zero.

    Args:
        camera: any model that projects points off the ground.
        point_px: (2,) px.

    Returns:
        None where the model shows nothing at the pixel.
    """
    point_px = np.asarray(point_px, dtype=np.float64)
    if isinstance(camera, ScaledCamera):
        return viewing_ray(camera.camera, point_px / np.array(camera.factors))
    if isinstance(camera, PinholeCamera | FisheyeCamera):
        ray = camera.rotation_cam_from_world.T @ rays_cam(camera, point_px[None])[:, 0]
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
