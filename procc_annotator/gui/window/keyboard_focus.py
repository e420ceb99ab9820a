"""The keyboard: focus regions (F6), focus ring, keys of the canvas and of the elements."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, QTimer
from PySide6.QtGui import (
    QAction,
    QCursor,
    QKeyEvent,
    QKeySequence,
    QPainter,
    QPaintEvent,
    QRegion,
    QShortcut,
)
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QDockWidget,
    QDoubleSpinBox,
    QGraphicsView,
    QLineEdit,
    QMainWindow,
    QToolBar,
    QToolButton,
    QWidget,
)
from shiboken6 import isValid

from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.canvas.canvas_keys import beside_picture, typed_into
from procc_annotator.gui.keymap import element_keys, keys_by_place
from procc_annotator.gui.panels.widgets import LEFT_BY_ESCAPE
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import running_application

_WIDTH = 2
_MOVES = (QEvent.Type.Move, QEvent.Type.Resize, QEvent.Type.Show, QEvent.Type.Hide)
_WITHOUT = (Qt.WindowType.Popup, Qt.WindowType.ToolTip)


class FocusRing(QObject):
    """Shows a ring around the widget that has the keyboard, unless a click gave it."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self.widget: QWidget | None = None
        self._ring: _Ring | None = None
        running_application().focusChanged.connect(self._follow)

    @property
    def shown(self) -> bool:
        """Return whether the ring is in sight."""
        return self._ring is not None and not self._ring.isHidden()

    def _follow(self, _old: QWidget | None, new: QWidget | None) -> None:
        if self.widget is not None and isValid(self.widget):
            self.widget.removeEventFilter(self)
        self.widget = None
        self._remove()
        if new is not None and self._wanted(new):
            self.widget = new
            new.installEventFilter(self)
            self._ring = _Ring(new.window())
            self._stand()

    def _wanted(self, widget: QWidget) -> bool:
        """A line of text has a rim of its own; what was clicked needs no telling."""
        if QApplication.mouseButtons() != Qt.MouseButton.NoButton or typed_into(widget):
            return False
        top = widget.window()
        if top is not self._window and not self._window.isAncestorOf(top):
            return False
        if isinstance(widget, QGraphicsView):  # takes the keyboard when the mouse enters
            return not widget.underMouse()
        return top.windowType() not in _WITHOUT

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in _MOVES:
            self._stand()
        elif event.type() in (QEvent.Type.MouseButtonPress, QEvent.Type.Enter):
            self._remove()
        return False

    def _remove(self) -> None:
        if self._ring is not None and isValid(self._ring):  # a dialog takes its own along
            self._ring.hide()
            self._ring.deleteLater()
        self._ring = None

    def _stand(self) -> None:
        widget, ring = self.widget, self._ring
        if widget is None or ring is None:
            return
        window = widget.window()
        at = widget.mapTo(window, QPoint(0, 0))
        ring.setGeometry(QRect(at, widget.size()).intersected(window.rect()))
        inner = ring.rect().adjusted(_WIDTH, _WIDTH, -_WIDTH, -_WIDTH)
        ring.setMask(QRegion(ring.rect()).subtracted(QRegion(inner)))
        ring.setVisible(widget.isVisible())
        ring.raise_()


