"""Projected polylines as flat arrays: distances, arc length, clipping to the image."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class Polylines:
    """The visible pieces of all elements, one after the other, in element order.

    Attributes:
        vertices: (M, 2) px.
        element: (M,) row of the element a vertex belongs to, ascending.
        is_end: (M,) whether the vertex is the last of its piece (no segment leads to the next one).
        element_count: E, the number of elements of the field.
        nan_if_zero_length: a segment whose ends coincide has no distance (NaN), as in the official
            evaluation; otherwise it counts as a point.
    """

    vertices: FloatArray
    element: IntArray
    is_end: BoolArray
    element_count: int
    nan_if_zero_length: bool = False

    @cached_property
    def detected(self) -> BoolArray:
        """(E,) whether an element has any vertex in the picture."""
        found = np.zeros(self.element_count, dtype=bool)
        found[self.element] = True
        return found

    @cached_property
    def segments(self) -> Segments:
        """All segments; a piece of a single vertex becomes one segment without length."""
        is_start = ~self.is_end
        alone = self.is_end.copy()
        alone[1:] &= self.is_end[:-1]
        first = np.flatnonzero(is_start | alone)
        last = first + is_start.take(first)
        table = np.empty((5, len(first)))
        a, along, inverse = table[:2], table[2:4], table[4]
        a[:] = self.vertices.take(first, axis=0).T
        np.subtract(self.vertices.take(last, axis=0).T, a, out=along)
        length2 = along[0] * along[0] + along[1] * along[1]
        with np.errstate(divide="ignore", over="ignore"):
            np.divide(1.0, length2, out=inverse)
        pointlike = length2 < np.finfo(np.float64).tiny  # its inverse is infinite
        if self.nan_if_zero_length:
            pointlike &= alone[first]
        inverse[pointlike] = 0.0
        counts = np.bincount(self.element[first], minlength=self.element_count)
        starts = np.cumsum(counts) - counts
        return Segments(table, starts, counts)

    @classmethod
    def joined(cls, frames: Sequence[Polylines]) -> Polylines:
        """Several frames, of the same field and protocol, as one: the elements of each follow those
        of the one before."""
        if len(frames) == 1:
            return frames[0]
        before = [frame.element_count * i for i, frame in enumerate(frames)]
        return cls(
            np.concatenate([frame.vertices for frame in frames]),
            np.concatenate([f.element + n for f, n in zip(frames, before, strict=True)]),
            np.concatenate([frame.is_end for frame in frames]),
            frames[0].element_count * len(frames),
            frames[0].nan_if_zero_length,
        )

    def of_frames(self, count: int) -> list[Polylines]:
        """Return what was `joined`, or projected together, frame by frame."""
        if count == 1:
            return [self]
        elements = self.element_count // count
        cuts = np.searchsorted(self.element, np.arange(count + 1) * elements).tolist()
        return [
            Polylines(
                self.vertices[begin:end],
                self.element[begin:end] - i * elements,
                self.is_end[begin:end],
                elements,
                self.nan_if_zero_length,
            )
            for i, (begin, end) in enumerate(pairwise(cuts))
        ]

    def of_elements(self, wanted: BoolArray) -> Polylines:
        """Without the pieces of the elements that are not wanted, (E,); rows stay as they are."""
        if wanted.all():
            return self
        kept = wanted[self.element]
        return replace(
            self,
            vertices=self.vertices[kept],
            element=self.element[kept],
            is_end=self.is_end[kept],
        )

    def pieces_of(self, row: int) -> tuple[FloatArray, ...]:
        """The visible pieces of one element, each (n, 2) px."""
        begin, end = np.searchsorted(self.element, (row, row + 1))
        if begin == end:
            return ()
        cuts = np.flatnonzero(self.is_end[begin : end - 1]) + 1
        return tuple(np.split(self.vertices[begin:end], cuts))


@dataclass(frozen=True, eq=False)
class Segments:
    """S segments in element order.

    Attributes:
        table: (5, S): a_x, a_y, (b-a)_x, (b-a)_y in px, and 1/|b-a|^2: 0 for a segment that counts
            as its point a, infinite for one without length whose distance is NaN.
        starts: (E,) first segment of each element.
        counts: (E,) number of segments of each element.
    """

    table: FloatArray
    starts: IntArray
    counts: IntArray

    def distances(self, points_px: FloatArray, elements: IntArray) -> FloatArray:
        """Distance of each point to the nearest segment of its own element.

        The foot is clamped to the segment: strictly between the ends it is the perpendicular one,
        else the nearer end (devkit's rule, and eq. 1 of the ProCC paper).

        Args:
            points_px: (n, 2) px.
            elements: (n,) row of the element each point is measured against; it must be detected.

        Returns:
            (n,) px; NaN where a segment without length has no distance (soccernet protocol).
        """
        if not len(points_px):
            return np.empty(0)
        off_x, off_y, first, _ = self._offsets(points_px, elements)
        off_x *= off_x
        off_y *= off_y
        off_x += off_y
        nearest: FloatArray = np.sqrt(np.minimum.reduceat(off_x, first))
        return nearest

    def feet(self, points_px: FloatArray, elements: IntArray) -> FloatArray:
        """The nearest projected position (n, 2), px, of each point; arguments as for `distances`.
        Segments without a distance are passed over (NaN if there is no other)."""
        if not len(points_px):
            return np.empty((0, 2))
        off_x, off_y, first, counts = self._offsets(points_px, elements)
        distance2 = off_x * off_x + off_y * off_y
        distance2[np.isnan(distance2)] = np.inf
        least = np.minimum.reduceat(distance2, first)
        hits = np.flatnonzero(distance2 == np.repeat(least, counts))
        nearest = hits[np.searchsorted(hits, first)]  # of equally near segments the first one
        return points_px - np.column_stack((off_x[nearest], off_y[nearest]))

    def _offsets(
        self, points_px: FloatArray, elements: IntArray
    ) -> tuple[FloatArray, FloatArray, IntArray, IntArray]:
        """For every pair (point, segment of its element) the point minus its foot: x and y offsets
        of all pairs, the first pair of each point, and pairs a point. This is where scoring spends
        its time, hence the arithmetic in place."""
        counts = self.counts[elements]
        first = np.cumsum(counts) - counts
        which = np.arange(first[-1] + counts[-1])
        which += np.repeat(self.starts[elements] - first, counts)
        a_x, a_y, d_x, d_y, inverse = (row.take(which) for row in self.table)
        off_x, off_y = np.asarray(points_px, dtype=np.float64).T.repeat(counts, axis=1)
        off_x -= a_x
        off_y -= a_y
        k = np.multiply(off_x, d_x, out=a_x)
        k += np.multiply(off_y, d_y, out=a_y)
        # 0 * inf is NaN: a segment without length that has no distance.
        with np.errstate(invalid="ignore"):
            k *= inverse
        np.maximum(k, 0.0, out=k)
        np.minimum(k, 1.0, out=k)
        d_x *= k
        d_y *= k
        off_x -= d_x
        off_y -= d_y
        return off_x, off_y, first, counts


def arc_lengths(course: FloatArray) -> FloatArray:
    """(n,) length of the way to each point of a course (n, 2), 0 at the first; in its units."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(course, axis=0).T))])


def points_at_arc_lengths(
    course: FloatArray, at: FloatArray, lengths: FloatArray | None = None
) -> FloatArray:
    """(m, 2) the places at some lengths (m,) along a course (n, 2); at its ends beyond them.
    ``lengths``: `arc_lengths` of the course, where they are known."""
    known = arc_lengths(course) if lengths is None else lengths
    return np.column_stack([np.interp(at, known, course[:, k]) for k in (0, 1)])


def polyline_normals(course: FloatArray, reach: int = 1) -> FloatArray:
    """(n, 2) unit vectors across a course (n, 2), px, n >= 2. The direction is that from
    ``reach`` points before to as many behind; more than one where the corners of a polyline are
    not to show."""
    rows = np.arange(len(course))
    along = course[np.minimum(rows + reach, len(rows) - 1)] - course[np.maximum(rows - reach, 0)]
    length = np.hypot(along[:, 0], along[:, 1])[:, None]
    along = np.where(length > 0, along / np.maximum(length, 1e-12), (1.0, 0.0))
    return np.column_stack([-along[:, 1], along[:, 0]])


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
    """Projected elements of a camera: the pieces in the picture, and the same elements as they go
    on beyond it, without a vertex of any other element."""

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
