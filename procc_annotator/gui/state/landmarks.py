"""The landmarks of the dataset: kept in its files, part of its field, seen in its views."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np
from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import projects_only_ground
from procc_annotator.camera.projections import ElementProjections
from procc_annotator.camera.scaling import scaled
from procc_annotator.errors import InputError, ProccError
from procc_annotator.field.geometry import Vector
from procc_annotator.field.landmarks import Landmark, at_instant, by_name, is_moving
from procc_annotator.field.model import Field
from procc_annotator.fit.projected_ellipse import projected_ellipses
from procc_annotator.gui.state.landmark_files import LandmarkFiles
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.interact.overlay_landmarks import ShownEllipse
from procc_annotator.io.landmark_file import (
    LANDMARKS_FILE,
    LandmarkFile,
    load_landmarks,
    save_landmarks,
)
from procc_annotator.session import landmark_edits
from procc_annotator.session.dataset_landmarks import field_with, read_landmarks_in
from procc_annotator.session.landmark_clicks import LocatedLandmark, why_kept, with_positions
from procc_annotator.session.landmark_scan import (
    FoundInDataset,
    PlaceOfFiles,
    Search,
    clicked_frames,
    clicked_in,
    locate_in_dataset,
)
from procc_annotator.session.view_groups import ViewGroups
from procc_annotator.session.workspace import Workspace

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document

ClickedFrames = dict[str, frozenset[str]]
# What they were made of, compared by identity and by value; the ellipses.
_Ellipses = tuple[tuple[object, ...], tuple[object, ...], tuple[ShownEllipse, ...]]


class Landmarks(QObject):
    """Reads and writes ``landmarks.json``, and lets the field follow.

    Attributes:
        file: what the dataset has.
        groups: its frames of one instant.
        problem: why its files cannot be used; nothing is written over them then.
        working: name of the landmark that is being triangulated; empty for none.
    """

    changed = Signal()  # landmarks, where they are clicked, or whether one is being triangulated
    mended = Signal(str)  # a problem that was told is gone
    ellipsesChanged = Signal()  # only how surely the frame on screen shows them

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document
        self.file, self.groups = LandmarkFile(), ViewGroups()
        self.problem = self.working = ""
        self._clicked: ClickedFrames | None = None
        self._scan: Job | None = None
        self._edited: set[int] = set()  # frames, since the scan began
        self._job: Job | None = None
        self._ellipses: _Ellipses = ((), (), ())
        self._files = LandmarkFiles(self)
        self._files.read.connect(self._take_read)
        self._files.damaged.connect(self._note_damage)
        document.annotationChanged.connect(self._look_at_frame)
        document.framesEdited.connect(self._look_again)
        document.live_fit.changed.connect(self._note_fit)

    # --- the dataset ---

    def take(self, workspace: Workspace, field: Field) -> Field:
        """Another dataset is opened: its field with its landmarks."""
        self.close()
        self.file, self.groups, self.problem = LandmarkFile(), ViewGroups(), ""
        self._files.watch(workspace.folder)
        try:
            self.file, self.groups = read_landmarks_in(workspace.folder)
            field = field_with(field, self.file, self.groups, self._path(workspace))
        except InputError as error:
            self.problem = f"the dataset's landmarks are not used: {error}"
            self.file = LandmarkFile()
        self.changed.emit()
        return field

    def close(self) -> None:
        """Look for nothing any more."""
        self._files.watch(None)
        for job in (self._scan, self._job):
            if job is not None:
                job.cancel()
        self._scan = self._job = self._clicked = None
        self.working = ""

    @property
    def entries(self) -> list[Landmark]:
        """One a landmark, as it is in the frame on screen."""
        frame = self._document.frame
        instant = None if frame is None else self.groups.instant_of(frame.name)
        known = by_name(self.file.landmarks).values()
        return [at_instant(marks, instant) or marks[0] for marks in known]

    # --- edits ---

    def add(self, name: str) -> bool:
        """Have a new landmark, to be clicked."""
        return self._edit(lambda: landmark_edits.added(self.file, name, self._document.field))

    def survey(self, name: str, place: str) -> bool:
        """Give a landmark the place that somebody measured: ``x, y, z``, metres."""

        def edit() -> LandmarkFile:
            position: Vector = landmark_edits.parse_place(place)
            return landmark_edits.surveyed(self.file, name, position)

        return self._edit(edit)

    def retitle(self, name: str, title: str) -> bool:
        """Call a landmark something else; its class stays."""
        return self._edit(lambda: landmark_edits.titled(self.file, name, title))

    def remove(self, name: str) -> bool:
        """Forget a landmark; clicks on it stay in the annotations."""
        return self._edit(lambda: self.file.without(name))

    def _edit(self, make: Callable[[], LandmarkFile]) -> bool:
        """Write and use other landmarks; False, and said why, where that cannot be."""
        document, workspace = self._document, self._document.workspace
        if workspace is None:
            return False
        if self.problem:
            document.message.emit(self.problem, "warning")
            return False
        path, before = self._path(workspace), self.file
        try:
            self.file = load_landmarks(path)  # another window or program may have written it
            file = make()
            field = field_with(document.field, file, self.groups, path)
            if file != self.file:
                save_landmarks(path, file)
        except ProccError as error:
            self.file = before
            document.message.emit(str(error), "warning")
            return False
        self.file = before
        self._files.note_written()
        self._use(file, self.groups, field)
        return True

    def _use(self, file: LandmarkFile, groups: ViewGroups, field: Field) -> None:
        before = self._names()
        self.file, self.groups = file, groups
        if set(before) != set(self._names()):
            self._forget_clicks()
        self._document.take_field(field)
        self.changed.emit()

    # --- what others write ---

    def _take_read(self, file: LandmarkFile, groups: ViewGroups) -> None:
        """Another window or program wrote the files, or this one did."""
        document, workspace = self._document, self._document.workspace
        if workspace is None or (not self.problem and (file, groups) == (self.file, self.groups)):
            return
        try:
            field = field_with(document.field, file, groups, self._path(workspace))
        except InputError as error:
            self._note_damage(str(error))
            return
        if self.problem:
            before, self.problem = self.problem, ""
            self.mended.emit(before)
            document.message.emit("the dataset's landmarks can be used again", "info")
        self._use(file, groups, field)

    def _note_damage(self, text: str) -> None:
        """The last good landmarks stay, and nothing is written until the files can be read."""
        problem = f"the dataset's landmarks stay as they were: {text}"
        if problem != self.problem:
            self.problem = problem
            self._document.message.emit(problem, "warning")
            self.changed.emit()

    # --- where they are clicked ---

    def frames_with(self, name: str) -> tuple[str, ...] | None:
        """The frames that a landmark is clicked in, in order; None while that is looked up."""
        if self._clicked is None:
            self._look_for_clicks()
            return None
        return tuple(frame for frame, names in self._clicked.items() if name in names)

    def _look_for_clicks(self) -> None:
        workspace = self._document.workspace
        if workspace is None or self._scan is not None:
            return
        names = self._names()
        read = {f.name: partial(workspace.read, i) for i, f in enumerate(workspace.frames)}

        def work(control: JobControl) -> ClickedFrames:
            return clicked_frames(read, names, control.progress_or_stop)

        self._edited.clear()
        self._scan = run_in_background(
            work, on_result=self._found, on_error=self._not_found, owner=self
        )

    def _found(self, clicked: ClickedFrames) -> None:
        self._scan, self._clicked = None, clicked
        workspace = self._document.workspace
        for index in self._edited:  # some were left by now
            if workspace is not None and (now := workspace.at_hand(index)) is not None:
                clicked[workspace.frames[index].name] = clicked_in(now, self._names())
        self._look_at_frame()
        self.changed.emit()

    def _not_found(self, text: str) -> None:
        self._scan, self._clicked = None, {}
        self._document.message.emit(text, "error")

    def _look_at_frame(self) -> None:
        """The annotation on screen is another one; all others are known."""
        document, frame = self._document, self._document.frame
        if self._scan is not None:
            self._edited.add(document.frame_index)
        if self._clicked is None or frame is None or not self.file.landmarks:
            return
        now = clicked_in(document.annotation, self._names())
        if self._clicked.get(frame.name, frozenset()) != now:
            self._clicked[frame.name] = now
            self.changed.emit()

    def _look_again(self, _frames: list[int]) -> None:
        self._forget_clicks()
        self.changed.emit()

    def _forget_clicks(self) -> None:
        if self._scan is not None:
            self._scan.cancel()
        self._scan = self._clicked = None

    def _names(self) -> tuple[str, ...]:
        return tuple(by_name(self.file.landmarks))

    # --- views ---

    def other_views(self) -> tuple[tuple[int, str, str], ...]:
        """Of the other frames of the instant on screen: index, name, camera."""
        document = self._document
        workspace, frame = document.workspace, document.frame
        if workspace is None or frame is None:
            return ()
        names = (n for n in self.groups.others(frame.name) if n in workspace.index)
        return tuple((workspace.index[n], n, self.groups.view_of(n)) for n in names)

    @property
    def ellipses(self) -> tuple[ShownEllipse, ...]:
        """How surely the frame on screen shows the landmarks, by the active source, else by the
        fit; the same object as long as nothing changed."""
        document = self._document
        made_of = (
            document.judge.camera,
            document.live_fit.result,
            document.frame_field,
        )
        terms = document.setup.size, document.picture_size, document.projection_visible
        before, terms_before, known = self._ellipses
        same = len(before) == len(made_of) and all(map(lambda a, b: a is b, made_of, before))
        if not same or terms != terms_before:
            known = self._project()
            self._ellipses = made_of, terms, known
        return known

    def _note_fit(self) -> None:
        """Where no source is judged, ellipses are the fit's."""
        if self._document.judge.camera is None and self.file.landmarks:
            self.ellipsesChanged.emit()

    def _project(self) -> tuple[ShownEllipse, ...]:
        document, size = self._document, self._document.picture_size
        marks = [m for m in self.entries if m.position is not None and m.covariance is not None]
        if size is None or not marks or not document.projection_visible:
            return ()
        positions = [cast(Vector, mark.position) for mark in marks]
        camera, own = document.judge.camera, None
        if camera is not None:
            camera = scaled(camera, document.setup.size, size)
        elif (fit := document.live_fit.result) is not None and fit.size == size:
            camera, own = fit.camera, fit
        if camera is None or isinstance(camera, ElementProjections) or projects_only_ground(camera):
            return ()
        spread = None if own is None else own.projected_covariance(np.array(positions))
        found = projected_ellipses(
            camera,
            positions,
            [m.covariance for m in marks],
            camera_covariances=spread,
        )
        elements = {e.name: e.colour for e in document.frame_field.elements}
        return tuple(
            ShownEllipse(mark.name, elements[mark.name], ellipse)
            for mark, ellipse in zip(marks, found, strict=True)
            if ellipse is not None and mark.name in elements
        )

    # --- triangulation ---

    def why_kept(self, name: str) -> str:
        """Why a landmark is not to be triangulated; empty where it may be."""
        moves = any(map(is_moving, by_name(self.file.landmarks).get(name, [])))
        why = "" if moves else why_kept(self.file, name)
        return f"{self._title(name)} {why}" if why else ""

    def triangulate(self, name: str) -> None:
        """Find where a landmark is from its clicks, in the background."""
        document, workspace = self._document, self._document.workspace
        frames = self.frames_with(name)
        if workspace is None or frames is None or self._job is not None:
            return
        if why_not := self.problem or self.why_kept(name):
            document.message.emit(why_not, "warning")
            return
        read: dict[str, Callable[[], FrameAnnotation]] = {
            frame: partial(workspace.read, workspace.index[frame]) for frame in frames
        }
        source = document.active_source
        cameras = None if source is None else source.files
        place = PlaceOfFiles(
            workspace.folder,
            workspace.frames[0].annotation_folder,
            tuple(workspace.index),
        )
        field = document.field
        model = document.live_fit.model if document.live_fit.model != "H" else "R"
        search = Search(self.file, self.groups, cameras, names=(name,), model=model)

        def work(control: JobControl) -> FoundInDataset:
            return locate_in_dataset(read, field, place, search, control.progress_or_stop)

        self.working = name
        self._job = run_in_background(
            work, on_result=self._located, on_error=self._not_located, owner=self, urgent=True
        )
        self.changed.emit()

    def _located(self, outcome: FoundInDataset) -> None:
        self._job, self.working = None, ""
        told, located = self._document.message, outcome.located
        for problem in outcome.problems:
            told.emit(problem, "warning")
        found = [one for one in located if one.found.position is not None]
        if not found:
            self.changed.emit()
        elif not self._edit(lambda: with_positions(self.file, found)):
            return  # it was said why
        for one in located[:1]:
            name = one.clicked.name
            if why := why_kept(self.file, name, one.clicked.instant):
                told.emit(f"{self._title(name)} {why}", "warning")
            else:
                told.emit(_words(one), "info" if one in found else "warning")

    def _not_located(self, text: str) -> None:
        self._job, self.working = None, ""
        self._document.message.emit(text, "warning")
        self.changed.emit()

    def _title(self, name: str) -> str:
        entries = by_name(self.file.landmarks).get(name)
        return entries[0].shown_title if entries else name.strip()

    @staticmethod
    def _path(workspace: Workspace) -> Path:
        return workspace.folder / LANDMARKS_FILE


def _words(one: LocatedLandmark) -> str:
    found, name = one.found, one.clicked.name.strip()
    if found.position is None or found.deviations_m is None:
        return f"{name}: {found.failure}"
    views = len(one.clicked.clicks) - len(one.without_view) - len(found.left_out)
    left = f"; left out: {', '.join(found.left_out)}" if found.left_out else ""
    place = ", ".join(f"{value:.2f}" for value in found.position)
    deviations = ", ".join(f"{value:.2f}" for value in found.deviations_m)
    return f"{name} is at {place} m, ± {deviations}, from {views} views{left}"
