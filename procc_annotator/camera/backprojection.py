"""Back-project pixels to the ground plane and to viewing rays, for any camera model."""

from __future__ import annotations

from typing import NamedTuple, cast

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.camera.base import (
    Camera,
    CameraOrProjections,
    ElementProjections,
    ScaledCamera,
)
from procc_annotator.camera.distortion import rays_cam
from procc_annotator.camera.models import (
    NEAREST_DEPTH_M,
    FisheyeCamera,
    HomographyCamera,
    PinholeCamera,
)

_NEWTON_ITERATIONS = 25
_STEP_HALVINGS = 6
_BIN_PX = 24  # bins along the longer side of the pixels asked for
_BIN_ROW = _BIN_PX + 3
_BATCH_BINS = 16  # pixels compared with all of the grid; more take a hundred megabytes
_CONVERGED_M = 1e-9
_REACHED_PX = 1e-5
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


def ground_by_newton(camera: Camera, points_px: FloatArray) -> FloatArray:
    """Find the ground points that pixels show by Newton's method on the projection.

    A coarse grid on the ground is projected; the pixels are put into bins, each bin's centre starts
    at the grid point that appears nearest to it, and each pixel where its bin's centre arrived.

    Args:
        camera: any model with ``project``.
        points_px: (N, 2) px.

    Returns:
        (N, 2) metres, NaN where the search does not arrive at the pixel on this side of
        `FARTHEST_M` (along x or y, from the field's centre).
    """
    ground = np.full((len(points_px), 2), np.nan)
    finite = np.isfinite(points_px).all(axis=1)
    wanted = points_px[finite]
    if not len(wanted):
        return ground
    with np.errstate(all="ignore"):
        x, y = np.meshgrid(_GRID_AXIS_M, _GRID_AXIS_M)
        nodes = np.column_stack((x.ravel(), y.ravel()))
        nodes_px, seen = _project_ground(camera, nodes)
        part = _nodes_near_pixels(camera, nodes, nodes_px, seen, wanted)
        if not part.any():
            return ground
        inside = part.reshape(x.shape)
        nodes, nodes_px = nodes[part], nodes_px[part]
        bins = _Bins(wanted)
        starts = nodes[_nearest_nodes(nodes_px, bins.centres)]
        arrived = _newton_on_ground(camera, bins.centres, starts)
        arrived[~_in_marked_cell(inside, arrived)] = np.nan
        starts = np.where(np.isnan(arrived), starts, arrived)[bins.of_point]
        # Most of a sky is far from any ground: no need to look for it pixel by pixel.
        hopeful = bins.near(np.isfinite(arrived[:, 0]), nodes_px)[bins.of_point]
        found = np.full_like(wanted, np.nan)
        found[hopeful] = _newton_on_ground(camera, wanted[hopeful], starts[hopeful])
        found[~_in_marked_cell(inside, found)] = np.nan
        lost = hopeful & np.isnan(found[:, 0])
        if lost.any():  # from the grid itself: a bin's centre may lie beyond the horizon
            some = np.flatnonzero(lost)
            found[some] = _newton_on_ground(
                camera, wanted[some], nodes[_nearest_nodes(nodes_px, wanted[some])]
            )
            found[~_in_marked_cell(inside, found)] = np.nan
    ground[finite] = found
    return ground


def _nodes_near_pixels(
    camera: Camera, nodes: FloatArray, nodes_px: FloatArray, seen: BoolArray, points_px: FloatArray
) -> BoolArray:
    """(M,) which nodes of the grid on the ground pixels may mean.

    A lens model that folds shows far-off ground a second time, mirrored, or a third time, turned;
    no pixel means that. So only one connected part of the ground counts, seen from one side: that
    of which most lies among the pixels asked for.
    """
    side = np.where(seen, _orientation_sign(camera, nodes, nodes_px), 0.0)
    low, high = points_px.min(axis=0), points_px.max(axis=0)
    margin = 0.1 * (high - low).max() + 1
    among = ((nodes_px >= low - margin) & (nodes_px <= high + margin)).all(axis=1)
    best, most = np.zeros(len(nodes), dtype=bool), -1
    for sign in (1.0, -1.0):
        mask = (side == sign).reshape(len(_GRID_AXIS_M), -1).astype(np.uint8)
        labels = np.asarray(cv2.connectedComponents(mask, connectivity=4)[1]).ravel()
        counts = np.bincount(labels, weights=among)
        counts[0] = -1  # what is seen from the other side, or not at all
        largest = int(np.argmax(counts))
        if counts[largest] > most:
            best, most = labels == largest, int(counts[largest])
    return best


