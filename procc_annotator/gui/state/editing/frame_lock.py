"""The lock of the frame on screen: acquired before an edit, renewed, checked for other editors."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from procc_annotator.dataset.locks import FrameLocks, LockHolder, locks_folder

BEAT_MS = 10_000
_LOOK_MS = 2_000


class FrameLock(QObject):
    """The lock of the frame on screen. It is taken by the first gesture, not by looking."""

    changed = Signal()  # somebody else took or left the frame on screen
    freed = Signal()  # the frame on screen may be edited again; its file may be newer

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._locks: FrameLocks | None = None
        self._frame: str | None = None
        self._owned = False
        self.holder: LockHolder | None = None
        self._beat_timer = QTimer(self)
        self._beat_timer.setInterval(BEAT_MS)
        self._beat_timer.timeout.connect(self.beat)
        self._look_timer = QTimer(self)
        self._look_timer.setInterval(_LOOK_MS)
        self._look_timer.timeout.connect(self.look)

    def set_dataset(self, root: Path | None, author: str) -> None:
        """Give back the locks of the dataset before."""
        self.close()
        if root is not None:
            self._locks = FrameLocks(locks_folder(root), author)
            self._beat_timer.start()
            self._look_timer.start()

    def enter(self, frame: str | None) -> None:
        """Another frame is on screen."""
        self._release()
        self._frame = frame
        self.holder = self._look()

    def acquire(self) -> bool:
        """Take the frame on screen for editing; False when another person has it.

        Where it was not `still_owned`, its file may be newer by now: nothing here reads it again.
        """
        if self._locks is None or self._frame is None:
            return True
        if self.still_owned():
            return True
        self.holder = self._locks.acquire(self._frame)
        self._owned = self.holder is None
        if not self._owned:
            self.changed.emit()
        return self._owned

    def borrow(self, frame: str) -> LockHolder | None:
        """Lock a frame for one edit, whether it is on screen or not; who else has it, or None."""
        if self._locks is None or (frame == self._frame and self._owned):
            return None
        return self._locks.acquire(frame)

    def give_back(self, frame: str) -> None:
        """End what `borrow` began; the frame on screen stays taken."""
        if self._locks is not None and not (frame == self._frame and self._owned):
            self._locks.release(frame)

    @property
    def owned(self) -> bool:
        """Return whether this window has taken the frame on screen."""
        return self._owned

    def still_owned(self) -> bool:
        """As `owned`, after checking that the lock file was not removed."""
        if self._locks is None or self._frame is None or not self._owned:
            return self._owned
        if not self._locks.is_there(self._frame):
            self._owned = self._frame not in self._locks.beat()
        return self._owned

    def beat(self) -> None:
        """Show that this window still lives; notice when its lock was taken over or removed."""
        if self._locks is None or self._frame not in self._locks.beat():
            return
        self._owned = False
        if self.acquire():  # it was only removed; whoever had it meanwhile may have saved
            self.freed.emit()

    def look(self) -> None:
        """See whether another person took or left the frame on screen."""
        if self._owned:
            return
        before, self.holder = self.holder, self._look()
        if _who(before) != _who(self.holder):
            if self.holder is None:
                self.freed.emit()
            self.changed.emit()

    def close(self) -> None:
        """Give back everything."""
        self._beat_timer.stop()
        self._look_timer.stop()
        self._release()
        if self._locks is not None:
            self._locks.release_all()
        self._locks, self._frame, self.holder = None, None, None

    def set_author(self, author: str) -> None:
        """Others see this name from now on."""
        if self._locks is not None:
            self._locks.set_author(author)

    def _look(self) -> LockHolder | None:
        if self._locks is None or self._frame is None:
            return None
        return self._locks.holder(self._frame)

    def _release(self) -> None:
        if self._locks is not None and self._frame is not None and self._owned:
            self._locks.release(self._frame)
        self._owned = False


def _who(holder: LockHolder | None) -> tuple[str, str, float] | None:
    """A person, however long ago they were heard of."""
    return None if holder is None else (holder.author, holder.host, holder.since)
