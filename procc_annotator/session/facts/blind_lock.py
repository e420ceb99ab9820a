"""Locking a dataset to blind mode: who did it, who took it back, and when; written as JSON."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass

import msgspec

SETTING = "blind lock"  # what it is kept under with the dataset


@dataclass(frozen=True, slots=True)
class LockEvent:
    """The dataset was locked to blind mode, or unlocked.

    Attributes:
        time: seconds since 1970, UTC.
    """

    locked: bool
    author: str
    time: float


def read_events(text: str | None) -> tuple[LockEvent, ...]:
    """What happened, oldest first. A text that cannot be read is a lock by nobody known: whoever
    may not see the fit must not come to see it through a damaged entry."""
    if text is None:
        return ()
    try:
        return tuple(msgspec.json.decode(text, type=list[LockEvent]))
    except msgspec.DecodeError:
        return (LockEvent(True, "", 0.0),)


def write_events(events: Sequence[LockEvent]) -> str:
    """The text that `read_events` reads."""
    return json.dumps([asdict(event) for event in events], ensure_ascii=False)


def lock_of(events: Sequence[LockEvent]) -> LockEvent | None:
    """The lock that holds now, if one does."""
    return events[-1] if events and events[-1].locked else None