def _in_marked_cell(inside: BoolArray, ground: FloatArray) -> BoolArray:
    """(N,) whether points lie in a cell of the grid that has a corner in the part that counts."""
    cell = np.clip(np.searchsorted(_GRID_AXIS_M, ground), 1, len(_GRID_AXIS_M) - 1)
    column, row = cell.T
    near = inside[row, column] | inside[row - 1, column]
    near |= inside[row, column - 1] | inside[row - 1, column - 1]
    return np.asarray(near & np.isfinite(ground).all(axis=1))


class _Bins:
    """Square bins over the pixels asked for.

    Attributes:
        centres: (B, 2) px, of the bins that hold points.
        of_point: (N,) the bin of each point.
    """

    def __init__(self, points_px: FloatArray) -> None:
        self._low = points_px.min(axis=0)
        extent = float((points_px.max(axis=0) - self._low).max())
        self._width = max(extent / _BIN_PX, 1e-6)
        keys, self.of_point = np.unique(self._key(points_px), return_inverse=True)
        self._cells = np.column_stack(np.divmod(keys, _BIN_ROW)) - 1
        self._keys = keys
        self.centres = self._low + (self._cells + 0.5) * self._width

    def _key(self, points_px: FloatArray) -> NDArray[np.intp]:
        """One number a bin; points outside come to the rim of the table."""
        cell = np.floor((points_px - self._low) / self._width)
        column, row = np.clip(cell, -1, _BIN_PX + 1).astype(np.intp).T + 1
        return np.asarray(column * _BIN_ROW + row)

    def near(self, arrived: BoolArray, nodes_px: FloatArray) -> BoolArray:
        """(B,) whether ground was found in a bin or next to it, or a node of the grid appears."""
        table = np.zeros(_BIN_ROW * _BIN_ROW, dtype=np.uint8)
        table[self._keys[arrived]] = 1
        table[self._key(nodes_px[np.isfinite(nodes_px).all(axis=1)])] = 1
        grown = cv2.dilate(table.reshape(_BIN_ROW, _BIN_ROW), np.ones((3, 3), np.uint8))
        return np.asarray(grown.ravel()[self._keys] > 0)


def _nearest_nodes(nodes_px: FloatArray, points_px: FloatArray) -> np.ndarray:
    found = np.empty(len(points_px), dtype=np.intp)
    for start in range(0, len(points_px), _BATCH_BINS):
        part = points_px[start : start + _BATCH_BINS]
        offset_x = part[:, :1] - nodes_px[:, 0]
        offset_y = part[:, 1:] - nodes_px[:, 1]
        found[start : start + _BATCH_BINS] = np.argmin(
            offset_x * offset_x + offset_y * offset_y, axis=1
        )
    return found


def _project_ground(camera: Camera, ground: FloatArray) -> tuple[FloatArray, BoolArray]:
    px, seen = camera.project(np.column_stack((ground, np.zeros(len(ground)))))
    return px, np.asarray(seen & np.isfinite(px).all(axis=1))


def _orientation_sign(camera: Camera, at: FloatArray, px: FloatArray) -> FloatArray:
    """(N,) 1 where the ground appears as seen from above, -1 where it appears mirrored."""
    along_x, along_y = ground_jacobian(camera, at, px)
    side: FloatArray = np.sign(along_x[:, 0] * along_y[:, 1] - along_x[:, 1] * along_y[:, 0])
    return side


