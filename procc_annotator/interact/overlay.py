"""Everything drawn over a picture, as arrays of strokes, marks and labels.

Positions are picture px (pixel centres are whole numbers); widths, sizes and dashes are points. An
overlay always has the same strokes and marks in the same order, some of them empty, so that two
overlays can be compared row by row to repaint only what differs.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.field.model import Field
from procc_annotator.interact import palette as tones
from procc_annotator.metric.measure import Measurement, nearest_points
from procc_annotator.metric.project import ProjectedField
from procc_annotator.metric.score import FrameScore

FloatArray = NDArray[np.float64]
ColourBy = Literal["criterion", "class"]
Size = tuple[int, int]

_NO_SEGMENTS: FloatArray = np.empty((0, 4))
_NO_POINTS: FloatArray = np.empty((0, 2))
_PROJECTED = ("not_annotated", "tp", "too_far")
_ANNOTATED = ("tp", "too_far", "missed")


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
    """Texts beside points: (N, 2) picture px."""

    positions: FloatArray
    texts: tuple[str, ...]
    colour: str


@dataclass(frozen=True, eq=False)
class Overlay:
    """What is painted over a picture, first to last: strokes, marks, labels."""

    strokes: tuple[Strokes, ...]
    marks: tuple[Marks, ...]
    labels: tuple[Labels, ...]


@dataclass(frozen=True)
class Draft:
    """A polyline being drawn: its points and the cursor, picture px."""

    class_name: str
    points: tuple[tuple[float, float], ...]
    cursor: tuple[float, float] | None = None


def build_overlay(
    annotation: FrameAnnotation,
    size: Size,
    field: Field,
    *,
    measurement: Measurement | None = None,
    score: FrameScore | None = None,
    picture_size: Size,
    highlight: str | None = None,
    selection: str | tuple[str, int] | None = None,
    draft: Draft | None = None,
    pointer: tuple[float, float] | None = None,
    show_projection: bool = True,
    colour_by: ColourBy = "criterion",
) -> Overlay:
    """Draw an annotation and what a camera makes of it.

    Args:
        annotation: of the frame, gestures under way included.
        size: (width, height) of the evaluation; the measurement's px belong to it.
        field: names, colours.
        measurement, score: of this annotation against a camera; None without one.
        picture_size: (width, height) of the picture on screen.
        highlight: class under the cursor here or in the field map.
        selection: selected class, or class and point.
        draft: polyline being drawn.
        pointer: cursor in picture px; it carries the highlighted class's title.
        show_projection: False hides everything that depends on the camera (blind mode).
        colour_by: ``criterion`` (needs a score) or ``class``.
    """
    judged = score is not None and measurement is not None and show_projection
    drawn = {p.class_name: points_px(p, picture_size) for p in annotation.polylines if p.points}
    selected, selected_point = _selection(selection)
    scene = _Scene(drawn, field)
    if judged and measurement is not None and score is not None:
        scene.judge(measurement, score, picture_size, selected)
    by_class = colour_by == "class" or not judged
    strokes = [
        *scene.projection_strokes(highlight),
        *_halo(drawn, scene, highlight, selected),
        *(scene.strokes_by_class() if by_class else scene.strokes_by_status()),
        Strokes(scene.whiskers_passing, tones.PASSES, 1.0, layer="whisker"),
        Strokes(scene.whiskers_failing, tones.TOO_FAR, 1.0, layer="whisker"),
        *_draft_strokes(draft, field),
    ]
    marks = [*scene.marks(by_class), *_draft_marks(draft, field)]
    marks.append(Marks(_point_of(drawn, selected_point), "ring", tones.HALO, 13.0))
    labels = (scene.labels(), _pointer_label(field, highlight, draft, pointer))
    return Overlay(tuple(strokes), tuple(marks), labels)


class _Scene:
    """The annotated polylines of a frame, sorted by what the score says of them."""

    def __init__(self, drawn: dict[str, FloatArray], field: Field) -> None:
        self.drawn = drawn
        self.field = field
        self.status: dict[str, str] = {}
        self.projected: dict[str, FloatArray] = {}
        self.projected_status: dict[str, str] = {}
        self.passing = self.failing = _NO_POINTS
        self.whiskers_passing = self.whiskers_failing = _NO_SEGMENTS
        self._label_points: list[FloatArray] = []
        self._label_texts: list[str] = []

    def judge(
        self, measurement: Measurement, score: FrameScore, size: Size, selected: str | None
    ) -> None:
        """Take over verdicts, distances and the projection."""
        self.projected = _projected_segments(measurement.projected, measurement.setup.size, size)
        factor = _factor(measurement.setup.size, size)
        feet = dict(
            zip(
                score.labelling.annotated_names,
                nearest_points(measurement, score.labelling),
                strict=True,
            )
        )
        passing, failing = [], []
        for element in score.elements:
            self.projected_status[element.name] = element.status
            points = self.drawn.get(element.annotated_name)
            if points is None:
                continue
            self.status[element.annotated_name] = element.status
            foot = feet.get(element.annotated_name)
            if foot is None or len(foot) != len(points):
                continue
            lines = np.hstack([points, foot * factor])
            # NaN, the official distance to a zero-length segment, never passes.
            passes = element.distances < score.threshold
            passing.append(lines[passes])
            failing.append(lines[~passes])
            shown = ~passes if element.annotated_name != selected else np.ones_like(passes)
            self._label_points.append(points[shown])
            self._label_texts += [f"{d:.1f}" for d in element.distances[shown]]
        self.whiskers_passing, self.whiskers_failing = _joined(passing), _joined(failing)
        self.passing = self.whiskers_passing[:, :2]
        self.failing = self.whiskers_failing[:, :2]

    def projection_strokes(self, highlight: str | None) -> Iterable[Strokes]:
        """The projected field by status, the highlighted element's underlaid."""
        under = self.projected.get(highlight, _NO_SEGMENTS) if highlight else _NO_SEGMENTS
        yield Strokes(under, tones.HALO, 3.0, layer="highlight")
        for status in _PROJECTED:
            parts = [
                segments
                for name, segments in self.projected.items()
                if self.projected_status.get(name) == status
            ]
            width = tones.PROJECTION_WIDTH * (1.5 if status == "not_annotated" else 1.0)
            yield Strokes(
                _joined(parts),
                tones.STATUS_COLOURS[status],
                width,
                tones.STATUS_DASHES[status],
                "projection",
            )

    def strokes_by_status(self) -> Iterable[Strokes]:
        """Annotated polylines in the colours of the criterion."""
        for status in _ANNOTATED:
            parts = [
                _segments(points)
                for name, points in self.drawn.items()
                if self.status.get(name) == status
            ]
            yield Strokes(
                _joined(parts),
                tones.STATUS_COLOURS[status],
                tones.ANNOTATION_WIDTH,
                tones.STATUS_DASHES[status],
                "annotation",
            )
        # A homography's elements off its plane, when they are left out, have no verdict.
        rest = [_segments(p) for name, p in self.drawn.items() if name not in self.status]
        yield Strokes(_joined(rest), tones.UNKNOWN_CLASS, tones.ANNOTATION_WIDTH, (), "annotation")

    def strokes_by_class(self) -> Iterable[Strokes]:
        """Annotated polylines in the colours of their classes."""
        for element in self.field.elements:
            points = self.drawn.get(element.name)
            segments = _segments(points) if points is not None else _NO_SEGMENTS
            yield Strokes(segments, element.colour, tones.ANNOTATION_WIDTH, (), "annotation")
        rest = [_segments(p) for name, p in self.drawn.items() if name not in self.field.index]
        yield Strokes(
            _joined(rest), tones.UNKNOWN_CLASS, tones.ANNOTATION_WIDTH, (8.0, 4.0), "annotation"
        )

    def marks(self, by_class: bool) -> Iterable[Marks]:
        """Every annotated point: judged ones by verdict, the others as handles."""
        size = tones.HANDLE_SIZE
        missed = [p for name, p in self.drawn.items() if self.status.get(name) == "missed"]
        yield Marks(self.passing, "dot", tones.PASSES, size)
        yield Marks(self.failing, "cross", tones.TOO_FAR, size + 2)
        yield Marks(_joined_points(missed), "ring", tones.MISSED, size)
        if not by_class:
            rest = [p for name, p in self.drawn.items() if name not in self.status]
            yield Marks(_joined_points(rest), "handle", tones.UNKNOWN_CLASS, size)
            return
        judged = set(self.status)
        for element in self.field.elements:
            points = self.drawn.get(element.name)
            shown = points is not None and element.name not in judged
            yield Marks(points if shown else _NO_POINTS, "handle", element.colour, size)  # type: ignore[arg-type]
        rest = [
            p
            for name, p in self.drawn.items()
            if name not in self.field.index and name not in judged
        ]
        yield Marks(_joined_points(rest), "handle", tones.UNKNOWN_CLASS, size)

    def labels(self) -> Labels:
        """Distances beside failing points, and beside all points of the selected element."""
        return Labels(_joined_points(self._label_points), tuple(self._label_texts), "#FFFFFF")


