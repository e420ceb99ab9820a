"""Commands of the store by which anything says something to the user."""

from __future__ import annotations

from procc_annotator.gui.state.notices import Level, Notice, Told, with_notice, without_notice
from procc_annotator.gui.state.store import Store


def say(store: Store, text: str, level: Level = "info") -> None:
    """Say one line, once."""
    store.set(told=Told(text, level))


def notify(store: Store, key: str, text: str, level: Level = "warning") -> None:
    """Say a line that holds until it is withdrawn; what was said under its key gives way."""
    notices = with_notice(store.state.notices, Notice(key, level, text))
    store.set(notices=notices, told=Told(text, level, key))


def withdraw(store: Store, key: str) -> None:
    """What was said under a key is so no more."""
    store.set(notices=without_notice(store.state.notices, key))
