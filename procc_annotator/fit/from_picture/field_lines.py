"""A field's painted lines as places, and which of them is nearest to any place of the ground."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.model import Field
from procc_annotator.fit.on_paint.painted import Painted, painted_of
from procc_annotator.fit.solving.observations import FloatArray, IntArray
from procc_annotator.fit.solving.surroundings import Surroundings, surroundings_of

_COARSE, _COARSEST = 750, 400  # places that a closer and a first look take
_CELL = 0.004  # of half the field's length
_BEYOND = 1.15  # how far about the field, of its half length and width


@dataclass(frozen=True, eq=False)
class FieldLines:
    """N places on the painted lines of the ground.

    Attributes:
        world: (3, N) metres, in the middle of the paint.
        along: (3, N) unit vectors along the line.
        step: (N,) metres of the line that a place stands for.
        around: where cameras stand.
    """

    world: FloatArray
    along: FloatArray
    step: FloatArray
    around: Surroundings

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
    def coarse(self) -> FieldLines:
        """Fewer places, which show nearly as much."""
        return self._thinned(_COARSE)

    @cached_property
    def coarsest(self) -> FieldLines:
        """Still fewer, for many cameras."""
        return self._thinned(_COARSEST)

    def _thinned(self, count: int) -> FieldLines:
        every = max(self.world.shape[1] // count, 1)
        chosen = slice(every // 2, None, every)
        step = self.step[chosen] * every
        return FieldLines(self.world[:, chosen], self.along[:, chosen], step, self.around)

    @cached_property
    def nearest(self) -> NearestLine:
        """The nearest place of any spot of the ground."""
        return NearestLine.of(self)


@dataclass(frozen=True, eq=False)
class NearestLine:
    """Cells of the ground, each with the place on a line that is nearest to it.

    Attributes:
        place: (h, w) index in `FieldLines`.
        cell: metres.
        half: (2,) metres from the centre to the first column and row.
    """

    place: IntArray
    cell: float
    half: FloatArray

    @classmethod
    def of(cls, lines: FieldLines) -> NearestLine:
        """Of all places on and about the field."""
        around = lines.around
        cell = _CELL * around.half_length
        half = _BEYOND * np.array([around.half_length, around.half_width])
        width, height = (int(2 * reach / cell) + 1 for reach in half)
        column, row = ((lines.world[:2] + half[:, None]) / cell).astype(np.intp)
        inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
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


def lines_of(field: Field) -> FieldLines | None:
    """The painted lines on a field's ground that every such field has; None if it has none."""
    return _lines_of(painted_of(field), frozenset(_usual(field)), surroundings_of(field))


def _usual(field: Field) -> list[str]:
    return [e.name for e in field.elements if e.on_ground and not e.optional]


@lru_cache(maxsize=8)
def _lines_of(painted: Painted, usual: frozenset[str], around: Surroundings) -> FieldLines | None:
    wanted = np.array([name in usual for name in painted.names], dtype=bool)
    rows = np.flatnonzero(wanted[painted.element]) if len(wanted) else np.zeros(0, dtype=np.intp)
    if not len(rows):
        return None
    world = painted.world[:, rows]
    apart = np.linalg.norm(np.diff(world, axis=1, append=world[:, -1:]), axis=0)
    apart[np.diff(painted.run[rows], append=-1) != 0] = 0.0
    return FieldLines(world, painted.along[:, rows], apart, around)