def _halo(
    drawn: dict[str, FloatArray], scene: _Scene, highlight: str | None, selected: str | None
) -> Iterable[Strokes]:
    def of(name: str | None) -> FloatArray:
        points = drawn.get(name) if name is not None else None
        return _segments(points) if points is not None else _NO_SEGMENTS

    width = tones.ANNOTATION_WIDTH
    yield Strokes(of(highlight), tones.HALO, width + 2.5, layer="highlight")
    yield Strokes(of(selected), tones.RIM, width + 5.5, layer="selection")
    yield Strokes(of(selected), tones.HALO, width + 3.5, layer="selection")
    alone = scene.projected.get(selected) if selected and selected not in drawn else None
    yield Strokes(alone if alone is not None else _NO_SEGMENTS, tones.HALO, 1.0, (2.0, 6.0), "sel")


def _draft_strokes(draft: Draft | None, field: Field) -> Iterable[Strokes]:
    colour = _class_colour(draft.class_name, field) if draft is not None else tones.HALO
    points = np.array(draft.points if draft is not None else (), dtype=np.float64).reshape(-1, 2)
    lines = _segments(points)
    yield Strokes(lines, tones.RIM, tones.ANNOTATION_WIDTH + 2, layer="draft")
    yield Strokes(lines, colour, tones.ANNOTATION_WIDTH, layer="draft")
    band = _NO_SEGMENTS
    if draft is not None and draft.cursor is not None and len(points):
        band = np.array([[*points[-1], *draft.cursor]])
    yield Strokes(band, colour, 1.0, (4.0, 4.0), "draft")


