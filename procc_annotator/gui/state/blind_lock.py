"""Blind mode as the annotator wants it, and as the dataset asks for it."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from procc_annotator.session.blind_lock import (
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
        document.datasetChanged.connect(self._look)
        document.review.settingChanged.connect(lambda key: self._look() if key == SETTING else None)

    @property
    def lock(self) -> LockEvent | None:
        """The lock of the dataset on screen."""
        return lock_of(read_events(self._document.review.setting(SETTING)))

    @property
    def reason(self) -> str:
        """Who locked the dataset and when, in words; empty when nobody did."""
        lock = self.lock
        if lock is None:
            return ""
        if not lock.time:
            return "this dataset is locked to blind mode"
        day = time.strftime("%Y-%m-%d %H:%M", time.localtime(lock.time))
        return f"{lock.author or 'somebody'} locked this dataset to blind mode on {day}"

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
        events = read_events(review.setting(SETTING))
        if locked != (lock_of(events) is not None):
            event = LockEvent(locked, self._document.author, time.time())
            review.set_setting(SETTING, write_events((*events, event)))
            words = "locked to blind mode" if locked else "not locked to blind mode any more"
            self._document.message.emit(f"this dataset is {words}", "info")

    def _look(self) -> None:
        """Another dataset, or it was locked or unlocked, here or in another window."""
        self._document.apply_blind(self.wanted or self.lock is not None)
