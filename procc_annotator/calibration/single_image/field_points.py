"""Points on the field's lines, the nearest to any ground point, and those a camera shows."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.line_alignment.expected_lines import MarkingPoints, marking_points
from procc_annotator.calibration.optimization.camera_placement import (
    CameraPlacementPrior,
    camera_placement_prior,
)
from procc_annotator.calibration.optimization.observations import HALF_WIDTH_PX
from procc_annotator.calibration.optimization.projection import Lens
from procc_annotator.field.geometry import Line, length_of
from procc_annotator.field.model import Field

_COARSE_POINTS, _COARSEST_POINTS = 750, 400  # places that a closer and a first look take
_GROUND_CELL_SHARE = 0.004  # of half the field's length
_GRID_MARGIN = 1.15  # how far about the field, of its half length and width
_OFF_GROUND_M = 0.01  # what is so high stands above the ground
_BEAM_SPACING = (
    0.5  # of the field's half width: what is longer above the ground goes across the field
)


@dataclass(frozen=True, eq=False)
class FieldLinePoints:
    """N places on the painted lines of the ground, after them on beams, after these on lines that
    not every such field has: those explain paint, but are not missed.

    Attributes:
        world: (3, N) metres, in the middle of the paint.
        along: (3, N) unit vectors along the line.
        step: (N,) metres of the line that a place stands for.
        around: where cameras stand.
        usual: so many places, the first ones, are on what every field has.
        beams: (S, 2) first and last place of each straight bar that goes across the field above its
            ground, such as a net's bands.
    """

    world: FloatArray
    along: FloatArray
    step: FloatArray
    around: CameraPlacementPrior
    usual: int
    beams: IntArray

    @cached_property
    def homogeneous(self) -> NDArray[np.float32]:
        """(4, N) the places, with ones."""
        ones = np.ones((1, self.world.shape[1]))
        return np.concatenate([self.world, ones]).astype(np.float32)

    @cached_property
    def along_float32(self) -> NDArray[np.float32]:
        """(3, N) the directions."""
        return self.along.astype(np.float32)

    @cached_property
    def step_float32(self) -> NDArray[np.float32]:
        """(N,) the lengths."""
        return self.step.astype(np.float32)

    @cached_property
    def coarse(self) -> FieldLinePoints:
        """Fewer places, which show nearly as much of what every field has."""
        return self._thinned(self.usual, _COARSE_POINTS)

    @cached_property
    def coarsest(self) -> FieldLinePoints:
        """Still fewer, for many cameras; those on the ground."""
        return self._thinned(
            int(self.beams[0, 0]) if len(self.beams) else self.usual, _COARSEST_POINTS
        )

    def _thinned(self, first: int, count: int) -> FieldLinePoints:
        """About so many of the first places."""
        every = max(first // count, 1)
        chosen = slice(every // 2, first, every)
        world, step = self.world[:, chosen], self.step[chosen] * every
        beams = self.beams[self.beams[:, 1] < first] // every
        return FieldLinePoints(
            world, self.along[:, chosen], step, self.around, world.shape[1], beams
        )

    @cached_property
    def nearest(self) -> NearestLineGrid:
        """The nearest place of any spot of the ground."""
        return NearestLineGrid.of(self)


@dataclass(frozen=True, eq=False)
class NearestLineGrid:
    """Cells of the ground, each with the place on a line that is nearest to it.

    Attributes:
        place: (h, w) index in `FieldLinePoints`.
        cell: metres.
        half: (2,) metres from the centre to the first column and row.
    """

    place: IntArray
    cell: float
    half: FloatArray

    @classmethod
    def of(cls, lines: FieldLinePoints) -> NearestLineGrid:
        """Of all places on and about the field."""
        around = lines.around
        cell = _GROUND_CELL_SHARE * around.half_length
        half = _GRID_MARGIN * np.array([around.half_length, around.half_width])
        width, height = (int(2 * reach / cell) + 1 for reach in half)
        column, row = ((lines.world[:2] + half[:, None]) / cell).astype(np.intp)
        inside = ~is_off_ground(lines.world)
        inside &= (column >= 0) & (column < width) & (row >= 0) & (row < height)
        free = np.ones((height, width), dtype=np.uint8)
        free[row[inside], column[inside]] = 0
        _, labels = cv2.distanceTransformWithLabels(
            free, cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL
        )
        place = np.zeros(int(labels.max()) + 1, dtype=np.intp)
        place[labels[row[inside], column[inside]]] = np.flatnonzero(inside)
        return cls(place[labels], cell, half)

    def at(self, ground: FloatArray) -> IntArray:
        """(B, 2, n) metres -> (B, n) the nearest place; -1 far outside the field."""
        with np.errstate(invalid="ignore"):
            cells = np.floor((ground + self.half[:, None]) / self.cell)
            height, width = self.place.shape
            inside = (cells >= 0).all(axis=1) & (cells[:, 0] < width) & (cells[:, 1] < height)
        column, row = np.where(inside[:, None], cells, 0).astype(np.intp).transpose(1, 0, 2)
        return np.asarray(np.where(inside, self.place[row, column], -1))


def is_off_ground(world: FloatArray) -> NDArray[np.bool_]:
    """(..., 3, N) metres -> (..., N) which places do not lie on the ground."""
    return np.asarray(world[..., 2, :] < -_OFF_GROUND_M)


def field_line_points(field: Field) -> FieldLinePoints | None:
    """The painted lines on a field's ground, and what stands across it; None if it has no line
    that every such field has."""
    around = camera_placement_prior(field)
    beams = [
        e.name
        for e in field.elements
        if not (e.on_ground or e.optional)
        and isinstance(e.geometry, Line)
        and length_of(e.geometry) > _BEAM_SPACING * around.half_width
    ]
    ground = {
        way: [e.name for e in field.elements if e.on_ground and e.optional == way]
        for way in (False, True)
    }
    names = tuple(frozenset(some) for some in (ground[False], beams, ground[True]))
    return _build_line_points(marking_points(field), names, around)


@lru_cache(maxsize=8)
def _build_line_points(
    painted: MarkingPoints, names: tuple[frozenset[str], ...], around: CameraPlacementPrior
) -> FieldLinePoints | None:
    """Of the lines on the ground of every field, beams, and other lines on the ground."""
    parts = [_points_of_elements(painted, some) for some in names]
    lines, beams = (len(part) for part in parts[:2])
    if not lines:
        return None
    ends = np.flatnonzero(np.diff(painted.run[parts[1]], prepend=-1, append=-1)) + lines
    rows = np.concatenate(parts)
    world = painted.world[:, rows]
    apart = np.linalg.norm(np.diff(world, axis=1, append=world[:, -1:]), axis=0)
    apart[np.diff(painted.run[rows], append=-1) != 0] = 0.0
    spans = np.column_stack([ends[:-1], ends[1:] - 1])
    return FieldLinePoints(world, painted.along[:, rows], apart, around, lines + beams, spans)


def _points_of_elements(painted: MarkingPoints, names: frozenset[str]) -> IntArray:
    wanted = np.array([name in names for name in painted.names], dtype=bool)
    return np.flatnonzero(wanted[painted.element]) if len(wanted) else np.zeros(0, dtype=np.intp)


_MIN_DEPTH_M, _VIEW_BORDER_PX, _MAX_STEP_PX = 1.0, 6.0, 120.0
_VIEW_BATCH = 64  # cameras: more at once leave the processor's cache, fewer take more calls
_COMPARED_POINTS = 40  # places


@dataclass(frozen=True, eq=False)
class VisiblePoints:
    """K places for each of B cameras; those without a line in sight have any.

    Attributes:
        places: (B, K) of the lines.
        length_px: (B,) solver px of the lines in sight.
        points: (B, 2, K) where they appear, without distortion.
        angles: (B, K) rad, the direction they run there.
    """

    places: IntArray
    length_px: FloatArray
    points: FloatArray
    angles: FloatArray


def visible_line_points(
    vectors: FloatArray, lines: FieldLinePoints, half_height: float, count: int
) -> VisiblePoints:
    """``count`` places for each of B cameras (B, 11), each standing for the same length in its
    picture; half the picture's height in solver px."""
    parts = [
        _visible_line_points(vectors[first : first + _VIEW_BATCH], lines, half_height, count)
        for first in range(0, max(len(vectors), 1), _VIEW_BATCH)
    ]
    return VisiblePoints(*(np.concatenate(one) for one in zip(*parts, strict=True)))


