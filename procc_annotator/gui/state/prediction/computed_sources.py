"""Camera sources computed here: the fits to the clicks, and the track of the sequence."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

from PySide6.QtCore import QObject, Signal

from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.tracking.track import Track, TrackedFrame
from procc_annotator.dataset.computed_cameras import FittedCameras, FittedFrame, TrackedCameras
from procc_annotator.dataset.sequence import FrameSequence
from procc_annotator.field.model import Element, Field
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import ComputedValue
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.scoring.commands import CameraSourceCommands
from procc_annotator.gui.state.scoring.frame_score import SourceFrames
from procc_annotator.gui.state.store import Store
from procc_annotator.interaction.palette import FIT, TRACK


class FitSource(QObject):
    """Keeps the source "fit" in step with the live fit.

    It joins the sources once the clicks of a frame have given a camera, and leaves them when the
    live fit is switched off or another dataset is opened. It holds the fits of the frames visited
    in this window, each for as long as its clicks are the same. While the clicks on screen are
    fitted anew, the fit before stays in the picture for that moment, so that nothing flickers.

    Attributes:
        source: as a row of the list.
        preferred: whether the user chose to judge the fit: then it is judged whenever there is no
            other source that is.
    """

    def __init__(
        self,
        store: Store,
        sources: CameraSourceCommands,
        source_frames: SourceFrames,
        live_fit: LiveFit,
    ) -> None:
        super().__init__(store)
        self._store, self._sources = store, sources
        self._source_frames, self._live_fit = source_frames, live_fit
        self.source = CameraSource(FittedCameras(), FIT, visible=False)
        self.preferred = False
        self._frame: str | None = None
        self._terms: tuple[object, ...] = ()
        self._seen = (False, store.state.active)  # whether it was listed, and what was judged
        live_fit.changed.connect(self.look)
        store.watch(select.dataset, self._begin_anew)
        store.watch(select.frame, self.look)
        store.watch(select.blind, self._hide)
        store.watch(select.cameras, self._note_choice)
        store.events.framesEdited.connect(self._drop_edited)

    @property
    def cameras(self) -> FittedCameras:
        """The fits known now."""
        found = self.source.camera_set
        assert isinstance(found, FittedCameras)
        return found

    @property
    def listed(self) -> bool:
        """Return whether the fit is among the sources."""
        return self.source in self._store.state.sources

    def look(self) -> None:
        """The fit, or the frame it is for, may be another one."""
        live_fit, state = self._live_fit, self._store.state
        if not live_fit.wanted:
            self._leave()
            return
        frame = state.frame
        if frame is None:
            return
        terms = live_fit.model, state.field
        if terms != self._terms:  # fits of several kinds would make no source
            self._terms = terms
            self._forget([name for name in self.cameras.fits if name != frame.name])
        if self._frame not in (None, frame.name):
            self._drop_outdated(self._frame)
        known = self.cameras.fits.get(frame.name)
        insight = live_fit.insight
        if insight is not None and insight.fit is not (known.fit if known else None):
            fitted = FittedFrame(insight.annotation, insight.fit)
            cameras = self.cameras.with_fit(frame.name, fitted)
            if (shown := live_fit.shown) is not None:
                self._source_frames.put(cameras, frame.name, shown)
            self._replace(cameras)
        elif insight is None and self._outlived(frame.name, known):
            self._replace(self.cameras.without([frame.name]))
        self._frame = frame.name

    # --- inside ---

    def _drop_outdated(self, left: str) -> None:
        """The frame was left before the clicks there were fitted anew."""
        workspace, known = self._store.state.workspace, self.cameras.fits.get(left)
        index = None if workspace is None else workspace.index.get(left)
        if workspace is None or index is None or known is None:
            return
        now = workspace.loaded_annotation(index)
        if now is not None and now.polylines != known.annotation.polylines:
            self._forget([left])
            self._sources.show_source_again(self.source)

    def _outlived(self, frame: str, known: FittedFrame | None) -> bool:
        """Return whether what is known of a frame must not be shown any more."""
        if known is None or known.annotation is self._store.state.annotation:
            return False
        came = self._frame != frame  # others may have edited it meanwhile
        return came or not self._live_fit.working

    def _replace(self, cameras: FittedCameras) -> None:
        self.source.camera_set = cameras
        if not self.listed and cameras.frames:
            self._join()
        self._sources.show_source_again(self.source)

    def _join(self) -> None:
        nothing_judged = self._store.state.active is None
        self._sources.join_source(self.source, active=self.preferred and nothing_judged)

    def _leave(self) -> None:
        self._forget(self.cameras.fits)
        self._sources.remove_source(self.source)

    def _forget(self, frames: Collection[str]) -> None:
        """Drop what is known of some frames, also how they scored."""
        frames = list(frames)
        self.source.camera_set = self.cameras.without(frames)
        self.source.forget(frames)

    def _begin_anew(self) -> None:
        self._leave()
        self._frame = None
        self.source.clear()

    def _drop_edited(self, indices: list[int]) -> None:
        """Frames that are not on screen were edited: their fits are of other clicks."""
        workspace = self._store.state.workspace
        if workspace is not None:
            here = self._store.state.frame_index
            self._forget([workspace.frames[i].name for i in indices if i != here])

    def _hide(self) -> None:
        """Blind mode: of frames that are not committed nothing may be known."""
        if self._store.state.blind:
            committed = self._store.state.committed
            self._forget([name for name in self.cameras.fits if name not in committed])
            self._sources.show_source_again(self.source)

    def _note_choice(self) -> None:
        """Remember whether the user chose the fit or another source."""
        was_listed, judged = self._seen
        self._seen = now_listed, active = self.listed, self._store.state.active
        if was_listed and now_listed and active is not judged:
            self.preferred = active is self.source


class ShotTrack(QObject):
    """Tracked cameras by number in the sequence; also a camera source, by frame name.

    Attributes:
        tracked: number -> the frame.
        cuts: the first frame of each shot that was met, but the first of the sequence.
        source: as a row of the list of sources, once a frame of the dataset has a camera.
    """

    changed = Signal()  # other frames are known, or none
    followed = Signal(object)  # these frames came while a shot is followed
    forgotten = Signal()  # nothing of what is under way is wanted either

    def __init__(
        self, store: Store, sequence: ComputedValue[FrameSequence], sources: CameraSourceCommands
    ) -> None:
        super().__init__(store)
        self._store, self._sequence, self._sources = store, sequence, sources
        self.tracked: dict[int, TrackedFrame] = {}
        self.cuts: tuple[int, ...] = ()
        self._shown: dict[int, TrackedFrame] = {}  # what the source shows
        self._cameras = TrackedCameras()
        self.source = CameraSource(self._cameras, TRACK, visible=False)
        self._elements = _own_elements(store.state.field)
        store.watch(select.dataset, self._begin_anew)
        store.watch(select.field, self._leave_other_field)

    @property
    def here(self) -> TrackedFrame | None:
        """Return what is known of the frame on screen."""
        number = self.number_here
        return None if number is None else self.tracked.get(number)

    @property
    def number_here(self) -> int | None:
        """The number of the frame on screen in the sequence."""
        sequence, index = self._sequence.value, self._store.state.frame_index
        if sequence is None or not 0 <= index < len(sequence.numbers):
            return None
        return int(sequence.numbers[index])

    @property
    def fit_here(self) -> FitResult | None:
        """The camera of the frame on screen, as a fit; None without one."""
        frame = self.here
        fit = frame.fit if frame is not None else None
        return fit if fit is not None and fit.camera is not None else None

    def put(self, frames: Iterable[TrackedFrame]) -> None:
        """Frames were followed; more are to come."""
        frames = tuple(frames)
        self.tracked |= {frame.number: frame for frame in frames}
        self.followed.emit(frames)

    def correct(self, frame: TrackedFrame) -> None:
        """One frame is known otherwise."""
        self.tracked[frame.number] = frame
        self._show([frame.number])
        self.changed.emit()

    def replace(self, frames: Mapping[int, TrackedFrame], cuts: Iterable[int]) -> None:
        """This is all that is known from now on."""
        self.tracked, self.cuts = dict(frames), tuple(sorted(cuts))
        shown = self._shown
        other = [n for n, frame in self.tracked.items() if shown.get(n) is not frame]
        self._show([*other, *(shown.keys() - self.tracked.keys())])
        self.changed.emit()

    def take(self, track: Track, *, is_shot: bool = False) -> None:
        """Frames were followed to their end, which is that of the shot if ``is_shot``: what was
        known of them before goes."""
        if not track.frames:
            return
        first, last = track.frames[0].number, track.frames[-1].number
        cuts = {cut for cut in self.cuts if not first < cut <= last}
        cuts |= {begin for begin, _ in track.shots[1:]}
        sequence = self._sequence.value
        if is_shot and sequence is not None:
            cuts |= {end for end in (first, last + 1) if sequence.first < end <= sequence.last}
        others = {n: frame for n, frame in self.tracked.items() if not first <= n <= last}
        self.replace(others | {frame.number: frame for frame in track.frames}, cuts)

    def between_anchors(self, number: int) -> range | None:
        """The frames around one from the anchor before it to the one after it, or to where the
        shot ends; None where it was not followed."""
        if number not in self.tracked:
            return None
        ends = []
        for step in (-1, 1):
            at = number
            while at + step in self.tracked and max(at, at + step) not in self.cuts:
                at += step
                if self.tracked[at].state == "anchor":
                    break
            ends.append(at)
        return range(ends[0], ends[1] + 1)

    def shot_of(self, number: int) -> range:
        """The frames of the sequence around one, up to the cuts that are known."""
        sequence = self._sequence.value
        first = sequence.first if sequence is not None else number
        past = sequence.last + 1 if sequence is not None else number + 1
        first = max((cut for cut in self.cuts if cut <= number), default=first)
        return range(first, min((cut for cut in self.cuts if cut > number), default=past))

    def forget(self) -> None:
        """Nothing is known any more."""
        self.forgotten.emit()
        self.replace({}, ())

    # --- inside ---

    def _begin_anew(self) -> None:
        self._sources.remove_source(self.source)
        self.source.clear()
        self.forget()

    def _leave_other_field(self) -> None:
        """Cameras were found on the paint of another field, unless only landmarks differ."""
        before, self._elements = self._elements, _own_elements(self._store.state.field)
        if self._elements != before:
            self.forget()

    def _show(self, numbers: Collection[int]) -> None:
        """The source holds the cameras of the dataset's frames; of these they are others now."""
        sequence, workspace = self._sequence.value, self._store.state.workspace
        self._shown = dict(self.tracked)
        by_name: dict[str, TrackedFrame | None] = {}
        if sequence is not None and workspace is not None:
            index_of, frames, tracked = sequence.index_of, workspace.frames, self.tracked
            by_name = {frames[index_of[n]].name: tracked.get(n) for n in numbers if n in index_of}
        cameras = self._cameras.updated(by_name) if self.tracked else TrackedCameras()
        self.source.forget(by_name)
        self.source.camera_set = self._cameras = cameras
        if self.source not in self._store.state.sources:
            if cameras.frames:
                self._sources.join_source(self.source, active=False)
        elif cameras.frames:
            self._sources.show_source_again(self.source)
        else:
            self._sources.remove_source(self.source)


def _own_elements(field: Field) -> tuple[Element, ...]:
    """Return what of a field is painted, whatever landmarks its dataset has."""
    landmarks = {mark.name for mark in field.landmarks}
    return tuple(element for element in field.elements if element.name not in landmarks)
