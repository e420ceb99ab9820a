"""Rows of frames laid next to each other: the same frames, a column for each."""

from __future__ import annotations

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QObject, Qt

from procc_annotator.gui.panels.frames.model import FramesModel
from procc_annotator.gui.panels.rows import Index


class TurnedRows(QAbstractTableModel):
    """A `FramesModel` whose rows are columns.

    Attributes:
        frames: the model whose rows these are.
    """

    def __init__(self, frames: FramesModel, parent: QObject) -> None:
        super().__init__(parent)
        self.frames = frames
        frames.modelAboutToBeReset.connect(self.beginResetModel)
        frames.modelReset.connect(self.endResetModel)
        frames.dataChanged.connect(self._repaint)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 (Qt's signature)
        return 0 if parent.isValid() else 1

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else self.frames.rowCount()

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        return self.frames.data(self.frames.index(index.column()), role)

    def _repaint(self, first: QModelIndex, last: QModelIndex) -> None:
        self.dataChanged.emit(self.index(0, first.row()), self.index(0, last.row()))
