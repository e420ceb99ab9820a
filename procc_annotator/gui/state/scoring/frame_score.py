"""Cameras of the frame on screen, by source, and their score against the clicks."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import CameraOrProjections
from procc_annotator.dataset.camera_set import FrameCameras
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.loaded_camera import NAME_THE_FORMAT, field_mismatch
from procc_annotator.gui.state.background import ComputedValue, Inputs
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.state import same
from procc_annotator.gui.state.store import Store
from procc_annotator.metrics.measurement import Measurement, measure_projected
from procc_annotator.metrics.projection import (
    ProjectedField,
    project_field,
    projections_error,
)
from procc_annotator.metrics.score import FrameScore, display_score
from procc_annotator.metrics.setup import EvaluationSetup


@dataclass(frozen=True, eq=False)
class SourceFrame:
    """A source's camera for one frame, or why there is none.

    Attributes:
        camera: px of the evaluation size; None if there is none to be used.
        projected: what the camera shows of the field.
        notice: what to know about it (scaled from another size, missing).
        error: why it cannot be used.
        fitted_on: what it was fitted to, see `LoadedCamera`.
    """

    camera: CameraOrProjections | None = None
    model: str = ""
    projected: ProjectedField | None = None
    notice: str = ""
    error: str = ""
    fitted_on: str | None = None


NO_CAMERA = SourceFrame()


def find_camera(camera_set: FrameCameras, frame: str, setup: EvaluationSetup) -> SourceFrame:
    """Read a frame's camera; safe from any thread."""
    try:
        found = camera_set.camera(frame, setup.size)
    except CameraError as error:
        return SourceFrame(error=str(error))
    if found is None:
        return SourceFrame(notice=camera_set.why_none(frame))
    if problem := field_mismatch(found.assumed_field, setup.field):
        return SourceFrame(error=f"{frame}: {problem} ({NAME_THE_FORMAT})")
    if problem := projections_error(found.camera, setup.of_frame(frame)):
        return SourceFrame(error=f"{frame}: {problem}")
    return SourceFrame(
        found.camera, found.model, notice=found.notice or "", fitted_on=found.fitted_on
    )


def look_up(camera_set: FrameCameras, frame: str, setup: EvaluationSetup) -> SourceFrame:
    """Read a frame's camera and project the field with it; safe from any thread."""
    found = find_camera(camera_set, frame, setup)
    if found.camera is None:
        return found
    return replace(found, projected=project_field(found.camera, setup.of_frame(frame)))


_Key = tuple[FrameCameras, str]

_FEWEST = 16  # frames of sources that are kept


class SourceFrames(QObject):
    """Keeps what the sources show of the frame on screen and of those next to it.

    Stepping through the frames and switching the active source then read and project nothing.
    """

    changed = Signal()  # more is known of the frame on screen

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._known: OrderedDict[_Key, SourceFrame] = OrderedDict()
        self._kept = _FEWEST
        self._setup: EvaluationSetup | None = None
        self._frame: str | None = None
        self._wanted: tuple[_Key, ...] = ()  # of the frame on screen first
        self._complete = True
        self._next = ComputedValue(self._to_look_up, look_up, self)
        self._next.changed.connect(self._take)

    def of(self, source: CameraSource | None) -> SourceFrame | None:
        """Return what a source shows of the frame on screen; None while that is not known."""
        if source is None or self._frame is None:
            return None
        return self.peek(source.camera_set, self._frame)

    def peek(self, camera_set: FrameCameras, frame: str) -> SourceFrame | None:
        """Return what is known of a frame already."""
        found = self._known.get((camera_set, frame))
        if found is not None:
            self._known.move_to_end((camera_set, frame))
        return found

    def look_up(self, camera_set: FrameCameras, frame: str, setup: EvaluationSetup) -> SourceFrame:
        """Return what a source shows of a frame, read now if it is not known."""
        self.set_setup(setup)
        found = self.peek(camera_set, frame)
        if found is None:
            found = look_up(camera_set, frame, setup)
            self.put(camera_set, frame, found)
        return found

    def put(self, camera_set: FrameCameras, frame: str, shown: SourceFrame) -> None:
        """Keep what was looked up elsewhere."""
        self._known[camera_set, frame] = shown
        while len(self._known) > self._kept:
            self._known.popitem(last=False)

    def set_setup(self, setup: EvaluationSetup) -> None:
        """Size and protocol decide what is shown."""
        if setup != self._setup:
            self._setup = setup
            self._known.clear()

    def show(
        self, sources: Sequence[CameraSource], frame: str | None, beside: Iterable[str] = ()
    ) -> None:
        """Another frame is on screen, or there are other sources; frames ``beside`` are likely to
        be on screen next, and looked up afterwards."""
        self._frame = frame
        self._kept = max(_FEWEST, 4 * len(sources))
        while len(self._known) > self._kept:
            self._known.popitem(last=False)
        names = () if frame is None else (frame, *beside)
        self._wanted = tuple((source.camera_set, name) for name in names for source in sources)
        self._complete = self._is_complete()
        self._next.invalidate()

    def _missing(self) -> _Key | None:
        return next((key for key in self._wanted if self.peek(*key) is None), None)

    def _to_look_up(self) -> Inputs | None:
        return None if (key := self._missing()) is None else (*key, self._setup)

    def _take(self) -> None:
        """Keep what was found, and go on with what is missing, which others may look up, too."""
        key, shown = self._missing(), self._next.value
        if key is not None and shown is not None:
            self.put(*key, shown)
        self._next.invalidate()
        if not self._complete and self._is_complete():
            self._complete = True
            self.changed.emit()

    def _is_complete(self) -> bool:
        key = self._missing()
        return key is None or key[1] != self._frame


