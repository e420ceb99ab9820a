"""Watches files that other windows and programs write: annotations and cameras."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from PySide6.QtCore import QFileSystemWatcher, QObject, QTimer

from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.saving import Stamp, stamp_of
from procc_annotator.errors import ProccError
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.editing.editor import Editing
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.scoring.commands import CameraSourceCommands
from procc_annotator.gui.state.scoring.dataset_scores import DatasetScoring
from procc_annotator.gui.state.store import Store
from procc_annotator.translation import tr

_SETTLED_MS = 120  # editors write in several steps


class FileWatch(QObject):
    """Watches one file: it may be written, replaced, taken away and put back."""

    def __init__(self, parent: QObject, written: Callable[[], object]) -> None:
        """``written`` is called when the file may hold something else, or is gone."""
        super().__init__(parent)
        self._written = written
        self.path: Path | None = None
        self._seen: Stamp = None
        self._watcher = QFileSystemWatcher(self)
        self._settled = QTimer(self, singleShot=True, interval=_SETTLED_MS)
        self._settled.timeout.connect(self._look)
        # A file that was replaced is noticed by its folder only.
        self._watcher.fileChanged.connect(self._settled.start)
        self._watcher.directoryChanged.connect(self._settled.start)

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

    def _look(self) -> None:
        if self.path is None:
            return
        if str(self.path) not in self._watcher.files() and self.path.exists():
            self._watcher.addPath(str(self.path))
        stamp = stamp_of(self.path)
        if stamp != self._seen:
            self._seen = stamp
            self._written()


@dataclass(frozen=True, eq=False, slots=True)
class _Newer:
    """Cameras of a source as they are on disk by now, or why they cannot be read."""

    source: CameraSource
    before: CameraSet
    cameras: CameraSet | None
    frames: frozenset[str]
    problem: str = ""


class OutsideChanges(QObject):
    """Looks at the files of the set on request, and watches that of the frame on screen."""

    def __init__(
        self,
        store: Store,
        editing: Editing,
        sources: CameraSourceCommands,
        scoring: DatasetScoring,
    ) -> None:
        super().__init__(store)
        self._store = store
        self._editing, self._sources, self._scoring = editing, sources, scoring
        self._looking = LatestOnlyTask(self, partial(say, store, level="error"))
        self._again = False
        self.watch = FileWatch(self, editing.look_at_frame)

    def look(self) -> None:
        """See which files were written since they were read, in the background, and follow them;
        where cameras are written, read them anew."""
        self._editing.look_at_frame()
        if self._looking.running:
            self._again = True
            return
        workspace = self._store.state.workspace
        if workspace is None:
            return
        sources = [(s, s.files) for s in self._store.state.sources if s.files is not None]

        def work(control: JobControl) -> tuple[dict[int, Stamp], list[_Newer]]:
            stopped = lambda: control.cancelled  # noqa: E731
            looked = [
                _look_at(source, cameras, workspace.index, stopped) for source, cameras in sources
            ]
            return workspace.changed_outside(stopped), [found for found in looked if found]

        def done(found: tuple[dict[int, Stamp], list[_Newer]]) -> None:
            if workspace is self._store.state.workspace:
                for newer in found[1]:
                    self._take_cameras(newer)
                self._take(found[0])
            self._look_again()

        self._looking.start(work, done)

    def close(self) -> None:
        """Look no more."""
        self.watch.watch(None)
        self._again = False
        self._looking.cancel()

    # --- inside ---

    def _look_again(self) -> None:
        again, self._again = self._again, False
        if again:
            self.look()

    def _take_cameras(self, newer: _Newer) -> None:
        source = newer.source
        if source not in self._store.state.sources or source.camera_set is not newer.before:
            return  # removed, or loaded again meanwhile
        if newer.cameras is None:
            text = tr("cameras of {name} changed: {why}", name=source.name, why=newer.problem)
            say(self._store, text, "warning")
            return
        self._sources.add_source(newer.cameras, active=False, changed=newer.frames)
        say(self._store, tr("cameras of {name} changed on disk: read again", name=source.name))

    def _take(self, changed: Mapping[int, Stamp]) -> None:
        state = self._store.state
        workspace, here = state.workspace, state.frame_index
        if workspace is None or not changed:
            return
        unsaved = set(workspace.dirty_frames())
        workspace.follow({i: stamp for i, stamp in changed.items() if i != here})
        self._editing.look_at_frame()
        others = [i for i in changed if i != here and i not in unsaved]
        if others:
            self._scoring.frames_edited([workspace.frames[i].name for i in others])
            self._store.events.framesEdited.emit(others)


def _look_at(
    source: CameraSource, cameras: CameraSet, frames: Iterable[str], stopped: Callable[[], bool]
) -> _Newer | None:
    try:
        found = cameras.look_again(frames, stopped)
    except (ProccError, OSError) as error:
        return _Newer(source, cameras, None, frozenset(), str(error))
    return None if found is None else _Newer(source, cameras, *found)
