"""A frame labelled top for bottom or left for right: the labels of the reflected field.

Reflecting a field twice, across and along, is half a turn. Of a field that half a turn takes to
itself no camera can tell it: there the two reflections are one and the same mistake, seen from the
two sides of the field. A field without symmetry has no reflection either.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import lru_cache

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.field.geometry import Arc, Chain, Geometry, Line, Spot, Vector, same_place
from procc_annotator.field.model import Element, Field

_SAME_PLACE_M = 0.01
ALONG = (-1.0, 1.0)  # left for right
ACROSS = (1.0, -1.0)  # top for bottom


def reflected_names(
    field: Field, signs: tuple[float, float], needed: Iterable[str] = ()
) -> Mapping[str, str] | None:
    """The class that each class becomes when the field is reflected.

    Args:
        field: the elements.
        signs: factors of x and y: `ALONG` or `ACROSS`.
        needed: classes that must become one.

    Returns:
        None where one of those becomes none: what is told by its place on one side only (a mark
        before the team benches, a landmark) cannot have been taken for its own reflection.
    """
    found = _reflected(field.elements, signs)
    return found if all(name in found for name in needed) else None


@lru_cache(maxsize=16)
def _reflected(elements: tuple[Element, ...], signs: tuple[float, float]) -> dict[str, str]:
    free = list(elements)
    found: dict[str, str] = {}
    for element in elements:
        there = _reflection(element.geometry, signs)
        twin = next((e for e in free if same_place(e.geometry, there, _SAME_PLACE_M)), None)
        if twin is not None:
            free.remove(twin)
            found[element.name] = twin.name
    return found


def _reflection(shape: Geometry, signs: tuple[float, float]) -> Geometry:
    if isinstance(shape, Line):
        return Line(_there(shape.start, signs), _there(shape.end, signs))
    if isinstance(shape, Spot):
        return Spot(_there(shape.position, signs))
    if isinstance(shape, Chain):
        parts = (_reflection(part, signs) for part in shape.parts)
        return Chain(tuple(part for part in parts if isinstance(part, Line | Arc)))
    places = (shape.centre, shape.ahead, shape.aside)
    centre, ahead, aside = (_there(place, signs) for place in places)
    return replace(shape, centre=centre, ahead=ahead, aside=aside)


def _there(place: Vector, signs: tuple[float, float]) -> Vector:
    return signs[0] * place[0], signs[1] * place[1], place[2]


def renamed(annotation: FrameAnnotation, names: Mapping[str, str]) -> FrameAnnotation:
    """An annotation with classes exchanged, all at once; unconfirmed elements are dropped."""
    return FrameAnnotation(
        tuple(
            Polyline(names.get(p.class_name, p.class_name), p.points) for p in annotation.polylines
        )
    )
