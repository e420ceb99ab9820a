"""Writing the annotations for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QWidget

from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import Job, JobControl, run_in_background

if TYPE_CHECKING:
    from procc_annotator.gui.tasks.files.dialogs import ExportDialog
    from procc_annotator.report.conversion_output import Converted

_LISTED = 200
_CANCELLED = "cancelled; files that were written already are still there"


class ExportAs(QObject):
    """Asks for format and place, writes in the background, and says what was lost."""

    def __init__(self, document: Document, parent: QWidget) -> None:
        super().__init__(parent)
        self._document = document
        self._parent = parent
        self._job: Job | None = None
        self.dialog: ExportDialog | None = None
        document.datasetChanged.connect(self._leave)

    def ask(self) -> None:
        """Show the dialog."""
        from procc_annotator.gui.tasks.files.dialogs import ExportDialog

        if self._document.frame is None:
            self._document.say("open a folder of pictures first", "warning")
            return
        self._leave()
        self.dialog = dialog = ExportDialog(self._parent)
        dialog.started.connect(self._ask_path)
        dialog.cancelled.connect(self.cancel)
        dialog.open()

    def start(self, out: Path) -> None:
        """Write to a folder or archive, as the dialog says."""
        from procc_annotator.report.conversion import export_as
        from procc_annotator.report.conversion_output import Wanted

        document, dialog = self._document, self.dialog
        if dialog is None:
            return
        said = "" if document.save_now() else "Not everything could be saved: what is on disk goes."
        review, reopen = document.review, document.reopener()
        drafts = set(review.database.drafts()) if review.database is not None else set()
        wanted = Wanted(
            dialog.format.name,
            dialog.line_width.value(),
            overwrite=dialog.overwrite.isChecked(),
            keep_optional=dialog.keep_optional.isChecked(),
        )
        dialog.set_running(True)

        def write(control: JobControl) -> Converted:
            return export_as(
                reopen(), out, wanted, drafts=drafts, progress=control.progress_or_stop
            )

        self._job = run_in_background(
            write,
            on_result=lambda done: self._tell(done, said),
            on_error=self._fail,
            on_progress=dialog.advance,
            owner=self,
        )

    def cancel(self) -> None:
        """Stop; an archive is then not there, files of single frames may be."""
        if self._job is not None and self._job.running:
            self._job.cancel()
            self._fail(f"{_CANCELLED[0].upper()}{_CANCELLED[1:]}.")

    def _ask_path(self) -> None:
        frame = self._document.frame
        if self.dialog is not None and frame is not None:
            out = self.dialog.ask_path(frame.image_folder.parent)
            if out is not None:
                self.start(out)

    def _leave(self) -> None:
        if self._job is not None and self._job.running:
            self._job.cancel()
            # Once all have heard of the other dataset, for which the message bar is cleared.
            QTimer.singleShot(0, self, self._tell_cut_short)
        if self.dialog is not None:
            self.dialog.set_running(False)
            self.dialog.close()
            self.dialog.deleteLater()
            self.dialog = None

    def _tell_cut_short(self) -> None:
        self._document.say(f"export: {_CANCELLED}", "warning")

    def _fail(self, text: str) -> None:
        if self.dialog is not None:
            self.dialog.set_running(False)
            self.dialog.tell(text)

    def _tell(self, done: Converted, said: str) -> None:
        if self.dialog is None:
            return
        from procc_annotator.words import count_of

        headline = (
            f"{count_of(done.frames, 'frame')}, {count_of(done.elements, 'element')} and"
            f" {count_of(done.points, 'point')} written to {done.path} ({done.title})."
            if done.frames
            else "Nothing was written: no frame is annotated, or none could be written."
        )
        self.dialog.set_running(False)
        self.dialog.tell(
            "\n".join(filter(None, (headline, said))),
            ("Not written", done.problems[:_LISTED]),
            ("What the format cannot hold", done.losses),
        )
