"""Grouping the frames of one instant by their names, kept in the dataset's ``views.csv``."""

from __future__ import annotations

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QWidget

from procc_annotator.dataset.landmarks.view_groups import (
    NamedViews,
    ViewGroups,
    replace_views,
    suggested_pattern,
    views_by_name,
)
from procc_annotator.dataset.layout import VIEWS_FILE
from procc_annotator.errors import UsageError
from procc_annotator.gui.commands.dialog_task import DialogTask
from procc_annotator.gui.commands.field.view_dialog import Preview, ViewDialog
from procc_annotator.gui.messages import as_sentence, ask_to_replace
from procc_annotator.gui.state.background import LatestOnlyTask, Priority
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.writing import opened_frame
from procc_annotator.translation import tr, tr_count, word

_SETTLED_MS = 120  # after a key, so that a word is not looked up letter by letter
_LOST = word("What it says now is lost, with everything else that is written in it.")


class ViewGrouping(DialogTask):
    """Slot of the action: asks for a pattern, shows what it does, and writes the groups."""

    dialog: ViewDialog | None

    def __init__(self, document: Document, parent: QWidget) -> None:
        super().__init__(document, parent, priority=Priority.URGENT)
        self._names: tuple[str, ...] = ()
        self._writing = LatestOnlyTask(
            self, lambda text: self._fail(as_sentence(text)), priority=Priority.URGENT
        )
        self._settled = QTimer(self, singleShot=True, interval=_SETTLED_MS)
        self._settled.timeout.connect(self._look)

    def ask(self) -> None:
        """Show the dialog, with a pattern that fits the names where there is one."""
        if (
            opened_frame(self._document) is None
            or (workspace := self._document.state.workspace) is None
        ):
            return
        self._leave()
        self._names = names = tuple(workspace.index)
        self.dialog = dialog = ViewDialog(self._parent, self._what_is_there())
        dialog.patternEdited.connect(self._settled.start)
        dialog.writeWanted.connect(self.write)
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

    def _what_is_there(self) -> str:
        groups = self._document.landmarks.groups
        if not groups.frames:
            return ""
        return tr("{file} is there already: {sizes}.", file=VIEWS_FILE, sizes=_sizes(groups))

    def _suggest(self, found: tuple[str, Preview]) -> None:
        if self.dialog is None or self.dialog.pattern.text():
            return
        pattern, preview = found
        self.dialog.suggest(pattern)
        self._settled.stop()
        if pattern:
            self.dialog.show_preview(preview)

    def _look(self) -> None:
        """See what the pattern does, off the interface thread: a set may have many names."""
        dialog, names = self.dialog, self._names
        if dialog is None:
            return
        pattern = dialog.pattern.text().strip()
        self._work.start(lambda _: _preview(names, pattern), self._show, failed=dialog.tell)

    def _show(self, preview: Preview) -> None:
        if self.dialog is not None:
            self.dialog.show_preview(preview)

    def _write(self, groups: ViewGroups, known: bytes | None) -> None:
        dialog, workspace = self.dialog, self._document.state.workspace
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
        document = self._document
        document.landmarks.read_again()
        said = tr("{file} groups {sizes} from now on", file=VIEWS_FILE, sizes=_sizes(groups))
        document.say(said)
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
    """Of no pattern: the names, which anyone who writes one wants to see."""
    rows = Preview.of(NamedViews(ViewGroups(), names)).rows
    counts = tr_count(len(names), "{n:,} frame, none grouped.", "{n:,} frames, none grouped.")
    return Preview(ViewGroups(), rows, counts=counts)
