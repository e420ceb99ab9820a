"""How every source does in every frame: audited in the background, looked up at any threshold."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from time import monotonic

import numpy as np
from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.audit import TAU_GRID, FrameAudit, audit_frame
from procc_annotator.dataset.camera_set import FrameCameras
from procc_annotator.errors import CameraError, InputError
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts
from procc_annotator.formats.cameras.loaded_camera import NAME_THE_FORMAT, field_mismatch
from procc_annotator.gui.latest import Latest
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.source_frames import SourceFrame
from procc_annotator.gui.state.state import State
from procc_annotator.gui.worker import JobControl
from procc_annotator.metrics.measurement import Measurement, measure_projected
from procc_annotator.metrics.projection import clipped_projection_error, project_field
from procc_annotator.metrics.setup import EvaluationSetup

_TELL_AFTER_S = 0.25
_TELL_PLOTS_AFTER_S = 1.0

ReadAnnotation = Callable[[], FrameAnnotation | None]


class FrameScores(Mapping[str, float]):
    """Frame name -> JaC at one threshold; a view, built without copying."""

    def __init__(
        self,
        audits: Mapping[str, FrameAudit],
        tau: float,
        allowed: Callable[[str], bool] | None = None,
    ) -> None:
        self._audits = audits
        self._column = int(np.argmin(np.abs(TAU_GRID - tau)))
        self._allowed = allowed

    @property
    def allowed(self) -> Callable[[str], bool] | None:
        """Which frames may be shown; None: all."""
        return self._allowed

    def __getitem__(self, name: str) -> float:
        if self._allowed is not None and not self._allowed(name):
            raise KeyError(name)
        return float(self._audits[name].jac[self._column])

    def __iter__(self) -> Iterator[str]:
        allowed = self._allowed
        return iter(n for n in self._audits if allowed is None or allowed(n))

    def __len__(self) -> int:
        return sum(1 for _ in self)


def scores_of(state: State) -> FrameScores:
    """Frame name -> JaC at the threshold, of frames scored so far (while blind: committed ones)."""
    audits = state.active.audits if state.active is not None else {}
    return FrameScores(audits, state.tau, state.reveals if state.blind else None)


@dataclass(frozen=True, eq=False, slots=True)
class _Outcome:
    """What became of one frame under one source."""

    source: CameraSource
    frame: str
    audit: FrameAudit | None
    problem: str


class SetScores(QObject):
    """Audits the frames of all sources, one source after the other."""

    changed = Signal(object, str)  # source, and a frame's name, or "" for many
    progressed = Signal(int, int)
    failed = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._set_work = Latest(self, self._fail)
        self._frame_work: dict[str, Latest] = {}
        self._touched: set[tuple[CameraSource, str]] = set()  # judged anew since the start
        self._untold: dict[CameraSource, float] = {}  # since when

    @property
    def running(self) -> bool:
        """Return whether the set is being audited."""
        return self._set_work.running

    def cancel(self) -> None:
        """Stop auditing; what was found so far stays."""
        if self._set_work.cut_short():
            self._end()

    def close(self) -> None:
        """Stop everything that is under way."""
        self.cancel()
        for work in self._frame_work.values():
            work.cancel()
        self._frame_work.clear()

    def forget(self, sources: Sequence[CameraSource]) -> None:
        """Drop all that is known of these sources, and what is under way: the terms changed."""
        self.close()
        for source in sources:
            source.clear()
            self.changed.emit(source, "")

    def start(
        self,
        sources: Sequence[CameraSource],
        readers: Mapping[str, ReadAnnotation],
        setup: EvaluationSetup,
        tau: float,
    ) -> None:
        """Audit in the background what was not examined yet.

        Args:
            sources: in the order they are to be done.
            readers: frame name -> how to read its annotation, from any thread; None where a frame
                belongs to no figure of the set.
            setup: the terms; sources audited under others must have been cleared.
            tau: px, decides between plain and mirrored labels.
        """
        self.cancel()
        self._touched.clear()
        wanted = [(source, source.camera_set, source.to_look_at(readers)) for source in sources]
        total = sum(len(names) for _, _, names in wanted)
        if not total:
            return

        def work(control: JobControl) -> None:
            done, told = 0, monotonic()
            for source, cameras, names in wanted:
                for name in names:
                    if control.cancelled:
                        return
                    audit, problem = _audit(name, readers[name], cameras, setup, tau)
                    control.hand_over(_Outcome(source, name, audit, problem))
                    done += 1
                    if monotonic() - told > _TELL_AFTER_S:
                        control.progress(done, total)
                        told = monotonic()

        self._set_work.start(
            work, lambda _: self._end(), progress=self._progressed, parts=self._take
        )

    def put(
        self, source: CameraSource, frame: str, shown: SourceFrame, measurement: Measurement | None,
        tau: float, fitted: FitCounts = NOT_FITTED,
    ) -> None:  # fmt: skip
        """Take over how a source does in the frame on screen after an edit.

        Args:
            fitted: whether its camera was fitted to these very clicks.
        """
        self._touched.add((source, frame))
        known, problem = frame in source.audits, source.problems.get(frame, "")
        audit = None
        if measurement is not None and shown.camera is not None:
            audit = audit_frame(frame, shown.camera, shown.model, measurement, tau, fitted=fitted)
        source.take(frame, audit, shown.error)
        if known or audit is not None or shown.error != problem:
            self.changed.emit(source, frame)

    def audit_again(
        self,
        frame: str,
        annotation: FrameAnnotation | None,
        shown: Sequence[tuple[CameraSource, SourceFrame | None]],
        setup: EvaluationSetup,
        tau: float,
    ) -> None:
        """Audit one frame after an edit with some sources, in the background.

        Args:
            frame: its name.
            annotation: what is in it now; None if it belongs to no figure of the set.
            shown: what the sources show of it, as far as known.
        """
        self._touched.update((source, frame) for source, _ in shown)
        if (earlier := self._frame_work.pop(frame, None)) is not None:
            earlier.cancel()
        if not shown:
            return
        read: ReadAnnotation = lambda: annotation  # noqa: E731
        asked = [(source, source.camera_set, known) for source, known in shown]

        def work(control: JobControl) -> list[_Outcome]:
            return [
                _Outcome(source, frame, *_audit(frame, read, cameras, setup, tau, known))
                for source, cameras, known in asked
            ]

        def done(outcomes: list[_Outcome]) -> None:
            self._frame_work.pop(frame, None)
            now = {source for source, cameras, _ in asked if source.camera_set is cameras}
            for outcome in outcomes:
                if outcome.source not in now:
                    continue  # its cameras are others by now
                outcome.source.take(frame, outcome.audit, outcome.problem)
                self.changed.emit(outcome.source, frame)

        self._frame_work[frame] = Latest(self, self.failed.emit, urgent=True)
        self._frame_work[frame].start(work, done)

    # --- inside ---

    def _progressed(self, done: int, total: int) -> None:
        now = monotonic()
        if any(now - since > _TELL_PLOTS_AFTER_S for since in self._untold.values()):
            self._tell_changed()
        self.progressed.emit(done, total)

    def _take(self, outcomes: list[_Outcome]) -> None:
        now = monotonic()
        for outcome in outcomes:
            if (outcome.source, outcome.frame) not in self._touched:
                outcome.source.take(outcome.frame, outcome.audit, outcome.problem)
                self._untold.setdefault(outcome.source, now)

    def _tell_changed(self) -> None:
        untold, self._untold = self._untold, {}
        for source in untold:
            self.changed.emit(source, "")

    def _end(self) -> None:
        self._tell_changed()
        self.progressed.emit(0, 0)

    def _fail(self, text: str) -> None:
        self._end()
        self.failed.emit(text)


def _audit(
    frame: str,
    read: ReadAnnotation,
    cameras: FrameCameras,
    setup: EvaluationSetup,
    tau: float,
    known: SourceFrame | None = None,
) -> tuple[FrameAudit | None, str]:
    """One frame under one source, and why its camera cannot be used."""
    projected = known.projected if known is not None else None
    setup = setup.of_frame(frame)
    try:
        found = cameras.camera(frame, setup.size)
    except CameraError as error:
        return None, str(error)
    if found is None:
        return None, ""
    if problem := field_mismatch(found.assumed_field, setup.field):
        return None, f"{frame}: {problem} ({NAME_THE_FORMAT})"
    if problem := clipped_projection_error(found.camera, setup):
        return None, f"{frame}: {problem}"
    try:
        annotation = read()
    except InputError:  # told when somebody opens this frame; the rest of the set goes on
        return None, ""
    if annotation is None:
        return None, ""
    if projected is None:
        projected = project_field(found.camera, setup)
    measurement = measure_projected(annotation, projected, setup)
    fitted = FitCounts.of(found.fitted_on, annotation)
    audit = audit_frame(frame, found.camera, found.model, measurement, tau, fitted=fitted)
    return audit, ""
