"""Words that several rules use."""

from __future__ import annotations

from collections.abc import Sequence


def listed(titles: Sequence[str]) -> str:
    """Titles as a sentence names them: "one", "one and two", "one, two and three"."""
    return titles[0] if len(titles) == 1 else f"{', '.join(titles[:-1])} and {titles[-1]}"
