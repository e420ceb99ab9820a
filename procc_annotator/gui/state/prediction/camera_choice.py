"""The camera that predictions (ghosts, suggestions, the map) follow.

That is the camera fitted to the clicks. As long as these give none, or agree with a camera that was
found without clicks and knows more elements, that one stands in for it: the camera of the track if
the shot was followed, else the proposed one. A dragged camera comes before all of them, until
something is annotated after it.
"""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from procc_annotator.assist.frame_analysis import FrameAnalysis, ghosts_without_clicks
from procc_annotator.assist.track_anchors import CameraCorrection
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.proposal import SURE, Proposal
from procc_annotator.calibration.tracking.track import TrackedFrame
from procc_annotator.dataset.computed_cameras import review_reason
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import ComputedValue, Inputs
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.prediction.proposals import CameraCorrections, Proposals
from procc_annotator.gui.state.prediction.shot_track import ShotTrack
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.store import Store

_KEPT = 8


@dataclass(frozen=True, eq=False, slots=True)
class CameraChoice:
    """A camera that was found without clicks, or dragged.

    Attributes:
        fit: the camera; None if none was found.
        doubt: why it should be checked first; empty if it is sure.
    """

    fit: FitResult | None = None
    doubt: str = ""


def choose_camera(
    corrected: CameraCorrection | None, tracked: TrackedFrame | None, proposal: Proposal | None
) -> CameraChoice:
    """Return the camera to predict with: the one dragged by hand, else that of the track, else the
    proposed one."""
    if corrected is not None:
        return CameraChoice(corrected.fit, corrected.why_not)
    if tracked is not None and tracked.fit is not None and tracked.fit.camera is not None:
        return CameraChoice(tracked.fit, review_reason(tracked))
    if proposal is None:
        return CameraChoice()
    doubt = "" if proposal.state == SURE else proposal.reason
    return CameraChoice(None if proposal.fit.camera is None else proposal.fit, doubt)


class PredictionSource(QObject):
    """The insight that ghosts go by."""

    changed = Signal()

    def __init__(
        self,
        store: Store,
        live_fit: LiveFit,
        review: ReviewState,
        track: ShotTrack,
        proposals: Proposals,
        corrections: CameraCorrections,
    ) -> None:
        super().__init__(store)
        self._store, self._live_fit, self._review = store, live_fit, review
        self._track, self._proposals, self._corrections = track, proposals, corrections
        self._stand_in = ComputedValue(
            self._made_of, ghosts_without_clicks, self, cache_size=_KEPT, stoppable=True
        )
        self._stand_in.changed.connect(self.changed)
        store.keep_current(self._stand_in)
        store.watch(select.mode, self._look)
        for signal in (
            live_fit.changed,
            review.notVisibleChanged,
            track.changed,
            track.followed,
            proposals.changed,
            corrections.changed,
        ):
            signal.connect(self._look)

    @property
    def allowed(self) -> bool:
        """Return whether it may be shown: blind mode is for clicks that nothing has influenced."""
        return self._live_fit.allowed

    @property
    def wanted(self) -> bool:
        """Return whether there is a camera to go by, or a person wants one."""
        return self._live_fit.wanted or self.found is not None

    @property
    def working(self) -> bool:
        """Return whether more may be known in a moment."""
        return self._live_fit.working or self._stand_in.working

    @property
    def found(self) -> FitResult | None:
        """The camera of the frame on screen that was found without clicks, or dragged."""
        return self._choice.fit

    @property
    def insight(self) -> FrameAnalysis | None:
        """Return what the camera says; None while that is worked out, or to be hidden."""
        stand_in = self._stand_in.value
        if stand_in is not None and stand_in.fit.camera is not None:
            return stand_in
        return self._live_fit.insight if not self._stand_in.working else None

    @property
    def doubt(self) -> str:
        """Why the camera that stands in should be examined first; empty where it is sure."""
        return self._choice.doubt

    @property
    def stands_in(self) -> bool:
        """Return whether what is shown follows from a camera that was found without clicks."""
        insight = self.insight
        return insight is not None and not insight.from_clicks

    def close(self) -> None:
        """Work nothing out any more."""
        self._stand_in.close()

    # --- inside ---

    @property
    def _choice(self) -> CameraChoice:
        if not self._proposals.allowed or self._store.state.frame is None:
            return CameraChoice()
        return choose_camera(self._corrections.here, self._track.here, self._proposals.here)

    def _made_of(self) -> Inputs | None:
        """Clicks that give a camera are compared with the camera that was found without them."""
        found, state = self.found, self._store.state
        if found is None or state.frame_name is None:
            return None
        fitted = None
        if state.annotation.annotated and self._live_fit.wanted and not self._corrections.rules:
            fitted = self._live_fit.insight
            if fitted is None:
                return None
        hidden = self._review.not_visible(state.frame_name)
        return state.annotation, state.sized_field, found, hidden, fitted

    def _look(self, *_: object) -> None:
        self._stand_in.invalidate()
        self.changed.emit()
