"""The part of the document that concerns cameras: the sources, the frame's scores, the set's."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from functools import partial
from pathlib import Path

from PySide6.QtCore import Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.errors import ProccError
from procc_annotator.field.load import resized
from procc_annotator.field.model import Field
from procc_annotator.gui.state.camera_sources import (
    CameraSource,
    free_colour,
    free_name,
    same_place,
    where_else,
)
from procc_annotator.gui.state.disagreement import DisagreementWatch
from procc_annotator.gui.state.frame_on_screen import FrameOnScreen
from procc_annotator.gui.state.judge import Judge, SecondOpinion
from procc_annotator.gui.state.set_scores import FrameScores, SetScores
from procc_annotator.gui.state.source_frames import NO_CAMERA, SourceFrames, look_up
from procc_annotator.metric.measure import Measurement, measure_projected
from procc_annotator.metric.score import FrameScore
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.audit import FrameAudit
from procc_annotator.session.camera_set import CameraSet, FrameCameras
from procc_annotator.session.field_dimensions import keep_dimensions
from procc_annotator.session.verdict import Fault, Verdict, place_of


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

    def load_cameras(self, path: Path, fmt: str = "auto", name: str | None = None) -> bool:
        """Add a folder, archive or file of cameras and make it the active source.

        What is loaded already is read again from the disk.
        """
        try:
            cameras = CameraSet.open(path, fmt, name)
        except (ProccError, OSError) as error:
            self.message.emit(str(error), "error")
            return False
        if not cameras.frames:
            self.message.emit(f"{path}: no cameras in it ({where_else(path)})", "error")
            return False
        source = self.add_source(cameras)
        if name is not None:
            self.rename_source(source, name)
        remarks = [*cameras.notices, *self._no_match(cameras)]
        if remarks:
            self.message.emit("; ".join(remarks), "warning")
        return True

    def _no_match(self, cameras: CameraSet) -> Iterator[str]:
        """What to say of cameras that belong to no frame of the dataset."""
        frames = self.workspace.frames if self.workspace is not None else ()
        if frames and not any(frame.name in cameras.frames for frame in frames):
            yield (
                f"{cameras.path}: no camera has the name of a frame (cameras are named like"
                f" {next(iter(cameras.frames))!r}, frames like {frames[0].name!r})"
            )

    def add_source(
        self,
        cameras: CameraSet,
        *,
        colour: str | None = None,
        visible: bool = True,
        active: bool = True,
        changed: Collection[str] | None = None,
    ) -> CameraSource:
        """Add cameras that were opened already; the same ones loaded before are replaced.

        Args:
            changed: frames whose cameras are others than those loaded before; None: all.
        """
        known = next((s for s in self.sources if same_place(s.files, cameras)), None)
        if known is not None:
            cameras.name = known.name
            known.camera_set = cameras
            if changed is None:
                self.set_scores.forget([known])
            else:
                known.forget(changed)
            source = known
        else:
            cameras.name = free_name(cameras.name, self.sources)
            source = CameraSource(cameras, colour or free_colour(self.sources), visible=visible)
            self.sources.insert(len(self._from_files), source)
        if active or self.active_source is source:
            self._activate(source)
        else:
            self._show_sources()
            self.camerasChanged.emit()
        self._score_set()
        return source

    def set_active_camera(self, index: int) -> None:
        """Judge against this source; -1 for none. What is known of the set is not computed anew."""
        chosen = self.sources[index] if 0 <= index < len(self.sources) else None
        self._activate(chosen)

    def compare_with(self, source: CameraSource | None) -> None:
        """Hold the active source against this one, until another is chosen; None: against the one
        that was active before."""
        self._compared, self._compared_chosen = source, source is not None
        self.camerasChanged.emit()

    def swap_sources(self) -> None:
        """Judge against the compared source, and compare with the one that was active."""
        if (other := self.compared) is not None:
            self._activate(other)

    def remove_camera_set(self, index: int) -> None:
        """Forget a source (its files stay)."""
        removed = self.sources.pop(index)
        if removed is self.active_source:
            self.active_source = None
            self.set_active_camera(min(index, len(self._from_files) - 1))
        else:
            self._show_sources()
            self.camerasChanged.emit()
        self._score_set()

    def join_source(self, source: CameraSource, *, active: bool) -> None:
        """Put a source of fits behind the others."""
        self.sources.append(source)
        if active:
            self._activate(source)
        else:
            self.camerasChanged.emit()

    def show_source_again(self, source: CameraSource) -> None:
        """A source of fits has another camera for the frame on screen, or none any more."""
        frame = self.frame
        if frame is None or source not in self.sources:
            return
        shown = look_up(source.camera_set, frame.name, self.setup)
        self.source_frames.put(source.camera_set, frame.name, shown)
        measurement = None
        if shown.projected is not None and self.annotation.annotated:
            measurement = measure_projected(self.annotation, shown.projected, self.setup)
        self.set_scores.put(source, frame.name, shown, measurement, self.tau)
        if source is self.active_source:
            self._rejudge()
        self.source_frames.changed.emit()

    def clear_sources(self) -> None:
        """Forget all sources."""
        self.sources.clear()
        self.active_source = self._compared = None
        self._compared_chosen = False
        self._activate(None)
        self._score_set()

    def rename_source(self, source: CameraSource, name: str) -> None:
        """Call a source something else; no two have the same name. Its verdicts go along."""
        name, before = " ".join(name.split()), source.name
        if source.files is not None and name and name != before:
            source.files.name = free_name(name, [s for s in self.sources if s is not source])
            if place := self.place(source):
                self.review.rename_source(place, before, source.name)
            self.camerasChanged.emit()

    def set_source_colour(self, source: CameraSource, colour: str) -> None:
        """Show a source in another colour."""
        source.colour = colour
        self.camerasChanged.emit()

    def set_source_visible(self, source: CameraSource, visible: bool) -> None:
        """Whether a source is drawn beside the active one."""
        source.visible = visible
        self.camerasChanged.emit()

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

    def set_field_dimensions(
        self, dimensions: Mapping[str, float] | None, *, keep: bool = True
    ) -> None:
        """Give the field other dimensions; everything that is shown and judged goes by them.

        Args:
            dimensions: metres, by name; those that are not named are nominal, None for all.
            keep: whether the dataset keeps them.

        Raises:
            FieldError: a dimension outside the range of the rules.
        """
        field = resized(self.field, dimensions or {})
        if keep and (database := self.review.database) is not None:
            keep_dimensions(database, field)
        if field != self.field:
            self._use_field(field)
            self.fieldChanged.emit()
            self._rejudge()
            self._show_sources()
            self._score_set()

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

    def _use_field(self, field: Field) -> None:
        """Compute with another field from now on; what is shown is asked for anew afterwards."""
        self.field = field
        if self.workspace is not None:
            self.workspace.field = field
        self.judge.set_setup(field=field)
        self.source_frames.set_setup(self.setup)
        self.set_scores.forget(self.sources)

    def _activate(self, source: CameraSource | None) -> None:
        before = self.active_source
        # Two that are compared change places; somebody's choice of a third one stays.
        stays = self._compared_chosen and self.compared is not source
        if before is not None and before is not source and not stays:
            self._compared = before
        self.active_source = source
        self._rejudge()
        self._show_sources()
        self.camerasChanged.emit()
        self.frameScoresChanged.emit("")

    def _rejudge(self) -> None:
        self._show_camera()
        self.judge.judge(self.shown_annotation)
        self.scoreChanged.emit()

    def _show_camera(self) -> None:
        """Let the judge have the active source's camera of the frame on screen."""
        frame, cameras = self.frame, self.active_camera
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
        readers: dict[str, Callable[[], FrameAnnotation]] = {
            frame.name: partial(workspace.read, i) for i, frame in enumerate(workspace.frames)
        }
        first = self.active_source
        ordered = sorted(self.sources, key=lambda source: source is not first)
        self.set_scores.start(ordered, readers, self.setup, self.tau)

    def _audit_frame_again(self) -> None:
        """The annotation on screen is another one: every source from files is judged anew against
        it; fits are once they are made."""
        frame, active = self.frame, self.active_source
        if frame is None:
            return
        if active is not None and active.files is not None:
            measured = self.judge.measurement if self.annotation.annotated else None
            self.set_scores.put(active, frame.name, self.judge.shown, measured, self.tau)
        others = [(s, self.source_frames.of(s)) for s in self._from_files if s is not active]
        self.set_scores.audit_again(frame.name, self.annotation, others, self.setup, self.tau)

    def _audits_changed(self, source: CameraSource, frame: str) -> None:
        if source in self.sources:
            self.sourceAuditsChanged.emit(source)
        if source is self.active_source:
            self.frameScoresChanged.emit(frame)
