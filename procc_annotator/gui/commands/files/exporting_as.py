"""Writing the annotations for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer

from procc_annotator.gui.commands.dialog_task import DialogTask
from procc_annotator.gui.state.background import JobControl
from procc_annotator.gui.writing import opened_frame
from procc_annotator.translation import tr, tr_count

if TYPE_CHECKING:
    from procc_annotator.gui.commands.files.dialogs import ExportDialog
    from procc_annotator.report.conversion_output import Converted

_LISTED = 200


class ExportAs(DialogTask):
    """Asks for format and place, writes in the background, and says what was lost."""

    dialog: ExportDialog | None

    def ask(self) -> None:
        """Show the dialog."""
        from procc_annotator.gui.commands.files.dialogs import ExportDialog

        if opened_frame(self._document) is None:
            return
        self._leave()
        self.dialog = dialog = ExportDialog(self._parent)
        dialog.started.connect(self._ask_path)
        dialog.cancelled.connect(self.cancel)
        dialog.open()

    def start(self, out: Path) -> None:
        """Write to a folder or archive, as the dialog says."""
        from procc_annotator.report.conversion import export_as
        from procc_annotator.report.conversion_output import ConversionRequest

        document, dialog = self._document, self.dialog
        if dialog is None:
            return
        unsaved = tr("Not everything could be saved: what is on disk goes.")
        said = "" if document.editing.save_now() else unsaved
        review, reopen = document.review, document.opening.reopener()
        drafts = set(review.database.drafts()) if review.database is not None else set()
        wanted = ConversionRequest(
            dialog.format.name,
            dialog.line_width.value(),
            overwrite=dialog.overwrite.isChecked(),
            keep_optional=dialog.keep_optional.isChecked(),
            pictures=dialog.pictures.isChecked() and dialog.format.pictures is not None,
        )
        dialog.set_running(True)

        def write(control: JobControl) -> Converted:
            return export_as(
                reopen(), out, wanted, drafts=drafts, progress=control.progress_or_stop
            )

        self._work.start(write, lambda done: self._tell(done, said), progress=dialog.advance)

    def cancel(self) -> None:
        """Stop; an archive is then not there, files of single frames may be."""
        if self._work.cancel():
            self._fail(tr("Cancelled; files that were written already are still there."))

    def _ask_path(self) -> None:
        workspace = self._document.state.workspace
        if self.dialog is not None and workspace is not None:
            out = self.dialog.ask_path(workspace.folder.parent)
            if out is not None:
                self.start(out)

    def _leave(self) -> None:
        if self._work.cancel():
            # Once all have heard of the other dataset, for which the message bar is cleared.
            QTimer.singleShot(0, self, self._tell_cut_short)
        super()._leave()

    def _tell_cut_short(self) -> None:
        self._document.say(
            tr("export: cancelled; files that were written already are still there"), "warning"
        )

    def _tell(self, done: Converted, said: str) -> None:
        if self.dialog is None:
            return
        headline = (
            _written(done)
            if done.frames
            else tr("Nothing was written: no frame is annotated, or none could be written.")
        )
        self.dialog.set_running(False)
        self.dialog.tell(
            "\n".join(filter(None, (headline, said))),
            (tr("Not written"), done.problems[:_LISTED]),
            (tr("What the format cannot hold"), done.losses),
        )


def _written(done: Converted) -> str:
    return tr(
        "{frames}, {elements} and {points} written to {path} ({format}).",
        frames=tr_count(done.frames, "{n:,} frame", "{n:,} frames"),
        elements=tr_count(done.elements, "{n:,} element", "{n:,} elements"),
        points=tr_count(done.points, "{n:,} point", "{n:,} points"),
        path=done.path,
        format=done.title,
    )
