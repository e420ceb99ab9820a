"""Clip chords to the picture rectangle and join them to pieces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.metric.polylines import BoolArray, FloatArray, IntArray, Polylines


@dataclass(frozen=True, eq=False)
class Chords:
    """K straight chords of projected curves.

    Attributes:
        rows: (K,) element. t: (K, 2) curve parameters of the ends. px: (K, 2, 2) their pixels.
    """

    rows: IntArray
    t: FloatArray
    px: FloatArray

    def select(self, which: BoolArray | IntArray) -> Chords:
        return Chords(self.rows[which], self.t[which], self.px[which])

    @classmethod
    def concatenate(cls, parts: list[Chords]) -> Chords:
        if not parts:
            return cls(np.empty(0, np.intp), np.empty((0, 2)), np.empty((0, 2, 2)))
        return cls(
            np.concatenate([p.rows for p in parts]),
            np.concatenate([p.t for p in parts]),
            np.concatenate([p.px for p in parts]),
        )


def clipped_polylines(chords: Chords, size: tuple[int, int], element_count: int) -> Polylines:
    """The parts of chords inside [0, width - 1] x [0, height - 1], joined where curves continue.

    Args:
        chords: in any order; neighbours of one curve share an end's parameter exactly.
        size: (width, height) px.
        element_count: number of elements of the field.

    Returns:
        Separate pieces, never joined across a gap; a chord that only touches the border is dropped.
    """
    chords = chords.select(np.lexsort((chords.t[:, 0], chords.rows)))
    enter, leave = _clip_interval(chords.px, size)
    visible = (enter < leave) & (enter < 1) & (leave > 0)
    chords, enter, leave = chords.select(visible), enter[visible], leave[visible]
    count = len(enter)
    continues = np.zeros(count, dtype=bool)
    continues[1:] = (
        (chords.rows[1:] == chords.rows[:-1])
        & (chords.t[1:, 0] == chords.t[:-1, 1])
        & (leave[:-1] == 1)
        & (enter[1:] == 0)
    )
    limit = np.array(size) - 1.0
    along = chords.px[:, 1] - chords.px[:, 0]
    # The ends themselves where nothing is cut: a + 1 * (b - a) may miss b by rounding.
    begin = np.where(enter[:, None] > 0, chords.px[:, 0] + enter[:, None] * along, chords.px[:, 0])
    end = np.where(leave[:, None] < 1, chords.px[:, 0] + leave[:, None] * along, chords.px[:, 1])
    keep = np.ones((count, 2), dtype=bool)
    keep[:, 0] = ~continues
    vertices = np.clip(np.stack((begin, end), axis=1)[keep], 0.0, limit)
    is_end = np.zeros((count, 2), dtype=bool)
    is_end[:-1, 1] = ~continues[1:]
    is_end[-1:, 1] = True
    rows = np.repeat(chords.rows[:, None], 2, axis=1)
    return Polylines(vertices, rows[keep], is_end[keep], element_count)


def _clip_interval(px: FloatArray, size: tuple[int, int]) -> tuple[FloatArray, FloatArray]:
    """Liang-Barsky: the part of each chord inside the rectangle; empty where enter >= leave."""
    start = px[:, 0]
    along = px[:, 1] - start
    limit = np.array(size) - 1.0
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        at_low, at_high = -start / along, (limit - start) / along
    # A chord parallel to a side is cut by it nowhere or, when beyond it, everywhere.
    parallel = along == 0
    beyond = parallel & ((start < 0) | (start > limit))
    near = np.where(parallel, -np.inf, np.minimum(at_low, at_high))
    far = np.where(parallel, np.inf, np.maximum(at_low, at_high))
    # Reducing a short axis is slow in numpy.
    enter = np.maximum(np.maximum(near[:, 0], near[:, 1]), 0.0)
    leave = np.minimum(np.minimum(far[:, 0], far[:, 1]), 1.0)
    leave[beyond[:, 0] | beyond[:, 1]] = -1.0
    return enter, leave
