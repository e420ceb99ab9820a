"""What is drawn over the picture, and when it is drawn anew."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from procc_annotator.gui.canvas.camera_hand import CameraHand
from procc_annotator.gui.canvas.comparison import OtherSources
from procc_annotator.gui.canvas.corner_legend import CornerLegend
from procc_annotator.gui.canvas.editor import Editor
from procc_annotator.gui.canvas.ghost_layer import GhostLayer
from procc_annotator.gui.canvas.metre_maps import MetreMaps
from procc_annotator.gui.canvas.overlay_item import OverlayItem
from procc_annotator.gui.canvas.overlay_layer import BY_ORIGIN, OverlayLayer
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import after_paint
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.store import When
from procc_annotator.interaction.gestures import Position
from procc_annotator.interaction.overlay import ColourBy
from procc_annotator.interaction.overlay_primitives import EMPTY_OVERLAY


class OverlayDrawing(QObject):
    """Draws overlay, ghosts and other sources where they changed; once for all that changes
    together.

    Attributes:
        colour_by: what colours mean.
        count: how often it drew; shows whether something drew meanwhile.
    """

    drawn = Signal()  # what a loupe shows may be another thing
    told = Signal()  # and so may be what the next click does

    def __init__(
        self,
        document: Document,
        view: PictureView,
        editor: Editor,
        item: OverlayItem,
        comparison: OtherSources,
        maps: MetreMaps,
        legend: CornerLegend,
        hand: CameraHand,
        cursor: Callable[[], Position | None],
    ) -> None:
        """
        Args:
            item, comparison, maps, legend: what it draws with.
            hand: may carry a camera, which is drawn instead of the ghosts.
            cursor: where the mouse is, picture px.
        """
        super().__init__(view)
        self._document, self._view = document, view
        self._item, self._comparison, self._maps, self._legend = item, comparison, maps, legend
        self._editor, self._hand, self._cursor = editor, hand, cursor
        self._layer = OverlayLayer(document, editor)
        self._other_layer = OverlayLayer(document, editor)
        self._ghosts = GhostLayer(document)
        self.colour_by: ColourBy = "criterion"
        self.count = 0
        self._hidden_by_action = self._hidden_by_key = False
        self._dragged = frozenset[str]()  # elements that are drawn apart
        self._due = False  # once all that changed was told
        self._everywhere = False  # not only where the overlay differs
        self._soon = after_paint(self, self.refresh)
        self._listen()

    def _listen(self) -> None:
        document = self._document
        self._hand.changed.connect(self._refresh_ghosts)
        document.store.watch(lambda s: s.preview, self._follow_preview, When.GESTURE)
        document.store.watch(
            lambda s: (select.score(s), s.selection, s.hovered_class, select.mode(s)),
            self._follow_state,
        )
        document.review.originsChanged.connect(self._refresh_origins)
        document.second.changed.connect(self.refresh)
        # Comes next to signals that draw at once: one drawing is enough for both.
        document.label_check.changed.connect(self._soon.start)
        document.store.watch(select.cameras, self._refresh_others)
        document.source_frames.changed.connect(self._refresh_others)
        document.ghosts.changed.connect(self._refresh_ghosts)
        document.painted_width.changed.connect(self.refresh)
        document.paint_watch.changed.connect(self._soon.start)
        document.landmarks.changed.connect(self.refresh)
        document.landmarks.ellipsesChanged.connect(self.refresh)

    # --- what is wanted -----------------------------------------------------------------------

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
        """What colours mean."""
        self.colour_by = colour_by
        self.refresh()

    def show_others(self, shown: bool) -> None:
        """Whether visible sources are drawn next to the active one."""
        self._comparison.others_wanted = shown
        self.refresh()

    def set_split(self, split: bool) -> None:
        """Draw the active source on the left of a divider, the compared one on its right."""
        self._comparison.split_wanted = split
        self.refresh()

    # --- drawing ------------------------------------------------------------------------------

    def refresh(self) -> None:
        """Draw the overlay anew where it changed, and say what the next click does."""
        self._due = True
        self._document.store.when_notified(self._refresh_if_due)

    def refresh_everywhere(self) -> None:
        """The same, also where the overlay looks as it did."""
        self._everywhere = True
        self.refresh()

    def _refresh_if_due(self) -> None:
        if self._due:
            self._refresh()

    def _follow_state(self) -> None:
        """Draw another state. The cursor did not move: the position of the next click is searched
        after the paint, which would have to wait for it."""
        self._refresh(looking=False)
        if self._document.state.mode == "draw" and self._editor.follows_cursor:
            self._soon.start()

    def _refresh_others(self) -> None:
        """Other sources are drawn, or otherwise; whatever changes the one in front says so too."""
        comparison = self._comparison
        if comparison.split_wanted or comparison.looking:
            self.refresh()
            return
        comparison.refresh(hidden=self.hidden)

    def _refresh_origins(self) -> None:
        if self.colour_by in BY_ORIGIN:
            self.refresh()

    def _refresh(self, *, looking: bool = True) -> None:
        self.count += 1
        everywhere, self._everywhere, self._due = self._everywhere, False, False
        self._soon.stop()
        scale, comparison = self._view.view_scale, self._comparison
        comparison.refresh(hidden=self.hidden)
        self._maps.set_hidden(self.hidden)
        self._legend.show_for(self.colour_by, bare=self.hidden)
        overlay = other = dragged = EMPTY_OVERLAY
        self._dragged = self._find_dragged()
        if not self.hidden:
            terms = self._cursor(), self.colour_by
            overlay = self._layer.overlay(
                comparison.judged, *terms, looking=looking, dragged=self._dragged
            )
            if self._dragged:
                dragged = self._layer.dragged(self._cursor())
            if comparison.split.shown:
                right = comparison.judged_right
                other = self._other_layer.overlay(right, *terms, looking=looking)
        self._item.set_overlay(overlay, scale, everywhere=everywhere)
        self._item.set_dragged(dragged, scale)
        comparison.other_side.set_overlay(other, scale, everywhere=everywhere)
        self._draw_ghosts()
        self._hand.refresh(hidden=self.hidden)
        self.drawn.emit()
        self.told.emit()

    def _follow_preview(self) -> None:
        """Draw the dragged elements; everything else, and what a camera makes of them, after the
        paint."""
        dragged = self._find_dragged()
        if not dragged or dragged != self._dragged:
            self.refresh()
            return
        self.count += 1
        self._item.set_dragged(self._layer.dragged(self._cursor()), self._view.view_scale)
        if self._document.state.active is not None:
            self._soon.start()
        self.drawn.emit()

    def _find_dragged(self) -> frozenset[str]:
        """Return the elements that are drawn apart, above everything, while the mouse moves them.

        Two sides show them twice, and points by origin are drawn by those that exist.
        """
        state, comparison = self._document.state, self._comparison
        if state.preview is None or self.hidden or self.colour_by in BY_ORIGIN:
            return frozenset()
        if comparison.divided or comparison.looking:
            return frozenset()
        same = set(map(id, state.annotation.polylines))
        return frozenset([p.class_name for p in state.preview.polylines if id(p) not in same])

    def _refresh_ghosts(self) -> None:
        if not self._due:
            self._draw_ghosts()
            self.told.emit()

    def _draw_ghosts(self) -> None:
        hidden = self.hidden or self._hand.held  # its wireframe is shown instead
        ghosts = self._ghosts.overlay(hidden=hidden)
        self._item.set_ghosts(ghosts, self._view.view_scale)
        beside = ghosts if self._comparison.split.shown else EMPTY_OVERLAY
        self._comparison.other_side.set_ghosts(beside, self._view.view_scale)
