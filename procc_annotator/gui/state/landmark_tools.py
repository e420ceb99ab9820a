"""Triangulating one landmark of the dataset in the background."""

from __future__ import annotations

from collections.abc import Callable
from typing import cast

import numpy as np
from PySide6.QtCore import QObject, Signal

from procc_annotator.calibration.prediction.uncertainty import project_error_ellipses
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.base import (
    CameraOrProjections,
    ElementProjections,
    projects_only_ground,
    scaled_camera,
)
from procc_annotator.dataset.landmarks.dataset_landmarks import (
    read_landmarks_in,
    unknown_frames_message,
)
from procc_annotator.dataset.landmarks.view_groups import ViewGroups
from procc_annotator.dataset.layout import VIEWS_FILE
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.field.geometry import Vector
from procc_annotator.field.landmarks import landmark_at_instant, landmarks_by_name
from procc_annotator.field.model import Field, Landmark
from procc_annotator.formats.landmark_file import LANDMARKS_FILE, LandmarkFile
from procc_annotator.gui.state.background import (
    ComputedValue,
    Inputs,
)
from procc_annotator.gui.state.file_watch import FileWatch
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.scoring.frame_score import FrameScorer
from procc_annotator.gui.state.store import Store
from procc_annotator.interaction.overlay_lines import ShownEllipse

Size = tuple[int, int]
Ellipses = tuple[ShownEllipse, ...]
FileAndInstant = tuple[LandmarkFile, str | None]  # of a dataset, and of the frame on screen


class LandmarkEllipses(ComputedValue[Ellipses]):
    """Error ellipses of the landmarks whose position has a covariance, by the scored camera, else
    by the fit."""

    def __init__(
        self,
        store: Store,
        live_fit: LiveFit,
        judge: FrameScorer,
        here: Callable[[], FileAndInstant],
    ) -> None:
        super().__init__(self._made_of, _project, store, background=False)
        self._store, self._live_fit, self._judge = store, live_fit, judge
        self._here = here
        store.keep_current(self, live_fit.changed)

    def _made_of(self) -> Inputs | None:
        state, (file, instant) = self._store.state, self._here()
        size = state.picture_size
        if size is None or not file.landmarks or not state.projection_visible:
            return None
        field, camera = self._judge.frame_setup.field, self._judge.camera
        if camera is not None:
            return file, instant, field, size, camera, state.setup.size
        fit = self._live_fit.result
        return None if fit is None else (file, instant, field, size, fit, fit.size)


def entries_of(file: LandmarkFile, instant: str | None) -> list[Landmark]:
    """One a landmark of a dataset, as it is at an instant."""
    return [
        landmark_at_instant(marks, instant) or marks[0]
        for marks in landmarks_by_name(file.landmarks).values()
    ]


def _project(
    file: LandmarkFile,
    instant: str | None,
    field: Field,
    size: Size,
    judged: CameraOrProjections | FitResult,
    judged_size: Size,
) -> Ellipses:
    entries = entries_of(file, instant)
    marks = [m for m in entries if m.position is not None and m.covariance is not None]
    positions = [cast(Vector, mark.position) for mark in marks]
    camera: CameraOrProjections | None = None
    spread = None
    if not isinstance(judged, FitResult):
        camera = scaled_camera(judged, judged_size, size)
    elif judged_size == size and marks:
        camera, spread = judged.camera, judged.projected_covariance(np.array(positions))
    if not marks or camera is None or isinstance(camera, ElementProjections):
        return ()
    if projects_only_ground(camera):
        return ()
    covariances = [mark.covariance for mark in marks]
    found = project_error_ellipses(camera, positions, covariances, camera_covariances=spread)
    elements = {e.name: e.colour for e in field.elements}
    return tuple(
        ShownEllipse(mark.name, elements[mark.name], ellipse)
        for mark, ellipse in zip(marks, found, strict=True)
        if ellipse is not None and mark.name in elements
    )


class LandmarkFiles(QObject):
    """Reads both files again, in the background, whenever one of them was written."""

    read = Signal(LandmarkFile, ViewGroups, str)  # and of rows that name no frame
    damaged = Signal(str)  # why they cannot be used

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._workspace: Workspace | None = None
        self._writes = 0  # that were seen; what was there before is known
        self._found = ComputedValue(self._written, _read, self)
        self._found.changed.connect(self._deliver)
        self._watches = {name: FileWatch(self) for name in (LANDMARKS_FILE, VIEWS_FILE)}
        for watch in self._watches.values():
            watch.changed.connect(self.read_again)

    def watch(self, workspace: Workspace | None) -> None:
        """Watch the files of this dataset from now on; None: of none."""
        self._found.clear()
        self._workspace, self._writes = workspace, 0
        for name, watch in self._watches.items():
            watch.watch(None if workspace is None else workspace.folder / name)

    def note_written(self) -> None:
        """Read again if a read is in progress: it may have begun before the write."""
        if self._found.working:
            self.read_again()

    def read_again(self) -> None:
        """Read both files, in the background, anyone who wrote them."""
        self._writes += 1
        self._found.invalidate()

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
