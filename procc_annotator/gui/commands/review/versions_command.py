"""Look at the earlier versions of a frame and bring one back."""

from __future__ import annotations

from PySide6.QtWidgets import QWidget

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset import editing
from procc_annotator.dataset.records import OriginKind
from procc_annotator.dataset.workspace import restore_version
from procc_annotator.errors import InputError, SaveError, UsageError
from procc_annotator.gui.commands.review.versions_dialog import VersionRow, VersionsDialog
from procc_annotator.gui.state.document import Document
from procc_annotator.translation import tr, translatable


class Versions:
    """Slot of the action."""

    def __init__(self, document: Document, parent: QWidget) -> None:
        self._document = document
        self._parent = parent

    def ask(self) -> None:
        """Show every saved version of the frame on screen; a chosen one becomes an edit."""
        document = self._document
        document.store.events.aboutToLeave.emit()
        document.saver.settle()  # what is written is a version too
        workspace, frame = document.state.workspace, document.state.frame
        database = document.review.database
        if workspace is None or frame is None or database is None:
            document.say(tr("open a folder of pictures first"))
            return
        rows = [VersionRow(v.id, v.author, v.time, v.reason) for v in database.versions(frame.name)]
        index = document.state.frame_index

        def read(version: str) -> FrameAnnotation:
            return workspace.parse(index, database.version_data(version))

        dialog = VersionsDialog(
            self._parent,
            rows,
            read,
            document.walk.picture,
            document.state.field,
            document.state.picture_size or (2, 2),
            current=document.state.annotation,
        )
        if dialog.exec() and dialog.chosen_id is not None:
            apply_version(document, dialog.chosen_id)
        dialog.deleteLater()


def apply_version(document: Document, version: str) -> None:
    """Make a saved version the annotation of the frame on screen; undo takes it back. Where the
    file cannot be read, it is replaced, and stays a version."""
    workspace, database = document.state.workspace, document.review.database
    if workspace is None or database is None:
        return
    seen, index = document.state.annotation, document.state.frame_index
    if document.state.damage:
        document.editing.look_at_frame()  # somebody may have mended it
    try:
        data = database.version_data(version)
        restored = workspace.parse(index, data)
        if document.state.damage:
            restore_version(workspace, index, data)
            document.editing.reload_frame()
            document.say(tr("the earlier version is back; what could not be read stays a version"))
            return
    except (InputError, SaveError) as error:
        document.say(str(error), "error")
        return

    def restore(annotation: FrameAnnotation) -> FrameAnnotation:
        if annotation is not seen:  # nobody decided to give up what somebody else just saved
            raise UsageError(tr("the frame was changed elsewhere: look at it, then restore again"))
        return editing.add_unconfirmed(restored, annotation.unconfirmed)

    if document.editing.edit(translatable("restore an earlier version"), restore, OriginKind.FILE):
        document.say(tr("the earlier version is back; undo takes it away again"))
