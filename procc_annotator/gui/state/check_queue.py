"""Which frames' labels are checked next to the window's work: the whole set, and edited ones."""

from __future__ import annotations

from PySide6.QtCore import QObject, QTimer, Signal

from procc_annotator.gui.state.background_check import BackgroundCheck
from procc_annotator.gui.state.live_fit import LiveFit
from procc_annotator.gui.state.saying import say
from procc_annotator.gui.state.signals import Signals
from procc_annotator.gui.state.store import Store

_PATIENCE_MS = 400  # what is on screen is worked out before the frames that were left


class CheckQueue(QObject):
    """Has the whole set checked when asked, and edited frames once they were left.

    The frame on screen is not its business.
    """

    arrived = Signal(list)  # what was found: `Checked` each
    progressed = Signal(int, int)  # frames of the set checked, of how many; (0, 0): it is over
    told = Signal(dict)  # checks that got a finding from the set: name -> `FrameCheck`
    finished = Signal(int)  # frames of the set that were checked

    def __init__(self, store: Store, signals: Signals, live_fit: LiveFit, parent: QObject) -> None:
        super().__init__(parent)
        self._store, self._live_fit = store, live_fit
        self._edited: dict[str, None] = {}  # frames that nobody has checked since
        self._set_run, self._edited_run = BackgroundCheck(self), BackgroundCheck(self)
        self._soon = QTimer(self, singleShot=True, interval=_PATIENCE_MS)
        self._soon.timeout.connect(self._check_edited)
        for run in (self._set_run, self._edited_run):
            run.arrived.connect(self.arrived)
            run.failed.connect(self._say_failed)
            run.progressed.connect(self._go_on)
        self._set_run.progressed.connect(self.progressed)
        self._set_run.told.connect(self.told)
        self._set_run.finished.connect(self.finished)
        signals.frameChanged.connect(self._soon.start)

    @property
    def running(self) -> bool:
        """Return whether the set is being checked."""
        return self._set_run.running

    def check_set(self) -> None:
        """Check every annotated frame, with a camera where one may be fitted."""
        state, workspace = self._store.state, self._store.state.workspace
        if workspace is not None:
            names = enumerate(frame.name for frame in workspace.frames)
            frames = [(index, state.reveals(name)) for index, name in names]
            model = self._live_fit.model
            self._set_run.start(workspace, frames, state.field, model, together=True)

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
        state, workspace = self._store.state, self._store.state.workspace
        if workspace is None or self._edited_run.running or self._set_run.running:
            return  # the end of either begins anew
        here = state.frame_name or ""
        names = [name for name in self._edited if name != here and name in workspace.index]
        self._edited = {here: None} if here in self._edited else {}
        if names:
            wanted = self._live_fit.wanted
            frames = [(workspace.index[name], wanted and state.reveals(name)) for name in names]
            self._edited_run.start(workspace, frames, state.field, self._live_fit.model)

    def _say_failed(self, text: str) -> None:
        say(self._store, text, "error")
