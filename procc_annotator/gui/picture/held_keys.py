"""Keys that mean something for as long as they are held down."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent


@dataclass(frozen=True)
class HeldKey:
    """What a key does when it goes down, and when it comes up again."""

    down: Callable[[], None]
    up: Callable[[], None]


class HeldKeys:
    """Turns key events into one call when a key goes down and one when it comes up.

    The repetitions that the keyboard sends meanwhile are swallowed. A key counts only if it goes
    down without modifiers; it comes up whatever is held then.
    """

    def __init__(self, keys: dict[Qt.Key, HeldKey]) -> None:
        self._keys = keys

    def pressed(self, event: QKeyEvent) -> bool:
        """Take a press; False for a key that is none of these."""
        key = self._keys.get(Qt.Key(event.key()))
        alone = not event.modifiers() or event.key() == Qt.Key.Key_Control
        if key is None or not alone:
            return False
        event.accept()
        if not event.isAutoRepeat():
            key.down()
        return True

    def released(self, event: QKeyEvent) -> bool:
        """Take a release; False for a key that is none of these."""
        key = self._keys.get(Qt.Key(event.key()))
        if key is None:
            return False
        event.accept()
        if not event.isAutoRepeat():
            key.up()
        return True
