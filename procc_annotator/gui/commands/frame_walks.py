"""Walks through frames: by status, worst first, and through a shot."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

from PySide6.QtCore import QEvent, QObject, QTimer, Signal
from PySide6.QtWidgets import QApplication

from procc_annotator.batch.audit import FrameAudit
from procc_annotator.batch.triage import (
    SetDisagreement,
    largest_error,
    next_worst,
    set_disagreement,
    worst_frames_first,
)
from procc_annotator.dataset.computed_cameras import review_reason
from procc_annotator.dataset.records import Status
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.availability import no_source
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.review_state import UNFINISHED
from procc_annotator.gui.state.sequences import is_annotated
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, word

_SLOWEST_MS = 1000  # between frames that lie seconds apart, nobody wants to wait as long


_NO_OTHER = word("no further frame this way: {what}")


class ShotWalk(QObject):
    """Commands that go to frames; none of them waits for a picture."""

    playingChanged = Signal(bool)

    def __init__(
        self,
        services: Services,
        canvas: Canvas,
        unsure: Callable[[], Mapping[int, float]],
        window: QObject,
    ) -> None:
        """Stay where it is; ``unsure`` has the probabilities of frames by index."""
        super().__init__(window)
        self._services, self._window, self._unsure = services, window, unsure
        self._walked: Mapping[int, float] = {}  # the unsure frames that are gone through
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

    def go_doubtful(self, step: int) -> None:
        """Go through the frames that are not sure, the least sure first; without such to the
        nearest frame whose track is in doubt, after (1) or before (-1) this one."""
        if self._unsure() and not self._services.state.blind:
            self._go_unsure(step)
            return
        sequence = self._services.sequence.value
        tracked = self._services.shot_track.tracked
        if not self._has_order() or sequence is None:
            return
        if self._services.state.blind:
            self._services.say(tr("blind mode: how the track does is hidden"))
            return
        if not tracked:
            self._services.say(tr("no shot was followed yet (T)"))
            return
        here = self._services.state.frame_index
        index_of, known = sequence.index_of, tracked.keys() & sequence.index_of.keys()
        doubtful = [index_of[number] for number in known if review_reason(tracked[number])]
        if beyond := [index for index in doubtful if (index - here) * step > 0]:
            self._services.navigator.come_to(min(beyond) if step > 0 else max(beyond))
        else:
            self._services.say(tr(_NO_OTHER, what=tr("none is doubtful")))

    def _go_unsure(self, step: int) -> None:
        here, workspace = self._services.state.frame_index, self._services.state.workspace
        assert workspace is not None
        unsure = self._unsure()
        begun, self._walked = unsure is self._walked and here in unsure, unsure
        order = sorted(unsure, key=lambda index: (unsure[index], index))
        left = [p for p, i in enumerate(order) if i != here and not is_annotated(workspace, i)]
        if not left:
            self._services.say(tr("no other frame is unsure"))
            return
        at = order.index(here) if begun else -1
        place = ([p for p in left if (p - at) * step > 0] or left)[0 if step > 0 else -1]
        self._services.navigator.go_to(order[place])
        words = tr("{place} of {total}, the least sure first", place=place + 1, total=len(order))
        last = tr("this is the last one") if place == left[-1] else ""
        self._services.say("; ".join(filter(None, (words, last))))

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


# Whether a frame, of an index and a status, is of a kind; what is said if absent.
_KINDS: dict[str, tuple[Callable[[Workspace, int, Status], bool], str]] = {
    "annotated": (lambda w, index, _: is_annotated(w, index), word("none is annotated")),
    "unannotated": (lambda w, index, _: not is_annotated(w, index), word("all are annotated")),
    "unfinished": (lambda *frame: frame[2] in UNFINISHED, word("all are done or approved")),
    "rejected": (lambda *frame: frame[2] is Status.REJECTED, word("none is rejected")),
}


class StatusWalk:
    """Slots of the menu Frame that look at more than one frame."""

    def __init__(self, services: Services) -> None:
        self._services = services

    def go(self, kind: str, step: int) -> None:
        """Go to the nearest frame of a kind (of `_KINDS`) after (1) or before (-1) this one; for
        rejected ones it begins again after the last."""
        services, workspace = self._services, self._services.state.workspace
        if workspace is None:
            return
        wanted, what = _KINDS[kind]
        here, count = services.state.frame_index, len(workspace.frames)
        ahead = range(here + step, count if step > 0 else -1, step)
        order = [*ahead, *(range(here) if kind == "rejected" else ())]
        within = services.navigator.within
        for index in order if within is None else [index for index in order if index in within]:
            if wanted(workspace, index, services.review.status(workspace.frames[index].name)):
                services.navigator.go_to(index)
                return
        services.say(tr(_NO_OTHER, what=tr(what)))


Order = Literal["jac", "error", "disagreement"]
Values = Callable[[], Mapping[str, float]]

_SAID: dict[Order, str] = {
    "jac": word("{place} of {total}, worst first: JaC {value:.3f}"),
    "error": word("{place} of {total}, worst first: largest error {value:.1f} px"),
    "disagreement": word("{place} of {total}, worst first: median disagreement {value:.2f} m"),
}
_MANY = 300  # frames that are ranked on the interface thread at most


@dataclass
class _Walk:
    """A walk under way.

    Attributes:
        key: what it is a walk through; another one begins with the worst frame.
        order: positions of frames, the worst first.
        place: visited last, -1 at the beginning.
    """

    key: tuple[object, ...]
    order: list[int]
    values: Mapping[str, float]
    place: int = -1


class WorstFirst(QObject):
    """Slots of the actions that walk; a walk keeps its order while one edits and looks around."""

    progressed = Signal(int, int)  # frames compared, of how many; (0, 0) when it is over

    def __init__(self, services: Services, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._services = services
        self._walk: _Walk | None = None
        self._kept: dict[tuple[object, ...], SetDisagreement] = {}
        self._ranking = LatestOnlyTask(self, lambda text: services.say(text, "error"))
        self._comparing = LatestOnlyTask(self, self._not_compared)
        services.store.watch(select.dataset, self._forget)
        services.store.watch(select.cameras, self._forget_removed)

    def go_worst(self) -> None:
        """The frame with the lowest JaC, then the next better one."""
        tau = self._services.state.tau
        self._go_by_audits("jac", lambda audit: audit.jac_at(tau), low=True, more=(tau,))

    def go_largest_error(self) -> None:
        """The frame with the largest error of a point, then the next smaller one."""
        self._go_by_audits("error", largest_error, low=False)

    def go_disagreement(self) -> None:
        """The frame where the active source and the compared one differ most, then the next."""
        services = self._services
        pair = self._pair()
        if pair is None or services.state.workspace is None:
            services.say(
                tr("two sources are needed to see where they disagree: load more cameras (Ctrl+L)")
            )
            return
        found = self._kept.get(self._pair_key(*pair))
        if found is None:
            self._compare(*pair)
            return
        if not found.metres:
            services.say(
                tr(
                    "{source} and {other} cannot be compared on the ground in any frame",
                    source=pair[0].name,
                    other=pair[1].name,
                )
            )
            return
        self._go("disagreement", lambda: found.metres, self._pair_key(*pair), low=False)

    def stop(self) -> None:
        """Stop what is computed of the whole set."""
        self._services.scoring.cancel()
        if self._comparing.cancel():
            self.progressed.emit(0, 0)
            self._services.say(tr("stopped comparing the sources"))

    # --- walking --------------------------------------------------------------------------

    def _go_by_audits(
        self,
        order: Order,
        value: Callable[[FrameAudit], float | None],
        *,
        low: bool,
        more: tuple[object, ...] = (),
    ) -> None:
        source = self._services.state.active
        if source is None:
            self._say_no_scores()
            return
        audits = dict(source.audits)

        def values() -> dict[str, float]:
            found = ((name, value(audit)) for name, audit in audits.items())
            return {name: number for name, number in found if number is not None}

        key = (source.camera_set, self._services.state.setup, len(audits), *more)
        self._go(order, values, key, low=low)

    def _go(self, order: Order, values: Values, more: tuple[object, ...], *, low: bool) -> None:
        """Take the next step of a walk, or rank the frames and take the first one."""
        services = self._services
        workspace = services.state.workspace
        if workspace is None or self._ranking.running:
            return
        committed = services.state.revealed_frames
        key = (order, *more, None if committed is None else len(committed))
        if self._walk is not None and self._walk.key == key:
            # An edit changes a frame's value; while one walks its place stays, so that none is
            # visited twice and none is missed.
            self._step(order, self._walk)
            return
        index, frame = workspace.index, services.state.frame

        def rank() -> _Walk:
            found = values()
            if committed is not None:
                found = {name: value for name, value in found.items() if name in committed}
            return _Walk(key, worst_frames_first(found, index, low=low), found)

        def done(walk: _Walk) -> None:
            if services.state.frame is frame:  # nobody has moved on meanwhile
                self._walk = walk
                self._step(order, walk)

        if len(workspace.frames) <= _MANY:
            done(rank())
            return
        self._ranking.start(lambda _: rank(), done)

    def _step(self, order: Order, walk: _Walk) -> None:
        services = self._services
        workspace = services.state.workspace
        if workspace is None or not walk.order:
            self._say_no_scores()
            return
        if walk.place < 0 and walk.order[0] == services.state.frame_index:
            walk.place = 0
            self._tell(order, walk, tr("this is the worst; once more goes on"))
            return
        place = next_worst(walk.order, walk.place, services.state.frame_index)
        if place is None:
            services.say(tr("no other frame has a score"))
            return
        again, walk.place = place < walk.place, place
        services.navigator.go_to(walk.order[place])
        self._tell(order, walk, tr("from the worst again") if again else "")

    def _tell(self, order: Order, walk: _Walk, more: str) -> None:
        frame = self._services.state.frame
        if frame is not None:
            said = tr(
                _SAID[order],
                place=walk.place + 1,
                total=len(walk.order),
                value=walk.values[frame.name],
            )
            self._services.say("; ".join(filter(None, (said, more))))

    def _say_no_scores(self) -> None:
        state, words = self._services.state, tr("no frame with a score to go to")
        if state.blind:
            words = tr(
                "no frame with a score to go to: blind mode shows those of committed frames only"
            )
        self._services.say(no_source(state) or words)

    # --- comparing ------------------------------------------------------------------------

    def _pair(self) -> tuple[CameraSource, CameraSource] | None:
        active, other = self._services.state.active, self._services.state.compared
        return None if active is None or other is None else (active, other)

    def _pair_key(self, a: CameraSource, b: CameraSource) -> tuple[object, ...]:
        """The same whichever of the two is active: metres do not depend on it."""
        setup = self._services.state.setup
        return frozenset((a.camera_set, b.camera_set)), setup.size, setup.field.described

    def _compare(self, a: CameraSource, b: CameraSource) -> None:
        services = self._services
        state = services.state
        workspace, frame, setup = state.workspace, state.frame, state.setup
        if workspace is None:
            return
        if self._comparing.running:
            services.say(tr("two sources are being compared already"))
            return
        key = self._pair_key(a, b)
        names = [f.name for f in workspace.frames]
        first, second = a.camera_set, b.camera_set
        services.say(
            tr("comparing {source} with {other} over the set", source=a.name, other=b.name)
        )

        def work(control: JobControl) -> SetDisagreement:
            return set_disagreement(
                names, first, second, setup, control.progress, lambda: control.cancelled
            )

        def done(found: SetDisagreement) -> None:
            self.progressed.emit(0, 0)
            self._kept[key] = found
            if services.state.frame is frame:  # nobody has moved on meanwhile
                self.go_disagreement()
            else:
                services.say(tr("{source} and {other} are compared", source=a.name, other=b.name))

        self._comparing.start(work, done, progress=self.progressed.emit)

    def _not_compared(self, text: str) -> None:
        self.progressed.emit(0, 0)
        self._services.say(text, "error")

    def _forget(self) -> None:
        self._ranking.cancel()
        if self._comparing.cancel():
            self.progressed.emit(0, 0)
        self._walk = None
        self._kept.clear()

    def _forget_removed(self) -> None:
        """Comparisons of sources that are gone are not kept."""
        there = {source.camera_set for source in self._services.state.sources}
        self._kept = {
            key: found
            for key, found in self._kept.items()
            if isinstance(key[0], frozenset) and key[0] <= there
        }
