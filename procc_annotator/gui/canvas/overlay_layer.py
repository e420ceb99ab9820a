"""How the canvas shows the annotation of one side: built anew only when something of it changes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from procc_annotator.dataset.records import Origin, PointKey
from procc_annotator.gui.canvas.comparison import Judged
from procc_annotator.gui.canvas.editor import Editor
from procc_annotator.gui.state.checking.line_pixels import Evidence
from procc_annotator.gui.state.document import Document
from procc_annotator.interaction.overlay import (
    ColourBy,
    LastCallCache,
    OverlayBuilder,
    OverlayContent,
    dragged_overlay,
)
from procc_annotator.interaction.overlay_lines import evidence_strips
from procc_annotator.interaction.overlay_primitives import EMPTY_OVERLAY, Overlay

BY_ORIGIN = ("origin", "annotator")

XY = tuple[float, float]


class OverlayLayer:
    """Makes an overlay of the annotation, a source's verdicts and what the hands are about."""

    def __init__(self, document: Document, editor: Editor) -> None:
        self._document = document
        self._editor = editor
        self._builder = OverlayBuilder()
        self._remembered = LastCallCache(self._builder.build)
        self._with_strips = LastCallCache(_with_strips)

    def overlay(
        self,
        judged: Judged,
        cursor_px: XY | None,
        colour_by: ColourBy,
        *,
        looking: bool = True,
        dragged: frozenset[str] = frozenset(),
    ) -> Overlay:
        """Return what to draw; the same object as long as nothing changed.

        Args:
            judged: measurement and score of the source to draw.
            cursor_px: the mouse, picture px.
            colour_by: see `OverlayContent`.
            looking: whether to look in the picture where a click would be put.
            dragged: elements that are drawn by `dragged`.
        """
        document, size = self._document, self._document.state.picture_size
        if size is None:
            return EMPTY_OVERLAY
        by_origin = colour_by in BY_ORIGIN
        shown = OverlayContent(
            annotation=document.state.shown_annotation,
            size=document.state.setup.size,
            field=document.judge.frame_setup.field,
            measurement=judged[0],
            score=judged[1],
            picture_size=size,
            highlight=document.state.hovered_class,
            selection=document.state.selection.point or document.state.selected_class,
            draft=self._editor.draft(cursor_px, looking=looking),
            pointer=cursor_px if document.state.hovered_class is not None else None,
            with_projection=document.state.projection_visible,
            colour_by=colour_by,
            selected_points=document.state.selection.points,
            band=self._editor.band,
            origins=self._origins() if by_origin else None,
            other=document.second.annotation if document.state.projection_visible else None,
            # Of the compared source no one asked for it.
            paint=document.painted_width.value if judged[0] is document.judge.measurement else None,
            ellipses=tuple(document.landmarks.ellipses),
            found=document.label_check.shown,
            dragged=dragged,
        )
        self._content = shown
        if dragged:  # what is below them is the same whatever becomes of them
            shown = replace(shown, annotation=document.state.annotation, pointer=None)
        # Of points by their origin more may be known meanwhile, without a sign.
        overlay = self._builder.build(shown) if by_origin else self._remembered(shown)
        seen = document.paint_watch.value if document.paint_watch.shown else None
        return overlay if seen is None else self._with_strips(overlay, seen)

    def dragged(self, cursor_px: XY | None) -> Overlay:
        """Return the dragged elements where they are now, with all else as `overlay` drew it."""
        annotation = self._document.state.shown_annotation
        return dragged_overlay(replace(self._content, annotation=annotation, pointer=cursor_px))

    def _origins(self) -> Mapping[PointKey, Origin] | None:
        frame = self._document.state.frame
        return None if frame is None else self._document.review.origins(frame.name)


def _with_strips(overlay: Overlay, seen: Evidence) -> Overlay:
    return replace(overlay, strokes=(*evidence_strips(seen.values()), *overlay.strokes))
