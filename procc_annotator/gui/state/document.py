"""The state of one window and everything that works on it, assembled; it knows no widget."""

from __future__ import annotations

from typing import TypeVar

from PySide6.QtCore import QObject

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
    SetScores,
)
from procc_annotator.gui.state.scoring.evaluation_settings import Terms
from procc_annotator.gui.state.scoring.frame_cameras import SourceFrames
from procc_annotator.gui.state.scoring.frame_score import Judge
from procc_annotator.gui.state.second import SecondAnnotator
from procc_annotator.gui.state.selection import Selecting
from procc_annotator.gui.state.sequences import AnnotatedIndices, SequenceWatch
from procc_annotator.gui.state.state import State
from procc_annotator.gui.state.store import Store
from procc_annotator.image.decoding import FrameCache
from procc_annotator.metrics.setup import EvaluationSetup

T = TypeVar("T")

_CACHE_BYTES = 16 * 2**20  # more than the pictures that may come next cost more than they spare


class Document(QObject):
    """The store and its services, made in the order in which they are notified of a change."""

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
        self.review = ReviewState(self)
        self.saver, self.presence = Saver(self), Presence(self)
        self.source_frames, self.set_scores = SourceFrames(self), SetScores(self)
        self.judge = Judge(store, self.source_frames)
        self.auditing = Auditing(store, self.judge, self.source_frames, self.set_scores)
        store.score = self.auditing.follow
        self._listen()
        self._make_commands()
        self._make_watches()

    @property
    def state(self) -> State:
        """The present state."""
        return self.store.state

    # --- assembly -----------------------------------------------------------------------------

    def _listen(self) -> None:
        """Put into the state what services find by themselves."""
        self.review.failed.connect(self._say_warning)
        self.saver.failed.connect(self._say_unsaved)
        self.saver.changed.connect(self._take_unsaved)
        self.presence.changed.connect(self._take_holder)

    def _make_commands(self) -> None:
        store, review = self.store, self.review
        self.verdicts = KeptVerdicts(store, review)
        self.selecting = Selecting(store)
        self.terms = Terms(store, review)
        self.camera_sources = Sources(store, self.auditing, self.set_scores, self.verdicts)
        self.editing = Editing(store, self.saver, self.presence, review, self.auditing)
        self.outside = OutsideChanges(store, self.editing, self.camera_sources, self.auditing)
        self.second = SecondAnnotator(store)
        self.blind_lock = BlindLock(store, review)
        self.walk = FrameWalk(
            store, self.cache, self.editing, self.auditing, self.second, self.outside
        )

    def _make_watches(self) -> None:
        store = self.store
        self.sequence = SequenceWatch(store)
        self.annotated_frames = AnnotatedIndices(store)
        self.shot_track = ShotTrack(store, self.sequence, self.camera_sources)
        self.painted_width = PaintedWidth(store, self.judge)
        self.disagreement = DisagreementWatch(store, self.source_frames)
        self.live_fit = LiveFit(store, self.review, self.blind_lock, self.judge)
        self.uncertainty = UncertaintyWatch(
            store, self.live_fit, self.blind_lock, self.disagreement
        )
        self.fit_source = FitSource(store, self.camera_sources, self.source_frames, self.live_fit)
        self.proposals = Proposals(store, self.blind_lock, self.cache)
        self.corrections = Corrections(store, self.proposals)
        self.foresight = Foresight(
            store,
            self.live_fit,
            self.review,
            self.shot_track,
            self.proposals,
            self.corrections,
        )
        self.ghosts = Ghosts(store, self.foresight, self.review)
        self.map_sight = MapSight(store, self.foresight, self.judge)
        self.paint_watch = PaintWatch(store)
        self.label_check = LabelCheck(
            store, self.review, self.live_fit, self.judge, self.paint_watch
        )
        self.field_choice = FieldChoice(store, self.review, self.terms)
        self.landmarks = Landmarks(store, self.judge, self.live_fit, self.terms)
        self.opening = Opening(
            self.store,
            self.walk,
            self.editing,
            self.blind_lock,
            self.field_choice,
            self.landmarks,
            self.second,
        )

    # --- from outside the store -----------------------------------------------------------------

    def say(self, text: str, level: Level = "info", remedy: str = "") -> None:
        """Show the user one line, and which action may help."""
        say(self.store, text, level, remedy)

    def set_author(self, author: str) -> None:
        """Give points, comments and versions another author from now on."""
        self.store.update(author=author)
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
        self.store.update(unsaved=self.saver.problems)
        if not self.state.unsaved:
            withdraw(self.store, UNSAVED)

    def _take_holder(self) -> None:
        self.store.update(holder=self.presence.holder)

    def _say_warning(self, text: str) -> None:
        say(self.store, text, "warning")

    def _say_unsaved(self, text: str) -> None:
        notify(self.store, UNSAVED, text, "error", remedy="save")
