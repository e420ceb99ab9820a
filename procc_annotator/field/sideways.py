"""Shapes moved sideways in their plane: borders and the middle of paint lie so beside a line."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.geometry import (
    Arc,
    Chain,
    Geometry,
    Line,
    Part,
    Spot,
    Vector,
    ends_of,
    is_closed,
    parts_of,
    vector_of,
)

FloatArray = NDArray[np.float64]

_SAME_CORNER_M = 1e-6


def offset_parts(geometry: Geometry, normal: FloatArray, offset: float) -> list[Part | None]:
    """The parts of a geometry, moved in their plane; corners of a chain stay corners.

    Args:
        geometry: in a plane.
        normal: (3,) unit normal of that plane.
        offset: metres, to the side of ``normal x direction``.

    Returns:
        None for a part of which nothing is left: an arc moved beyond its centre, a spot.
    """
    parts = [_offset_part(part, normal, offset) for part in parts_of(geometry)]
    if isinstance(geometry, Chain):
        joints = list(pairwise(range(len(parts))))
        if is_closed(geometry):
            joints.append((len(parts) - 1, 0))
        for before, after in joints:
            one, other = parts[before], parts[after]
            if not (isinstance(one, Line | Arc) and isinstance(other, Line | Arc)):
                continue
            corner = extended_corner((one, True), (other, False))
            if corner is not None:
                parts[before] = with_end_at(one, True, corner)
                parts[after] = with_end_at(other, False, corner)
    return parts


def extended_corner(one: tuple[Line | Arc, bool], other: tuple[Line | Arc, bool]) -> Vector | None:
    """Where an end of one shape and an end of another would meet if they went on as they run.

    Args:
        one: with whether its last end is meant, else its first.
        other: the same of a shape in the same plane.

    Returns:
        Metres; None where the ends are together, where two lines go on straight, where a line
        passes an arc by, and for two arcs.
    """
    (first, first_last), (second, second_last) = one, other
    here, there = _end_point(first, first_last), _end_point(second, second_last)
    if math.dist(here, there) < _SAME_CORNER_M:
        return None
    if isinstance(first, Line) and isinstance(second, Line):
        return _intersection(first, second)
    if isinstance(first, Line) and isinstance(second, Arc):
        return _line_arc_intersection(first, second, there)
    if isinstance(first, Arc) and isinstance(second, Line):
        return _line_arc_intersection(second, first, here)
    return None


def with_end_at(part: Line | Arc, last: bool, place: Vector) -> Line | Arc:
    """A line or an arc that ends at another place of its course.

    Args:
        part: any.
        last: whether it is its last end, else its first.
        place: metres.
    """
    if isinstance(part, Line):
        return Line(part.start, place) if last else Line(place, part.end)
    out = np.array(place) - part.centre
    angle = math.atan2(float(out @ part.aside), float(out @ part.ahead))
    before = part.end_rad if last else part.start_rad
    angle = before + math.remainder(angle - before, 2 * math.pi)
    return replace(part, end_rad=angle) if last else replace(part, start_rad=angle)


def _end_point(part: Line | Arc, last: bool) -> Vector:
    ends = ends_of(part)
    if ends is None:
        raise TypeError("a full turn has no ends")
    return ends[last]


def _offset_part(part: Part, normal: FloatArray, offset: float) -> Part | None:
    if isinstance(part, Spot):
        return None
    if isinstance(part, Line):
        start, end = np.array(part.start), np.array(part.end)
        aside = np.cross(normal, end - start)
        shift = offset * aside / np.linalg.norm(aside)
        return Line(vector_of(start + shift), vector_of(end + shift))
    # Walked from ahead towards aside, the left of a curve is its centre if the plane is not turned.
    turned = float(np.cross(part.ahead, part.aside) @ normal)
    radius = part.radius - math.copysign(offset, offset * turned)
    return replace(part, radius=radius) if radius > 0 else None


def _intersection(one: Line, other: Line) -> Vector | None:
    start, begin = np.array(one.start), np.array(other.start)
    along, way = np.array(one.end) - start, np.array(other.end) - begin
    shares, _, rank, _ = np.linalg.lstsq(np.stack([along, -way], axis=1), begin - start, rcond=1e-6)
    if rank < 2:  # one goes on straight where the other ends
        return None
    return vector_of(start + shares[0] * along)


def _line_arc_intersection(line: Line, arc: Arc, near: Vector) -> Vector | None:
    """Where a line crosses the circle of an arc, near a place."""
    start, centre = np.array(line.start), np.array(arc.centre)
    way = np.array(line.end) - start
    way /= np.linalg.norm(way)
    foot = start + ((centre - start) @ way) * way
    left = arc.radius**2 - float((foot - centre) @ (foot - centre))
    if left < 0:
        return None
    both = (foot + side * math.sqrt(left) * way for side in (-1, 1))
    return vector_of(min(both, key=lambda place: math.dist(place, near)))
