"""How much of a picture's paint many cameras' lines explain, seen coarsely: bits of large cells."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.from_picture.seen_paint import (
    DIRECTIONS,
    SeenPaint,
    cells_of,
    directions_of,
    shape_of,
)

_CELLS = 10  # cells of the maps of paint, to a side of a large one: 24 columns fit in 32 bits
_TURNS = 6  # directions that are told apart
_FEWEST = 6  # places of paint, for a large cell to have some

Bits = NDArray[np.uint32]


@dataclass(frozen=True, eq=False)
class CoarsePaint:
    """Which large cells have paint.

    Attributes:
        rows: (directions, rows) a bit a column.
        cell: solver px of the maps' cells that large ones consist of.
        half_height: of the picture, solver px.
    """

    rows: Bits
    cell: int
    half_height: float

    @classmethod
    def of(cls, paint: SeenPaint, cell: int) -> CoarsePaint:
        """Of the paint on the ground."""
        height, width = (-(-n // _CELLS) for n in shape_of(paint.half_height, cell))
        column, row = cells_of(paint.points[:, paint.on_ground], paint.half_height, cell)
        turn = directions_of(paint.along[paint.on_ground]) * _TURNS // DIRECTIONS
        count = np.zeros((_TURNS, height, width), dtype=np.intp)
        np.add.at(count, (turn, row // _CELLS, column // _CELLS), 1)
        bits = np.left_shift(1, np.arange(width, dtype=np.uint32), dtype=np.uint32)
        rows = ((count >= _FEWEST) * bits).sum(axis=2, dtype=np.uint32)
        return cls(rows, cell, paint.half_height)

    def explained(self, cells: NDArray[np.int32]) -> NDArray[np.float64]:
        """(B,) share of its cells that have a line of a like direction in them or beside them.

        Args:
            cells: (B, K) of the maps where lines are, flat.
        """
        height, width = shape_of(self.half_height, self.cell)
        place = cells % (height * width)
        row, column = place // width // _CELLS, place % width // _CELLS
        turn = cells // (height * width) * _TURNS // DIRECTIONS
        lines = np.zeros((len(cells), *self.rows.shape), dtype=np.uint32)
        which = (np.arange(len(cells))[:, None] * _TURNS + turn) * self.rows.shape[1] + row
        bits = np.left_shift(1, column.astype(np.uint32), dtype=np.uint32)
        np.bitwise_or.at(lines.reshape(-1), which.ravel(), bits.ravel())
        found = np.bitwise_count(_wider(lines) & self.rows).sum(axis=(1, 2), dtype=np.intp)
        total = int(np.bitwise_count(self.rows).sum())
        return np.asarray(found / max(total, 1))


def _wider(lines: Bits) -> Bits:
    """With the cells beside, above and below, and of the next directions."""
    lines = lines | lines << np.uint32(1) | lines >> np.uint32(1)
    tall = lines.copy()
    tall[:, :, 1:] |= lines[:, :, :-1]
    tall[:, :, :-1] |= lines[:, :, 1:]
    return np.asarray(tall | np.roll(tall, 1, axis=1) | np.roll(tall, -1, axis=1))
