"""Saving after every finished edit: at once but behind the interface's thread, again if it failed,
never over others' work."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from datetime import datetime

from PySide6.QtCore import QObject, QTimer, Signal

from procc_annotator.dataset.saving import SaveResult
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ChangedOnDiskError, InputError, SaveError
from procc_annotator.gui.state.background import Job, Priority, after_paint, run_in_background
from procc_annotator.translation import tr

RETRY_MS = 5000


@dataclass(frozen=True, slots=True)
class _Writing:
    """A save in progress."""

    frames: frozenset[int]
    job: Job


class Saver(QObject):
    """Writes frames of a workspace and remembers which could not be written.

    The disk is waited for behind the interface's thread, by one write at a time. Anyone who leaves
    a frame, looks at its file or gives it to others settles what is under way first.

    A frame that failed stays dirty and is tried again every few seconds; its reason is reported
    once, until it changes. A frame whose file another person changed waits for a decision instead.
    """

    changed = Signal()  # which frames are not on disk
    begun = Signal()  # something is being written, or about to be
    saved = Signal()
    settled = Signal()  # nothing is being written any more
    failed = Signal(str)  # one line, told once per reason
    reloaded = Signal(int)  # frame index: the annotation is now the one on disk

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._workspace: Workspace | None = None
        self._problems: dict[int, SaveError] = {}
        self._writing: _Writing | None = None
        self._again: set[int] = set()  # edited since, or not begun with yet
        self._soon = after_paint(self, self._begin)
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

    @property
    def under_way(self) -> bool:
        """Return whether something is being written, or about to be: until it is kept nothing says
        that it is saved."""
        return self._writing is not None or bool(self._again)

    def save_soon(self, index: int) -> None:
        """As `save_behind`, after the next paint: the writing thread would take the interpreter
        from it."""
        if self.under_way:
            self._again.add(index)
        elif self._has_changes(index):
            self._again.add(index)
            self._soon.start()
            self.begun.emit()

    def save_behind(self, index: int) -> None:
        """Write a frame if it has unsaved changes, without waiting for the disk. What is written
        already goes on, and the frame is saved again on its result."""
        if self._writing is not None:
            self._again.add(index)
        elif self._has_changes(index):
            self._write([index], lambda: None)

    def save(self, index: int) -> bool:
        """Write a frame if it has unsaved changes; True when it is on disk."""
        self.settle(index)
        self.save_behind(index)
        self.settle(index)
        return index not in self._problems

    def save_all(self) -> bool:
        """Try every unsaved frame now; True when nothing is left."""
        self.settle()
        if self._workspace is None:
            return True
        results = [self.save(index) for index in self._workspace.dirty_frames()]
        return all(results)

    def save_together(self, indices: Iterable[int], done: Callable[[], None]) -> None:
        """Write frames with unsaved changes in the background, several at a time.

        Args:
            indices: the frames.
            done: called once each is on disk or its `problems` say why it is not.
        """
        self.settle()
        self._write(indices, done)

    def settle(self, index: int | None = None) -> None:
        """Wait for what is under way for a frame, or for all: then it is kept, or among the
        `problems`."""
        if self._writing is None and (index is None or index in self._again):
            self._begin()
        while (writing := self._writing) is not None:
            if index is not None and index not in writing.frames | self._again:
                return
            writing.job.finish()
            if self._writing is writing:  # the program ends, and nothing is told any more
                return

    def retry(self) -> None:
        """Try the failed frames again, except those that wait for a decision."""
        for index in sorted(self._problems):
            if self.conflict(index) is None:
                self.save_behind(index)

    def overwrite(self, index: int) -> bool:
        """Decide a conflict: what is on screen replaces the file."""
        self.settle(index)
        if self._workspace is None:
            return True
        try:
            self._workspace.overwrite(index)
        except SaveError as error:
            self._note(index, error)
            return False
        self._note_kept(index)
        return True

    def reload(self, index: int) -> None:
        """Decide a conflict: the file replaces what is on screen (undo brings it back)."""
        self.settle(index)
        if self._workspace is None:
            return
        try:
            self._workspace.reload(index)
        except InputError as error:
            self.failed.emit(str(error))
            return
        self._note_kept(index)
        self.reloaded.emit(index)

    def _has_changes(self, index: int) -> bool:
        """Return whether a frame is to be written; if not, whatever failed before is over."""
        if self._workspace is None or self._workspace.state(index).dirty:
            return self._workspace is not None
        # Undone until it is what was saved last; a person may have changed the file since.
        decided = self.conflict(index) is None or self._workspace.knows_file(index)
        if decided and self._problems.pop(index, None) is not None:
            self.changed.emit()
        return False

    def _write(self, indices: Iterable[int], done: Callable[[], None]) -> None:
        """Begin to write; nothing else is under way."""
        workspace = self._workspace
        assert workspace is not None
        batch = workspace.prepare_saves(indices)

        def take(results: list[SaveResult]) -> None:
            self._writing = None
            for written in results:
                workspace.note_saved(written)
            # Anyone who hears of one may look at the others, too.
            for written in results:
                if written.error is None:
                    self._note_kept(written.save.index)
                else:
                    self._note(written.save.index, written.error)
            try:
                done()
            finally:
                self._write_again()

        def give_up(text: str) -> None:
            # Which of them were written no one knows. All stay dirty: the next try finds out.
            error = tr("not saved: {why}", why=text)
            take([SaveResult(p, SaveError(f"{p.path}: {error}"), unsure=True) for p in batch])

        job = run_in_background(
            lambda _: workspace.write(batch),
            on_result=take,
            on_error=give_up,
            owner=self,
            priority=Priority.IMMEDIATE,
        )
        self._writing = _Writing(frozenset(pending.index for pending in batch), job)
        self.begun.emit()

    def _begin(self) -> None:
        """Write what was to be begun with, unless that was done."""
        if self._again and self._writing is None:
            self._write_again()

    def _write_again(self) -> None:
        """Write the frames that were edited during the last save."""
        again, self._again = self._again, set()
        for index in sorted(again):
            self.save_behind(index)
        if self._writing is None:
            self.settled.emit()

    def _note(self, index: int, error: SaveError) -> None:
        known = self._problems.get(index)
        self._problems[index] = error
        if not isinstance(error, ChangedOnDiskError):
            self.retry_timer.start()
        self.changed.emit()
        if known is None or str(known) != str(error):
            self.failed.emit(str(error))

    def _note_kept(self, index: int) -> None:
        failed_before = self._problems.pop(index, None) is not None
        self.saved_at = datetime.now()
        if all(self.conflict(i) is not None for i in self._problems):
            self.retry_timer.stop()
        self.saved.emit()
        if failed_before:
            self.changed.emit()
