"""Keeps in step with the state what is looked up of the frame and audited of the set."""

from __future__ import annotations

from collections.abc import Callable, Collection
from functools import partial

from PySide6.QtCore import QObject

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.formats.cameras.fit_record import FitCounts
from procc_annotator.gui.soon import soon
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.judge import Judge
from procc_annotator.gui.state.saying import say
from procc_annotator.gui.state.set_scores import SetScores
from procc_annotator.gui.state.signals import Signals
from procc_annotator.gui.state.source_frames import SourceFrames
from procc_annotator.gui.state.state import State, same
from procc_annotator.gui.state.store import Store
from procc_annotator.metrics.measurement import Measurement, measure_projected

_FORGOTTEN_ONE_BY_ONE = 400  # more are forgotten together with all others, which takes no time


class Auditing(QObject):
    """Has the sources looked up and audited again where dataset, frame, terms or cameras differ."""

    def __init__(
        self,
        store: Store,
        signals: Signals,
        judge: Judge,
        source_frames: SourceFrames,
        set_scores: SetScores,
    ) -> None:
        super().__init__(store)
        self._store, self._signals, self._judge = store, signals, judge
        self._source_frames, self._set_scores = source_frames, set_scores
        self._edited = False  # the frame on screen, since it was judged
        self._refitted: dict[CameraSource, None] = {}  # to the frame on screen, since then
        self._soon = soon(self, self.settle)
        source_frames.set_setup(store.state.setup)
        set_scores.changed.connect(self._tell)
        set_scores.failed.connect(self._say_failed)

    def follow(self, old: State, new: State) -> None:
        """The state is another one: what was looked up and audited under others is forgotten."""
        if new.setup is not old.setup:
            self._source_frames.set_setup(new.setup)
        if new.setup is not old.setup or new.workspace is not old.workspace:
            self._set_scores.forget(new.sources)
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
    def waiting(self) -> bool:
        """Return whether something of the frame on screen is not judged anew yet."""
        return self._soon.isActive()

    def settle(self) -> None:
        """What waits for the paint is done now: it came, or the frame on screen is left."""
        self._soon.stop()
        edited, self._edited = self._edited, False
        refitted, self._refitted = self._refitted, {}
        if edited:
            self._judge_files()
        for source in refitted:
            self._judge_fit(source)

    def close(self) -> None:
        """Look up and audit nothing any more."""
        self._soon.stop()
        self._set_scores.close()
        self._source_frames.close()

    def frames_edited(self, names: Collection[str]) -> None:
        """Annotations of frames that are not on screen are others now: audit these anew."""
        self._set_scores.cancel()  # what it found there is of the annotations before
        sources = self._store.state.sources
        if len(names) > _FORGOTTEN_ONE_BY_ONE:
            self._set_scores.forget(sources)
        else:
            for source in sources:
                source.forget(names)
        self._start(self._store.state)
        for source in sources:
            self._signals.sourceAuditsChanged.emit(source)
        self._signals.frameScoresChanged.emit("")

    # --- inside -------------------------------------------------------------------------------

    def _judge_files(self) -> None:
        state = self._store.state
        name, active = state.frame_name, state.active
        if name is None:
            return
        if active is not None and active.files is not None:
            measured = self._measured if state.counts else None
            shown = self._judge.shown
            fitted = FitCounts.of(shown.fitted_on, state.annotation)
            self._set_scores.put(active, name, shown, measured, state.tau, fitted)
        others = [
            (s, self._source_frames.of(s))
            for s in state.sources
            if s.files is not None and s is not active
        ]
        now = state.annotation if state.counts else None
        self._set_scores.audit_again(name, now, others, state.setup, state.tau)

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
                terms = self._judge.frame_setup
                measurement = measure_projected(state.annotation, shown.projected, terms)
        self._set_scores.put(source, name, shown, measurement, state.tau)
        self._source_frames.changed.emit()

    @property
    def _measured(self) -> Measurement | None:
        """Of the finished annotation, whatever gesture is under way."""
        state, projected = self._store.state, self._judge.shown.projected
        if projected is None or state.preview is None:
            return self._judge.judged[0]
        return measure_projected(state.annotation, projected, self._judge.frame_setup)

    def _look_up(self, state: State) -> None:
        """Have the frame on screen, and those next to it, looked up in every source."""
        frames = state.workspace.frames if state.workspace is not None else ()
        around = (state.frame_index + 1, state.frame_index - 1)
        beside = [frames[i].name for i in around if 0 <= i < len(frames)]
        name = state.frame_name
        self._source_frames.show(state.sources, name, beside if name is not None else ())

    def _start(self, state: State) -> None:
        """Audit what is not audited yet in the background, the active source first."""
        workspace = state.workspace
        if workspace is None:
            self._set_scores.cancel()
            return
        readers: dict[str, Callable[[], FrameAnnotation | None]] = {
            frame.name: partial(workspace.annotation_to_score, i)
            for i, frame in enumerate(workspace.frames)
        }
        ordered = sorted(state.sources, key=lambda source: source is not state.active)
        self._set_scores.start(ordered, readers, state.setup, state.tau)

    def _tell(self, source: CameraSource, frame: str) -> None:
        if source in self._store.state.sources:
            self._signals.sourceAuditsChanged.emit(source)
        if source is self._store.state.active:
            self._signals.frameScoresChanged.emit(frame)

    def _say_failed(self, text: str) -> None:
        say(self._store, text, "error")


def _looked_up(state: State) -> tuple[object, ...]:
    cameras = tuple(look.cameras for look in state.looks)
    return state.workspace, state.frame_index, state.setup, cameras


def _audited(state: State) -> tuple[object, ...]:
    from_files = tuple(k.cameras for k in state.looks if k.source.files is not None)
    return state.workspace, state.setup, state.sources, from_files
