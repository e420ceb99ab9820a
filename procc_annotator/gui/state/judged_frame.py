"""The part of the document that concerns cameras: the active set, the frame's scores, the set's."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.errors import ProccError
from procc_annotator.field.model import Field
from procc_annotator.gui.state.judge import Judge
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.set_scores import FrameScores, SetScores
from procc_annotator.metric.measure import Measurement
from procc_annotator.metric.score import FrameScore
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.camera_set import CameraSet
from procc_annotator.session.workspace import Frame, FrameState, Workspace

_EMPTY = FrameAnnotation()


class JudgedFrame(QObject):
    """A frame of a dataset, judged against the active camera set."""

    scoreChanged = Signal()
    camerasChanged = Signal()
    frameScoresChanged = Signal(str)
    message = Signal(str, str)

    def __init__(self, field: Field) -> None:
        super().__init__()
        self.field = field
        self.workspace: Workspace | None = None
        self.frame_index = -1
        self.blind = False
        self.noise_floor: tuple[float, float] | None = None
        self.camera_sets: list[CameraSet] = []
        self.active_camera: CameraSet | None = None
        self._preview: FrameAnnotation | None = None
        self.review = ReviewState(self)
        self.judge = Judge(EvaluationSetup(field))
        self.set_scores = SetScores(self)
        self.set_scores.changed.connect(self.frameScoresChanged)
        self.set_scores.failed.connect(lambda text: self.message.emit(text, "error"))

    # --- what is on screen ---

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
    def annotation(self) -> FrameAnnotation:
        """The finished annotation of the frame on screen."""
        state = self.state
        return state.history.current if state is not None else _EMPTY

    @property
    def shown_annotation(self) -> FrameAnnotation:
        """The annotation including a gesture under way."""
        return self._preview if self._preview is not None else self.annotation

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
    def camera(self) -> CameraOrProjections | None:
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
        frame = self.frame
        return not self.blind or (frame is not None and self._committed(frame.name))

    @property
    def frame_scores(self) -> FrameScores:
        """Frame name -> JaC at `tau`, for frames scored so far (while blind: committed ones)."""
        allowed = self._committed if self.blind else None
        return FrameScores(self.set_scores.curves, self.tau, allowed)

    # --- cameras ---------------------------------------------------------------------------------

    def load_cameras(self, path: Path, fmt: str = "auto") -> bool:
        """Add a folder, archive or file of cameras and make it the active set."""
        try:
            cameras = CameraSet.open(path, fmt)
        except (ProccError, OSError) as error:
            self.message.emit(str(error), "error")
            return False
        if not cameras.frames:
            self.message.emit(f"{path}: no cameras in it ({_where_else(path)})", "error")
            return False
        self.camera_sets.append(cameras)
        self.set_active_camera(len(self.camera_sets) - 1)
        if cameras.notices:
            self.message.emit("; ".join(cameras.notices), "warning")
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

    def set_noise_floor(self, floor: tuple[float, float] | None) -> None:
        """Median and 95 % of the distances between two annotators, px; shown beside tau."""
        if floor != self.noise_floor:
            self.noise_floor = floor
            self.scoreChanged.emit()

    # --- inside ---

    def _rejudge(self) -> None:
        frame = self.frame
        self.judge.show(self.active_camera, frame.name if frame else None)
        self.judge.judge(self.shown_annotation)
        self.scoreChanged.emit()

    def _committed(self, name: str) -> bool:
        return self.review.record(name).committed

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


def _where_else(path: Path) -> str:
    """What to do about a folder without cameras."""
    try:
        inner = sorted(p.name for p in path.iterdir() if p.is_dir() and not p.name.startswith("."))
    except OSError:  # a single file or an archive
        inner = []
    if inner:
        return f"load one of its folders: {', '.join(inner[:6])}"
    return "expected files like camera_00037.json, 00037.npy or 00037.homographyMatrix"
