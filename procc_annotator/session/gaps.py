"""Close the small gaps a hand leaves: at the picture's edges, at corners, around circles."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import (
    FrameAnnotation,
    Point,
    Polyline,
    point_from_px,
    points_px,
)
from procc_annotator.field.model import Circle, Field
from procc_annotator.field.neighbours import meeting

FloatArray = NDArray[np.float64]
Size = tuple[int, int]

REACH_PX = 25.0


def close_gaps(
    polyline: Polyline,
    annotation: FrameAnnotation,
    field: Field,
    size: Size,
    reach_px: float = REACH_PX,
) -> Polyline:
    """An element whose ends reach what they fall short of; the same polyline when nothing is near.

    An end of a straight element is moved along its line, by at most ``reach_px``: to where it meets
    the line of an annotated straight element that it meets on the field, else to the picture's
    edge. A circle whose ends are that near is closed with its first point. Points between the ends
    stay.

    Args:
        polyline: of a class of the field; others come back unchanged.
        annotation: with the neighbours.
        field: knows which elements meet.
        size: (width, height) of the picture, px.
        reach_px: how far an end may be moved.
    """
    element = field.element(polyline.class_name)
    if element is None or len(polyline.points) < 2:
        return polyline
    points = points_px(polyline, size)
    if isinstance(element.geometry, Circle):
        if len(points) > 4 and 0 < np.hypot(*(points[-1] - points[0])) <= reach_px:
            return Polyline(polyline.class_name, (*polyline.points, polyline.points[0]))
        return polyline
    if not element.is_straight:
        return polyline
    lines = [
        points_px(other, size)
        for name in meeting(field, polyline.class_name)
        if (other := annotation.get(name)) is not None
        and len(other.points) >= 2
        and (neighbour := field.element(name)) is not None
        and neighbour.is_straight
    ]
    first = _moved_end(points[0], points[1], lines, size, reach_px)
    last = _moved_end(points[-1], points[-2], lines, size, reach_px)
    return Polyline(
        polyline.class_name,
        (
            _replaced(polyline.points[0], first, size),
            *polyline.points[1:-1],
            _replaced(polyline.points[-1], last, size),
        ),
    )


def _moved_end(
    end: FloatArray, inner: FloatArray, lines: list[FloatArray], size: Size, reach_px: float
) -> FloatArray | None:
    """Where an end belongs, px; None where nothing is within reach."""
    along = end - inner
    length = float(np.hypot(*along))
    if length < 1e-6:
        return None
    along = along / length
    corners = [corner for line in lines if (corner := _meeting_point(end, along, line)) is not None]
    near = [c for c in corners if np.hypot(*(c - end)) <= reach_px]
    if near:
        return min(near, key=lambda c: float(np.hypot(*(c - end))))
    edge = _edge_point(end, along, size)
    return edge if edge is not None and np.hypot(*(edge - end)) <= reach_px else None


def _meeting_point(end: FloatArray, along: FloatArray, line: FloatArray) -> FloatArray | None:
    """Where the ray's line meets the end segment of another polyline that is nearer, px."""
    first = np.hypot(*(line[0] - end)) <= np.hypot(*(line[-1] - end))
    begin, other = (line[0], line[1]) if first else (line[-1], line[-2])
    across = other - begin
    determinant = along[0] * -across[1] + along[1] * across[0]
    # Lines at less than about six degrees have no corner that two clicks could tell.
    if abs(determinant) < 0.1 * float(np.hypot(*across)):
        return None
    offset = begin - end
    distance = (offset[0] * -across[1] + offset[1] * across[0]) / determinant
    found: FloatArray = end + distance * along
    return found


def _edge_point(end: FloatArray, along: FloatArray, size: Size) -> FloatArray | None:
    """Where the ray from an end inside the picture leaves it, px."""
    limits = np.array(size, dtype=np.float64) - 1
    if (end < 0).any() or (end > limits).any():
        return None
    with np.errstate(divide="ignore"):
        steps = np.where(
            along > 0, (limits - end) / along, np.where(along < 0, -end / along, np.inf)
        )
    found: FloatArray = end + float(steps.min()) * along
    return np.clip(found, 0.0, limits)


def _replaced(point: Point, place: FloatArray | None, size: Size) -> Point:
    if place is None:
        return point
    moved = point_from_px(float(place[0]), float(place[1]), size)
    return Point(moved.u, moved.v, point.extra)
