"""Pure edits of an annotation, and the undo history of a frame."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import replace

from procc_annotator.annotation import FrameAnnotation, Point, Polyline

PointRef = tuple[str, int]  # a point by its class and its place in the polyline


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
    `IndexError` if there is no such place."""
    points = _points(annotation, class_name)
    if not 0 <= index <= len(points):
        raise IndexError(f"{class_name!r} has {len(points)} points, cannot insert at {index}")
    return set_points(annotation, class_name, (*points[:index], point, *points[index:]))


def move_point(
    annotation: FrameAnnotation, class_name: str, index: int, point: Point
) -> FrameAnnotation:
    """Put a point elsewhere; what the file said about it besides its place stays. `IndexError` if
    there is no such point."""
    points = _points(annotation, class_name)
    old = _at(points, class_name, index)
    moved = point if point.extra else Point(point.u, point.v, old.extra)
    return set_points(annotation, class_name, (*points[:index], moved, *points[index + 1 :]))


def delete_point(annotation: FrameAnnotation, class_name: str, index: int) -> FrameAnnotation:
    """Remove a point; the last one takes the class with it. `IndexError` if no such point."""
    return delete_points(annotation, {(class_name, index)})


def change_class(annotation: FrameAnnotation, old: str, new: str) -> FrameAnnotation:
    """Give a polyline another class, in place. `ValueError` if the new class already has points, or
    the old one does not exist."""
    if old == new:
        return annotation
    if annotation.get(old) is None:
        raise ValueError(f"{old!r} is not annotated")
    _require_free(annotation, new)
    without_empty = annotation.without(new)
    renamed = tuple(
        replace(p, class_name=new) if p.class_name == old else p for p in without_empty.polylines
    )
    return replace(without_empty, polylines=renamed)


# --- several points at once -------------------------------------------------------------------


def move_points(
    annotation: FrameAnnotation, chosen: Collection[PointRef], du: float, dv: float
) -> FrameAnnotation:
    """Shift points, of whatever classes, by a normalised distance. `IndexError` if one of the
    points does not exist."""
    for name, indices in _by_class(chosen).items():
        points = list(_points(annotation, name))
        for index in indices:
            old = _at(tuple(points), name, index)
            points[index] = Point(old.u + du, old.v + dv, old.extra)
        annotation = set_points(annotation, name, points)
    return annotation


def delete_points(annotation: FrameAnnotation, chosen: Collection[PointRef]) -> FrameAnnotation:
    """Remove points of whatever classes; a class that loses its last point goes. `IndexError` if
    one of the points does not exist."""
    for name, indices in _by_class(chosen).items():
        points = _points(annotation, name)
        for index in indices:
            _at(points, name, index)
        kept = [p for i, p in enumerate(points) if i not in indices]
        annotation = set_points(annotation, name, kept)
    return annotation


# --- whole elements ---------------------------------------------------------------------------


def reverse(annotation: FrameAnnotation, class_name: str) -> FrameAnnotation:
    """Turn the order of a class's points round."""
    return set_points(annotation, class_name, _points(annotation, class_name)[::-1])


def split(
    annotation: FrameAnnotation, class_name: str, index: int, rest_class: str
) -> FrameAnnotation:
    """Cut a polyline at one of its points; what follows becomes another class.

    The point belongs to both afterwards: where one element was drawn over two, it is their corner.

    Raises:
        IndexError: no such point, or one of the two ends, where there is nothing to cut.
        ValueError: the other class is annotated already.
    """
    points = _points(annotation, class_name)
    if not 0 < index < len(points) - 1:
        raise IndexError(f"{class_name!r} cannot be split at point {index} of {len(points)}")
    _require_free(annotation, rest_class)
    shortened = set_points(annotation, class_name, points[: index + 1])
    return set_points(shortened, rest_class, points[index:])


def merge(annotation: FrameAnnotation, source: str, target: str) -> FrameAnnotation:
    """Join a class's points to another's, at the two ends that are nearest to each other.

    The points of ``target`` keep their order; those of ``source`` are turned round where needed.

    Raises:
        ValueError: one of the two is not annotated, or they are the same.
    """
    taken, kept = _points(annotation, source), _points(annotation, target)
    if not taken or not kept or source == target:
        raise ValueError(f"cannot merge {source!r} into {target!r}: both must be annotated")
    begin, end = kept[0], kept[-1]
    ways = (
        (_apart(end, taken[0]), (*kept, *taken)),
        (_apart(end, taken[-1]), (*kept, *taken[::-1])),
        (_apart(begin, taken[-1]), (*taken, *kept)),
        (_apart(begin, taken[0]), (*taken[::-1], *kept)),
    )
    _, joined = min(ways, key=lambda way: way[0])
    without_repeats = [p for i, p in enumerate(joined) if i == 0 or p[:2] != joined[i - 1][:2]]
    return set_points(annotation.without(source), target, without_repeats)


