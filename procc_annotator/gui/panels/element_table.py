"""A table with a row an element, of which one can be chosen."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol, TypeVar

from PySide6.QtCore import QModelIndex, Qt, Signal
from PySide6.QtWidgets import QHeaderView

from procc_annotator.gui.panels.rows import LowTable, RowsModel, list_rows


class ElementRow(Protocol):
    """What every row has."""

    @property
    def class_name(self) -> str:
        """The element's class."""
        ...


R = TypeVar("R", bound=ElementRow)


class ElementRowsModel(RowsModel[R]):
    """Rows that are found by their element."""

    def row_of(self, class_name: str | None) -> int:
        """The row of a class, -1 if it has none."""
        return next((i for i, row in enumerate(self.rows) if row.class_name == class_name), -1)


class ElementTable(LowTable):
    """Shows the rows of a model, titles of elements in the first column.

    A click, Enter and the arrows choose a row; showing the one that is chosen elsewhere
    (`show_chosen`) does not.
    """

    chosen = Signal(int)  # a row

    def __init__(self, name: str, model: ElementRowsModel[R], samples: Mapping[int, str]) -> None:
        """Args:
        name: the widget's.
        model: the rows.
        samples: by column, the widest text there; all other room is the titles'.
        """
        super().__init__()
        self._model = model
        self._following = False
        self.setObjectName(name)
        self.setModel(model)
        list_rows(self)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the keys to the canvas
        metrics, header = self.fontMetrics(), self.horizontalHeader()
        header.setMinimumSectionSize(36)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        for column, sample in samples.items():
            header.resizeSection(column, metrics.horizontalAdvance(sample) + 8)
        self.clicked.connect(self._choose)
        self.activated.connect(self._choose)
        self.selectionModel().currentRowChanged.connect(self._take_current)

    def show_chosen(self, class_name: str | None) -> int:
        """Mark the row of a class; its number, or -1 where it has none."""
        row = self._model.row_of(class_name)
        self._following = True
        if row < 0:
            self.clearSelection()
        elif row != self.currentIndex().row() or not self.selectedIndexes():
            self.selectRow(row)
        self._following = False
        return row

    def _choose(self, index: QModelIndex) -> None:
        self.chosen.emit(index.row())

    def _take_current(self, current: QModelIndex, _: QModelIndex) -> None:
        """Arrows go from row to row; clicks are taken when they end."""
        if current.isValid() and self.hasFocus() and not self._following:
            self._choose(current)
