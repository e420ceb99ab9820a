"""JaC of every frame of the set, computed in the background and looked up at any threshold."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.gui.state.judge import MAX_TAU, MIN_TAU
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.metric.measure import Measurement, measure
from procc_annotator.metric.score import jac_curve
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.camera_set import CameraSet

# Every threshold the slider can take, so that moving it computes nothing: 1.2 KB a frame.
TAU_GRID = np.round(np.arange(MIN_TAU, MAX_TAU + 0.05, 0.1), 1)
Curve = NDArray[np.float32]
ReadAnnotation = Callable[[], FrameAnnotation]


def _curve(measurement: Measurement) -> Curve:
    return jac_curve(measurement, TAU_GRID).astype(np.float32)


class FrameScores(Mapping[str, float]):
    """Frame name -> JaC at one threshold; a view, built without copying."""

    def __init__(
        self, curves: Mapping[str, Curve], tau: float, allowed: Callable[[str], bool] | None = None
    ) -> None:
        self._curves = curves
        self._column = int(np.argmin(np.abs(TAU_GRID - tau)))
        self._allowed = allowed

    @property
    def allowed(self) -> Callable[[str], bool] | None:
        """Which frames may be shown; None: all."""
        return self._allowed

    def __getitem__(self, name: str) -> float:
        if self._allowed is not None and not self._allowed(name):
            raise KeyError(name)
        return float(self._curves[name][self._column])

    def __iter__(self) -> Iterator[str]:
        allowed = self._allowed
        return iter(n for n in self._curves if allowed is None or allowed(n))

    def __len__(self) -> int:
        return sum(1 for _ in self)


class SetScores(QObject):
    """Keeps the curve of every frame for the active camera set and setup."""

    changed = Signal(str)  # a frame's name, or "" for all
    progressed = Signal(int, int)
    failed = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.curves: dict[str, Curve] = {}
        self._touched: set[str] = set()
        self._job: Job | None = None

    @property
    def running(self) -> bool:
        """Whether the set is being scored."""
        return self._job is not None

    def clear(self) -> None:
        """Forget all scores and stop scoring."""
        self.cancel()
        self.curves = {}
        self._touched = set()
        self.changed.emit("")

    def cancel(self) -> None:
        """Stop scoring; the scores of frames that were opened stay."""
        if self._job is not None:
            self._job.cancel()
            self._job = None
            self.progressed.emit(0, 0)

    def start(
        self, readers: Mapping[str, ReadAnnotation], cameras: CameraSet, setup: EvaluationSetup
    ) -> None:
        """Score all frames in the background, from frame name -> how to read its annotation."""
        self.clear()

        def work(control: JobControl) -> dict[str, Curve]:
            return _score_set(readers, cameras, setup, control)

        self._job = run_in_background(
            work,
            on_result=self._finished,
            on_error=self._failed,
            on_progress=self.progressed.emit,
            owner=self,
        )

    def put(self, name: str, measurement: Measurement | None) -> None:
        """Take over the score of the frame on screen after an edit."""
        self._touched.add(name)
        if measurement is None:
            if self.curves.pop(name, None) is None:
                return
        else:
            self.curves[name] = _curve(measurement)
        self.changed.emit(name)

    def _finished(self, curves: dict[str, Curve]) -> None:
        self._job = None
        newer = {n: self.curves[n] for n in self._touched if n in self.curves}
        self.curves = {n: c for n, c in curves.items() if n not in self._touched} | newer
        self.progressed.emit(0, 0)
        self.changed.emit("")

    def _failed(self, text: str) -> None:
        self._job = None
        self.progressed.emit(0, 0)
        self.failed.emit(text)


def _score_set(
    readers: Mapping[str, ReadAnnotation],
    cameras: CameraSet,
    setup: EvaluationSetup,
    control: JobControl,
) -> dict[str, Curve]:
    curves: dict[str, Curve] = {}
    for done, (name, read) in enumerate(readers.items(), start=1):
        if control.cancelled:
            break
        try:
            loaded = cameras.camera(name, setup.size)
            if loaded is not None:
                annotation = read()
                if annotation.annotated:
                    curves[name] = _curve(measure(annotation, loaded.camera, setup))
        except InputError:
            pass  # told when somebody opens this frame; the rest of the set goes on
        if done % 50 == 0 or done == len(readers):
            control.progress(done, len(readers))
    return curves