def _newton_on_ground(camera: Camera, points_px: FloatArray, starts: FloatArray) -> FloatArray:
    """(N, 2) ground points that appear at the pixels, from starts (N, 2); NaN where not reached."""
    found = np.full_like(starts, np.nan)
    active = np.arange(len(starts))
    at, target = starts.copy(), points_px
    px, seen = _project_ground(camera, at)
    error = np.where(seen, np.hypot(*(px - target).T), np.inf)
    for _ in range(_NEWTON_ITERATIONS):
        step = _newton_step(camera, at, px, target)
        at, px, new, moved = _line_search_step(camera, at, px, error, step, target)
        # At the horizon a pixel is worth any distance: there the share of it counts.
        reach = _CONVERGED_M * np.maximum(1.0, np.hypot(*at.T) / 10)
        settled = (moved <= reach) | (new == 0)
        good = settled & (new <= _REACHED_PX)
        found[active[good]] = at[good]
        going = ~settled & np.isfinite(new)
        if not going.any():
            break
        active, at, px, target = active[going], at[going], px[going], target[going]
        error = new[going]
    return found


def _newton_step(camera: Camera, at: FloatArray, px: FloatArray, target: FloatArray) -> FloatArray:
    """Newton's step."""
    (a, c), (b, d) = (slope.T for slope in ground_jacobian(camera, at, px))
    off_x, off_y = (target - px).T
    area = a * d - b * c
    return np.column_stack(((d * off_x - b * off_y) / area, (a * off_y - c * off_x) / area))


