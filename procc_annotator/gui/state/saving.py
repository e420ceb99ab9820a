"""Saving after every finished edit: at once, again if it failed, never over others' work."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from datetime import datetime

from PySide6.QtCore import QObject, QTimer, Signal

from procc_annotator.errors import ChangedOnDiskError, InputError, SaveError
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.session.dataset.pending_save import PendingSave, write_together
from procc_annotator.session.dataset.workspace import Workspace

RETRY_MS = 5000


class Saver(QObject):
    """Writes frames of a workspace and remembers which could not be written.

    A frame that failed stays dirty and is tried again every few seconds; its reason is told once,
    until it changes. A frame whose file somebody else changed waits for a decision instead.
    """

    changed = Signal()  # which frames are not on disk
    saved = Signal()
    failed = Signal(str)  # one line, told once per reason
    reloaded = Signal(int)  # frame index: the annotation is now the one on disk

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._workspace: Workspace | None = None
        self._problems: dict[int, SaveError] = {}
        self._together: tuple[frozenset[int], Job] | None = None
        self.saved_at: datetime | None = None
        self.retry_timer = QTimer(self)
        self.retry_timer.setInterval(RETRY_MS)
        self.retry_timer.timeout.connect(self.retry)

    def set_workspace(self, workspace: Workspace | None) -> None:
        """Start anew with another dataset; the caller made sure that nothing unsaved is left."""
        self._workspace = workspace
        self._problems.clear()
        self.saved_at = None
        self.retry_timer.stop()
        self.changed.emit()

    @property
    def problems(self) -> dict[int, SaveError]:
        """Frame index -> why it is not on disk."""
        return dict(self._problems)

    def conflict(self, index: int) -> ChangedOnDiskError | None:
        """The frame's conflict with a change made outside, waiting for a decision."""
        problem = self._problems.get(index)
        return problem if isinstance(problem, ChangedOnDiskError) else None

    def save(self, index: int) -> bool:
        """Write a frame if it has unsaved changes; True when it is on disk."""
        if self._workspace is None:
            return True
        self._settle_together(index)
        if not self._workspace.state(index).dirty:
            # Undone until it is what was saved last; somebody may have changed the file since.
            if self.conflict(index) is not None and not self._workspace.knows_file(index):
                return False
            if self._problems.pop(index, None) is not None:
                self.changed.emit()
            return True
        try:
            self._workspace.save(index)
        except SaveError as error:
            self._note(index, error)
            return False
        self._settle(index)
        return True

    def save_all(self) -> bool:
        """Try every unsaved frame now; True when nothing is left."""
        if self._workspace is None:
            return True
        results = [self.save(index) for index in self._workspace.dirty_frames()]
        return all(results)

    def save_together(self, indices: Iterable[int], done: Callable[[], None]) -> None:
        """Write frames with unsaved changes in the background, several at a time.

        Saving one of them meanwhile, or beginning with others, waits for them.

        Args:
            indices: the frames.
            done: called once each is on disk or its `problems` say why it is not.
        """
        self.finish_together()
        prepared = [self._prepare(index) for index in indices]
        batch = [pending for pending in prepared if pending is not None]
        workspace = self._workspace
        database = workspace.database if workspace is not None else None

        def write(_: JobControl) -> list[tuple[PendingSave, SaveError | None]]:
            # What is replaced is a version on disk first, unless no versions can be written.
            if database is not None and not database.problem:
                database.flush()
            return write_together(batch)

        def take(written: list[tuple[PendingSave, SaveError | None]]) -> None:
            self._together = None
            for pending, error in written:
                self._take_written(pending, error)
            done()

        def give_up(text: str) -> None:
            # Which of them were written nobody knows. All stay dirty: the next try finds out.
            take([(pending, SaveError(f"{pending.path}: not saved: {text}")) for pending in batch])

        job = run_in_background(write, on_result=take, on_error=give_up, owner=self)
        self._together = frozenset(pending.index for pending in batch), job

    def finish_together(self) -> None:
        """Wait for what `save_together` began."""
        if self._together is not None:
            self._together[1].finish()

    def retry(self) -> None:
        """Try the failed frames again, except those that wait for a decision."""
        for index in sorted(self._problems):
            if self.conflict(index) is None:
                self.save(index)

    def overwrite(self, index: int) -> bool:
        """Decide a conflict: what is on screen replaces the file."""
        if self._workspace is None:
            return True
        self._settle_together(index)
        try:
            self._workspace.overwrite(index)
        except SaveError as error:
            self._note(index, error)
            return False
        self._settle(index)
        return True

    def reload(self, index: int) -> None:
        """Decide a conflict: the file replaces what is on screen (undo brings it back)."""
        if self._workspace is None:
            return
        self._settle_together(index)
        try:
            self._workspace.reload(index)
        except InputError as error:
            self.failed.emit(str(error))
            return
        self._settle(index)
        self.reloaded.emit(index)

    def _settle_together(self, index: int) -> None:
        if self._together is not None and index in self._together[0]:
            self.finish_together()

    def _prepare(self, index: int) -> PendingSave | None:
        try:
            return self._workspace.prepare_save(index) if self._workspace is not None else None
        except SaveError as error:
            self._note(index, error)
            return None

    def _take_written(self, pending: PendingSave, error: SaveError | None) -> None:
        if self._workspace is None:
            return
        self._workspace.note_saved(pending, error)
        if error is None:
            self._settle(pending.index)
        else:
            self._note(pending.index, error)

    def _note(self, index: int, error: SaveError) -> None:
        known = self._problems.get(index)
        self._problems[index] = error
        if not isinstance(error, ChangedOnDiskError):
            self.retry_timer.start()
        self.changed.emit()
        if known is None or str(known) != str(error):
            self.failed.emit(str(error))

    def _settle(self, index: int) -> None:
        failed_before = self._problems.pop(index, None) is not None
        self.saved_at = datetime.now()
        if all(self.conflict(i) is not None for i in self._problems):
            self.retry_timer.stop()
        self.saved.emit()
        if failed_before:
            self.changed.emit()