def _visible_line_points(
    vectors: FloatArray, lines: FieldLinePoints, half_height: float, count: int
) -> tuple[IntArray, FloatArray, FloatArray, FloatArray]:
    linear = Lens.of(vectors, 1.0).linear.astype(np.float32)
    # One product of two large matrices is many times as fast as many products of small ones.
    flat, total_places = linear.reshape(-1, 4), lines.world.shape[1]
    place = (flat @ lines.homogeneous).reshape(-1, 3, total_places)
    toward = (flat[:, :3] @ lines.along_float32).reshape(-1, 3, total_places)
    near = 1 / np.maximum(place[:, 2], _MIN_DEPTH_M)
    x, y = place[:, 0] * near, place[:, 1] * near
    inside = (np.abs(x) < HALF_WIDTH_PX - _VIEW_BORDER_PX) & (
        np.abs(y) < half_height - _VIEW_BORDER_PX
    )
    inside &= place[:, 2] > _MIN_DEPTH_M
    blind = ~inside.any(axis=1)
    inside[blind, -1] = True
    # S places that cameras see, a few of all: one camera's after the other's.
    seen = np.flatnonzero(inside)
    row = seen // total_places
    column = seen - row * total_places
    near, x, y = near.take(seen), x.take(seen), y.take(seen)
    at = seen + row * (2 * total_places)
    forth = toward.take(at + 2 * total_places)
    across = (toward.take(at) - x * forth) * near
    down = (toward.take(at + total_places) - y * forth) * near
    length = np.sqrt(across * across + down * down) * lines.step_float32[column]
    length = np.where(blind[row], 0, np.minimum(length, _MAX_STEP_PX))
    total, times = _evenly_along(length, row, np.count_nonzero(inside, axis=1), count)
    taken = np.repeat(np.arange(len(seen)), times)
    shape = (len(vectors), count)
    points = np.stack([x[taken].reshape(shape), y[taken].reshape(shape)], axis=1)
    angles = np.arctan2(down[taken], across[taken]).reshape(shape)
    return column[taken].reshape(shape), total, points, np.asarray(angles)


