"""What a strip shows of the open sequence, kept up as frames are followed, annotated, reviewed."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from itertools import islice

from PySide6.QtCore import QObject, Signal

from procc_annotator.calibration.tracking.track import TrackedFrame
from procc_annotator.dataset.computed_cameras import most_residual_px, review_reason
from procc_annotator.dataset.records import FrameRecord, Status
from procc_annotator.dataset.sequence import FrameSequence
from procc_annotator.gui.panels.timeline.band import Band
from procc_annotator.gui.soon import soon
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document

_AT_ONCE = 400  # frames that are taken down in one go


class StripContent(QObject):
    """Frames by number, marks by number.

    Attributes:
        sequence: the frames; None while nothing is open that has an order in time.
        band: what is known of each frame's camera.
        anchors: (n,) numbers of annotated frames, ascending.
        dragged: those of frames whose camera a person dragged, ascending.
        statuses: number -> status, of the frames that were touched.
    """

    changed = Signal()

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self.sequence: FrameSequence | None = None
        self.band = Band.unknown(0)
        self._told: dict[int, TrackedFrame] = {}  # what the band tells, by number
        self.anchors: tuple[int, ...] = ()
        self.dragged: tuple[int, ...] = ()
        self.statuses: dict[int, Status] = {}
        self._pending: dict[int, TrackedFrame] = {}  # to be taken down
        self._go_on = soon(self, self._take_down)
        document.sequence.changed.connect(self._begin_anew)
        document.store.watch(select.dataset, self._begin_anew)
        document.shot_track.followed.connect(self._take_followed)
        document.shot_track.changed.connect(self._take_track)
        document.annotated_frames.changed.connect(self._take_anchors)
        document.corrections.changed.connect(self._take_dragged)
        document.review.statusChanged.connect(self._take_statuses)

    @property
    def hidden(self) -> bool:
        """Return whether nothing of a camera may be shown."""
        return self._document.state.blind

    @property
    def cuts(self) -> tuple[int, ...]:
        """The first frame of each shot but the first, as far as the shots are known."""
        return self._document.shot_track.cuts

    def _begin_anew(self) -> None:
        sequence = self._document.sequence.value
        if sequence is self.sequence:
            return
        self.sequence = sequence
        self._document.annotated_frames.set_wanted(sequence is not None)
        self.band, self._told = Band.unknown(0 if sequence is None else sequence.count), {}
        self._take_track()
        self._take_anchors()
        self._take_dragged()
        self._take_statuses()
        self.changed.emit()

    def _take_track(self) -> None:
        """Other frames than before may be known; most of them are those of before."""
        if (sequence := self.sequence) is None:
            return
        tracked, told = self._document.shot_track.tracked, self._told
        self._pending.clear()
        for number in told.keys() - tracked.keys():
            self.band.coverage[number - sequence.first] = math.nan
            del told[number]
        self._take_followed([f for n, f in tracked.items() if told.get(n) is not f])

    def _take_followed(self, frames: Iterable[TrackedFrame]) -> None:
        if self.sequence is not None:
            self._pending |= {frame.number: frame for frame in frames}
            self._take_down()

    def _take_down(self) -> None:
        """What is known of some frames; of more of them once the event loop has turned."""
        sequence = self.sequence
        if sequence is None:
            return
        for number in list(islice(self._pending, _AT_ONCE)):
            frame = self._pending.pop(number)
            if sequence.first <= number <= sequence.last:
                _put(self.band, number - sequence.first, frame)
                self._told[number] = frame
        if self._pending:
            self._go_on.start()
        self.changed.emit()

    def _take_anchors(self) -> None:
        if (sequence := self.sequence) is not None:
            numbers = sequence.numbers.tolist()
            annotated = sorted(self._document.annotated_frames.indices)
            self.anchors = tuple(numbers[i] for i in annotated if i < len(numbers))
            self.changed.emit()

    def _take_dragged(self, _: str = "") -> None:
        sequence, workspace = self.sequence, self._document.state.workspace
        if sequence is not None and workspace is not None:
            index, numbers = workspace.index, sequence.numbers
            names = self._document.state.corrected.keys() & index.keys()
            self.dragged = tuple(sorted(int(numbers[index[name]]) for name in names))
            self.changed.emit()

    def _take_statuses(self, frame: str = "") -> None:
        sequence, workspace = self.sequence, self._document.state.workspace
        database = self._document.review.database
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
    band.distance[at] = 0.0 if fit is None else min(1.0, far / most_residual_px(fit.size[0]))
    band.doubtful[at] = bool(review_reason(frame))
    band.lost[at] = fit is None
