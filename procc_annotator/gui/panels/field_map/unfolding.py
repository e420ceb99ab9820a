"""What stands or hangs above the ground, laid flat next to the field on its map."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.field.geometry import SAME_PLACE_M, outline_of
from procc_annotator.field.model import Element

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

    What is on the ground stays where it is, a border above the ground becomes a second one around
    it, and whatever else stands or hangs is laid outwards behind its end of the field, seen from
    the field; what stands in the middle is laid behind the right end. Single places stay where they
    are, at the map's edge if they are far away.

    Args:
        elements: of a field.
        ground: (left, top, right, bottom) of those on the ground, metres.
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
    """Return how to lay single places flat that are none of the field's own: next to the thing in
    the air that they belong to, else where they are.

    Args:
        places: (n, 3) metres.
        elements: of the field.
        ways: how these are laid (`unfolded`).
        ground: (left, top, right, bottom) of those on the ground, metres.
    """
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
