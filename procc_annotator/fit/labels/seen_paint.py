"""What a picture shows of paint along an element as it was clicked; measured elsewhere, data here.

Lengths are px of the picture; `SeenPaint.scale` takes them to those of one that is 960 px wide.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.observations import FloatArray, IntArray, ImageFrame

# The middle of paint this near is under the clicked line, px at 960 px width.
ON_LINE_PX = 2.0
_NEIGHBOUR_TOLERANCE_PX = 1.0  # paint runs smoothly: places near each other show it equally far off
_NEIGHBOUR_STEPS = np.arange(-2, 3)  # a place and its neighbours
_MIN_AGREEING, _MIN_ON_LINE = 3, 4  # of these
_NEIGHBOUR_LINE_PX, _MAX_SLOPE_PX = 0.8, 2.0


class LinePresence(IntEnum):
    """What is seen at a place: paint under it, paint to its left or right, or none."""

    NONE = 0
    UNDER = 1
    LEFT = 2
    RIGHT = 3


@dataclass(frozen=True, eq=False)
class LineEvidence:
    """Evidence along one element.

    Attributes:
        size: (width, height) px of the picture.
        places_px: (n, 2) px, along the element as it was clicked; each stands for as much of it.
        offsets_px: (n,) px from each to the middle of the paint across, to the right when going
            along; NaN where none was found.
        segments: (n,) between which clicks each lies, 0 before the second one.
        lengths_px: (n,) px of the element that each stands for.
        ahead: beyond the first click and beyond the last: (m,) px from it, (m,) offsets as above.
    """

    size: tuple[int, int]
    places_px: FloatArray
    offsets_px: FloatArray
    segments: IntArray
    lengths_px: FloatArray
    ahead: tuple[tuple[FloatArray, FloatArray], tuple[FloatArray, FloatArray]]

    @property
    def scale(self) -> float:
        """Px at 960 px width, per px."""
        return ImageFrame(self.size).scale

    @cached_property
    def steady(self) -> FloatArray:
        """(n,) the offsets that neighbours agree with; NaN elsewhere."""
        return consistent_offsets(self.offsets_px, self.scale)

    @cached_property
    def paint(self) -> NDArray[np.int8]:
        """(n,) what is seen at each place, as `Paint`."""
        off = self.steady * self.scale
        found = np.where(off > 0, LinePresence.RIGHT, LinePresence.LEFT)
        found = np.where(np.abs(off) <= ON_LINE_PX, LinePresence.UNDER, found)
        return np.where(np.isnan(off), LinePresence.NONE, found).astype(np.int8)

    @property
    def missing_share(self) -> float:
        """Share of the element's length under which there is no paint, 0 to 1."""
        return float(self.lengths_px[self.paint != LinePresence.UNDER].sum() / self.lengths_px.sum())

    @property
    def longest_gap_px(self) -> float:
        """Length of the longest stretch without paint under it, px."""
        runs = (self.lengths_px[begin:end].sum() for begin, end in _true_runs(self.paint != LinePresence.UNDER))
        return float(max(runs, default=0.0))

    def ends_at(self, end: int, gap_px: float) -> bool:
        """Whether paint that can be seen along the element cannot be seen beyond an end.

        Args:
            end: 0 or -1.
            gap_px: over so much beyond it, half of which must show none.
        """
        distances, offsets = self.ahead[end]
        near = distances <= gap_px
        if self.missing_share > 0.5 or not near.any():
            return False
        return bool(np.isfinite(consistent_offsets(offsets, self.scale)[near]).mean() < 0.5)


def consistent_offsets(offsets: FloatArray, scale: float) -> FloatArray:
    """(n,) offsets, px, but NaN where too few of a place's neighbours have about the same one, or
    lie with it on one line: paint runs smoothly."""
    n, reach = len(offsets), int(_NEIGHBOUR_STEPS[-1])
    here = offsets * scale
    padded = np.pad(here, reach, constant_values=np.nan)
    apart = np.stack([padded[reach + k : reach + k + n] for k in _NEIGHBOUR_STEPS.tolist()]) - here
    near = np.abs(apart) <= _NEIGHBOUR_TOLERANCE_PX * np.maximum(np.abs(_NEIGHBOUR_STEPS), 1)[:, None]
    enough = near.sum(axis=0) >= min(_MIN_AGREEING, n)
    rows = np.arange(n) + _NEIGHBOUR_STEPS[:, None]
    there = ((rows >= 0) & (rows < n)).sum(axis=0)
    for row in np.flatnonzero(_NEIGHBOUR_STEPS).tolist():
        slope = apart[row] / _NEIGHBOUR_STEPS[row]
        on_line = (np.abs(apart - slope * _NEIGHBOUR_STEPS[:, None]) <= _NEIGHBOUR_LINE_PX).sum(axis=0)
        enough |= (np.abs(slope) <= _MAX_SLOPE_PX) & (on_line >= np.minimum(_MIN_ON_LINE, there))
    return np.where(enough, offsets, np.nan)


def _true_runs(of: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate([[0], of.astype(np.int8), [0]])))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)
