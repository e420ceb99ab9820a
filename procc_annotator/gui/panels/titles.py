"""Titles of elements, shortened below a heading and in narrow columns."""

from __future__ import annotations

from itertools import takewhile

from PySide6.QtCore import Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem

from procc_annotator.field.model import Field
from procc_annotator.gui.panels.rows import Index
from procc_annotator.translation import is_english, tr

_COMMAS = (",", "、", "，")


def short_titles(field: Field) -> dict[str, str]:
    """By class: the title without what its group says already.

    In English these are the leading words that all titles of the group share with it: below "Left
    three-point line" the "Left three-point far straight" is the "Far straight". Other languages
    bend their words and put them elsewhere; there it is a first part of words of the group: below
    "Linkes Tor" the "Linkes Tor, linker Pfosten" is the "Linker Pfosten".
    """
    groups: dict[str, list[tuple[str, str]]] = {}
    for element in field.elements:
        groups.setdefault(element.group, []).append((element.name, element.title))
    found = {}
    for group, elements in groups.items():
        leading = _leading(group, [title for _, title in elements])
        for name, title in elements:
            said, english = tr(title), " ".join(title.split()[leading:])
            rest = english if said == title else _beyond(tr(group), said)
            found[name] = f"{rest[:1].upper()}{rest[1:]}"
    return found


def _beyond(group: str, title: str) -> str:
    """Return what a title says behind a first part that has no word but the group's; else all of
    it."""
    for comma in _COMMAS:
        first, _, rest = title.partition(comma)
        if rest and set(first.split()) <= set(group.split()):
            return rest.strip()
    return title


def _leading(group: str, titles: list[str]) -> int:
    """Return how many leading words of a group all its titles share, each having words beyond
    them."""
    if len(titles) < 2:
        return 0
    columns = zip(group.split(), *(title.split()[:-1] for title in titles), strict=False)
    return sum(1 for _ in takewhile(lambda words: len(set(words)) == 1, columns))


class TitleDelegate(QStyledItemDelegate):
    """Writes titles so that near and far, left and right can be distinguished."""

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        view = option.widget
        style = view.style()
        room = style.subElementRect(QStyle.SubElement.SE_ItemViewItemText, option, view).width()
        margin = style.pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin, None, view) + 1
        option.text = elided_title(option.text, option.fontMetrics, room - 2 * margin)


def elided_title(title: str, metrics: QFontMetrics, width: int) -> str:
    """A title in so many px: the side of the field stands first, what distinguishes its parts last.

    "Right three-point far straight" becomes "Right … far straight", then "R… far straight". Other
    languages have the side anywhere: there every long word is shortened.
    """
    if not is_english():
        return _abbreviated(title, metrics, width)
    words = title.split()
    fewer = (words[1 + left_out :] for left_out in range(1, len(words) - 2))
    shorter = [title, *(" ".join((words[0], "…", *rest)) for rest in fewer)]
    if len(words) > 2:
        shorter.append(" ".join((f"{words[0][0]}…", *words[-2:])))
    for text in shorter:
        if metrics.horizontalAdvance(text) <= width:
            return text
    return metrics.elidedText(title, Qt.TextElideMode.ElideMiddle, max(width, 0))


def _abbreviated(title: str, metrics: QFontMetrics, width: int) -> str:
    """A title whose longest words give way first: "Surf. gauc. côté loin."."""
    words = title.split()
    for most in range(max(map(len, words), default=0), 1, -1):
        text = " ".join(w if len(w) <= most else f"{w[: most - 1]}." for w in words)
        if metrics.horizontalAdvance(text) <= width:
            return text
    return metrics.elidedText(title, Qt.TextElideMode.ElideMiddle, max(width, 0))
