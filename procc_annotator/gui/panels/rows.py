"""Tables of rows: the model of those that are replaced as a whole, and how they look."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, QSize, Qt
from PySide6.QtWidgets import QAbstractItemView, QTableView

RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter

Index = QModelIndex | QPersistentModelIndex

R = TypeVar("R")


class RowsModel(QAbstractTableModel, Generic[R]):
    """Rows, headings and tips, replaced as a whole; only what changed is announced. What the cells
    say is for each table to give (`data`)."""

    def __init__(
        self, headings: Sequence[str], tips: Sequence[str] = (), first_figure: int | None = None
    ) -> None:
        """Args:
        headings, tips: of the columns.
        first_figure: columns from here on are aligned to the right.
        """
        super().__init__()
        self.rows: Sequence[R] = ()
        self._headings, self._tips = headings, tips
        self._first_figure = len(headings) if first_figure is None else first_figure

    def replace(self, rows: Sequence[R]) -> None:
        """Show other rows; a view keeps its place when their number stays."""
        if len(rows) == len(self.rows):
            changed = [i for i, row in enumerate(rows) if row != self.rows[i]]
            self.rows = rows
            for i in changed:
                self.dataChanged.emit(self.index(i, 0), self.index(i, len(self._headings) - 1))
        else:
            self.beginResetModel()
            self.rows = rows
            self.endResetModel()

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 (Qt's signature)
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self._headings)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation is Qt.Orientation.Horizontal:
            if role == Qt.ItemDataRole.DisplayRole:
                return self._headings[section]
            if role == Qt.ItemDataRole.ToolTipRole and self._tips:
                return self._tips[section]
            if role == Qt.ItemDataRole.TextAlignmentRole and section >= self._first_figure:
                return RIGHT
        return None


class LowTable(QTableView):
    """A table that asks for its least height, and takes what else there is: Qt's asks for 192."""

    def sizeHint(self) -> QSize:
        return QSize(super().sizeHint().width(), self.minimumSizeHint().height())

    def minimumSizeHint(self) -> QSize:
        return QSize(super().minimumSizeHint().width(), 4 * (self.fontMetrics().height() + 6))


def list_rows(table: QTableView, room: int = 6) -> None:
    """Have a table look like a list: whole rows, one of which may be chosen, without a grid.

    Args:
        table: its model is set.
        room: px a row is higher than its text.
    """
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setShowGrid(False)
    table.setTabKeyNavigation(False)
    table.setWordWrap(False)
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(table.fontMetrics().height() + room)
    table.horizontalHeader().setHighlightSections(False)
