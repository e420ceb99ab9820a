"""What the steps of undo are called: English where files keep them, spoken where they are shown.

Titles are those of elements.
"""

from __future__ import annotations

from procc_annotator.language import said, said_count


def drawing(title: str, *, goes_on: bool = False) -> str:
    """Points of an element were clicked; ``goes_on``: behind those it had."""
    if goes_on:
        return said("continue {title}", title=said(title))
    return said("draw {title}", title=said(title))


def confirming(title: str) -> str:
    """An unconfirmed element counts from now on."""
    return said("confirm {title}", title=said(title))


def moving(title: str) -> str:
    """A point of an element, or a single place, is elsewhere."""
    return said("move {title}", title=said(title))


def moving_all(title: str) -> str:
    """An element is elsewhere as a whole."""
    return said("move all of {title}", title=said(title))


def moving_points(count: int) -> str:
    """Several points are elsewhere."""
    return said_count(count, "move {n} point", "move {n} points")


def nudging(title: str) -> str:
    """The arrows moved points of one element."""
    return said("nudge {title}", title=said(title))


def nudging_points(count: int) -> str:
    """The arrows moved points of several elements."""
    return said_count(count, "nudge {n} point", "nudge {n} points")


def inserting(title: str) -> str:
    """A line has a point more."""
    return said("insert a point in {title}", title=said(title))


def deleting(title: str) -> str:
    """An element is gone."""
    return said("delete {title}", title=said(title))


def deleting_point(number: int, title: str) -> str:
    """A point of an element is gone; the first one is 1."""
    return said("delete point {number} of {title}", number=number, title=said(title))


def deleting_points(count: int) -> str:
    """Several points are gone."""
    return said_count(count, "delete {n} point", "delete {n} points")
