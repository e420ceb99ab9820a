"""Locking a dataset to blind mode, and the question before it is unlocked."""

from __future__ import annotations

from PySide6.QtWidgets import QMessageBox, QWidget

from procc_annotator.gui.state.document import Document
from procc_annotator.translation import tr, word

_UNLOCKS_SHARED = word(
    "Unlocking shows cameras, ghosts and the fit to everybody who annotates it. It is recorded with"
    " the dataset that {author} unlocked it, and when."
)
_UNLOCKS_OWN = word(
    "Unlocking shows cameras, ghosts and the fit to you; for others it was not locked. It is"
    " recorded with the dataset that {author} unlocked it, and when."
)


class BlindLocking:
    """Slot of the action that locks and unlocks."""

    def __init__(self, document: Document, parent: QWidget) -> None:
        self._document = document
        self._parent = parent

    def set_locked(self, locked: bool) -> None:
        """Lock the dataset for everybody; unlock it once a person said so knowingly."""
        lock = self._document.blind_lock
        if locked or lock.lock is None or self._confirmed(lock.reason):
            lock.set_locked(locked)
        lock.refused.emit()  # the action shows the present state

    def _confirmed(self, reason: str) -> bool:
        shared = not self._document.review.reach
        words = _UNLOCKS_SHARED if shared else _UNLOCKS_OWN
        box = QMessageBox(self._parent)
        box.setObjectName("unlockBlind")
        box.setIcon(QMessageBox.Icon.Warning)
        box.setWindowTitle(tr("Unlock blind mode"))
        box.setText(f"{reason[0].upper()}{reason[1:]}.")
        box.setInformativeText(tr(words, author=self._document.state.author))
        unlock = box.addButton(tr("Unlock, and record it"), QMessageBox.ButtonRole.AcceptRole)
        keep = box.addButton(tr("Keep it locked"), QMessageBox.ButtonRole.RejectRole)
        box.setDefaultButton(keep)
        box.exec()
        chosen = box.clickedButton() is unlock
        box.deleteLater()
        return chosen
