"""The canvas: the picture with its overlays, and its mouse and key events."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, Qt, QTimer, Signal
from PySide6.QtGui import (
    QAccessible,
    QContextMenuEvent,
    QEnterEvent,
    QKeyEvent,
    QMouseEvent,
    QResizeEvent,
)
from PySide6.QtWidgets import QApplication, QLineEdit, QToolTip

from procc_annotator.dataset.records import Comment
from procc_annotator.gui.canvas.camera_drag import CameraDrag
from procc_annotator.gui.canvas.canvas_keys import HeldKey, HeldKeys, KeyPointing, modifiers_of
from procc_annotator.gui.canvas.comparison import OtherSources
from procc_annotator.gui.canvas.drawing import OverlayDrawing
from procc_annotator.gui.canvas.editor import Editor
from procc_annotator.gui.canvas.legend import CornerLegend
from procc_annotator.gui.canvas.loupe import Loupe
from procc_annotator.gui.canvas.metre_maps import MetreMaps
from procc_annotator.gui.canvas.overlay_item import OverlayItem
from procc_annotator.gui.canvas.picture_item import ShownPicture
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.gui.canvas.viewport_overlays import BlindFrame, FoundPlate
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import after_paint
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import give_role
from procc_annotator.interaction.gestures import Modifiers
from procc_annotator.interaction.hints import join_hint
from procc_annotator.translation import tr

_EXPLANATION_MS = 12_000
_SCREEN_FRAME_MS = 16


class Canvas(PictureView):
    """Shows the state's frame; mouse and keys go to the draw or edit tool."""

    cursorMoved = Signal(object)  # (x, y) in picture px, or None
    hintChanged = Signal(str)
    menuWanted = Signal(QPoint)  # on the screen
    panChanged = Signal(bool)  # whether the left button moves the picture

    def __init__(self, services: Services) -> None:
        super().__init__()
        give_role(self, QAccessible.Role.Canvas)
        self.setObjectName("canvas")
        self.setAccessibleName(tr("Picture"))
        self._services = self.services = services
        self.editor = Editor(services, self)
        self.overlay_item = OverlayItem()
        self.scene().addItem(self.overlay_item)
        self.comparison = OtherSources(services, self.viewport(), self.scene(), self.overlay_item)
        self.maps = MetreMaps(services, self.viewport(), self.scene())
        self.found_plate = FoundPlate(services, self)
        self.blind_frame = BlindFrame(services, self)
        self.legend = CornerLegend(services, self, self.comparison)
        self.legend.stood.connect(self.overlay_item.keep_clear)
        self.camera_drag = CameraDrag(services, self, self.editor)
        self.drawing = OverlayDrawing(
            services,
            self,
            self.editor,
            self.overlay_item,
            self.comparison,
            self.maps,
            self.legend,
            self.camera_drag,
            lambda: self.cursor_px,
        )
        self.keep_zoom = False
        self.cursor_px: tuple[float, float] | None = None
        self._menu_px: tuple[float, float] | None = None  # where the menu was asked for
        self._hint = ""
        self._hint_soon = after_paint(self, self._say_hint)
        # While the user drags something, who only reads where it is can wait for the next frame.
        self._carried_on = QTimer(self, singleShot=True, interval=_SCREEN_FRAME_MS)
        self._carried_on.timeout.connect(self._say_cursor)
        self.loupe = Loupe(self.viewport())
        self.loupe_always = False
        self._held_keys = self._make_held_keys()
        self._loupe_by_key = False
        self.keys = KeyPointing(services, self, self.editor, lambda: self.cursor_px)
        self.shown = ShownPicture(self)
        services.cache.foresee = self.picture_item.reduced.foresee
        self._listen()
        self._show_frame()

    def _listen(self) -> None:
        services = self._services
        self.shown.changed.connect(self._show_picture)
        self.editor.changed.connect(self.drawing.refresh_gesture)
        self.drawing.drawn.connect(self._place_loupe)
        self.drawing.told.connect(self._hint_soon.start)
        self.keys.pointed.connect(self.point_at)
        self.keys.forgotten.connect(self._forget_cursor)
        self.editor.explained.connect(self._explain)
        self.viewChanged.connect(self._view_changed)
        self.camera_drag.moved.connect(self._follow_cursor)
        services.store.watch(select.dataset, self.keys.forget)
        services.store.watch(select.frame, self._show_frame)
        services.store.watch(select.picture, self._show_whole)
        services.store.events.flyTo.connect(self.fly_to)
        services.store.events.flyToArea.connect(self.show_area)

    # --- showing --------------------------------------------------------------------------

    def _show_frame(self) -> None:
        if self._loupe_wanted:  # it shows every pixel
            self._services.navigator.see_whole()
        state = self._services.state
        looked_at = state.picture if state.half is None else state.half.pixels
        self.shown.set_picture(looked_at, whole=state.half is None)
        self.set_picture(self.shown.pixels, state.picture_size, keep_view=self.keep_zoom)
        self.overlay_item.set_area(self.sceneRect())
        self.comparison.other_side.set_area(self.sceneRect())
        self.camera_drag.item.set_area(self.sceneRect())
        self.keys.keep_within()
        self.drawing.refresh_everywhere()

    def _show_whole(self) -> None:
        """The whole picture is there, or it turned out that it cannot be read."""
        state = self._services.state
        if state.picture is None:
            self._show_frame()
            return
        self.shown.set_picture(state.picture)
        self._show_picture()
        self.drawing.refresh_gesture()  # the next click snaps to the lines of the picture

    def _show_picture(self) -> None:
        """The same frame looks different: brightness and the like."""
        self.picture_item.set_picture(self.shown.pixels, self._services.state.picture_size)

    def _explain(self, text: str) -> None:
        """Next to the cursor, where it cannot be missed."""
        if self.cursor_px is not None:
            place = self.viewport().mapToGlobal(self.to_view(*self.cursor_px).toPoint())
            QToolTip.showText(place, text, self.viewport(), QRect(), _EXPLANATION_MS)

    @property
    def hint(self) -> str:
        """Return what the next click, Enter and Esc will do."""
        self._say_hint()
        return self._hint

    def _say_hint(self) -> None:
        self._hint_soon.stop()
        hint = self.camera_drag.hint or (_pan_hint() if self.pan_tool else self.editor.hint())
        if hint != self._hint:
            self._hint = hint
            self.setAccessibleDescription(hint)
            self.hintChanged.emit(hint)

    # --- loupe ----------------------------------------------------------------------------

    def set_loupe_always(self, always: bool) -> None:
        """Show the loupe also while no key is held."""
        self.loupe_always = always
        self._place_loupe()

    @property
    def _loupe_wanted(self) -> bool:
        held = self.editor.dragging or self.camera_drag.dragging
        return self.loupe_always or self._loupe_by_key or held

    def _place_loupe(self) -> None:
        px, pixels = self.cursor_px, self.shown.pixels
        half = self._services.state.half is not None
        if not self._loupe_wanted or px is None or pixels is None or half:
            self.loupe.hide()
            return
        at = self.to_view(*px)
        item = self.comparison.item_at(at.x())
        self.loupe.show_at(at, px, pixels, *item.layers, *self.camera_drag.item.layers)

    def _view_changed(self) -> None:
        self.editor.view_scale = self.view_scale
        self.comparison.view_changed()

    def set_keep_zoom(self, keep: bool) -> None:
        """Keep position and zoom when the frame changes."""
        self.keep_zoom = keep

    def set_pan(self, on: bool) -> None:
        """Let the left button pan instead of passing it to the tool."""
        if on != self.pan_tool:
            self.pan_tool = on
            self.update_cursor()
            self._say_hint()
            self.panChanged.emit(on)

    # --- actions --------------------------------------------------------------------------

    def undo(self) -> None:
        """Take back the last point of a polyline under way, put back what the mouse holds, give up
        what is waited for, or take back the last step of the frame."""
        if self.editor.drawing:
            self.key("Backspace")  # not shown
        elif self.editor.holding:
            self.key("Escape")  # not shown
        elif not self.editor.taken_first("Undo", False):  # not shown
            self._services.editing.undo()

    def redo(self) -> None:
        """Do again what was taken back last: a stretch of frames, or a step of the frame."""
        if not self.editor.taken_first("Redo", False):  # not shown
            self._services.editing.redo()

    def key(self, name: str, shift: bool = False) -> None:
        """Pass Enter, Backspace, Escape or Delete to the tool."""
        if name == "Escape" and self.pan_tool:
            self.set_pan(False)
        elif not self.editor.key(name, shift=shift) and name == "Escape":
            self.keys.put_away()

    def point_at(self, px: tuple[float, float]) -> None:
        """Move the cursor of the tool, by mouse or by keys."""
        self.cursor_px = px
        self.editor.move(px, Modifiers())
        self.drawing.refresh_gesture()
        self._say_cursor()

    @property
    def pointed_px(self) -> tuple[float, float] | None:
        """Return the place that the menu, the crosshair or the mouse is at, picture px."""
        return self._menu_px or self.keys.crosshair.px or self.cursor_px

    def comment_at(self, cursor: QPointF) -> Comment | None:
        """Return the comment whose pin is at a position of the viewport."""
        place = self.viewportTransform().inverted()[0].map(cursor)
        return self._services.review.pins.get(self.overlay_item.text_at(place))

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        event.accept()
        if self.editor.holding or self.camera_drag.dragging or self.panning:
            return  # a menu would take the release that ends it
        if event.reason() == QContextMenuEvent.Reason.Mouse:
            self._menu_px = self.to_picture(QPointF(event.pos()))
            self.editor.point_at(self._menu_px)
            self.menuWanted.emit(event.globalPos())
            self._menu_px = None
            return
        at = self.viewport().rect().center()
        if (px := self.keys.crosshair.px) is not None:
            self.editor.point_at(px)
            at = self.to_view(*px).toPoint()
        self.menuWanted.emit(self.viewport().mapToGlobal(at))

    # --- events ---------------------------------------------------------------------------

    def tool_cursor(self) -> Qt.CursorShape:
        if self._services.state.mode == "draw" and self._services.state.editable:
            return Qt.CursorShape.CrossCursor
        return Qt.CursorShape.ArrowCursor

    def mousePressEvent(self, event: QMouseEvent) -> None:
        event.accept()
        self.keys.put_away()
        if self._wants_pan(event):
            self._start_pan(event)
        elif event.button() == Qt.MouseButton.LeftButton and not self.panning:
            comment = self.comment_at(event.position())
            if comment is not None and not self.editor.drawing:
                self._services.review.commentChosen.emit(comment)
                return
            self.cursor_px = self.to_picture(event.position())
            self._services.navigator.see_whole()  # its lines are snapped to
            self.editor.press(self.cursor_px, modifiers_of(event.modifiers()))
            if self.editor.holding:
                self._say_hint()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        event.accept()
        px = self.to_picture(event.position())
        if self._wants_pan(event):
            self._start_pan(event)
        elif event.button() == Qt.MouseButton.LeftButton and not self.panning:
            # Qt sent the first click already; it is the last point, and this one only finishes.
            self.editor.double_click(px, modifiers_of(event.modifiers()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        event.accept()
        self.keys.put_away()
        px = self.to_picture(event.position())
        if self.editor.holding and not event.buttons() & Qt.MouseButton.LeftButton:
            # Another window had the release: what is held stays where it was seen last.
            self.editor.release(self.cursor_px or px, modifiers_of(event.modifiers()))
        self.cursor_px, drawn = px, self.drawing.count
        if self.panning:
            self._pan_to(event.position().toPoint())
        else:
            self.editor.move(px, modifiers_of(event.modifiers()))
        if self.editor.follows_cursor and drawn == self.drawing.count:
            self.drawing.refresh_gesture()
        elif drawn == self.drawing.count:
            self._place_loupe()
        if not self.editor.holding:
            self._say_cursor()
        elif not self._carried_on.isActive():
            self._carried_on.start()

    def _forget_cursor(self) -> None:
        self.cursor_px = None

    def _follow_cursor(self, px: tuple[float, float]) -> None:
        self.cursor_px = px
        self._place_loupe()
        self._say_cursor()

    def _say_cursor(self) -> None:
        self._carried_on.stop()
        px = self.cursor_px
        self.legend.follow(None if px is None else self.to_view(*px))
        self.cursorMoved.emit(px)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        event.accept()
        if self._ends_pan(event):
            self._end_pan()
        elif event.button() == Qt.MouseButton.LeftButton:
            self.editor.release(self.to_picture(event.position()), modifiers_of(event.modifiers()))
            if self._carried_on.isActive():
                self._say_cursor()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        tapped = self.tapped(event)
        super().keyReleaseEvent(event)
        if tapped:
            self.keys.click(modifiers_of(event.modifiers()))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.comparison.place()
        self.maps.legend.place()

    def enterEvent(self, event: QEnterEvent) -> None:
        super().enterEvent(event)
        self.update_cursor()
        # Keys should act on what the mouse is over, unless something is being typed elsewhere.
        if not isinstance(QApplication.focusWidget(), QLineEdit) and self.window().isActiveWindow():
            self.setFocus()

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        if self.keys.active:
            return  # they point; the mouse is elsewhere
        self.cursor_px = None
        self.editor.leave()
        self.drawing.refresh_gesture()
        self._say_cursor()

    def _make_held_keys(self) -> HeldKeys:
        hide, loupe, aside = self.drawing.hide_by_key, self._loupe, self._aside
        dressed, no_loupe, snap = partial(hide, False), partial(loupe, False), partial(aside, False)
        keys = {
            Qt.Key.Key_X: HeldKey(partial(hide, True), dressed, dressed),
            Qt.Key.Key_Z: HeldKey(partial(loupe, True), no_loupe, no_loupe),
            Qt.Key.Key_Comma: HeldKey(self._blink, self._end_blink, self._lose_blink),
            Qt.Key.Key_Control: HeldKey(partial(aside, True), snap, snap),
        }
        return HeldKeys(keys, self)

    def _loupe(self, shown: bool) -> None:
        self._loupe_by_key = shown
        self._place_loupe()

    def _aside(self, suspended: bool) -> None:
        """Snapping rests."""
        self.editor.hold(Modifiers(ctrl=suspended))
        self.drawing.refresh_gesture()

    def _blink(self) -> None:
        if self.comparison.hold():
            self.drawing.refresh()
        else:
            say = self._services.say
            say(tr("load a second set of cameras to blink between two (Ctrl+L)"), "info")

    def _end_blink(self) -> None:
        if self.comparison.let_go():
            self._services.camera_sources.swap_sources()
        else:
            self.drawing.refresh()

    def _lose_blink(self) -> None:
        self.comparison.let_go()
        self.drawing.refresh()


def _pan_hint() -> str:
    return join_hint((tr("PAN"), tr("drag moves the picture")), (tr("Esc takes the tool again"),))