def _draft_marks(draft: Draft | None, field: Field) -> Iterable[Marks]:
    points = np.array(draft.points if draft is not None else (), dtype=np.float64).reshape(-1, 2)
    colour = _class_colour(draft.class_name, field) if draft is not None else tones.HALO
    yield Marks(points, "handle", colour, tones.HANDLE_SIZE)


def _pointer_label(
    field: Field,
    highlight: str | None,
    draft: Draft | None,
    pointer: tuple[float, float] | None,
) -> Labels:
    """The class the next click belongs to, or the one under the cursor, at the cursor."""
    name, at = (draft.class_name, draft.cursor) if draft is not None else (highlight, pointer)
    if name is None or at is None:
        return Labels(_NO_POINTS, (), "#FFFFFF")
    element = field.element(name)
    return Labels(
        np.array([at], dtype=np.float64), (element.title if element else name,), "#FFFFFF"
    )


def _class_colour(class_name: str, field: Field) -> str:
    element = field.element(class_name)
    return element.colour if element is not None else tones.UNKNOWN_CLASS


def _selection(
    selection: str | tuple[str, int] | None,
) -> tuple[str | None, tuple[str, int] | None]:
    if isinstance(selection, tuple):
        return selection[0], selection
    return selection, None


def _point_of(drawn: dict[str, FloatArray], selected: tuple[str, int] | None) -> FloatArray:
    if selected is None:
        return _NO_POINTS
    points = drawn.get(selected[0])
    if points is None or selected[1] >= len(points):
        return _NO_POINTS
    return points[selected[1] : selected[1] + 1]


@lru_cache(maxsize=8)
def _projected_segments(
    projected: ProjectedField, size: Size, picture_size: Size
) -> dict[str, FloatArray]:
    """Element name -> its visible pieces as segments, picture px; a camera's is built once."""
    factor = _factor(size, picture_size)
    return {
        name: _joined([_segments(piece * factor) for piece in pieces])
        for name, pieces in projected.pieces.items()
    }


def _factor(size: Size, picture_size: Size) -> FloatArray:
    return np.array([(picture_size[0] - 1) / (size[0] - 1), (picture_size[1] - 1) / (size[1] - 1)])


def _segments(points: FloatArray) -> FloatArray:
    if len(points) < 2:
        return _NO_SEGMENTS
    return np.hstack([points[:-1], points[1:]])


def _joined(parts: list[FloatArray]) -> FloatArray:
    return np.concatenate(parts) if parts else _NO_SEGMENTS


def _joined_points(parts: list[FloatArray]) -> FloatArray:
    return np.concatenate(parts) if parts else _NO_POINTS
