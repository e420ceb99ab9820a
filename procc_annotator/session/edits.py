"""Edits of an annotation: pure functions from one annotation to the next.

Coordinates are normalised; a polyline that loses its last point is removed with its class.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from procc_annotator.annotation import FrameAnnotation, Point, Polyline


def set_points(
    annotation: FrameAnnotation, class_name: str, points: Sequence[Point]
) -> FrameAnnotation:
    """Give a class exactly these points, in this order; none removes the class."""
    if not points:
        return annotation.without(class_name)
    return annotation.with_polyline(Polyline(class_name, tuple(points)))


def append_points(
    annotation: FrameAnnotation, class_name: str, points: Sequence[Point]
) -> FrameAnnotation:
    """Continue a class at its last point, or begin it."""
    return set_points(annotation, class_name, (*_points(annotation, class_name), *points))


def insert_point(
    annotation: FrameAnnotation, class_name: str, index: int, point: Point
) -> FrameAnnotation:
    """Put a point before the one at ``index`` (``index`` = number of points: at the end).

    Raises:
        IndexError: no such place.
    """
    points = _points(annotation, class_name)
    if not 0 <= index <= len(points):
        raise IndexError(f"{class_name!r} has {len(points)} points, cannot insert at {index}")
    return set_points(annotation, class_name, (*points[:index], point, *points[index:]))


def move_point(
    annotation: FrameAnnotation, class_name: str, index: int, point: Point
) -> FrameAnnotation:
    """Put a point elsewhere; what the file said about it besides its place stays.

    Raises:
        IndexError: no such point.
    """
    points = _points(annotation, class_name)
    old = _at(points, class_name, index)
    moved = point if point.extra else Point(point.u, point.v, old.extra)
    return set_points(annotation, class_name, (*points[:index], moved, *points[index + 1 :]))


def delete_point(annotation: FrameAnnotation, class_name: str, index: int) -> FrameAnnotation:
    """Remove a point; the last one takes the class with it.

    Raises:
        IndexError: no such point.
    """
    points = _points(annotation, class_name)
    _at(points, class_name, index)
    return set_points(annotation, class_name, (*points[:index], *points[index + 1 :]))


def delete_element(annotation: FrameAnnotation, class_name: str) -> FrameAnnotation:
    """Remove a class; nothing happens when it is not there."""
    return annotation.without(class_name)


def change_class(annotation: FrameAnnotation, old: str, new: str) -> FrameAnnotation:
    """Give a polyline another class, in place.

    Raises:
        ValueError: the new class already has points, or the old one does not exist.
    """
    if old == new:
        return annotation
    if annotation.get(old) is None:
        raise ValueError(f"{old!r} is not annotated")
    taken = annotation.get(new)
    if taken is not None and taken.points:
        raise ValueError(f"{new!r} is already annotated")
    without_empty = annotation.without(new)
    renamed = tuple(
        replace(p, class_name=new) if p.class_name == old else p for p in without_empty.polylines
    )
    return replace(without_empty, polylines=renamed)


def _points(annotation: FrameAnnotation, class_name: str) -> tuple[Point, ...]:
    polyline = annotation.get(class_name)
    return polyline.points if polyline is not None else ()


def _at(points: tuple[Point, ...], class_name: str, index: int) -> Point:
    if not 0 <= index < len(points):
        raise IndexError(f"{class_name!r} has {len(points)} points, no point {index}")
    return points[index]
