"""Blind mode as the annotator wants it, and as the dataset asks for it."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from procc_annotator.session.facts.blind_lock import (
    SETTING,
    LockEvent,
    lock_of,
    read_events,
    write_events,
)

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document


class BlindLock(QObject):
    """Forces blind mode on while the dataset on screen is locked to it.

    Attributes:
        wanted: the annotator's own choice, which counts where there is no lock.
    """

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document
        self.wanted = False
        self._events: tuple[str | None, tuple[LockEvent, ...]] = (None, ())  # and their text
        self._locking = False  # this window does it, and says so itself
        document.datasetChanged.connect(self._look)
        document.review.settingChanged.connect(self._take)

    @property
    def lock(self) -> LockEvent | None:
        """The lock of the dataset on screen."""
        return lock_of(self._read())

    @property
    def reason(self) -> str:
        """Who locked the dataset and when, in words; empty when nobody did. It may begin with a
        name, which is written as its owner writes it."""
        return self._said(lock) if (lock := self.lock) is not None else ""

    @property
    def no_fit(self) -> str:
        """Why there is no live fit whatever somebody wants; empty when there may be one."""
        return f"{reason}: there is no live fit in it" if (reason := self.reason) else ""

    def _said(self, event: LockEvent) -> str:
        done = "locked this dataset to" if event.locked else "unlocked this dataset from"
        if not event.time:
            words = "This dataset is locked to blind mode"
        else:
            day = time.strftime("%Y-%m-%d %H:%M", time.localtime(event.time))
            words = f"{event.author or 'Somebody'} {done} blind mode on {day}"
        reach = self._document.review.reach
        return f"{words} ({reach})" if reach else words

    def _read(self) -> tuple[LockEvent, ...]:
        """What happened, read once: it is asked for with every edit."""
        text = self._document.review.setting(SETTING)
        if text != self._events[0]:
            self._events = text, read_events(text)
        return self._events[1]

    def choose(self, blind: bool) -> bool:
        """The annotator switches blind mode; whether it is on now."""
        if self.lock is not None:
            if not blind:
                self._document.message.emit(
                    f"{self.reason}: menu Frame unlocks it, which is recorded", "info"
                )
            return True
        self.wanted = blind
        return blind

    def set_locked(self, locked: bool) -> None:
        """Lock the dataset, for everybody who annotates it, or unlock it; written down either
        way."""
        review = self._document.review
        if review.database is None:
            self._document.message.emit("open a folder of pictures first", "warning")
            return
        events = self._read()
        if locked != (lock_of(events) is not None):
            event = LockEvent(locked, self._document.author, time.time())
            self._locking = True
            review.set_setting(SETTING, write_events((*events, event)))
            self._locking = False
            words = "locked to blind mode" if locked else "not locked to blind mode any more"
            reach = f", {review.reach}" if review.reach else ""
            self._document.message.emit(f"this dataset is {words}{reach}", "info")

    def _take(self, key: str) -> None:
        """The dataset was locked or unlocked, here or in another window."""
        if key != SETTING:
            return
        self._look()
        events = self._read()
        if events and not self._locking:
            self._document.message.emit(self._said(events[-1]), "warning")

    def _look(self) -> None:
        """Another dataset, or another lock."""
        self._document.apply_blind(self.wanted or self.lock is not None)