def _evenly_along(
    length: NDArray[np.float32], row: IntArray, seen: IntArray, count: int
) -> tuple[FloatArray, IntArray]:
    """Along what each of B cameras sees.

    Args:
        length: (S,) that places stand for, one camera's after the other's.
        row: (S,) the camera's.
        seen: (B,) how many places a camera sees, one at least.
        count: of the places it takes.

    Returns:
        (B,) the lengths together; (S,) how often a place is taken.
    """
    end = np.cumsum(seen)
    first = end - seen
    rank = np.arange(len(length)) - first[row]
    gone = np.zeros((int(seen.max()), len(seen)), dtype=np.float32)
    gone[rank, row] = length
    np.cumsum(gone, axis=0, out=gone)
    total = gone[-1].copy()
    # A place is taken as often as the length up to it passes another part of the whole.
    parts = (count / np.maximum(total, 1))[row]
    passed = np.floor(gone[rank, row] * parts + 1e-3).astype(np.int32)
    np.minimum(passed, count, out=passed)
    passed[end - 1] = count
    times = np.diff(passed, prepend=0)
    times[first] = passed[first]
    return np.asarray(total, dtype=gone.dtype), times


def view_distance_px(
    vector: FloatArray, others: FloatArray, lines: FieldLinePoints, half_height: float
) -> FloatArray:
    """Return how far apart, solver px (B,), others (B, 11) show the lines that a camera (11,) has
    in view: the median distance. Half the picture's height in solver px."""
    chosen = visible_line_points(
        vector[None], lines.coarsest, half_height, _COMPARED_POINTS
    ).places[0]
    world = lines.coarsest.world[:, chosen]
    linear = Lens.of(np.concatenate([vector[None], others]), 1.0).linear
    place = linear[:, :, :3] @ world + linear[:, :, 3:]
    points = place[:, :2] / np.where(place[:, 2:] > _MIN_DEPTH_M, place[:, 2:], 1e-3)
    return np.asarray(np.median(np.hypot(*(points[1:] - points[0]).transpose(1, 0, 2)), axis=1))
