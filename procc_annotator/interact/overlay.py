"""Everything drawn over a picture, as arrays of strokes, marks and labels.

Positions are picture px (pixel centres are whole numbers); widths, sizes and dashes are points. An
overlay always has the same strokes and marks in the same order, some of them empty, so that two
overlays can be compared row by row to repaint only what differs.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.interact import palette as tones
from procc_annotator.interact.overlay_lines import (
    band_strokes,
    draft_colour,
    draft_points,
    draft_strokes,
    halos,
    projection_strokes,
    second_strokes,
    strokes_by_class,
    strokes_by_status,
    unconfirmed_strokes,
)
from procc_annotator.interact.overlay_paint import paint_strokes
from procc_annotator.interact.overlay_points import (
    author_marks,
    chosen_points,
    judged_marks,
    landing,
    origin_marks,
    plain_marks,
)
from procc_annotator.interact.overlay_shapes import (
    Draft,
    Drawn,
    Labels,
    Marks,
    Overlay,
    Size,
    Strokes,
)
from procc_annotator.interact.verdicts import NO_POINTS, NO_VERDICTS, verdicts
from procc_annotator.metric.measure import Measurement
from procc_annotator.metric.project import ProjectedField
from procc_annotator.metric.score import FrameScore
from procc_annotator.session.dataset.edits import PointRef
from procc_annotator.session.facts.origins import Origin, PointKey

ColourBy = Literal["criterion", "class", "origin", "annotator"]


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
    paint: ProjectedField | None = None,
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
        paint: where the camera shows the borders of painted lines (`metric.project`); None: they
            are not to be drawn.
    """
    verdict = NO_VERDICTS
    if score is not None and measurement is not None and show_projection:
        verdict = verdicts(measurement, score, picture_size)
    drawn = Drawn(annotation, picture_size)
    selected, selected_point = _selection(selection)
    by_class = colour_by != "criterion" or verdict is NO_VERDICTS
    waiting = Drawn(FrameAnnotation(annotation.unconfirmed), picture_size)
    second = Drawn(other if other is not None else FrameAnnotation(), picture_size)
    strokes = [
        *halos(drawn, verdict, highlight, selected),
        *halos(waiting, NO_VERDICTS, highlight, selected),
        *second_strokes(second),
        *projection_strokes(verdict),
        *paint_strokes(
            paint if show_projection else None,
            score if show_projection else None,
            size,
            picture_size,
        ),
        *unconfirmed_strokes(waiting),
        *(strokes_by_class(drawn, field) if by_class else strokes_by_status(drawn, verdict)),
        Strokes(verdict.passing_whiskers, tones.PASSES, tones.WHISKER_WIDTH, layer="whisker"),
        Strokes(verdict.failing_whiskers, tones.TOO_FAR, tones.WHISKER_WIDTH, layer="whisker"),
        *draft_strokes(draft, (drawn, waiting), field),
        *band_strokes(band),
    ]
    chosen = selected_points | ({selected_point} if selected_point is not None else frozenset())
    by_origin = origins is not None and colour_by in ("origin", "annotator")
    marks = [
        *judged_marks(drawn, NO_VERDICTS if by_origin else verdict),
        *plain_marks(drawn, verdict, field, by_class, hidden=by_origin),
        *origin_marks(annotation, picture_size, origins if colour_by == "origin" else None),
        *author_marks(annotation, picture_size, origins if colour_by == "annotator" else None),
        Marks(waiting.all_points, "ring", tones.UNCONFIRMED, tones.HANDLE_SIZE),
        Marks(second.all_points, "ring", tones.SECOND, tones.HANDLE_SIZE - 2),
        Marks(draft_points(draft), "handle", draft_colour(draft, field), tones.HANDLE_SIZE),
        Marks(landing(draft), "ring", tones.LANDING, tones.LANDING_SIZE),
        Marks(chosen_points(chosen, drawn, waiting), "ring", tones.HALO, tones.SELECTED_POINT_SIZE),
    ]
    labels = (
        Labels(*verdict.labelled(selected), tones.LABEL),
        _pointer_label(field, highlight, draft, pointer),
    )
    return Overlay(tuple(strokes), tuple(marks), labels)


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
