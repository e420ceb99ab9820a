"""Everything drawn over a picture, as arrays of strokes, marks and labels.

Positions are picture px (pixel centres are whole numbers); widths, sizes and dashes are points. An
overlay always has the same strokes and marks in the same order, some of them empty, so that two
overlays can be compared row by row to repaint only what differs.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.interact import palette as tones
from procc_annotator.interact.verdicts import (
    NO_POINTS,
    NO_SEGMENTS,
    NO_VERDICTS,
    Verdicts,
    joined,
    verdicts,
)
from procc_annotator.metric.measure import Measurement
from procc_annotator.metric.score import FrameScore
from procc_annotator.session.edits import PointRef
from procc_annotator.session.origins import Origin, OriginKind, PointKey

FloatArray = NDArray[np.float64]
ColourBy = Literal["criterion", "class", "origin", "annotator"]
Size = tuple[int, int]

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
    """A polyline being drawn, picture px; ``landing`` is where a click would be put by snapping."""

    class_name: str
    points: tuple[tuple[float, float], ...]
    cursor: tuple[float, float] | None = None
    landing: tuple[float, float] | None = None


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
    selected_points: frozenset[PointRef] = frozenset(),
    band: tuple[tuple[float, float], tuple[float, float]] | None = None,
    origins: Mapping[PointKey, Origin] | None = None,
    other: FrameAnnotation | None = None,
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
        colour_by: ``criterion`` (needs a score), ``class``, ``origin`` or ``annotator`` (points by
            how they came to be, or through whom; lines by class).
        selected_points: all chosen points, when there are several.
        band: corners of the rectangle that chooses points, picture px.
        origins: of the points, for ``origin`` and ``annotator``.
        other: what a second annotator clicked in this frame.
    """
    verdict = NO_VERDICTS
    if score is not None and measurement is not None and show_projection:
        verdict = verdicts(measurement, score, picture_size)
    drawn = _Drawn(annotation, picture_size)
    selected, selected_point = _selection(selection)
    by_class = colour_by != "criterion" or verdict is NO_VERDICTS
    waiting = _Drawn(FrameAnnotation(annotation.unconfirmed), picture_size)
    second = _Drawn(other if other is not None else FrameAnnotation(), picture_size)
    strokes = [
        *_halos(drawn, verdict, highlight, selected),
        *_halos(waiting, NO_VERDICTS, highlight, selected),
        *_second_strokes(second),
        *_projection_strokes(verdict),
        *_waiting_strokes(waiting),
        *(_strokes_by_class(drawn, field) if by_class else _strokes_by_status(drawn, verdict)),
        Strokes(verdict.passing_whiskers, tones.PASSES, tones.WHISKER_WIDTH, layer="whisker"),
        Strokes(verdict.failing_whiskers, tones.TOO_FAR, tones.WHISKER_WIDTH, layer="whisker"),
        *_draft_strokes(draft, drawn, field),
        *_band_strokes(band),
    ]
    chosen = selected_points | ({selected_point} if selected_point is not None else frozenset())
    by_origin = origins is not None and colour_by in ("origin", "annotator")
    marks = [
        *_judged_marks(drawn, NO_VERDICTS if by_origin else verdict),
        *_plain_marks(drawn, verdict, field, by_class, hidden=by_origin),
        *_origin_marks(annotation, picture_size, origins if colour_by == "origin" else None),
        *_author_marks(annotation, picture_size, origins if colour_by == "annotator" else None),
        Marks(waiting.all_points, "ring", tones.UNCONFIRMED, tones.HANDLE_SIZE),
        Marks(second.all_points, "ring", tones.SECOND, tones.HANDLE_SIZE - 2),
        Marks(_draft_points(draft), "handle", _draft_colour(draft, field), tones.HANDLE_SIZE),
        Marks(_landing(draft), "ring", tones.LANDING, tones.LANDING_SIZE),
        Marks(_chosen(chosen, drawn, waiting), "ring", tones.HALO, tones.SELECTED_POINT_SIZE),
    ]
    labels = (
        Labels(*verdict.labelled(selected), tones.LABEL),
        _pointer_label(field, highlight, draft, pointer),
    )
    return Overlay(tuple(strokes), tuple(marks), labels)


class _Drawn:
    """The annotated polylines, picture px, as one array of points and one of segments."""

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