class FrameScorer:
    """Measures the annotation on screen against the active camera when a person asks, and again
    only if need be."""

    def __init__(self, store: Store, source_frames: SourceFrames) -> None:
        self._store = store
        self._source_frames = source_frames
        self._of_frame: tuple[EvaluationSetup, str | None, EvaluationSetup] | None = None
        self._opinion, self._other_opinion = CachedScore(), CachedScore()

    @property
    def tau(self) -> float:
        """The threshold in px of the evaluation size."""
        return self._store.state.tau

    @property
    def frame_setup(self) -> EvaluationSetup:
        """The terms in the frame on screen; the same object as long as they stay."""
        setup, frame = self._store.state.setup, self._store.state.frame_name
        known = self._of_frame
        if known is None or known[0] is not setup or known[1] != frame:
            own = setup if frame is None else setup.of_frame(frame)
            known = self._of_frame = (setup, frame, own)
        return known[2]

    @property
    def shown(self) -> SourceFrame:
        """The active camera in the frame on screen."""
        state = self._store.state
        frame, cameras = state.frame_name, state.cameras_of(state.active)
        if frame is None or cameras is None:
            return NO_CAMERA
        return self._source_frames.look_up(cameras, frame, state.setup)

    @property
    def judged(self) -> tuple[Measurement | None, FrameScore | None]:
        """Distances of the shown annotation and its score, also while blind mode hides them."""
        return self._opinion.of(self.shown, self._store.state.shown_annotation, self)

    @property
    def camera(self) -> CameraOrProjections | None:
        """In px of the evaluation size; None while blind mode hides it."""
        return self.shown.camera if self._store.state.projection_visible else None

    @property
    def measurement(self) -> Measurement | None:
        """Distances of the shown annotation; None without a camera and while blind."""
        return self.judged[0] if self._store.state.projection_visible else None

    @property
    def score(self) -> FrameScore | None:
        """The score at the threshold; None without a camera and while blind."""
        return self.judged[1] if self._store.state.projection_visible else None

    @property
    def compared(self) -> tuple[Measurement | None, FrameScore | None]:
        """Measurement and score of the shown annotation against the compared source; None without
        its camera and while blind."""
        state = self._store.state
        if not state.projection_visible:
            return None, None
        shown = self._source_frames.of(state.compared)
        return self._other_opinion.of(shown, state.shown_annotation, self)


class CachedScore:
    """The measurement and score of a camera, computed at access."""

    def __init__(self) -> None:
        self._asked: tuple[object, ...] = ()
        self._measurement: Measurement | None = None
        self._score: FrameScore | None = None

    def of(
        self, shown: SourceFrame | None, annotation: FrameAnnotation, terms: FrameScorer
    ) -> tuple[Measurement | None, FrameScore | None]:
        """Measurement and score under the terms of the judge; measured again only if need be."""
        projected = shown.projected if shown is not None else None
        if projected is None:
            return None, None
        asked = projected, annotation, terms.frame_setup
        if not same(asked, self._asked):
            self._asked, self._score = asked, None
            self._measurement = measure_projected(annotation, projected, terms.frame_setup)
        assert self._measurement is not None
        if self._score is None or self._score.threshold != terms.tau:
            self._score = display_score(self._measurement, terms.tau)
        return self._measurement, self._score
