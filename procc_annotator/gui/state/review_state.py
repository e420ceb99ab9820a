"""Review data of the dataset's frames (status, comments, time, provenance), and its blind lock."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping
from time import monotonic

from PySide6.QtCore import QObject, QTimer, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.records import (
    Comment,
    FaultParty,
    FrameRecord,
    Origin,
    OriginKind,
    PointKey,
    Status,
    Verdict,
    count_points_by_origin,
    new_origins,
    place_by_name,
    place_of,
)
from procc_annotator.dataset.review import (
    LOCK_SETTING,
    BlindCommit,
    LockEvent,
    content_of,
    lock_of,
    read_commit,
    read_events,
    setting_of,
    write_commit,
    write_events,
)
from procc_annotator.gui.state.availability import no_frame
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.store import Store
from procc_annotator.interaction.gestures import Position
from procc_annotator.translation import tr

IDLE_S = 30.0  # longer pauses do not count as work on a frame
UNFINISHED = frozenset({Status.UNTOUCHED, Status.IN_PROGRESS, Status.REJECTED})
_POLL_MS = 2000
_COLLECT_MS = 50  # after it was begun to look what others wrote

_NO_RECORD = FrameRecord()
_JUDGED = (Status.APPROVED, Status.REJECTED)


class ReviewState(QObject):
    """Review data of the workspace database: status, comments, time, origins, kept current with
    edits and other windows."""

    statusChanged = Signal(str)  # status, comments, verdicts or time of a frame, or of all ("")
    originsChanged = Signal()  # how the points of the frame on screen came to be
    notVisibleChanged = Signal(str)  # frame; of another window's doing only that on screen
    commentChosen = Signal(object)  # one whose pin was clicked
    settingChanged = Signal(str)  # the key of a dataset's setting, also changed elsewhere

    def __init__(self, store: Store) -> None:
        super().__init__(store)
        self._store = store
        self.database: WorkspaceDatabase | None = None
        self.new_place: Position | None = None  # of a comment that is being written, picture px
        self._origins: dict[str, dict[PointKey, Origin]] = {}
        self._before_edits: dict[str, tuple[Status, FrameAnnotation]] = {}
        self._frame: str | None = None
        self._last_activity: float | None = None
        self._seconds = 0.0
        self._reported: tuple[str, ...] = ()
        self._poll_timer = QTimer(self, interval=_POLL_MS)
        self._poll_timer.timeout.connect(self.poll)
        self._collect_soon = QTimer(self, singleShot=True, interval=_COLLECT_MS)
        self._collect_soon.timeout.connect(self._collect)

    def set_database(self, database: WorkspaceDatabase | None) -> None:
        """Take over another dataset's memory; the one before is written and closed."""
        self.leave()
        if self.database is not None:
            self.database.close()
        self.database = database
        self._origins.clear()
        self._before_edits.clear()
        self._reported = () if database is None else database.notices  # reported when it was opened
        if database is None:
            self._poll_timer.stop()
            self._collect_soon.stop()
        else:
            self._poll_timer.start()

    # --- status -------------------------------------------------------------------------------

    def record(self, frame: str) -> FrameRecord:
        """Return what is known about a frame."""
        return self.database.record(frame) if self.database is not None else _NO_RECORD

    def status(self, frame: str) -> Status:
        """A frame's status."""
        return self.record(frame).status

    def set_status(self, frame: str, status: Status) -> None:
        """Give a frame another status."""
        if self.database is not None and status != self.status(frame):
            self.database.set_status(frame, status)
            self.statusChanged.emit(frame)

    def touched(self, frame: str, before: FrameAnnotation, after: FrameAnnotation) -> str:
        """The annotation changed: the frame is in progress again, or what it was if this took the
        change back; what to report to the annotator, if much. Its time so far is written down."""
        self._write_time()
        was = self.status(frame)
        earlier, annotation = self._before_edits.get(frame, (was, None))
        revealed = self.blind_commit(frame) is not None
        if was is Status.IN_PROGRESS and after == annotation:
            self.set_status(frame, earlier)
            if earlier not in _JUDGED and not revealed:
                return ""
            return tr("{frame} is {status} again", frame=frame, status=tr(earlier.value, "a frame"))
        # The annotator's own "done" stands, unless it said that the clicks are blind work.
        if was is Status.IN_PROGRESS or (was is Status.DONE and not revealed):
            return ""
        self._before_edits[frame] = was, before
        self.set_status(frame, Status.IN_PROGRESS)
        status = tr(was.value, "a frame")
        if revealed:
            return tr(
                "{frame} was {status} and is in progress again: edited after the cameras were"
                " shown, it is no blind work any more",
                frame=frame,
                status=status,
            )
        if was is not Status.APPROVED:
            return ""
        return tr("{frame} was {status} and is in progress again", frame=frame, status=status)

    def commit(self, frame: str, annotation: FrameAnnotation, *, blind: bool) -> None:
        """Declare a frame's clicks final; ``blind``: no camera of it was shown so far."""
        if self.database is None:
            return
        if blind and not self.record(frame).committed:
            commit = BlindCommit(self.database.author, time.time(), content_of(annotation))
            self.set_setting(setting_of(frame), write_commit(commit))
        self.database.commit(frame)
        self.set_status(frame, Status.DONE)

    def blind_commit(self, frame: str) -> BlindCommit | None:
        """The first commit of a frame, if that was in blind mode."""
        return read_commit(self.setting(setting_of(frame)))

    def committed_frames(self) -> frozenset[str]:
        """Return the frames with final clicks."""
        records = self.database.records() if self.database is not None else {}
        return frozenset(name for name, record in records.items() if record.committed)

    # --- comments -----------------------------------------------------------------------------

    def comments(self, frame: str) -> tuple[Comment, ...]:
        """The thread of a frame, oldest first."""
        return self.database.comments(frame) if self.database is not None else ()

    def add_comment(self, frame: str, text: str, place: Position | None = None) -> None:
        """Add to the thread of a frame, on a ``place`` in it if given; not a blank text."""
        if self.database is not None and text.strip():
            self.database.add_comment(frame, text.strip(), place)
            self.statusChanged.emit(frame)

    def begin_comment(self, place: Position | None) -> None:
        """Show where the comment that is being written will stand; None: it has no place."""
        if place != self.new_place:
            self.new_place = place
            self.statusChanged.emit(self._frame or "")

    @property
    def pins(self) -> dict[str, Comment]:
        """The comments on places of the frame on screen that are not settled, or being written, by
        their texts in the picture."""
        frame = self._frame or ""
        every = {f"✎ {n}": comment for n, comment in enumerate(self.comments(frame), start=1)}
        every["✎ +"] = Comment("", frame, "", 0.0, "", place=self.new_place)
        return {text: c for text, c in every.items() if c.place is not None and not c.resolved}

    def resolve_comment(self, comment: Comment, resolved: bool) -> None:
        """Settle a comment, or open it again."""
        if self.database is not None:
            self.database.resolve_comment(comment.id, resolved)
            self.statusChanged.emit(comment.frame)

    # --- verdicts on camera sources from files; fits change with the clicks and have none -----

    def verdict(self, frame: str, source: CameraSource) -> Verdict | None:
        """Return whose fault a frame's score with a source is, also if blind mode hides it; what an
        older database says of the source's name holds unless something else was said."""
        if self.database is None or source.files is None:
            return None
        found = self.database.verdicts(frame)
        return found.get(self.place(source)) or found.get(place_by_name(source.name))

    def shown_verdict(self, frame: str) -> Verdict | None:
        """Return whose fault a frame's score with the active source is; None while blind mode
        hides it."""
        source = self._store.state.active
        if source is None or not self._store.state.reveals(frame):
            return None
        return self.verdict(frame, source)

    def all_verdicts(self) -> Mapping[str, Mapping[str, Verdict]]:
        """Return what was found of every frame, by frame and the camera source's place."""
        return self.database.all_verdicts() if self.database is not None else {}

    def set_verdict(
        self, frame: str, source: CameraSource, fault: FaultParty | None, comment: str = ""
    ) -> None:
        """Set who caused a frame's low score with a source; None removes the verdict."""
        if self.database is not None and source.files is not None:
            place = self.place(source)
            self.database.set_verdict(frame, source.name, fault, comment, place=place)
            self.statusChanged.emit(frame)

    def rename_source(self, source: CameraSource, before: str) -> None:
        """A source has another name: its verdicts go along."""
        if self.database is not None and (place := self.place(source)):
            self.database.rename_source(place, before, source.name)
            self.statusChanged.emit("")

    def place(self, source: CameraSource) -> str:
        """Return what verdicts know a source by, whatever it is called; empty without a dataset or
        files."""
        cameras, workspace = source.files, self._store.state.workspace
        if workspace is None or cameras is None:
            return ""
        return place_of(cameras.path, cameras.format, workspace.folder)

    # --- elements not visible, and settings ---------------------------------------------------

    def not_visible(self, frame: str) -> frozenset[str]:
        """The classes of the elements that a person said cannot be seen in a frame."""
        return self.database.not_visible(frame) if self.database is not None else frozenset()

    def set_not_visible(self, frame: str, class_name: str, hidden: bool) -> None:
        """Say that an element cannot be seen in a frame, or take it back."""
        if self.database is not None and hidden != (class_name in self.not_visible(frame)):
            self.database.set_not_visible(frame, class_name, hidden)
            self.notVisibleChanged.emit(frame)

    @property
    def reach(self) -> str:
        """For whom what is said of the dataset holds, in words; empty: for everybody."""
        if self.database is None or self.database.shared:
            return ""
        if self.database.path is None:
            return tr("in this window only: nothing can be written")
        return tr("for you alone: the dataset's folder cannot be written")

    def setting(self, key: str) -> str | None:
        """Return what the dataset was given under a key; None when nothing is."""
        return self.database.setting(key) if self.database is not None else None

    def set_setting(self, key: str, value: str | None) -> None:
        """Give the dataset a setting; None takes it back."""
        if self.database is not None and value != self.setting(key):
            self.database.set_setting(key, value)
            self.settingChanged.emit(key)

    # --- provenance ---------------------------------------------------------------------------

    def origins(self, frame: str) -> Mapping[PointKey, Origin]:
        """Return how the points of a frame came to be, as far as known."""
        if self.database is None:
            return {}
        found = self._origins.get(frame)
        if found is None:
            found = self._origins[frame] = dict(self.database.origins(frame))
        return found

    def foresee(self, frames: Iterable[str]) -> None:
        """These frames may be on screen soon: have their origins read meanwhile."""
        if self.database is not None:
            self.database.prefetch_origins(f for f in frames if f not in self._origins)

    def note_edit(
        self,
        frame: str,
        before: FrameAnnotation,
        after: FrameAnnotation,
        kind: OriginKind,
        snapped: frozenset[PointKey] = frozenset(),
        unseen: frozenset[PointKey] = frozenset(),
    ) -> None:
        """Remember how the points of an edit came to be."""
        if self.database is None:
            return
        # Only what was copied here before has an origin to keep; asking for it may wait.
        known = self.origins(frame) if before.unconfirmed else None
        fresh = new_origins(
            before,
            after,
            kind,
            self.database.author,
            time.time(),
            snapped=snapped,
            unseen=unseen,
            known=known,
        )
        if fresh:
            if frame in self._origins:
                self._origins[frame].update(fresh)
            self.database.put_origins(frame, fresh)
            if frame == self._frame:
                self.originsChanged.emit()

    def origin_counts(self, frame: str, annotation: FrameAnnotation) -> dict[OriginKind, int]:
        """Return how many points of an annotation are of each kind."""
        return count_points_by_origin(annotation, self.origins(frame))

    # --- time ---------------------------------------------------------------------------------

    def enter(self, frame: str | None) -> None:
        """Another frame is on screen: its time begins."""
        self.leave()
        self._frame = frame
        self._last_activity = monotonic()
        if frame is not None and self.database is not None:
            self.database.last_frame = frame

    def note_activity(self) -> None:
        """Count the time since the last activity as work, unless it was a long pause."""
        now = monotonic()
        if self._last_activity is not None:
            self._seconds += max(0.0, min(now - self._last_activity, IDLE_S))
        self._last_activity = now

    def leave(self) -> None:
        """The frame is left: write down its time."""
        self._write_time()
        self._frame, self._seconds = None, 0.0

    def _write_time(self) -> None:
        if self._frame is None or self.database is None:
            return
        self.note_activity()
        if self._seconds > 0.05:
            self.database.add_seconds(self._frame, self._seconds)
            self._seconds = 0.0

    # --- other windows ------------------------------------------------------------------------

    def poll(self) -> None:
        """Take over what other windows wrote, and say when nothing can be written."""
        if self.database is not None:
            self._take_over(self.database, self.database.poll)

    def _collect(self) -> None:
        """The same with what was found meanwhile: what waits for the next look is outdated by
        then, as long as a person works here."""
        if self.database is not None:
            self._take_over(self.database, self.database.collect)

    def _take_over(self, database: WorkspaceDatabase, ask: Callable[[], frozenset[str]]) -> None:
        shown = self._frame or ""
        hidden = self.not_visible(shown)
        for frame in ask():
            self._origins.pop(frame, None)
            self.statusChanged.emit(frame)
        if self.not_visible(shown) != hidden:
            self.notVisibleChanged.emit(shown)
        for key in database.changed_settings():
            self.settingChanged.emit(key)
        if database.looking:
            self._collect_soon.start()
        before, self._reported = self._reported, (*database.notices, database.problem)
        for line in filter(None, self._reported):
            if line not in before:
                say(self._store, line, "warning")


