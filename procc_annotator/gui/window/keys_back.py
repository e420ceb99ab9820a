"""The keyboard goes back to the picture once something next to it has been said."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtGui import QCursor, QKeyEvent
from PySide6.QtWidgets import QApplication, QComboBox, QDoubleSpinBox, QLineEdit, QWidget

from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.canvas.held_keys import beside_picture, typed_into
from procc_annotator.gui.panels.widgets import LEFT_BY_ESCAPE

_CLICK_MS = 200  # window managers refuse to activate another window while a click is under way
_ENTER, _BACKSPACE, _ESCAPE = "Enter", "Backspace", "Escape"  # not shown
_NAMES = {
    Qt.Key.Key_Return: _ENTER,
    Qt.Key.Key_Enter: _ENTER,
    Qt.Key.Key_Backspace: _BACKSPACE,
    Qt.Key.Key_Escape: _ESCAPE,
}


class KeysBack(QObject):
    """Routes keys to the picture.

    A click next to the picture gives the keyboard to text only: whatever else is clicked leaves the
    picture the keys that the status bar names. A number is taken by Enter and put back by Escape;
    a list is left by either. While a polyline is being clicked its keys mean it wherever nothing is
    typed.
    """

    def __init__(self, canvas: Canvas) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self._former: float | str = ""  # what was in the box when it got the keyboard
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self._follow)

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
        return _nothing if isinstance(widget, QComboBox) else None

    def _put_back(self, box: QDoubleSpinBox | QLineEdit) -> None:
        if isinstance(box, QLineEdit):
            box.setText(str(self._former))
        else:
            box.setValue(float(self._former))


def _nothing() -> None:
    """The keyboard goes back, and that is all."""
