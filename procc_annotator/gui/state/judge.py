"""The camera of the frame on screen and how it agrees with the clicks; no widgets."""

from __future__ import annotations

from dataclasses import replace

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.errors import CameraError
from procc_annotator.metric.measure import Measurement, measure_projected
from procc_annotator.metric.project import ProjectedField, project_field
from procc_annotator.metric.score import FrameScore, score
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.camera_set import CameraSet

MIN_TAU, MAX_TAU, DEFAULT_TAU = 0.5, 30.0, 5.0


class Judge:
    """Measures the annotation on screen against the active camera."""

    def __init__(self, setup: EvaluationSetup) -> None:
        self.setup = setup
        self.tau = DEFAULT_TAU
        self.camera: CameraOrProjections | None = None
        self.notice = ""
        self.error = ""
        self.measurement: Measurement | None = None
        self.score: FrameScore | None = None
        self._projected: ProjectedField | None = None

    def set_tau(self, tau: float) -> bool:
        """Change the threshold within its limits; False when nothing changed."""
        tau = round(min(max(tau, MIN_TAU), MAX_TAU), 1)
        if tau == self.tau:
            return False
        self.tau = tau
        if self.measurement is not None:
            self.score = score(self.measurement, tau)
        return True

    def set_setup(self, **changes: object) -> None:
        """Change the evaluation's terms; call `show` afterwards."""
        self.setup = replace(self.setup, **changes)  # type: ignore[arg-type]

    def show(self, camera_set: CameraSet | None, frame_name: str | None) -> None:
        """Take the camera of another frame or set; call `judge` afterwards."""
        self.camera, self._projected = None, None
        self.notice = self.error = ""
        if camera_set is None or frame_name is None:
            return
        try:
            found = camera_set.camera(frame_name, self.setup.size)
        except CameraError as error:
            self.error = str(error)
            return
        if found is None:
            self.notice = f"{camera_set.name} has no camera for {frame_name}"
            return
        self.camera, self.notice = found.camera, found.notice or ""

    def judge(self, annotation: FrameAnnotation) -> None:
        """Measure an annotation against the frame's camera."""
        if self.camera is None:
            self.measurement = self.score = None
            return
        if self._projected is None:
            self._projected = project_field(self.camera, self.setup)
        self.measurement = measure_projected(annotation, self._projected, self.setup)
        self.score = score(self.measurement, self.tau)
