"""The keys that choose elements: those of the field, unless the window needs them itself."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache

from PySide6.QtCore import QObject
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QWidget

from procc_annotator.field.model import Element, Field
from procc_annotator.gui.actions import ACTIONS
from procc_annotator.gui.gestures import HELD_KEYS
from procc_annotator.gui.state.document import Document

_Chords = tuple[str, ...]

_PORTABLE = QKeySequence.SequenceFormat.PortableText
NATIVE = QKeySequence.SequenceFormat.NativeText


def element_keys(field: Field) -> Mapping[str, QKeySequence]:
    """Class -> the keys that choose it; nothing of elements whose keys mean something else.

    A key that begins a sequence of another element's belongs to the one that comes first in the
    field: Qt would wait for ever whether more is to come.
    """
    return _keys_of(field.elements)


def key_text(field: Field, class_name: str) -> str:
    """The keys of a class as people write them; "" where there are none."""
    keys = element_keys(field).get(class_name)
    return keys.toString(NATIVE) if keys is not None else ""


class ElementShortcuts(QObject):
    """The keys of a window that choose the elements of the field on screen."""

    def __init__(self, window: QWidget, document: Document) -> None:
        super().__init__(window)
        self._window, self._document = window, document
        self._shortcuts: list[QShortcut] = []
        document.fieldChanged.connect(self._make)
        self._make()

    def _make(self) -> None:
        for old in self._shortcuts:
            old.setEnabled(False)  # it is deleted later only
            old.deleteLater()
        self._shortcuts = []
        for name, keys in element_keys(self._document.field).items():
            shortcut = QShortcut(keys, self._window)
            shortcut.activated.connect(lambda name=name: self._document.select_class(name))
            self._shortcuts.append(shortcut)


@lru_cache(maxsize=4)
def _keys_of(elements: tuple[Element, ...]) -> Mapping[str, QKeySequence]:
    found: dict[str, QKeySequence] = {}
    whole = set(_own_keys())
    begun = {beginning for chords in whole for beginning in _beginnings(chords)}
    for element in elements:
        chords = _chords(element.shortcut)
        if not chords or chords in begun or not whole.isdisjoint(_beginnings(chords)):
            continue
        whole.add(chords)
        begun.update(_beginnings(chords))
        found[element.name] = QKeySequence(element.shortcut)
    return found


def _beginnings(chords: _Chords) -> list[_Chords]:
    """All that a sequence begins with, itself included."""
    return [chords[: i + 1] for i in range(len(chords))]


def _chords(text: str) -> _Chords:
    """The chords of a sequence in Qt's own words; () for keys that Qt does not know."""
    written = QKeySequence(text).toString(_PORTABLE)
    return tuple(written.split(", ")) if written else ()


@cache
def _own_keys() -> frozenset[_Chords]:
    """What the window's actions are called by, and what means something while it is held."""
    given = [key for spec in ACTIONS for key in spec.keys]
    return frozenset(_chords(key) for key in (*given, *HELD_KEYS))
