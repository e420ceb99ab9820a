"""The part of the document that concerns cameras: the sources, the frame's scores, the set's."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from functools import partial

from PySide6.QtCore import Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.model import Field
from procc_annotator.gui.state.camera_sources import (
    CameraSource,
)
from procc_annotator.gui.state.disagreement import DisagreementWatch
from procc_annotator.gui.state.frame_on_screen import FrameOnScreen
from procc_annotator.gui.state.judge import Judge, SecondOpinion
from procc_annotator.gui.state.painted_width import PaintedWidth
from procc_annotator.gui.state.set_scores import FrameScores, SetScores
from procc_annotator.gui.state.source_frames import NO_CAMERA, SourceFrames, look_up
from procc_annotator.metric.measure import Measurement
from procc_annotator.metric.score import FrameScore
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.database.places import folder_of
from procc_annotator.session.dataset.camera_set import FrameCameras
from procc_annotator.session.dataset.dataset_field import keep_field
from procc_annotator.session.dataset.field_dimensions import keep_dimensions
from procc_annotator.session.dataset.field_lines import keep_lines
from procc_annotator.session.facts.verdict import Fault, Verdict, place_of
from procc_annotator.session.runs.audit import FrameAudit

_FORGOTTEN_ONE_BY_ONE = 400  # more are forgotten together with all others, which takes no time


class JudgedFrame(FrameOnScreen):
    """A frame of a dataset, judged against the active camera source.

    Attributes:
        sources: every camera source opened, in the order they were.
        active_source: the one that is judged.
        source_frames: what each of them shows of the frame on screen.
        disagreement: between the active and the compared source on the ground.
    """

    scoreChanged = Signal()
    fieldChanged = Signal()
    camerasChanged = Signal()
    frameScoresChanged = Signal(str)
    sourceAuditsChanged = Signal(object)

    def __init__(self, field: Field) -> None:
        super().__init__(field)
        self.noise_floor: tuple[float, float] | None = None
        self.sources: list[CameraSource] = []
        self.active_source: CameraSource | None = None
        self._compared: CameraSource | None = None
        self._compared_chosen = False
        self.judge = Judge(EvaluationSetup(field))
        self.source_frames = SourceFrames(self)
        self.source_frames.set_setup(self.setup)
        self._second_opinion = SecondOpinion()
        self.set_scores = SetScores(self)
        self.set_scores.changed.connect(self._audits_changed)
        self.set_scores.failed.connect(lambda text: self.message.emit(text, "error"))
        self.painted_width = PaintedWidth(self)
        self.disagreement = DisagreementWatch(self)
        for signal in (self.scoreChanged, self.camerasChanged, self.source_frames.changed):
            signal.connect(self.disagreement.look)

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
    def frame_scores(self) -> FrameScores:
        """Frame name -> JaC at `tau`, for frames scored so far (while blind: committed ones)."""
        allowed = self._committed if self.blind else None
        return FrameScores(self.active_audits, self.tau, allowed)

    @property
    def active_audits(self) -> Mapping[str, FrameAudit]:
        """Frame name -> how the active source does there, also where blind mode hides it."""
        return self.active_source.audits if self.active_source is not None else {}

    def shown_verdict(self, name: str) -> Fault | None:
        """Whose fault a frame's score is under the active source; None while blind mode hides
        what is known of the camera there."""
        source = self.active_source
        if source is None or (self.blind and not self._committed(name)):
            return None
        verdict = self.verdict(name, source)
        return None if verdict is None else verdict.fault

    def verdict(self, name: str, source: CameraSource) -> Verdict | None:
        """Whose fault a frame's score is under a source, also where blind mode hides it; None for
        fits, which change with the clicks."""
        if source.files is None:
            return None
        return self.review.verdict(name, source.name, self.place(source))

    def set_verdict(
        self, name: str, source: CameraSource, fault: Fault | None, comment: str = ""
    ) -> None:
        """Say whose fault a frame's score is under a source from files; None takes it back."""
        if source.files is None:
            return
        self.review.set_verdict(name, source.name, self.place(source), fault, comment)

    def place(self, source: CameraSource) -> str:
        """What verdicts know a source by, whatever it is called; empty without a dataset or
        files."""
        cameras = source.files
        if self.workspace is None or cameras is None:
            return ""
        return place_of(cameras.path, cameras.format, self.workspace.folder)

    # --- camera sources --------------------------------------------------------------------------

    @property
    def camera_sets(self) -> list[FrameCameras]:
        """The cameras of every source, in the order of `sources`."""
        return [source.camera_set for source in self.sources]

    @property
    def active_camera(self) -> FrameCameras | None:
        """The cameras that are judged."""
        return self.active_source.camera_set if self.active_source is not None else None

    @property
    def compared(self) -> CameraSource | None:
        """The source that the active one is held against: as chosen, else the one that was active
        before, else the first other one."""
        others = [source for source in self.sources if source is not self.active_source]
        if self.active_source is None or not others:
            return None
        return self._compared if self._compared in others else others[0]

    @property
    def compared_drawing(self) -> tuple[Measurement | None, FrameScore | None]:
        """Measurement and score of the shown annotation against the compared source; None without
        its camera and while blind."""
        if not self.projection_visible:
            return None, None
        shown = self.source_frames.of(self.compared)
        return self._second_opinion.of(shown, self.shown_annotation, self.judge)

    # --- terms -----------------------------------------------------------------------------------

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
        self.source_frames.set_setup(self.setup)
        self.set_scores.forget(self.sources)
        self._rejudge()
        self._show_sources()
        self._score_set()

    def set_sized_field(self, field: Field, *, keep: bool = True) -> None:
        """Give the field other dimensions, or lines elsewhere; all that is shown and judged goes by
        them.

        Args:
            field: the one that is shown, `resized`.
            keep: whether the dataset keeps its dimensions and where its lines are.

        Raises:
            FieldError: a landmark has the name of one of the field's classes.
        """
        field = self._with_own_landmarks(field)
        if keep and (database := self.review.database) is not None:
            keep_dimensions(database, field)
            keep_lines(database, field)
        self._change_field(field)

    def set_field(self, field: Field, *, keep: bool = True) -> None:
        """Show, judge and fit by another field; annotations, their histories and what is not saved
        yet stay, as do the dataset's landmarks.

        Args:
            field: of any sport; classes that it does not know stay in sight.
            keep: whether the dataset remembers it.

        Raises:
            FieldError: a landmark has the name of one of the field's classes.
        """
        field = self._with_own_landmarks(field)
        if keep and self.workspace is not None and (database := self.review.database) is not None:
            keep_field(database, folder_of(self.workspace.root), field)
        self._change_field(field)

    def take_field(self, field: Field) -> None:
        """Go by the field with other landmarks; what the dataset keeps of its field stays."""
        self._change_field(field)

    @property
    def frame_field(self) -> Field:
        """The field with what moves where it was in the frame on screen."""
        return self.judge.frame_setup.field

    def set_noise_floor(self, floor: tuple[float, float] | None) -> None:
        """Median and 95 % of the distances between two annotators, px; shown beside tau."""
        if floor != self.noise_floor:
            self.noise_floor = floor
            self.scoreChanged.emit()

    # --- inside ---

    @property
    def _from_files(self) -> list[CameraSource]:
        """The sources that were loaded, which come before fits."""
        return [source for source in self.sources if source.files is not None]

    def _with_own_landmarks(self, field: Field) -> Field:
        own = self.field
        return with_landmarks(field, own.landmarks, own.instant, own.instants)

    def _change_field(self, field: Field) -> None:
        if field == self.field and field.source == self.field.source:
            return
        self._use_field(field)
        self.fieldChanged.emit()
        self._rejudge()
        self._show_sources()
        self._score_set()

    def _use_field(self, field: Field) -> None:
        """Compute with another field from now on; what is shown is asked for anew afterwards."""
        self.field = field
        if self.workspace is not None:
            self.workspace.set_field(field)
        self.judge.set_setup(field=field)
        self.source_frames.set_setup(self.setup)
        self.set_scores.forget(self.sources)

    def _rejudge(self) -> None:
        self._judge_again()
        self.scoreChanged.emit()

    def _judge_again(self) -> None:
        self._show_camera()
        self.judge.judge(self.shown_annotation)

    def _show_camera(self) -> None:
        """Let the judge have the active source's camera of the frame on screen."""
        frame, cameras = self.frame, self.active_camera
        self.judge.set_frame(None if frame is None else frame.name)
        if frame is None or cameras is None:
            self.judge.show(NO_CAMERA)
            return
        shown = self.source_frames.peek(cameras, frame.name)
        if shown is None:
            shown = look_up(cameras, frame.name, self.setup)
            self.source_frames.put(cameras, frame.name, shown)
        self.judge.show(shown)

    def _show_sources(self) -> None:
        """Have the frame on screen, and those beside it, looked up in every source."""
        frame, index = self.frame, self.frame_index
        if frame is None or self.workspace is None:
            self.source_frames.show(self.sources, None)
            return
        frames = self.workspace.frames
        beside = [frames[i].name for i in (index + 1, index - 1) if 0 <= i < len(frames)]
        self.source_frames.show(self.sources, frame.name, beside)

    def _score_set(self) -> None:
        """Audit what is not audited yet in the background, the active source first."""
        workspace = self.workspace
        if workspace is None:
            self.set_scores.cancel()
            return
        readers: dict[str, Callable[[], FrameAnnotation | None]] = {
            frame.name: partial(workspace.to_judge, i) for i, frame in enumerate(workspace.frames)
        }
        first = self.active_source
        ordered = sorted(self.sources, key=lambda source: source is not first)
        self.set_scores.start(ordered, readers, self.setup, self.tau)

    def judge_frames_again(self, names: Collection[str]) -> None:
        """Annotations of frames that are not on screen are others now: audit these anew."""
        self.set_scores.cancel()  # what it found there is of the annotations before
        if len(names) > _FORGOTTEN_ONE_BY_ONE:
            self.set_scores.forget(self.sources)
        else:
            for source in self.sources:
                source.forget(names)
        self._score_set()
        for source in self.sources:
            self.sourceAuditsChanged.emit(source)
        self.frameScoresChanged.emit("")

    def _audit_frame_again(self) -> None:
        """The annotation on screen is another one: every source from files is judged anew against
        it; fits are once they are made."""
        frame, active, state = self.frame, self.active_source, self.state
        if frame is None or state is None:
            return
        counts = state.counts
        if active is not None and active.files is not None:
            measured = self.judge.measurement if counts else None
            self.set_scores.put(active, frame.name, self.judge.shown, measured, self.tau)
        others = [(s, self.source_frames.of(s)) for s in self._from_files if s is not active]
        now = self.annotation if counts else None
        self.set_scores.audit_again(frame.name, now, others, self.setup, self.tau)

    def _audits_changed(self, source: CameraSource, frame: str) -> None:
        if source in self.sources:
            self.sourceAuditsChanged.emit(source)
        if source is self.active_source:
            self.frameScoresChanged.emit(frame)
