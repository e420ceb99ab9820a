"""What the steps of undo are called: English where files keep them, spoken where they are shown.

Titles are those of elements.
"""

from __future__ import annotations

from procc_annotator.language import translatable, translatable_count


def drawing(title: str, *, goes_on: bool = False) -> str:
    """Points of an element were clicked; ``is_resuming``: behind those it had."""
    if goes_on:
        return translatable("continue {title}", title=translatable(title))
    return translatable("draw {title}", title=translatable(title))


def confirming(title: str) -> str:
    """An unconfirmed element counts from now on."""
    return translatable("confirm {title}", title=translatable(title))


def moving(title: str) -> str:
    """A point of an element, or a single place, is elsewhere."""
    return translatable("move {title}", title=translatable(title))


def moving_all(title: str) -> str:
    """An element is elsewhere as a whole."""
    return translatable("move all of {title}", title=translatable(title))


def moving_points(count: int) -> str:
    """Several points are elsewhere."""
    return translatable_count(count, "move {n} point", "move {n} points")


def nudging(title: str) -> str:
    """The arrows moved points of one element."""
    return translatable("nudge {title}", title=translatable(title))


def nudging_points(count: int) -> str:
    """The arrows moved points of several elements."""
    return translatable_count(count, "nudge {n} point", "nudge {n} points")


def inserting(title: str) -> str:
    """A line has a point more."""
    return translatable("insert a point in {title}", title=translatable(title))


def deleting(title: str) -> str:
    """An element is gone."""
    return translatable("delete {title}", title=translatable(title))


def deleting_point(number: int, title: str) -> str:
    """A point of an element is gone; the first one is 1."""
    return translatable("delete point {number} of {title}", number=number, title=translatable(title))


def deleting_points(count: int) -> str:
    """Several points are gone."""
    return translatable_count(count, "delete {n} point", "delete {n} points")
