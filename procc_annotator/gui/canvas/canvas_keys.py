"""Keys on the canvas: a crosshair moved by the arrows, and keys that act while they are held."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QPainter, QPen
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDockWidget,
    QGraphicsItem,
    QLineEdit,
    QPlainTextEdit,
    QStyleOptionGraphicsItem,
    QTextEdit,
    QWidget,
)

from procc_annotator.gui.canvas.editor import Editor
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import running_application
from procc_annotator.interaction.gestures import ARROWS, Modifiers, Position
from procc_annotator.interaction.palette import HALO, OUTLINE
from procc_annotator.translation import tr, word

_ARM, _GAP = 15.0, 4.0  # screen px
_BACKGROUND_WIDTH, _WIDTH = 4.0, 1.6
_ABOVE_ALL = 1000.0
_HALF_PIXEL = 0.5  # pixel (0, 0) is the scene's square from (0, 0) to (1, 1)


class Crosshair(QGraphicsItem):
    """The cursor of the keys; hidden while the mouse points.

    Attributes:
        px: its place in picture px; None while the mouse points.
    """

    def __init__(self) -> None:
        super().__init__()
        self.px: Position | None = None
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemIgnoresTransformations)
        self.setZValue(_ABOVE_ALL)
        self.hide()

    def put(self, px: Position | None) -> None:
        """Stand at a place of the picture, or go."""
        self.px = px
        self.setVisible(px is not None)
        if px is not None:
            self.setPos(px[0] + _HALF_PIXEL, px[1] + _HALF_PIXEL)

    def boundingRect(self) -> QRectF:
        reach = _ARM + _BACKGROUND_WIDTH
        return QRectF(-reach, -reach, 2 * reach, 2 * reach)

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: QWidget | None = None
    ) -> None:
        for colour, width in ((OUTLINE, _BACKGROUND_WIDTH), (HALO, _WIDTH)):
            painter.setPen(
                QPen(QColor(colour), width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap)
            )
            for dx, dy in ARROWS.values():
                painter.drawLine(QPointF(dx * _GAP, dy * _GAP), QPointF(dx * _ARM, dy * _ARM))


def moved(px: Position, arrow: str, step: float, size: tuple[int, int]) -> Position:
    """Move a position by ``step`` picture px, within the picture."""
    dx, dy = ARROWS[arrow]
    x, y = px[0] + dx * step, px[1] + dy * step
    return min(max(x, 0.0), size[0] - 1.0), min(max(y, 0.0), size[1] - 1.0)


_TYPED_INTO = (QLineEdit, QTextEdit, QPlainTextEdit, QAbstractSpinBox)
# The key comes up elsewhere, though the widget keeps the focus of its window.
_AWAY = (Qt.FocusReason.PopupFocusReason, Qt.FocusReason.ActiveWindowFocusReason)


@dataclass(frozen=True)
class HeldKey:
    """Callbacks of a key: pressed, released, and released unseen (the focus left)."""

    down: Callable[[], None]
    up: Callable[[], None]
    lost: Callable[[], None]


class HeldKeys(QObject):
    """Turns key events into one call when a key goes down and one when it comes up.

    It does not matter which part of the window has the focus, unless something is typed there.
    The repetitions that the keyboard sends meanwhile are swallowed. A key counts only if it goes
    down without modifiers; it comes up whatever is held then.
    """

    def __init__(self, keys: dict[Qt.Key, HeldKey], picture: QWidget) -> None:
        super().__init__(picture)
        self._keys = keys
        self._picture = picture
        self._down: set[Qt.Key] = set()
        picture.installEventFilter(self)
        running_application().focusChanged.connect(self._follow)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent):
            if event.type() == QEvent.Type.KeyPress:
                return self._pressed(event)
            if event.type() == QEvent.Type.KeyRelease:
                return self._released(event)
        elif isinstance(event, QFocusEvent) and event.lostFocus() and event.reason() in _AWAY:
            self._lose()
        return False

    def _follow(self, _old: QWidget | None, new: QWidget | None) -> None:
        """Keys go to another widget; one that was watched before is not watched twice."""
        if new is not None and beside_picture(new, self._picture) and not typed_into(new):
            new.installEventFilter(self)
        else:
            self._lose()

    def _pressed(self, event: QKeyEvent) -> bool:
        """Take a press; False for a key that is none of these."""
        key = Qt.Key(event.key())
        alone = not event.modifiers() or key == Qt.Key.Key_Control
        if key not in self._keys or not alone or typed_into(QApplication.focusWidget()):
            return False  # what a text field does not want comes to the widgets around it
        event.accept()
        if not event.isAutoRepeat():
            self._down.add(key)
            self._keys[key].down()
        return True

    def _released(self, event: QKeyEvent) -> bool:
        """Take a release; False for a key that is none of these."""
        key = Qt.Key(event.key())
        if key not in self._keys:
            return False
        event.accept()
        if not event.isAutoRepeat():
            self._down.discard(key)
            self._keys[key].up()
        return True

    def _lose(self) -> None:
        """No one will say when the keys that are down come up."""
        down, self._down = self._down, set()
        for key in down:
            self._keys[key].lost()


def beside_picture(widget: QWidget, picture: QWidget) -> bool:
    """Return whether a widget is in the window of a picture, or in a panel that floats above it."""
    window, own = widget.window(), picture.window()
    return window is own or (isinstance(window, QDockWidget) and window.parent() is own)


def typed_into(widget: QWidget | None) -> bool:
    """Return whether keys become text there."""
    return isinstance(widget, _TYPED_INTO) or (
        isinstance(widget, QComboBox) and widget.isEditable()
    )


_RIM_PX = 48.0  # screen px at the edge of the view that the crosshair does not enter, where it can
_EDGE = 2.0  # screen px that count as out of sight
_WHAT = word(
    "crosshair: the arrows move it (Shift 0.1 px, Ctrl 10 px, Ctrl+Shift 100 px), Space clicks,"
    " Esc puts it away"
)


class KeyPointing(QObject):
    """Does with keys what the mouse does on the picture."""

    pointed = Signal(object)  # position of the crosshair, picture px
    forgotten = Signal()  # it is nowhere any more

    def __init__(
        self,
        services: Services,
        view: PictureView,
        editor: Editor,
        cursor: Callable[[], Position | None],
    ) -> None:
        super().__init__(view)
        self._services, self._view, self._editor, self._cursor = services, view, editor, cursor
        self.crosshair = Crosshair()
        view.scene().addItem(self.crosshair)

    @property
    def active(self) -> bool:
        """Return whether the crosshair is on the picture."""
        return self.crosshair.px is not None

    def arrow(self, name: str, step: float) -> None:
        """Move the chosen points, or without any the crosshair, by ``step`` picture px."""
        if self._editor.nudge(name, step):
            return
        size = self._services.state.picture_size
        if size is None:
            return
        begun = self.active
        start = self.crosshair.px or self._start(size)
        self._point(moved(start, name, step, size))
        if not begun:
            self._services.say(tr(_WHAT), "info")

    def click(self, modifiers: Modifiers) -> None:
        """Click at the crosshair."""
        px = self.crosshair.px
        if px is None:
            return
        self._services.navigator.see_whole()  # its lines are snapped to
        self._editor.press(px, modifiers)
        self._editor.release(px, modifiers)
        self.pointed.emit(px)

    def insert(self) -> None:
        """Put a point on the line at the crosshair, or at the mouse, as Alt and a click do."""
        services, px = self._services, self.crosshair.px or self._cursor()
        if px is None:
            services.say(tr("point at a line first: with the mouse, or with the arrows"), "info")
            return
        services.selection.set_mode("edit")
        before = services.state.annotation
        self._editor.press(px, Modifiers(alt=True))
        self._editor.release(px, Modifiers(alt=True))
        self.pointed.emit(px)
        if services.state.annotation is before:
            services.say(tr("there is no line here to put a point on"), "info")

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
        px, size = self.crosshair.px, self._services.state.picture_size
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
