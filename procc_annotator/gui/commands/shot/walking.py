"""Through the frames of a shot: by tens, to the next doubtful or annotated one, and played."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from PySide6.QtCore import QEvent, QObject, QTimer, Signal
from PySide6.QtWidgets import QApplication

from procc_annotator.calibration.tracking.track import TrackedFrame
from procc_annotator.dataset.computed_cameras import review_reason
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, word

_SLOWEST_MS = 1000  # between frames that lie seconds apart, nobody wants to wait as long


# (forward, what is looked for) -> what is said if absent.
_ANNOTATED, _DOUBTFUL = "annotated", "doubtful"
_NO_OTHER = {
    (True, _ANNOTATED): word("no frame after this one is annotated"),
    (False, _ANNOTATED): word("no frame before this one is annotated"),
    (True, _DOUBTFUL): word("no frame after this one is doubtful"),
    (False, _DOUBTFUL): word("no frame before this one is doubtful"),
}


class ShotWalk(QObject):
    """Commands that go to frames; none of them waits for a picture."""

    playingChanged = Signal(bool)

    def __init__(self, services: Services, canvas: Canvas, window: QObject) -> None:
        super().__init__(window)
        self._services, self._window = services, window
        self._at: int | None = None  # where playing is
        self._clock = QTimer(self, singleShot=True)
        self._clock.timeout.connect(self._play_on)
        canvas.editor.changed.connect(self.stop)  # a hand does something
        canvas.menuWanted.connect(self.stay)  # before the menu is there, and with it a choice
        services.store.events.annotationEdited.connect(self.stop)
        services.store.watch(select.dataset, self.stop)

    def step(self, frames: int) -> None:
        """Go so many frames on, or back; to the last or the first one at most."""
        workspace = self._services.state.workspace
        if workspace is not None and workspace.frames:
            index = self._services.state.frame_index + frames
            self._services.navigator.come_to(min(max(index, 0), len(workspace.frames) - 1))

    def go_anchor(self, step: int) -> None:
        """Go to the nearest annotated frame after (1) or before (-1) this one."""
        indices = self._services.annotated_frames.indices
        if self._has_order():
            self._go(indices, step, _ANNOTATED)

    def go_doubtful(self, step: int) -> None:
        """Go to the nearest frame whose track is in doubt, after (1) or before (-1) this one."""
        sequence = self._services.sequence.value
        tracked = self._services.shot_track.tracked
        if sequence is None or not self._has_order():
            return
        if self._services.state.blind:
            self._services.say(tr("blind mode: how the track does is hidden"))
            return
        if not tracked:
            self._services.say(tr("no shot was followed yet (T)"))
            return
        index_of = sequence.index_of
        self._go((index_of[n] for n in index_of if _doubtful(tracked, n)), step, _DOUBTFUL)

    def _go(self, indices: Iterable[int], step: int, what: str) -> None:
        here = self._services.state.frame_index
        beyond = [index for index in indices if (index - here) * step > 0]
        if beyond:
            self._services.navigator.come_to(min(beyond) if step > 0 else max(beyond))
        else:
            self._services.say(tr(_NO_OTHER[step > 0, what]))

    def _has_order(self) -> bool:
        if self._services.sequence.value is None:
            self._services.say(tr("these frames do not follow one another"))
            return False
        return True

    # --- playing ------------------------------------------------------------------------------

    @property
    def playing(self) -> bool:
        """Return whether frames are shown one after the other."""
        return self._at is not None

    def play(self) -> None:
        """Show the frames one after the other from here on, or stop."""
        if self.playing:
            self.stop()
        elif self._has_order():
            self._window.installEventFilter(self)
            self._at = self._services.state.frame_index
            self.playingChanged.emit(True)
            self._play_on()

    def stop(self) -> None:
        """Stay where it is."""
        if self._at is not None:
            self._at = None
            self._clock.stop()
            self._window.removeEventFilter(self)
            self.playingChanged.emit(False)

    def stay(self) -> None:
        """Stop, without a frame that is on its way still: something was chosen on this one."""
        if self.playing:
            self.stop()
            self._services.navigator.stay()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.WindowBlocked:  # a dialog asks about the frame on screen
            self.stay()
        return False

    def _play_on(self) -> None:
        """Go to the next frame, unless a person went elsewhere or the last one is there."""
        services, at = self._services, self._at
        sequence = services.sequence.value
        if at is None or sequence is None:
            self.stop()
            return
        if QApplication.activePopupWidget() is not None:  # a menu of the bar
            self.stay()
            return
        if services.navigator.coming:  # pictures come more slowly than they should be shown
            self._clock.start(5)
            return
        if services.state.frame_index != at or at + 1 >= len(sequence.numbers):
            self.stop()
            return
        self._at = at + 1
        apart = int(sequence.numbers[at + 1] - sequence.numbers[at])
        services.navigator.come_to(at + 1)
        self._clock.start(min(_SLOWEST_MS, round(1000 * apart / sequence.fps)))


def _doubtful(tracked: Mapping[int, TrackedFrame], number: int) -> bool:
    frame = tracked.get(number)
    return frame is not None and bool(review_reason(frame))
