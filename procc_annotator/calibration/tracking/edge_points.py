"""The edge points of all frames of a shot as arrays, some hundred frames at a time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.line_alignment.gaussian_state import FloatingArray, IntegerArray
from procc_annotator.calibration.tracking.filter_step import FilterStep

_BATCH_FRAMES = 128  # frames


@dataclass(frozen=True, eq=False)
class EdgePointBatch:
    """The marks of b frames, m of each.

    Attributes:
        world: (b, 3, m) metres.
        across: (b, m) solver px.
        normal: (b, 2, m).
        trust: (b, m) inverse variances; 0 where a frame has fewer.
        element: (b, m) which element each is on.
    """

    world: FloatingArray
    across: FloatingArray
    normal: FloatingArray
    trust: FloatingArray
    element: IntegerArray


class ShotEdgePoints:
    """Inputs of smoothing for K frames.

    Attributes:
        vectors: (K, 11) where following left their cameras.
        coverages: (K,).
        elements: (E,) that any mark is on.
    """

    vectors: FloatArray
    coverages: FloatArray
    elements: IntArray

    def __init__(self, steps: Sequence[FilterStep]) -> None:
        self.vectors = np.array([step.belief.vector for step in steps])
        self.coverages = np.array([step.coverage for step in steps])
        of_frames = (step.marks.element.tolist() for step in steps if step.marks is not None)
        self.elements = np.array(sorted(set().union(*of_frames)), dtype=np.intp)
        self._parts = [
            (slice(first, past), _batch_of(steps[first:past]))
            for first in range(0, len(steps), _BATCH_FRAMES)
            for past in [min(first + _BATCH_FRAMES, len(steps))]
        ]

    def parts(self) -> Iterator[tuple[slice, EdgePointBatch]]:
        """All frames, some at a time."""
        yield from self._parts


def _batch_of(steps: Sequence[FilterStep]) -> EdgePointBatch:
    frames = len(steps)
    most = max([1, *(len(step.marks) for step in steps if step.marks is not None)])
    some = EdgePointBatch(
        np.zeros((frames, 3, most), np.float32),
        np.zeros((frames, most), np.float32),
        np.zeros((frames, 2, most), np.float32),
        np.zeros((frames, most), np.float32),
        np.zeros((frames, most), np.int16),
    )
    for row, step in enumerate(steps):
        if (marks := step.marks) is None:
            continue
        own = len(marks)
        some.world[row, :, :own], some.across[row, :own] = marks.world, marks.across
        some.normal[row, :, :own], some.element[row, :own] = marks.normal, marks.element
        # Of the marks that were found some were kept, which stand for all of them.
        some.trust[row, :own] = step.represented_weight / step.worth.independent_error_px**2
    return some
