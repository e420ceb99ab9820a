"""The camera that predictions (ghosts, suggestions, the map) follow.

That is the camera fitted to the clicks. As long as these give none, or agree with a camera that was
found without clicks and knows more elements, that one stands in for it: the camera of the track if
the shot was followed, else the proposed one. A dragged camera comes before all of them, until
something is annotated after it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from procc_annotator.assist.frame_analysis import FrameAnalysis, ghosts_without_clicks
from procc_annotator.assist.track_anchors import CameraCorrection, align_to_lines
from procc_annotator.batch.camera_proposals import set_pixel_aspect
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.proposal import NONE, SURE, UNSURE, Proposal
from procc_annotator.calibration.single_image.propose import propose_camera
from procc_annotator.calibration.tracking.track import TrackedFrame
from procc_annotator.dataset.computed_cameras import review_reason
from procc_annotator.dataset.dataset_field import ASPECT_SETTING, aspect_setting
from procc_annotator.dataset.frames import Frame
from procc_annotator.field.load import field_for_frame
from procc_annotator.field.model import Field, PixelAspect
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import ComputedValue, Inputs, Priority
from procc_annotator.gui.state.prediction.computed_sources import ShotTrack
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.scoring.commands import EvaluationSettings
from procc_annotator.gui.state.sequences import is_annotated
from procc_annotator.gui.state.store import Store
from procc_annotator.image.decoding import FrameCache
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import word

_KEPT_PROPOSALS = 64
_STAYED_MS = 150  # a frame that is left sooner was only passed
_NEIGHBOURS = (1, -1)  # looked at once nothing is left to do for the frame on screen


class Proposals(QObject):
    """Looks at the frame on screen if nothing is annotated there, then at those next to it.

    The answer is that of the picture alone, it does not depend on what was opened before; except
    how wide the pixels of the dataset are, which become part of its field and are kept. Nothing of
    it is ever saved: what a person accepts is an edit like any other. In blind mode, and in a
    dataset locked to it, nothing is looked for.
    """

    changed = Signal()  # what is known of the frame on screen, or that it is looked for

    def __init__(
        self, store: Store, cache: FrameCache, review: ReviewState, evaluation: EvaluationSettings
    ) -> None:
        super().__init__(store)
        self._store, self._cache, self._review = store, cache, review
        self._evaluation = evaluation
        self._frames: tuple[Frame, ...] = ()
        # Of the dataset, where they were estimated; and whether that was tried.
        self._pixels: PixelAspect | None = None
        self._pixels_known = False
        self.wanted = True
        self._rejected: set[Frame] = set()  # frames whose camera a person found wrong
        self._derived = ComputedValue(
            self._next,
            self._look_at,
            self,
            cache_size=_KEPT_PROPOSALS,
            cache_scope=lambda: store.state.workspace,
            stoppable=True,
            priority=Priority.LOW,
            delay_ms=lambda _: _STAYED_MS,
        )
        self._derived.changed.connect(self._take)
        store.keep_current(self._derived)

    def set_wanted(self, wanted: bool) -> None:
        """Propose cameras, or do not."""
        if wanted != self.wanted:
            self.wanted = wanted
            self._derived.invalidate()
            self.changed.emit()

    @property
    def allowed(self) -> bool:
        """Return whether a camera may be shown of the frame on screen before anything is
        clicked."""
        return self.allowed_in(self._store.state.frame_name)

    def allowed_in(self, frame: str | None) -> bool:
        """As `allowed`, for any frame by name."""
        state = self._store.state
        return state.reveals(frame) and state.blind_lock is None

    @property
    def here(self) -> Proposal | None:
        """Return what was found in the frame on screen; None while it is looked for, and where it
        is not."""
        if not (self.wanted and self.allowed):
            return None
        state = self._store.state
        found = None if state.frame is None else self._derived.cached(state.frame, state.field)
        if found is None or state.frame not in self._rejected:
            return found
        why = word("you rejected it (Ctrl+Z takes that back)")
        return replace(found, state=NONE, reason=why, fit=replace(found.fit, camera=None))

    def reject(self, rejected: bool) -> bool:
        """Show the unsure camera of the frame on screen no more, or again; False where there is
        none, or something is annotated."""
        found, state = self.here, self._store.state
        if found is None or state.frame is None or state.annotation.polylines:
            return False
        if rejected is (state.frame in self._rejected) or (rejected and found.state != UNSURE):
            return False
        self._rejected ^= {state.frame}
        self.changed.emit()
        return True

    @property
    def working(self) -> bool:
        """Return whether the frame on screen is examined, or about to be."""
        state = self._store.state
        return self._is_asked(state.frame_index) and not self._derived.is_cached(
            state.frame, state.field
        )

    # --- inside ---

    def _next(self) -> Inputs | None:
        """The first of the frames that should be examined and were not."""
        state = self._store.state
        if state.workspace is None or state.picture is None:
            return None
        here, frames = state.frame_index, state.workspace.frames
        if frames is not self._frames:
            self._frames = frames
            self._pixels, self._pixels_known = None, False
        for index in (here, *(here + step for step in _NEIGHBOURS)):
            if not 0 <= index < len(frames):
                continue
            frame = frames[index]
            if not self._is_asked(index):
                if index == state.frame_index:
                    return None  # a hand works here: no search slows it down
            elif not self._derived.is_cached(frame, state.field):
                return frame, state.field
        return None

    def _is_asked(self, index: int) -> bool:
        """Return whether a camera should be proposed for a frame: no one annotated it."""
        state = self._store.state
        workspace = state.workspace
        if workspace is None or index < 0 or not self.wanted or state.blind_lock is not None:
            return False
        if index == state.frame_index:
            annotation = state.annotation
            bare = not annotation.annotated and not annotation.unconfirmed
            return bare and not state.why_broken and self.allowed
        revealed = state.reveals(workspace.frames[index].name)
        return revealed and not is_annotated(workspace, index)

    def _look_at(self, frame: Frame, field: Field, *, go_on: Callable[[], None]) -> Proposal:
        """Propose a camera; runs in a thread."""
        go_on()
        field = field_for_frame(field, frame.name)
        picture = self._cache.get(frame.image_path)
        if field.pixels is None and not self._pixels_known:
            frames = self._frames
            pictures = [(one.name, one.image_path) for one in frames]
            pixels = set_pixel_aspect(pictures, field, go_on)
            if frames is self._frames:
                self._pixels, self._pixels_known = pixels, True
            field = replace(field, pixels=pixels)
        return propose_camera(picture, field, go_on=go_on)

    def _take(self) -> None:
        field = self._store.state.field
        if self._pixels is not None and field.pixels is None:
            self._review.set_setting(ASPECT_SETTING, aspect_setting(self._pixels))
            self._evaluation.take_field(replace(field, pixels=self._pixels))
        self.changed.emit()
        self._derived.invalidate_later()  # there may be the next one to look at


class CameraCorrections(QObject):
    """Commands on the state's ``corrected``. Nothing of it is saved: what a person accepts along a
    corrected camera is an edit like any other.
    """

    changed = Signal(str)  # the frame whose camera is corrected otherwise, or not any more

    def __init__(self, store: Store, proposals: Proposals) -> None:
        super().__init__(store)
        self._store, self._proposals = store, proposals
        self._before: dict[str, list[CameraCorrection | None]] = {}  # steps that can be taken back
        self._look = ComputedValue(self._to_look_at, _look_at, self, stoppable=True)
        self._look.changed.connect(self._take)
        store.watch(lambda s: (s.workspace, s.field), self._forget)
        store.keep_current(self._look)

    @property
    def here(self) -> CameraCorrection | None:
        """The correction of the frame on screen; None if there is none or it is hidden."""
        state = self._store.state
        if state.frame_name is None or not self._proposals.allowed:
            return None
        return state.corrected.get(state.frame_name)

    @property
    def rules(self) -> bool:
        """Return whether nothing was annotated here since the camera was corrected."""
        found = self.here
        return found is not None and found.annotation == self._store.state.annotation

    @property
    def looking(self) -> bool:
        """Return whether the lines of the camera on screen are being looked for."""
        return self._look.working

    def put(self, correction: CameraCorrection | None) -> None:
        """This is the camera of the frame on screen; None: it is corrected no more."""
        name = self._store.state.frame_name
        if name is not None:
            self._before.setdefault(name, []).append(self._store.state.corrected.get(name))
            self._set(name, correction)

    def take_back(self) -> bool:
        """The camera of the frame on screen is as it was before the last correction; False if there
        was none."""
        name = self._store.state.frame_name
        before = self._before.get(name or "")
        if name is None or not before or not self._proposals.allowed:
            return False
        self._set(name, before.pop())
        return True

    # --- inside ---

    def _set(self, name: str, correction: CameraCorrection | None) -> None:
        others = {n: c for n, c in self._store.state.corrected.items() if n != name}
        if correction is not None:
            others[name] = correction
        self._store.update(corrected=others)
        self._look.invalidate()
        self.changed.emit(name)

    def _to_look_at(self) -> Inputs | None:
        state, found = self._store.state, self.here
        if found is None or found.looked or state.picture is None or state.frame_name is None:
            return None
        return found, state.picture, state.field, state.frame_name

    def _take(self) -> None:
        """Keep what was found; it is no step of its own."""
        found, name = self._look.value, self._store.state.frame_name
        if found is not None and name is not None:
            self._set(name, found)

    def _forget(self) -> None:
        self._before.clear()
        if self._store.state.corrected:
            self._store.update(corrected={})
            self.changed.emit("")


def _look_at(
    found: CameraCorrection,
    picture: PixelArray,
    field: Field,
    frame: str,
    *,
    go_on: Callable[[], None],
) -> CameraCorrection:
    return align_to_lines(found, picture, field_for_frame(field, frame), go_on=go_on)


_KEPT = 8


def choose_camera(
    corrected: CameraCorrection | None, tracked: TrackedFrame | None, proposal: Proposal | None
) -> tuple[FitResult | None, str]:
    """Choose the camera to predict with, the one dragged by hand, else that of the track, else the
    proposed one, if there is any; and say why it should be checked first, empty if it is sure."""
    if corrected is not None:
        return corrected.fit, corrected.why_not
    if tracked is not None and tracked.fit is not None and tracked.fit.camera is not None:
        return tracked.fit, review_reason(tracked)
    if proposal is None:
        return None, ""
    doubt = "" if proposal.state == SURE else proposal.reason
    return (None if proposal.fit.camera is None else proposal.fit), doubt


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
        return self._choice[0]

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
        return self._choice[1]

    @property
    def stands_in(self) -> bool:
        """Return whether what is shown follows from a camera that was found without clicks."""
        insight = self.insight
        return insight is not None and not insight.from_clicks

    # --- inside ---

    @property
    def _choice(self) -> tuple[FitResult | None, str]:
        if not self._proposals.allowed or self._store.state.frame is None:
            return None, ""
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
