"""Sample field elements as world points; their corners, crossings, neighbours and distances."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.field.geometry import (
    Arc,
    Chain,
    Circle,
    Geometry,
    Line,
    Spot,
    angles_of,
    ends_of,
    is_closed,
    middle_of,
    parts_of,
    points_at_angles,
)
from procc_annotator.field.model import Element, Field

STRAIGHT_SPACING_M = 0.9
CURVE_SPACING_M = 0.2
# The official spacing is one for large circles: of a basket's rim it would leave seven points. No
# curve that the official evaluation knows is so small that this reaches it.
_MAX_OFFICIAL_STEP_RAD = 0.1
_MAX_STEP_RAD = math.radians(15.0)


@dataclass(frozen=True, eq=False)
class FieldSamples:
    """Samples of all E elements; element i owns rows ``offsets[i]:offsets[i + 1]``.

    Attributes:
        names: (E,) class names, in the field's order.
        points_world: (N, 3) metres, world frame; read-only.
        offsets: (E + 1,) row at which each element starts; read-only.
        closed: (E,) whether the last sample repeats the first.
    """

    names: tuple[str, ...]
    points_world: FloatArray
    offsets: NDArray[np.intp]
    closed: NDArray[np.bool_]

    def of(self, i: int) -> FloatArray:
        """(n, 3) samples of the i-th element, metres."""
        return self.points_world[self.offsets[i] : self.offsets[i + 1]]


@lru_cache(maxsize=16)
def _official_cached(key: tuple[tuple[str, Geometry], ...]) -> FieldSamples:
    return _collect_samples(
        key, [_official_samples(geometry) for _, geometry in key], closed_curves=False
    )


def sample_official(field: Field) -> FieldSamples:
    """Samples, metres, at the spacing of the official SoccerNet evaluation, its uneven ends
    included; about a thousand for a large field.

    Straight elements: first end, then ``int(length / 0.9 - 1)`` points 0.9 m apart, then the second
    end. Circles: 0.2 m of arc apart (0.1 rad where that is less), not closed. Arcs: the same, then
    the exact end. Chains: part by part; spots: themselves.
    """
    return _official_cached(tuple((e.name, e.geometry) for e in field.elements))


def sample_evenly(field: Field, spacing_m: float) -> FieldSamples:
    """Evenly spaced samples, ends exact, circles closed (the last point equals the first).

    Args:
        field: E elements.
        spacing_m: largest distance between neighbours along the element, metres, positive. Curves
            turn by at most 15 degrees between two.

    Raises:
        ValueError: the spacing is not positive and finite.
    """
    if not (math.isfinite(spacing_m) and spacing_m > 0):
        raise ValueError(f"expected a positive spacing in metres, found {spacing_m!r}")
    key = tuple((e.name, e.geometry) for e in field.elements)
    return _collect_samples(
        key, [_even_samples(geometry, spacing_m) for _, geometry in key], closed_curves=True
    )


def _official_samples(geometry: Geometry) -> FloatArray:
    if isinstance(geometry, Chain):
        # Each part as if it stood alone; a joint is one sample.
        parts = [_official_samples(part) for part in geometry.parts]
        return np.concatenate([parts[0], *(part[1:] for part in parts[1:])])
    if isinstance(geometry, Spot):
        return np.array([geometry.position])
    if isinstance(geometry, Line):
        start, end = np.array(geometry.start), np.array(geometry.end)
        length = float(np.linalg.norm(end - start))
        steps = np.arange(1, int(length / STRAIGHT_SPACING_M - 1) + 1) * STRAIGHT_SPACING_M
        between = start + steps[:, None] * ((end - start) / length)
        return np.vstack([start, between, end])
    spacing = min(CURVE_SPACING_M, _MAX_OFFICIAL_STEP_RAD * geometry.radius)
    step = spacing / geometry.radius
    if isinstance(geometry, Circle):
        count = int(2 * math.pi * geometry.radius / spacing)
        angles: FloatArray = np.arange(count, dtype=np.float64) * step
    else:
        arc_length = (geometry.end_rad - geometry.start_rad) * geometry.radius
        inner = (
            geometry.start_rad + np.arange(int(arc_length / spacing) + 1, dtype=np.float64) * step
        )
        angles = np.append(inner, np.float64(geometry.end_rad))
    return points_at_angles(geometry, angles)


def _even_samples(geometry: Geometry, spacing_m: float) -> FloatArray:
    if isinstance(geometry, Chain):
        parts = [_even_samples(part, spacing_m) for part in geometry.parts]
        points = np.concatenate([parts[0], *(part[1:] for part in parts[1:])])
        if is_closed(geometry):
            points[-1] = points[0]
        return points
    if isinstance(geometry, Spot):
        return np.array([geometry.position])
    if isinstance(geometry, Line):
        start, end = np.array(geometry.start), np.array(geometry.end)
        gaps = max(1, math.ceil(float(np.linalg.norm(end - start)) / spacing_m - 1e-9))
        t = np.linspace(0.0, 1.0, gaps + 1)[:, None]
        return np.asarray(start * (1 - t) + end * t)
    first, last = angles_of(geometry)
    # A hoop is smaller than the spacing of long lines, and no triangle.
    fewest = max(3, math.ceil((last - first) / _MAX_STEP_RAD - 1e-9))
    gaps = max(fewest, math.ceil((last - first) * geometry.radius / spacing_m - 1e-9))
    points = points_at_angles(geometry, np.linspace(first, last, gaps + 1))
    if isinstance(geometry, Circle):
        points[-1] = points[0]
    return points


def _collect_samples(
    key: tuple[tuple[str, Geometry], ...], parts: list[FloatArray], *, closed_curves: bool
) -> FieldSamples:
    points = np.concatenate(parts) if parts else np.zeros((0, 3))
    offsets = np.cumsum([0, *(len(part) for part in parts)], dtype=np.intp)
    closed = np.array([closed_curves and is_closed(g) for _, g in key], dtype=bool)
    for array in (points, offsets, closed):
        array.setflags(write=False)
    return FieldSamples(tuple(name for name, _ in key), points, offsets, closed)


# By how much a curve leaves the chords that stand for it: metres at most, and of its radius.
_SAGITTA_M, _SAGITTA_SHARE = 0.02, 0.02
_TOUCH_TOLERANCE_M = 0.2  # paint has a width, and some lines end at another one's edge
_ROUNDING_TOLERANCE_M = 1e-3  # more than products of matrices lose


def distances_from(field: Field, class_names: Collection[str]) -> FloatArray:
    """(E,) metres from each element to the nearest of some, curves to a few centimetres; classes
    without a geometry do not count, infinite where none has one."""
    # Landmarks come and go while a person annotates: what is known of the field itself stays.
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


def _few_segments(curve: Arc | Circle) -> int:
    first, last = angles_of(curve)
    step = 2 * math.acos(1 - min(_SAGITTA_M / curve.radius, _SAGITTA_SHARE))
    return math.ceil((last - first) / step)


def _chords_of(curve: Arc | Circle) -> int:
    first, last = angles_of(curve)
    return max(2, int((last - first) * curve.radius / _CROSSING_CHORD_M))


def _segments_of_geometry(
    geometry: Geometry, count: Callable[[Arc | Circle], int] = _few_segments
) -> FloatArray:
    """(n, 2, 3) both ends of segments that stand for a geometry; a spot is one without length."""
    found = []
    for part in parts_of(geometry):
        if isinstance(part, Line):
            points = np.array([part.start, part.end])
        elif isinstance(part, Spot):
            points = np.array([part.position, part.position])
        else:
            points = points_at_angles(part, np.linspace(*angles_of(part), count(part) + 1))
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


_CROSSING_CHORD_M = 0.25
_SAME_POINT_M = 0.05
_PARALLEL = 1e-6


@lru_cache(maxsize=16)
def distinctive_points(elements: tuple[Element, ...]) -> tuple[tuple[str, ...], FloatArray]:
    """Ends, corners of chains, spots, and where elements on the ground cross: the class that each
    is on, of those that share it the first; and (n, 3) metres."""
    names: list[str] = []
    places: list[FloatArray] = []
    for element in elements:
        own = [np.array(place) for place in _end_points(element)]
        names += [element.name] * len(own)
        places += own
    crossing_names, crossings = _crossings(elements)
    names += crossing_names
    every = np.array([*places, *crossings]).reshape(-1, 3)
    kept: list[int] = []
    for row, place in enumerate(every):
        if not kept or np.linalg.norm(every[kept] - place, axis=1).min() > _SAME_POINT_M:
            kept.append(row)
    return tuple(names[row] for row in kept), every[kept]


def _end_points(element: Element) -> list[tuple[float, float, float]]:
    geometry = element.geometry
    if isinstance(geometry, Spot):
        return [geometry.position]
    parts = parts_of(geometry) if isinstance(geometry, Chain) else (geometry,)
    return [end for part in parts for end in ends_of(part) or ()]


def _crossings(elements: tuple[Element, ...]) -> tuple[list[str], FloatArray]:
    """Return where chords of elements on the ground cross those of others; (n, 3) metres."""
    flat = [e for e in elements if e.on_ground and not isinstance(e.geometry, Spot)]
    chords = [_segments_of_geometry(e.geometry, _chords_of)[..., :2] for e in flat]
    if not chords:
        return [], np.empty((0, 3))
    owner = np.repeat(np.arange(len(flat)), [len(c) for c in chords])
    every = np.concatenate(chords)
    begin, step = every[:, 0], every[:, 1] - every[:, 0]
    turn = step[:, None, 0] * step[None, :, 1] - step[:, None, 1] * step[None, :, 0]
    apart = begin[None] - begin[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        along = (apart[..., 0] * step[None, :, 1] - apart[..., 1] * step[None, :, 0]) / turn
    inside = (along >= 0) & (along <= 1) & (np.abs(turn) > _PARALLEL)
    first, second = np.nonzero(inside & inside.T & (owner[:, None] < owner[None]))
    places = begin[first] + along[first, second][:, None] * step[first]
    names = [flat[owner[row]].name for row in first.tolist()]
    return names, np.column_stack([places, np.zeros(len(places))])
