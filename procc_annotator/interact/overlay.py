"""Everything drawn over a picture, as arrays of strokes, marks and labels.

Positions are picture px (pixel centres are whole numbers); widths, sizes and dashes are points. An
overlay always has the same strokes and marks in the same order, some of them empty, so that two
overlays can be compared group by group to repaint only what differs. What is drawn for one reason
(an annotation, a projection, what is chosen, what is under way) is made once as long as that stays,
and the groups of overlays made one after the other are then the very same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, ParamSpec, TypeVar

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.interact import palette as tones
from procc_annotator.interact.hand import draft_words
from procc_annotator.interact.overlay_findings import finding_signs, found_elements
from procc_annotator.interact.overlay_lines import (
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
from procc_annotator.interact.overlay_points import (
    author_marks,
    chosen_points,
    judged_marks,
    landing,
    origin_marks,
    plain_marks,
)
from procc_annotator.interact.overlay_shapes import (
    NO_DRAFT_STATE,
    Draft,
    Drawn,
    CursorSigns,
    Labels,
    Overlay,
    PointMarks,
    Size,
    Strokes,
)
from procc_annotator.interact.remembered import LastCallCache
from procc_annotator.interact.verdicts import NO_POINTS, NO_SCORED_FRAME, ScoredFrame, unscored_projection, scored_frame
from procc_annotator.language import tr
from procc_annotator.metric.measure import Measurement
from procc_annotator.metric.project import ProjectedField
from procc_annotator.metric.score import FrameScore
from procc_annotator.session.dataset.edits import PointRef
from procc_annotator.session.facts.frame_check import StoredFinding
from procc_annotator.session.facts.origins import Origin, PointKey

ColourBy = Literal["criterion", "class", "origin", "annotator"]
Origins = Mapping[PointKey, Origin]
Corners = tuple[tuple[float, float], tuple[float, float]]
P = ParamSpec("P")
T = TypeVar("T")

_UNKNOWN_AUTHOR = FrameAnnotation()


@dataclass(frozen=True, slots=True, kw_only=True)
class OverlayContent:
    """What an overlay is of.

    Attributes:
        annotation: of the frame, gestures under way included.
        size: (width, height) of the evaluation; the measurement's px belong to it.
        field: names, colours.
        picture_size: (width, height) of the picture on screen.
        measurement, score: of this annotation against a camera; None without one. A measurement
            alone shows the projected field.
        highlight: class under the cursor here or in the field map.
        selection: selected class, or class and point.
        draft: polyline being drawn.
        pointer: cursor in picture px; it carries the highlighted class's title.
        with_projection: False hides everything that depends on the camera (blind mode).
        colour_by: ``criterion`` (needs a score), ``class``, ``origin`` or ``annotator`` (points
            by how they came to be, or through whom; lines by class).
        selected_points: all chosen points, when there are several.
        band: corners of the rectangle that chooses points, picture px.
        origins: of the points, for ``origin`` and ``annotator``.
        other: what a second annotator clicked in this frame.
        paint: where the camera shows the borders of painted lines (`metric.project`); None:
            they are not to be drawn.
        ellipses: how surely the view shows the landmarks.
        found: of the label check, the surest first; None: it is not asked, and its groups are
            left out.
    """

    annotation: FrameAnnotation
    size: Size
    field: Field
    picture_size: Size
    measurement: Measurement | None = None
    score: FrameScore | None = None
    highlight: str | None = None
    selection: str | PointRef | None = None
    draft: Draft | None = None
    pointer: tuple[float, float] | None = None
    with_projection: bool = True
    colour_by: ColourBy = "criterion"
    selected_points: frozenset[PointRef] = frozenset()
    band: Corners | None = None
    origins: Origins | None = None
    other: FrameAnnotation | None = None
    paint: ProjectedField | None = None
    ellipses: tuple[ShownEllipse, ...] = ()
    found: Sequence[StoredFinding] | None = None

    @property
    def selected_class(self) -> str | None:
        """The selected class, be it chosen itself or by one of its points."""
        return self.selection[0] if isinstance(self.selection, tuple) else self.selection


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
        self._in_hand = LastCallCache(_strokes_in_hand)
        self._judged = LastCallCache(_all(judged_marks))
        self._plain = LastCallCache(_all(plain_marks))
        self._unjudged = LastCallCache(_unscored_marks)
        self._chosen = LastCallCache(_chosen_marks)
        self._landing = LastCallCache(_draft_marks)
        self._signs = LastCallCache(finding_signs)
        self._distances = LastCallCache(_distance_labels)
        self._pointer = LastCallCache(_pointer_label)

    def build(self, shown: OverlayContent) -> Overlay:
        """Draw an annotation and what a camera makes of it."""
        verdict = NO_SCORED_FRAME
        if shown.score is not None and shown.measurement is not None and shown.with_projection:
            verdict = scored_frame(shown.measurement, shown.score, shown.picture_size)
        elif shown.measurement is not None and shown.with_projection:
            verdict = unscored_projection(shown.measurement, shown.picture_size)
        self._draw(shown.annotation, shown.picture_size, shown.other)
        by_class = shown.colour_by != "criterion" or not verdict.by_criterion
        strokes = tuple(self._strokes(shown, verdict, by_class))
        marks = tuple(self._marks(shown, verdict, by_class))
        labels: tuple[Labels, ...] = (self._distances(verdict, shown.selected_class),)
        if shown.found is not None:
            looked_at = frozenset((shown.selected_class, shown.highlight))
            at = found_elements(shown.found, shown.annotation)
            ring, signs = self._signs(shown.found, at, shown.picture_size, shown.field, looked_at)
            marks, labels = (*marks, ring), (*labels, *signs)
        carried = self._pointer(shown.field, shown.highlight, shown.draft, shown.pointer)
        return Overlay(strokes, marks, (*labels, carried))  # what is carried above everything

    def _strokes(self, shown: OverlayContent, verdict: ScoredFrame, by_class: bool) -> Iterator[Strokes]:
        drawn, waiting, looked_at = self._drawn, self._waiting, shown.highlight
        selected = shown.selected_class
        score, paint = (shown.score, shown.paint) if shown.with_projection else (None, None)
        yield from self._ellipses(shown.ellipses)
        yield from self._halos(drawn, verdict, looked_at, selected)
        yield from self._waiting_halos(waiting, NO_SCORED_FRAME, looked_at, selected)
        yield from self._second_strokes(self._second)
        yield from self._projection(verdict.projection)
        yield from self._paint(paint, score, shown.size, shown.picture_size)
        yield from self._unconfirmed(waiting)
        yield from self._annotated(drawn, verdict, shown.field if by_class else None)
        goes_on = (drawn, waiting) if shown.draft is not None else ()
        yield from self._in_hand(shown.draft, goes_on, shown.field, shown.band)

    def _marks(self, shown: OverlayContent, verdict: ScoredFrame, by_class: bool) -> Iterator[PointMarks]:
        drawn, origins, colour_by = self._drawn, shown.origins, shown.colour_by
        by_origin = origins is not None and colour_by in ("origin", "annotator")
        yield from self._judged(drawn, NO_SCORED_FRAME if by_origin else verdict)
        yield from self._plain(drawn, verdict, shown.field, by_class, hidden=by_origin)
        if by_origin:  # more may be known of them meanwhile, without a sign
            yield from _by_origin(shown.annotation, shown.picture_size, origins, colour_by)
        else:
            yield from _NO_ORIGINS
        yield from self._unjudged(self._waiting, self._second)
        yield from self._landing(shown.draft, shown.field)
        chosen = shown.selected_points
        if isinstance(shown.selection, tuple):
            chosen |= {shown.selection}
        yield self._chosen(chosen, drawn, self._waiting)

    def _draw(self, annotation: FrameAnnotation, size: Size, other: FrameAnnotation | None) -> None:
        """What is annotated as arrays; the very same ones while it is."""
        made_of = annotation, annotation.unconfirmed, other, size
        before, self._made_of = self._made_of, made_of
        if made_of == before:
            return
        self._drawn = Drawn(annotation, size, self._drawn)
        if made_of[1:] != before[1:]:
            self._waiting = Drawn(FrameAnnotation(annotation.unconfirmed), size)
            self._second = Drawn(other if other is not None else _UNKNOWN_AUTHOR, size)


def _all(make: Callable[P, Iterable[T]]) -> Callable[P, tuple[T, ...]]:
    def made(*args: P.args, **kwargs: P.kwargs) -> tuple[T, ...]:
        return tuple(make(*args, **kwargs))

    return made


def _annotated_strokes(drawn: Drawn, verdict: ScoredFrame, field: Field | None) -> tuple[Strokes, ...]:
    """Annotated lines, by class where a field is given, and how far off they are."""
    return (
        *(strokes_by_class(drawn, field) if field else strokes_by_status(drawn, verdict)),
        Strokes(verdict.passing_error_vectors, tones.PASSES, tones.ERROR_VECTOR_WIDTH, layer="whisker"),
        Strokes(verdict.failing_error_vectors, tones.TOO_FAR, tones.ERROR_VECTOR_WIDTH, layer="whisker"),
    )


def _strokes_in_hand(
    draft: Draft | None, drawn: tuple[Drawn, ...], field: Field, band: Corners | None
) -> tuple[Strokes, ...]:
    return (*draft_strokes(draft, drawn, field), *band_strokes(band))


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


def _draft_marks(draft: Draft | None, field: Field) -> tuple[PointMarks, ...]:
    colour = draft_colour(draft, field)
    return (
        PointMarks(draft_points(draft), "handle", colour, tones.HANDLE_SIZE),
        PointMarks(landing(draft), "ring", tones.LANDING, tones.LANDING_SIZE),
    )


def _chosen_marks(chosen: frozenset[PointRef], drawn: Drawn, waiting: Drawn) -> PointMarks:
    points = chosen_points(chosen, drawn, waiting)
    return PointMarks(points, "ring", tones.HALO, tones.SELECTED_POINT_SIZE)


def _distance_labels(verdict: ScoredFrame, selected: str | None) -> Labels:
    return Labels(*verdict.labelled(selected), tones.LABEL)


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
    text = tr(field.title_of(name))
    place = np.array([at], dtype=np.float64)
    if draft is None or draft.hand is NO_DRAFT_STATE:
        return Labels(place, (text,), tones.LABEL, carried=True)
    signs = CursorSigns(draft_colour(draft, field), draft.hand.snap)
    return Labels(
        place, (f"{text}  {draft_words(draft.hand)}",), tones.LABEL, hand=signs, carried=True
    )
