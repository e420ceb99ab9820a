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
from procc_annotator.field.geometry import is_closed
from procc_annotator.field.model import Field
from procc_annotator.field.neighbours import touching_elements
from procc_annotator.fit.line_ends import ImageSize, expected_line_end

FloatArray = NDArray[np.float64]

REACH_PX = 25.0


def close_gaps(
    polyline: Polyline,
    annotation: FrameAnnotation,
    field: Field,
    size: ImageSize,
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
    if is_closed(element.geometry):
        if len(points) > 4 and 0 < np.hypot(*(points[-1] - points[0])) <= reach_px:
            return Polyline(polyline.class_name, (*polyline.points, polyline.points[0]))
        return polyline
    if not element.is_straight:
        return polyline
    lines = [
        points_px(other, size)
        for name in touching_elements(field, polyline.class_name)
        if (other := annotation.get(name)) is not None
        and len(other.points) >= 2
        and (neighbour := field.element(name)) is not None
        and neighbour.is_straight
    ]
    first = expected_line_end(points[0], points[1], lines, size, reach_px)
    last = expected_line_end(points[-1], points[-2], lines, size, reach_px)
    return Polyline(
        polyline.class_name,
        (
            _replaced(polyline.points[0], first, size),
            *polyline.points[1:-1],
            _replaced(polyline.points[-1], last, size),
        ),
    )


def _replaced(point: Point, place: FloatArray | None, size: ImageSize) -> Point:
    if place is None:
        return point
    moved = point_from_px(float(place[0]), float(place[1]), size)
    return Point(moved.u, moved.v, point.extra)
