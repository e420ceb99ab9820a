"""What was clicked: the polylines of one frame, exactly as they were read.

Coordinates are normalised as in SoccerNet files: ``pixel = u * (W - 1)``. They are never rounded,
clamped or reordered here, so that an untouched element is written back with identical numbers.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, SupportsFloat

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.errors import UsageError

# No one clicks so far from the picture, in its widths and heights.
_FARTHEST = 2.0


class Point(NamedTuple):
    """One clicked point, normalised; ``extra`` keeps keys of the file that we do not know."""

    u: float
    v: float
    extra: tuple[tuple[str, Any], ...] = ()


@dataclass(frozen=True, slots=True)
class Polyline:
    """The points clicked along one element; the list may be empty (the class counts as absent)."""

    class_name: str
    points: tuple[Point, ...]

    def __hash__(self) -> int:
        """Of class and places: further keys of a file may hold lists."""
        return hash((self.class_name, tuple(point[:2] for point in self.points)))


@dataclass(frozen=True, slots=True)
class FrameAnnotation:
    """All polylines of one frame, in file order, at most one a class.

    ``extra`` holds top-level entries of the file that are not lists of points; they are written
    back. ``unconfirmed`` holds elements that the program put here (copied from another frame) and
    no person has touched or confirmed yet: they are shown, but never counted, scored or written. A
    class stands in one of the two lists only.
    """

    polylines: tuple[Polyline, ...] = ()
    extra: tuple[tuple[str, Any], ...] = field(default=())
    unconfirmed: tuple[Polyline, ...] = ()

    @classmethod
    def from_dict(
        cls,
        elements: Mapping[str, Iterable[Mapping[str, Any] | Iterable[SupportsFloat]]],
        *,
        size: tuple[int, int] | None = None,
    ) -> FrameAnnotation:
        """An annotation from plain values.

        Args:
            elements: class name -> its points in order along the element, each ``(u, v)`` or
                ``{"x": u, "y": v}``; further keys of a point are kept. Arrays (n, 2) will do.
            size: (width, height) px of the picture that the points are pixels of (pixel centres
                are whole numbers); None where they are normalised, as in files.

        Raises:
            UsageError: what is given is none of this, no finite number, a class twice (spaces at
                the ends of names do not count), or no size.
        """
        size = None if size is None else as_size(size)
        return cls(
            tuple(
                Polyline(str(name), _points_of(str(name), points, size))
                for name, points in _by_class(elements)
            )
        )

    def to_dict(self, *, size: tuple[int, int] | None = None) -> dict[str, list[dict[str, Any]]]:
        """The elements as plain values, as a SoccerNet file has them; unconfirmed ones are none.

        Args:
            size: (width, height) px of the picture, for points in its pixels; None for normalised
                ones.

        Returns:
            Class name -> its points, each ``{"x": u, "y": v}`` with its further keys.

        Raises:
            UsageError: it is no size.
        """
        width, height = (2, 2) if size is None else as_size(size)
        right, low = width - 1, height - 1
        return {
            polyline.class_name: [
                {"x": u * right, "y": v * low, **dict(extra)} for u, v, extra in polyline.points
            ]
            for polyline in self.polylines
        }

    def __iter__(self) -> Iterator[Polyline]:
        return iter(self.polylines)

    def get(self, class_name: str) -> Polyline | None:
        """The polyline of a class, or None."""
        for polyline in self.polylines:
            if polyline.class_name == class_name:
                return polyline
        return None

    def get_unconfirmed(self, class_name: str) -> Polyline | None:
        """The unconfirmed polyline of a class, or None."""
        for polyline in self.unconfirmed:
            if polyline.class_name == class_name:
                return polyline
        return None

    def same_content(self, other: FrameAnnotation) -> bool:
        """Whether both would be written as the same file: unconfirmed elements do not count."""
        return self.polylines == other.polylines and self.extra == other.extra

    @property
    def annotated(self) -> tuple[str, ...]:
        """Names of the classes that have at least one point, in file order."""
        return tuple(p.class_name for p in self.polylines if p.points)

    def with_polyline(self, polyline: Polyline) -> FrameAnnotation:
        """This annotation with a class's polyline replaced in place, or appended when it is new.

        An unconfirmed polyline of the class goes: a person has now decided where the element is.
        """
        name = polyline.class_name
        kept = tuple(polyline if p.class_name == name else p for p in self.polylines)
        if self.get(name) is None:
            kept = (*kept, polyline)
        return replace(self, polylines=kept, unconfirmed=_other_classes(self.unconfirmed, name))

    def renamed(self, name_of: Callable[[str], str]) -> FrameAnnotation:
        """This annotation with other spellings of its classes; the very same where none changes.

        A class whose new name another one bears already stays as it is.
        """
        every = (*self.polylines, *self.unconfirmed)
        taken = {p.class_name for p in every}
        names = {name: name_of(name) for name in taken}
        names = {a: b for a, b in names.items() if a != b and b not in taken}
        if not names:
            return self

        def named(polylines: tuple[Polyline, ...]) -> tuple[Polyline, ...]:
            return tuple(
                Polyline(names.get(p.class_name, p.class_name), p.points) for p in polylines
            )

        return replace(self, polylines=named(self.polylines), unconfirmed=named(self.unconfirmed))

    def without(self, class_name: str) -> FrameAnnotation:
        """This annotation without a class, confirmed or not."""
        return replace(
            self,
            polylines=_other_classes(self.polylines, class_name),
            unconfirmed=_other_classes(self.unconfirmed, class_name),
        )


def _by_class(elements: object) -> Iterable[tuple[object, object]]:
    if not isinstance(elements, Mapping):
        raise UsageError(f"expected points by class name, found {type(elements).__name__}")
    known: dict[str, object] = {}
    for name in elements:
        other = known.setdefault(str(name).strip(), name)
        if other is not name:
            raise UsageError(
                f"{other!r} and {name!r} are the same class: its points belong together"
            )
    return elements.items()


def _points_of(name: str, points: object, size: tuple[int, int] | None) -> tuple[Point, ...]:
    if not isinstance(points, Iterable) or isinstance(points, str | Mapping):
        raise UsageError(f"{name}: expected a list of points, found {type(points).__name__}")
    return tuple(_point_of(f"{name}[{i}]", point, size) for i, point in enumerate(points))


def _point_of(place: str, point: object, size: tuple[int, int] | None) -> Point:
    extra: dict[str, Any] = {}
    try:
        if isinstance(point, Mapping):
            extra = dict(point)
            x, y = float(extra.pop("x")), float(extra.pop("y"))
        else:
            x, y = (float(value) for value in point)  # type: ignore[attr-defined]
    except (TypeError, ValueError, KeyError):
        raise UsageError(
            f'{place}: expected a point as (x, y) or {{"x": x, "y": y}}, found {point!r}'
        ) from None
    if not (math.isfinite(x) and math.isfinite(y)):
        raise UsageError(f"{place}: expected finite numbers, found ({x}, {y})")
    found = Point(x, y) if size is None else point_from_px(x, y, size)
    return found._replace(extra=tuple(extra.items()))


def _other_classes(polylines: tuple[Polyline, ...], class_name: str) -> tuple[Polyline, ...]:
    return tuple(p for p in polylines if p.class_name != class_name)


def pixel_like(annotation: FrameAnnotation) -> Point | None:
    """A point that shows that coordinates are pixels, where most of them are far beyond any picture
    (some outside of it are in order): the first such point. None for normalised coordinates."""
    points = [point for polyline in annotation.polylines for point in polyline.points]
    beyond = [p for p in points if max(abs(p.u), abs(p.v)) > _FARTHEST]
    coordinates = sum((abs(p.u) > _FARTHEST) + (abs(p.v) > _FARTHEST) for p in beyond)
    return beyond[0] if coordinates > len(points) else None  # of two each


def as_size(size: Any) -> tuple[int, int]:
    """(width, height) px of a picture, as a caller gave it.

    Raises:
        UsageError: it is none, or has no two pixels each way, between which points would lie.
    """
    try:
        width, height = map(operator.index, size)
    except (TypeError, ValueError):  # no whole numbers, or not two of them
        raise UsageError(
            f"expected a size as (width, height) in whole pixels, found {size!r}"
        ) from None
    if min(width, height) < 2:
        raise UsageError(f"the size {width}x{height} is too small")
    return width, height


def points_px(polyline: Polyline, size: tuple[int, int]) -> FloatArray:
    """A polyline in pixels of a picture.

    Args:
        polyline: n points.
        size: (width, height) in px; u = 1 is the centre of the last column, ``u * (width - 1)``.

    Returns:
        (n, 2) float64, px, origin at the centre of the top left pixel.
    """
    uv = np.array([(p.u, p.v) for p in polyline.points], dtype=np.float64).reshape(-1, 2)
    return uv * (size[0] - 1, size[1] - 1)


def point_from_px(x: float, y: float, size: tuple[int, int]) -> Point:
    """The normalised point of a pixel position; the inverse of `points_px`."""
    return Point(float(x) / (size[0] - 1), float(y) / (size[1] - 1))
