"""The window begins as it was left: its settings taken up, and written down."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QMainWindow

from procc_annotator.gui import settings as rows
from procc_annotator.gui.picture.canvas import Canvas
from procc_annotator.gui.settings import SWITCHES, Settings
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.window.docks import Docks
from procc_annotator.gui.window.menus import Actions

_SIZE = QSize(1440, 900)
# Settings that an action each sets: its name begins so, and ends with the value.
_CHOICES = {rows.PROTOCOL: "protocol", rows.OFF_PLANE: "off_plane", rows.COLOUR_BY: "colour"}


class Remembering:
    """Puts a window in the state it was left in."""

    def __init__(
        self,
        settings: Settings,
        window: QMainWindow,
        document: Document,
        canvas: Canvas,
        actions: Actions,
        docks: Docks,
    ) -> None:
        self._settings = settings
        self._window = window
        self._document = document
        self._canvas = canvas
        self._actions = actions
        self._docks = docks

    def take_up(self) -> None:
        """Give the window what is remembered."""
        settings, document, window = self._settings, self._document, self._window
        window.resize(_SIZE.boundedTo(window.screen().availableGeometry().size()))
        if not (geometry := settings.get(rows.GEOMETRY)).isEmpty():
            window.restoreGeometry(geometry)
            if self._docks.restore(settings.get(rows.LAYOUT)):
                self._docks.restore_desks(settings.get(rows.DESKS))
        document.set_tau(settings.get(rows.TAU))
        document.store.set(keymap=settings.get(rows.KEYS))
        for row, prefix in _CHOICES.items():
            if (name := settings.get(row)) != row.default:
                self._actions[f"{prefix}_{name}"].trigger()
        document.live_fit.set_model(settings.get(rows.FIT_MODEL))
        document.fit_source.preferred = settings.get(rows.JUDGE_FIT)
        for name, switch in SWITCHES.items():
            if settings.get(switch) != self._actions[name].isChecked():
                self._actions[name].trigger()

    def write_down(self) -> None:
        """Remember the window as it is."""
        settings, document = self._settings, self._document
        settings.set(rows.GEOMETRY, self._window.saveGeometry())
        settings.set(rows.LAYOUT, self._docks.state())
        settings.set(rows.DESKS, self._docks.desks())
        settings.set(rows.TAU, document.tau)
        settings.set(rows.PROTOCOL, document.setup.protocol)
        settings.set(rows.OFF_PLANE, document.setup.off_plane)
        settings.set(rows.COLOUR_BY, self._canvas.colour_by)
        settings.set(rows.FIT_MODEL, document.live_fit.model)
        settings.set(rows.JUDGE_FIT, document.fit_source.preferred)
        # A locked dataset may hold what somebody chose for all of them.
        chosen = {"blind": document.blind_lock.wanted, "live_fit": document.live_fit.chosen}
        for name, switch in SWITCHES.items():
            settings.set(switch, chosen.get(name, self._actions[name].isChecked()))
        settings.sync()
