"""The points of several frames side by side, so that cameras of all of them are worked on at once.

Small arrays cost numpy about as much as large ones. What is worked out point by point comes out the
same in either; sums over the points of a frame would not, to the last digit, and are made frame by
frame (`side_by_side`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.observations import AnyArray, FloatArray, IntArray, Observations
from procc_annotator.fit.solving.parts import PrimitiveCandidates, Primitives

# What stands in for parts that a frame has fewer of; nothing comes of it.
_PADDING_LINE = np.array([[0.0, 1.0], [0.0, 0.0], [0.0, 0.0]])
_PADDING_CURVE = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 0.0]])


def is_batchable(seen: Observations) -> bool:
    """Whether all points lie on lines and curves that end at their ends, and count as they are."""
    plain = seen.candidates.of_point is None and seen.parts.all_have_ends and seen.soft is None
    return plain and seen.curve_pairs == seen.points.shape[1]


@dataclass(frozen=True, eq=False)
class BatchedObservations:
    """What `Observations` tell of one frame, for B cameras of several frames: some cameras of the
    first one, then some of the next.

    Attributes:
        points: (B, 2, N) solver px: first those on lines, then those on curves, of each frame
            followed by what stands in for those it has not.
        line_pairs, curve_pairs: how many of the N are on lines; N.
        parts: those of each camera's frame: arrays as `Parts` has them, (B, ...).
        line_first, line_span: (B, 3, points on lines) metres, as `Observations` have them.
        curve_half, curve_frames: (B, points on curves) and (B, 3, 3, points on curves), likewise.
        line_place, curve_place: (B, points) where among all the parts of all cameras that of each
            point is.
        first_row: (F,) the first camera of each frame.
        frame_of_row: (B,) which frame each camera is of.
    """

    points: FloatArray
    line_pairs: int
    curve_pairs: int
    parts: Primitives
    line_first: FloatArray
    line_span: FloatArray
    curve_half: FloatArray
    curve_frames: FloatArray
    line_place: IntArray
    curve_place: IntArray
    first_row: IntArray
    frame_of_row: IntArray
    candidates: ClassVar[PrimitiveCandidates] = PrimitiveCandidates(None, np.empty(0, dtype=np.intp), None)
    soft: ClassVar[None] = None

    @classmethod
    def of(cls, frames: Sequence[Observations], counts: IntArray) -> BatchedObservations:
        """Stack the points of F frames for so many cameras (F,) of each."""
        most = max(one.parts.lines for one in frames), max(one.parts.curves for one in frames)
        on_lines = max(one.line_pairs for one in frames)
        on_curves = max(one.curve_pairs - one.line_pairs for one in frames)
        points = np.zeros((len(frames), 2, on_lines + on_curves))
        ends = np.tile(_PADDING_LINE[:, :, None], (len(frames), 1, 1, most[0]))
        circles = np.tile(_PADDING_CURVE[:, :, None], (len(frames), 1, 1, most[1]))
        half = np.full((len(frames), most[1]), np.inf)
        line = np.zeros((len(frames), on_lines), dtype=np.intp)
        curve = np.zeros((len(frames), on_curves), dtype=np.intp)
        for row, one in enumerate(frames):
            parts = one.parts
            points[row][:, point_columns(one, on_lines)] = one.points
            ends[row, :, :, : parts.lines] = parts.line_ends.reshape(3, 2, -1)
            circles[row, :, :, : parts.curves] = parts.curve_frames.reshape(3, 3, -1)
            half[row, : parts.curves] = parts.curve_half
            line[row, : one.line_pairs] = one.line_of_pair
            curve[row, : len(one.curve_of_pair)] = one.curve_of_pair
        first, span = ends[:, :, 0], ends[:, :, 1] - ends[:, :, 0]
        frame_of_row = np.repeat(np.arange(len(frames)), counts)
        number = np.arange(len(frame_of_row))[:, None]
        return cls(
            points[frame_of_row],
            on_lines,
            points.shape[2],
            Primitives(
                ends.reshape(len(frames), 3, -1)[frame_of_row],
                circles.reshape(len(frames), 3, -1)[frame_of_row],
                half[frame_of_row],
                np.empty((3, 0)),
                np.ones((2, 1), dtype=bool),
                (),
            ),
            np.take_along_axis(first, line[:, None], axis=2)[frame_of_row],
            np.take_along_axis(span, line[:, None], axis=2)[frame_of_row],
            np.take_along_axis(half, curve, axis=1)[frame_of_row],
            np.take_along_axis(circles, curve[:, None, None], axis=3)[frame_of_row],
            line[frame_of_row] + number * most[0],
            curve[frame_of_row] + number * most[1],
            np.cumsum(counts) - counts,
            frame_of_row,
        )

    def of_lines(self, table: AnyArray) -> AnyArray:
        """See `Observations.of_lines`."""
        return _select_rows(table, self.line_place)

    def of_curves(self, table: AnyArray) -> AnyArray:
        """See `Observations.of_curves`."""
        return _select_rows(table, self.curve_place)

    def shared(self, of_rows: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """(B,) whether what is said of cameras (B,) holds of any of the same frame."""
        found = np.logical_or.reduceat(of_rows, self.first_row)[self.frame_of_row]
        return np.asarray(found)


def point_columns(seen: Observations, on_lines: int) -> IntArray:
    """(n,) where a frame's points are among those of `BatchedObservations`, so many of which are on lines."""
    columns = np.arange(seen.points.shape[1])
    columns[seen.line_pairs :] += on_lines - seen.line_pairs
    return columns


def _select_rows(table: AnyArray, place: IntArray) -> AnyArray:
    return table.reshape(*table.shape[:-2], -1).take(place, axis=-1)
