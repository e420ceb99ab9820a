"""Messages that are shown once, and notices that stay until they are withdrawn."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from procc_annotator.gui.state.state import Level, Notice
from procc_annotator.gui.state.store import Store


@dataclass(frozen=True, slots=True, eq=False)
class Message:
    """A line to the user, shown once; ``key``: of the notice that it is, empty for one that nothing
    withdraws; ``remedy``: the action that may help: it asks for another place, or tries again."""

    text: str
    level: Level
    key: str = ""
    remedy: str = ""


def say(store: Store, text: str, level: Level = "info", remedy: str = "") -> None:
    """Show one line, once; ``remedy`` is the action that may help."""
    _emit(store, Message(text, level, remedy=remedy))


def notify(store: Store, key: str, text: str, level: Level = "warning", remedy: str = "") -> None:
    """Show a line that stays until it is withdrawn; it replaces an earlier one with its key."""
    notices = {notice.key: notice for notice in store.state.notices}
    store.update(notices=tuple((notices | {key: Notice(key, level, text)}).values()))
    _emit(store, Message(text, level, key, remedy))


def withdraw(store: Store, key: str) -> None:
    """Remove the notice with a key."""
    store.update(notices=tuple(notice for notice in store.state.notices if notice.key != key))


def _emit(store: Store, message: Message) -> None:
    store.when_notified(partial(store.events.message.emit, message))
