"""A field whose elements lie in the middle of their paint, where clicks are snapped to.

Rules measure many lines at an edge of their paint; what is clicked is its middle, half the paint's
width away.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from procc_annotator.field.geometry import (
    SAME_PLACE_M,
    Arc,
    Chain,
    Circle,
    Geometry,
    Line,
    ends_of,
)
from procc_annotator.field.model import MIDDLE_LINE, Element, Field
from procc_annotator.field.paint import marking_normal, border_offsets
from procc_annotator.field.sideways import extended_corner, with_end_at, offset_parts


def with_centred_markings(field: Field) -> Field:
    """The field with each element in the middle of its paint, if it is measured at an edge of it.

    Lines that shared an end, as at the corner of a court, end where their middles cross.
    What has no paint, or paint that lies nobody knows where, stays: spots, posts, nets. Names,
    order, symmetries and all else stay.

    Args:
        field: any; one that went through here comes back as it is.
    """
    if field.lines == MIDDLE_LINE:
        return field
    elements = [_centred_element(element) for element in field.elements]
    _rejoin_corners(field.elements, elements)
    return replace(field, elements=tuple(elements), lines=MIDDLE_LINE)


def has_off_centre_markings(field: Field) -> bool:
    """Whether it makes a difference to a field, or has made one."""
    return field.lines == MIDDLE_LINE or any(_centred_element(e) is not e for e in field.elements)


def _centred_element(element: Element) -> Element:
    """The same element if it lies there already, or if nothing tells where its paint is."""
    if element.inside is None or element.line_width <= 0 or element.is_spot:
        return element
    normal = marking_normal(element)
    if normal is None:
        return element
    (border,) = border_offsets(element, normal)
    parts = offset_parts(element.geometry, normal, border / 2)
    geometry = _join_parts(element.geometry, [p for p in parts if isinstance(p, Line | Arc | Circle)])
    if geometry is None:
        return element
    return replace(element, geometry=geometry, inside=None)


def _join_parts(geometry: Geometry, parts: Sequence[Line | Arc | Circle]) -> Geometry | None:
    """Moved parts as one geometry; None where one of them is gone."""
    if not isinstance(geometry, Chain):
        return parts[0] if parts else None
    kept = tuple(part for part in parts if isinstance(part, Line | Arc))
    return Chain(kept) if len(kept) == len(geometry.parts) else None


def _rejoin_corners(before: Sequence[Element], moved: list[Element]) -> None:
    """Let lines and arcs of the ground that were moved and shared an end, share one again."""
    ended = {
        i: (ends, now.geometry)
        for i, (was, now) in enumerate(zip(before, moved, strict=True))
        if isinstance(now.geometry, Line | Arc) and was is not now and was.on_ground
        if (ends := ends_of(was.geometry)) is not None
    }
    for i, (own_ends, own) in ended.items():
        course = own
        for last, end in enumerate(own_ends):
            corners = (
                extended_corner((own, bool(last)), (other, bool(other_last)))
                for j, (other_ends, other) in ended.items()
                if i != j
                for other_last, other_end in enumerate(other_ends)
                if math.dist(end, other_end) < SAME_PLACE_M
            )
            if (corner := next(filter(None, corners), None)) is not None:
                course = with_end_at(course, bool(last), corner)
        moved[i] = replace(moved[i], geometry=course)
