"""Notices that a file was written, also by editors that put another one in its place."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QFileSystemWatcher, QObject, QTimer, Signal

from procc_annotator.dataset.saving import Stamp, stamp_of

_SETTLED_MS = 120  # editors write in several steps


class FileWatch(QObject):
    """Watches one file: it may be written, replaced, taken away and put back."""

    changed = Signal()  # it may hold something else now, or be gone

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.path: Path | None = None
        self._seen: Stamp = None
        self._watcher = QFileSystemWatcher(self)
        self._settled = QTimer(self, singleShot=True, interval=_SETTLED_MS)
        self._settled.timeout.connect(self._look)
        # A file that was replaced is noticed by its folder only.
        self._watcher.fileChanged.connect(self._wait)
        self._watcher.directoryChanged.connect(self._wait)

    def watch(self, path: Path | None) -> None:
        """Watch this file from now on, and no other; None: none."""
        if path == self.path:
            return
        self._settled.stop()
        # To leave a folder of 20,000 files and watch it again takes 14 ms: another file of the same
        # one keeps it.
        folder = None if path is None else str(path.parent)
        watched = [*self._watcher.files(), *self._watcher.directories()]
        if left := [one for one in watched if one != folder]:
            self._watcher.removePaths(left)
        self.path = path
        if path is not None:
            self._seen = stamp_of(path)
            if folder not in watched:
                self._watcher.addPath(str(folder))
            if self._seen is not None:
                self._watcher.addPath(str(path))

    def _wait(self) -> None:
        self._settled.start()

    def _look(self) -> None:
        if self.path is None:
            return
        if str(self.path) not in self._watcher.files() and self.path.exists():
            self._watcher.addPath(str(self.path))
        stamp = stamp_of(self.path)
        if stamp != self._seen:
            self._seen = stamp
            self.changed.emit()
