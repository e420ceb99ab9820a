"""Scores of all frames of the dataset with every camera source, kept current with the state."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from time import monotonic

import numpy as np
from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.audit import TAU_GRID, FrameAudit, audit_frame
from procc_annotator.dataset.camera_set import FrameCameras
from procc_annotator.errors import InputError
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask, Priority, after_paint
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.scoring.frame_score import (
    FrameScorer,
    SourceFrame,
    SourceFrames,
    find_camera,
)
from procc_annotator.gui.state.state import State, same
from procc_annotator.gui.state.store import Store
from procc_annotator.metrics.measurement import Measurement, measure_projected
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

_PROGRESS_S = 0.25
_SIGNAL_S = 1.0

ReadAnnotation = Callable[[], FrameAnnotation | None]


class FrameScores(Mapping[str, float]):
    """Frame name -> JaC at one threshold, of the frames that may be shown (``allowed``; None: all);
    a view, built without copying."""

    def __init__(
        self,
        audits: Mapping[str, FrameAudit],
        tau: float,
        allowed: Callable[[str], bool] | None = None,
    ) -> None:
        self._audits = audits
        self._column = int(np.argmin(np.abs(TAU_GRID - tau)))
        self.allowed = allowed

    def __getitem__(self, name: str) -> float:
        if self.allowed is not None and not self.allowed(name):
            raise KeyError(name)
        return float(self._audits[name].jac[self._column])

    def __iter__(self) -> Iterator[str]:
        return iter(n for n in self._audits if self.allowed is None or self.allowed(n))

    def __len__(self) -> int:
        return sum(1 for _ in self)


@dataclass(frozen=True, eq=False, slots=True)
class _Outcome:
    """The audit of one frame with one source."""

    source: CameraSource
    frame: str
    audit: FrameAudit | None
    problem: str


def _audit(
    frame: str,
    read: ReadAnnotation,
    cameras: FrameCameras,
    setup: EvaluationSetup,
    tau: float,
    known: SourceFrame | None = None,
) -> tuple[FrameAudit | None, str]:
    """One frame under one source, and why its camera cannot be used."""
    shown = known if known is not None else find_camera(cameras, frame, setup)
    if shown.camera is None:
        return None, shown.error
    try:
        annotation = read()
    except InputError:  # reported when somebody opens this frame; the rest of the set goes on
        return None, ""
    if annotation is None:
        return None, ""
    setup = setup.of_frame(frame)
    projected = shown.projected or project_field(shown.camera, setup)
    measurement = measure_projected(annotation, projected, setup)
    fitted = FitCounts.of(shown.fitted_on, annotation, measurement)
    return audit_frame(frame, shown.camera, shown.model, measurement, tau, fitted=fitted), ""


_FORGOTTEN_ONE_BY_ONE = 400  # more are forgotten together with all others, which takes no time


class DatasetScoring(QObject):
    """Audits the frames of the dataset with every source, one source after the other, and again
    where dataset, frame, settings or cameras differ."""

    progressed = Signal(int, int)  # frames of all sources audited, of how many; (0, 0): finished

    def __init__(self, store: Store, scorer: FrameScorer, source_frames: SourceFrames) -> None:
        super().__init__(store)
        self._store, self._scorer, self._source_frames = store, scorer, source_frames
        self._set_work = LatestOnlyTask(self, self._fail)
        self._frame_work: dict[str, LatestOnlyTask] = {}
        self._touched: set[tuple[CameraSource, str]] = set()  # judged anew since the start
        self._unsignalled: dict[CameraSource, float] = {}  # since when
        self._edited = False  # the frame on screen, since it was judged
        self._refitted: dict[CameraSource, None] = {}  # to the frame on screen, since then
        self._soon = after_paint(self, self.settle)
        source_frames.set_setup(store.state.setup)

    @property
    def running(self) -> bool:
        """Return whether the set is being audited."""
        return self._set_work.running

    def cancel(self) -> None:
        """Stop scoring; what was found so far stays."""
        if self._set_work.stop_keep_partial():
            self._end()

    def forget(self, sources: Sequence[CameraSource]) -> None:
        """Drop all that is known of these sources, and what is under way: the settings changed."""
        self._stop()
        for source in sources:
            source.clear()
            self._notify(source)

    def follow(self, old: State, new: State) -> None:
        """The state is another one: what was looked up and audited under others is forgotten."""
        if new.setup is not old.setup:
            self._source_frames.set_setup(new.setup)
        if new.setup is not old.setup or new.workspace is not old.workspace:
            self.forget(new.sources)
        if not same(_looked_up(old), _looked_up(new)):
            self._look_up(new)
        if not same(_audited(old), _audited(new)):
            self._start(new)

    # --- what was edited ----------------------------------------------------------------------

    def frame_edited(self) -> None:
        """The annotation on screen is another one: once it was painted every source from files is
        judged anew against it; fits are once they are made."""
        self._edited = True
        self._soon.start()

    def fitted(self, source: CameraSource) -> None:
        """A source of fits has another camera for the frame on screen, or none any more: it is
        judged once that was painted."""
        self._refitted[source] = None
        self._soon.start()

    @property
    def frame_scores(self) -> FrameScores:
        """Frame name -> JaC at the threshold, of frames scored so far (while blind: committed
        ones)."""
        state = self._store.state
        return FrameScores(self.active_audits, state.tau, state.reveals if state.blind else None)

    @property
    def active_audits(self) -> Mapping[str, FrameAudit]:
        """Frame name -> audit of the active source, also where blind mode hides it."""
        active = self._store.state.active
        return {} if active is None else active.audits

    @property
    def waiting(self) -> bool:
        """Return whether something of the frame on screen is not judged anew yet."""
        return self._soon.isActive()

    def settle(self) -> None:
        """Do now what waits for the paint: it came, or the frame on screen is left."""
        self._soon.stop()
        edited, self._edited = self._edited, False
        refitted, self._refitted = self._refitted, {}
        if edited:
            self._judge_files()
        for source in refitted:
            self._judge_fit(source)

    def close(self) -> None:
        """Audit nothing any more."""
        self._soon.stop()
        self._stop()

    def frames_edited(self, names: Collection[str]) -> None:
        """Annotations of frames that are not on screen are others now: audit these anew."""
        self.cancel()  # what it found there is of the annotations before
        sources = self._store.state.sources
        if len(names) > _FORGOTTEN_ONE_BY_ONE:
            self.forget(sources)
        else:
            for source in sources:
                source.forget(names)
        self._start(self._store.state)
        for source in sources:
            self._store.events.sourceAuditsChanged.emit(source)
        self._store.events.frameScoresChanged.emit("")

    # --- inside -------------------------------------------------------------------------------

    def _judge_files(self) -> None:
        state = self._store.state
        name, active = state.frame_name, state.active
        if name is None:
            return
        if active is not None and active.files is not None:
            measured = self._measured if state.counts else None
            shown = self._scorer.shown
            fitted = FitCounts.of(shown.fitted_on, state.annotation, measured)
            self._put(active, name, shown, measured, state.tau, fitted)
        others = [
            (s, self._source_frames.of(s))
            for s in state.sources
            if s.files is not None and s is not active
        ]
        now = state.annotation if state.counts else None
        self._audit_again(name, now, others, state.setup, state.tau)

    def _judge_fit(self, source: CameraSource) -> None:
        state = self._store.state
        name, cameras = state.frame_name, state.cameras_of(source)
        if name is None or cameras is None:
            return
        shown = self._source_frames.look_up(cameras, name, state.setup)
        measurement = None
        if shown.projected is not None and state.annotation.annotated:
            if source is state.active:
                measurement = self._measured
            else:
                terms = self._scorer.frame_setup
                measurement = measure_projected(state.annotation, shown.projected, terms)
        self._put(source, name, shown, measurement, state.tau)
        self._source_frames.changed.emit()

    @property
    def _measured(self) -> Measurement | None:
        """The measurement of the annotation without a gesture in progress."""
        state, projected = self._store.state, self._scorer.shown.projected
        if projected is None or state.preview is None:
            return self._scorer.judged[0]
        return measure_projected(state.annotation, projected, self._scorer.frame_setup)

    def _look_up(self, state: State) -> None:
        frames = state.workspace.frames if state.workspace is not None else ()
        around = (state.frame_index + 1, state.frame_index - 1)
        beside = [frames[i].name for i in around if 0 <= i < len(frames)]
        name = state.frame_name
        self._source_frames.show(state.sources, name, beside if name is not None else ())

    def _start(self, state: State) -> None:
        """Audit what is not audited yet in the background, the active source first."""
        workspace = state.workspace
        if workspace is None:
            self.cancel()
            return
        readers: dict[str, Callable[[], FrameAnnotation | None]] = {
            frame.name: partial(workspace.annotation_to_score, i)
            for i, frame in enumerate(workspace.frames)
        }
        ordered = sorted(state.sources, key=lambda source: source is not state.active)
        setup, tau = state.setup, state.tau
        self.cancel()
        self._touched.clear()
        wanted = [(source, source.camera_set, source.to_look_at(readers)) for source in ordered]
        total = sum(len(names) for _, _, names in wanted)
        if not total:
            return

        def work(control: JobControl) -> None:
            done, reported = 0, monotonic()
            for source, cameras, names in wanted:
                for name in names:
                    if control.cancelled:
                        return
                    audit, problem = _audit(name, readers[name], cameras, setup, tau)
                    control.emit_partial(_Outcome(source, name, audit, problem))
                    done += 1
                    if monotonic() - reported > _PROGRESS_S:
                        control.progress(done, total)
                        reported = monotonic()

        self._set_work.start(
            work, lambda _: self._end(), progress=self._progressed, partial=self._take
        )

    def _put(
        self, source: CameraSource, frame: str, shown: SourceFrame, measurement: Measurement | None,
        tau: float, fitted: FitCounts = NOT_FITTED,
    ) -> None:  # fmt: skip
        """Take over how a source does in the frame on screen after an edit; ``fitted``: whether its
        camera was fitted to these very clicks."""
        self._touched.add((source, frame))
        known, problem = frame in source.audits, source.problems.get(frame, "")
        audit = None
        if measurement is not None and shown.camera is not None:
            audit = audit_frame(frame, shown.camera, shown.model, measurement, tau, fitted=fitted)
        source.take(frame, audit, shown.error)
        if known or audit is not None or shown.error != problem:
            self._notify(source, frame)

    def _audit_again(
        self,
        frame: str,
        annotation: FrameAnnotation | None,
        shown: Sequence[tuple[CameraSource, SourceFrame | None]],
        setup: EvaluationSetup,
        tau: float,
    ) -> None:
        """Audit one frame after an edit with some sources, in the background. Without an annotation
        it belongs to no figure of the set; what the sources show of it is given as far as known."""
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
                self._notify(outcome.source, frame)

        failed = partial(say, self._store, level="error")
        self._frame_work[frame] = LatestOnlyTask(self, failed, priority=Priority.URGENT)
        self._frame_work[frame].start(work, done)

    def _stop(self) -> None:
        self.cancel()
        for work in self._frame_work.values():
            work.cancel()
        self._frame_work.clear()

    def _progressed(self, done: int, total: int) -> None:
        now = monotonic()
        if any(now - since > _SIGNAL_S for since in self._unsignalled.values()):
            self._signal_changes()
        self.progressed.emit(done, total)

    def _take(self, outcomes: list[_Outcome]) -> None:
        now = monotonic()
        for outcome in outcomes:
            if (outcome.source, outcome.frame) not in self._touched:
                outcome.source.take(outcome.frame, outcome.audit, outcome.problem)
                self._unsignalled.setdefault(outcome.source, now)

    def _signal_changes(self) -> None:
        unsignalled, self._unsignalled = self._unsignalled, {}
        for source in unsignalled:
            self._notify(source)

    def _notify(self, source: CameraSource, frame: str = "") -> None:
        """Signal other scores of a source in a frame, or in many ("")."""
        if source in self._store.state.sources:
            self._store.events.sourceAuditsChanged.emit(source)
        if source is self._store.state.active:
            self._store.events.frameScoresChanged.emit(frame)

    def _end(self) -> None:
        self._signal_changes()
        self.progressed.emit(0, 0)

    def _fail(self, text: str) -> None:
        self._end()
        say(self._store, text, "error")


def _looked_up(state: State) -> tuple[object, ...]:
    cameras = tuple(look.cameras for look in state.looks)
    return state.workspace, state.frame_index, state.setup, cameras


def _audited(state: State) -> tuple[object, ...]:
    from_files = tuple(k.cameras for k in state.looks if k.source.files is not None)
    return state.workspace, state.setup, state.sources, from_files
