"""Clip chords to the picture rectangle and join them to pieces; or leave them as they go on."""

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


@dataclass(frozen=True, eq=False)
class ClippedPolylines:
    """Where a camera puts the elements that it shows.

    Attributes:
        in_sight: the pieces in the picture.
        unclipped: the same elements as they go on beyond it; no vertex of any other element.
    """

    in_sight: Polylines
    unclipped: Polylines


def clip_chords(
    chords: Chords, element: IntArray, element_count: int, size: tuple[int, int]
) -> ClippedPolylines:
    """The parts of chords inside [0, width - 1] x [0, height - 1], joined where curves continue,
    and all chords of the elements that have such a part.

    Args:
        chords: in any order; neighbours of one curve share an end's parameter exactly.
        element: element of each row of the chords, ascending.
        element_count: number of elements of the field.
        size: (width, height) px.

    Returns:
        Separate pieces, never joined across a gap; a chord that only touches the border is not in
        sight.
    """
    chords = chords.select(np.lexsort((chords.t[:, 0], chords.rows)))
    enter, leave = _clip_interval(chords.px, size)
    visible = (enter < leave) & (enter < 1) & (leave > 0)
    shown, enter, leave = chords.select(visible), enter[visible], leave[visible]
    along = shown.px[:, 1] - shown.px[:, 0]
    # The ends themselves where nothing is cut: a + 1 * (b - a) may miss b by rounding.
    begin = np.where(enter[:, None] > 0, shown.px[:, 0] + enter[:, None] * along, shown.px[:, 0])
    end = np.where(leave[:, None] < 1, shown.px[:, 0] + leave[:, None] * along, shown.px[:, 1])
    px = np.clip(np.stack((begin, end), axis=1), 0.0, np.array(size) - 1.0)
    uncut = (leave[:-1] == 1) & (enter[1:] == 0)
    in_sight = _join_chords(Chords(shown.rows, shown.t, px), uncut, element, element_count)
    chords = chords.select(in_sight.detected[element[chords.rows]])
    return ClippedPolylines(in_sight, _join_chords(chords, np.True_, element, element_count))


def _join_chords(
    chords: Chords, uncut: BoolArray | np.bool_, element: IntArray, element_count: int
) -> Polylines:
    """Chords in order as pieces; uncut: (K - 1,) whether nothing lies between neighbours."""
    continues = np.zeros(len(chords.rows), dtype=bool)
    continues[1:] = (
        (chords.rows[1:] == chords.rows[:-1]) & (chords.t[1:, 0] == chords.t[:-1, 1]) & uncut
    )
    keep = np.ones((len(continues), 2), dtype=bool)
    keep[:, 0] = ~continues
    is_end = np.zeros((len(continues), 2), dtype=bool)
    is_end[:-1, 1] = ~continues[1:]
    is_end[-1:, 1] = True
    rows = np.repeat(element[chords.rows, None], 2, axis=1)
    return Polylines(chords.px[keep], rows[keep], is_end[keep], element_count)


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
