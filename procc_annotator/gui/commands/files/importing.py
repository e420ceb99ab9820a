"""Taking annotations of other programs into the open dataset."""

from __future__ import annotations

from collections import Counter
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from procc_annotator.dataset.records import OriginKind
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.gui.commands.dialog_task import DialogTask
from procc_annotator.gui.commands.files.label_look import LabelLook, LookedAt
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.editing.batch_edits import (
    EditedFrames,
    LeftAlone,
    ManyEdits,
    edit_frame,
    imported,
    why_left_alone,
)
from procc_annotator.gui.writing import opened_frame
from procc_annotator.translation import tr, tr_count, translatable

if TYPE_CHECKING:
    from procc_annotator.formats.annotations.registry import ReadSet
    from procc_annotator.gui.commands.files.dialogs import ImportDialog
    from procc_annotator.gui.commands.files.label_dialog import LabelDialog

_LISTED = 200


class AnnotationImporter(DialogTask):
    """Asks what to import, reads it in the background, asks what labels stand for that are no
    class, and saves it frame by frame."""

    dialog: ImportDialog | None
    names: LabelDialog | None = None

    def __init__(self, document: Document, parent: QWidget) -> None:
        super().__init__(document, parent)
        self._edits = ManyEdits(document.store, document.editing, document.auditing, self)
        self._edits.progressed.connect(self._advance)
        self._edits.finished.connect(self._finish)

    def ask(self) -> None:
        """Show the dialog."""
        from procc_annotator.gui.commands.files.dialogs import ImportDialog

        workspace = self._document.state.workspace
        if opened_frame(self._document) is None or workspace is None:
            return
        self._leave()
        self.dialog = dialog = ImportDialog(self._parent, str(workspace.folder))
        dialog.started.connect(lambda: self.start(Path(dialog.path.text().strip())))
        dialog.cancelled.connect(self.cancel)
        dialog.open()

    def start(self, path: Path) -> None:
        """Read the annotations and take them over, as the dialog says."""

        document, dialog = self._document, self.dialog
        if dialog is None:
            return
        document.editing.save_now()
        look = LabelLook(path, str(dialog.formats.currentData()), document)
        self._replace = dialog.replace.isChecked()
        dialog.set_running(True)
        self._work.start(look.read, self._ask_names, progress=dialog.advance)

    def _ask_names(self, looked: LookedAt) -> None:
        """Ask what labels stand for that are no class; where there are none, begin to save."""
        from procc_annotator.gui.commands.files.label_dialog import LabelDialog

        if not looked.proposals or self.dialog is None:
            self._take(looked.found)
            return
        self.dialog.set_running(False)
        self.names = names = LabelDialog(
            self.dialog, looked.proposals, looked.field, better=looked.better,
            has_file=looked.has_file,
        )  # fmt: skip
        names.accepted.connect(lambda: self._read_again(looked, names))
        names.rejected.connect(lambda: self._fail(tr("Cancelled; nothing was imported.")))
        names.open()

    def _read_again(self, looked: LookedAt, names: LabelDialog) -> None:
        """Read by the names that were chosen, and keep them with the dataset if that is wanted."""
        if self.dialog is None:
            return
        rules, keep = names.rules, names.keep.isChecked()
        self.dialog.set_running(True)
        self._work.start(
            partial(looked.look.read_by, looked, rules, keep=keep), self._take,
            progress=self.dialog.advance,
        )  # fmt: skip

    def cancel(self) -> None:
        """Stop; frames that are saved already stay so, and are reported."""
        if self._work.cancel():
            self._fail(tr("Cancelled; nothing was imported."))
        else:
            self._edits.stop()

    def stop(self) -> None:
        """Import no more, and say nothing: the window closes. What is edited is saved by then."""
        self._leave()

    def _leave(self) -> None:
        self._edits.forget()
        super()._leave()

    def _take(self, read: ReadSet) -> None:
        """Begin to save what was read."""
        workspace = self._document.state.workspace
        assert workspace is not None
        self._imported = read
        self._unmatched = [name for name in read.frames if name not in workspace.index]
        indices = [workspace.index[name] for name in read.frames if name in workspace.index]
        self._edits.start(indices, partial(self._take_one, workspace))

    def _take_one(self, workspace: Workspace, index: int) -> str:
        incoming = self._imported.frames[workspace.frames[index].name].annotation
        state = workspace.state(index)
        if state.error is None:  # most frames that stay as they are need no lock
            before = state.history.current
            why = why_left_alone(before, incoming, replacing=self._replace)
            if why is not None:
                return why
        change = imported(incoming, replacing=self._replace)
        store, editing = self._document.store, self._document.editing
        return edit_frame(
            store, editing, index, change, translatable("import", "a step"), OriginKind.FILE
        )

    def _advance(self, done: int, total: int) -> None:
        if self.dialog is not None:
            self.dialog.advance(done, total)

    def _finish(self, outcome: EditedFrames) -> None:
        document = self._document
        edited, total = len(outcome.edited), outcome.total
        document.say(
            tr_count(
                total,
                "{edited} of {n:,} frame imported",
                "{edited} of {n:,} frames imported",
                edited=edited,
            )
        )
        if self.dialog is None:
            return
        self.dialog.set_running(False)
        self.dialog.tell(
            "\n".join(_said(outcome, self._imported.title)),
            (tr("Left as they were"), self._refused(outcome)[:_LISTED]),
            (tr("Could not be read"), self._imported.problems[:_LISTED]),
            (
                tr("Without a picture here ({n})", n=len(self._unmatched)),
                self._unmatched[:_LISTED],
            ),
            (tr("Changed or left out"), self._imported.losses),
        )

    def _refused(self, outcome: EditedFrames) -> list[str]:
        workspace = self._document.state.workspace
        frames = workspace.frames if workspace is not None else ()
        left = [(i, why) for i, why in outcome.left if not isinstance(why, LeftAlone)]
        unsaved = [(i, tr("it could not be saved: {why}", why=why)) for i, why in outcome.unsaved]
        return [f"{frames[i].name}: {why}" for i, why in sorted(left + unsaved)]


def _said(outcome: EditedFrames, format_title: str) -> list[str]:
    """Return what came of an import, a line each."""
    reasons = Counter(why for _, why in outcome.left)
    annotated, same = reasons[LeftAlone.ANNOTATED], reasons[LeftAlone.SAME]
    imported = tr_count(
        outcome.total,
        "{edited} of {n:,} frame imported ({format}).",
        "{edited} of {n:,} frames imported ({format}).",
        edited=len(outcome.edited),
        format=format_title,
    )
    waiting = tr_count(
        outcome.waiting,
        "Cancelled: {n:,} frame was not looked at.",
        "Cancelled: {n:,} frames were not looked at.",
    )
    left = tr_count(
        annotated,
        "{n:,} frame is annotated already and left unchanged.",
        "{n:,} frames are annotated already and left unchanged.",
    )
    alike = tr_count(
        same, "{n:,} frame holds the same already.", "{n:,} frames hold the same already."
    )
    lines = ((imported, 1), (waiting, outcome.waiting), (left, annotated), (alike, same))
    return [words for words, count in lines if count]
