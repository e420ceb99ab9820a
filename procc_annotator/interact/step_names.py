"""What the steps of undo are called: English where files keep them, spoken where they are shown.

Titles are those of elements.
"""

from __future__ import annotations

from procc_annotator.language import kept, tr, tr_count


def drawing(title: str, *, goes_on: bool = False) -> str:
    """Points of an element were clicked; ``goes_on``: behind those it had."""
    if goes_on:
        return kept(lambda: tr("continue {title}", title=tr(title)))
    return kept(lambda: tr("draw {title}", title=tr(title)))


def confirming(title: str) -> str:
    """An unconfirmed element counts from now on."""
    return kept(lambda: tr("confirm {title}", title=tr(title)))


def moving(title: str) -> str:
    """A point of an element, or a single place, is elsewhere."""
    return kept(lambda: tr("move {title}", title=tr(title)))


def moving_all(title: str) -> str:
    """An element is elsewhere as a whole."""
    return kept(lambda: tr("move all of {title}", title=tr(title)))


def moving_points(count: int) -> str:
    """Several points are elsewhere."""
    return kept(lambda: tr_count(count, "move {n} point", "move {n} points"))


def nudging(title: str) -> str:
    """The arrows moved points of one element."""
    return kept(lambda: tr("nudge {title}", title=tr(title)))


def nudging_points(count: int) -> str:
    """The arrows moved points of several elements."""
    return kept(lambda: tr_count(count, "nudge {n} point", "nudge {n} points"))


def inserting(title: str) -> str:
    """A line has a point more."""
    return kept(lambda: tr("insert a point in {title}", title=tr(title)))


def deleting(title: str) -> str:
    """An element is gone."""
    return kept(lambda: tr("delete {title}", title=tr(title)))


def deleting_point(number: int, title: str) -> str:
    """A point of an element is gone; the first one is 1."""
    return kept(lambda: tr("delete point {number} of {title}", number=number, title=tr(title)))


def deleting_points(count: int) -> str:
    """Several points are gone."""
    return kept(lambda: tr_count(count, "delete {n} point", "delete {n} points"))
