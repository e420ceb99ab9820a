"""The files of a dataset's landmarks as others write them: ``landmarks.json`` and ``views.csv``."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from procc_annotator.dataset.landmarks.dataset_landmarks import (
    read_landmarks_in,
    unknown_frames_message,
)
from procc_annotator.dataset.landmarks.view_groups import ViewGroups
from procc_annotator.dataset.layout import VIEWS_FILE
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.formats.landmark_file import LANDMARKS_FILE, LandmarkFile
from procc_annotator.gui.state.derived import Derived, Inputs, Where
from procc_annotator.gui.state.file_watch import FileWatch


class LandmarkFiles(QObject):
    """Reads both files again, in the background, whenever one of them was written."""

    read = Signal(LandmarkFile, ViewGroups, str)  # and of rows that name no frame
    damaged = Signal(str)  # why they cannot be used

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._workspace: Workspace | None = None
        self._writes = 0  # that were seen; what was there before is known
        self._found = Derived(self._written, _read, Where.BESIDE, self)
        self._found.changed.connect(self._deliver)
        self._watches = {name: FileWatch(self) for name in (LANDMARKS_FILE, VIEWS_FILE)}
        for watch in self._watches.values():
            watch.changed.connect(self.read_again)

    def watch(self, workspace: Workspace | None) -> None:
        """Watch the files of this dataset from now on; None: of none."""
        self._found.forget()
        self._workspace, self._writes = workspace, 0
        for name, watch in self._watches.items():
            watch.watch(None if workspace is None else workspace.folder / name)

    def note_written(self) -> None:
        """What is being read may be older than what was written just now: it is read again."""
        if self._found.working:
            self.read_again()

    def read_again(self) -> None:
        """Read both files, in the background, anyone who wrote them."""
        self._writes += 1
        self._found.look()

    def _written(self) -> Inputs | None:
        return (self._workspace, self._writes) if self._workspace and self._writes else None

    def _deliver(self) -> None:
        if (found := self._found.value) is not None:
            self.read.emit(*found)
        elif problem := self._found.problem:
            self.damaged.emit(problem)


def _read(workspace: Workspace, _writes: int) -> tuple[LandmarkFile, ViewGroups, str]:
    file, groups = read_landmarks_in(workspace.folder)
    _ = groups.groups  # is kept; many frames take long to be put in order
    return file, groups, unknown_frames_message(groups, workspace)
