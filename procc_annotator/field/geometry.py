"""Element shapes: lines, arcs, circles, chains, spots; measuring, rotating and offsetting them."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from procc_annotator.arrays import FloatArray

Vector = tuple[float, float, float]
Covariance = tuple[Vector, Vector, Vector]  # of a place, (3, 3) m^2

SAME_PLACE_M = 1e-6
_OUTLINE_SAMPLES = 9


@dataclass(frozen=True, slots=True)
class Line:
    """A straight segment; points in metres, world frame."""

    start: Vector
    end: Vector


@dataclass(frozen=True, slots=True)
class Arc:
    """An arc from ``start_rad`` increasing to ``end_rad``; ``ahead``, ``aside``: unit vectors."""

    centre: Vector
    radius: float
    start_rad: float
    end_rad: float
    ahead: Vector = (1.0, 0.0, 0.0)
    aside: Vector = (0.0, 1.0, 0.0)


@dataclass(frozen=True, slots=True)
class Circle:
    """A circle, sampled from ``ahead`` towards ``aside``, which are unit vectors."""

    centre: Vector
    radius: float
    ahead: Vector = (1.0, 0.0, 0.0)
    aside: Vector = (0.0, 1.0, 0.0)


@dataclass(frozen=True, slots=True)
class Chain:
    """Lines and arcs joined end to end: a free-throw area's border, a net that sags."""

    parts: tuple[Line | Arc, ...]


@dataclass(frozen=True, slots=True)
class Spot:
    """A single place: a penalty mark, the foot of a corner flag, a landmark."""

    position: Vector


Geometry = Line | Arc | Circle | Chain | Spot
Part = Line | Arc | Circle | Spot


def vector_of(values: Iterable[float]) -> Vector:
    """Three numbers of a list or an array as plain ones, none of them a negative zero."""
    x, y, z = (float(value) + 0.0 for value in values)
    return x, y, z


def parts_of(geometry: Geometry) -> tuple[Part, ...]:
    """The simple shapes a geometry is made of: those of a chain, else itself."""
    return geometry.parts if isinstance(geometry, Chain) else (geometry,)


def angles_of(curve: Arc | Circle) -> tuple[float, float]:
    """First and last angle, rad; a full turn for a circle."""
    return (curve.start_rad, curve.end_rad) if isinstance(curve, Arc) else (0.0, 2 * math.pi)


def points_at_angles(curve: Arc | Circle, angles: FloatArray) -> FloatArray:
    """(n, 3) metres: the places of a curve at angles (n,), rad."""
    along = np.cos(angles)[:, None] * np.array(curve.ahead)
    along += np.sin(angles)[:, None] * np.array(curve.aside)
    return np.asarray(np.array(curve.centre) + curve.radius * along)


def ends_of(geometry: Geometry) -> tuple[Vector, Vector] | None:
    """Both ends, metres, the first one first; None where there are none: circles, closed chains."""
    if isinstance(geometry, Circle):
        return None
    if isinstance(geometry, Spot):
        return geometry.position, geometry.position
    if isinstance(geometry, Line):
        return geometry.start, geometry.end
    if isinstance(geometry, Arc):
        both = points_at_angles(geometry, np.array(angles_of(geometry))).tolist()
        return vector_of(both[0]), vector_of(both[1])
    first, last = ends_of(geometry.parts[0]), ends_of(geometry.parts[-1])
    if first is None or last is None or math.dist(first[0], last[1]) < SAME_PLACE_M:
        return None
    return first[0], last[1]


def is_closed(geometry: Geometry) -> bool:
    """Return whether a geometry comes back to where it began."""
    return ends_of(geometry) is None


def length_of(geometry: Geometry) -> float:
    """Metres along it; 0 for a spot."""
    total = 0.0
    for part in parts_of(geometry):
        if isinstance(part, Line):
            total += math.dist(part.start, part.end)
        elif isinstance(part, Arc | Circle):
            first, last = angles_of(part)
            total += (last - first) * part.radius
    return total


def outline_of(geometry: Geometry) -> FloatArray:
    """(n, 3) metres: some places along it, its ends and the joints of a chain among them."""
    found = []
    for part in parts_of(geometry):
        if isinstance(part, Line):
            found.append(np.array([part.start, part.end]))
        elif isinstance(part, Spot):
            found.append(np.array([part.position]))
        else:
            first, last = angles_of(part)
            count = _OUTLINE_SAMPLES if isinstance(part, Arc) else 4 * _OUTLINE_SAMPLES
            found.append(points_at_angles(part, np.linspace(first, last, count)))
    return np.concatenate(found)