def ground_jacobian(
    camera: Camera, at: FloatArray, px: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return how far the picture of a ground point moves with it, by central differences.

    Args:
        camera: any model with ``project``.
        at: (N, 2) metres on the ground, which the camera shows.
        px: (N, 2) px, where it shows them.

    Returns:
        (N, 2) px a metre along x, and along y.
    """
    size = 1e-5 * np.maximum(1.0, np.hypot(*at.T))
    columns = []
    for axis in (0, 1):
        ahead, back = at.copy(), at.copy()
        ahead[:, axis] += size
        back[:, axis] -= size
        ahead_px, ahead_seen = _project_ground(camera, ahead)
        back_px, back_seen = _project_ground(camera, back)
        # Next to the edge of what the camera sees, on one side only.
        ahead_px = np.where(ahead_seen[:, None], ahead_px, px)
        back_px = np.where(back_seen[:, None], back_px, px)
        width = size * (ahead_seen.astype(float) + back_seen)
        columns.append((ahead_px - back_px) / width[:, None])
    return columns[0], columns[1]


def _line_search_step(
    camera: Camera,
    at: FloatArray,
    px: FloatArray,
    error: FloatArray,
    step: FloatArray,
    target: FloatArray,
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Take the step, or as much of it as brings the pixel nearer.

    Returns:
        The new points, their pixels and errors (infinite: nothing helps), and how far they moved.
    """
    new_at, new_px = at.copy(), px.copy()
    new = np.where(np.isfinite(step).all(axis=1), error, np.inf)
    moved = np.zeros(len(at))
    trying = np.flatnonzero(np.isfinite(step).all(axis=1))
    share = 1.0
    for _ in range(_STEP_HALVINGS):
        if not len(trying):
            break
        there = at[trying] + share * step[trying]
        there_px, seen = _project_ground(camera, there)
        seen &= np.abs(there).max(axis=1) <= _GRID_AXIS_M[-1]
        left = np.where(seen, np.hypot(*(there_px - target[trying]).T), np.inf)
        tiny = np.hypot(*(share * step[trying]).T) <= _CONVERGED_M * np.maximum(
            1.0, np.hypot(*at[trying].T) / 10
        )
        better = (left < error[trying]) | (tiny & np.isfinite(left))
        some = trying[better]
        new_at[some], new_px[some], new[some] = there[better], there_px[better], left[better]
        moved[some] = np.hypot(*(there[better] - at[some]).T)
        trying = trying[~better]
        share /= 4
    return new_at, new_px, new, moved


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
    if isinstance(camera, PinholeCamera | FisheyeCamera):
        return _intersect_rays_with_ground(camera, points_px)
    if isinstance(camera, ScaledCamera):
        return ground_from_px(camera.camera, points_px / np.array(camera.factors))
    if callable(getattr(camera, "ground_from_px", None)):
        return np.asarray(cast(HomographyCamera, camera).ground_from_px(points_px))
    return ground_by_newton(camera, points_px)


def _intersect_rays_with_ground(
    camera: PinholeCamera | FisheyeCamera, points_px: FloatArray
) -> FloatArray:
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


_DIFFERENCE_STEP_M = 1e-3
_LINE_ITERATIONS = 40
_LINE_REACHED_PX = 1e-6
_LINE_ACCEPTED_PX = 1e-3
_MIN_STEP_SHARE = 1 / 64
# Where to look for a place that a pixel shows: about a field, from its ground to its roof.
_START_AXIS_M = np.array([-120.0, -70.0, -40.0, -20.0, -8.0, 0.0, 8.0, 20.0, 40.0, 70.0, 120.0])
_START_HEIGHTS_M = np.array([0.0, -3.0, -12.0, -40.0])
_START_COUNT = 6


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
    return _ray_by_search(camera, point_px)


def projection_jacobian(camera: Camera, points_world: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return where places appear, and the derivatives by the place, from central differences.

    Args:
        camera: any model.
        points_world: (N, 3) metres.

    Returns:
        (N, 2) px and (N, 2, 3) px a metre; NaN where the camera shows nothing.
    """
    points = np.asarray(points_world, dtype=np.float64)
    steps = _DIFFERENCE_STEP_M * np.concatenate((np.zeros((1, 3)), np.eye(3), -np.eye(3)))
    px, shown = _project_or_nan(camera, (points[:, None] + steps).reshape(-1, 3))
    px = np.where(shown[:, None], px, np.nan).reshape(len(points), 7, 2)
    slopes = (px[:, 1:4] - px[:, 4:]) / (2 * _DIFFERENCE_STEP_M)
    return px[:, 0], slopes.transpose(0, 2, 1)


def _project_or_nan(camera: Camera, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
    px, shown = camera.project(points_world)
    return px, shown & np.isfinite(px).all(axis=1)


def _ray_by_search(camera: Camera, point_px: FloatArray) -> ViewingRay | None:
    x, y, z = np.meshgrid(_START_AXIS_M, _START_AXIS_M, _START_HEIGHTS_M)
    nodes = np.column_stack((x.ravel(), y.ravel(), z.ravel()))
    px, shown = _project_or_nan(camera, nodes)
    away = np.where(shown, ((px - point_px) ** 2).sum(axis=1), np.inf)
    for start in np.argsort(away, kind="stable")[:_START_COUNT]:
        if not np.isfinite(away[start]):
            break
        found = _newton_on_ray(camera, point_px, nodes[start])
        if found is not None:
            return found
    return None


def _newton_on_ray(camera: Camera, point_px: FloatArray, place: FloatArray) -> ViewingRay | None:
    """The nearest place of the line, by steps across it; shorter ones where one leads astray."""
    px, slopes = projection_jacobian(camera, place[None])
    for _ in range(_LINE_ITERATIONS):
        off = px[0] - point_px
        if not np.isfinite(slopes).all():
            return None
        if float(np.hypot(*off)) < _LINE_REACHED_PX:
            break
        step = -np.linalg.pinv(slopes[0]) @ off
        share = 1.0
        while share >= _MIN_STEP_SHARE:
            tried, tried_slopes = projection_jacobian(camera, (place + share * step)[None])
            if np.hypot(*(tried[0] - point_px)) < np.hypot(*off):  # False for NaN
                break
            share /= 2
        else:
            break
        place, px, slopes = place + share * step, tried, tried_slopes
    if not (float(np.hypot(*(px[0] - point_px))) < _LINE_ACCEPTED_PX and np.isfinite(slopes).all()):
        return None
    return ViewingRay(place, np.linalg.svd(slopes[0])[2][2])
