"""A field's painted lines as places, and which of them is nearest to any place of the ground.

What stands across the field above its ground, as a net does, is looked for along with them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.geometry import Line, length_of
from procc_annotator.field.model import Field
from procc_annotator.fit.on_paint.painted import MarkingPoints, marking_points
from procc_annotator.fit.solving.observations import FloatArray, IntArray
from procc_annotator.fit.solving.surroundings import CameraPlacementPrior, camera_placement_prior

_COARSE_POINTS, _COARSEST_POINTS = 750, 400  # places that a closer and a first look take
_GROUND_CELL_SHARE = 0.004  # of half the field's length
_GRID_MARGIN = 1.15  # how far about the field, of its half length and width
_OFF_GROUND_M = 0.01  # what is so high stands above the ground
_BEAM_SPACING = 0.5  # of the field's half width: what is longer above the ground goes across the field


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
        return self._thinned(int(self.beams[0, 0]) if len(self.beams) else self.usual, _COARSEST_POINTS)

    def _thinned(self, first: int, count: int) -> FieldLinePoints:
        """About so many of the first places."""
        every = max(first // count, 1)
        chosen = slice(every // 2, first, every)
        world, step = self.world[:, chosen], self.step[chosen] * every
        beams = self.beams[self.beams[:, 1] < first] // every
        return FieldLinePoints(world, self.along[:, chosen], step, self.around, world.shape[1], beams)

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
