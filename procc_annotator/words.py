"""Words for how many there are, and for which: every plural is made here."""

from __future__ import annotations

from collections.abc import Sequence

_NAMED = 5


def count_of(count: int, thing: str, several: str = "", *, thousands: str = "") -> str:
    """``1 frame``, ``2 frames``, or what is to be said of ``several``; thousands: set apart by."""
    return f"{count:{thousands}} {thing if count == 1 else several or f'{thing}s'}"


def first_of(names: Sequence[str]) -> str:
    """The first few of many names: ``a, b, c, d, e, ...``."""
    return ", ".join(names[:_NAMED]) + (", ..." if len(names) > _NAMED else "")


def all_of(names: Sequence[str]) -> str:
    """Names as a sentence names them: "one", "one and two", "one, two and three"."""
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def listed(names: Sequence[str], thing: str, several: str = "") -> str:
    """How many there are and the first few of them: ``2 frames (a, b)``."""
    return f"{count_of(len(names), thing, several)} ({first_of(names)})"
