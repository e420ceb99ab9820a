"""Blind mode as the annotator wants it, and as the dataset asks for it."""

from __future__ import annotations

import time

from PySide6.QtCore import QObject, Signal

from procc_annotator.dataset.review import (
    LOCK_SETTING,
    LockEvent,
    lock_of,
    read_events,
    write_events,
)
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.saying import say
from procc_annotator.gui.state.store import Store
from procc_annotator.translation import tr


class BlindLock(QObject):
    """Forces blind mode on while the dataset on screen is locked to it.

    Attributes:
        wanted: the annotator's own choice, which counts where there is no lock.
    """

    refused = Signal()  # leaving blind mode was refused: switches show the present state again

    def __init__(self, store: Store, review: ReviewState) -> None:
        super().__init__(store)
        self._store, self._review = store, review
        self.wanted = False
        self._locking = False  # this window does it, and says so itself
        review.settingChanged.connect(self._take)
        review.statusChanged.connect(self._take_committed)

    @property
    def lock(self) -> LockEvent | None:
        """The lock of the dataset on screen."""
        return self._store.state.blind_lock

    @property
    def reason(self) -> str:
        """Return who locked the dataset and when, in words; empty when no one did. It may begin
        with a name, which is written as its owner writes it."""
        return self._said(lock) if (lock := self.lock) is not None else ""

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
        if self.lock is None:
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
            say(self._store, tr("open a folder of pictures first"), "warning")
            return
        events = self._events()
        if locked != (lock_of(events) is not None):
            event = LockEvent(locked, self._store.state.author, time.time())
            self._locking = True
            review.set_setting(LOCK_SETTING, write_events((*events, event)))
            self._locking = False
            said = [
                tr("this dataset is locked to blind mode")
                if locked
                else tr("this dataset is not locked to blind mode any more")
            ]
            say(self._store, ", ".join(filter(None, (*said, review.reach))))

    # --- inside ---

    def _events(self) -> tuple[LockEvent, ...]:
        return read_events(self._review.setting(LOCK_SETTING))

    def _of_lock(self) -> dict[str, object]:
        lock = lock_of(self._events())
        return {"blind_lock": lock, "blind": self.wanted or lock is not None}

    def _said(self, event: LockEvent) -> str:
        if not event.time:
            words = tr("This dataset is locked to blind mode")
        else:
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
