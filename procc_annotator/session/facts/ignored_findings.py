"""Findings of the label check that somebody looked at and let be: how a dataset remembers them."""

from __future__ import annotations

from collections.abc import Iterable

# One setting a finding, so that two windows that ignore at the same time lose nothing.
SETTING = "ignored finding "


def ignored_keys(settings: Iterable[str]) -> dict[str, frozenset[str]]:
    """Frame -> the keys of its findings that are ignored.

    Args:
        settings: names of a dataset's settings that are set.
    """
    found: dict[str, set[str]] = {}
    for setting in settings:
        if setting.startswith(SETTING):
            key, _, frame = setting.removeprefix(SETTING).partition(" ")
            found.setdefault(frame, set()).add(key)
    return {frame: frozenset(keys) for frame, keys in found.items()}
