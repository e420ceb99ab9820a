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

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.arrays import FloatArray
from procc_annotator.field.geometry import (
    Arc,
    Chain,
    Geometry,
    Line,
    Spot,
    Vector,
    outline_of,
    same_geometry,
)
from procc_annotator.field.model import Element, Field
from procc_annotator.translation import translatable

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


_SAME_PLACE_M = 0.01
MIRROR_X = (-1.0, 1.0)  # left for right
MIRROR_Y = (1.0, -1.0)  # top for bottom
MIRROR_REMEDY_TEXTS = {  # the remedies
    MIRROR_Y: translatable("exchange far and near in the whole frame"),
    MIRROR_X: translatable("exchange left and right in the whole frame"),
}


def mirrored_names(
    field: Field, signs: tuple[float, float], needed: Iterable[str] = ()
) -> Mapping[str, str] | None:
    """The class that each class becomes when the field is reflected.

    Args:
        field: the elements.
        signs: factors of x and y: `ALONG` or `MIRROR_Y`.
        needed: classes that must become one.

    Returns:
        None where one of those becomes none: what is given by its place on one side only (a mark
        before the team benches, a landmark) cannot have been taken for its own reflection.
    """
    found = _mirrored_elements(field.elements, signs)
    return found if all(name in found for name in needed) else None


@lru_cache(maxsize=16)
def _mirrored_elements(elements: tuple[Element, ...], signs: tuple[float, float]) -> dict[str, str]:
    free = list(elements)
    found: dict[str, str] = {}
    for element in elements:
        there = _mirrored_geometry(element.geometry, signs)
        twin = next((e for e in free if same_geometry(e.geometry, there, _SAME_PLACE_M)), None)
        if twin is not None:
            free.remove(twin)
            found[element.name] = twin.name
    return found


def _mirrored_geometry(shape: Geometry, signs: tuple[float, float]) -> Geometry:
    if isinstance(shape, Line):
        return Line(_mirrored_point(shape.start, signs), _mirrored_point(shape.end, signs))
    if isinstance(shape, Spot):
        return Spot(_mirrored_point(shape.position, signs))
    if isinstance(shape, Chain):
        parts = (_mirrored_geometry(part, signs) for part in shape.parts)
        return Chain(tuple(part for part in parts if isinstance(part, Line | Arc)))
    places = (shape.centre, shape.ahead, shape.aside)
    centre, ahead, aside = (_mirrored_point(place, signs) for place in places)
    return replace(shape, centre=centre, ahead=ahead, aside=aside)


def _mirrored_point(place: Vector, signs: tuple[float, float]) -> Vector:
    return signs[0] * place[0], signs[1] * place[1], place[2]


def relabelled(annotation: FrameAnnotation, names: Mapping[str, str]) -> FrameAnnotation:
    """An annotation with classes exchanged, all at once; unconfirmed elements are dropped."""
    return FrameAnnotation(
        tuple(
            Polyline(names.get(p.class_name, p.class_name), p.points) for p in annotation.polylines
        )
    )
