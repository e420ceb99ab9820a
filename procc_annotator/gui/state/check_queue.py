"""Which frames' labels are checked beside the window's work: the whole set, and edited ones."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal

from procc_annotator.gui.state.background_check import BackgroundCheck

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document

_PATIENCE_MS = 400  # what is on screen is worked out before the frames that were left


class CheckQueue(QObject):
    """Has the whole set checked when asked, and edited frames once they were left.

    The frame on screen is not its business.
    """

    arrived = Signal(list)  # what was found: `Checked` each
    progressed = Signal(int, int)  # frames of the set checked, of how many; (0, 0): it is over
    finished = Signal(int)  # frames of the set that were checked

    def __init__(self, document: Document, may_fit: Callable[[str], bool], parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._may_fit = may_fit  # whether a camera may be fitted to a frame (its name)
        self._edited: dict[str, None] = {}  # frames that nobody has checked since
        self._set_run, self._edited_run = BackgroundCheck(self), BackgroundCheck(self)
        self._soon = QTimer(self, singleShot=True, interval=_PATIENCE_MS)
        self._soon.timeout.connect(self._check_edited)
        for run in (self._set_run, self._edited_run):
            run.arrived.connect(self.arrived)
            run.failed.connect(lambda text: document.message.emit(text, "error"))
            run.progressed.connect(self._go_on)
        self._set_run.progressed.connect(self.progressed)
        self._set_run.finished.connect(self.finished)
        document.frameChanged.connect(self._soon.start)

    @property
    def running(self) -> bool:
        """Whether the set is being checked."""
        return self._set_run.running

    def check_set(self) -> None:
        """Check every annotated frame, with a camera where one may be fitted."""
        workspace = self._document.workspace
        if workspace is not None:
            names = enumerate(frame.name for frame in workspace.frames)
            frames = [(index, self._may_fit(name)) for index, name in names]
            model = self._document.live_fit.model
            self._set_run.start(workspace, frames, self._document.field, model)

    def stop(self) -> None:
        """Stop checking the set; what was found so far arrives."""
        self._set_run.stop()

    def add(self, frame: str) -> None:
        """A frame was edited: it is checked once it is not on screen, unless `drop` comes first."""
        self._edited[frame] = None
        self._soon.start()

    def drop(self, frame: str) -> None:
        """A frame has been checked as it is."""
        self._edited.pop(frame, None)

    def close(self) -> None:
        """Stop everything and forget which frames are waiting."""
        self._edited.clear()
        self._soon.stop()
        self._set_run.close()
        self._edited_run.close()

    def _go_on(self, _: int, total: int) -> None:
        if not total:
            self._soon.start()

    def _check_edited(self) -> None:
        document, workspace = self._document, self._document.workspace
        if workspace is None or self._edited_run.running or self._set_run.running:
            return  # the end of either begins anew
        here = document.frame.name if document.frame is not None else ""
        names = [name for name in self._edited if name != here and name in workspace.index]
        self._edited = {here: None} if here in self._edited else {}
        if names:
            wanted = document.live_fit.wanted
            frames = [(workspace.index[name], wanted and self._may_fit(name)) for name in names]
            self._edited_run.start(workspace, frames, document.field, document.live_fit.model)
