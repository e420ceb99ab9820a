"""Commands of the store by which anything says something to the user."""

from __future__ import annotations

from procc_annotator.gui.state.messages import Level, Notice, Told, with_notice, without_notice
from procc_annotator.gui.state.store import Store


def say(store: Store, text: str, level: Level = "info", remedy: str = "") -> None:
    """Say one line, once; ``remedy`` is the action that may help."""
    store.set(told=Told(text, level, remedy=remedy))


def notify(store: Store, key: str, text: str, level: Level = "warning", remedy: str = "") -> None:
    """Say a line that holds until it is withdrawn; what was said under its key gives way."""
    notices = with_notice(store.state.notices, Notice(key, level, text))
    store.set(notices=notices, told=Told(text, level, key, remedy))


def withdraw(store: Store, key: str) -> None:
    """What was said under a key is so no more."""
    store.set(notices=without_notice(store.state.notices, key))
