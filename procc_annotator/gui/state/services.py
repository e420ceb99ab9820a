"""The state of one window and everything that works on it, assembled; it knows no widget."""

from __future__ import annotations

from PySide6.QtCore import QObject

from procc_annotator.dataset.records import default_author
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.gui.state.background import ComputedValue
from procc_annotator.gui.state.checking.label_check import LabelCheck, LinePixels
from procc_annotator.gui.state.editing.editor import Editing
from procc_annotator.gui.state.editing.outside_changes import OutsideChanges
from procc_annotator.gui.state.editing.saving import FrameLock, Saver
from procc_annotator.gui.state.landmarks import Landmarks
from procc_annotator.gui.state.maps import (
    DisagreementMap,
    LineWidths,
    TopView,
    UncertaintyMap,
    VisibleFieldRegion,
)
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.navigation.field_choice import FieldChoice
from procc_annotator.gui.state.navigation.navigator import Navigator, Opening
from procc_annotator.gui.state.prediction.camera_choice import (
    CameraCorrections,
    PredictionSource,
    Proposals,
)
from procc_annotator.gui.state.prediction.computed_sources import FitSource, ShotTrack
from procc_annotator.gui.state.prediction.ghosts import Ghosts
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.review_state import BlindLock, ReviewState
from procc_annotator.gui.state.scoring.commands import CameraSourceCommands, EvaluationSettings
from procc_annotator.gui.state.scoring.dataset_scores import DatasetScoring
from procc_annotator.gui.state.scoring.frame_score import FrameScorer, SourceFrames
from procc_annotator.gui.state.second import SecondAnnotator
from procc_annotator.gui.state.selection import SelectionCommands
from procc_annotator.gui.state.sequences import AnnotatedIndices, open_sequence
from procc_annotator.gui.state.state import Level, State
from procc_annotator.gui.state.store import Store
from procc_annotator.image.decoding import FrameCache
from procc_annotator.metrics.setup import EvaluationSetup

_CACHE_BYTES = 16 * 2**20  # more than the pictures that may come next cost more than they spare


class Services(QObject):
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
            parent: the window: with it the store goes, and with the store all that listens to it.
        """
        super().__init__(parent)
        setup = EvaluationSetup(field if field is not None else load_field())
        self.store = store = Store(State(setup, author=default_author()), self)
        self.cache = cache if cache is not None else FrameCache(_CACHE_BYTES)
        self.review = ReviewState(store)
        self.saver, self.frame_lock = Saver(store), FrameLock(store)
        self.source_frames = SourceFrames(store)
        self.scorer = FrameScorer(store, self.source_frames)
        self.scoring = DatasetScoring(store, self.scorer, self.source_frames)
        store.score = self.scoring.follow
        self._make_commands()
        self._make_watches()

    @property
    def state(self) -> State:
        """The present state."""
        return self.store.state

    # --- assembly -----------------------------------------------------------------------------

    def _make_commands(self) -> None:
        store, review = self.store, self.review
        self.selection = SelectionCommands(store)
        self.evaluation = EvaluationSettings(store, review)
        self.camera_sources = CameraSourceCommands(store, self.scoring, review)
        self.editing = Editing(store, self.saver, self.frame_lock, review, self.scoring)
        self.outside_changes = OutsideChanges(
            store, self.editing, self.camera_sources, self.scoring
        )
        self.second_annotator = SecondAnnotator(store)
        self.blind_lock = BlindLock(store, review)
        self.navigator = Navigator(
            store,
            self.cache,
            self.editing,
            self.scoring,
            self.second_annotator,
            self.outside_changes,
        )

    def _make_watches(self) -> None:
        store = self.store
        self.sequence = open_sequence(store)
        self.annotated_frames = AnnotatedIndices(store)
        self.shot_track = ShotTrack(store, self.sequence, self.camera_sources)
        self.line_widths = LineWidths(store, self.scorer)
        self.disagreement = DisagreementMap(store, self.source_frames)
        self.live_fit = LiveFit(store, self.review, self.blind_lock, self.scorer)
        self.uncertainty = UncertaintyMap(store, self.live_fit, self.disagreement)
        self.fit_source = FitSource(store, self.camera_sources, self.source_frames, self.live_fit)
        self.proposals = Proposals(store, self.cache, self.review, self.evaluation)
        self.corrections = CameraCorrections(store, self.proposals)
        self.prediction = PredictionSource(
            store, self.live_fit, self.review, self.shot_track, self.proposals, self.corrections
        )
        self.ghosts = Ghosts(store, self.prediction, self.review)
        self.visible_region = VisibleFieldRegion(store, self.prediction, self.scorer)
        self.top_view = TopView(store, self.visible_region, self.prediction)
        self.line_pixels = LinePixels(store)
        self.label_check = LabelCheck(
            store, self.review, self.live_fit, self.scorer, self.line_pixels
        )
        self.field_choice = FieldChoice(store, self.review, self.evaluation)
        self.landmarks = Landmarks(store, self.scorer, self.live_fit, self.evaluation)
        self.opening = Opening(
            self.store,
            self.navigator,
            self.editing,
            self.blind_lock,
            self.field_choice,
            self.landmarks,
            self.second_annotator,
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
        self.editing.frame_lock.set_author(author)

    def close(self) -> None:
        """Stop everything that runs in the background, but for what is being saved."""
        self.saver.settle()
        self.outside_changes.close()
        self.scoring.close()
        self.label_check.close()
        self.field_choice.close()
        self.landmarks.close()
        for value in self.findChildren(ComputedValue):
            value.close()
        self.saver.retry_timer.stop()
        self.frame_lock.close()
        self.review.set_database(None)
        self.cache.close()
