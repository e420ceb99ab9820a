"""The overlays of the canvas: annotation with verdicts, ghosts, other sources, gestures."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np
from PySide6.QtCore import QObject, Signal

from procc_annotator.arrays import FloatArray
from procc_annotator.assist.ghost_points import GhostPoints
from procc_annotator.calibration.prediction.ghosts import Ghost
from procc_annotator.dataset.records import Origin, PointKey
from procc_annotator.gui.canvas.camera_drag import CameraDrag
from procc_annotator.gui.canvas.comparison import Judged, OtherSources
from procc_annotator.gui.canvas.editor import Editor
from procc_annotator.gui.canvas.legend import CornerLegend
from procc_annotator.gui.canvas.metre_maps import MetreMaps
from procc_annotator.gui.canvas.overlay_item import OverlayItem
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import after_paint
from procc_annotator.gui.state.checking.label_check import Evidence
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.store import When
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.gestures import Position
from procc_annotator.interaction.overlay import (
    ColourBy,
    GestureContent,
    LastCallCache,
    OverlayBuilder,
    OverlayContent,
    gesture_overlay,
)
from procc_annotator.interaction.overlay_lines import evidence_strips
from procc_annotator.interaction.overlay_predictions import build_ghosts, with_next
from procc_annotator.interaction.overlay_primitives import EMPTY_OVERLAY, NO_POINTS, Overlay
from procc_annotator.translation import tr

_BY_ORIGIN = ("origin", "annotator")


class _Side:
    """Builds the overlays of one side of the picture; parts that stay the same are not rebuilt."""

    def __init__(self, item: OverlayItem) -> None:
        self.item = item
        self._builder = OverlayBuilder()
        self._remembered = LastCallCache(self._builder.build)
        self._with_strips = LastCallCache(_with_strips)
        self._content: OverlayContent | None = None

    def show(
        self,
        content: OverlayContent | None,
        strips: Evidence | None,
        scale: float,
        *,
        everywhere: bool,
    ) -> None:
        """Show an overlay, or none; ``strips``: line pixels seen along elements."""
        self._content, overlay = content, EMPTY_OVERLAY
        if content is not None:
            # Origins of points may become known without a signal.
            by_origin = content.colour_by in _BY_ORIGIN
            overlay = self._builder.build(content) if by_origin else self._remembered(content)
            if strips is not None:
                overlay = self._with_strips(overlay, strips)
        self.item.set_overlay(overlay, scale, everywhere=everywhere)

    def show_gesture(self, gesture: GestureContent, scale: float) -> None:
        """Show what the mouse drags or draws."""
        shown = self._content
        overlay = EMPTY_OVERLAY if shown is None else gesture_overlay(shown, gesture)
        self.item.set_gesture(overlay, scale)


class OverlayDrawing(QObject):
    """Rebuilds the overlays whose content has changed; once for all changes of one round.

    Attributes:
        colour_by: what colours mean.
        count: number of rebuilds; shows whether something was rebuilt meanwhile.
    """

    drawn = Signal()  # the loupe may have to show another overlay
    told = Signal()  # the hint on the next click may have changed

    def __init__(
        self,
        services: Services,
        view: PictureView,
        editor: Editor,
        item: OverlayItem,
        comparison: OtherSources,
        maps: MetreMaps,
        legend: CornerLegend,
        hand: CameraDrag,
        cursor: Callable[[], Position | None],
    ) -> None:
        """
        Args:
            hand: while it drags a camera, no ghosts are drawn.
            cursor: position of the mouse, picture px.
        """
        super().__init__(view)
        self._services, self._view = services, view
        self._comparison, self._maps, self._legend = comparison, maps, legend
        self._editor, self._hand, self._cursor = editor, hand, cursor
        self._left, self._right = _Side(item), _Side(comparison.other_side)
        self._ghosts = LastCallCache(_ghosts_overlay)
        self.colour_by: ColourBy = "criterion"
        self.count = 0
        self._hidden_by_action = self._hidden_by_key = False
        self._dragged = frozenset[str]()  # elements that only the gesture's overlay shows
        self._due = False  # to be rebuilt after all watches were notified
        self._everywhere = False  # not only where the overlay differs
        self._soon = after_paint(self, self.refresh)
        self._gesture_soon = after_paint(self, self.refresh_gesture)
        self._listen()

    def _listen(self) -> None:
        services = self._services
        self._hand.changed.connect(self._refresh_ghosts)
        services.store.watch(lambda s: s.preview, self._follow_preview, When.GESTURE)
        services.store.watch(
            lambda s: (select.score(s), s.selection, s.hovered_class, select.mode(s)),
            self.refresh,
        )
        services.review.originsChanged.connect(self._refresh_origins)
        services.second_annotator.changed.connect(self.refresh)
        services.review.statusChanged.connect(self._soon.start)  # or its comments
        # Comes next to signals that draw at once: one drawing is enough for both.
        services.label_check.changed.connect(self._soon.start)
        services.store.watch(select.cameras, self._refresh_others)
        services.source_frames.changed.connect(self._refresh_others)
        services.ghosts.changed.connect(self._refresh_ghosts)
        services.line_widths.changed.connect(self.refresh)
        services.line_pixels.changed.connect(self._soon.start)
        services.landmarks.changed.connect(self.refresh)
        services.landmarks.ellipses.changed.connect(self.refresh)

    # --- options ------------------------------------------------------------------------------

    @property
    def hidden(self) -> bool:
        """Return whether only the bare picture is shown."""
        return self._hidden_by_action or self._hidden_by_key

    def set_hidden(self, hidden: bool) -> None:
        """Show the bare picture, until the action is chosen again."""
        self._hidden_by_action = hidden
        self.refresh()

    def hide_by_key(self, hidden: bool) -> None:
        """Show the bare picture as long as a key is held."""
        self._hidden_by_key = hidden
        self.refresh()

    def set_colour_by(self, colour_by: ColourBy) -> None:
        """Choose what colours mean."""
        self.colour_by = colour_by
        self.refresh()

    def show_others(self, shown: bool) -> None:
        """Choose whether visible sources are drawn next to the active one."""
        self._comparison.others_wanted = shown
        self.refresh()

    def set_split(self, split: bool) -> None:
        """Draw the active source on the left of a divider, the compared one on its right."""
        self._comparison.split_wanted = split
        self.refresh()

    # --- drawing ------------------------------------------------------------------------------

    def refresh(self) -> None:
        """Rebuild all overlays after the watches were notified; the hint may change as well.

        The cursor did not move: the position of the next click is searched after the paint, which
        would have to wait for it.
        """
        self._due = True
        self._services.store.when_notified(self._refresh_if_due)

    def refresh_everywhere(self) -> None:
        """Rebuild all overlays, and paint them also where they have not changed."""
        self._everywhere = True
        self.refresh()

    def refresh_gesture(self) -> None:
        """Rebuild what the mouse drags or draws; nothing else depends on the cursor."""
        if self._find_dragged() != self._dragged:
            self.refresh()
        elif not self._due:
            self._show_gesture()
            self.drawn.emit()
            self.told.emit()

    def _refresh_if_due(self) -> None:
        if self._due:
            self._refresh()

    def _follow_preview(self) -> None:
        """Draw the dragged elements; the verdict on them follows after the paint."""
        if not self._dragged or self._find_dragged() != self._dragged:
            self.refresh()
            return
        self._show_gesture()
        if self._services.state.active is not None:
            self._soon.start()
        self.drawn.emit()

    def _refresh_others(self) -> None:
        """Other sources are drawn, or otherwise; whatever changes the one in front says so too."""
        comparison = self._comparison
        if comparison.split_wanted or comparison.looking:
            self.refresh()
            return
        comparison.refresh(hidden=self.hidden)

    def _refresh_origins(self) -> None:
        if self.colour_by in _BY_ORIGIN:
            self.refresh()

    def _refresh(self) -> None:
        everywhere, self._everywhere, self._due = self._everywhere, False, False
        self._soon.stop()
        scale, comparison, services = self._view.view_scale, self._comparison, self._services
        comparison.refresh(hidden=self.hidden)
        self._maps.set_hidden(self.hidden)
        self._legend.show_for(self.colour_by, bare=self.hidden)
        self._dragged = self._find_dragged()
        strips = services.line_pixels.value if services.line_pixels.shown else None
        left = right = None
        if not self.hidden and services.state.picture_size is not None:
            left = self._content(comparison.judged)
            right = self._content(comparison.judged_right) if comparison.split.shown else None
        self._left.show(left, strips, scale, everywhere=everywhere)
        self._right.show(right, strips, scale, everywhere=everywhere)
        self._show_gesture(looking=False)
        self._draw_ghosts()
        self._hand.refresh(hidden=self.hidden)
        if services.state.mode == "draw" and self._editor.follows_cursor:
            self._gesture_soon.start()
        self.drawn.emit()
        self.told.emit()

    def _show_gesture(self, *, looking: bool = True) -> None:
        """``looking``: whether to search the picture for the position of the next click."""
        self.count += 1
        self._gesture_soon.stop()
        cursor, state = self._cursor(), self._services.state
        gesture = GestureContent(
            state.shown_annotation,
            self._editor.draft(cursor, looking=looking),
            cursor if state.hovered_class is not None else None,
            self._editor.band,
        )
        for side in (self._left, self._right):
            side.show_gesture(gesture, self._view.view_scale)

    def _find_dragged(self) -> frozenset[str]:
        """Return the elements that differ from the annotation; by origin all points are drawn
        alike."""
        state = self._services.state
        if state.preview is None or self.colour_by in _BY_ORIGIN:
            return frozenset()
        same = set(map(id, state.annotation.polylines))
        return frozenset([p.class_name for p in state.preview.polylines if id(p) not in same])

    def _content(self, judged: Judged) -> OverlayContent:
        """``judged``: measurement and score of the source to draw."""
        services, state = self._services, self._services.state
        assert state.picture_size is not None
        return OverlayContent(
            annotation=state.annotation if self._dragged else state.shown_annotation,
            size=state.setup.size,
            field=services.scorer.frame_setup.field,
            measurement=judged[0],
            score=judged[1],
            picture_size=state.picture_size,
            highlight=state.hovered_class,
            selection=state.selection.point or state.selected_class,
            with_projection=state.projection_visible,
            colour_by=self.colour_by,
            selected_points=state.selection.points,
            origins=self._origins() if self.colour_by in _BY_ORIGIN else None,
            other=services.second_annotator.annotation if state.projection_visible else None,
            # Of the compared source no one asked for it.
            paint=services.line_widths.value if judged[0] is services.scorer.measurement else None,
            ellipses=services.landmarks.ellipses.value or (),
            found=services.label_check.shown,
            dragged=self._dragged,
            comments=tuple(services.review.pins.items()),
        )

    def _origins(self) -> Mapping[PointKey, Origin] | None:
        frame = self._services.state.frame
        return None if frame is None else self._services.review.origins(frame.name)

    # --- ghosts -------------------------------------------------------------------------------

    def _refresh_ghosts(self) -> None:
        if not self._due:
            self._draw_ghosts()
            self.told.emit()

    def _draw_ghosts(self) -> None:
        hidden = self.hidden or self._hand.held  # its wireframe is shown instead
        ghosts = self._ghosts_shown() if not hidden else EMPTY_OVERLAY
        scale, right = self._view.view_scale, self._comparison.other_side
        self._left.item.set_ghosts(ghosts, scale)
        right.set_ghosts(ghosts if self._comparison.split.shown else EMPTY_OVERLAY, scale)

    def _ghosts_shown(self) -> Overlay:
        """Return the overlay of ghosts; the same object as long as nothing changed."""
        ghosts, state = self._services.ghosts, self._services.state
        current, size = ghosts.current, state.picture_size
        at = ghosts.suggested_at if ghosts.wanted else None
        if size is None or not (ghosts.painted or at):
            return EMPTY_OVERLAY
        foresight = self._services.prediction
        unsure = foresight.stands_in and bool(foresight.doubt)
        found, label = None, ""
        if current is not None:
            found, title = ghosts.found(current.name), tr(state.field.title_of(current.name))
            label = f"{title}  ±{current.sd_px:.1f} px"
            if unsure:
                label = tr("{title}  ±{sd:.1f} px  unsure", title=title, sd=current.sd_px)
        upcoming = ""
        if (best := ghosts.suggestion) is not None and current is None:
            upcoming = tr("next: {title}", title=tr(state.field.title_of(best.name)))
        painted = tuple(ghosts.painted)
        return self._ghosts(painted, current, label, found, unsure, size, at, upcoming)


def _ghosts_overlay(
    painted: tuple[Ghost, ...],
    current: Ghost | None,
    label: str,
    found: GhostPoints | None,
    unsure: bool,
    size: tuple[int, int],
    next_at: Position | None,
    upcoming: str,
) -> Overlay:
    overlay = build_ghosts(
        painted,
        current=current,
        label=label,
        points_px=_points_px(found, size),
        tone=tones.UNSURE_GHOST if unsure else tones.GHOST,
    )
    if upcoming and next_at is not None:
        return with_next(overlay, next_at, upcoming, size)
    return overlay


def _points_px(found: GhostPoints | None, size: tuple[int, int]) -> FloatArray:
    """(N, 2) picture px of the points that accepting a ghost would add."""
    if found is None or not found.points:
        return NO_POINTS
    return np.array([p[:2] for p in found.points]) * (size[0] - 1, size[1] - 1)


def _with_strips(overlay: Overlay, seen: Evidence) -> Overlay:
    return replace(overlay, strokes=(*evidence_strips(seen.values()), *overlay.strokes))
