"""Keys that mean something for as long as they are held down."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QFocusEvent, QKeyEvent
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDockWidget,
    QLineEdit,
    QPlainTextEdit,
    QTextEdit,
    QWidget,
)

_TYPED_INTO = (QLineEdit, QTextEdit, QPlainTextEdit, QAbstractSpinBox)
# The key comes up elsewhere, though the widget keeps the focus of its window.
_AWAY = (Qt.FocusReason.PopupFocusReason, Qt.FocusReason.ActiveWindowFocusReason)


@dataclass(frozen=True)
class HeldKey:
    """What a key does when it goes down, when it comes up again, and when no one sees that."""

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
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self._follow)

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
