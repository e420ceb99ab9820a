"""The contents of the timeline: its axis, the band of cameras, anchors and statuses by frame."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.tracking.track import TrackedFrame
from procc_annotator.dataset.computed_cameras import most_residual_px, review_reason
from procc_annotator.dataset.records import FrameRecord, Status
from procc_annotator.dataset.sequence import FrameSequence
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import after_paint
from procc_annotator.gui.state.services import Services
from procc_annotator.interaction import palette as tones

_FEWEST = 20.0  # frames across the strip, fully zoomed in


@dataclass(frozen=True, slots=True)
class Axis:
    """Frame numbers along a width.

    A frame takes the room from its number to the next one.

    Attributes:
        width: px.
        begin, end: numbers at both ends of the width, the end beyond its frame.
    """

    first: int
    last: int
    width: float
    begin: float
    end: float

    @classmethod
    def whole(cls, first: int, last: int, width: float) -> Axis:
        """All frames."""
        return cls(first, last, width, float(first), float(last + 1))

    @property
    def per_frame(self) -> float:
        """Px that a frame takes."""
        return self.width / (self.end - self.begin)

    @property
    def is_whole(self) -> bool:
        """Return whether all frames are in sight."""
        return self.end - self.begin >= self.last + 1 - self.first

    def x_of(self, number: float) -> float:
        """Return where a frame begins, px."""
        return (number - self.begin) * self.per_frame

    def middle_of(self, number: float) -> float:
        """The middle of a frame, px."""
        return self.x_of(number + 0.5)

    def number_at(self, x: float) -> int:
        """The frame at a place, px; the nearest one next to the strip."""
        number = int((x / self.per_frame) + self.begin)
        return min(max(number, self.first), self.last)

    def with_width(self, width: float) -> Axis:
        """The same frames along another width."""
        return replace(self, width=max(1.0, width))

    def zoomed(self, times: float, x: float) -> Axis:
        """Return the axis zoomed by a factor around the frame at ``x``."""
        span = min(max((self.end - self.begin) / times, _FEWEST), self.last + 1.0 - self.first)
        at = self.begin + x / self.per_frame
        return self._from(at - x / self.width * span, span)

    def scrolled(self, frames: float) -> Axis:
        """Moved along by some frames."""
        return self._from(self.begin + frames, self.end - self.begin)

    def showing(self, number: int) -> Axis:
        """Moved along, if need be, to have a frame in sight, with some room around it."""
        span = self.end - self.begin
        room = 0.1 * span
        if self.begin + room <= number <= self.end - room:
            return self
        return self._from(number + 0.5 - span / 2, span)

    def _from(self, begin: float, span: float) -> Axis:
        begin = min(max(begin, float(self.first)), self.last + 1.0 - span)
        begin = max(begin, float(self.first))
        return replace(self, begin=begin, end=begin + span)


Pixels = NDArray[np.uint32]

_LOST_HEIGHT = 0.12
_LEAST_HEIGHT = 0.25  # of a frame that has a camera
_DOT = 2  # px of the screen


@dataclass(frozen=True, eq=False)
class Band:
    """State of the frames of a sequence, by number from the first.

    Attributes:
        coverage: (n,) share of the lines on paint, 0 to 1; 0 for a lost frame, NaN where no one
            looked.
        distance: (n,) of the paint from the lines as a share of what is still sure, 0 to 1.
        doubtful: (n,) whether a person should look.
        lost: (n,) whether there is no camera.
    """

    coverage: FloatArray
    distance: FloatArray
    doubtful: NDArray[np.bool_]
    lost: NDArray[np.bool_]

    @classmethod
    def unknown(cls, count: int) -> Band:
        """No one examined any frame."""
        off = np.zeros(count, dtype=bool)
        return cls(np.full(count, np.nan), np.zeros(count), off, off.copy())


def band_pixels(band: Band, axis: Axis, size: tuple[int, int]) -> Pixels:
    """The band of the whole sequence as (height, width) 0xAARRGGBB, transparent where nothing is
    known. The frames of the axis, in whatever px, are spread over the width, screen px."""
    width, height = size
    edges = axis.begin + (axis.end - axis.begin) * np.arange(width + 1) / width
    begin = np.clip(np.floor(edges[:-1]).astype(np.intp) - axis.first, 0, len(band.lost) - 1)
    past = np.clip(np.ceil(edges[1:]).astype(np.intp) - axis.first, begin + 1, len(band.lost))
    known = ~np.isnan(band.coverage)
    coverage = _least(np.where(known, band.coverage, np.inf), begin, past)
    doubtful = -_least(-(band.doubtful & known).astype(np.float64), begin, past) > 0
    lost = -_least(-(band.lost & known).astype(np.float64), begin, past) > 0
    distance = -_least(-np.where(known, band.distance, 0.0), begin, past)
    tops = np.where(lost, _LOST_HEIGHT, np.maximum(coverage, _LEAST_HEIGHT))
    rows = np.where(np.isfinite(coverage), np.ceil(np.minimum(tops, 1.0) * height), 0)
    filled = np.arange(height)[::-1, None] < rows[None, :]
    dots = (np.arange(height)[:, None] // _DOT + np.arange(width)[None, :] // _DOT) % 2 == 0
    filled &= ~(doubtful & ~lost)[None, :] | dots
    return np.where(filled, _colours(distance, doubtful, lost)[None, :], np.uint32(0))


def _least(values: FloatArray, begin: NDArray[np.intp], past: NDArray[np.intp]) -> FloatArray:
    """(width,) the least of the values from each begin to before each end."""
    pairs = np.column_stack((begin, past)).ravel()
    padded = np.append(values, np.inf)  # an end may be that of all
    return np.asarray(np.minimum.reduceat(padded, pairs)[::2])


def _colours(
    distance: FloatArray, doubtful: NDArray[np.bool_], lost: NDArray[np.bool_]
) -> NDArray[np.uint32]:
    good, far, gone = (_rgb(tone) for tone in (tones.PASSES, tones.NOT_ANNOTATED, tones.TOO_FAR))
    share = np.clip(distance, 0.0, 1.0)[:, None] * 0.7
    mixed = good * (1 - share) + far * share
    mixed = np.where(doubtful[:, None], far, mixed)
    red, green, blue = np.where(lost[:, None], gone, mixed).round().astype(np.uint32).T
    packed = (red << 16) | (green << 8) | blue
    return np.asarray(packed | np.uint32(0xFF000000), dtype=np.uint32)


def _rgb(tone: str) -> FloatArray:
    return np.array([int(tone[i : i + 2], 16) for i in (1, 3, 5)], dtype=np.float64)


_AT_ONCE = 400  # frames that are taken down in one go


class StripContent(QObject):
    """Frames by number, marks by number.

    Attributes:
        sequence: the frames; None while nothing is open that has an order in time.
        band: what is known of each frame's camera.
        anchors: (n,) numbers of annotated frames, ascending.
        dragged: those of frames with a camera that a person dragged, ascending.
        statuses: number -> status, of the frames that were touched.
    """

    changed = Signal()

    def __init__(self, services: Services, parent: QObject) -> None:
        super().__init__(parent)
        self._services = services
        self.sequence: FrameSequence | None = None
        self.band = Band.unknown(0)
        self._drawn: dict[int, TrackedFrame] = {}  # what the band shows, by number
        self.anchors: tuple[int, ...] = ()
        self.dragged: tuple[int, ...] = ()
        self.statuses: dict[int, Status] = {}
        self._pending: dict[int, TrackedFrame] = {}  # to be taken down
        self._go_on = after_paint(self, self._take_down)
        services.sequence.changed.connect(self._begin_anew)
        services.store.watch(select.dataset, self._begin_anew)
        services.shot_track.followed.connect(self._take_followed)
        services.shot_track.changed.connect(self._take_track)
        services.annotated_frames.changed.connect(self._take_anchors)
        services.corrections.changed.connect(self._take_dragged)
        services.review.statusChanged.connect(self._take_statuses)

    @property
    def hidden(self) -> bool:
        """Return whether nothing of a camera may be shown."""
        return self._services.state.blind

    @property
    def cuts(self) -> tuple[int, ...]:
        """The first frame of each shot but the first, as far as the shots are known."""
        return self._services.shot_track.cuts

    def _begin_anew(self) -> None:
        sequence = self._services.sequence.value
        if sequence is self.sequence:
            return
        self.sequence = sequence
        self._services.annotated_frames.set_wanted(sequence is not None)
        self.band, self._drawn = Band.unknown(0 if sequence is None else sequence.count), {}
        self._take_track()
        self._take_anchors()
        self._take_dragged()
        self._take_statuses()
        self.changed.emit()

    def _take_track(self) -> None:
        """Other frames than before may be known; most of them are those of before."""
        if (sequence := self.sequence) is None:
            return
        tracked, drawn = self._services.shot_track.tracked, self._drawn
        self._pending.clear()
        for number in drawn.keys() - tracked.keys():
            self.band.coverage[number - sequence.first] = math.nan
            del drawn[number]
        self._take_followed([f for n, f in tracked.items() if drawn.get(n) is not f])

    def _take_followed(self, frames: Iterable[TrackedFrame]) -> None:
        if self.sequence is not None:
            self._pending |= {frame.number: frame for frame in frames}
            self._take_down()

    def _take_down(self) -> None:
        """Store the state of some frames; more of them when the event loop has turned."""
        sequence = self.sequence
        if sequence is None:
            return
        for number in list(islice(self._pending, _AT_ONCE)):
            frame = self._pending.pop(number)
            if sequence.first <= number <= sequence.last:
                _put(self.band, number - sequence.first, frame)
                self._drawn[number] = frame
        if self._pending:
            self._go_on.start()
        self.changed.emit()

    def _take_anchors(self) -> None:
        if (sequence := self.sequence) is not None:
            numbers = sequence.numbers.tolist()
            annotated = sorted(self._services.annotated_frames.indices)
            self.anchors = tuple(numbers[i] for i in annotated if i < len(numbers))
            self.changed.emit()

    def _take_dragged(self, _: str = "") -> None:
        sequence, workspace = self.sequence, self._services.state.workspace
        if sequence is not None and workspace is not None:
            index, numbers = workspace.index, sequence.numbers
            names = self._services.state.corrected.keys() & index.keys()
            self.dragged = tuple(sorted(int(numbers[index[name]]) for name in names))
            self.changed.emit()

    def _take_statuses(self, frame: str = "") -> None:
        sequence, workspace = self.sequence, self._services.state.workspace
        database = self._services.review.database
        if sequence is None or workspace is None or database is None:
            return
        index, numbers = workspace.index, sequence.numbers
        if frame:
            records: Mapping[str, FrameRecord] = {frame: database.record(frame)}
        else:
            self.statuses, records = {}, database.records()
        for name, record in records.items():
            if name in index:
                self.statuses[int(numbers[index[name]])] = record.status
        self.changed.emit()


def _put(band: Band, at: int, frame: TrackedFrame) -> None:
    """Take down what is known of one more frame, in place."""
    fit = frame.fit if frame.fit is not None and frame.fit.camera is not None else None
    band.coverage[at] = 0.0 if fit is None else min(max(frame.coverage, 0.0), 1.0)
    far = 0.0 if fit is None or frame.residual_px is None else frame.residual_px
    band.distance[at] = (
        0.0 if fit is None else min(1.0, far / most_residual_px(fit.size[0] * fit.pixel_aspect))
    )
    band.doubtful[at] = bool(review_reason(frame))
    band.lost[at] = fit is None
