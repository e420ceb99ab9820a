"""Words of errors about field files: what was meant, and what of a file can be shown."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

_MAX_SUGGESTION_LENGTH = 60


def did_you_mean(word: object, known: Iterable[str]) -> str:
    """What was meant by an unknown word, to end an error with; "" where nothing is near."""
    # Comparing takes time by the square of the length, and both sides may come from the file.
    if not isinstance(word, str) or len(word) > _MAX_SUGGESTION_LENGTH:
        return ""
    short = [name for name in known if len(name) <= _MAX_SUGGESTION_LENGTH]
    close = difflib.get_close_matches(word, short, n=1)
    return f"; did you mean {close[0]!r}?" if close else ""


def short_repr(value: object) -> str:
    """A value of the file in an error message; never one that is itself too large to be shown."""
    if isinstance(value, dict | list):
        return "a table" if isinstance(value, dict) else "a list"
    if isinstance(value, int) and abs(value) >= 1 << 64:
        return "a far larger number"
    text = repr(value[: _MAX_SUGGESTION_LENGTH + 1] if isinstance(value, str) else value)
    return text if len(text) <= _MAX_SUGGESTION_LENGTH + 2 else f"{text[: _MAX_SUGGESTION_LENGTH - 3]}..."


def printable_place(place: str) -> str:
    """Keys of a file may hold characters that a terminal would obey; and be of any length."""
    short = place if len(place) <= 3 * _MAX_SUGGESTION_LENGTH else f"{place[: 3 * _MAX_SUGGESTION_LENGTH]}..."
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in short)
