"""Keys of the elements: those of the field, and the digit row of any keyboard layout."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from functools import lru_cache

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QKeyEvent, QKeySequence, QShortcut
from PySide6.QtWidgets import QWidget

from procc_annotator.field.model import Element, Field
from procc_annotator.gui.actions import ACTIONS
from procc_annotator.gui.keymap import HELD_KEYS, NATIVE, USUAL, Keymap, chords_of
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.services import Services

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


_Chords = tuple[str, ...]


def element_keys(field: Field, keymap: Keymap = USUAL) -> Mapping[str, QKeySequence]:
    """Class -> the keys that choose it; nothing of elements whose keys mean something else.

    A key that begins a sequence of another element's belongs to the one that comes first in the
    field: Qt would wait forever whether more is to come.
    """
    return _keys_of(field.elements, keymap)


@lru_cache(maxsize=8)
def _keys_of(elements: tuple[Element, ...], keymap: Keymap) -> Mapping[str, QKeySequence]:
    found: dict[str, QKeySequence] = {}
    given = [key for spec in ACTIONS for key in keymap.of_action(spec)]
    whole = {chords_of(key) for key in (*given, *HELD_KEYS)}
    begun = {beginning for chords in whole for beginning in _beginnings(chords)}
    for element in elements:
        keys = keymap.of_element(element)
        chords = chords_of(keys)
        if not chords or chords in begun or not whole.isdisjoint(_beginnings(chords)):
            continue
        whole.add(chords)
        begun.update(_beginnings(chords))
        found[element.name] = QKeySequence(keys)
    return found


def key_text(field: Field, class_name: str, keymap: Keymap = USUAL) -> str:
    """The keys of a class as people write them; "" where there are none."""
    keys = element_keys(field, keymap).get(class_name)
    return keys.toString(NATIVE) if keys is not None else ""


def _beginnings(chords: _Chords) -> list[_Chords]:
    """All that a sequence begins with, itself included."""
    return [chords[: i + 1] for i in range(len(chords))]


class ElementShortcuts(QObject):
    """The keys of a window that choose the elements of the field on screen."""

    def __init__(self, window: QWidget, services: Services) -> None:
        super().__init__(window)
        self._window, self._services = window, services
        self._shortcuts: list[QShortcut] = []
        services.store.watch(select.field, self._make)
        services.store.watch(lambda state: state.keymap, self._take)
        self._make()

    def _take(self) -> None:
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
