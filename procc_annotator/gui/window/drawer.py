"""The drawer with the large plots below the picture: its handle, and the key that opens it."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QSizePolicy, QToolButton, QWidget

from procc_annotator.gui.window.docks import Docks
from procc_annotator.translation import tr

_DOCK, _DESK = "plots", "judge"


class Drawer(QToolButton):
    """A strip across the foot of the picture while one judges; pulled, the drawer opens or shuts.

    What is torn off is no drawer any more: the handle brings it to the front.
    """

    def __init__(self, docks: Docks, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("drawerHandle")
        self._docks, self._dock = docks, docks.by_name[_DOCK]
        self.setAutoRaise(True)
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._keys = ""
        self._dock.visibilityChanged.connect(self._show_state)
        self.show_for(docks.desk)

    def take_keys(self, action: QAction) -> None:
        """Show the keys that do the same, whatever they are."""
        action.changed.connect(lambda: self._take_keys(action))
        self._take_keys(action)

    def show_for(self, desk: str) -> None:
        """A desk came into sight."""
        self.setVisible(desk == _DESK)
        self._show_state()

    def _take_keys(self, action: QAction) -> None:
        self._keys = action.shortcut().toString()
        self._show_state()

    @property
    def is_open(self) -> bool:
        """Return whether the plots are in sight, in the drawer or torn off."""
        return not self._dock.isHidden()

    def _show_state(self) -> None:
        title = tr("Plots")
        self.setText(f"{title}  {self._keys}" if self._keys else title)
        shut = not self.is_open or self._dock.isFloating()
        self.setArrowType(Qt.ArrowType.UpArrow if shut else Qt.ArrowType.DownArrow)
        told = tr("Open the plots below the picture") if shut else tr("Shut the plots")
        self.setToolTip(told)
        self.setAccessibleName(told)
