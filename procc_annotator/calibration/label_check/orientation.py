"""Orientation relations of field elements in any image, and class exchanges by reflection.

Seen from above the ground, three of its points that go round clockwise do so in every picture: with
homogeneous coordinates the determinant of three projected points is that of the field's points,
times that of the homography, over three depths that are positive for what is seen. So two things
hold whatever the camera:

- three things keep their orientation, if all choices of a point on each of them have the same one,
  i.e. if no straight line meets all three;
- two things on the same side of a line stay on the same side of it.

Half a turn of the field changes neither.

A frame may be labelled top for bottom or left for right, as the reflected field. Reflecting twice,
across and along, is half a turn. Of a field that half a turn takes to itself no camera can
decide it:
there the two reflections are one and the same mistake, seen from the two sides of the field. A
field without symmetry has no reflection either.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.field.geometry import (
    Line,
    outline_of,
)
from procc_annotator.field.model import Element

Corner = tuple[int, int]  # two straight elements that meet

# A triangle this flat on the field says nothing.
_MIN_ALTITUDE_M = 0.1
_TOUCH_TOLERANCE_M = 0.05


@dataclass(frozen=True, eq=False)
class OrientationRelations:
    """The relations of a field's things: its E ground elements, then the corners of two lines.

    Attributes:
        rows: (E,) names of the ground elements.
        corners: (C,) pairs of rows: straight elements that touch or cross.
        triples: (E + C, E + C, E + C) orientation of three things, 0 where it is not fixed.
        sides: (E, E + C) side of a straight element, walked from its start to its end, that a thing
            lies on; 0 where it lies on both, and for curves.
    """

    rows: tuple[str, ...]
    corners: tuple[Corner, ...]
    triples: NDArray[np.int8]
    sides: NDArray[np.int8]


@lru_cache(maxsize=4)
def orientation_relations(elements: tuple[Element, ...]) -> OrientationRelations:
    """The relations of a field.

    Args:
        elements: of the field; those off the ground are left out.
    """
    ground = [element for element in elements if element.on_ground]
    things = [_outline(element) for element in ground]
    corners: list[Corner] = []
    for i, one in enumerate(ground):
        for j in range(i + 1, len(ground)):
            place = _intersection_point(one, ground[j])
            if place is not None:
                corners.append((i, j))
                things.append(place[None])
    owner = np.repeat(np.arange(len(things)), [len(thing) for thing in things])
    points = np.concatenate(things) if things else np.zeros((0, 2))
    starts = np.searchsorted(owner, np.arange(len(things)))
    count = len(things)
    triples = np.zeros((count, count, count), dtype=np.int8)
    sides = np.zeros((len(ground), count), dtype=np.int8)
    for i, thing in enumerate(things):
        begin = starts[i] + len(thing)
        later = _orientations_with(thing, points[begin:], starts[i + 1 :] - begin)
        # The same three things in another order: turned by an odd one.
        triples[i, i + 1 :, i + 1 :] = triples[i + 1 :, i + 1 :, i] = later
        triples[i + 1 :, i, i + 1 :] = -later
        if i < len(ground) and isinstance(ground[i].geometry, Line):
            first, second = thing[0], thing[-1]
            across = _cross_2d(second - first, points - first) / np.hypot(*(second - first))
            sides[i] = _definite_sign(
                np.minimum.reduceat(across, starts), np.maximum.reduceat(across, starts)
            )
    for array in (triples, sides):
        array.setflags(write=False)
    return OrientationRelations(tuple(e.name for e in ground), tuple(corners), triples, sides)


def _orientations_with(
    thing: FloatArray, points: FloatArray, starts: NDArray[np.intp]
) -> NDArray[np.int8]:
    """(T, T) orientation of one thing with each two others."""
    if not len(starts):
        return np.zeros((0, 0), dtype=np.int8)
    least = np.full((len(starts), len(starts)), np.inf)
    most = -least
    for own in thing:
        flat = signed_altitudes(own, points[:, None], points[None])
        low = np.minimum.reduceat(np.minimum.reduceat(flat, starts, axis=0), starts, axis=1)
        high = np.maximum.reduceat(np.maximum.reduceat(flat, starts, axis=0), starts, axis=1)
        least, most = np.minimum(least, low), np.maximum(most, high)
    return _definite_sign(least, most)


def _definite_sign(least: FloatArray, most: FloatArray) -> NDArray[np.int8]:
    return ((least > _MIN_ALTITUDE_M).astype(np.int8) - (most < -_MIN_ALTITUDE_M)).astype(np.int8)


def signed_altitudes(a: FloatArray, b: FloatArray, c: FloatArray) -> FloatArray:
    """Signed smallest altitude of triangles: no corner moved by less than half of it turns them.

    Args:
        a, b, c: (..., 2) corners.

    Returns:
        (...) positive where a, b, c go from the x axis towards the y axis.
    """
    doubled = _cross_2d(b - a, c - a)
    longest = np.maximum(
        np.maximum(((b - a) ** 2).sum(axis=-1), ((c - a) ** 2).sum(axis=-1)),
        ((c - b) ** 2).sum(axis=-1),
    )
    return np.asarray(doubled / np.sqrt(np.maximum(longest, 1e-12)))


def _cross_2d(a: FloatArray, b: FloatArray) -> FloatArray:
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


def _outline(element: Element) -> FloatArray:
    """(n, 2) metres: points whose convex hull is about that of a ground element."""
    return outline_of(element.geometry)[:, :2]


def _intersection_point(one: Element, other: Element) -> FloatArray | None:
    """(2,) metres: where two straight elements touch or cross."""
    if not isinstance(one.geometry, Line) or not isinstance(other.geometry, Line):
        return None
    p, q = np.array(one.geometry.start[:2]), np.array(other.geometry.start[:2])
    r, s = np.array(one.geometry.end[:2]) - p, np.array(other.geometry.end[:2]) - q
    turn = float(_cross_2d(r, s))
    if abs(turn) < 1e-6 * float(np.hypot(*r) * np.hypot(*s)):
        return None
    along, also = float(_cross_2d(q - p, s)) / turn, float(_cross_2d(q - p, r)) / turn
    slack = _TOUCH_TOLERANCE_M / float(np.hypot(*r)), _TOUCH_TOLERANCE_M / float(np.hypot(*s))
    if not (-slack[0] <= along <= 1 + slack[0] and -slack[1] <= also <= 1 + slack[1]):
        return None
    return np.asarray(p + along * r)
