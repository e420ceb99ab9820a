"""The keys that choose elements: those of the field, unless the window needs them itself."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from PySide6.QtCore import QObject
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QWidget

from procc_annotator.field.model import Element, Field
from procc_annotator.gui.actions import ACTIONS
from procc_annotator.gui.gestures import HELD_KEYS
from procc_annotator.gui.keymap import NATIVE, USUAL, Keymap, chords_of
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document

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

    def __init__(self, window: QWidget, document: Document) -> None:
        super().__init__(window)
        self._window, self._document = window, document
        self._shortcuts: list[QShortcut] = []
        document.store.watch(select.field, self._make)
        document.store.watch(lambda state: state.keymap, self._take)
        self._make()

    def _take(self) -> None:
        self._make()

    def _make(self) -> None:
        for old in self._shortcuts:
            old.setEnabled(False)  # it is deleted later only
            old.deleteLater()
        self._shortcuts = []
        for name, keys in element_keys(
            self._document.state.field, self._document.state.keymap
        ).items():
            shortcut = QShortcut(keys, self._window)
            shortcut.activated.connect(
                lambda name=name: self._document.selecting.select_class(name, continues=True)
            )
            self._shortcuts.append(shortcut)
