"""Projected elements as flat arrays, and distances of points to them.

All elements of a frame are one list of vertices; nothing here loops over points or elements.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.intp]
BoolArray = NDArray[np.bool_]


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
        """Several frames as one: the elements of each follow those of the one before.

        Args:
            frames: at least one, all of the same field and protocol.
        """
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
        """What was `joined`, or projected together, frame by frame."""
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
        """The nearest projected position of each point; arguments as for `distances`.

        Returns:
            (n, 2) px; segments without a distance are passed over (NaN if there is no other).
        """
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
        """For every pair (point, segment of its element) the point minus its foot.

        Returns:
            x and y offsets of all pairs, the first pair of each point, and pairs a point. This is
            where scoring spends its time, hence the arithmetic in place.
        """
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
