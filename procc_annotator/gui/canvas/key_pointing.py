"""The keyboard points at the picture: arrows move the chosen points, or else the crosshair."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QPointF, QRectF, Qt, Signal

from procc_annotator.gui.canvas.crosshair import Crosshair, moved
from procc_annotator.gui.canvas.editor import Editor
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.gui.state.document import Document
from procc_annotator.interaction.gestures import Modifiers, Position
from procc_annotator.translation import tr, word

_RIM_PX = 48.0  # screen px at the edge of the view that the crosshair does not enter, where it can
_EDGE = 2.0  # screen px that count as out of sight
_WHAT = word(
    "crosshair: the arrows move it (Shift 0.1 px, Ctrl 10 px, Ctrl+Shift 100 px), Space clicks,"
    " Esc puts it away"
)


class KeyPointing(QObject):
    """Does with keys what the mouse does on the picture."""

    pointed = Signal(object)  # where the hand is now, picture px
    forgotten = Signal()  # it is nowhere any more

    def __init__(
        self,
        document: Document,
        view: PictureView,
        editor: Editor,
        cursor: Callable[[], Position | None],
    ) -> None:
        super().__init__(view)
        self._document, self._view, self._editor, self._cursor = document, view, editor, cursor
        self.crosshair = Crosshair()
        view.scene().addItem(self.crosshair)

    @property
    def active(self) -> bool:
        """Return whether the crosshair is on the picture."""
        return self.crosshair.px is not None

    def arrow(self, name: str, step: float) -> None:
        """Move the chosen points, or the crosshair where none is chosen, so many picture px."""
        if self._editor.nudge(name, step):
            return
        size = self._document.state.picture_size
        if size is None:
            return
        begun = self.active
        start = self.crosshair.px or self._start(size)
        self._point(moved(start, name, step, size))
        if not begun:
            self._document.say(tr(_WHAT), "info")

    def click(self, modifiers: Modifiers) -> None:
        """What a click of the mouse would do there."""
        px = self.crosshair.px
        if px is None:
            return
        self._document.walk.see_whole()  # its lines are snapped to
        self._editor.press(px, modifiers)
        self._editor.release(px, modifiers)
        self.pointed.emit(px)

    def insert(self) -> None:
        """Put a point on the line at the crosshair, or at the mouse, as Alt and a click do."""
        document, px = self._document, self.crosshair.px or self._cursor()
        if px is None:
            document.say(tr("point at a line first: with the mouse, or with the arrows"), "info")
            return
        document.selecting.set_mode("edit")
        before = document.state.annotation
        self._editor.press(px, Modifiers(alt=True))
        self._editor.release(px, Modifiers(alt=True))
        self.pointed.emit(px)
        if document.state.annotation is before:
            document.say(tr("there is no line here to put a point on"), "info")

    def put_away(self) -> None:
        """The mouse points again, or nothing does."""
        self.crosshair.put(None)

    def forget(self) -> None:
        """Other pictures come: what was pointed at is not there any more."""
        if self.active:
            self.put_away()
            self.forgotten.emit()

    def keep_within(self) -> None:
        """Another picture is shown: it may be smaller."""
        px, size = self.crosshair.px, self._document.state.picture_size
        if px is not None:
            self.crosshair.put(None if size is None else moved(px, "Left", 0.0, size))  # not shown

    # --- inside ---------------------------------------------------------------------------

    def _start(self, size: tuple[int, int]) -> Position:
        """Return where the mouse was, or the middle of what is in sight."""
        if (cursor := self._cursor()) is not None:
            return moved(cursor, "Left", 0.0, size)  # not shown
        place = self._view.place
        return moved((place.x, place.y), "Left", 0.0, size)  # not shown

    def _point(self, px: Position) -> None:
        self.crosshair.put(px)
        self._bring_into_sight(px)
        self.pointed.emit(px)

    def _bring_into_sight(self, px: Position) -> None:
        view = self._view
        at, area = view.to_view(*px), QRectF(view.viewport().rect())
        if not area.adjusted(_EDGE, _EDGE, -_EDGE, -_EDGE).contains(at):
            inner = area.adjusted(_RIM_PX, _RIM_PX, -_RIM_PX, -_RIM_PX)
            x = min(max(at.x(), inner.left()), inner.right())
            y = min(max(at.y(), inner.top()), inner.bottom())
            view.go_along(at - QPointF(x, y))


def modifiers_of(held: Qt.KeyboardModifier) -> Modifiers:
    """Keys that are held, as the tools know them."""
    if not held:  # as with nearly every move
        return Modifiers()
    return Modifiers(
        alt=bool(held & Qt.KeyboardModifier.AltModifier),
        shift=bool(held & Qt.KeyboardModifier.ShiftModifier),
        ctrl=bool(held & Qt.KeyboardModifier.ControlModifier),
    )
