"""The row of digits is found by its place: on some keyboards it writes other things.

French and Belgian keyboards write digits with Shift only, so that a bare digit would call nothing;
German and Swiss ones write "/" with Shift and 7, which would call two things, hence neither.
"""

from __future__ import annotations

import sys

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QKeyEvent, QKeySequence, QShortcut
from PySide6.QtWidgets import QWidget

# Codes of the keys 1 to 9 and 0 from left to right: evdev's plus 8 (X11, Wayland), those of
# Windows, and macOS's virtual keys.
_X11 = tuple(range(10, 20))
_WINDOWS = tuple(range(2, 12))
_MAC = (0x12, 0x13, 0x14, 0x15, 0x17, 0x16, 0x1A, 0x1C, 0x19, 0x1D)
_DIGITS = "1234567890"
_PLAIN = Qt.KeyboardModifier.NoModifier
_SHIFT = Qt.KeyboardModifier.ShiftModifier


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


def keys_by_place(event: QKeyEvent) -> str:
    """``7`` or ``Shift+7`` for the key that is the seventh digit's; "" for other keys, and where
    what it writes is that digit anyway."""
    held = event.modifiers()
    if held not in (_PLAIN, _SHIFT):
        return ""
    if sys.platform == "darwin":
        codes, code = _MAC, event.nativeVirtualKey()
    else:
        codes = _WINDOWS if sys.platform == "win32" else _X11
        code = event.nativeScanCode()
    if code not in codes:
        return ""
    digit = _DIGITS[codes.index(code)]
    if held == _SHIFT:
        return f"Shift+{digit}"  # not shown
    return "" if event.text() == digit else digit
