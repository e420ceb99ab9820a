"""Line markings as painted bands: their borders, and elements moved to the middle of the band."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.field.geometry import (
    SAME_PLACE_M,
    Arc,
    Chain,
    Circle,
    Geometry,
    Line,
    Part,
    Spot,
    ends_of,
    extended_corner,
    length_of,
    offset_parts,
    outline_of,
    parts_of,
    with_end_at,
)
from procc_annotator.field.model import MIDDLE_LINE, Element, Field

_COPLANAR_M = 1e-6
_BORDER_SEPARATOR = "\n"  # no name in a field's file has a line break


def marking_field(field: Field) -> Field:
    """The borders of all painted bands as a field of their own, to be projected like any other; one
    without elements where nothing is painted.

    Of a band that is measured at its middle those are two lines, half the paint's width away; of
    one that is measured at an edge the other edge. Bands lie in the plane of their element: the
    ground, or the plane of a curve. A straight line in the air has one only together with the place
    its paint lies towards. Names of the elements go through `class_of_border`.
    """
    return replace(field, elements=_border_elements(field.elements), symmetries=(), landmarks=())


def class_of_border(border: str) -> str:
    """The class that a border of `marking_field` belongs to."""
    return border.partition(_BORDER_SEPARATOR)[0]


def marking_side(element: Element) -> str:
    """``inside`` or ``outside``: where the paint lies of an element that is measured at an edge of
    it. Of a curve that is its own inside, of a straight line the field's centre lies inside. ""
    where it is measured at its middle, or where neither side is the inner one (a line through the
    centre)."""
    if element.inside is None or element.line_width <= 0:
        return ""
    if isinstance(element.geometry, Line):
        start = np.array(element.geometry.start)
        way = np.array(element.geometry.end) - start
        way /= np.linalg.norm(way)
        away = np.array(element.inside) - start, -start  # of the paint, of the field's centre
        paint, centre = (towards - (towards @ way) * way for towards in away)
        gain = -float(paint @ centre) if np.linalg.norm(centre) > _COPLANAR_M else 0.0
    else:
        border = sum(length_of(e.geometry) for e in _border_elements((element,)))
        gain = border - length_of(element.geometry)
    if abs(gain) < _COPLANAR_M:
        return ""
    return "outside" if gain > 0 else "inside"


@lru_cache(maxsize=8)
def _border_elements(elements: tuple[Element, ...]) -> tuple[Element, ...]:
    found: list[Element] = []
    for element in elements:
        if element.line_width <= 0 or element.is_spot:
            continue
        normal = marking_normal(element)
        if normal is None:
            continue
        for offset in border_offsets(element, normal):
            for part in offset_parts(element.geometry, normal, offset):
                if part is None:
                    continue
                name = f"{element.name}{_BORDER_SEPARATOR}{len(found)}"
                found.append(replace(element, name=name, geometry=part, line_width=0.0))
    return tuple(found)


def marking_normal(element: Element) -> FloatArray | None:
    """(3,) unit normal of the plane the paint lies in; None if unknown."""
    if element.on_ground:
        return np.array((0.0, 0.0, 1.0))
    geometry = element.geometry
    if isinstance(geometry, Arc | Circle):
        return np.cross(geometry.ahead, geometry.aside)
    points = outline_of(geometry)
    if element.inside is not None and isinstance(geometry, Line):
        points = np.vstack([points, element.inside])
    spread = points - points.mean(axis=0)
    _, sizes, axes = np.linalg.svd(spread, full_matrices=True)
    sizes = np.append(sizes, np.zeros(3 - len(sizes)))
    if sizes[1] < _COPLANAR_M or sizes[2] > _COPLANAR_M:
        return None  # a straight line, or one that lies in no plane
    return np.asarray(axes[2])


def border_offsets(element: Element, normal: FloatArray) -> tuple[float, ...]:
    """Return how far the borders of a painted element are from it, metres, to the side of ``normal
    x direction``: one where it is measured at an edge of its paint, else one to either side."""
    if element.inside is None:
        return element.line_width / 2, -element.line_width / 2
    place = np.array(element.inside)
    nearest = math.inf
    towards = 0.0
    for part in parts_of(element.geometry):
        begin, way = _closest_point_on_part(part, place)
        apart = float(np.linalg.norm(place - begin))
        if apart < nearest:
            nearest = apart
            towards = float(np.cross(normal, way) @ (place - begin))
    return (math.copysign(element.line_width, towards),)


def _closest_point_on_part(part: Part, place: FloatArray) -> tuple[FloatArray, FloatArray]:
    if isinstance(part, Line):
        start, end = np.array(part.start), np.array(part.end)
        way = end - start
        share = float(np.clip((place - start) @ way / (way @ way), 0, 1))
        return start + share * way, way / np.linalg.norm(way)
    if isinstance(part, Spot):
        raise TypeError("a spot has no paint")
    centre, ahead, aside = (np.array(v) for v in (part.centre, part.ahead, part.aside))
    out = place - centre
    angle = math.atan2(float(out @ aside), float(out @ ahead))
    if isinstance(part, Arc):
        angle = _clamp_angle_to_arc(angle, part)
    point = centre + part.radius * (math.cos(angle) * ahead + math.sin(angle) * aside)
    return point, -math.sin(angle) * ahead + math.cos(angle) * aside


def _clamp_angle_to_arc(angle: float, arc: Arc) -> float:
    """The angle of an arc that is nearest to an angle."""
    turned = arc.start_rad + (angle - arc.start_rad) % (2 * math.pi)
    if turned <= arc.end_rad:
        return turned
    past_end, before_start = turned - arc.end_rad, arc.start_rad + 2 * math.pi - turned
    return arc.end_rad if past_end <= before_start else arc.start_rad


def with_centred_markings(field: Field) -> Field:
    """The field with each element in the middle of its paint, if it is measured at an edge of it.

    Lines that shared an end, as at the corner of a court, end where their middles cross.
    What has no paint, or paint that lies no one knows where, stays: spots, posts, nets. Names,
    order, symmetries and all else stay; a field that went through here comes back as it is.
    """
    if field.lines == MIDDLE_LINE:
        return field
    elements = [_centred_element(element) for element in field.elements]
    _rejoin_corners(field.elements, elements)
    return replace(field, elements=tuple(elements), lines=MIDDLE_LINE)


def has_off_centre_markings(field: Field) -> bool:
    """Return whether it makes a difference to a field, or has made one."""
    return field.lines == MIDDLE_LINE or any(_centred_element(e) is not e for e in field.elements)


def _centred_element(element: Element) -> Element:
    """The same element if it lies there already, or if nothing decides where its paint is."""
    if element.inside is None or element.line_width <= 0 or element.is_spot:
        return element
    normal = marking_normal(element)
    if normal is None:
        return element
    (border,) = border_offsets(element, normal)
    parts = offset_parts(element.geometry, normal, border / 2)
    geometry = _join_parts(
        element.geometry, [p for p in parts if isinstance(p, Line | Arc | Circle)]
    )
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
