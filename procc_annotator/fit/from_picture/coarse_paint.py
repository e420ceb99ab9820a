"""How much of a picture's paint many cameras' lines explain, seen coarsely: bits of large cells."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.from_picture.seen_paint import (
    DIRECTION_COUNT,
    ImageLinePixels,
    map_cells,
    direction_indices,
    map_shape,
)

_CELLS_ACROSS = 10  # cells of the maps of paint, to a side of a large one: 24 columns fit in 32 bits
_DIRECTION_BINS = 6  # directions that are told apart
_MIN_PIXELS_PER_CELL = 6  # places of paint, for a large cell to have some

BitArray = NDArray[np.uint32]


@dataclass(frozen=True, eq=False)
class CoarseLineGrid:
    """Which large cells have paint.

    Attributes:
        rows: (directions, rows) a bit a column.
        cell: solver px of the maps' cells that large ones consist of.
        half_height: of the picture, solver px.
    """

    rows: BitArray
    cell: int
    half_height: float

    @classmethod
    def of(cls, paint: ImageLinePixels, cell: int) -> CoarseLineGrid:
        """Of the paint on the ground."""
        height, width = (-(-n // _CELLS_ACROSS) for n in map_shape(paint.half_height, cell))
        column, row = map_cells(paint.points[:, paint.on_ground], paint.half_height, cell)
        turn = direction_indices(paint.along[paint.on_ground]) * _DIRECTION_BINS // DIRECTION_COUNT
        count = np.zeros((_DIRECTION_BINS, height, width), dtype=np.intp)
        np.add.at(count, (turn, row // _CELLS_ACROSS, column // _CELLS_ACROSS), 1)
        bits = np.left_shift(1, np.arange(width, dtype=np.uint32), dtype=np.uint32)
        rows = ((count >= _MIN_PIXELS_PER_CELL) * bits).sum(axis=2, dtype=np.uint32)
        return cls(rows, cell, paint.half_height)

    def explained(self, cells: NDArray[np.int32]) -> NDArray[np.float64]:
        """(B,) share of its cells that have a line of a like direction in them or beside them.

        Args:
            cells: (B, K) of the maps where lines are, flat.
        """
        height, width = map_shape(self.half_height, self.cell)
        place = cells % (height * width)
        row, column = place // width // _CELLS_ACROSS, place % width // _CELLS_ACROSS
        turn = cells // (height * width) * _DIRECTION_BINS // DIRECTION_COUNT
        lines = np.zeros((len(cells), *self.rows.shape), dtype=np.uint32)
        which = (np.arange(len(cells))[:, None] * _DIRECTION_BINS + turn) * self.rows.shape[1] + row
        bits = np.left_shift(1, column.astype(np.uint32), dtype=np.uint32)
        np.bitwise_or.at(lines.reshape(-1), which.ravel(), bits.ravel())
        found = np.bitwise_count(_dilate_cells(lines) & self.rows).sum(axis=(1, 2), dtype=np.intp)
        total = int(np.bitwise_count(self.rows).sum())
        return np.asarray(found / max(total, 1))


def _dilate_cells(lines: BitArray) -> BitArray:
    """With the cells beside, above and below, and of the next directions."""
    lines = lines | lines << np.uint32(1) | lines >> np.uint32(1)
    tall = lines.copy()
    tall[:, :, 1:] |= lines[:, :, :-1]
    tall[:, :, :-1] |= lines[:, :, 1:]
    return np.asarray(tall | np.roll(tall, 1, axis=1) | np.roll(tall, -1, axis=1))
