"""The overview's tables: figures in columns, one of which is drawn as a bar."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from PySide6.QtCore import (
    QRectF,
    QSize,
    Qt,
)
from PySide6.QtGui import QPainter, QPalette
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
)

from procc_annotator.gui.panels.rows import RIGHT, Index, RowsModel, list_rows
from procc_annotator.gui.theme import blend, fixed_width, muted
from procc_annotator.translation import tr

DASH = "–"
_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_SHARE = Qt.ItemDataRole.UserRole
_SHORTEST_BAR, _BESIDE_BAR = 70, "> 99 %"


def duration(seconds: float | None) -> str:
    """A time in the two units that matter; a dash if absent."""
    if seconds is None:
        return DASH
    if seconds < 9.95:
        return tr("{seconds:.1f} s", seconds=seconds)
    whole = round(seconds)
    if whole < 60:
        return tr("{seconds} s", seconds=whole)
    if whole < 3600:
        return tr("{minutes} min {seconds:02d} s", minutes=whole // 60, seconds=whole % 60)
    minutes = round(seconds / 60)
    return tr("{hours:,} h {minutes:02d} min", hours=minutes // 60, minutes=minutes % 60)


def whole_percent(share: float | None) -> str:
    """A share in whole whole_percent; what is not all or nothing is never said to be."""
    if share is None:
        return DASH
    if 0 < share < 0.01:
        return "< 1 %"
    return "> 99 %" if 0.99 < share < 1 else f"{100 * share:.0f} %"


class FigureRow(NamedTuple):
    """One row: its texts, and how long its bar is, 0 to 1."""

    texts: tuple[str, ...]
    share: float
    tip: str = ""


class FiguresModel(RowsModel[FigureRow]):
    """The first column is words, the others are figures; one of them is drawn as a bar."""

    def __init__(self, headers: Sequence[str], tips: Sequence[str], bar: int) -> None:
        super().__init__(headers, tips, first_figure=1)
        self.bar = bar

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        row, column = self.rows[index.row()], index.column()
        if role == Qt.ItemDataRole.DisplayRole:
            return row.texts[column]
        if role == _SHARE:
            return row.share
        if role == Qt.ItemDataRole.TextAlignmentRole and column:
            return RIGHT
        if role == Qt.ItemDataRole.ToolTipRole:
            return row.tip or None
        return None


class BarDelegate(QStyledItemDelegate):
    """A bar of the row's share next to the text of one column; rows without any step back."""

    def __init__(self, view: QTableView, bar: int) -> None:
        super().__init__(view)
        self._bar = bar

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        size = super().sizeHint(option, index)
        if index.column() == self._bar:
            size.setWidth(size.width() + _SHORTEST_BAR)
        return size

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        super().paint(painter, option, index)
        if index.column() != self._bar:
            return
        share = float(index.data(_SHARE))
        palette: QPalette = option.palette
        selected = bool(option.state & QStyle.StateFlag.State_Selected)
        back = palette.color(QPalette.ColorRole.Highlight if selected else QPalette.ColorRole.Base)
        front = palette.color(
            QPalette.ColorRole.HighlightedText if selected else QPalette.ColorRole.Highlight
        )
        text = option.fontMetrics.horizontalAdvance(_BESIDE_BAR) + 12
        room = QRectF(option.rect).adjusted(6, 0, -text, 0)
        height = min(10.0, room.height() * 0.45)
        track = QRectF(room.left(), room.center().y() - height / 2, room.width(), height)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        neutral = palette.color(QPalette.ColorRole.Text) if not selected else front
        painter.setBrush(blend(back, neutral, 0.1))
        painter.drawRoundedRect(track, 2, 2)
        if share > 0:
            track.setWidth(max(3.0, track.width() * min(share, 1.0)))  # a few of many still show
            painter.setBrush(front)
            painter.drawRoundedRect(track, 2, 2)
        painter.restore()

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        if index.data(_SHARE) == 0:
            option.palette.setColor(QPalette.ColorRole.Text, muted(option.palette))


def figures_view(model: FiguresModel, name: str, what: str) -> QTableView:
    """A table on such a model; the bar's column takes the room that is left."""
    view = QTableView()
    view.setObjectName(name)
    view.setAccessibleName(what)
    view.setModel(model)
    view.setItemDelegate(BarDelegate(view, model.bar))
    view.setFont(fixed_width(view.font()))
    list_rows(view, room=7)
    view.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
    view.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
    columns = view.horizontalHeader()
    columns.setDefaultAlignment(_LEFT)
    columns.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    columns.setSectionResizeMode(model.bar, QHeaderView.ResizeMode.Stretch)
    return view


def width_needed(view: QTableView) -> int:
    """The width at which nothing of a table is cut off, in logical pixels."""
    headers = view.horizontalHeader()
    columns = range(headers.count())
    cells = sum(max(view.sizeHintForColumn(c), headers.sectionSizeHint(c)) for c in columns)
    return cells + view.verticalScrollBar().sizeHint().width() + 2 * view.frameWidth() + 4