def middle_of(geometry: Geometry) -> Vector:
    """Metres: the middle of a line, an arc or a chain, the centre of a circle, a spot itself."""
    if isinstance(geometry, Circle):
        return geometry.centre
    if isinstance(geometry, Spot):
        return geometry.position
    if isinstance(geometry, Line):
        return vector_of([(a + b) / 2 for a, b in zip(geometry.start, geometry.end, strict=True)])
    if isinstance(geometry, Arc):
        middle = (geometry.start_rad + geometry.end_rad) / 2
        return vector_of(points_at_angles(geometry, np.array([middle]))[0].tolist())
    half, before = length_of(geometry) / 2, 0.0
    for part in geometry.parts:
        own = length_of(part)
        if before + own >= half:
            return _point_at_share(part, (half - before) / own)
        before += own
    return ends_of(geometry.parts[-1])[1]  # type: ignore[index]  # rounding, at the very end


def is_on_ground(geometry: Geometry) -> bool:
    """Return whether all of it lies on the plane z = 0."""
    return all(_part_on_ground(part) for part in parts_of(geometry))


def rotated(geometry: Geometry, turn_rad: float) -> Geometry:
    """A geometry turned about the vertical through the field's centre, from +x towards +y."""
    if isinstance(geometry, Line):
        return Line(
            _rotated_point(geometry.start, turn_rad), _rotated_point(geometry.end, turn_rad)
        )
    if isinstance(geometry, Spot):
        return Spot(_rotated_point(geometry.position, turn_rad))
    if isinstance(geometry, Chain):
        parts = tuple(rotated(part, turn_rad) for part in geometry.parts)
        return Chain(tuple(p for p in parts if isinstance(p, Line | Arc)))
    centre = _rotated_point(geometry.centre, turn_rad)
    ahead, aside = (
        _rotated_point(geometry.ahead, turn_rad),
        _rotated_point(geometry.aside, turn_rad),
    )
    if isinstance(geometry, Circle):
        return Circle(centre, geometry.radius, ahead, aside)
    return Arc(centre, geometry.radius, geometry.start_rad, geometry.end_rad, ahead, aside)


def same_geometry(one: Geometry, other: Geometry, within_m: float = SAME_PLACE_M) -> bool:
    """Return whether two geometries are the same set of points, whichever way each one is
    walked."""
    if isinstance(one, Circle) and isinstance(other, Circle):
        apart = math.dist(one.centre, other.centre)
        normals = np.cross(one.ahead, one.aside), np.cross(other.ahead, other.aside)
        return (
            apart < within_m
            and abs(one.radius - other.radius) < within_m
            and abs(abs(float(normals[0] @ normals[1])) - 1) < SAME_PLACE_M
        )
    if type(one) is not type(other):
        return False
    if isinstance(one, Chain) and isinstance(other, Chain):
        if len(one.parts) != len(other.parts):
            return False
        # A closed chain, such as a backboard's edge, may begin at any of its corners.
        starts = range(len(other.parts)) if is_closed(other) else range(1)
        return any(
            all(same_geometry(a, b, within_m) for a, b in zip(one.parts, way, strict=True))
            for start in starts
            for turned_round in (other.parts[start:] + other.parts[:start],)
            for way in (turned_round, turned_round[::-1])
        )
    mine, theirs = outline_of(one), outline_of(other)
    return any(np.abs(mine - way).max() < within_m for way in (theirs, theirs[::-1]))


def _part_on_ground(part: Part) -> bool:
    if isinstance(part, Line):
        return part.start[2] == 0 and part.end[2] == 0
    if isinstance(part, Spot):
        return part.position[2] == 0
    return part.centre[2] == 0 and part.ahead[2] == 0 and part.aside[2] == 0


def _point_at_share(part: Line | Arc, share: float) -> Vector:
    if isinstance(part, Line):
        ends = zip(part.start, part.end, strict=True)
        return vector_of([a + share * (b - a) for a, b in ends])
    angle = part.start_rad + share * (part.end_rad - part.start_rad)
    return vector_of(points_at_angles(part, np.array([angle]))[0].tolist())


def _rotated_point(point: Vector, turn_rad: float) -> Vector:
    # Exact for half and quarter turns, which nearly all symmetries are.
    quarters = turn_rad / (math.pi / 2)
    if abs(quarters - round(quarters)) < 1e-12:
        cosine, sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(quarters) % 4]
    else:
        cosine, sine = math.cos(turn_rad), math.sin(turn_rad)
    x, y, z = point
    return cosine * x - sine * y, sine * x + cosine * y, z


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
    """Return where an end (the last one if True) of one shape and an end of another in the same
    plane would meet, metres, if they went on as they run; None where the ends are together, where
    two lines go on straight, where a line passes an arc by, and for two arcs."""
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
    """A line or an arc with its last end, else its first, at another place of its course,
    metres."""
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
    """Return where a line crosses the circle of an arc, near a place."""
    start, centre = np.array(line.start), np.array(arc.centre)
    way = np.array(line.end) - start
    way /= np.linalg.norm(way)
    foot = start + ((centre - start) @ way) * way
    left = arc.radius**2 - float((foot - centre) @ (foot - centre))
    if left < 0:
        return None
    both = (foot + side * math.sqrt(left) * way for side in (-1, 1))
    return vector_of(min(both, key=lambda place: math.dist(place, near)))
