"""Actions that are on or off show what holds, whoever decided it."""

from __future__ import annotations

from dataclasses import asdict

from PySide6.QtCore import QObject

from procc_annotator.gui.state.document import Document
from procc_annotator.gui.window.menus import Actions


class ActionStates(QObject):
    """Keeps the ticks of the menus in step with the document."""

    def __init__(self, document: Document, actions: Actions, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._actions = actions
        document.modeChanged.connect(self._show_mode)
        document.datasetChanged.connect(self._show_mode)
        document.live_fit.changed.connect(self._show_live_fit)
        document.disagreement.changed.connect(self._show_maps)
        document.uncertainty.changed.connect(self._show_maps)

    def _show_mode(self) -> None:
        document, actions = self._document, self._actions
        actions.set_checked("draw_mode", document.mode == "draw")
        actions.set_checked("edit_mode", document.mode == "edit")
        actions.set_checked("blind", document.blind)
        for name, on in asdict(document.state.options).items():
            actions.set_checked(name, on)
        reason = document.blind_lock.reason
        actions.set_checked("lock_blind", bool(reason))
        actions.set_reason("blind", reason)
        actions.set_reason("live_fit", document.blind_lock.no_fit)

    def _show_live_fit(self) -> None:
        self._actions.set_checked("live_fit", self._document.live_fit.wanted)

    def _show_maps(self) -> None:
        self._actions.set_checked("disagreement", self._document.disagreement.wanted)
        self._actions.set_checked("uncertainty", self._document.uncertainty.wanted)
