"""Grouping the frames of one instant by their names, kept in the dataset's ``views.csv``."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QAbstractTableModel, Qt, QTimer
from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QLabel,
    QLineEdit,
    QTableView,
    QWidget,
)

from procc_annotator.dataset.landmarks.view_groups import (
    NamedViews,
    ViewGroups,
    replace_views,
    suggested_pattern,
    views_by_name,
)
from procc_annotator.dataset.layout import VIEWS_FILE
from procc_annotator.errors import UsageError
from procc_annotator.gui.commands.dialogs import CLOSE, DialogTask, TaskDialog, dialog_buttons
from procc_annotator.gui.messages import ask_to_replace, opened_frame
from procc_annotator.gui.panels import widgets
from procc_annotator.gui.state.availability import as_sentence
from procc_annotator.gui.state.background import LatestOnlyTask, Priority
from procc_annotator.gui.state.services import Services
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
    """The groups that a pattern gives for the frames of a dataset.

    Attributes:
        groups: of the frames that fit it.
        rows: instant, view and frame; those that do not fit last, without instant.
        counts: in one sentence.
        problem: why they cannot be grouped so; empty if they can.
    """

    groups: ViewGroups
    rows: tuple[_Row, ...] = ()
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
        return cls(groups, (*rows, *alone), _counts(named), named.problem)


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


class _FramesModel(widgets.RowsModel[_Row]):
    """Frames with what the pattern makes of their names; those it does not fit are last."""

    def texts(self, row: _Row) -> list[str]:
        return [text or _ALONE for text in row]

    def tip(self, row: _Row) -> str:
        alone = tr("This name does not fit the pattern: the frame stands alone")
        return "" if row[0] else alone

    def data(self, index: widgets.Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if role == Qt.ItemDataRole.ForegroundRole and not self.rows[index.row()][0]:
            return muted(QApplication.palette())
        return super().data(index, role)


class ViewDialog(TaskDialog):
    """Shows nothing but what it is given."""

    def __init__(self, parent: QWidget, there: ViewGroups) -> None:
        """Begin with the groups in the dataset's file now."""
        super().__init__(parent, "viewDialog", tr("Group views"))
        self.preview: Preview | None = None
        asked = QLabel(tr(_ASKED), wordWrap=True, textFormat=Qt.TextFormat.RichText)
        line = QLineEdit(placeholderText="{instant}_{view}")
        self.pattern = widgets.named(line, "viewPattern", title=tr("Pattern of the frames' names"))
        self.pattern.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.counts = widgets.make_label(name="viewCounts", wrap=True)
        self._model = _FramesModel(_HEADERS)
        self.table = _table(self._model)
        self.there = widgets.note_label("viewThere")
        if there.frames:
            said = tr("{file} is there already: {sizes}.", file=VIEWS_FILE, sizes=_sizes(there))
            widgets.show_note(self.there, said)
        buttons, self.write = dialog_buttons(self, tr("Write {file}", file=VIEWS_FILE), CLOSE)
        self.write.setToolTip(tr("Keep these groups in the dataset's folder"))
        self.write.setEnabled(False)
        self.pattern.textChanged.connect(lambda: self.write.setEnabled(False))  # until it is known
        shown = (self.counts, (self.table, 1), self.there, self.note)
        widgets.vbox(asked, self.pattern, *shown, buttons, of=self)
        self.resize(*_SIZE)

    def show_preview(self, preview: Preview) -> None:
        """Show what the pattern makes of the names; it may be written if nothing is wrong."""
        self.preview = preview
        self._model.beginResetModel()  # not row by row: a set may have many names
        self._model.rows = preview.rows
        self._model.endResetModel()
        self.counts.setText(preview.counts)
        self.tell(as_sentence(preview.problem))
        self.write.setEnabled(bool(preview.groups.frames) and not preview.problem)

    def set_running(self, running: bool) -> None:
        self.pattern.setEnabled(not running)
        self.write.setEnabled(not running)


def _table(model: QAbstractTableModel) -> QTableView:
    table = widgets.named(QTableView(), "viewTable", title=tr("Groups of frames"))
    table.setModel(model)
    widgets.list_rows(table)
    table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
    header = table.horizontalHeader()
    header.setStretchLastSection(True)
    header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    return table


_SETTLED_MS = 120  # after a key, so that a word is not looked up letter by letter
_LOST = word("What it says now is lost, with everything else that is written in it.")


