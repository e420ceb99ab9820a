"""Edits of many frames, a little at a time; their files are written in the background."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from time import perf_counter

from PySide6.QtCore import QObject, Signal

from procc_annotator.gui.soon import soon
from procc_annotator.gui.state.auditing import Auditing
from procc_annotator.gui.state.editing import Editing
from procc_annotator.gui.state.signals import Signals
from procc_annotator.gui.state.store import Store

_SLICE_S = 0.008
_TOGETHER = 32

# Edits a frame and locks it; why it left the frame as it was, not locked, or "" where it did not.
EditFrame = Callable[[int], str]


@dataclass
class EditedFrames:
    """What became of the frames.

    Attributes:
        total: how many were to be edited.
        edited: those that are, and are saved.
        left: (index, why) of those that were left as they were.
        unsaved: (index, why) of those that could not be saved.
        waiting: how many no one came to: it was stopped.
    """

    total: int = 0
    edited: list[int] = field(default_factory=list)
    left: list[tuple[int, str]] = field(default_factory=list)
    unsaved: list[tuple[int, str]] = field(default_factory=list)
    waiting: int = 0


class ManyEdits(QObject):
    """Goes through frames, one run at a time. Edits are made on the interface thread: a slice of
    them between what else happens there."""

    progressed = Signal(int, int)  # frames that were gone through, and all
    finished = Signal(object)  # EditedFrames

    def __init__(
        self,
        store: Store,
        signals: Signals,
        editing: Editing,
        auditing: Auditing,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._store, self._signals = store, signals
        self._editing, self._auditing = editing, auditing
        self._outcome: EditedFrames | None = None
        self._edit: EditFrame = lambda _: ""
        self._stopped = False
        self._waiting: list[int] = []
        self._batch: list[int] = []  # edited and not handed over to be written yet
        self._written: list[int] = []  # being written
        self._next = soon(self, self._take_some)

    @property
    def running(self) -> bool:
        """Return whether frames are still to be edited or written."""
        return self._outcome is not None

    def start(self, indices: Sequence[int], edit: EditFrame) -> None:
        """Edit these frames in their order."""
        self._edit, self._stopped = edit, False
        self._waiting, self._batch, self._written = list(indices)[::-1], [], []
        self._outcome = EditedFrames(len(indices))
        self._next.start()

    def stop(self) -> None:
        """Edit no further frame; what is edited is saved, and reported."""
        if self._outcome is not None:
            self._next.stop()
            self._stopped = True
            if not self._written:
                self._save_batch()
            self._editing.saver.settle()

    def forget(self) -> None:
        """Edit no further frame and say nothing: the dataset or the window closes."""
        self._next.stop()
        self._outcome = None

    def _take_some(self) -> None:
        end = perf_counter() + _SLICE_S
        assert self._outcome is not None
        while self._waiting and len(self._batch) < _TOGETHER and perf_counter() < end:
            index = self._waiting.pop()
            if why := self._edit(index):
                self._outcome.left.append((index, why))
            else:
                self._batch.append(index)
        if self._waiting and len(self._batch) < _TOGETHER:
            self._next.start()
        else:
            self._save_batch()

    def _save_batch(self) -> None:
        self._written, self._batch = self._batch, []
        self._editing.saver.save_together(self._written, self._batch_saved)

    def _batch_saved(self) -> None:
        workspace, outcome = self._store.state.workspace, self._outcome
        if workspace is None or outcome is None:
            return
        for index in self._written:
            problem = workspace.state(index).save_error
            self._editing.presence.give_back(workspace.frames[index].name)
            if problem is None:
                outcome.edited.append(index)
            else:
                outcome.unsaved.append((index, str(problem)))
        self._written = []
        self.progressed.emit(outcome.total - len(self._waiting), max(1, outcome.total))
        if self._waiting and not self._stopped:
            self._next.start()
        else:
            self._finish(outcome)

    def _finish(self, outcome: EditedFrames) -> None:
        self._outcome = None
        outcome.waiting = len(self._waiting)
        workspace = self._store.state.workspace
        if outcome.edited and workspace is not None:
            self._signals.framesEdited.emit(outcome.edited)
            self._auditing.frames_edited([workspace.frames[i].name for i in outcome.edited])
        self.finished.emit(outcome)
