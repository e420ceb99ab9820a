"""The camera fitted to the clicks of the frame on screen, worked out after every edit."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import Camera
from procc_annotator.field.model import Field
from procc_annotator.fit.result import FitResult
from procc_annotator.gui.state.source_frames import SourceFrame, look_up
from procc_annotator.gui.worker import Job, JobControl, Stopped, run_in_background
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.clicks.insight import Insight, gain_insight
from procc_annotator.session.dataset.fitted_cameras import FittedCameras, FittedFrame

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document

DEFAULT_MODEL = "auto"
MODELS = ("auto", "H", "P", "R", "R+")
_KEPT = 32  # insights, of frames and steps of undo one may come back to
_STAYED_MS = 80  # a frame that is left sooner was only passed: no fit slows the walk through it


@dataclass(frozen=True, eq=False)
class _Asked:
    """All that a fit depends on, and where its search begins."""

    annotation: FrameAnnotation
    frame: str
    size: tuple[int, int]
    model: str
    field: Field
    not_visible: frozenset[str]
    setup: EvaluationSetup
    start: Camera | None = None

    def same_as(self, other: _Asked) -> bool:
        """Whether the fit would be the same."""
        terms = (self.frame, self.size, self.model) == (other.frame, other.size, other.model)
        terms = terms and self.not_visible == other.not_visible
        same_things = self.annotation is other.annotation and self.field is other.field
        return same_things and terms


@dataclass(frozen=True, eq=False)
class _Answer:
    """What was found, and what the fit shows of the frame under the terms of then."""

    asked: _Asked
    insight: Insight
    shown: SourceFrame


class LiveFit(QObject):
    """Fits a camera in the background; what is shown always belongs to the annotation on screen.

    One fit is under way at most: whatever is asked meanwhile waits, and only the newest of it is
    done. A gesture is fitted once it has ended: a fit holds the interpreter for milliseconds at a
    time, which a drag would feel; and a point is best dragged against what all clicks said before.
    A frame is fitted once somebody stays on it, an edit at once.

    Attributes:
        model: one of `MODELS`; auto takes the simplest that the clicks support.
        chosen: whether somebody wants a fit, be the dataset locked or not.
    """

    changed = Signal()  # another insight, or none

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document
        self.model = DEFAULT_MODEL
        self.chosen = True
        self._on = True
        self._insight: Insight | None = None
        self._asked: _Asked | None = None
        self._latest: _Answer | None = None
        self._kept: deque[_Answer] = deque(maxlen=_KEPT)
        self._job: Job | None = None
        self._under_way: _Asked | None = None  # what the job works on, or worked on last
        self._frame: str | None = None
        self._closed = False
        self._passing = QTimer(self, singleShot=True, interval=_STAYED_MS)
        self._passing.timeout.connect(self._begin)
        document.datasetChanged.connect(self._forget)
        for signal in (
            document.datasetChanged,
            document.frameChanged,
            document.fieldChanged,
            document.annotationChanged,
            document.modeChanged,
            document.scoreChanged,  # a frame committed in blind mode
            document.review.statusChanged,
            document.review.notVisibleChanged,
        ):
            signal.connect(self.look)

    @property
    def wanted(self) -> bool:
        """Whether the fit is on: somebody wants one, and the dataset is not locked to blind
        mode, where nothing that follows from the clicks may come to guide them."""
        return self.chosen and self._document.blind_lock.lock is None

    @property
    def allowed(self) -> bool:
        """Whether the fit may be shown: blind mode is for clicks that nothing has influenced."""
        return self._document.projection_visible

    @property
    def insight(self) -> Insight | None:
        """What the annotation on screen tells; None while that is worked out, or to be hidden."""
        found = self._insight
        current = found is not None and found.annotation is self._document.annotation
        return found if current and self.allowed and self.wanted else None

    @property
    def result(self) -> FitResult | None:
        """The fit to the annotation on screen; None as for `insight`."""
        return self.insight.fit if self.insight is not None else None

    @property
    def shown(self) -> SourceFrame | None:
        """What the fit shows of the frame on screen, where that is known under today's terms."""
        latest = self._latest
        if latest is None or latest.insight is not self.insight:
            return None
        return latest.shown if latest.asked.setup == self._document.setup else None

    @property
    def working(self) -> bool:
        """Whether the fit of what is on screen is under way."""
        under_way = self._job is not None or self._passing.isActive()
        return self._asked is not None and self._insight is None and under_way

    def set_wanted(self, wanted: bool) -> None:
        """Switch the live fit on or off; a dataset locked to blind mode has none."""
        if barred := self._document.blind_lock.no_fit:
            self._document.message.emit(barred, "info")
            self.changed.emit()  # the switch shows what holds
        elif wanted != self.chosen:
            self.chosen = wanted
            self.look()

    def set_model(self, model: str) -> None:
        """Fit another model from now on."""
        if model != self.model:
            self.model = model
            self.look()
            self.changed.emit()

    def look(self) -> None:
        """The frame, its annotation or what is wanted may be other than before."""
        turned, self._on = self.wanted != self._on, self.wanted
        asked = self._what_to_fit()
        if asked is None:
            self._drop()
        if turned:
            self.changed.emit()
        if asked is None:
            return
        if self._asked is not None and asked.same_as(self._asked):
            return
        came, self._frame = asked.frame != self._frame, asked.frame
        self._asked = asked
        self._insight = self._known(asked)
        self._passing.stop()
        if self._insight is None:
            if came:
                self._passing.start()
            else:
                self._begin()
        self.changed.emit()

    def close(self) -> None:
        """Fit nothing any more."""
        self._closed = True
        self._passing.stop()
        if self._job is not None:
            self._job.cancel()
            self._job = None
        self._asked = None

    # --- inside ---

    def _what_to_fit(self) -> _Asked | None:
        document = self._document
        frame = document.frame
        if self._closed or not (self.wanted and self.allowed) or frame is None:
            return None
        # Points are shares of the picture: where it cannot be read, any size of its shape will do.
        size = document.picture_size or document.setup.size
        start = None
        if self._latest is not None:
            before, insight = self._latest.asked, self._latest.insight
            same_sport = before.field.name == document.field.name
            if same_sport and (before.frame, before.size) == (frame.name, size):
                start = insight.fit.camera
        hidden = document.review.not_visible(frame.name)
        return _Asked(
            document.annotation, frame.name, size, self.model, document.frame_field, hidden,
            document.setup, start,
        )  # fmt: skip

    def _known(self, asked: _Asked) -> Insight | None:
        """What was found of the same clicks before: on another visit, before an undo."""
        for answer in self._kept:
            if answer.asked.same_as(asked):
                self._latest = answer
                return answer.insight
        return None

    def _begin(self) -> None:
        """Have the newest of what is asked done, unless the end of a fit sees to it."""
        if self._job is None:
            self._job = run_in_background(
                self._work,
                on_result=self._take,
                on_error=self._fail,
                owner=self,
                urgent=True,
            )

    def _work(self, control: JobControl) -> _Answer | None:
        """In a thread: what is the newest once the thread is free; left when it is not any more."""
        asked = self._under_way = self._asked
        if asked is None:
            return None

        def go_on() -> None:
            if control.cancelled or self._asked is not asked:
                raise Stopped

        try:
            insight = gain_insight(
                asked.annotation,
                asked.field,
                size=asked.size,
                model=asked.model,
                start=asked.start,
                not_visible=asked.not_visible,
                go_on=go_on,
            )
        except Stopped:
            return None
        fitted = FittedFrame(asked.annotation, insight.fit)
        shown = look_up(FittedCameras({asked.frame: fitted}), asked.frame, asked.setup)
        return _Answer(asked, insight, shown)

    def _take(self, answer: _Answer | None) -> None:
        self._job = None
        if answer is not None:
            self._latest = answer
            self._kept.append(answer)
            if self._asked is answer.asked:
                self._insight = answer.insight
                self.changed.emit()
                return
        if self._asked is not None and self._insight is None:
            self._begin()

    def _fail(self, text: str) -> None:
        self._job = None
        self._document.message.emit(f"the fit failed: {text}", "warning")
        if self._asked is not None and self._asked is not self._under_way:
            self._begin()  # what was asked since may well go through
        self.changed.emit()

    def _drop(self) -> None:
        self._passing.stop()
        had, self._insight, self._asked = self._asked, None, None
        if had is not None:
            self.changed.emit()

    def _forget(self) -> None:
        self._asked = self._insight = self._latest = None
        self._frame = None
        self._kept.clear()
