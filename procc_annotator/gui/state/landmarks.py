"""The landmarks of the dataset: kept in its files, part of its field, seen in its views."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import cast

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
from procc_annotator.dataset.landmarks import dataset_landmarks
from procc_annotator.dataset.landmarks.clicks import LocatedLandmark, why_kept, with_positions
from procc_annotator.dataset.landmarks.dataset_landmarks import (
    field_with,
    read_landmarks_in,
    unknown_frames_message,
)
from procc_annotator.dataset.landmarks.triangulation import (
    DatasetPaths,
    FoundInDataset,
    TriangulationSettings,
    clicked_frames,
    clicked_in,
    locate_in_dataset,
)
from procc_annotator.dataset.landmarks.view_groups import ViewGroups
from procc_annotator.dataset.layout import VIEWS_FILE
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError, ProccError
from procc_annotator.field.geometry import Vector
from procc_annotator.field.landmarks import is_moving, landmark_at_instant, landmarks_by_name
from procc_annotator.field.model import Field, Landmark
from procc_annotator.formats.landmark_file import (
    LANDMARKS_FILE,
    LandmarkFile,
    load_landmarks,
    save_landmarks,
)
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import (
    ComputedValue,
    Inputs,
    JobControl,
    LatestOnlyTask,
    Priority,
)
from procc_annotator.gui.state.editing.outside_changes import FileWatch
from procc_annotator.gui.state.messages import notify, say, withdraw
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.scoring.commands import EvaluationSettings
from procc_annotator.gui.state.scoring.frame_score import FrameScorer
from procc_annotator.gui.state.store import Store
from procc_annotator.interaction.overlay_lines import ShownEllipse
from procc_annotator.translation import tr

Size = tuple[int, int]
FileAndInstant = tuple[LandmarkFile, str | None]  # of a dataset, and of the frame on screen


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
) -> tuple[ShownEllipse, ...]:
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
        ShownEllipse(elements[mark.name], ellipse)
        for mark, ellipse in zip(marks, found, strict=True)
        if ellipse is not None and mark.name in elements
    )


def _read(workspace: Workspace, _writes: int) -> tuple[LandmarkFile, ViewGroups, str]:
    file, groups = read_landmarks_in(workspace.folder)
    _ = groups.groups  # is kept; many frames take long to be put in order
    return file, groups, unknown_frames_message(groups, workspace)


PROBLEM, STRANGE = "landmarks", "views"  # the notices

ClickedFrames = dict[str, frozenset[str]]


class Landmarks(QObject):
    """Reads and writes ``landmarks.json``, and lets the field follow.

    Attributes:
        file: what the dataset has.
        groups: its frames of one instant.
        problem: why its files cannot be used; nothing is written over them then.
        strange: what is to say of rows of ``views.csv`` that name no frame; empty for nothing.
        ellipses: error ellipses in the frame on screen of the landmarks whose position has a
            covariance.
    """

    changed = Signal()  # landmarks, where they are clicked, or whether one is being triangulated

    def __init__(
        self, store: Store, scorer: FrameScorer, live_fit: LiveFit, terms: EvaluationSettings
    ) -> None:
        super().__init__(store)
        self._store, self._terms = store, terms
        self._scorer, self._live_fit = scorer, live_fit
        self.file, self.groups = LandmarkFile(), ViewGroups()
        self.problem = self.strange = ""
        self._damage = ""  # what the problem is, of the files alone
        self._since: ClickedFrames = {}  # of frames that were on screen since the scan
        self._clicked = ComputedValue(
            self._to_scan, _scan, self, stoppable=True, priority=Priority.LOW
        )
        self._clicked.changed.connect(self._take_scan)
        self._clicked.failed.connect(partial(say, store, level="error"))
        self.triangulation = LandmarkTriangulation(store, live_fit, self)
        self.ellipses = ComputedValue(self._to_project, _project, self, background=False)
        store.keep_current(self.ellipses, live_fit.changed)
        self._writes = 0  # of both files that were seen
        self._read = ComputedValue(self._to_read, _read, self)
        self._read.changed.connect(self._take_read)
        names = LANDMARKS_FILE, VIEWS_FILE
        self._watches = {name: FileWatch(self, self.read_again) for name in names}
        store.watch(select.annotation, self._look_at_frame)
        store.events.framesEdited.connect(self._look_again)
        store.watch(select.field, self._try_again)

    # --- the dataset ---

    def take(self, workspace: Workspace, field: Field) -> Field:
        """Another dataset is opened: its field with its landmarks."""
        self.close()
        self.file, self.groups = LandmarkFile(), ViewGroups()
        self.problem = self.strange = ""
        for notice in (PROBLEM, STRANGE):  # of the dataset before
            withdraw(self._store, notice)
        self._watch(workspace)
        try:
            self.file, self.groups = read_landmarks_in(workspace.folder)
            self.strange = unknown_frames_message(self.groups, workspace)
            field = field_with(field, self.file, self.groups, self._path(workspace))
        except InputError as error:
            self._damage = str(error)
            self.problem = tr("the dataset's landmarks are not used: {why}", why=self._damage)
            self.file = LandmarkFile()
        self.changed.emit()
        return field

    def close(self) -> None:
        """Look for nothing any more."""
        self._watch(None)
        self.triangulation.stop()
        self._forget_clicks()

    @property
    def entries(self) -> list[Landmark]:
        """One a landmark, as it is in the frame on screen."""
        return entries_of(*self._here())

    def _here(self) -> FileAndInstant:
        name = self._store.state.frame_name
        return self.file, None if name is None else self.groups.instant_of(name)

    # --- edits ---

    def add(self, name: str) -> bool:
        """Have a new landmark, to be clicked."""
        return self.edit(
            lambda: dataset_landmarks.with_new_landmark(self.file, name, self._store.state.field)
        )

    def survey(self, name: str, place: str) -> bool:
        """Give a landmark the place that a person measured: ``x, y, z``, metres."""

        def edit() -> LandmarkFile:
            position: Vector = dataset_landmarks.parse_position(place)
            return dataset_landmarks.with_surveyed_position(self.file, name, position)

        return self.edit(edit)

    def retitle(self, name: str, title: str) -> bool:
        """Call a landmark something else; its class stays."""
        return self.edit(lambda: dataset_landmarks.with_title(self.file, name, title))

    def remove(self, name: str) -> bool:
        """Forget a landmark; clicks on it stay in the annotations."""
        self.triangulation.stop(name)  # or its place would bring it back
        return self.edit(lambda: self.file.without(name))

    def edit(self, make: Callable[[], LandmarkFile]) -> bool:
        """Write and use other landmarks; False, and said why, where that cannot be."""
        state, workspace = self._store.state, self._store.state.workspace
        if workspace is None:
            return False
        if self.problem:
            notify(self._store, PROBLEM, self.problem)
            return False
        path, before = self._path(workspace), self.file
        try:
            self.file = load_landmarks(path)  # another window or program may have written it
            file = make()
            field = field_with(state.field, file, self.groups, path)
            if file != self.file:
                save_landmarks(path, file)
        except ProccError as error:
            self.file = before
            say(self._store, str(error), "warning")
            return False
        self.file = before
        if self._read.working:  # it may have begun before the write
            self.read_again()
        self._use(file, self.groups, field)
        return True

    def _use(self, file: LandmarkFile, groups: ViewGroups, field: Field) -> None:
        before = self._names()
        self.file, self.groups = file, groups
        if set(before) != set(self._names()):
            self._forget_clicks()
        self._terms.take_field(field)
        self.changed.emit()

    # --- what others write ---

    def read_again(self) -> None:
        """Read both files, in the background, whoever wrote them."""
        self._writes += 1
        self._read.invalidate()

    def _watch(self, workspace: Workspace | None) -> None:
        self._read.clear()
        self._writes = 0
        for name, watch in self._watches.items():
            watch.watch(None if workspace is None else workspace.folder / name)

    def _to_read(self) -> Inputs | None:
        workspace = self._store.state.workspace
        return (workspace, self._writes) if workspace is not None and self._writes else None

    def _try_again(self) -> None:
        """With another field what could not be used before may be."""
        if self.problem:
            self.read_again()

    def _take_read(self) -> None:
        """Another window or program wrote the files, or this one did."""
        workspace = self._store.state.workspace
        if self._read.value is None:
            if self._read.problem:
                self._note_damage(self._read.problem)
            return
        file, groups, strange = self._read.value
        self._tell_strange(strange)
        if workspace is None or (not self.problem and (file, groups) == (self.file, self.groups)):
            return
        try:
            field = field_with(self._store.state.field, file, groups, self._path(workspace))
        except InputError as error:
            self._note_damage(str(error))
            return
        if self.problem:
            self.problem = ""
            withdraw(self._store, PROBLEM)
            say(self._store, tr("the dataset's landmarks can be used again"))
        self._use(file, groups, field)

    def _tell_strange(self, strange: str) -> None:
        if strange != self.strange:
            self.strange = strange
            if strange:
                notify(self._store, STRANGE, strange)
            else:
                withdraw(self._store, STRANGE)
            self.changed.emit()

    def _note_damage(self, text: str) -> None:
        """The last good landmarks stay, and nothing is written until the files can be read."""
        if self.problem and self._damage == text:
            return  # it was said so
        self._damage = text
        self.problem = tr("the dataset's landmarks stay as they were: {why}", why=text)
        notify(self._store, PROBLEM, self.problem)
        self.changed.emit()

    # --- where they are clicked ---

    def frames_with(self, name: str) -> tuple[str, ...] | None:
        """The frames that a landmark is clicked in, in order; None while that is looked up."""
        self._clicked.invalidate()
        clicked = self._clicked.value
        if clicked is None:
            return () if self._clicked.problem else None
        known = {**clicked, **self._since}
        return tuple(frame for frame, names in known.items() if name in names)

    def _to_scan(self) -> Inputs | None:
        workspace = self._store.state.workspace
        return None if workspace is None else (workspace, self._names())

    def _take_scan(self) -> None:
        if self._clicked.value is not None:
            self.changed.emit()

    def _look_at_frame(self) -> None:
        """The annotation on screen is another one; all others are known."""
        name = self._store.state.frame_name
        if name is None or not self.file.landmarks:
            return
        now = clicked_in(self._store.state.annotation, self._names())
        known = self._clicked.value
        before = self._since.get(name)
        if before is None:
            before = (known or {}).get(name, frozenset())
        self._since[name] = now
        if known is not None and before != now:
            self.changed.emit()

    def _look_again(self, _frames: list[int]) -> None:
        self._forget_clicks()
        self.changed.emit()

    def _forget_clicks(self) -> None:
        self._since.clear()
        self._clicked.clear()

    def _names(self) -> tuple[str, ...]:
        return tuple(landmarks_by_name(self.file.landmarks))

    # --- views ---

    def other_views(self) -> tuple[tuple[int, str, str], ...]:
        """Return index, name and camera of the other frames of the instant on screen."""
        workspace, name = self._store.state.workspace, self._store.state.frame_name
        if workspace is None or name is None:
            return ()
        names = (n for n in self.groups.others(name) if n in workspace.index)
        places = ((workspace.index[n], self.groups.view_of(n)) for n in names)
        return tuple((index, workspace.frames[index].name, view) for index, view in places)

    def _to_project(self) -> Inputs | None:
        """The landmarks on screen with the scored camera, else with the fit."""
        state = self._store.state
        size = state.picture_size
        if size is None or not self.file.landmarks or not state.projection_visible:
            return None
        field, camera = self._scorer.frame_setup.field, self._scorer.camera
        if camera is not None:
            return *self._here(), field, size, camera, state.setup.size
        fit = self._live_fit.result
        return None if fit is None else (*self._here(), field, size, fit, fit.size)

    @staticmethod
    def _path(workspace: Workspace) -> Path:
        return workspace.folder / LANDMARKS_FILE


class LandmarkTriangulation(QObject):
    """Finds the position of a landmark from its clicks, in the background; ``working`` is its name,
    empty for none."""

    def __init__(self, store: Store, live_fit: LiveFit, landmarks: Landmarks) -> None:
        super().__init__(store)
        self._store, self._live_fit = store, live_fit
        self._landmarks = landmarks
        self._task = LatestOnlyTask(self, self._not_located, priority=Priority.URGENT)
        self.working = ""

    def stop(self, name: str | None = None) -> None:
        """Triangulate no more; with a name: not that landmark."""
        if self.working and name in (None, self.working):
            self._task.cancel()
            self.working = ""
            self._landmarks.changed.emit()

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
        place = DatasetPaths(workspace.folder, workspace.annotations, tuple(workspace.index))
        field = state.field
        model = self._live_fit.model if self._live_fit.model != "H" else "R"
        search = TriangulationSettings(
            landmarks.file, landmarks.groups, cameras, names=(name,), model=model
        )

        def work(control: JobControl) -> FoundInDataset:
            return locate_in_dataset(read, field, place, search, control.progress_or_stop)

        self.working = name
        self._task.start(work, self._located)
        self._landmarks.changed.emit()

    def _located(self, outcome: FoundInDataset) -> None:
        name, landmarks, store = self.working, self._landmarks, self._store
        self.working = ""
        located = outcome.located
        for problem in outcome.problems:
            say(store, problem, "warning")
        found = [one for one in located if one.found.position is not None]

        def is_there() -> bool:  # another person may have deleted it; a place would bring it back
            return name in landmarks_by_name(landmarks.file.landmarks)

        def placed() -> LandmarkFile:
            return with_positions(landmarks.file, found) if is_there() else landmarks.file

        if not found:
            self._landmarks.changed.emit()
        elif not landmarks.edit(placed):
            self._landmarks.changed.emit()
            return  # it was said why
        if found and not is_there():
            title = tr(name.strip())
            text = tr("{title} was deleted meanwhile: its place was not kept", title=title)
            say(store, text, "warning")
            return
        for one in located[:1]:
            if why := why_kept(landmarks.file, name, one.clicked.instant):
                say(store, tr(why), "warning")
            else:
                say(store, _words(one), "info" if one in found else "warning")

    def _not_located(self, text: str) -> None:
        self.working = ""
        say(self._store, text, "warning")
        self._landmarks.changed.emit()


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


def _scan(
    workspace: Workspace, names: tuple[str, ...], *, go_on: Callable[[], None]
) -> ClickedFrames:
    read = {f.name: partial(workspace.read, i) for i, f in enumerate(workspace.frames)}
    return clicked_frames(read, names, lambda _done, _total: go_on())
