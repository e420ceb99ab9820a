"""What an overlay consists of, and an annotation as arrays it is drawn from.

Positions are picture px (pixel centres are whole numbers); widths, sizes and dashes are points.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.interact.verdicts import NO_POINTS, joined

FloatArray = NDArray[np.float64]
Size = tuple[int, int]


@dataclass(frozen=True, eq=False)
class Strokes:
    """Lines of one look: (N, 4) picture px, x0 y0 x1 y1; a curve's segments follow each other."""

    segments: FloatArray
    colour: str
    width: float
    dash: tuple[float, ...] = ()
    layer: str = ""


@dataclass(frozen=True, eq=False)
class Marks:
    """Points of one look: (N, 2) picture px; shape ``dot``, ``cross``, ``ring`` or ``handle``."""

    centres: FloatArray
    shape: str
    colour: str
    size: float


@dataclass(frozen=True, eq=False)
class Labels:
    """Texts beside points: (N, 2) picture px.

    ``sign`` is a finding's severity, whose sign goes before each text (or stands alone before "");
    ``below``: on the other side of their points than texts usually are.
    """

    positions: FloatArray
    texts: tuple[str, ...]
    colour: str
    sign: str = ""
    below: bool = False


@dataclass(frozen=True, eq=False)
class Patch:
    """A filled outline, (N, 2) picture px; ``opacity`` from 0 to 1."""

    outline: FloatArray
    colour: str
    opacity: float


@dataclass(frozen=True, eq=False)
class Overlay:
    """What is painted over a picture, first to last: patches, strokes, marks, labels."""

    strokes: tuple[Strokes, ...]
    marks: tuple[Marks, ...]
    labels: tuple[Labels, ...]
    patches: tuple[Patch, ...] = ()


@dataclass(frozen=True)
class Draft:
    """A polyline being drawn, picture px; ``landing`` is where a click would be put by snapping."""

    class_name: str
    points: tuple[tuple[float, float], ...]
    cursor: tuple[float, float] | None = None
    landing: tuple[float, float] | None = None


class Drawn:
    """Polylines, picture px, as one array of points (N, 2) and one of segments (N, 4)."""

    def __init__(self, annotation: FrameAnnotation, picture_size: Size) -> None:
        flat: list[float] = []
        self._bounds: dict[str, tuple[int, int]] = {}
        for polyline in annotation.polylines:
            if polyline.points:
                begin = len(flat) // 2
                for point in polyline.points:
                    flat += point[:2]
                self._bounds[polyline.class_name] = begin, len(flat) // 2
        self._points = np.array(flat, dtype=np.float64).reshape(-1, 2)
        self._points *= (picture_size[0] - 1, picture_size[1] - 1)
        # Also between polylines; those are left out when a class's own are cut from it.
        self._segments = np.concatenate((self._points[:-1], self._points[1:]), axis=1)

    @property
    def all_points(self) -> FloatArray:
        return self._points

    @property
    def all_segments(self) -> FloatArray:
        return joined([self.segments(name) for name in self._bounds])

    def __contains__(self, class_name: object) -> bool:
        return class_name in self._bounds

    def names(self) -> Iterable[str]:
        return self._bounds

    def points(self, class_name: str | None) -> FloatArray:
        begin, end = self._bounds.get(class_name or "", (0, 0))
        return self._points[begin:end]

    def segments(self, class_name: str | None) -> FloatArray:
        begin, end = self._bounds.get(class_name or "", (0, 1))
        return self._segments[begin : end - 1]

    def point(self, which: tuple[str, int] | None) -> FloatArray:
        if which is None:
            return NO_POINTS
        return self.points(which[0])[which[1] : which[1] + 1]


def joined_points(parts: list[FloatArray]) -> FloatArray:
    """Arrays of points as one, (N, 2)."""
    return np.concatenate(parts) if parts else NO_POINTS
