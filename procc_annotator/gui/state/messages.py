"""Messages that are shown once, and notices that stay until they are withdrawn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

BENT = "bent"  # the notice that paint runs beside what was clicked just now
UNSAVED = "unsaved"  # the notice that something is not on disk

Level = Literal["info", "warning", "error"]


@dataclass(frozen=True, slots=True)
class Notice:
    """A line that is so until it is withdrawn.

    Attributes:
        key: what it is about; there is one notice a key.
        level: how much it matters.
        text: one line.
    """

    key: str
    level: Level
    text: str


@dataclass(frozen=True, slots=True, eq=False)
class Message:
    """A line to the user, shown once.

    Attributes:
        key: of the notice that it is; empty for one that nothing withdraws.
        remedy: the action that may help: it asks for another place, or tries again.
    """

    text: str
    level: Level
    key: str = ""
    remedy: str = ""


def with_notice(notices: tuple[Notice, ...], notice: Notice) -> tuple[Notice, ...]:
    """The notices, with one in the place of that about the same thing, or behind the others."""
    if any(one.key == notice.key for one in notices):
        return tuple(notice if one.key == notice.key else one for one in notices)
    return (*notices, notice)


def without_notice(notices: tuple[Notice, ...], key: str) -> tuple[Notice, ...]:
    """The notices but that about one thing."""
    return tuple(one for one in notices if one.key != key)