class ViewGrouping(DialogTask):
    """Slot of the action: asks for a pattern, shows what it does, and writes the groups."""

    dialog: ViewDialog | None

    def __init__(self, services: Services, parent: QWidget) -> None:
        super().__init__(services, parent, priority=Priority.URGENT)
        self._names: tuple[str, ...] = ()
        self._writing = LatestOnlyTask(
            self, lambda text: self._fail(as_sentence(text)), priority=Priority.URGENT
        )
        self._settled = QTimer(self, singleShot=True, interval=_SETTLED_MS)
        self._settled.timeout.connect(self._look)

    def ask(self) -> None:
        """Show the dialog, with a pattern that fits the names where there is one."""
        workspace = self._services.state.workspace
        if opened_frame(self._services) is None or workspace is None:
            return
        self._leave()
        self._names = names = tuple(workspace.index)
        self.dialog = dialog = ViewDialog(self._parent, self._services.landmarks.groups)
        dialog.pattern.textChanged.connect(self._settled.start)
        dialog.write.clicked.connect(self.write)
        dialog.finished.connect(self._leave)
        dialog.show_preview(_nothing(names))

        def work(_: object) -> tuple[str, Preview]:
            pattern = suggested_pattern(names)
            return pattern, _preview(names, pattern)

        self._work.start(work, self._suggest, failed=dialog.tell)
        dialog.open()

    def write(self) -> None:
        """Write what is shown; over a file that says something else only if that is meant."""
        dialog = self.dialog
        if dialog is not None and dialog.preview is not None and not self._writing.running:
            self._write(dialog.preview.groups, None)

    # --- inside ---

    def _suggest(self, found: tuple[str, Preview]) -> None:
        pattern, preview = found
        if self.dialog is None or self.dialog.pattern.text():
            return  # the user wrote one meanwhile
        self.dialog.pattern.setText(pattern)
        self._settled.stop()
        if pattern:
            self.dialog.show_preview(preview)
        else:
            self.dialog.tell(tr(_NONE_FITS))

    def _look(self) -> None:
        """See what the pattern does, off the interface thread: a set may have many names."""
        dialog, names = self.dialog, self._names
        if dialog is None:
            return
        pattern = dialog.pattern.text().strip()
        self._work.start(
            lambda _: _preview(names, pattern), dialog.show_preview, failed=dialog.tell
        )

    def _write(self, groups: ViewGroups, known: bytes | None) -> None:
        dialog, workspace = self.dialog, self._services.state.workspace
        if dialog is None or workspace is None:
            return
        path = workspace.folder / VIEWS_FILE

        def written(there: bytes | None) -> None:
            if there is None:
                self._tell_written(groups)
            elif self.dialog is not dialog:
                return  # it was closed, and nobody can be asked
            elif ask_to_replace(dialog, VIEWS_FILE, tr(_LOST)):
                self._write(groups, there)
            else:
                dialog.set_running(False)

        dialog.set_running(True)
        dialog.tell("")
        self._writing.start(lambda _: replace_views(path, groups, known), written)

    def _tell_written(self, groups: ViewGroups) -> None:
        services = self._services
        services.landmarks.read_again()
        said = tr("{file} groups {sizes} from now on", file=VIEWS_FILE, sizes=_sizes(groups))
        services.say(said)
        self._leave()

    def _leave(self) -> None:
        self._settled.stop()
        super()._leave()


def _sizes(groups: ViewGroups) -> str:
    instants = {of.instant for of in groups.frames.values()}
    frames = tr_count(len(groups.frames), "{n:,} frame", "{n:,} frames")
    return tr_count(
        len(instants), "{frames} of {n:,} instant", "{frames} of {n:,} instants", frames=frames
    )


def _preview(names: tuple[str, ...], pattern: str) -> Preview:
    if not pattern:
        return _nothing(names)
    try:
        return Preview.of(views_by_name(names, pattern))
    except UsageError as error:
        return Preview(ViewGroups(), _nothing(names).rows, problem=str(error))


def _nothing(names: tuple[str, ...]) -> Preview:
    rows = Preview.of(NamedViews(ViewGroups(), names)).rows
    counts = tr_count(len(names), "{n:,} frame, none grouped.", "{n:,} frames, none grouped.")
    return Preview(ViewGroups(), rows, counts=counts)