class _Ring(QWidget):
    """A frame of a colour that is seen on both themes; below its mask nothing is painted anew."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)

    def paintEvent(self, event: QPaintEvent) -> None:
        QPainter(self).fillRect(self.rect(), self.palette().link().color())


_CLICK_MS = 200  # window managers refuse to activate another window while a click is under way
_ENTER, _BACKSPACE, _ESCAPE = "Enter", "Backspace", "Escape"  # not shown
_NAMES = {
    Qt.Key.Key_Return: _ENTER,
    Qt.Key.Key_Enter: _ENTER,
    Qt.Key.Key_Backspace: _BACKSPACE,
    Qt.Key.Key_Escape: _ESCAPE,
}


class FocusReturn(QObject):
    """Routes keys to the picture.

    A click next to the picture gives the keyboard to text only: whatever else is clicked leaves the
    picture the keys that the status bar names. A number is taken by Enter and put back by Escape; a
    list is left by either, and whatever else has the keyboard by Escape. While a polyline is being
    clicked its keys mean it wherever nothing is typed.
    """

    def __init__(self, canvas: Canvas) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self._former: float | str = ""  # what was in the box when it got the keyboard
        running_application().focusChanged.connect(self._follow)

    def _follow(self, old: QWidget | None, new: QWidget | None) -> None:
        picture = self._canvas
        if new is None or new is picture or not beside_picture(new, picture):
            return
        clicked = QApplication.mouseButtons() != Qt.MouseButton.NoButton
        floating = new.window() is not picture.window()
        if floating:  # it became active, maybe after the click
            clicked |= new.window().frameGeometry().contains(QCursor.pos())
        # What goes with the keyboard in it leaves that to whatever comes next to it.
        gone = old is not None and not old.isVisible() and beside_picture(old, picture)
        if (clicked or gone) and not typed_into(new):
            if clicked:  # from now on not even for a moment
                new.setFocusPolicy(new.focusPolicy() & Qt.FocusPolicy.TabFocus)
            picture.setFocus()
            if floating:
                QTimer.singleShot(_CLICK_MS, picture, picture.activateWindow)
            return
        new.installEventFilter(self)  # one that was watched before is not watched twice
        if isinstance(new, QDoubleSpinBox):
            self._former = new.value()
        elif isinstance(new, QLineEdit):
            self._former = new.text()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if not isinstance(event, QKeyEvent) or event.type() == QEvent.Type.KeyRelease:
            return False
        what = self._meant(watched, event)
        if what is None:
            pressed = event.type() == QEvent.Type.KeyPress and event.key() == Qt.Key.Key_Escape
            focused = QApplication.focusWidget()
            if pressed and watched is focused and not typed_into(focused):
                self._canvas.setFocus()  # whatever else the key does there
            return False
        event.accept()  # before the window's actions have it
        if event.type() == QEvent.Type.KeyPress:
            what()
            self._canvas.setFocus()
        return True

    def _meant(self, widget: QObject, event: QKeyEvent) -> Callable[[], None] | None:
        """Return what a key does before the keyboard goes back; None for a key that is the
        widget's."""
        name = _NAMES.get(Qt.Key(event.key()))
        held = event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        shift = held == Qt.KeyboardModifier.ShiftModifier
        canvas = self._canvas
        if name is None or widget is not QApplication.focusWidget():
            return None  # what one widget does not want comes to those around it
        if isinstance(widget, QWidget) and not typed_into(widget) and canvas.editor.drawing:
            if not held or (shift and name == _ENTER):
                return lambda: canvas.key(name, shift)
            return None
        if held or name == _BACKSPACE:
            return None
        if isinstance(widget, QDoubleSpinBox):
            return widget.interpretText if name == _ENTER else lambda: self._put_back(widget)
        if isinstance(widget, QLineEdit) and widget.property(LEFT_BY_ESCAPE) and name == _ESCAPE:
            return lambda: self._put_back(widget)
        # The keyboard goes back from a list, and that is all.
        return (lambda: None) if isinstance(widget, QComboBox) else None

    def _put_back(self, box: QDoubleSpinBox | QLineEdit) -> None:
        if isinstance(box, QLineEdit):
            box.setText(str(self._former))
        else:
            box.setValue(float(self._former))


_BY_TAB = Qt.FocusPolicy.TabFocus


