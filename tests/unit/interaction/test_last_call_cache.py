"""A result is given again only for the same arguments."""

from __future__ import annotations

from procc_annotator.interaction.overlay import LastCallCache


def test_the_same_arguments_give_the_very_same_result() -> None:
    join = LastCallCache(lambda *parts, end="": [*parts, end])
    first = join("a", (1, 2), end=".")
    assert join("a", (1, 2), end=".") is first
    assert join("a", (1, 3), end=".") == ["a", (1, 3), "."]
    assert join("a", (1, 2), end=".") is not first  # only the last one is kept


def test_other_keywords_are_other_arguments() -> None:
    join = LastCallCache(lambda *parts, end="": [*parts, end])
    assert join("a", end="!") == ["a", "!"]
    assert join("a") == ["a", ""]