def _halos(
    drawn: _Drawn, verdict: Verdicts, highlight: str | None, selected: str | None
) -> Iterable[Strokes]:
    """What lies under the lines of the hovered and the selected element.

    White alone would vanish on the painted lines of the field, hence the dark rims. The selected
    element's projection is emphasised only if there is no annotation to emphasise.
    """
    for segments, width in (
        (verdict.projection_of(highlight), tones.PROJECTION_WIDTH),
        (drawn.segments(highlight), tones.ANNOTATION_WIDTH),
    ):
        yield Strokes(segments, tones.RIM, width + 3.5, layer="highlight")
        yield Strokes(segments, tones.HALO, width + 2.0, layer="highlight")
    alone = NO_SEGMENTS if selected in drawn else verdict.projection_of(selected)
    for segments, width in (
        (alone, tones.PROJECTION_WIDTH),
        (drawn.segments(selected), tones.ANNOTATION_WIDTH),
    ):
        yield Strokes(segments, tones.RIM, width + 5.5, layer="selection")
        yield Strokes(segments, tones.HALO, width + 3.5, layer="selection")


def _waiting_strokes(waiting: _Drawn) -> Iterable[Strokes]:
    """Unconfirmed elements: on a dark rim, for short blue dashes vanish on grass."""
    lines, width = waiting.all_segments, tones.ANNOTATION_WIDTH
    yield Strokes(lines, tones.HALO, width + 1.5, layer="unconfirmed")
    yield Strokes(lines, tones.UNCONFIRMED, width, tones.UNCONFIRMED_DASH, "unconfirmed")


def _second_strokes(second: _Drawn) -> Iterable[Strokes]:
    """What the second annotator clicked."""
    width = tones.PROJECTION_WIDTH
    yield Strokes(second.all_segments, tones.RIM, width + 2.0, layer="second")
    yield Strokes(second.all_segments, tones.SECOND, width, layer="second")


def _band_strokes(
    band: tuple[tuple[float, float], tuple[float, float]] | None,
) -> Iterable[Strokes]:
    """The rectangle that chooses points."""
    lines = NO_SEGMENTS
    if band is not None:
        (x0, y0), (x1, y1) = band
        lines = np.array([[x0, y0, x1, y0], [x1, y0, x1, y1], [x1, y1, x0, y1], [x0, y1, x0, y0]])
    yield Strokes(lines, tones.RIM, tones.WHISKER_WIDTH + 2, layer="band")
    yield Strokes(lines, tones.HALO, tones.WHISKER_WIDTH, tones.CURSOR_LINE_DASH, "band")


def _projection_strokes(verdict: Verdicts) -> Iterable[Strokes]:
    """The projected field by verdict."""
    for status in _PROJECTED:
        yield Strokes(
            verdict.projections_by_status.get(status, NO_SEGMENTS),
            tones.STATUS_COLOURS[status],
            # Nothing annotated lies beside these, and dashes weigh less than lines.
            tones.PROJECTION_WIDTH * (1.5 if status == "not_annotated" else 1.0),
            tones.STATUS_DASHES[status],
            "projection",
        )


def _strokes_by_status(drawn: _Drawn, verdict: Verdicts) -> Iterable[Strokes]:
    """Annotated polylines in the colours of the criterion."""
    for status in _ANNOTATED:
        parts = [drawn.segments(n) for n in drawn.names() if verdict.status.get(n) == status]
        yield Strokes(
            joined(parts),
            tones.STATUS_COLOURS[status],
            tones.ANNOTATION_WIDTH,
            tones.STATUS_DASHES[status],
            "annotation",
        )
    # A homography's elements off its plane, when they are left out, have no verdict.
    rest = [drawn.segments(n) for n in drawn.names() if n not in verdict.status]
    yield Strokes(joined(rest), tones.UNKNOWN_CLASS, tones.ANNOTATION_WIDTH, (), "annotation")


def _strokes_by_class(drawn: _Drawn, field: Field) -> Iterable[Strokes]:
    """Annotated polylines in the colours of their classes."""
    width = tones.ANNOTATION_WIDTH
    for element in field.elements:
        yield Strokes(drawn.segments(element.name), element.colour, width, (), "annotation")
    rest = [drawn.segments(n) for n in drawn.names() if n not in field.index]
    yield Strokes(joined(rest), tones.UNKNOWN_CLASS, width, tones.UNKNOWN_CLASS_DASH, "annotation")


def _judged_marks(drawn: _Drawn, verdict: Verdicts) -> Iterable[Marks]:
    """Points by verdict: their shapes tell them apart without colour."""
    size = tones.HANDLE_SIZE
    missed = [drawn.points(n) for n in drawn.names() if verdict.status.get(n) == "missed"]
    yield Marks(verdict.passing, "dot", tones.PASSES, size)
    yield Marks(verdict.failing, "cross", tones.TOO_FAR, size + 2)
    yield Marks(_joined_points(missed), "ring", tones.MISSED, size)


def _plain_marks(
    drawn: _Drawn, verdict: Verdicts, field: Field, by_class: bool, *, hidden: bool
) -> Iterable[Marks]:
    """Points without a verdict, as handles in the colour of their lines."""
    rest = [] if hidden else [n for n in drawn.names() if n not in verdict.status]
    if by_class:
        for element in field.elements:
            points = drawn.points(element.name if element.name in rest else None)
            yield Marks(points, "handle", element.colour, tones.HANDLE_SIZE)
        rest = [n for n in rest if n not in field.index]
    points = _joined_points([drawn.points(n) for n in rest])
    yield Marks(points, "handle", tones.UNKNOWN_CLASS, tones.HANDLE_SIZE)


