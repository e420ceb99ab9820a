"""Commands of the store that show a message to the user."""

from __future__ import annotations

from functools import partial

from procc_annotator.gui.state.messages import Level, Message, Notice, with_notice, without_notice
from procc_annotator.gui.state.store import Store


def say(store: Store, text: str, level: Level = "info", remedy: str = "") -> None:
    """Show one line, once; ``remedy`` is the action that may help."""
    _emit(store, Message(text, level, remedy=remedy))


def notify(store: Store, key: str, text: str, level: Level = "warning", remedy: str = "") -> None:
    """Show a line that stays until it is withdrawn; it replaces an earlier one with its key."""
    store.update(notices=with_notice(store.state.notices, Notice(key, level, text)))
    _emit(store, Message(text, level, key, remedy))


def withdraw(store: Store, key: str) -> None:
    """Remove the notice with a key."""
    store.update(notices=without_notice(store.state.notices, key))


def _emit(store: Store, message: Message) -> None:
    store.when_notified(partial(store.events.message.emit, message))
