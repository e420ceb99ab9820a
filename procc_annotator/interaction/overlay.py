"""Build the overlay of a picture from annotation, projection and score."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Generic, Literal, ParamSpec, TypeVar

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.arrays import FloatArray
from procc_annotator.dataset.editing import PointRef
from procc_annotator.dataset.records import Comment, Origin, OriginKind, PointKey
from procc_annotator.dataset.review import StoredFinding
from procc_annotator.field.model import Field
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.draw_tool import draft_words
from procc_annotator.interaction.overlay_lines import (
    ShownEllipse,
    band_strokes,
    draft_colour,
    draft_points,
    draft_strokes,
    ellipse_strokes,
    halos,
    paint_strokes,
    projection_strokes,
    second_strokes,
    strokes_by_class,
    strokes_by_status,
    unconfirmed_strokes,
)
from procc_annotator.interaction.overlay_predictions import finding_signs, found_elements
from procc_annotator.interaction.overlay_primitives import (
    EMPTY_OVERLAY,
    NO_DRAFT_STATE,
    NO_LINE,
    NO_POINTS,
    NO_SCORED_FRAME,
    CursorSigns,
    Draft,
    Drawn,
    DrawnLine,
    Labels,
    Overlay,
    PointMarks,
    ScoredFrame,
    Size,
    Strokes,
    joined_points,
    scored_frame,
    unscored_projection,
)
from procc_annotator.metrics.measurement import Measurement
from procc_annotator.metrics.projection import ProjectedField
from procc_annotator.metrics.score import FrameScore
from procc_annotator.translation import tr

P = ParamSpec("P")
T = TypeVar("T")


class LastCallCache(Generic[P, T]):
    """Gives the very same result for the same arguments as the last time.

    Arguments are compared as members of a tuple are: the same object, or an equal one. Arrays must
    therefore come in something that is compared by identity.
    """

    def __init__(self, make: Callable[P, T]) -> None:
        self._make = make
        self._last: tuple[object, T] | None = None

    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> T:
        asked = args, kwargs
        if self._last is None or self._last[0] != asked:
            self._last = asked, self._make(*args, **kwargs)
        return self._last[1]


def judged_marks(drawn: Drawn, verdict: ScoredFrame) -> Iterable[PointMarks]:
    """Points by verdict: their shapes distinguish them without colour."""
    size = tones.HANDLE_SIZE
    missed = [drawn.points(n) for n in drawn.names() if verdict.status.get(n) == "missed"]
    yield PointMarks(verdict.passing, "dot", tones.PASSES, size)
    yield PointMarks(verdict.failing, "cross", tones.TOO_FAR, size + 2)
    yield PointMarks(joined_points(missed), "ring", tones.MISSED, size)


def plain_marks(
    drawn: Drawn, verdict: ScoredFrame, field: Field, by_class: bool, *, hidden: bool
) -> Iterable[PointMarks]:
    """Points without a verdict, as handles in the colour of their lines."""
    rest = [] if hidden else [n for n in drawn.names() if n not in verdict.status]
    if by_class:
        marks = [_class_marks(NO_LINE, element.colour) for element in field.elements]
        for name in rest:
            if (i := field.index.get(name)) is not None:
                marks[i] = _class_marks(drawn.line(name), marks[i].colour)
        yield from marks
        rest = [n for n in rest if n not in field.index]
    points = joined_points([drawn.points(n) for n in rest])
    yield PointMarks(points, "handle", tones.UNKNOWN_CLASS, tones.HANDLE_SIZE)


@lru_cache(maxsize=256)  # the very same while other elements change
def _class_marks(line: DrawnLine, colour: str) -> PointMarks:
    return PointMarks(line.points, "handle", colour, tones.HANDLE_SIZE)


def origin_marks(
    annotation: FrameAnnotation, size: Size, origins: Mapping[PointKey, Origin] | None
) -> Iterable[PointMarks]:
    """Points by how they came to be."""
    groups: dict[OriginKind, list[PointKey]] = {kind: [] for kind in OriginKind}
    for key in _keys(annotation) if origins is not None else ():
        origin = origins.get(key) if origins is not None else None
        groups[origin.kind if origin is not None else OriginKind.FILE].append(key)
    for kind, keys in groups.items():
        colour, shape = tones.ORIGINS[kind.value]
        yield PointMarks(_places(keys, size), shape, colour, tones.HANDLE_SIZE)


def author_marks(
    annotation: FrameAnnotation, size: Size, origins: Mapping[PointKey, Origin] | None
) -> Iterable[PointMarks]:
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
        yield PointMarks(_places(keys, size), shape, colour, tones.HANDLE_SIZE)
    yield PointMarks(_places(unknown, size), "handle", tones.UNKNOWN_CLASS, tones.HANDLE_SIZE)


def _keys(annotation: FrameAnnotation) -> Iterable[PointKey]:
    return [(p.u, p.v) for polyline in annotation.polylines for p in polyline.points]


def _places(keys: list[PointKey], size: Size) -> FloatArray:
    places = np.array(keys, dtype=np.float64).reshape(-1, 2)
    return places * (size[0] - 1, size[1] - 1)


ColourBy = Literal["criterion", "class", "origin", "annotator"]
Origins = Mapping[PointKey, Origin]
Corners = tuple[tuple[float, float], tuple[float, float]]

_UNKNOWN_AUTHOR = FrameAnnotation()


@dataclass(frozen=True, slots=True, kw_only=True)
class OverlayContent:
    """Content of an overlay.

    Attributes:
        size: (width, height) of the evaluation; the measurement's px belong to it.
        picture_size: (width, height) of the picture on screen.
        measurement, score: of this annotation against a camera; None without one. A measurement
            alone shows the projected field.
        highlight: class under the cursor here or in the field map.
        selection: selected class, or class and point.
        with_projection: False hides everything that depends on the camera (blind mode).
        colour_by: ``criterion`` (needs a score), ``class``, ``origin`` or ``annotator`` (points
            by how they came to be, or through whom; lines by class).
        selected_points: all chosen points, when there are several.
        origins: of the points, for ``origin`` and ``annotator``.
        other: what a second annotator clicked in this frame.
        paint: where the camera shows the borders of painted lines (`metrics.projection`); None:
            they are not to be drawn.
        ellipses: how surely the view shows the landmarks.
        found: of the label check, the surest first; None: it is not asked, and its groups are
            left out.
        dragged: elements that the mouse drags: `gesture_overlay` draws them.
        comments: those pinned to a place, with their texts.
    """

    annotation: FrameAnnotation
    size: Size
    field: Field
    picture_size: Size
    measurement: Measurement | None = None
    score: FrameScore | None = None
    highlight: str | None = None
    selection: str | PointRef | None = None
    with_projection: bool = True
    colour_by: ColourBy = "criterion"
    selected_points: frozenset[PointRef] = frozenset()
    origins: Origins | None = None
    other: FrameAnnotation | None = None
    paint: ProjectedField | None = None
    ellipses: tuple[ShownEllipse, ...] = ()
    found: Sequence[StoredFinding] | None = None
    dragged: frozenset[str] = frozenset()
    comments: tuple[tuple[str, Comment], ...] = ()

    @property
    def selected_class(self) -> str | None:
        """The selected class, whether chosen itself or by one of its points."""
        return self.selection[0] if isinstance(self.selection, tuple) else self.selection

    @property
    def verdict(self) -> ScoredFrame:
        """The criterion on the frame, as far as a camera is shown."""
        if self.measurement is None or not self.with_projection:
            return NO_SCORED_FRAME
        if self.score is None:
            return unscored_projection(self.measurement, self.picture_size)
        return scored_frame(self.measurement, self.score, self.picture_size)

    @property
    def chosen(self) -> frozenset[PointRef]:
        """All selected points."""
        single = {self.selection} if isinstance(self.selection, tuple) else ()
        return self.selected_points.union(single)


@dataclass(frozen=True, slots=True)
class GestureContent:
    """The part of the overlay that may change with every move of the mouse.

    Attributes:
        annotation: of the frame, as if the mouse button were released now.
        pointer: cursor in picture px; it has the highlighted class's title.
        band: corners of the rectangle that chooses points, picture px.
    """

    annotation: FrameAnnotation
    draft: Draft | None = None
    pointer: tuple[float, float] | None = None
    band: Corners | None = None


class OverlayBuilder:
    """Builds overlays one after the other; what is drawn for the same reason is not made again."""

    def __init__(self) -> None:
        self._drawn = self._waiting = self._second = Drawn(_UNKNOWN_AUTHOR, (2, 2))
        self._made_of: tuple[object, ...] = ()
        self._ellipses = LastCallCache(_all(ellipse_strokes))
        self._halos = LastCallCache(_all(halos))
        self._waiting_halos = LastCallCache(_all(halos))
        self._second_strokes = LastCallCache(_all(second_strokes))
        self._projection = LastCallCache(_all(projection_strokes))
        self._paint = LastCallCache(_all(paint_strokes))
        self._unconfirmed = LastCallCache(_all(unconfirmed_strokes))
        self._annotated = LastCallCache(_annotated_strokes)
        self._judged = LastCallCache(_all(judged_marks))
        self._plain = LastCallCache(_all(plain_marks))
        self._unjudged = LastCallCache(_unscored_marks)
        self._chosen = LastCallCache(_chosen_marks)
        self._signs = LastCallCache(finding_signs)
        self._distances = LastCallCache(_distance_labels)
        self._comments = LastCallCache(_comment_pins)

    def build(self, shown: OverlayContent) -> Overlay:
        """Draw an annotation and what a camera makes of it."""
        verdict, annotation = shown.verdict, shown.annotation
        for name in shown.dragged:
            annotation = annotation.without(name)
        self._draw(annotation, shown.picture_size, shown.other)
        by_class = shown.colour_by != "criterion" or not verdict.by_criterion
        strokes = tuple(self._strokes(shown, verdict, by_class))
        pins, comments = self._comments(shown.comments)
        marks = (*self._marks(shown, verdict, by_class), pins)
        labels: tuple[Labels, ...] = self._distances(verdict, shown.selected_class), comments
        if shown.found is not None:
            looked_at = frozenset((shown.selected_class, shown.highlight))
            at = found_elements(shown.found, annotation)
            ring, signs = self._signs(shown.found, at, shown.picture_size, shown.field, looked_at)
            marks, labels = (*marks, ring), (*labels, *signs)
        return Overlay(strokes, marks, labels)

    def _strokes(
        self, shown: OverlayContent, verdict: ScoredFrame, by_class: bool
    ) -> Iterator[Strokes]:
        drawn, waiting = self._drawn, self._waiting
        selected = None if shown.selected_class in shown.dragged else shown.selected_class
        score, paint = (shown.score, shown.paint) if shown.with_projection else (None, None)
        yield from self._ellipses(shown.ellipses)
        yield from self._halos(drawn, verdict, shown.highlight, selected)
        yield from self._waiting_halos(waiting, NO_SCORED_FRAME, shown.highlight, selected)
        yield from self._second_strokes(self._second)
        yield from self._projection(verdict.projection)
        yield from self._paint(paint, score, shown.size, shown.picture_size)
        yield from self._unconfirmed(waiting)
        yield from self._annotated(drawn, verdict, shown.field if by_class else None)

    def _marks(
        self, shown: OverlayContent, verdict: ScoredFrame, by_class: bool
    ) -> Iterator[PointMarks]:
        drawn, origins, colour_by = self._drawn, shown.origins, shown.colour_by
        by_origin = origins is not None and colour_by in ("origin", "annotator")
        yield from self._judged(drawn, NO_SCORED_FRAME if by_origin else verdict)
        yield from self._plain(drawn, verdict, shown.field, by_class, hidden=by_origin)
        if by_origin:  # more may be known of them meanwhile, without a sign
            yield from _by_origin(shown.annotation, shown.picture_size, origins, colour_by)
        else:
            yield from _NO_ORIGINS
        yield from self._unjudged(self._waiting, self._second)
        yield self._chosen(shown.chosen, drawn, self._waiting)

    def _draw(self, annotation: FrameAnnotation, size: Size, other: FrameAnnotation | None) -> None:
        """Turn the annotation into arrays; the very same ones while it is unchanged."""
        made_of = annotation, annotation.unconfirmed, other, size
        before, self._made_of = self._made_of, made_of
        if made_of == before:
            return
        self._drawn = Drawn(annotation, size, self._drawn)
        if made_of[1:] != before[1:]:
            self._waiting = Drawn(FrameAnnotation(annotation.unconfirmed), size)
            self._second = Drawn(other if other is not None else _UNKNOWN_AUTHOR, size)


def gesture_overlay(shown: OverlayContent, gesture: GestureContent) -> Overlay:
    """Draw dragged elements, the draft, the band and the title at the cursor.

    All of it lies above the overlay of ``shown``.
    """
    strokes: list[Strokes] = []
    marks: list[PointMarks] = []
    labels: list[Labels] = []
    if shown.dragged:
        dragged = _dragged_overlay(shown, gesture.annotation)
        strokes += dragged.strokes
        marks += dragged.marks
        labels += dragged.labels
    if (draft := gesture.draft) is not None:
        known = (
            gesture.annotation.get(draft.class_name),
            gesture.annotation.get_unconfirmed(draft.class_name),
        )
        drawn = [Drawn(FrameAnnotation((p,)), shown.picture_size) for p in known if p is not None]
        strokes += draft_strokes(draft, drawn, shown.field)
        marks += _draft_marks(draft, shown.field)
    if gesture.band is not None:
        strokes += band_strokes(gesture.band)
    name, at = shown.highlight, gesture.pointer
    if draft is not None:
        name, at = draft.class_name, draft.cursor
    if name is not None and at is not None:
        labels.append(_pointer_label(shown.field, name, at, draft))
    if not (strokes or marks or labels):
        return EMPTY_OVERLAY
    return Overlay(tuple(strokes), tuple(marks), tuple(labels))


def _dragged_overlay(shown: OverlayContent, moved: FrameAnnotation) -> Overlay:
    verdict, size, names = shown.verdict, shown.picture_size, shown.dragged
    annotation = FrameAnnotation(tuple([p for p in moved.polylines if p.class_name in names]))
    drawn = Drawn(annotation, size)
    highlight = shown.highlight if shown.highlight in names else None
    selected = shown.selected_class if shown.selected_class in names else None
    lines, marks = [], []
    by_class = shown.colour_by != "criterion" or not verdict.by_criterion
    for name in drawn.names():
        line, status = drawn.line(name), verdict.status.get(name)
        colour: str = tones.UNKNOWN_CLASS
        dash: tuple[float, ...] = ()
        if by_class and (element := shown.field.element(name)) is not None:
            colour = element.colour
        elif by_class:
            dash = tones.UNKNOWN_CLASS_DASH
        elif status is not None:
            colour, dash = tones.STATUS_COLOURS[status], tones.STATUS_DASHES[status]
        lines.append(Strokes(line.segments, colour, tones.ANNOTATION_WIDTH, dash, "annotation"))
        if status is None:
            marks.append(PointMarks(line.points, "handle", colour, tones.HANDLE_SIZE))
        elif status == "missed":
            marks.append(PointMarks(line.points, "ring", tones.MISSED, tones.HANDLE_SIZE))
    marks.append(_chosen_marks(shown.chosen, drawn))
    labels: tuple[Labels, ...] = ()
    if shown.found is not None:
        looked_at = frozenset((shown.selected_class, shown.highlight))
        ring, labels = finding_signs(shown.found, annotation, size, shown.field, looked_at)
        marks.append(ring)
    # The projection's halo lies below the projection.
    around = halos(drawn, NO_SCORED_FRAME, highlight, selected)
    strokes = [s for s in around if len(s.segments)]
    return Overlay((*strokes, *lines), tuple(marks), labels)


def _all(make: Callable[P, Iterable[T]]) -> Callable[P, tuple[T, ...]]:
    def made(*args: P.args, **kwargs: P.kwargs) -> tuple[T, ...]:
        return tuple(make(*args, **kwargs))

    return made


def _annotated_strokes(
    drawn: Drawn, verdict: ScoredFrame, field: Field | None
) -> tuple[Strokes, ...]:
    """Annotated lines, by class where a field is given, and how far off they are."""
    return (
        *(strokes_by_class(drawn, field) if field else strokes_by_status(drawn, verdict)),
        Strokes(
            verdict.passing_error_vectors, tones.PASSES, tones.ERROR_VECTOR_WIDTH, layer="whisker"
        ),
        Strokes(
            verdict.failing_error_vectors, tones.TOO_FAR, tones.ERROR_VECTOR_WIDTH, layer="whisker"
        ),
    )


def _by_origin(
    annotation: FrameAnnotation, size: Size, origins: Origins | None, colour_by: ColourBy
) -> tuple[PointMarks, ...]:
    return (
        *origin_marks(annotation, size, origins if colour_by == "origin" else None),
        *author_marks(annotation, size, origins if colour_by == "annotator" else None),
    )


_NO_ORIGINS = _by_origin(_UNKNOWN_AUTHOR, (2, 2), None, "origin")


def _unscored_marks(waiting: Drawn, second: Drawn) -> tuple[PointMarks, ...]:
    return (
        PointMarks(waiting.all_points, "ring", tones.UNCONFIRMED, tones.HANDLE_SIZE),
        PointMarks(second.all_points, "ring", tones.SECOND, tones.HANDLE_SIZE - 2),
    )


def _draft_marks(draft: Draft, field: Field) -> tuple[PointMarks, ...]:
    colour = draft_colour(draft, field)
    landing = NO_POINTS if draft.landing is None else np.array([draft.landing], dtype=np.float64)
    return (
        PointMarks(draft_points(draft), "handle", colour, tones.HANDLE_SIZE),
        PointMarks(landing, "ring", tones.LANDING, tones.LANDING_SIZE),
    )


def _chosen_marks(chosen: frozenset[PointRef], *drawn: Drawn) -> PointMarks:
    """The selected points of confirmed and unconfirmed elements."""
    parts = [group.point(ref) for ref in sorted(chosen) for group in drawn if ref[0] in group]
    points = joined_points(parts)
    return PointMarks(points, "ring", tones.HALO, tones.SELECTED_POINT_SIZE)


def _distance_labels(verdict: ScoredFrame, selected: str | None) -> Labels:
    return Labels(*verdict.labelled(selected), tones.LABEL)


def _comment_pins(comments: tuple[tuple[str, Comment], ...]) -> tuple[PointMarks, Labels]:
    places = np.array([c.place for _, c in comments], dtype=np.float64).reshape(-1, 2)
    marks = PointMarks(places, "ring", tones.COMMENT, tones.SELECTED_POINT_SIZE)
    return marks, Labels(places, tuple(text for text, _ in comments), tones.COMMENT)


def _pointer_label(field: Field, name: str, at: tuple[float, float], draft: Draft | None) -> Labels:
    """The class the next click belongs to, or the one under the cursor, at the cursor."""
    text = tr(field.title_of(name))
    place = np.array([at], dtype=np.float64)
    if draft is None or draft.hand is NO_DRAFT_STATE:
        return Labels(place, (text,), tones.LABEL, carried=True)
    signs = CursorSigns(draft_colour(draft, field), draft.hand.snap)
    text = f"{text}  {draft_words(draft.hand)}"
    return Labels(place, (text,), tones.LABEL, hand=signs, carried=True)