def swap_classes(annotation: FrameAnnotation, first: str, second: str) -> FrameAnnotation:
    """Give each of two polylines the other's class; one of them may be absent. `ValueError` if
    neither is annotated."""
    names = {first: second, second: first}
    if not any(annotation.get(name) for name in names):
        raise ValueError(f"neither {first!r} nor {second!r} is annotated")
    swapped = tuple(
        replace(p, class_name=names.get(p.class_name, p.class_name)) for p in annotation.polylines
    )
    hidden = tuple(p for p in annotation.unconfirmed if p.class_name not in names)
    return replace(annotation, polylines=swapped, unconfirmed=hidden)


# --- unconfirmed elements ---------------------------------------------------------------------


def add_unconfirmed(annotation: FrameAnnotation, polylines: Iterable[Polyline]) -> FrameAnnotation:
    """Add unconfirmed elements; classes that are annotated already are left alone."""
    known = {p.class_name for p in annotation.polylines if p.points}
    proposed = [p for p in polylines if p.points and p.class_name not in known]
    names = {p.class_name for p in proposed}
    kept = tuple(p for p in annotation.unconfirmed if p.class_name not in names)
    return replace(annotation, unconfirmed=(*kept, *proposed))


def confirm(annotation: FrameAnnotation, class_name: str) -> FrameAnnotation:
    """Make an unconfirmed element an annotated one; any other class is ignored."""
    polyline = annotation.get_unconfirmed(class_name)
    return annotation if polyline is None else annotation.with_polyline(polyline)


def confirm_all(annotation: FrameAnnotation) -> FrameAnnotation:
    """Make all unconfirmed elements annotated ones."""
    for polyline in annotation.unconfirmed:
        annotation = annotation.with_polyline(polyline)
    return annotation


def drop_unconfirmed(annotation: FrameAnnotation) -> FrameAnnotation:
    """Throw all unconfirmed elements away."""
    return replace(annotation, unconfirmed=())


def _by_class(chosen: Collection[PointRef]) -> dict[str, set[int]]:
    grouped: dict[str, set[int]] = {}
    for name, index in chosen:
        grouped.setdefault(name, set()).add(index)
    return grouped


def _require_free(annotation: FrameAnnotation, class_name: str) -> None:
    taken = annotation.get(class_name)
    if taken is not None and taken.points:
        raise ValueError(f"{class_name!r} is already annotated")


def _apart(first: Point, second: Point) -> float:
    return math.hypot(first.u - second.u, first.v - second.v)


def _points(annotation: FrameAnnotation, class_name: str) -> tuple[Point, ...]:
    polyline = annotation.get(class_name)
    return polyline.points if polyline is not None else ()


def _at(points: tuple[Point, ...], class_name: str, index: int) -> Point:
    if not 0 <= index < len(points):
        raise IndexError(f"{class_name!r} has {len(points)} points, no point {index}")
    return points[index]


class History:
    """Every annotation a frame has had in this session, each with the edit that led to it.

    Snapshots share the polylines that did not change, so there is no limit to their number.
    """

    def __init__(self, initial: FrameAnnotation) -> None:
        self._steps: list[tuple[str, FrameAnnotation]] = [("", initial)]
        self._position = 0

    @property
    def current(self) -> FrameAnnotation:
        """The annotation as it is now."""
        return self._steps[self._position][1]

    @property
    def can_undo(self) -> bool:
        return self._position > 0

    @property
    def can_redo(self) -> bool:
        return self._position + 1 < len(self._steps)

    @property
    def undo_label(self) -> str | None:
        """Return what undo would take back."""
        return self._steps[self._position][0] if self.can_undo else None

    @property
    def redo_label(self) -> str | None:
        """Return what redo would do again."""
        return self._steps[self._position + 1][0] if self.can_redo else None

    def push(self, label: str, annotation: FrameAnnotation) -> bool:
        """Make an edit the newest step; steps that were undone are given up. False when the
        annotation did not change: then there is no step."""
        if annotation == self.current:
            return False
        del self._steps[self._position + 1 :]
        self._steps.append((label, annotation))
        self._position += 1
        return True

    def change_all(self, change: Callable[[FrameAnnotation], FrameAnnotation]) -> None:
        """Replace every annotation by what a function makes of it; the steps stay."""
        self._steps = [(label, change(annotation)) for label, annotation in self._steps]

    def undo(self) -> str | None:
        """Go back one step; its label, or None if absent."""
        label = self.undo_label
        if label is not None:
            self._position -= 1
        return label

    def redo(self) -> str | None:
        """Go forward one step; its label, or None if absent."""
        label = self.redo_label
        if label is not None:
            self._position += 1
        return label