def _origin_marks(
    annotation: FrameAnnotation, size: Size, origins: Mapping[PointKey, Origin] | None
) -> Iterable[Marks]:
    """Points by how they came to be."""
    groups: dict[OriginKind, list[PointKey]] = {kind: [] for kind in OriginKind}
    for key in _keys(annotation) if origins is not None else ():
        origin = origins.get(key) if origins is not None else None
        groups[origin.kind if origin is not None else OriginKind.FILE].append(key)
    for kind, keys in groups.items():
        colour, shape = tones.ORIGINS[kind.value]
        yield Marks(_places(keys, size), shape, colour, tones.HANDLE_SIZE)


def _author_marks(
    annotation: FrameAnnotation, size: Size, origins: Mapping[PointKey, Origin] | None
) -> Iterable[Marks]:
    """Points by who put them there, in the order of the names; those of the file last."""
    known = origins if origins is not None else {}
    authors = sorted({origin.author for origin in known.values()})
    groups: list[list[PointKey]] = [[] for _ in tones.AUTHORS]
    unknown: list[PointKey] = []
    for key in _keys(annotation) if origins is not None else ():
        origin = known.get(key)
        chosen = unknown
        if origin is not None:
            chosen = groups[authors.index(origin.author) % len(tones.AUTHORS)]
        chosen.append(key)
    for (colour, shape), keys in zip(tones.AUTHORS, groups, strict=True):
        yield Marks(_places(keys, size), shape, colour, tones.HANDLE_SIZE)
    yield Marks(_places(unknown, size), "handle", tones.UNKNOWN_CLASS, tones.HANDLE_SIZE)


def _keys(annotation: FrameAnnotation) -> Iterable[PointKey]:
    return [(p.u, p.v) for polyline in annotation.polylines for p in polyline.points]


def _places(keys: list[PointKey], size: Size) -> FloatArray:
    places = np.array(keys, dtype=np.float64).reshape(-1, 2)
    return places * (size[0] - 1, size[1] - 1)


def _landing(draft: Draft | None) -> FloatArray:
    if draft is None or draft.landing is None:
        return NO_POINTS
    return np.array([draft.landing], dtype=np.float64)


def _chosen(chosen: frozenset[PointRef], *drawn: _Drawn) -> FloatArray:
    parts = [group.point(ref) for ref in sorted(chosen) for group in drawn if ref[0] in group]
    return _joined_points(parts)


def _draft_points(draft: Draft | None) -> FloatArray:
    return np.array(draft.points if draft is not None else (), dtype=np.float64).reshape(-1, 2)


def _draft_colour(draft: Draft | None, field: Field) -> str:
    element = field.element(draft.class_name) if draft is not None else None
    if draft is None:
        return tones.HALO
    return element.colour if element is not None else tones.UNKNOWN_CLASS


def _draft_strokes(draft: Draft | None, drawn: _Drawn, field: Field) -> Iterable[Strokes]:
    """The polyline under way from where it continues, and its line to the cursor."""
    colour = _draft_colour(draft, field)
    points = _draft_points(draft)
    if draft is not None:
        points = np.concatenate((drawn.points(draft.class_name)[-1:], points))
    lines = np.concatenate((points[:-1], points[1:]), axis=1)
    yield Strokes(lines, tones.RIM, tones.ANNOTATION_WIDTH + 2, layer="draft")
    yield Strokes(lines, colour, tones.ANNOTATION_WIDTH, layer="draft")
    band = NO_SEGMENTS
    if draft is not None and draft.cursor is not None and len(points):
        band = np.array([[*points[-1], *draft.cursor]])
    yield Strokes(band, colour, tones.WHISKER_WIDTH, tones.CURSOR_LINE_DASH, "draft")


def _pointer_label(
    field: Field,
    highlight: str | None,
    draft: Draft | None,
    pointer: tuple[float, float] | None,
) -> Labels:
    """The class the next click belongs to, or the one under the cursor, at the cursor."""
    name, at = (draft.class_name, draft.cursor) if draft is not None else (highlight, pointer)
    if name is None or at is None:
        return Labels(NO_POINTS, (), tones.LABEL)
    element = field.element(name)
    text = element.title if element is not None else name
    return Labels(np.array([at], dtype=np.float64), (text,), tones.LABEL)


def _selection(
    selection: str | tuple[str, int] | None,
) -> tuple[str | None, tuple[str, int] | None]:
    if isinstance(selection, tuple):
        return selection[0], selection
    return selection, None


def _joined_points(parts: list[FloatArray]) -> FloatArray:
    return np.concatenate(parts) if parts else NO_POINTS