class BlindLock(QObject):
    """Forces blind mode on while the dataset on screen is locked to it; else the annotator's own
    choice, ``wanted``, counts."""

    refused = Signal()  # leaving blind mode was refused: switches show the present state again

    def __init__(self, store: Store, review: ReviewState) -> None:
        super().__init__(store)
        self._store, self._review = store, review
        self.wanted = False
        self._locking = False  # this window does it, and says so itself
        review.settingChanged.connect(self._take)
        review.statusChanged.connect(self._take_committed)

    @property
    def reason(self) -> str:
        """Return who locked the dataset and when, in words; empty when no one did. It may begin
        with a name, which is written as its owner writes it."""
        lock = self._store.state.blind_lock
        return "" if lock is None else self._said(lock)

    @property
    def no_fit(self) -> str:
        """Why there is no live fit whatever a person wants; empty when there may be one."""
        if not (reason := self.reason):
            return ""
        return tr("{reason}: there is no live fit in it", reason=reason)

    def of_dataset(self) -> dict[str, object]:
        """Return the state fields of the dataset that the review database belongs to."""
        return {**self._of_lock(), "committed": self._review.committed_frames()}

    def set_blind(self, blind: bool) -> None:
        """Hide everything of the camera until the frame is committed, or show it again unless the
        dataset is locked to blind mode."""
        if self._store.state.blind_lock is None:
            self.wanted = blind
            self._store.update(blind=blind)
        elif not blind:
            text = tr("{reason}: menu Frame unlocks it, which is recorded", reason=self.reason)
            say(self._store, text)
            self.refused.emit()

    def set_locked(self, locked: bool) -> None:
        """Lock the dataset, for everybody who annotates it, or unlock it; written down either
        way."""
        review = self._review
        if review.database is None:
            say(self._store, no_frame(self._store.state), "warning")
            return
        events = self._events()
        if locked != (lock_of(events) is not None):
            event = LockEvent(locked, self._store.state.author, time.time())
            self._locking = True
            review.set_setting(LOCK_SETTING, write_events((*events, event)))
            self._locking = False
            said = tr("this dataset is not locked to blind mode any more")
            if locked:
                said = tr("this dataset is locked to blind mode")
            say(self._store, ", ".join(filter(None, (said, review.reach))))

    # --- inside ---

    def _events(self) -> tuple[LockEvent, ...]:
        return read_events(self._review.setting(LOCK_SETTING))

    def _of_lock(self) -> dict[str, object]:
        lock = lock_of(self._events())
        return {"blind_lock": lock, "blind": self.wanted or lock is not None}

    def _said(self, event: LockEvent) -> str:
        words = tr("This dataset is locked to blind mode")
        if event.time:
            words = _who_and_when(event)
        reach = self._review.reach
        return f"{words} ({reach})" if reach else words

    def _take(self, key: str) -> None:
        """The dataset was locked or unlocked, here or in another window."""
        if key != LOCK_SETTING:
            return
        self._store.update(**self._of_lock())
        events = self._events()
        if events and not self._locking:
            say(self._store, self._said(events[-1]), "warning")

    def _take_committed(self, frame: str) -> None:
        """A frame was committed, here or in another window, or is not any more."""
        known = self._store.state.committed
        if not frame:
            self._store.update(committed=self._review.committed_frames())
        elif self._review.record(frame).committed != (frame in known):
            self._store.update(committed=known ^ {frame})


def _who_and_when(event: LockEvent) -> str:
    who = event.author or tr("Somebody")
    day = time.strftime("%Y-%m-%d %H:%M", time.localtime(event.time))
    if event.locked:
        return tr("{who} locked this dataset to blind mode on {day}", who=who, day=day)
    return tr("{who} unlocked this dataset from blind mode on {day}", who=who, day=day)
