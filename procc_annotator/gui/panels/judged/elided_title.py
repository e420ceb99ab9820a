"""Titles of elements in a narrow column: whole words go, those first that say the least."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem


class TitleDelegate(QStyledItemDelegate):
    """Writes titles so that near and far, left and right can be told apart."""

    def initStyleOption(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        super().initStyleOption(option, index)
        view = option.widget
        style = view.style()
        room = style.subElementRect(QStyle.SubElement.SE_ItemViewItemText, option, view).width()
        margin = style.pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin, None, view) + 1
        option.text = elided_title(option.text, option.fontMetrics, room - 2 * margin)


def elided_title(title: str, metrics: QFontMetrics, width: int) -> str:
    """A title in so many px: the side of the field stands first, what tells its parts apart last.

    "Right three-point far straight" becomes "Right … far straight", then "R… far straight".
    """
    words = title.split()
    fewer = (words[1 + left_out :] for left_out in range(1, len(words) - 2))
    shorter = [title, *(" ".join((words[0], "…", *rest)) for rest in fewer)]
    if len(words) > 2:
        shorter.append(" ".join((f"{words[0][0]}…", *words[-2:])))
    for text in shorter:
        if metrics.horizontalAdvance(text) <= width:
            return text
    return metrics.elidedText(title, Qt.TextElideMode.ElideMiddle, max(width, 0))
