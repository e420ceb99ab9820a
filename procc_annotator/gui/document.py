"""The one live state that all widgets share: dataset, frame on screen, scores, selection.

Signals, and what they say:

==================  ===============================================================================
datasetChanged      another dataset (or none); `frameChanged` follows
frameChanged        another frame is on screen: picture, annotation, selection, scores, save state
                    are all new; no other signal is sent for them
annotationChanged   the frame's annotation: an edit, undo, redo or reload; `scoreChanged` follows
previewChanged      the annotation as it would be if the mouse button were released now
selectionChanged    selected class or point
hoverChanged        the class under the cursor, in whatever widget
scoreChanged        measurement, threshold, protocol, camera of the frame, or blind mode
camerasChanged      camera sets were loaded or removed, or another one is active
frameScoresChanged  per-frame JaC of one frame, or of all of them ("")
saveStateChanged    whether everything is saved
modeChanged         draw or edit, blind or not
aboutToLeave        the frame on screen is about to be left: finish what is under way
flyTo               show this position of the picture (px)
message             one line for the user; level "info", "warning" or "error"
==================  ===============================================================================
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Literal

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import Camera
from procc_annotator.errors import ImageError, ProccError, UsageError
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.gui.judge import Judge
from procc_annotator.gui.saving import Saver
from procc_annotator.gui.set_scores import FrameScores, SetScores
from procc_annotator.image.cache import FrameCache
from procc_annotator.image.decode import PixelArray
from procc_annotator.metric.measure import Measurement
from procc_annotator.metric.score import FrameScore
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.camera_set import CameraSet
from procc_annotator.session.workspace import Frame, FrameState, Workspace

Mode = Literal["draw", "edit"]

_CACHE_BYTES = 96 * 2**20
_EMPTY = FrameAnnotation()


class Document(QObject):
    """Shared by canvas and panels, which display it and call its methods; it knows no widget."""

    datasetChanged = Signal()
    frameChanged = Signal()
    annotationChanged = Signal()
    previewChanged = Signal()
    selectionChanged = Signal()
    hoverChanged = Signal()
    scoreChanged = Signal()
    camerasChanged = Signal()
    frameScoresChanged = Signal(str)
    saveStateChanged = Signal()
    modeChanged = Signal()
    aboutToLeave = Signal()
    flyTo = Signal(float, float)
    message = Signal(str, str)

    def __init__(self, field: Field | None = None, cache: FrameCache | None = None) -> None:
        super().__init__()
        self.field = field if field is not None else load_field("soccer")
        self.cache = cache if cache is not None else FrameCache(_CACHE_BYTES)
        self.workspace: Workspace | None = None
        self.frame_index = -1
        self.picture: PixelArray | None = None
        self.picture_error = ""
        self.selected_class: str | None = None
        self.selected_point: tuple[str, int] | None = None
        self.hovered_class: str | None = None
        self.camera_sets: list[CameraSet] = []
        self.active_camera: CameraSet | None = None
        self.blind = False
        self.mode: Mode = "draw"
        self._preview: FrameAnnotation | None = None
        self.judge = Judge(EvaluationSetup(self.field))
        self._opened: tuple[Path, Path | None] | None = None
        self.saver = Saver(self)
        self.saver.changed.connect(self.saveStateChanged)
        self.saver.failed.connect(lambda text: self.message.emit(text, "error"))
        self.saver.reloaded.connect(self._after_reload)
        self.set_scores = SetScores(self)
        self.set_scores.changed.connect(self.frameScoresChanged)
        self.set_scores.failed.connect(lambda text: self.message.emit(text, "error"))

    # --- what is on screen -----------------------------------------------------------------

    @property
    def frame(self) -> Frame | None:
        """The frame on screen."""
        if self.workspace is None or self.frame_index < 0:
            return None
        return self.workspace.frames[self.frame_index]

    @property
    def state(self) -> FrameState | None:
        """History, errors and save state of the frame on screen."""
        if self.workspace is None or self.frame_index < 0:
            return None
        return self.workspace.state(self.frame_index)

    @property
    def picture_size(self) -> tuple[int, int] | None:
        """(width, height) of the picture on screen in px; None when there is none."""
        if self.picture is None:
            return None
        return self.picture.shape[1], self.picture.shape[0]

    @property
    def annotation(self) -> FrameAnnotation:
        """The finished annotation of the frame on screen."""
        state = self.state
        return state.history.current if state is not None else _EMPTY

    @property
    def shown_annotation(self) -> FrameAnnotation:
        """The annotation including a gesture under way."""
        return self._preview if self._preview is not None else self.annotation

    @property
    def frame_error(self) -> str:
        """Why this frame cannot be edited; empty when it can."""
        state = self.state
        if state is not None and state.error is not None:
            return str(state.error)
        return self.picture_error

    @property
    def editable(self) -> bool:
        """Whether there is a frame that can be edited."""
        return self.frame is not None and not self.frame_error

    # --- scores ------------------------------------------------------------------------------

    @property
    def setup(self) -> EvaluationSetup:
        """What scores are computed with."""
        return self.judge.setup

    @property
    def tau(self) -> float:
        """The threshold in px of the evaluation size."""
        return self.judge.tau

    @property
    def camera(self) -> Camera | None:
        """The camera of the frame on screen, unless it is hidden by blind mode."""
        return self.judge.camera if self.projection_visible else None

    @property
    def measurement(self) -> Measurement | None:
        """Distances of the shown annotation; None without a camera and while blind."""
        return self.judge.measurement if self.projection_visible else None

    @property
    def score(self) -> FrameScore | None:
        """The score at `tau`; None without a camera and while blind."""
        return self.judge.score if self.projection_visible else None

    @property
    def camera_notice(self) -> str:
        """What to know about the frame's camera (scaled from another size, missing)."""
        return self.judge.notice

    @property
    def camera_error(self) -> str:
        """Why the frame's camera cannot be used."""
        return self.judge.error

    @property
    def projection_visible(self) -> bool:
        """False while blind and the frame is not committed: nothing of the camera may be shown."""
        state = self.state
        return not self.blind or (state is not None and state.committed)

    @property
    def frame_scores(self) -> FrameScores:
        """Frame name -> JaC at `tau`, for frames scored so far (while blind: committed ones)."""
        allowed = self._committed if self.blind else None
        return FrameScores(self.set_scores.curves, self.tau, allowed)

    # --- dataset and frames ------------------------------------------------------------------

    def open_path(self, path: Path, annotations: Path | None = None) -> bool:
        """Open a folder of pictures or one picture; on failure the session stays as it is."""
        if not self.save_now():
            self.message.emit(
                "not everything is saved yet: the other dataset was not opened", "error"
            )
            return False
        try:
            workspace = Workspace.open(path, self.field, annotations)
        except ProccError as error:
            self.message.emit(str(error), "error")
            return False
        self.workspace, self._opened = workspace, (path, annotations)
        self.frame_index = 0 if workspace.frames else -1
        self.selected_point = None
        self.saver.set_workspace(workspace)
        self._load_frame()
        self.datasetChanged.emit()
        self.frameChanged.emit()
        self._score_set()
        return True

    def reopen(self) -> Workspace:
        """The dataset as it is on disk, for a thread of its own.

        Raises:
            ProccError: it cannot be opened any more, or nothing is open.
        """
        if self._opened is None:
            raise UsageError("nothing is open")
        path, annotations = self._opened
        return Workspace.open(path, self.field, annotations)

    def close(self) -> None:
        """Stop everything that runs in the background."""
        self.set_scores.cancel()
        self.saver.retry_timer.stop()
        self.cache.close()

    def go_to(self, index: int) -> None:
        """Show another frame; what is under way on this one is finished first."""
        if self.workspace is None or index == self.frame_index:
            return
        if not 0 <= index < len(self.workspace.frames):
            return
        self.aboutToLeave.emit()
        self.frame_index = index
        self.selected_point = None
        self.hovered_class = None
        self._load_frame()
        self.frameChanged.emit()

    def next_frame(self) -> None:
        """Show the next frame, if there is one."""
        self.go_to(self.frame_index + 1)

    def previous_frame(self) -> None:
        """Show the previous frame, if there is one."""
        self.go_to(self.frame_index - 1)

    def go_to_unannotated(self, step: int) -> None:
        """Show the nearest frame without annotation before (-1) or after (1) this one."""
        if self.workspace is None:
            return
        index = self.frame_index + step
        while 0 <= index < len(self.workspace.frames):
            state = self.workspace.state(index)
            if state.error is None and not state.history.current.annotated:
                self.go_to(index)
                return
            index += step
        where = "after" if step > 0 else "before"
        self.message.emit(f"every frame {where} this one is annotated", "info")

    # --- selection -----------------------------------------------------------------------------

    def select_class(self, class_name: str | None) -> None:
        """Choose the element to draw and to look at."""
        if class_name != self.selected_class:
            self.selected_class = class_name
            if self.selected_point is not None and self.selected_point[0] != class_name:
                self.selected_point = None
            self.selectionChanged.emit()

    def select_point(self, class_name: str | None, index: int = 0) -> None:
        """Choose one point of an element; None lets go of the point."""
        point = None if class_name is None else (class_name, index)
        if point == self.selected_point and class_name in (None, self.selected_class):
            return
        self.selected_point = point
        if class_name is not None:
            self.selected_class = class_name
        self.selectionChanged.emit()

    def hover_class(self, class_name: str | None) -> None:
        """Tell every widget which element the cursor is on."""
        if class_name != self.hovered_class:
            self.hovered_class = class_name
            self.hoverChanged.emit()

    def set_mode(self, mode: Mode) -> None:
        """Draw or edit; a polyline under way is finished first."""
        if mode != self.mode:
            self.aboutToLeave.emit()
            self.mode = mode
            self.modeChanged.emit()

    # --- edits -----------------------------------------------------------------------------------

    def set_preview(self, annotation: FrameAnnotation | None) -> None:
        """Show (and score) an annotation during a gesture, without touching history or disk."""
        if annotation is self._preview:
            return
        self._preview = annotation
        self.judge.judge(self.shown_annotation)
        self.previewChanged.emit()

    def commit_edit(self, label: str, annotation: FrameAnnotation) -> bool:
        """Make an edit a step of the history and save it at once."""
        if self.workspace is None or not self.editable:
            self.message.emit(self.frame_error or "open a folder of pictures first", "warning")
            return False
        self._preview = None
        if annotation == self.annotation:
            self._after_edit(save=False)
            return False
        self.workspace.edit(self.frame_index, label, annotation)
        self._after_edit()
        return True

    def undo(self) -> None:
        """Go back one step of this frame."""
        self._travel("undo", "undone")

    def redo(self) -> None:
        """Go forward one step of this frame."""
        self._travel("redo", "redone")

    def save_now(self) -> bool:
        """Finish what is under way and write what is not on disk; True when all is saved."""
        self.aboutToLeave.emit()
        return self.saver.save_all()

    def reload_frame(self) -> None:
        """Decide a conflict in favour of the file."""
        self.saver.reload(self.frame_index)

    def overwrite_frame(self) -> None:
        """Decide a conflict in favour of the screen."""
        self.saver.overwrite(self.frame_index)

    # --- blind mode ------------------------------------------------------------------------------

    def set_blind(self, blind: bool) -> None:
        """Hide everything of the camera until the frame is committed."""
        if blind != self.blind:
            self.blind = blind
            self.modeChanged.emit()
            self.scoreChanged.emit()
            self.frameScoresChanged.emit("")

    def commit_frame(self) -> None:
        """The annotator is done with this frame: the projection may be shown."""
        state = self.state
        if state is None:
            return
        self.aboutToLeave.emit()
        state.committed = True
        self.scoreChanged.emit()
        if (frame := self.frame) is not None:
            self.frameScoresChanged.emit(frame.name)
            self.message.emit(f"{frame.name} is committed", "info")

    # --- cameras ---------------------------------------------------------------------------------

    def load_cameras(self, path: Path, fmt: str = "auto") -> bool:
        """Add a folder, archive or file of cameras and make it the active set."""
        try:
            cameras = CameraSet.open(path, fmt)
        except (ProccError, OSError) as error:
            self.message.emit(str(error), "error")
            return False
        self.camera_sets.append(cameras)
        self.set_active_camera(len(self.camera_sets) - 1)
        return True

    def set_active_camera(self, index: int) -> None:
        """Judge against this set; -1 for none."""
        chosen = self.camera_sets[index] if 0 <= index < len(self.camera_sets) else None
        self.active_camera = chosen
        self._rejudge()
        self.camerasChanged.emit()
        self._score_set()

    def remove_camera_set(self, index: int) -> None:
        """Forget a set of cameras (its files stay)."""
        removed = self.camera_sets.pop(index)
        if removed is self.active_camera:
            self.set_active_camera(min(index, len(self.camera_sets) - 1))
        else:
            self.camerasChanged.emit()

    def set_tau(self, tau: float) -> None:
        """Change the threshold; nothing is measured again."""
        if self.judge.set_tau(tau):
            self.scoreChanged.emit()
            self.frameScoresChanged.emit("")

    def set_protocol(
        self,
        protocol: str | None = None,
        *,
        size: tuple[int, int] | None = None,
        off_plane: str | None = None,
    ) -> None:
        """Change the terms of the evaluation."""
        given = {"protocol": protocol, "size": size, "off_plane": off_plane}
        self.judge.set_setup(**{k: v for k, v in given.items() if v is not None})
        self._rejudge()
        self._score_set()

    # --- inside ----------------------------------------------------------------------------------

    def _load_frame(self) -> None:
        self._preview = None
        self.picture, self.picture_error = None, ""
        frame = self.frame
        if frame is not None:
            try:
                self.picture = self.cache.get(frame.image_path)
            except ImageError as error:
                self.picture_error = str(error)
            self._prefetch_neighbours()
        self.judge.show(self.active_camera, frame.name if frame else None)
        self.judge.judge(self.annotation)

    def _prefetch_neighbours(self) -> None:
        frames = self.workspace.frames if self.workspace is not None else ()
        around = (self.frame_index + step for step in (1, -1, 2))
        self.cache.prefetch([frames[i].image_path for i in around if 0 <= i < len(frames)])

    def _rejudge(self) -> None:
        frame = self.frame
        self.judge.show(self.active_camera, frame.name if frame else None)
        self.judge.judge(self.shown_annotation)
        self.scoreChanged.emit()

    def _after_edit(self, *, save: bool = True) -> None:
        if self.selected_point is not None:
            name, index = self.selected_point
            polyline = self.annotation.get(name)
            if polyline is None or index >= len(polyline.points):
                self.selected_point = None
        self.judge.judge(self.annotation)
        if save:
            self.saver.save(self.frame_index)
        self.annotationChanged.emit()
        self.scoreChanged.emit()
        if save and self.frame is not None:
            measured = self.judge.measurement if self.annotation.annotated else None
            self.set_scores.put(self.frame.name, measured)

    def _travel(self, direction: Literal["undo", "redo"], done: str) -> None:
        if self.workspace is None or self.frame is None:
            return
        label = getattr(self.workspace, direction)(self.frame_index)
        if label is None:
            self.message.emit(f"nothing to {direction} on this frame", "info")
            return
        self._preview = None
        self._after_edit()
        self.message.emit(f"{done}: {label}", "info")

    def _after_reload(self, index: int) -> None:
        if index == self.frame_index:
            self._preview = None
            self._after_edit(save=False)

    def _committed(self, name: str) -> bool:
        return self.workspace is not None and self.workspace.is_committed(name)

    def _score_set(self) -> None:
        """Score every frame in the background."""
        if self.workspace is None or self.active_camera is None:
            self.set_scores.clear()
            return
        readers: dict[str, Callable[[], FrameAnnotation]] = {
            frame.name: partial(self.workspace.read, i)
            for i, frame in enumerate(self.workspace.frames)
        }
        self.set_scores.start(readers, self.active_camera, self.setup)
