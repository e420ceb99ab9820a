"""The camera fitted to the clicks of the frame on screen, worked out after every edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.result import FitResult
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.session.insight import Insight, gain_insight

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document


@dataclass(frozen=True, eq=False)
class _Asked:
    """All that a fit depends on but its start."""

    annotation: FrameAnnotation
    frame: str
    size: tuple[int, int]
    model: str
    field: Field
    not_visible: frozenset[str]

    def same_as(self, other: _Asked) -> bool:
        """Whether the answer would be the same."""
        terms = (self.frame, self.size, self.model) == (other.frame, other.size, other.model)
        terms = terms and self.not_visible == other.not_visible
        same_things = self.annotation is other.annotation and self.field is other.field
        return same_things and terms


class LiveFit(QObject):
    """Fits a camera in the background; what is shown always belongs to the annotation on screen.

    Attributes:
        model: H, P, R or R+.
    """

    changed = Signal()  # another insight, or none

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document
        self.model = "R"
        self._wanted = True
        self._insight: Insight | None = None
        self._asked: _Asked | None = None
        self._job: Job | None = None
        for signal in (
            document.datasetChanged,
            document.frameChanged,
            document.annotationChanged,
            document.modeChanged,
            document.review.notVisibleChanged,
        ):
            signal.connect(self.look)

    @property
    def wanted(self) -> bool:
        """Whether somebody wants a fit."""
        return self._wanted

    @property
    def allowed(self) -> bool:
        """Whether the fit may be shown: blind mode is for clicks that nothing has influenced."""
        return self._document.projection_visible

    @property
    def insight(self) -> Insight | None:
        """What the annotation on screen tells; None while that is worked out, or to be hidden."""
        found = self._insight
        current = found is not None and found.annotation is self._document.annotation
        return found if current and self.allowed and self._wanted else None

    @property
    def result(self) -> FitResult | None:
        """The fit to the annotation on screen; None as for `insight`."""
        return self.insight.fit if self.insight is not None else None

    @property
    def working(self) -> bool:
        """Whether a fit is under way."""
        return self._job is not None

    def set_wanted(self, wanted: bool) -> None:
        """Switch the live fit on or off."""
        self._wanted = wanted
        self.look()
        self.changed.emit()

    def set_model(self, model: str) -> None:
        """Fit another model from now on."""
        if model != self.model:
            self.model = model
            self.look()

    def look(self) -> None:
        """The frame, its annotation or what is wanted may be other than before."""
        document = self._document
        size, frame = document.picture_size, document.frame
        if not (self._wanted and self.allowed) or frame is None or size is None:
            self._drop()
            return
        hidden = document.review.not_visible(frame.name)
        asked = _Asked(document.annotation, frame.name, size, self.model, document.field, hidden)
        if self._asked is not None and asked.same_as(self._asked):
            return
        same_frame = self._asked is not None and self._asked.frame == frame.name
        before = self._insight.fit.camera if self._insight is not None and same_frame else None
        self._asked = asked
        self._cancel()
        annotation, field, model = asked.annotation, asked.field, asked.model

        def work(control: JobControl) -> Insight | None:
            if control.cancelled:
                return None
            return gain_insight(
                annotation, field, size=size, model=model, start=before, not_visible=hidden
            )

        self._job = run_in_background(work, on_result=self._take, on_error=self._fail, owner=self)
        self.changed.emit()

    def _take(self, insight: Insight | None) -> None:
        self._job = None
        self._insight = insight
        self.changed.emit()

    def _fail(self, text: str) -> None:
        self._job = None
        self._insight = None
        self._document.message.emit(text, "warning")
        self.changed.emit()

    def _cancel(self) -> None:
        if self._job is not None:
            self._job.cancel()
            self._job = None

    def _drop(self) -> None:
        self._cancel()
        had, self._insight, self._asked = self._insight, None, None
        if had is not None:
            self.changed.emit()
