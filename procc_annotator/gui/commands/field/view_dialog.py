"""The dialog that groups frames by their names: a pattern, and what it makes of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QAbstractTableModel, Qt, Signal
from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPushButton,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.dataset.landmarks.view_groups import NamedViews, ViewGroups
from procc_annotator.dataset.layout import VIEWS_FILE
from procc_annotator.gui.messages import as_sentence
from procc_annotator.gui.panels.tables import Index, RowsModel, list_rows
from procc_annotator.gui.panels.widgets import note_label, show_note
from procc_annotator.gui.theme import muted
from procc_annotator.translation import tr, tr_count, word

_SIZE = (560, 520)
_ASKED = word(
    "Frames of one instant from different cameras are one group. Their names tell which, by a"
    " pattern: <b>{instant}</b> stands for when a frame was taken, <b>{view}</b> for the camera,"
    " all else for itself. A regular expression with <b>(?P&lt;instant&gt;…)</b> and"
    " <b>(?P&lt;view&gt;…)</b> does it, too."
)
_NONE_FITS = word("No pattern was found that fits these names: write one.")
_HEADERS = (word("Instant"), word("View"), word("Frame"))
_ALONE = "—"

_Row = tuple[str, str, str]


@dataclass(frozen=True)
class Preview:
    """What a pattern makes of the frames of a dataset, ready to be shown.

    Attributes:
        groups: of the frames that fit it.
        rows: instant, view and frame; those that do not fit last, without instant.
        fitting: number of rows of frames that fit.
        counts: in one sentence.
        problem: why they cannot be grouped so; empty if they can.
    """

    groups: ViewGroups
    rows: tuple[_Row, ...] = ()
    fitting: int = 0
    counts: str = ""
    problem: str = ""

    @classmethod
    def of(cls, named: NamedViews) -> Preview:
        """From what a pattern makes of the names; costs as much as putting them in order."""
        groups = named.groups
        rows = [
            (instant, groups.view_of(frame), frame)
            for instant, frames in groups.groups.items()
            for frame in frames
        ]
        alone = [("", "", frame) for frame in named.alone]
        return cls(groups, (*rows, *alone), len(rows), _counts(named), named.problem)


def _counts(named: NamedViews) -> str:
    sizes = [len(frames) for frames in named.groups.groups.values()]
    together = [size for size in sizes if size > 1]
    words = [_together(together)]
    if single := len(sizes) - len(together):
        words.append(
            tr_count(
                single, "{n:,} instant with one frame only", "{n:,} instants with one frame only"
            )
        )
    if named.alone:
        words.append(
            tr_count(
                len(named.alone),
                "{n:,} name does not fit (last in the table)",
                "{n:,} names do not fit (last in the table)",
            )
        )
    return f"{'; '.join(words)}."


def _together(sizes: list[int]) -> str:
    """Return how many frames are in groups, and of how many the groups are."""
    frames = tr_count(sum(sizes), "{n:,} frame", "{n:,} frames")
    if len(set(sizes)) < 2:
        return tr_count(
            len(sizes), "{frames} in {n:,} group", "{frames} in {n:,} groups", frames=frames
        )
    return tr_count(
        len(sizes),
        "{frames} in {n:,} group of {least} to {most}",
        "{frames} in {n:,} groups of {least} to {most}",
        frames=frames,
        least=min(sizes),
        most=max(sizes),
    )


class _FramesModel(RowsModel[_Row]):
    """Frames with what the pattern makes of their names; those it does not fit are last."""

    def __init__(self) -> None:
        super().__init__([tr(header) for header in _HEADERS])
        self._fitting = 0

    def show_preview(self, preview: Preview) -> None:
        self.beginResetModel()
        self.rows, self._fitting = preview.rows, preview.fitting
        self.endResetModel()

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        fits = index.row() < self._fitting
        if role == Qt.ItemDataRole.DisplayRole:
            return self.rows[index.row()][index.column()] or _ALONE
        if role == Qt.ItemDataRole.ForegroundRole and not fits:
            return muted(QApplication.palette())
        if role == Qt.ItemDataRole.ToolTipRole and not fits:
            return tr("This name does not fit the pattern: the frame stands alone")
        return None


class ViewDialog(QDialog):
    """Shows nothing but what it is given."""

    patternEdited = Signal(str)
    writeWanted = Signal()

    def __init__(self, parent: QWidget, there: str) -> None:
        """Args:
        there: what the dataset's file says now, in one sentence; empty if absent.
        """
        super().__init__(parent)
        self.setObjectName("viewDialog")
        self.setWindowTitle(tr("Group views"))
        self.preview: Preview | None = None
        asked = QLabel(tr(_ASKED), wordWrap=True, textFormat=Qt.TextFormat.RichText)
        self.pattern = QLineEdit(placeholderText="{instant}_{view}")
        self.pattern.setObjectName("viewPattern")
        self.pattern.setAccessibleName(tr("Pattern of the frames' names"))
        self.pattern.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.pattern.textChanged.connect(self._change)
        self.counts = QLabel(wordWrap=True)
        self.counts.setObjectName("viewCounts")
        self._model = _FramesModel()
        self.table = _table(self._model)
        self.there = note_label("viewThere")
        show_note(self.there, there)
        self.note = note_label("viewNote")
        self.buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        close = self.buttons.button(QDialogButtonBox.StandardButton.Close)
        close.setAutoDefault(False)
        self.write = QPushButton(tr("Write {file}", file=VIEWS_FILE))
        self.write.setToolTip(tr("Keep these groups in the dataset's folder"))
        self.write.setEnabled(False)
        self.buttons.addButton(self.write, QDialogButtonBox.ButtonRole.ActionRole)
        self.write.setDefault(True)
        self.write.clicked.connect(self.writeWanted)
        self.buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        column.addWidget(asked)
        for part in (self.pattern, self.counts, self.table, self.there, self.note, self.buttons):
            column.addWidget(part, int(part is self.table))
        self.resize(*_SIZE)

    def suggest(self, pattern: str) -> None:
        """Write a pattern that fits, unless a person wrote one meanwhile."""
        if self.pattern.text():
            return
        self.pattern.setText(pattern)
        if not pattern:
            self.tell(tr(_NONE_FITS))

    def show_preview(self, preview: Preview) -> None:
        """Show what the pattern makes of the names; it may be written if nothing is wrong."""
        self.preview = preview
        self._model.show_preview(preview)
        self.counts.setText(preview.counts)
        self.tell(as_sentence(preview.problem))
        self.write.setEnabled(bool(preview.groups.frames) and not preview.problem)

    def tell(self, text: str) -> None:
        """Say what is wrong, or nothing."""
        show_note(self.note, text)

    def set_running(self, running: bool) -> None:
        """While the file is being written nothing else can be asked for."""
        self.pattern.setEnabled(not running)
        self.write.setEnabled(not running)

    def _change(self, pattern: str) -> None:
        self.write.setEnabled(False)  # until it is known what this pattern does
        self.patternEdited.emit(pattern)


def _table(model: QAbstractTableModel) -> QTableView:
    table = QTableView()
    table.setObjectName("viewTable")
    table.setAccessibleName(tr("Groups of frames"))
    table.setModel(model)
    list_rows(table)
    table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
    header = table.horizontalHeader()
    header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
    header.setStretchLastSection(True)
    header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    return table
