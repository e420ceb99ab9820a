"""The camera fitted to the clicks of the frame on screen, worked out after every edit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.frame_analysis import FrameAnalysis, analyse_frame
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.base import Camera
from procc_annotator.dataset.computed_cameras import FittedCameras, FittedFrame
from procc_annotator.field.model import Field
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.availability import no_fit
from procc_annotator.gui.state.background import ComputedValue, Inputs
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.review_state import BlindLock, ReviewState
from procc_annotator.gui.state.scoring.frame_score import FrameScorer, SourceFrame, look_up
from procc_annotator.gui.state.store import Store
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.translation import tr, word

DEFAULT_MODEL = "auto"
MODELS = {
    "auto": word("chosen automatically"),
    "H": word("H: homography of the ground"),
    "P": word("P: pinhole"),
    "R": word("R: pinhole, lens distortion"),
    "R+": word("R+: R, aspect ratio, principal point"),
    "R2": word("R2: R+, second radial coefficient"),
    "F": word("F: fisheye"),
}
_KEPT = 32  # insights, of frames and steps of undo one may come back to
_STAYED_MS = 80  # a frame that is left sooner was only passed: no fit slows the walk through it


@dataclass(frozen=True, eq=False)
class Fitted:
    """A fit of a frame with what follows from it, and its projection under the settings it was made
    with."""

    insight: FrameAnalysis
    frame: str
    sport: str
    setup: EvaluationSetup
    shown: SourceFrame


@dataclass(eq=False, slots=True)
class _Terms:
    """Settings that do not identify a fit: its start camera, and the setup of its projection."""

    setup: EvaluationSetup
    start: Camera | None = None


class LiveFit(ComputedValue[Fitted]):
    """Fits a camera in the background; what is shown always belongs to the annotation on screen.

    A gesture is fitted once it has ended: a fit holds the interpreter for milliseconds at a time,
    which a drag would feel; and a point is best dragged against what all clicks said before. A
    frame is fitted once a person stays on it, an edit at once.

    Attributes:
        model: one of `MODELS`; auto takes the simplest that the clicks support.
        chosen: whether a person wants a fit, be the dataset locked or not.
    """

    def __init__(
        self, store: Store, review: ReviewState, blind_lock: BlindLock, scorer: FrameScorer
    ) -> None:
        self._terms = _Terms(store.state.setup)
        super().__init__(
            self._made_of,
            partial(_fit, self._terms),
            store,
            cache_size=_KEPT,
            stoppable=True,
            delay_ms=self._get_ready,
        )
        self._store, self._review = store, review
        self._blind_lock, self._scorer = blind_lock, scorer
        self.model = DEFAULT_MODEL
        self.chosen = True
        self._frame: str | None = None
        self.failed.connect(self._say)
        store.watch(select.dataset, self._begin_anew)
        store.watch(lambda s: (s.field, select.mode(s), s.committed), self.invalidate)
        store.keep_current(self, review.statusChanged, review.notVisibleChanged)

    @property
    def wanted(self) -> bool:
        """Return whether the fit is on: a person wants one, and the dataset is not locked to blind
        mode, where nothing that follows from the clicks may come to guide them."""
        return self.chosen and self._store.state.blind_lock is None

    @property
    def insight(self) -> FrameAnalysis | None:
        """Return what the annotation on screen says; None while that is worked out, or to be
        hidden."""
        return found.insight if (found := self.value) is not None else None

    @property
    def result(self) -> FitResult | None:
        """The fit to the annotation on screen; None as for `insight`."""
        return insight.fit if (insight := self.insight) is not None else None

    @property
    def shown(self) -> SourceFrame | None:
        """Return what the fit shows of the frame on screen, where that is known under today's
        terms."""
        found = self.value
        same_terms = found is not None and found.setup == self._store.state.setup
        return found.shown if found is not None and same_terms else None

    def set_wanted(self, wanted: bool) -> None:
        """Switch the live fit on or off; a dataset locked to blind mode has none."""
        if barred := self._blind_lock.no_fit:
            say(self._store, barred)
            self.changed.emit()  # the switch shows what holds
        elif wanted != self.chosen:
            self.chosen = wanted
            self.invalidate()

    def set_model(self, model: str) -> None:
        """Fit another model from now on."""
        if model != self.model:
            self.model = model
            self.invalidate()
            self.changed.emit()

    # --- inside ---

    def _made_of(self) -> Inputs | str | None:
        state = self._store.state
        name = state.frame_name
        if why := no_fit(state, self._blind_lock.no_fit, wanted=self.chosen):
            return why
        assert name is not None
        # Points are shares of the picture: where it cannot be read, any size of its shape will do.
        size = state.picture_size or state.setup.size
        field, hidden = self._scorer.frame_setup.field, self._review.not_visible(name)
        return state.annotation, field, name, size, self.model, hidden

    def _get_ready(self, inputs: Inputs) -> int:
        """Begin where the last fit of this frame ended, unless the frame was only passed."""
        state, terms, latest = self._store.state, self._terms, self.latest
        frame, size = inputs[2], inputs[3]
        terms.setup, terms.start = state.setup, None
        if latest is not None and latest.sport == state.field.name:
            fit = latest.insight.fit
            terms.start = fit.camera if (latest.frame, fit.size) == (frame, size) else None
        came, self._frame = frame != self._frame, str(frame)
        return _STAYED_MS if came else 0

    def _begin_anew(self) -> None:
        self._frame = None
        self.clear()
        self.invalidate()

    def _say(self, text: str) -> None:
        say(self._store, tr("the fit failed: {why}", why=text), "warning")


def _fit(
    terms: _Terms,
    annotation: FrameAnnotation,
    field: Field,
    frame: str,
    size: tuple[int, int],
    model: str,
    not_visible: frozenset[str],
    *,
    go_on: Callable[[], None],
) -> Fitted:
    setup, start = terms.setup, terms.start
    insight = analyse_frame(
        annotation, field, size=size, model=model, start=start, not_visible=not_visible, go_on=go_on
    )
    cameras = FittedCameras({frame: FittedFrame(annotation, insight.fit)})
    return Fitted(insight, frame, field.name, setup, look_up(cameras, frame, setup))
