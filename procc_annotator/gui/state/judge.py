"""The camera of the frame on screen and how it agrees with the clicks; no widgets."""

from __future__ import annotations

from dataclasses import replace

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.gui.state.source_frames import NO_CAMERA, SourceFrame
from procc_annotator.metric.measure import Measurement, measure_projected
from procc_annotator.metric.score import FrameScore, score_to_read
from procc_annotator.metric.setup import EvaluationSetup

MIN_TAU, MAX_TAU, DEFAULT_TAU = 0.5, 30.0, 5.0


class Judge:
    """Measures the annotation on screen against the active camera.

    Attributes:
        shown: the active camera in the frame on screen.
    """

    def __init__(self, setup: EvaluationSetup) -> None:
        self.setup = setup
        self.tau = DEFAULT_TAU
        self.shown = NO_CAMERA
        self._frame: str | None = None
        self._of_frame: tuple[EvaluationSetup, str | None, EvaluationSetup] | None = None
        self.measurement: Measurement | None = None
        self.score: FrameScore | None = None

    @property
    def camera(self) -> CameraOrProjections | None:
        """In px of the evaluation size."""
        return self.shown.camera

    @property
    def notice(self) -> str:
        """What to know about the camera."""
        return self.shown.notice

    @property
    def error(self) -> str:
        """Why the camera cannot be used."""
        return self.shown.error

    def set_tau(self, tau: float) -> bool:
        """Change the threshold within its limits; False when nothing changed."""
        tau = round(min(max(tau, MIN_TAU), MAX_TAU), 1)
        if tau == self.tau:
            return False
        self.tau = tau
        if self.measurement is not None:
            self.score = score_to_read(self.measurement, tau)
        return True

    def set_setup(self, **changes: object) -> None:
        """Change the evaluation's terms; call `show` afterwards."""
        self.setup = replace(self.setup, **changes)  # type: ignore[arg-type]

    def set_frame(self, name: str | None) -> None:
        """Judge another frame; what moves is elsewhere in it."""
        self._frame = name

    @property
    def frame_setup(self) -> EvaluationSetup:
        """The terms in the frame on screen; the same object as long as they stay."""
        known = self._of_frame
        if known is None or known[0] is not self.setup or known[1] != self._frame:
            own = self.setup if self._frame is None else self.setup.of_frame(self._frame)
            known = self._of_frame = (self.setup, self._frame, own)
        return known[2]

    def show(self, shown: SourceFrame) -> None:
        """Take the camera of another frame or source; call `judge` afterwards."""
        self.shown = shown

    def judge(self, annotation: FrameAnnotation) -> None:
        """Measure an annotation against the frame's camera."""
        if self.shown.projected is None:
            self.measurement = self.score = None
            return
        self.measurement = measure_projected(annotation, self.shown.projected, self.frame_setup)
        self.score = score_to_read(self.measurement, self.tau)


class SecondOpinion:
    """How another camera agrees with the same clicks, measured when somebody asks."""

    def __init__(self) -> None:
        self._asked: tuple[object, ...] = ()
        self._measurement: Measurement | None = None
        self._score: FrameScore | None = None

    def of(
        self, shown: SourceFrame | None, annotation: FrameAnnotation, terms: Judge
    ) -> tuple[Measurement | None, FrameScore | None]:
        """Measurement and score under the terms of the judge; measured again only if need be."""
        projected = shown.projected if shown is not None else None
        if projected is None:
            return None, None
        asked = projected, annotation, terms.frame_setup
        if len(self._asked) != 3 or any(
            a is not b for a, b in zip(asked, self._asked, strict=True)
        ):
            self._asked, self._score = asked, None
            self._measurement = measure_projected(annotation, projected, terms.frame_setup)
        assert self._measurement is not None
        if self._score is None or self._score.threshold != terms.tau:
            self._score = score_to_read(self._measurement, terms.tau)
        return self._measurement, self._score
