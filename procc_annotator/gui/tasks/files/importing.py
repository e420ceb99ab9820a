"""Taking annotations of other programs into the open dataset."""

from __future__ import annotations

from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QWidget

from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.set_edits import LeftAlone, import_into_frame, why_left_alone
from procc_annotator.gui.tasks.dialog_task import DialogTask
from procc_annotator.gui.worker import JobControl
from procc_annotator.gui.writing import opened_frame
from procc_annotator.interact.hints import counted

if TYPE_CHECKING:
    from procc_annotator.gui.tasks.files.dialogs import ImportDialog
    from procc_annotator.io.annotation_files.exchange import ExchangedFrame
    from procc_annotator.report.conversion import Imported

# Edits go through the document, on the interface thread: a little at a time. Their files are
# written in the background, some together.
_SLICE_S = 0.008
_TOGETHER = 32
_LISTED = 200


class AnnotationImporter(DialogTask):
    """Asks what to import, reads it in the background, and saves it frame by frame."""

    dialog: ImportDialog | None

    def __init__(self, document: Document, parent: QWidget) -> None:
        super().__init__(document, parent)
        self._importing = self._stopped = False
        self._next = QTimer(self, singleShot=True, interval=0)
        self._next.timeout.connect(self._take_some)

    def ask(self) -> None:
        """Show the dialog."""
        from procc_annotator.gui.tasks.files.dialogs import ImportDialog

        if (frame := opened_frame(self._document)) is None:
            return
        self._leave()
        self.dialog = dialog = ImportDialog(self._parent, str(frame.image_folder))
        dialog.started.connect(lambda: self.start(Path(dialog.path.text().strip())))
        dialog.cancelled.connect(self.cancel)
        dialog.open()

    def start(self, path: Path) -> None:
        """Read the annotations and take them over, as the dialog says."""
        from procc_annotator.report.conversion import read_annotations

        document, dialog = self._document, self.dialog
        if dialog is None:
            return
        document.save_now()
        fmt, reopen = str(dialog.formats.currentData()), document.reopener()
        self._replace = dialog.replace.isChecked()
        dialog.set_running(True)

        def read(control: JobControl) -> Imported:
            return read_annotations(path, reopen(), fmt=fmt, progress=control.progress_or_stop)

        self._work.start(read, self._take, progress=dialog.advance)

    def cancel(self) -> None:
        """Stop; frames that are saved already stay so, and are told."""
        if self._work.cancel():
            self._fail("Cancelled; nothing was imported.")
        elif self._importing:
            self._next.stop()
            self._stopped = True
            if not self._written:
                self._save_batch()
            self._document.saver.settle()

    def stop(self) -> None:
        """Import no more, and say nothing: the window closes. What is edited is saved by then."""
        self._leave()

    def _leave(self) -> None:
        self._next.stop()
        self._importing = False
        super()._leave()

    def _take(self, imported: Imported) -> None:
        """Begin to save what was read."""
        workspace = self._document.workspace
        assert workspace is not None
        self._imported = imported
        self._unmatched = [name for name in imported.frames if name not in workspace.index]
        self._waiting = [
            (workspace.index[name], frame)
            for name, frame in imported.frames.items()
            if name in workspace.index
        ][::-1]
        self._total = len(self._waiting)
        self._edited: list[int] = []
        self._batch: list[int] = []  # edited and not handed over to be written yet
        self._written: list[int] = []  # being written
        self._kept = self._same = 0
        self._refused: list[str] = []
        self._importing, self._stopped = True, False
        self._next.start()

    def _take_some(self) -> None:
        end = perf_counter() + _SLICE_S
        while self._waiting and len(self._batch) < _TOGETHER and perf_counter() < end:
            self._take_one(*self._waiting.pop())
        if self._waiting and len(self._batch) < _TOGETHER:
            self._next.start()
        else:
            self._save_batch()

    def _take_one(self, index: int, frame: ExchangedFrame) -> None:
        workspace = self._document.workspace
        assert workspace is not None
        state = workspace.state(index)
        why: str | None = None
        if state.error is None:  # most frames that stay as they are need no lock
            before = state.history.current
            why = why_left_alone(before, frame.annotation, replacing=self._replace)
        if why is None:
            store, editing = self._document.store, self._document.editing
            why = import_into_frame(
                store, editing, index, frame.annotation, replacing=self._replace
            )
        if why == LeftAlone.SAME:
            self._same += 1
        elif why == LeftAlone.ANNOTATED:
            self._kept += 1
        elif why:
            self._refused.append(f"{frame.name}: {why}")
        else:
            self._batch.append(index)

    def _save_batch(self) -> None:
        self._written, self._batch = self._batch, []
        self._document.saver.save_together(self._written, self._batch_saved)

    def _batch_saved(self) -> None:
        document, workspace = self._document, self._document.workspace
        if workspace is None or not self._importing:
            return
        for index in self._written:
            name, problem = workspace.frames[index].name, workspace.state(index).save_error
            document.presence.give_back(name)
            if problem is None:
                self._edited.append(index)
            else:
                self._refused.append(f"{name}: it could not be saved: {problem}")
        self._written = []
        if self.dialog is not None:
            self.dialog.advance(self._total - len(self._waiting), max(1, self._total))
        if self._waiting and not self._stopped:
            self._next.start()
        else:
            self._finish()

    def _finish(self) -> None:
        self._importing = False
        document = self._document
        if self._edited:
            document.framesEdited.emit(self._edited)
            frames = document.workspace.frames if document.workspace is not None else ()
            document.auditing.frames_edited([frames[i].name for i in self._edited])
        done = f"{len(self._edited)} of {counted(self._total, 'frame')} imported"
        document.say(done)
        if self.dialog is None:
            return
        said = [f"{done} ({self._imported.title})."]
        if self._stopped:
            left = len(self._waiting)
            said.append(f"Cancelled: {counted(left, 'frame was', 'frames were')} not looked at.")
        if self._kept:
            annotated = counted(self._kept, "frame is annotated", "frames are annotated")
            said.append(f"{annotated} already and left unchanged.")
        if self._same:
            said.append(f"{counted(self._same, 'frame holds', 'frames hold')} the same already.")
        self.dialog.set_running(False)
        self.dialog.tell(
            "\n".join(said),
            ("Left as they were", self._refused[:_LISTED]),
            ("Could not be read", self._imported.problems[:_LISTED]),
            (f"Without a picture here ({len(self._unmatched)})", self._unmatched[:_LISTED]),
            ("Changed or left out", self._imported.losses),
        )
