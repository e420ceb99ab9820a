"""A frame labelled top for bottom or left for right: the labels of the reflected field.

Reflecting a field twice, across and along, is half a turn, which no camera can tell: the two
reflections are one and the same mistake, seen from the two sides of the field.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.field.geometry import Circle, outline_of
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sample import FloatArray

_SAME_PLACE_M = 0.01
ALONG = (-1.0, 1.0)  # left for right
ACROSS = (1.0, -1.0)  # top for bottom


def reflected_names(field: Field, signs: tuple[float, float]) -> dict[str, str] | None:
    """The class that each class becomes when the field is reflected.

    Args:
        field: the elements.
        signs: factors of x and y: `ALONG` or `ACROSS`.

    Returns:
        None for a field that is no reflection of itself.
    """
    return _reflected(field.elements, signs)


@lru_cache(maxsize=16)
def _reflected(elements: tuple[Element, ...], signs: tuple[float, float]) -> dict[str, str] | None:
    places = [_characteristic(element) for element in elements]
    found: dict[str, str] = {}
    for element, place in zip(elements, places, strict=True):
        turned = place * (*signs, 1.0)
        twin = next(
            (
                other.name
                for other, there in zip(elements, places, strict=True)
                if type(other.geometry) is type(element.geometry) and _same(turned, there)
            ),
            None,
        )
        if twin is None:
            return None
        found[element.name] = twin
    return found


def _characteristic(element: Element) -> FloatArray:
    """(n, 3) metres: points that tell an element from others of its kind, in no order."""
    shape = element.geometry
    if isinstance(shape, Circle):
        return np.array([shape.centre, (*shape.centre[:2], shape.radius)])
    return outline_of(shape)


def _same(one: FloatArray, other: FloatArray) -> bool:
    if one.shape != other.shape:
        return False
    return any(np.abs(one - way).max() < _SAME_PLACE_M for way in (other, other[::-1]))


def renamed(annotation: FrameAnnotation, names: Mapping[str, str]) -> FrameAnnotation:
    """An annotation with classes exchanged, all at once; unconfirmed elements are dropped."""
    return FrameAnnotation(
        tuple(
            Polyline(names.get(p.class_name, p.class_name), p.points) for p in annotation.polylines
        )
    )
