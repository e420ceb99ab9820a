"""Which elements of a field meet, and how far apart elements are."""

from __future__ import annotations

import math
from collections.abc import Collection
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.geometry import (
    Geometry,
    Line,
    Spot,
    angles_of,
    points_at_angles,
    middle_of,
    parts_of,
)
from procc_annotator.field.model import Element, Field

FloatArray = NDArray[np.float64]

# By how much a curve leaves the chords that stand for it: metres at most, and of its radius.
_SAGITTA_M, _SAGITTA_SHARE = 0.02, 0.02
_TOUCH_TOLERANCE_M = 0.2  # paint has a width, and some lines end at another one's edge
_ROUNDING_TOLERANCE_M = 1e-3  # more than products of matrices lose


def distances_from(field: Field, class_names: Collection[str]) -> FloatArray:
    """(E,) metres from each element to the nearest of some, curves to a few centimetres.

    Args:
        field: any.
        class_names: those without a geometry do not count; infinite where none has one.
    """
    # Landmarks come and go while somebody annotates: what is known of the field itself stays.
    landmarks = {landmark.name for landmark in field.landmarks}
    placed = np.array([e.name in landmarks for e in field.elements])
    chosen = np.array([e.name in class_names for e in field.elements])
    own = tuple(e for e in field.elements if e.name not in landmarks)
    segments = _segments_of(own)
    rows = [segments.distances(i) for i in np.flatnonzero(chosen[~placed]).tolist()]
    found = np.full(len(placed), np.inf)
    found[~placed] = np.min(rows, axis=0, initial=np.inf) if rows else np.inf
    if placed.any():
        spots = [e for e in field.elements if e.name in landmarks]
        places = np.array([middle_of(e.geometry) for e in spots])
        away = segments.distances_to(places)
        among = np.linalg.norm(places[:, None] - places, axis=2)
        far = [away[:, chosen[~placed]], among[:, chosen[placed]]]
        found[placed] = np.hstack(far).min(axis=1, initial=np.inf)
        near = away[chosen[placed]].min(axis=0, initial=np.inf)
        found[~placed] = np.minimum(found[~placed], near)
    return found


def touching_elements(field: Field, class_name: str) -> tuple[str, ...]:
    """The elements that touch or cross this one, in the field's order; () for an unknown class."""
    near = distances_from(field, (class_name,)) <= _TOUCH_TOLERANCE_M
    return tuple(
        e.name for e, met in zip(field.elements, near, strict=True) if met and e.name != class_name
    )


def distances_to(elements: tuple[Element, ...], points: FloatArray) -> FloatArray:
    """(n, E) metres from places (n, 3) to the nearest place of each of some elements, to 2 cm."""
    return _segments_of(elements).distances_to(points)


class _ElementSegments:
    """Segments that stand for some elements, and how far apart these are as far as it was asked.

    Attributes:
        every: (S, 2, 3) metres, element by element.
        starts: (E,) the first segment of each element.
    """

    def __init__(self, elements: tuple[Element, ...]) -> None:
        pieces = [_segments_of_geometry(e.geometry) for e in elements]
        counts = [len(piece) for piece in pieces]
        self.every = np.concatenate(pieces)
        self.starts = np.cumsum([0, *counts[:-1]])
        self._ends = np.cumsum(counts)
        self._element = np.repeat(np.arange(len(pieces)), counts)
        self._middles = self.every.mean(axis=1)
        self._halves = np.linalg.norm(self.every[:, 1] - self._middles, axis=1)
        self._known: dict[int, FloatArray] = {}

    def distances(self, index: int) -> FloatArray:
        """(E,) metres from each element to one of them."""
        if index not in self._known:
            self._known[index] = self._measured(index)
        return self._known[index]

    def _measured(self, index: int) -> FloatArray:
        """Only segments are measured that, as balls, are near enough to be the nearest ones."""
        own = slice(self.starts[index], self._ends[index])
        apart = np.sqrt(np.maximum(_squared_distances(self._middles[own], self._middles), 0.0))
        most = np.minimum.reduceat(apart.min(axis=0), self.starts) + _ROUNDING_TOLERANCE_M
        apart -= self._halves[own, None]
        which, other = np.nonzero(apart <= (most[self._element] + self._halves))
        found = np.full(len(self.starts), np.inf)
        measured = _segment_distances(self.every[own][which], self.every[other])
        np.minimum.at(found, self._element[other], measured)
        found.setflags(write=False)
        return found

    def distances_to(self, points: FloatArray) -> FloatArray:
        """(n, E) metres from places (n, 3) to each element."""
        begin, span = self.every[:, 0], self.every[:, 1] - self.every[:, 0]
        squares = np.maximum((span**2).sum(axis=1), 1e-12)
        # Products of matrices instead of (n, S, 3) arrays, which take ten times as long.
        along = points @ span.T - (begin * span).sum(axis=1)
        apart = _squared_distances(points, begin)
        share = np.clip(along / squares, 0.0, 1.0)
        apart -= share * (2 * along - share * squares)
        nearest = np.minimum.reduceat(apart, self.starts, axis=1)
        return np.asarray(np.sqrt(np.maximum(nearest, 0.0)))


# A window asks for one field; with other dimensions, or to compare, for some.
_segments_of = lru_cache(maxsize=32)(_ElementSegments)


def _squared_distances(points: FloatArray, others: FloatArray) -> FloatArray:
    """(n, m) squares of the distances between places (n, 3) and (m, 3); a rounding below 0."""
    own = (points**2).sum(axis=1)[:, None]
    return np.asarray(own - 2 * points @ others.T + (others**2).sum(axis=1))


def _segments_of_geometry(geometry: Geometry) -> FloatArray:
    """(n, 2, 3) both ends of segments that stand for a geometry; a spot is one without length."""
    found = []
    for part in parts_of(geometry):
        if isinstance(part, Line):
            points = np.array([part.start, part.end])
        elif isinstance(part, Spot):
            points = np.array([part.position, part.position])
        else:
            first, last = angles_of(part)
            step = 2 * math.acos(1 - min(_SAGITTA_M / part.radius, _SAGITTA_SHARE))
            points = points_at_angles(part, np.linspace(first, last, math.ceil((last - first) / step) + 1))
        found.append(np.stack([points[:-1], points[1:]], axis=1))
    return np.concatenate(found)


def _segment_distances(one: FloatArray, other: FloatArray) -> FloatArray:
    """(n,) smallest distances between segments (n, 2, 3) and as many others.

    The nearest places of both lines, then the one on each segment nearest to the other's; see
    C. Ericson, Real-Time Collision Detection, 5.1.9.
    """
    along, across = one[:, 1] - one[:, 0], other[:, 1] - other[:, 0]
    between = one[:, 0] - other[:, 0]
    a, b, e = (
        np.einsum("nk,nk->n", *two) for two in ((along, along), (along, across), (across, across))
    )
    c, f = np.einsum("nk,nk->n", between, along), np.einsum("nk,nk->n", between, across)
    rise = a * e - b * b
    slanted = rise > 1e-12 * a * e
    s = np.where(slanted, (b * f - c * e) / np.where(slanted, rise, 1.0), 0.0).clip(0.0, 1.0)
    t = ((b * s + f) / np.where(e > 0, e, 1.0)).clip(0.0, 1.0)
    s = ((b * t - c) / np.where(a > 0, a, 1.0)).clip(0.0, 1.0)
    gap = between + s[:, None] * along - t[:, None] * across
    return np.asarray(np.sqrt((gap**2).sum(axis=1)))
