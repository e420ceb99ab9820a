"""The state of one window and everything that works on it, assembled; it knows no widget."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Generic, TypeVar, overload

from PySide6.QtCore import QObject

from procc_annotator.batch.audit import FrameAudit
from procc_annotator.camera.base import CameraOrProjections
from procc_annotator.dataset.records import default_author
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.gui.state.blind_lock import BlindLock
from procc_annotator.gui.state.checking.label_check import LabelCheck
from procc_annotator.gui.state.checking.line_pixels import PaintWatch
from procc_annotator.gui.state.editing.editor import Editing
from procc_annotator.gui.state.editing.outside_changes import OutsideChanges
from procc_annotator.gui.state.editing.presence import Presence
from procc_annotator.gui.state.editing.saving import Saver
from procc_annotator.gui.state.landmarks import Landmarks
from procc_annotator.gui.state.maps import (
    DisagreementWatch,
    MapSight,
    PaintedWidth,
    UncertaintyWatch,
)
from procc_annotator.gui.state.messages import UNSAVED, Level
from procc_annotator.gui.state.navigation.field_choice import FieldChoice
from procc_annotator.gui.state.navigation.navigator import FrameWalk
from procc_annotator.gui.state.navigation.opening import Opening
from procc_annotator.gui.state.prediction.camera_choice import Foresight
from procc_annotator.gui.state.prediction.fit_source import FitSource
from procc_annotator.gui.state.prediction.ghosts import Ghosts
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.prediction.proposals import Corrections, Proposals
from procc_annotator.gui.state.prediction.shot_track import ShotTrack
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.saying import notify, say, withdraw
from procc_annotator.gui.state.scoring.camera_sources import KeptVerdicts, Sources
from procc_annotator.gui.state.scoring.dataset_scores import (
    Auditing,
    FrameScores,
    SetScores,
    scores_of,
)
from procc_annotator.gui.state.scoring.evaluation_settings import Terms
from procc_annotator.gui.state.scoring.frame_cameras import SourceFrames
from procc_annotator.gui.state.scoring.frame_score import Judge
from procc_annotator.gui.state.second import SecondAnnotator
from procc_annotator.gui.state.selection import Selecting
from procc_annotator.gui.state.sequences import AnnotatedIndices, SequenceWatch
from procc_annotator.gui.state.signals import Signals
from procc_annotator.gui.state.state import State
from procc_annotator.gui.state.store import Store
from procc_annotator.image.decoding import FrameCache
from procc_annotator.image.pixels import PixelArray
from procc_annotator.metrics.measurement import Measurement
from procc_annotator.metrics.score import FrameScore
from procc_annotator.metrics.setup import EvaluationSetup

T = TypeVar("T")

_CACHE_BYTES = 16 * 2**20  # more than the pictures that may come next cost more than they spare


class Read(Generic[T]):
    """Something of the document's state, under the document's own name."""

    def __init__(self, select: Callable[[State], T]) -> None:
        self._select = select

    @overload
    def __get__(self, document: None, owner: type) -> Read[T]: ...
    @overload
    def __get__(self, document: Document, owner: type) -> T: ...
    def __get__(self, document: Document | None, owner: type) -> T | Read[T]:
        return self if document is None else self._select(document.store.state)


class Document(QObject):
    """Makes the store and its services, in the order in which they hear of a change, and shares
    them: what is read of the state, the commands, and the signals."""

    workspace = Read(lambda s: s.workspace)
    frame = Read(lambda s: s.frame)
    frame_index = Read(lambda s: s.frame_index)
    frame_error = Read(lambda s: s.why_not_editable)
    annotation = Read(lambda s: s.annotation)
    shown_annotation = Read(lambda s: s.shown_annotation)
    picture_size = Read(lambda s: s.picture_size)
    editable = Read(lambda s: s.editable)
    why_not_judged = Read(lambda s: s.why_not_judged)
    projection_visible = Read(lambda s: s.projection_visible)
    revealed_frames = Read(lambda s: s.revealed_frames)
    blind = Read(lambda s: s.blind)
    field = Read(lambda s: s.field)
    setup = Read(lambda s: s.setup)
    tau = Read(lambda s: s.tau)
    noise_floor = Read(lambda s: s.noise_floor)
    sources = Read(lambda s: list(s.sources))
    active_source = Read(lambda s: s.active)
    active_camera = Read(lambda s: s.cameras_of(s.active))
    camera_sets = Read(lambda s: [look.cameras for look in s.looks])
    compared = Read(lambda s: s.compared)
    selected_class = Read(lambda s: s.selection.class_name)
    selected_point = Read(lambda s: s.selection.point)
    selected_points = Read(lambda s: s.selection.points)
    hovered_class = Read(lambda s: s.hovered_class)
    mode = Read(lambda s: s.mode)
    author = Read(lambda s: s.author)

    def __init__(
        self,
        field: Field | None = None,
        cache: FrameCache | None = None,
        parent: QObject | None = None,
    ) -> None:
        """Nothing is open yet.

        Args:
            field: shown where a dataset says nothing else; None: the default one.
            cache: of pictures.
            parent: the window: with it the store goes, and with the store all that listens to it.
        """
        super().__init__(parent)
        setup = EvaluationSetup(field if field is not None else load_field())
        self.store = store = Store(State(setup, author=default_author()), self)
        self.cache = cache if cache is not None else FrameCache(_CACHE_BYTES)
        self.signals = signals = Signals(store)
        self._share_signals(signals)
        self.review = ReviewState(self)
        self.saver, self.presence = Saver(self), Presence(self)
        self.source_frames, self.set_scores = SourceFrames(self), SetScores(self)
        self.judge = Judge(store, self.source_frames)
        self.auditing = Auditing(store, signals, self.judge, self.source_frames, self.set_scores)
        store.changed.connect(self.auditing.follow)  # before anybody looks at what follows
        store.changed.connect(signals.tell)
        self._listen()
        self._make_commands()
        self._make_watches()

    @property
    def state(self) -> State:
        """As it is now."""
        return self.store.state

    @property
    def picture(self) -> PixelArray | None:
        """The whole picture of the frame on screen; waited for where half its size is shown."""
        self.walk.see_whole()
        return self.state.picture

    # --- what is worked out at once, as far as blind mode lets it be seen -----------------------

    @property
    def camera(self) -> CameraOrProjections | None:
        """The camera of the frame on screen, unless it is hidden by blind mode."""
        return self.judge.camera

    @property
    def measurement(self) -> Measurement | None:
        """Distances of the shown annotation; None without a camera and while blind."""
        return self.judge.measurement

    @property
    def score(self) -> FrameScore | None:
        """The score at `tau`; None without a camera and while blind."""
        return self.judge.score

    @property
    def camera_notice(self) -> str:
        """Return what to know about the frame's camera (scaled from another size, missing)."""
        return self.judge.shown.notice

    @property
    def camera_error(self) -> str:
        """Why the frame's camera cannot be used."""
        return self.judge.shown.error

    @property
    def frame_field(self) -> Field:
        """The field with what moves where it was in the frame on screen."""
        return self.judge.frame_setup.field

    @property
    def frame_scores(self) -> FrameScores:
        """Frame name -> JaC at `tau`, for frames scored so far (while blind: committed ones)."""
        return scores_of(self.state)

    @property
    def active_audits(self) -> Mapping[str, FrameAudit]:
        """Frame name -> how the active source does there, also where blind mode hides it."""
        return self.active_source.audits if self.active_source is not None else {}

    @property
    def compared_drawing(self) -> tuple[Measurement | None, FrameScore | None]:
        """Measurement and score of the shown annotation against the compared source; None without
        its camera and while blind."""
        return self.judge.compared

    # --- assembly -----------------------------------------------------------------------------

    def _share_signals(self, signals: Signals) -> None:
        self.datasetChanged, self.frameChanged = signals.datasetChanged, signals.frameChanged
        self.annotationChanged = signals.annotationChanged
        self.pictureChanged, self.previewChanged = signals.pictureChanged, signals.previewChanged
        self.selectionChanged, self.hoverChanged = signals.selectionChanged, signals.hoverChanged
        self.scoreChanged, self.fieldChanged = signals.scoreChanged, signals.fieldChanged
        self.camerasChanged, self.modeChanged = signals.camerasChanged, signals.modeChanged
        self.saveStateChanged, self.blindChanged = signals.saveStateChanged, signals.blindChanged
        self.framesEdited, self.aboutToLeave = signals.framesEdited, signals.aboutToLeave
        self.frameScoresChanged = signals.frameScoresChanged
        self.sourceAuditsChanged = signals.sourceAuditsChanged
        self.flyTo, self.flyToArea = signals.flyTo, signals.flyToArea
        self.message = signals.message

    def _listen(self) -> None:
        """What services find out by themselves goes into the state."""
        self.review.failed.connect(self._say_warning)
        self.saver.failed.connect(self._say_unsaved)
        self.saver.changed.connect(self._take_unsaved)
        self.presence.changed.connect(self._take_holder)

    def _make_commands(self) -> None:
        store, signals, review = self.store, self.signals, self.review
        self.verdicts = KeptVerdicts(store, review)
        self.selecting = Selecting(store, signals)
        self.terms = Terms(store, signals, review)
        self.camera_sources = Sources(store, self.auditing, self.set_scores, self.verdicts)
        self.editing = Editing(store, signals, self.saver, self.presence, review, self.auditing)
        self.outside = OutsideChanges(
            store, signals, self.editing, self.camera_sources, self.auditing
        )
        self.second = SecondAnnotator(store, signals)
        self.blind_lock = BlindLock(store, review)
        self.blind_lock.refused.connect(signals.modeChanged)
        self.walk = FrameWalk(
            store, signals, self.cache, self.editing, self.auditing, self.second, self.outside
        )
        self._share_commands()

    def _share_commands(self) -> None:
        """Those that many need bear the document's name; the others are their service's."""
        selecting, terms, sources = self.selecting, self.terms, self.camera_sources
        self.select_class, self.select_point = selecting.select_class, selecting.select_point
        self.hover_class = selecting.hover_class
        self.set_mode, self.set_option = selecting.set_mode, selecting.set_option
        self.set_tau, self.set_protocol = terms.set_tau, terms.set_protocol
        self.set_noise_floor, self.set_field = terms.set_noise_floor, terms.set_field
        self.load_cameras, self.remove_camera_set = sources.load_cameras, sources.remove_camera_set
        self.set_active_camera, self.compare_with = sources.set_active_camera, sources.compare_with
        self.swap_sources, self.rename_source = sources.swap_sources, sources.rename_source
        self.set_source_colour = sources.set_source_colour
        self.set_source_visible = sources.set_source_visible
        editing, walk = self.editing, self.walk
        self.begin_edit, self.edit = editing.begin_edit, editing.edit
        self.commit_edit, self.commit_frame = editing.commit_edit, editing.commit_frame
        self.note_unseen = editing.note_unseen
        self.undo, self.redo, self.save_now = editing.undo, editing.redo, editing.save_now
        self.look_at_frame = editing.look_at_frame
        self.go_to, self.next_frame = walk.go_to, walk.next_frame
        self.previous_frame = walk.previous_frame
        self.set_blind = self.blind_lock.set_blind

    def _make_watches(self) -> None:
        store, signals = self.store, self.signals
        self.sequence = SequenceWatch(store, signals)
        self.annotated_frames = AnnotatedIndices(store, signals)
        self.shot_track = ShotTrack(store, signals, self.sequence, self.camera_sources)
        self.painted_width = PaintedWidth(store, signals, self.judge)
        self.disagreement = DisagreementWatch(store, signals, self.source_frames)
        self.live_fit = LiveFit(store, signals, self.review, self.blind_lock, self.judge)
        self.uncertainty = UncertaintyWatch(
            store, signals, self.live_fit, self.blind_lock, self.disagreement
        )
        self.fit_source = FitSource(
            store, signals, self.camera_sources, self.source_frames, self.live_fit
        )
        self.proposals = Proposals(store, signals, self.blind_lock, self.cache)
        self.corrections = Corrections(store, signals, self.proposals)
        self.foresight = Foresight(
            store,
            signals,
            self.live_fit,
            self.review,
            self.shot_track,
            self.proposals,
            self.corrections,
        )
        self.ghosts = Ghosts(store, signals, self.foresight, self.review)
        self.map_sight = MapSight(store, signals, self.foresight, self.judge)
        self.paint_watch = PaintWatch(store, signals)
        self.label_check = LabelCheck(
            store, signals, self.review, self.live_fit, self.judge, self.paint_watch
        )
        self.field_choice = FieldChoice(store, signals, self.review, self.terms)
        self.landmarks = Landmarks(store, signals, self.judge, self.live_fit, self.terms)
        self.opening = Opening(
            self.store,
            self.walk,
            self.editing,
            self.blind_lock,
            self.field_choice,
            self.landmarks,
            self.second,
        )
        self.open_path, self.reopener = self.opening.open_path, self.opening.reopener

    # --- from outside the store -----------------------------------------------------------------

    def say(self, text: str, level: Level = "info", remedy: str = "") -> None:
        """Show the user one line, and which action may help."""
        say(self.store, text, level, remedy)

    def set_author(self, author: str) -> None:
        """Give points, comments and versions another author from now on."""
        self.store.set(author=author)
        if self.review.database is not None:
            self.review.database.author = author
        self.editing.presence.set_author(author)

    def close(self) -> None:
        """Stop everything that runs in the background, but for what is being saved."""
        self.saver.settle()
        for service in (
            self.outside,
            self.auditing,
            self.live_fit,
            self.label_check,
            self.field_choice,
            self.landmarks,
            self.ghosts,
            self.map_sight,
            self.foresight,
            self.corrections,
            self.proposals,
            self.uncertainty,
            self.disagreement,
            self.painted_width,
            self.paint_watch,
            self.sequence,
            self.annotated_frames,
        ):
            service.close()
        self.saver.retry_timer.stop()
        self.presence.close()
        self.review.set_database(None)
        self.cache.close()

    def _take_unsaved(self) -> None:
        self.store.set(unsaved=self.saver.problems)
        if not self.state.unsaved:
            withdraw(self.store, UNSAVED)

    def _take_holder(self) -> None:
        self.store.set(holder=self.presence.holder)

    def _say_warning(self, text: str) -> None:
        say(self.store, text, "warning")

    def _say_unsaved(self, text: str) -> None:
        notify(self.store, UNSAVED, text, "error", remedy="save")
