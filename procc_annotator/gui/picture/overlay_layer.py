"""How the canvas shows the annotation of one side: built anew only when something of it changes."""

from __future__ import annotations

from collections.abc import Mapping

from procc_annotator.gui.picture.comparison import Judged
from procc_annotator.gui.picture.editor import Editor
from procc_annotator.gui.picture.overlay_item import NOTHING
from procc_annotator.gui.state.document import Document
from procc_annotator.interact.overlay import ColourBy, build_overlay
from procc_annotator.interact.overlay_findings import with_findings
from procc_annotator.interact.overlay_landmarks import with_ellipses
from procc_annotator.interact.overlay_shapes import Draft, Overlay
from procc_annotator.metric.project import ProjectedField
from procc_annotator.session.facts.origins import Origin, PointKey

BY_ORIGIN = ("origin", "annotator")

XY = tuple[float, float]


class OverlayLayer:
    """Makes an overlay of the annotation, a source's verdicts and what the hands are about."""

    def __init__(self, document: Document, editor: Editor) -> None:
        self._document = document
        self._editor = editor
        self._things: tuple[object, ...] = ()
        self._looks: tuple[object, ...] = ()
        self._overlay = NOTHING

    def overlay(self, judged: Judged, cursor_px: XY | None, colour_by: ColourBy) -> Overlay:
        """What to draw; the same object as long as nothing changed.

        Args:
            judged: measurement and score of the source to draw.
            cursor_px: the mouse, picture px.
            colour_by: see `build_overlay`.
        """
        document, size = self._document, self._document.picture_size
        if size is None:
            self._things, self._overlay = (), NOTHING
            return NOTHING
        draft = self._editor.draft(cursor_px)
        pointer = cursor_px if document.hovered_class is not None else None
        second = document.second.annotation if document.projection_visible else None
        found = document.label_check.shown
        ellipses = document.landmarks.ellipses
        # Of the compared source nobody asked for it.
        paint = document.painted_width.value if judged[0] is document.measurement else None
        things = document.shown_annotation, *judged, document.frame_field, second, ellipses, paint
        looks = (
            size,
            document.setup.size,
            document.hovered_class,
            document.selected_point or document.selected_class,
            document.selected_class,
            document.selected_points,
            draft,
            pointer,
            document.projection_visible,
            colour_by,
            self._editor.band,
            found,
        )
        # Of points by their origin more may be known meanwhile, without a sign.
        same = colour_by not in BY_ORIGIN and looks == self._looks and _same(things, self._things)
        if not same:
            self._things, self._looks = things, looks
            overlay = self._build(judged, draft, pointer, colour_by, paint)
            named = document.selected_class, document.hovered_class
            shown, field = document.shown_annotation, document.frame_field
            overlay = with_ellipses(overlay, ellipses)
            self._overlay = with_findings(overlay, found, shown, size, field, named=named)
        return self._overlay

    def _build(
        self,
        judged: Judged,
        draft: Draft | None,
        pointer: XY | None,
        colour_by: ColourBy,
        paint: ProjectedField | None,
    ) -> Overlay:
        document, size = self._document, self._document.picture_size
        assert size is not None  # the caller looked
        return build_overlay(
            document.shown_annotation,
            document.setup.size,
            document.frame_field,
            measurement=judged[0],
            score=judged[1],
            picture_size=size,
            highlight=document.hovered_class,
            selection=document.selected_point or document.selected_class,
            draft=draft,
            pointer=pointer,
            show_projection=document.projection_visible,
            colour_by=colour_by,
            selected_points=document.selected_points,
            band=self._editor.band,
            origins=self._origins(colour_by),
            other=document.second.annotation if document.projection_visible else None,
            paint=paint,
        )

    def _origins(self, colour_by: ColourBy) -> Mapping[PointKey, Origin] | None:
        frame = self._document.frame
        if frame is None or colour_by not in BY_ORIGIN:
            return None
        return self._document.review.origins(frame.name)


def _same(things: tuple[object, ...], before: tuple[object, ...]) -> bool:
    """Whether they are the very objects: to compare what is in them would take longer."""
    return len(things) == len(before) and all(map(lambda a, b: a is b, things, before))