class FocusRegions:
    """Takes the keyboard from one part of a window to the next, left to right, top to bottom."""

    def __init__(self, window: QMainWindow) -> None:
        self._window = window

    def go(self, step: int) -> None:
        """On to the next part (1) or back to the one before (-1)."""
        regions = self.all()
        if not regions:
            return
        focus = QApplication.focusWidget()
        around = [r for r in regions if focus is not None and r.isAncestorOf(focus)]
        here = next((i for i, r in enumerate(regions) if r is focus or r in around), None)
        begin = (-1 if step > 0 else 0) if here is None else here
        for turn in range(1, len(regions) + 1):
            region = regions[(begin + step * turn) % len(regions)]
            target = _target(region)
            if target is not None:
                region.window().activateWindow()
                target.setFocus(Qt.FocusReason.TabFocusReason)
                return

    def all(self) -> list[QWidget]:
        """The parts in sight, in the order in which they are gone to."""
        window = self._window
        parts = (*window.findChildren(QToolBar), window.menuWidget())
        bars = [bar for bar in parts if bar is not None and bar.isVisible()]
        for bar in bars:
            _reach(bar)
        docks = [d for d in window.findChildren(QDockWidget) if not d.visibleRegion().isEmpty()]
        return sorted(
            [*bars, *docks, *self._middle()], key=lambda part: part.mapToGlobal(QPoint()).toTuple()
        )

    def _middle(self) -> list[QWidget]:
        """The picture, the strip below it, and whatever else is one above the other there."""
        centre = self._window.centralWidget()
        if centre is None:
            return []
        direct = Qt.FindChildOption.FindDirectChildrenOnly
        parts = [w for w in centre.findChildren(QWidget, options=direct) if w.isVisible()]
        return [part for part in parts if _target(part) is not None]


def _reach(bar: QWidget) -> None:
    """Qt leaves the buttons of a bar to the mouse."""
    for button in bar.findChildren(QToolButton):
        if button.focusPolicy() == Qt.FocusPolicy.NoFocus and button.defaultAction() is not None:
            button.setFocusPolicy(_BY_TAB)


def _target(region: QWidget) -> QWidget | None:
    """Return what had the keyboard there last, or else what is first."""
    if _takes(region):
        return region
    last = region.focusWidget()
    if last is not None and _takes(last):
        return last
    taking = [widget for widget in region.findChildren(QWidget) if _takes(widget)]
    return min(taking, key=lambda w: w.mapTo(region, QPoint(0, 0)).toTuple()[::-1], default=None)


def _takes(widget: QWidget) -> bool:
    reachable = bool(widget.focusPolicy() & _BY_TAB)
    return reachable and widget.isVisible() and widget.isEnabled()


class DigitRow(QObject):
    """Has the keys of the digits call what digits call, whatever they write."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        window.installEventFilter(self)  # keys come here that no text field wanted

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if not isinstance(event, QKeyEvent) or event.type() == QEvent.Type.KeyRelease:
            return False
        keys = keys_by_place(event)
        called = self._called_by(keys) if keys else None
        if called is None:
            return False
        event.accept()  # as an override: no shortcut is looked for by what the key writes
        if event.type() == QEvent.Type.KeyPress and not event.isAutoRepeat():
            if isinstance(called, QAction):
                called.trigger()
            else:
                called.activated.emit()
        return True

    def _called_by(self, keys: str) -> QAction | QShortcut | None:
        wanted = QKeySequence(keys)
        for shortcut in self._window.findChildren(QShortcut):
            if shortcut.isEnabled() and shortcut.key() == wanted:
                return shortcut
        actions = self._window.actions()
        return next((a for a in actions if a.isEnabled() and wanted in a.shortcuts()), None)


class ElementShortcuts(QObject):
    """The keys of a window that choose the elements of the field on screen."""

    def __init__(self, window: QWidget, services: Services) -> None:
        super().__init__(window)
        self._window, self._services = window, services
        self._shortcuts: list[QShortcut] = []
        services.store.watch(lambda s: (s.field, s.keymap), self._make)
        self._make()

    def _make(self) -> None:
        for old in self._shortcuts:
            old.setEnabled(False)  # it is deleted later only
            old.deleteLater()
        self._shortcuts = []
        for name, keys in element_keys(
            self._services.state.field, self._services.state.keymap
        ).items():
            shortcut = QShortcut(keys, self._window)
            shortcut.activated.connect(
                lambda name=name: self._services.selection.select_class(name, continues=True)
            )
            self._shortcuts.append(shortcut)
