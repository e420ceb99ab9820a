"""Triangulating one landmark of the dataset in the background."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Protocol

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.landmarks.clicks import LocatedLandmark, why_kept, with_positions
from procc_annotator.dataset.landmarks.triangulation import (
    DatasetPaths,
    FoundInDataset,
    TriangulationSettings,
    locate_in_dataset,
)
from procc_annotator.dataset.landmarks.view_groups import ViewGroups
from procc_annotator.field.landmarks import is_moving, landmarks_by_name
from procc_annotator.formats.landmark_file import LandmarkFile
from procc_annotator.gui.latest import Latest
from procc_annotator.gui.state.live_fit import LiveFit
from procc_annotator.gui.state.saying import say
from procc_annotator.gui.state.store import Store
from procc_annotator.gui.worker import JobControl
from procc_annotator.translation import tr


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
