"""The window begins as it was left: its settings taken up, and written down."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QMainWindow

from procc_annotator.gui import settings as rows
from procc_annotator.gui.settings import Settings
from procc_annotator.gui.window.docks import Docks
from procc_annotator.gui.window.options import Options

_SIZE = QSize(1440, 900)
_AROUND = QSize(16, 48)  # what a desktop puts around a window, and its title; it tells too late


class Remembering:
    """Puts a window in the state it was left in."""

    def __init__(
        self, settings: Settings, window: QMainWindow, options: Options, docks: Docks
    ) -> None:
        self._settings = settings
        self._window = window
        self._options = options
        self._docks = docks

    def take_up(self) -> None:
        """Give the window what is remembered."""
        settings, window = self._settings, self._window
        window.resize(_SIZE.boundedTo(window.screen().availableGeometry().size() - _AROUND))
        if not (geometry := settings.get(rows.GEOMETRY)).isEmpty():
            window.restoreGeometry(geometry)
            if self._docks.restore(settings.get(rows.LAYOUT)):
                self._docks.restore_desks(settings.get(rows.DESKS))
        self._options.take_up_all()

    def write_down(self) -> None:
        """Remember the window as it is."""
        settings = self._settings
        settings.set(rows.GEOMETRY, self._window.saveGeometry())
        settings.set(rows.LAYOUT, self._docks.state())
        settings.set(rows.DESKS, self._docks.desks())
        self._options.write_down()
        settings.sync()
