"""Saving after every finished edit, off the GUI thread, and the lock of the frame on screen."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from procc_annotator.dataset.locks import FrameLocks, LockHolder, locks_folder
from procc_annotator.dataset.saving import SaveResult
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ChangedOnDiskError, InputError, SaveError
from procc_annotator.gui.state.background import Job, Priority, after_paint, run_in_background
from procc_annotator.gui.state.messages import notify, withdraw
from procc_annotator.gui.state.state import UNSAVED
from procc_annotator.gui.state.store import Store
from procc_annotator.translation import tr

BEAT_MS = 10_000
_LOOK_MS = 2_000


class FrameLock(QObject):
    """The lock of the frame on screen. It is taken by the first gesture, not by looking."""

    freed = Signal()  # the frame on screen may be edited again; its file may be newer

    def __init__(self, store: Store) -> None:
        super().__init__(store)
        self._store = store
        self._locks: FrameLocks | None = None
        self._frame: str | None = None
        self.owned = False
        self._beat_timer = QTimer(self, interval=BEAT_MS)
        self._beat_timer.timeout.connect(self.beat)
        self._look_timer = QTimer(self, interval=_LOOK_MS)
        self._look_timer.timeout.connect(self.look)

    def set_dataset(self, root: Path, author: str) -> None:
        """Give back the locks of the dataset before."""
        self.close()
        self._locks = FrameLocks(locks_folder(root), author)
        self._beat_timer.start()
        self._look_timer.start()

    def enter(self, frame: str | None) -> LockHolder | None:
        """Another frame is on screen; return who else is editing it."""
        self._release()
        self._frame = frame
        return self._look()

    def acquire(self) -> bool:
        """Take the frame on screen for editing; False when another person has it.

        Where it was not `still_owned`, its file may be newer by now: nothing here reads it again.
        """
        if self._locks is None or self._frame is None or self.still_owned():
            return True
        holder = self._locks.acquire(self._frame)
        self.owned = holder is None
        self._store.update(holder=holder)
        return self.owned

    def borrow(self, frame: str) -> LockHolder | None:
        """Lock a frame for one edit, whether it is on screen or not; who else has it, or None."""
        if self._locks is None or (frame == self._frame and self.owned):
            return None
        return self._locks.acquire(frame)

    def give_back(self, frame: str) -> None:
        """End what `borrow` began; the frame on screen stays taken."""
        if self._locks is not None and not (frame == self._frame and self.owned):
            self._locks.release(frame)

    def still_owned(self) -> bool:
        """As `owned`, after checking that the lock file was not removed."""
        if self._locks is None or self._frame is None or not self.owned:
            return self.owned
        if not self._locks.is_there(self._frame):
            self.owned = self._frame not in self._locks.beat()
        return self.owned

    def beat(self) -> None:
        """Show that this window still lives; notice when its lock was taken over or removed."""
        if self._locks is None or self._frame not in self._locks.beat():
            return
        self.owned = False
        if self.acquire():  # it was only removed; whoever had it meanwhile may have saved
            self.freed.emit()

    def look(self) -> None:
        """See whether another person took or left the frame on screen."""
        if self.owned:
            return
        holder = self._look()
        if _who(self._store.state.holder) != _who(holder):
            if holder is None:
                self.freed.emit()
            self._store.update(holder=holder)

    def close(self) -> None:
        """Give back everything."""
        self._beat_timer.stop()
        self._look_timer.stop()
        self._release()
        if self._locks is not None:
            self._locks.release_all()
        self._locks = self._frame = None

    def set_author(self, author: str) -> None:
        """Others see this name from now on."""
        if self._locks is not None:
            self._locks.set_author(author)

    def _look(self) -> LockHolder | None:
        if self._locks is None or self._frame is None:
            return None
        return self._locks.holder(self._frame)

    def _release(self) -> None:
        if self._locks is not None and self._frame is not None and self.owned:
            self._locks.release(self._frame)
        self.owned = False


def _who(holder: LockHolder | None) -> tuple[str, str, float] | None:
    """A person, however long ago they were heard of."""
    return None if holder is None else (holder.author, holder.host, holder.since)


RETRY_MS = 5000


class Saver(QObject):
    """Writes frames of a workspace and remembers which could not be written.

    The disk is waited for behind the interface's thread, by one write at a time. Anyone who leaves
    a frame, looks at its file or gives it to others settles what is under way first.

    A frame that failed stays dirty and is tried again every few seconds; its reason is reported
    once, until it changes. A frame whose file another person changed waits for a decision instead.
    """

    begun = Signal()  # something is being written, or about to be
    saved = Signal()
    settled = Signal()  # nothing is being written any more
    reloaded = Signal(int)  # frame index: the annotation is now the one on disk

    def __init__(self, store: Store) -> None:
        super().__init__(store)
        self._store = store
        self._workspace: Workspace | None = None
        self._writing: tuple[frozenset[int], Job] | None = None
        self._again: set[int] = set()  # edited since, or not begun with yet
        self._soon = after_paint(self, self._begin)
        self.saved_at: datetime | None = None
        self.retry_timer = QTimer(self, interval=RETRY_MS)
        self.retry_timer.timeout.connect(self.retry)

    def set_workspace(self, workspace: Workspace) -> None:
        """Start anew with another dataset; the caller made sure that nothing unsaved is left."""
        self._workspace = workspace
        self.saved_at = None
        self.retry_timer.stop()
        self._set_problems({})

    @property
    def problems(self) -> Mapping[int, SaveError]:
        """Frame index -> why it is not on disk."""
        return self._store.state.unsaved

    def _set_problems(self, problems: Mapping[int, SaveError]) -> None:
        self._store.update(unsaved=problems)
        if not problems:
            withdraw(self._store, UNSAVED)

    def _fail(self, error: Exception) -> None:
        notify(self._store, UNSAVED, str(error), "error", remedy="save_copies")

    def conflict(self, index: int) -> ChangedOnDiskError | None:
        """The frame's conflict with a change made outside, waiting for a decision."""
        problem = self.problems.get(index)
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
        return index not in self.problems

    def save_all(self) -> bool:
        """Try every unsaved frame now; True when nothing is left."""
        self.settle()
        if self._workspace is None:
            return True
        results = [self.save(index) for index in self._workspace.dirty_frames()]
        return all(results)

    def save_together(self, indices: Iterable[int], done: Callable[[], None]) -> None:
        """Write frames with unsaved changes in the background, several at a time; ``done`` is
        called once each is on disk or its `problems` say why it is not."""
        self.settle()
        self._write(indices, done)

    def settle(self, index: int | None = None) -> None:
        """Wait for what is under way for a frame, or for all: then it is kept, or among the
        `problems`."""
        if self._writing is None and (index is None or index in self._again):
            self._begin()
        while (writing := self._writing) is not None:
            frames, job = writing
            if index is not None and index not in frames | self._again:
                return
            job.finish()
            if self._writing is writing:  # the program ends, and nothing is told any more
                return

    def retry(self) -> None:
        """Try the failed frames again, except those that wait for a decision."""
        for index in sorted(self.problems):
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
            self._fail(error)
            return
        self._note_kept(index)
        self.reloaded.emit(index)

    def _has_changes(self, index: int) -> bool:
        """Return whether a frame is to be written; if not, whatever failed before is over."""
        if self._workspace is None or self._workspace.state(index).dirty:
            return self._workspace is not None
        # Undone until it is what was saved last; a person may have changed the file since.
        decided = self.conflict(index) is None or self._workspace.knows_file(index)
        if decided and index in self.problems:
            self._set_problems({i: why for i, why in self.problems.items() if i != index})
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
        self._writing = frozenset(pending.index for pending in batch), job
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
        known = self.problems.get(index)
        if not isinstance(error, ChangedOnDiskError):
            self.retry_timer.start()
        self._set_problems({**self.problems, index: error})
        if known is None or str(known) != str(error):
            self._fail(error)

    def _note_kept(self, index: int) -> None:
        others = {i: why for i, why in self.problems.items() if i != index}
        self.saved_at = datetime.now()
        if all(isinstance(why, ChangedOnDiskError) for why in others.values()):
            self.retry_timer.stop()
        self.saved.emit()
        if index in self.problems:
            self._set_problems(others)
