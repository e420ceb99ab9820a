"""The field laid flat: walls unfolded, every element as a line, the element under the cursor."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.field.geometry import (
    SAME_PLACE_M,
    Arc,
    Circle,
    Geometry,
    Spot,
    Vector,
    angles_of,
    outline_of,
    parts_of,
    points_at_angles,
)
from procc_annotator.field.model import Element, Field

Bounds = tuple[float, float, float, float]
Unfold = Callable[[FloatArray], FloatArray]

# Elements nearer than this belong to one thing: a goal, a basket, a net with its antennae.
_TOGETHER_M = 1.5
# Shares of the field's length. A crossbar at true scale would lie too near its goal line.
_TALL, _TALL_HANGING, _TALL_NET = 0.056, 0.11, 0.14
_SMALL, _ENLARGED = 0.065, 0.16
_GAP, _RIM, _EDGE = 0.05, 0.03, 0.02
_MARGIN = 0.12  # how far outside of the field a single place is shown
_RING = 0.5  # what runs around so much of the field is a border, not a thing
_MIDDLE = 0.25
_HANGS_M = 0.5


@dataclass(frozen=True)
class _Thing:
    """Elements that stand together: points (n, 3) metres, and where they are on the field."""

    points: FloatArray
    ground: Bounds

    @property
    def size(self) -> tuple[float, float]:
        """Along and across the field, metres."""
        along, across = np.ptp(self.points[:, :2], axis=0).tolist()
        return along, across

    @property
    def heights(self) -> tuple[float, float]:
        """Lowest and highest, metres above the ground."""
        up = -self.points[:, 2]
        return float(up.min()), float(up.max())


def unfolded(elements: tuple[Element, ...], ground: Bounds) -> list[Unfold]:
    """Return how to lay each element flat: functions of (n, 3) metres to (n, 2) map metres.

    What is on the ground (left, top, right, bottom) stays where it is, a border above the ground
    becomes a second one around it, and whatever else stands or hangs is laid outwards behind its
    end of the field, seen from the field; what stands in the middle is laid behind the right end.
    Single places stay where they are, at the map's edge if they are far away.
    """
    found: list[Unfold] = [_from_above] * len(elements)
    standing = [i for i, e in enumerate(elements) if not e.on_ground]
    points = {i: outline_of(elements[i].geometry) for i in standing}
    for group in _together(standing, points):
        thing = _Thing(np.concatenate([points[i] for i in group]), ground)
        alone = all(elements[i].is_spot for i in group)
        laid = _edge_of(ground) if alone else _laid(thing)
        for i in group:
            found[i] = laid
    for i, element in enumerate(elements):
        if element.is_spot and element.on_ground:
            found[i] = _edge_of(ground)
    return found


def unfolded_spots(
    places: FloatArray, elements: tuple[Element, ...], ways: Sequence[Unfold], ground: Bounds
) -> list[Unfold]:
    """Return how to lay single places (n, 3), metres, flat that are none of the field's own: next
    to the thing in the air that they belong to, among the elements, which are laid in the ``ways``
    of `unfolded`, else where they are."""
    found = [_edge_of(ground)] * len(places)
    standing = [(i, outline_of(e.geometry)) for i, e in enumerate(elements) if not e.on_ground]
    hanging = np.flatnonzero(abs(places[:, 2]) > SAME_PLACE_M)
    if standing and len(hanging):
        points = np.concatenate([own for _, own in standing])
        owner = np.repeat([i for i, _ in standing], [len(own) for _, own in standing])
        apart = np.linalg.norm(places[hanging, None] - points, axis=2)
        for i, nearest, far in zip(hanging, apart.argmin(axis=1), apart.min(axis=1), strict=True):
            if far < _TOGETHER_M:
                found[i] = ways[owner[nearest]]
    return found


def _together(standing: list[int], points: dict[int, FloatArray]) -> list[list[int]]:
    groups: list[list[int]] = []
    for i in standing:
        near = [g for g in groups if any(_apart(points[i], points[j]) < _TOGETHER_M for j in g)]
        groups = [g for g in groups if g not in near]
        groups.append([i, *(j for g in near for j in g)])
    return groups


def _apart(one: FloatArray, other: FloatArray) -> float:
    return float(np.linalg.norm(one[:, None] - other[None], axis=2).min())


def _from_above(points: FloatArray) -> FloatArray:
    return points[:, :2].copy()


def _edge_of(ground: Bounds) -> Unfold:
    left, top, right, bottom = ground
    margin = _MARGIN * max(right - left, bottom - top)
    low = np.array([left, top]) - margin
    high = np.array([right, bottom]) + margin

    def clipped(points: FloatArray) -> FloatArray:
        return np.clip(points[:, :2], low, high)

    return clipped


def _laid(thing: _Thing) -> Unfold:
    left, top, right, bottom = thing.ground
    length, width = right - left, bottom - top
    along, across = thing.size
    if along > _RING * length and across > _RING * width:
        return _around(thing, _RIM * max(length, width))
    middle = thing.points[:, :2].mean(axis=0) - ((left + right) / 2, (top + bottom) / 2)
    if abs(middle[0]) < _MIDDLE * length and abs(middle[1]) > _MIDDLE * width and along > across:
        return _outwards(thing, 1, math.copysign(1.0, middle[1]), length)
    in_middle = bool(abs(middle[0]) < _MIDDLE * length)
    side = 1.0 if in_middle else math.copysign(1.0, middle[0])
    return _outwards(thing, 0, side, length, in_middle)


def _around(thing: _Thing, margin: float) -> Unfold:
    left, top, right, bottom = thing.ground
    centre = np.array([(left + right) / 2, (top + bottom) / 2])
    half = np.maximum(np.array([right - left, bottom - top]) / 2, 1e-6)

    def widened(points: FloatArray) -> FloatArray:
        return np.asarray(centre + (points[:, :2] - centre) * (1 + margin / half))

    return widened


def _outwards(
    thing: _Thing, axis: int, side: float, length: float, in_middle: bool = False
) -> Unfold:
    """Laid flat in a direction: its own breadth stays across, heights go outwards."""
    low, high = thing.heights
    breadth = float(np.ptp(thing.points[:, 1 - axis]))
    hangs = low > _HANGS_M
    larger = _ENLARGED * length / breadth if 0 < breadth < _SMALL * length else 1.0
    share = _TALL_NET if in_middle else _TALL_HANGING if hangs else _TALL
    base = low if hangs and not in_middle else 0.0
    tall = share * length / max(high - base, 1e-6)
    centre = float(thing.points[:, 1 - axis].mean()) if larger > 1 else 0.0
    depth = side * thing.points[:, axis]
    edge = side * np.array(thing.ground).reshape(2, 2)[:, axis]
    inside = edge.max() - depth.max() > _EDGE * length  # its own end has other lines behind it
    beyond = hangs or in_middle or inside
    foot = float(edge.max()) + _GAP * length if beyond else float(depth.min())

    def laid(points: FloatArray) -> FloatArray:
        flat = np.empty((len(points), 2))
        flat[:, 1 - axis] = centre + larger * (points[:, 1 - axis] - centre)
        inwards = larger * (side * points[:, axis] - depth.min())
        flat[:, axis] = side * (foot + inwards + tall * (-points[:, 2] - base))
        return flat

    return laid


_STEPS = 100  # a curve's pieces are so small a part of the field
_ROUND_RAD = 0.2  # or smaller: a small circle is to be round
_COARSE = 24
_SHORTER = 0.7
_SMALLEST_M = 1.0  # a field of one line has a map, too
# Where along an element its sign may be, the best place first: off the middle, where others meet.
_SHARES = (0.4, 0.6, 0.25, 0.75, 0.5, 0.12, 0.88)
_FREE = 0.06  # of the map's size: so far from all others a place is as good as any


@dataclass(frozen=True, eq=False)
class FieldShape:
    """Elements as polylines on the map.

    Attributes:
        names: (E,) element names.
        lines: (E,) arrays (n, 2) of map metres: x along the field, y across, the main camera's side
            down; what stands upright is laid outwards behind its end of the field. One place of a
            spot.
        lengths: (E,) metres on the map.
        anchors: (E, 2) map metres: where each element bears its sign, away from the others
            of the field.
        bounds: (left, top, right, bottom) in map metres.
        ground: the same of the elements on the ground.
    """

    names: tuple[str, ...]
    lines: tuple[FloatArray, ...]
    lengths: FloatArray
    anchors: FloatArray
    bounds: Bounds
    ground: Bounds
    _segments: _Segments
    _unfold: tuple[Unfold, ...]

    @classmethod
    def of(cls, field: Field) -> FieldShape:
        landmarks = {landmark.name for landmark in field.landmarks}
        own = tuple(e for e in field.elements if e.name not in landmarks)
        places = {
            e.name: e.geometry.position
            for e in field.elements
            if e.name in landmarks and isinstance(e.geometry, Spot)
        }
        # They come and go one by one, and the map of the field stays as it is.
        shape = _shape_of(own)
        return shape._with_spots(own, places) if places else shape

    @classmethod
    def _of_elements(cls, elements: tuple[Element, ...]) -> FieldShape:
        outlines = [outline_of(e.geometry) for e in elements]
        wide = [o for o, e in zip(outlines, elements, strict=True) if not e.is_spot]
        size = float(np.ptp(np.concatenate(wide or outlines)[:, :2], axis=0).max())
        points = [_course(e.geometry, max(size, _SMALLEST_M) / _STEPS) for e in elements]
        lying = [
            p[:, :2] for p, e in zip(points, elements, strict=True) if e.on_ground and not e.is_spot
        ]
        ground = _bounds(np.concatenate(lying or [p[:, :2] for p in points]))
        ways = unfolded(elements, ground)
        lines = tuple(way(own) for way, own in zip(ways, points, strict=True))
        bounds = _bounds(np.concatenate(lines))
        segments = _Segments.of(lines)
        anchors = _anchors(lines, segments, max(bounds[2] - bounds[0], bounds[3] - bounds[1]))
        names = tuple(e.name for e in elements)
        return cls(names, lines, segments.lengths, anchors, bounds, ground, segments, tuple(ways))

    def _with_spots(
        self, elements: tuple[Element, ...], places: Mapping[str, Vector]
    ) -> FieldShape:
        """With single places, metres, after the elements it was made of."""
        points = np.array(list(places.values()))
        ways = unfolded_spots(points, elements, self._unfold, self.ground)
        lines = [way(at[None]) for way, at in zip(ways, points, strict=True)]
        corners = np.reshape(self.bounds, (2, 2))
        return FieldShape(
            (*self.names, *places),
            (*self.lines, *lines),
            np.append(self.lengths, np.zeros(len(lines))),
            np.concatenate([self.anchors, *lines]),
            _bounds(np.concatenate([corners, *lines])),
            self.ground,
            self._segments.joined(_Segments.of(lines)),
            (*self._unfold, *ways),
        )

    def on_map(self, class_name: str, points_world: FloatArray) -> FloatArray:
        """(n, 2) map metres of places (n, 3) along an element, metres."""
        return self._unfold[self.names.index(class_name)](points_world)

    def pick(self, x: float, y: float, tolerance: float) -> str | None:
        """The element nearest to a map position, within a tolerance (metres on the map).

        Where two are about equally near (a post on its goal line, a mark on a line) the shorter one
        is meant: the longer one can be picked elsewhere.
        """
        distances = self._segments.distances(np.array([[x, y]]))[0]
        nearest = int(distances.argmin())
        if distances[nearest] > tolerance:
            return None
        about = distances <= min(tolerance, distances[nearest] + tolerance / 6)
        shorter = np.flatnonzero(about & (self.lengths < _SHORTER * self.lengths[nearest]))
        if not shorter.size:
            return self.names[nearest]
        return self.names[int(shorter[np.argmin(self.lengths[shorter])])]


@dataclass(frozen=True, eq=False)
class _Segments:
    """All lines as segments, (S, 2) each; element i owns those from ``starts[i]``."""

    begin: FloatArray
    along: FloatArray
    starts: NDArray[np.intp]

    @classmethod
    def of(cls, lines: Sequence[FloatArray]) -> _Segments:
        own = [line if len(line) > 1 else line[[0, 0]] for line in lines]  # spots have no length
        counts = [len(line) - 1 for line in own]
        starts = np.cumsum([0, *counts[:-1]], dtype=np.intp)
        begin = np.concatenate([line[:-1] for line in own])
        return cls(begin, np.concatenate([np.diff(line, axis=0) for line in own]), starts)

    @cached_property
    def steps(self) -> FloatArray:
        """(S,) the length of each, map metres."""
        return np.asarray(np.hypot(self.along[:, 0], self.along[:, 1]))

    @cached_property
    def lengths(self) -> FloatArray:
        """(E,) the length of each line, map metres."""
        return np.asarray(np.add.reduceat(self.steps, self.starts))

    def joined(self, other: _Segments) -> _Segments:
        """These lines and then those of another."""
        return _Segments(
            np.concatenate([self.begin, other.begin]),
            np.concatenate([self.along, other.along]),
            np.concatenate([self.starts, other.starts + len(self.begin)]),
        )

    def at(self, shares: FloatArray) -> FloatArray:
        """(E, P, 2) the places at shares (P,) of the length of each line."""
        reached = np.concatenate([[0.0], np.cumsum(self.steps)])
        last = np.append(self.starts[1:], len(self.begin)) - 1
        wanted = reached[self.starts, None] + shares * self.lengths[:, None]
        which = np.searchsorted(reached, wanted, side="right") - 1
        which = np.clip(which, self.starts[:, None], last[:, None])
        part = (wanted - reached[which]) / np.maximum(self.steps[which], 1e-12)
        return np.asarray(self.begin[which] + part.clip(0, 1)[..., None] * self.along[which])

    def distances(self, places: FloatArray) -> FloatArray:
        """(P, E) from each place (P, 2) to each element, map metres."""
        # |p - a - k d|^2 by products of matrices: there are thousands of segments.
        a, d = self.begin, self.along
        squares = np.maximum((d**2).sum(axis=1), 1e-12)
        ahead = places @ d.T - (a * d).sum(axis=1)
        k = np.clip(ahead / squares, 0, 1)
        apart = (places**2).sum(axis=1)[:, None] - 2 * places @ a.T + (a**2).sum(axis=1)
        apart += k * (k * squares - 2 * ahead)
        return np.asarray(np.sqrt(np.maximum(np.minimum.reduceat(apart, self.starts, axis=1), 0)))


# Switched back and forth, a window asks for few fields.
_shape_of = lru_cache(maxsize=8)(FieldShape._of_elements)


def _course(geometry: Geometry, spacing_m: float) -> FloatArray:
    """(n, 3) places along an element, its corners among them; one of a spot."""
    found: list[FloatArray] = []
    for part in parts_of(geometry):
        if isinstance(part, Arc | Circle):
            first, last = angles_of(part)
            turn = last - first
            count = max(math.ceil(turn / _ROUND_RAD), math.ceil(turn * part.radius / spacing_m))
            found.append(points_at_angles(part, np.linspace(first, last, count + 1)))
        else:
            found.append(outline_of(part))
    return np.concatenate([found[0], *(points[1:] for points in found[1:])])


def _anchors(lines: Sequence[FloatArray], segments: _Segments, size: float) -> FloatArray:
    """(E, 2) the first place along each element that is free of the others, or the freest one."""
    places = segments.at(np.array(_SHARES))
    coarse = [line[_every(len(line))] for line in lines]
    distances = _Segments.of(coarse).distances(places.reshape(-1, 2))
    distances = distances.reshape(len(lines), len(_SHARES), -1)
    every = np.arange(len(lines))
    distances[every, :, every] = np.inf
    # Rounded: of places that are as free as each other the first one, not one that noise decides.
    free = np.minimum(distances.min(axis=2), _FREE * size).round(3)
    return np.asarray(places[every, free.argmax(axis=1)])


def _every(count: int) -> list[int]:
    """Which points of a long curve say well enough where it runs."""
    step = max(1, count // _COARSE)
    return [*range(0, count - 1, step), count - 1] if count > 1 else [0]


def _bounds(points: FloatArray) -> Bounds:
    low, high = points.min(axis=0), points.max(axis=0)
    missing = np.maximum(_SMALLEST_M - (high - low), 0) / 2
    left, top = (low - missing).tolist()
    right, bottom = (high + missing).tolist()
    return left, top, right, bottom
