"""The overview's tables: figures in columns, one of which is drawn as a bar."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QPersistentModelIndex,
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

from procc_annotator.gui.panels.common import blend, muted
from procc_annotator.gui.theme import fixed_width

DASH = "–"
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_SHARE = Qt.ItemDataRole.UserRole
_SHORTEST_BAR, _BESIDE_BAR = 70, "> 99 %"

Index = QModelIndex | QPersistentModelIndex


def duration(seconds: float | None) -> str:
    """A time in the two units that matter; a dash where there is none."""
    if seconds is None:
        return DASH
    if seconds < 9.95:
        return f"{seconds:.1f} s"
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02d} s"
    minutes = round(seconds / 60)
    return f"{minutes // 60:,} h {minutes % 60:02d} min"


def percent(share: float | None) -> str:
    """A share in whole percent; what is not all or nothing is never said to be."""
    if share is None:
        return DASH
    if 0 < share < 0.01:
        return "< 1 %"
    return "> 99 %" if 0.99 < share < 1 else f"{100 * share:.0f} %"


class Line(NamedTuple):
    """One row: its texts, and how long its bar is, 0 to 1."""

    texts: tuple[str, ...]
    share: float
    tip: str = ""


class FiguresModel(QAbstractTableModel):
    """Rows replaced as a whole; the first column is words, the others are figures."""

    def __init__(self, headers: Sequence[str], tips: Sequence[str], bar: int) -> None:
        super().__init__()
        self._headers, self._tips, self.bar = headers, tips, bar
        self.lines: tuple[Line, ...] = ()

    def show_lines(self, lines: Sequence[Line]) -> None:
        """Replace the rows; the view keeps its place when their number stays."""
        if len(lines) == len(self.lines):
            self.lines = tuple(lines)
            if lines:
                last = self.index(len(lines) - 1, len(self._headers) - 1)
                self.dataChanged.emit(self.index(0, 0), last)
            return
        self.beginResetModel()
        self.lines = tuple(lines)
        self.endResetModel()

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 (Qt's signature)
        return 0 if parent.isValid() else len(self.lines)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self._headers)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation is Qt.Orientation.Horizontal:
            if role == Qt.ItemDataRole.DisplayRole:
                return self._headers[section]
            if role == Qt.ItemDataRole.ToolTipRole:
                return self._tips[section]
            if role == Qt.ItemDataRole.TextAlignmentRole:
                return _RIGHT if section else _LEFT
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        line, column = self.lines[index.row()], index.column()
        if role == Qt.ItemDataRole.DisplayRole:
            return line.texts[column]
        if role == _SHARE:
            return line.share
        if role == Qt.ItemDataRole.TextAlignmentRole and column:
            return _RIGHT
        if role == Qt.ItemDataRole.ToolTipRole:
            return line.tip or None
        return None


class BarDelegate(QStyledItemDelegate):
    """A bar of the row's share beside the text of one column; rows without any step back."""

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
    view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    view.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
    view.setTabKeyNavigation(False)
    view.setShowGrid(False)
    view.setWordWrap(False)
    view.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
    rows = view.verticalHeader()
    rows.hide()
    rows.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
    rows.setDefaultSectionSize(view.fontMetrics().height() + 7)
    columns = view.horizontalHeader()
    columns.setHighlightSections(False)
    columns.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    columns.setSectionResizeMode(model.bar, QHeaderView.ResizeMode.Stretch)
    return view


def width_needed(view: QTableView) -> int:
    """The width at which nothing of a table is cut off, in logical pixels."""
    headers = view.horizontalHeader()
    columns = range(headers.count())
    cells = sum(max(view.sizeHintForColumn(c), headers.sectionSizeHint(c)) for c in columns)
    return cells + view.verticalScrollBar().sizeHint().width() + 2 * view.frameWidth() + 4
