"""A table with a row an element, replaced as a whole; only what changed is announced."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Generic, Protocol, TypeVar

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt

RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter

Index = QModelIndex | QPersistentModelIndex


class ElementRow(Protocol):
    """What every row has; rows are compared to find out what changed."""

    @property
    def class_name(self) -> str:
        """The element's class."""
        ...


R = TypeVar("R", bound=ElementRow)


class ElementRowsModel(QAbstractTableModel, Generic[R]):
    """Rows, headings and tips; what the cells say is for each table to give (`data`)."""

    def __init__(self, headings: Sequence[str], tips: Sequence[str], first_figure: int) -> None:
        super().__init__()
        self.rows: list[R] = []
        self._headings, self._tips = headings, tips
        self._first_figure = first_figure  # columns from here on are aligned to the right

    def replace(self, rows: list[R]) -> None:
        """Show other rows."""
        if len(rows) == len(self.rows):
            changed = [i for i, row in enumerate(rows) if row != self.rows[i]]
            self.rows = rows
            for i in changed:
                self.dataChanged.emit(self.index(i, 0), self.index(i, len(self._headings) - 1))
        else:
            self.beginResetModel()
            self.rows = rows
            self.endResetModel()

    def row_of(self, class_name: str | None) -> int:
        """The row of a class, -1 if it has none."""
        return next((i for i, row in enumerate(self.rows) if row.class_name == class_name), -1)

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
            if role == Qt.ItemDataRole.ToolTipRole:
                return self._tips[section]
            if role == Qt.ItemDataRole.TextAlignmentRole and section >= self._first_figure:
                return RIGHT
        return None
