"""The docks around the picture: which there are, how they are arranged, hidden and remembered."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from itertools import pairwise

from PySide6.QtCore import QByteArray, Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow, QTabBar, QWidget

from procc_annotator.gui.panels.refresher import Refresher

_LEFT = Qt.DockWidgetArea.LeftDockWidgetArea
_RIGHT = Qt.DockWidgetArea.RightDockWidgetArea
_VERSION = 4  # of the arrangement; what another version saved is not restored
_NARROWEST_FRAMES, _NARROWEST_PANEL = 190, 230  # below that texts are cut off

TITLES = {
    "frames": "Frames",
    "field_map": "Field map",
    "elements": "Elements",
    "cameras": "Cameras",
    "scores": "Scores",
    "fit": "Fit",
    "findings": "Check",
    "landmarks": "Landmarks",
    "plots": "Plots",
    "review": "Review",
    "agreement": "Agreement",
}
_ALONE = ("frames", "field_map")  # the others share a column as tabs, in this order


def _catch_up(panel: QWidget, in_sight: bool) -> None:
    """A panel that comes to the front of its tabs shows what it missed behind them."""
    if in_sight:
        for refresher in panel.findChildren(Refresher):
            refresher.catch_up()


class Docks:
    """The window's docks by name.

    Attributes:
        by_name: one for each panel.
    """

    def __init__(self, window: QMainWindow, panels: Mapping[str, QWidget]) -> None:
        self._window = window
        self._open = QByteArray()
        self.by_name: dict[str, QDockWidget] = {}
        for name, title in TITLES.items():
            dock = QDockWidget(title, window)
            dock.setObjectName(f"dock_{name}")
            dock.setWidget(panels[name])
            narrowest = _NARROWEST_FRAMES if name == "frames" else _NARROWEST_PANEL
            panels[name].setMinimumWidth(narrowest)
            dock.visibilityChanged.connect(partial(_catch_up, panels[name]))
            self.by_name[name] = dock
        self.arrange()

    def arrange(self) -> None:
        """The layout the window starts with."""
        window, docks = self._window, self.by_name
        window.setDockNestingEnabled(True)
        for name, dock in docks.items():
            dock.setFloating(False)
            window.addDockWidget(_LEFT if name == "frames" else _RIGHT, dock)
            dock.show()
        window.splitDockWidget(docks["field_map"], docks["elements"], Qt.Orientation.Vertical)
        for before, after in pairwise(name for name in docks if name not in _ALONE):
            window.tabifyDockWidget(docks[before], docks[after])
        self.hide("agreement")  # until there is a second annotator
        docks["elements"].raise_()
        window.resizeDocks(
            [docks["frames"], docks["field_map"]], [245, 300], Qt.Orientation.Horizontal
        )
        window.resizeDocks(
            [docks["field_map"], docks["elements"]], [260, 400], Qt.Orientation.Vertical
        )
        self.show_whole_tabs()

    def show(self, name: str) -> None:
        """Open a dock and bring it to the front of its tabs."""
        self.by_name[name].show()
        self.by_name[name].raise_()
        self.show_whole_tabs()

    def hide(self, name: str) -> None:
        """Close a dock."""
        self.by_name[name].hide()

    def show_whole_tabs(self) -> None:
        """Whole words of some panels, with arrows to the rest, rather than "Ca..." of all."""
        direct = Qt.FindChildOption.FindDirectChildrenOnly
        for bar in self._window.findChildren(QTabBar, options=direct):
            bar.setElideMode(Qt.TextElideMode.ElideNone)
            bar.setUsesScrollButtons(True)

    def hide_all(self) -> None:
        """Close every dock, until `bring_back`."""
        self._open = self.state()
        for dock in self.by_name.values():
            dock.hide()

    def bring_back(self) -> None:
        """Open the docks that were open."""
        self.restore(self._open)

    def state(self) -> QByteArray:
        """The arrangement, to be remembered."""
        return self._window.saveState(_VERSION)

    def restore(self, state: QByteArray) -> bool:
        """Arrange the docks as they were; False, and nothing done, if that was another version."""
        return self._window.restoreState(state, _VERSION)
