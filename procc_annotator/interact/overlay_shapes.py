"""What an overlay consists of, and an annotation as arrays it is drawn from.

Positions are picture px (pixel centres are whole numbers); widths, sizes and dashes are points.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.interact.verdicts import NO_POINTS, joined

FloatArray = NDArray[np.float64]
Size = tuple[int, int]
Box = tuple[float, float, float, float]  # left, top, right, bottom, picture px

_FEW = 60  # numbers, which are compared sooner one by one


@dataclass(frozen=True, eq=False)
class Strokes:
    """Lines of one look: (N, 4) picture px, x0 y0 x1 y1; a curve's segments follow each other."""

    segments: FloatArray
    colour: str
    width: float
    dash: tuple[float, ...] = ()
    layer: str = ""

    @cached_property
    def box(self) -> Box | None:
        """What the lines reach over, without their width; None where there are none."""
        return _box_of(self.segments)


@dataclass(frozen=True, eq=False)
class PointMarks:
    """Points of one look: (N, 2) picture px; shape ``dot``, ``cross``, ``ring`` or ``handle``."""

    centres: FloatArray
    shape: str
    colour: str
    size: float

    @cached_property
    def box(self) -> Box | None:
        """What the points reach over; None where there are none."""
        return _box_of(self.centres)


Snap = Literal["off", "none", "found", ""]
"""Whether the next click is put on a line: not wanted, no line there, on one; or nothing to say."""


@dataclass(frozen=True, slots=True)
class CursorSigns:
    """Signs at the cursor: the colour of the class that is drawn, and what snapping does."""

    colour: str
    snap: Snap


@dataclass(frozen=True, slots=True)
class DraftState:
    """How far what is drawn has come: its points, how many are missing until it is whole, and what
    snapping does with the next one."""

    points: int = 0
    missing: int = 0
    snap: Snap = ""


NO_DRAFT_STATE = DraftState()


@dataclass(frozen=True, eq=False)
class Labels:
    """Texts beside points: (N, 2) picture px.

    ``sign`` is a finding's severity, whose sign goes before each text (or stands alone before "");
    ``below``: on the other side of their points than texts usually are. ``hand``: what stands
    beside the text at the cursor. ``carried``: at the cursor; others need not give way.
    """

    positions: FloatArray
    texts: tuple[str, ...]
    colour: str
    sign: str = ""
    below: bool = False
    hand: CursorSigns | None = None
    carried: bool = False


@dataclass(frozen=True, eq=False)
class FilledArea:
    """A filled outline, (N, 2) picture px; ``opacity`` from 0 to 1."""

    outline: FloatArray
    colour: str
    opacity: float


@dataclass(frozen=True, eq=False)
class Overlay:
    """What is painted over a picture, first to last: patches, strokes, marks, labels."""

    strokes: tuple[Strokes, ...]
    marks: tuple[PointMarks, ...]
    labels: tuple[Labels, ...]
    patches: tuple[FilledArea, ...] = ()

    @cached_property
    def seen_strokes(self) -> tuple[Strokes, ...]:
        """Those that are not empty."""
        return tuple([s for s in self.strokes if s.box is not None])

    @cached_property
    def seen_marks(self) -> tuple[PointMarks, ...]:
        """Those that are not empty."""
        return tuple([m for m in self.marks if m.box is not None])


EMPTY_OVERLAY = Overlay((), (), ())


@dataclass(frozen=True)
class Draft:
    """A polyline being drawn, picture px; ``landing`` is where a click would be put by snapping."""

    class_name: str
    points: tuple[tuple[float, float], ...]
    cursor: tuple[float, float] | None = None
    landing: tuple[float, float] | None = None
    hand: DraftState = NO_DRAFT_STATE


@dataclass(frozen=True, eq=False)
class DrawnLine:
    """One polyline, picture px: points (N, 2) and segments (N - 1, 4)."""

    polyline: Polyline | None
    points: FloatArray

    @cached_property
    def segments(self) -> FloatArray:
        return np.concatenate((self.points[:-1], self.points[1:]), axis=1)


NO_LINE = DrawnLine(None, NO_POINTS)


class Drawn:
    """Polylines, picture px, by their classes; ``before`` lends those that are the very same."""

    def __init__(
        self, annotation: FrameAnnotation, picture_size: Size, before: Drawn | None = None
    ) -> None:
        self._size = picture_size
        known = before._lines if before is not None and before._size == picture_size else {}
        self._lines: dict[str, DrawnLine] = {}
        for polyline in annotation.polylines:
            if polyline.points:
                line = known.get(polyline.class_name, NO_LINE)
                if line.polyline is not polyline:
                    line = _drawn_line(polyline, picture_size)
                self._lines[polyline.class_name] = line

    @property
    def all_points(self) -> FloatArray:
        return joined_points([line.points for line in self._lines.values()])

    @property
    def all_segments(self) -> FloatArray:
        return joined([line.segments for line in self._lines.values()])

    def __contains__(self, class_name: object) -> bool:
        return class_name in self._lines

    def names(self) -> Iterable[str]:
        return self._lines

    def line(self, class_name: str | None) -> DrawnLine:
        return self._lines.get(class_name or "", NO_LINE)

    def points(self, class_name: str | None) -> FloatArray:
        return self.line(class_name).points

    def segments(self, class_name: str | None) -> FloatArray:
        return self.line(class_name).segments

    def point(self, which: tuple[str, int] | None) -> FloatArray:
        if which is None:
            return NO_POINTS
        return self.points(which[0])[which[1] : which[1] + 1]


def _drawn_line(polyline: Polyline, size: Size) -> DrawnLine:
    points = np.array([point[:2] for point in polyline.points], dtype=np.float64)
    return DrawnLine(polyline, points * (size[0] - 1, size[1] - 1))


def _box_of(places: FloatArray) -> Box | None:
    """What (N, 2) points or the ends of (N, 4) lines reach over; None where there are none."""
    if not places.size:
        return None
    if places.size <= _FEW and math.isfinite(sum(flat := places.ravel().tolist())):
        across, down = flat[::2], flat[1::2]
        return min(across), min(down), max(across), max(down)
    points = places.reshape(-1, 2)
    left, top = points.min(axis=0).tolist()
    right, bottom = points.max(axis=0).tolist()
    return left, top, right, bottom


def joined_points(parts: list[FloatArray]) -> FloatArray:
    """Arrays of points as one, (N, 2)."""
    return np.concatenate(parts) if parts else NO_POINTS
