"""Follows what other windows and programs write: annotation and camera files."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from procc_annotator.errors import ProccError
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.file_watch import FileWatch
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.session.dataset.camera_set import CameraSet
from procc_annotator.session.dataset.file_stamps import Stamp

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document


@dataclass(frozen=True, eq=False, slots=True)
class _Newer:
    """Cameras of a source as they are on disk by now, or why they cannot be read."""

    source: CameraSource
    before: CameraSet
    cameras: CameraSet | None
    frames: frozenset[str]
    problem: str = ""


class OutsideChanges(QObject):
    """Looks at the files of the set when somebody asks, and watches that of the frame on screen."""

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document
        self._job: Job | None = None
        self._again = False
        self._watch = FileWatch(self)
        self._watch.changed.connect(document.look_at_frame)

    def watch_frame(self) -> None:
        """Another frame is on screen."""
        frame = self._document.frame
        self._watch.watch(None if frame is None else frame.annotation_path)

    def look(self) -> None:
        """See which files were written since they were read, in the background, and follow them;
        where cameras are written, read them anew."""
        self._document.look_at_frame()
        if self._job is not None:
            self._again = True
            return
        workspace = self._document.workspace
        if workspace is None:
            return
        sources = [(s, s.files) for s in self._document.sources if s.files is not None]

        def work(control: JobControl) -> tuple[dict[int, Stamp], list[_Newer]]:
            stopped = lambda: control.cancelled  # noqa: E731
            looked = [_look_at(source, cameras, stopped) for source, cameras in sources]
            return workspace.changed_outside(stopped), [found for found in looked if found]

        def done(found: tuple[dict[int, Stamp], list[_Newer]]) -> None:
            self._job = None
            if workspace is self._document.workspace:
                for newer in found[1]:
                    self._take_cameras(newer)
                self._take(found[0])
            self._look_again()

        def failed(text: str) -> None:
            self._job = None
            self._document.message.emit(text, "error")

        self._job = run_in_background(work, on_result=done, on_error=failed, owner=self)

    def close(self) -> None:
        """Look no more."""
        self._watch.watch(None)
        self._again = False
        if self._job is not None:
            self._job.cancel()
            self._job = None

    # --- inside ---

    def _look_again(self) -> None:
        again, self._again = self._again, False
        if again:
            self.look()

    def _take_cameras(self, newer: _Newer) -> None:
        document, source = self._document, newer.source
        if source not in document.sources or source.camera_set is not newer.before:
            return  # removed, or loaded again meanwhile
        if newer.cameras is None:
            document.message.emit(f"cameras of {source.name} changed: {newer.problem}", "warning")
            return
        document.add_source(newer.cameras, active=False, changed=newer.frames)
        document.message.emit(f"cameras of {source.name} changed on disk: read again", "info")

    def _take(self, changed: Mapping[int, Stamp]) -> None:
        document, workspace = self._document, self._document.workspace
        if workspace is None or not changed:
            return
        unsaved = set(workspace.dirty_frames())
        here = document.frame_index
        workspace.follow({i: stamp for i, stamp in changed.items() if i != here})
        document.look_at_frame()
        others = [i for i in changed if i != here and i not in unsaved]
        if others:
            document.judge_frames_again([workspace.frames[i].name for i in others])
            document.framesEdited.emit(others)


def _look_at(
    source: CameraSource, cameras: CameraSet, stopped: Callable[[], bool]
) -> _Newer | None:
    try:
        found = cameras.look_again(stopped)
    except (ProccError, OSError) as error:
        return _Newer(source, cameras, None, frozenset(), str(error))
    return None if found is None else _Newer(source, cameras, *found)
