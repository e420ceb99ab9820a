"""What was opened last, to go on with: a submenu of File, and entries of the welcome page."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QMenu, QWidget

from procc_annotator.gui.settings import RECENT, Settings

_LONGEST_FOLDER = 48


class RecentMenu(QMenu):
    """Lists what was opened last, newest first."""

    def __init__(
        self, settings: Settings, chosen: Callable[[Path], object], parent: QWidget
    ) -> None:
        super().__init__("Open recent", parent)
        self.setObjectName("recentMenu")
        self._settings = settings
        self._chosen = chosen
        self.aboutToShow.connect(self.fill)

    def fill(self) -> None:
        """Make the entries anew."""
        self.clear()
        for path in self._settings.get(RECENT):
            action = self.addAction(described(path).replace("&", "&&"))
            action.setToolTip(str(path))
            action.triggered.connect(lambda _=False, path=path: self._chosen(path))
        if self.isEmpty():
            self.addAction("Nothing was opened yet").setEnabled(False)


def described(path: Path) -> str:
    """A path as its name and the folder it is in, the latter shortened from its beginning."""
    folder = str(path.parent)
    if len(folder) > _LONGEST_FOLDER:
        folder = "…" + folder[-_LONGEST_FOLDER:]
    return f"{path.name or path} – {folder}"
