"""Triangulating one landmark of the dataset in the background."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Protocol, cast

import numpy as np
from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.prediction.uncertainty import project_error_ellipses
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.base import (
    CameraOrProjections,
    ElementProjections,
    projects_only_ground,
    scaled_camera,
)
from procc_annotator.dataset.landmarks.clicks import LocatedLandmark, why_kept, with_positions
from procc_annotator.dataset.landmarks.dataset_landmarks import (
    read_landmarks_in,
    unknown_frames_message,
)
from procc_annotator.dataset.landmarks.triangulation import (
    DatasetPaths,
    FoundInDataset,
    TriangulationSettings,
    locate_in_dataset,
)
from procc_annotator.dataset.landmarks.view_groups import ViewGroups
from procc_annotator.dataset.layout import VIEWS_FILE
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.field.geometry import Vector
from procc_annotator.field.landmarks import is_moving, landmark_at_instant, landmarks_by_name
from procc_annotator.field.model import Field, Landmark
from procc_annotator.formats.landmark_file import LANDMARKS_FILE, LandmarkFile
from procc_annotator.gui.latest import Latest
from procc_annotator.gui.state.derived import Derived, Inputs, Where
from procc_annotator.gui.state.file_watch import FileWatch
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.saying import say
from procc_annotator.gui.state.scoring.frame_score import Judge
from procc_annotator.gui.state.store import Store
from procc_annotator.gui.worker import JobControl
from procc_annotator.interaction.overlay_lines import ShownEllipse
from procc_annotator.translation import tr

Size = tuple[int, int]
Ellipses = tuple[ShownEllipse, ...]
FileAndInstant = tuple[LandmarkFile, str | None]  # of a dataset, and of the frame on screen


class LandmarkEllipses(Derived[Ellipses]):
    """One for each landmark of the frame on screen whose place has a covariance, by the camera that
    is judged, else by the fit."""

    def __init__(
        self, store: Store, live_fit: LiveFit, judge: Judge, here: Callable[[], FileAndInstant]
    ) -> None:
        super().__init__(self._made_of, _project, Where.AT_ONCE, store)
        self._store, self._live_fit, self._judge = store, live_fit, judge
        self._here = here
        self.follow(store, live_fit.changed)

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


class PlacedLandmarks(Protocol):
    """What triangulating asks of the dataset's landmarks, and gives to them."""

    @property
    def file(self) -> LandmarkFile:
        """Return what the dataset has."""

    @property
    def groups(self) -> ViewGroups:
        """Its frames of one instant."""

    @property
    def problem(self) -> str:
        """Why nothing is written."""

    def frames_with(self, name: str) -> tuple[str, ...] | None:
        """The frames that a landmark is clicked in; None while that is looked up."""

    def edit(self, make: Callable[[], LandmarkFile]) -> bool:
        """Write and use other landmarks; False, and said why, where that cannot be."""


class LandmarkPlacing(QObject):
    """Finds where a landmark is from its clicks; belongs to the landmarks.

    Attributes:
        working: name of the landmark that is being triangulated; empty for none.
    """

    changed = Signal()  # whether one is being triangulated

    def __init__(self, store: Store, live_fit: LiveFit, landmarks: PlacedLandmarks) -> None:
        super().__init__(store)
        self._store, self._live_fit = store, live_fit
        self._landmarks = landmarks
        self._placing = Latest(self, self._not_located, urgent=True)
        self.working = ""

    def stop(self, name: str | None = None) -> None:
        """Triangulate no more; with a name: not that landmark."""
        if self.working and name in (None, self.working):
            self._placing.cancel()
            self.working = ""
            self.changed.emit()

    def why_kept(self, name: str) -> str:
        """Why a landmark is not to be triangulated; empty where it may be."""
        file = self._landmarks.file
        moves = any(map(is_moving, landmarks_by_name(file.landmarks).get(name, [])))
        why = "" if moves else why_kept(file, name)
        return tr(why) if why else ""

    def start(self, name: str) -> None:
        """Find where a landmark is from its clicks, in the background."""
        state, landmarks = self._store.state, self._landmarks
        workspace = state.workspace
        frames = landmarks.frames_with(name)
        if workspace is None or frames is None or self.working:
            return
        if why_not := landmarks.problem or self.why_kept(name):
            say(self._store, why_not, "warning")
            return
        read: dict[str, Callable[[], FrameAnnotation]] = {
            frame: partial(workspace.read, workspace.index[frame]) for frame in frames
        }
        source = state.active
        cameras = None if source is None else source.files
        place = DatasetPaths(
            workspace.folder,
            workspace.annotations,
            tuple(workspace.index),
        )
        field = state.field
        model = self._live_fit.model if self._live_fit.model != "H" else "R"
        search = TriangulationSettings(
            landmarks.file, landmarks.groups, cameras, names=(name,), model=model
        )

        def work(control: JobControl) -> FoundInDataset:
            return locate_in_dataset(read, field, place, search, control.progress_or_stop)

        self.working = name
        self._placing.start(work, self._located)
        self.changed.emit()

    def _located(self, outcome: FoundInDataset) -> None:
        name, landmarks, store = self.working, self._landmarks, self._store
        self.working = ""
        located = outcome.located
        for problem in outcome.problems:
            say(store, problem, "warning")
        found = [one for one in located if one.found.position is not None]
        deleted = False

        def placed() -> LandmarkFile:
            nonlocal deleted
            # Another person may have deleted it meanwhile; a place would bring it back.
            deleted = name not in landmarks_by_name(landmarks.file.landmarks)
            return landmarks.file if deleted else with_positions(landmarks.file, found)

        if not found:
            self.changed.emit()
        elif not landmarks.edit(placed):
            self.changed.emit()
            return  # it was said why
        if deleted:
            title = tr(name.strip())
            told = tr("{title} was deleted meanwhile: its place was not kept", title=title)
            say(store, told, "warning")
            return
        for one in located[:1]:
            if why := why_kept(landmarks.file, name, one.clicked.instant):
                say(store, tr(why), "warning")
            else:
                say(store, _words(one), "info" if one in found else "warning")

    def _not_located(self, text: str) -> None:
        self.working = ""
        say(self._store, text, "warning")
        self.changed.emit()


def _words(one: LocatedLandmark) -> str:
    found, name = one.found, tr(one.clicked.name.strip())
    if found.position is None or found.deviations_m is None:
        return f"{name}: {tr(found.failure or '')}"
    views = len(one.clicked.clicks) - len(one.without_view) - len(found.left_out)
    place = ", ".join(f"{value:.2f}" for value in found.position)
    deviations = ", ".join(f"{value:.2f}" for value in found.deviations_m)
    said = [
        tr(
            "{title} is at {place} m, ± {deviations}, from {views} views",
            title=name,
            place=place,
            deviations=deviations,
            views=views,
        )
    ]
    if found.left_out:
        said.append(tr("left out: {names}", names=", ".join(found.left_out)))
    return "; ".join(said)
