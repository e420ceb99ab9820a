"""The camera of the frame on screen and how it agrees with the clicks; no widgets."""

from __future__ import annotations

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import CameraOrProjections
from procc_annotator.gui.state.scoring.frame_cameras import NO_CAMERA, SourceFrame, SourceFrames
from procc_annotator.gui.state.state import same
from procc_annotator.gui.state.store import Store
from procc_annotator.metrics.measurement import Measurement, measure_projected
from procc_annotator.metrics.score import FrameScore, display_score
from procc_annotator.metrics.setup import EvaluationSetup


class FrameScorer:
    """Measures the annotation on screen against the active camera when a person asks, and again
    only if need be."""

    def __init__(self, store: Store, source_frames: SourceFrames) -> None:
        self._store = store
        self._source_frames = source_frames
        self._of_frame: tuple[EvaluationSetup, str | None, EvaluationSetup] | None = None
        self._opinion, self._other_opinion = CachedScore(), CachedScore()

    @property
    def tau(self) -> float:
        """The threshold in px of the evaluation size."""
        return self._store.state.tau

    @property
    def frame_setup(self) -> EvaluationSetup:
        """The terms in the frame on screen; the same object as long as they stay."""
        setup, frame = self._store.state.setup, self._store.state.frame_name
        known = self._of_frame
        if known is None or known[0] is not setup or known[1] != frame:
            own = setup if frame is None else setup.of_frame(frame)
            known = self._of_frame = (setup, frame, own)
        return known[2]

    @property
    def shown(self) -> SourceFrame:
        """The active camera in the frame on screen."""
        state = self._store.state
        frame, cameras = state.frame_name, state.cameras_of(state.active)
        if frame is None or cameras is None:
            return NO_CAMERA
        return self._source_frames.look_up(cameras, frame, state.setup)

    @property
    def judged(self) -> tuple[Measurement | None, FrameScore | None]:
        """Distances of the shown annotation and its score, also while blind mode hides them."""
        return self._opinion.of(self.shown, self._store.state.shown_annotation, self)

    @property
    def camera(self) -> CameraOrProjections | None:
        """In px of the evaluation size; None while blind mode hides it."""
        return self.shown.camera if self._store.state.projection_visible else None

    @property
    def measurement(self) -> Measurement | None:
        """Distances of the shown annotation; None without a camera and while blind."""
        return self.judged[0] if self._store.state.projection_visible else None

    @property
    def score(self) -> FrameScore | None:
        """The score at the threshold; None without a camera and while blind."""
        return self.judged[1] if self._store.state.projection_visible else None

    @property
    def compared(self) -> tuple[Measurement | None, FrameScore | None]:
        """Measurement and score of the shown annotation against the compared source; None without
        its camera and while blind."""
        state = self._store.state
        if not state.projection_visible:
            return None, None
        shown = self._source_frames.of(state.compared)
        return self._other_opinion.of(shown, state.shown_annotation, self)


class CachedScore:
    """The measurement and score of a camera, computed at access."""

    def __init__(self) -> None:
        self._asked: tuple[object, ...] = ()
        self._measurement: Measurement | None = None
        self._score: FrameScore | None = None

    def of(
        self, shown: SourceFrame | None, annotation: FrameAnnotation, terms: FrameScorer
    ) -> tuple[Measurement | None, FrameScore | None]:
        """Measurement and score under the terms of the judge; measured again only if need be."""
        projected = shown.projected if shown is not None else None
        if projected is None:
            return None, None
        asked = projected, annotation, terms.frame_setup
        if not same(asked, self._asked):
            self._asked, self._score = asked, None
            self._measurement = measure_projected(annotation, projected, terms.frame_setup)
        assert self._measurement is not None
        if self._score is None or self._score.threshold != terms.tau:
            self._score = display_score(self._measurement, terms.tau)
        return self._measurement, self._score
