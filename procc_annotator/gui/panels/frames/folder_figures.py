"""How many frames of each folder are done, and their mean JaC; counted a little at a time."""

from __future__ import annotations

import math
from time import perf_counter

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from procc_annotator.dataset.frames import Folder
from procc_annotator.dataset.records import Status
from procc_annotator.gui.state.background import after_paint
from procc_annotator.gui.state.document import Document

_BUDGET_S = 0.003
_SOON_MS = 150
_DONE = frozenset({Status.DONE, Status.APPROVED})


class FolderFigures(QObject):
    """What is known of the frames, by number; `changed` says that it is another thing now."""

    changed = Signal()

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._names: list[str] = []
        self._done = np.zeros(0, dtype=bool)
        self._jac = np.zeros(0)
        self._at = 0
        self._soon = QTimer(self, singleShot=True, interval=_SOON_MS)
        self._soon.timeout.connect(self._begin)
        self._go_on = after_paint(self, self._count)

    def reset(self, names: list[str]) -> None:
        """Other frames; none, where no folder is shown."""
        self._names = names
        self._done = np.zeros(len(names), dtype=bool)
        self._jac = np.full(len(names), math.nan)
        self._soon.stop()
        self._begin()

    def look_again(self) -> None:
        """Statuses or scores of some frames are other ones."""
        if self._document.auditing.frame_scores.allowed is not None:
            self._jac[:] = math.nan  # while blind nothing that was known before stays in sight
        if self._names:
            self._soon.start()

    def done(self, folder: Folder) -> int:
        """Return how many of a folder's frames are done or approved."""
        return int(self._done[folder.first : folder.past].sum())

    def jac(self, folder: Folder) -> float | None:
        """The mean of a folder's frames that have a score which may be seen; None without any."""
        known = self._jac[folder.first : folder.past]
        known = known[~np.isnan(known)]
        return float(known.mean()) if known.size else None

    def _begin(self) -> None:
        self._at = 0
        if self._names:
            self._go_on.start()

    def _count(self) -> None:
        review, scores = self._document.review, self._document.auditing.frame_scores
        end = perf_counter() + _BUDGET_S
        while self._at < len(self._names) and perf_counter() < end:
            name = self._names[self._at]
            self._done[self._at] = review.status(name) in _DONE
            self._jac[self._at] = scores.get(name, math.nan)
            self._at += 1
        if self._at < len(self._names):
            self._go_on.start()
        else:
            self.changed.emit()
