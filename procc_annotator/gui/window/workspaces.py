"""Workspaces: docks of panels, and the buttons that switch them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import asdict, dataclass, replace
from functools import partial
from itertools import pairwise

import msgspec
from PySide6.QtCore import QByteArray, QObject, Qt, Signal
from PySide6.QtWidgets import (
    QDockWidget,
    QMainWindow,
    QStyle,
    QTabBar,
    QToolButton,
    QWidget,
)

from procc_annotator.gui.panels.widgets import hbox, named
from procc_annotator.gui.state.visible_update import VisibleUpdate
from procc_annotator.gui.window.menus import Actions
from procc_annotator.translation import tr, word

_LEFT = Qt.DockWidgetArea.LeftDockWidgetArea
_RIGHT = Qt.DockWidgetArea.RightDockWidgetArea
_VERSION = 8  # of the arrangement; what another version saved is not restored
_FRAMES_WIDTH = 17  # lines of text: 255 px at the usual font
_WIDTHS = {"annotate": 16, "judge": 26, "review": 20}  # of the right column, lines of text
_LEAST_OF_WINDOW, _MOST_OF_WINDOW = 0.19, 0.4  # of its width, for a column
_MAP_SHAPE = 0.66  # height of a soccer field with its surroundings, of its width
_NARROWEST = 200  # px; below that texts are cut off

TITLES = {
    "frames": word("Frames"),
    "field_map": word("Field map"),
    "elements": word("Elements"),
    "cameras": word("Cameras"),
    "scores": word("Scores"),
    "fit": word("Fit"),
    "findings": word("Check"),
    "landmarks": word("Landmarks"),
    "plots": word("Plots"),
    "review": word("Review"),
    "agreement": word("Agreement"),
}
WORKSPACES: Mapping[str, tuple[str, ...]] = {
    "annotate": ("elements", "findings", "landmarks"),
    "judge": ("scores", "cameras", "fit", "plots"),
    "review": ("review", "agreement"),
}
_LISTED = "review"  # the workspace that begins with the list of frames instead of the strip
_LATER = "agreement"  # shown once there is a second annotator


@dataclass(frozen=True, slots=True)
class _Look:
    """Open docks and sizes of a workspace.

    Attributes:
        open: its docks that are not closed.
        front: the one in front of its tabs.
        frames: whether the list of frames is shown instead of the strip.
        width, map_height: of the column and of the field map above it, px; 0 where it is not shown.
    """

    open: tuple[str, ...]
    front: str
    frames: bool = False
    width: int = 0
    map_height: int = 0


def _catch_up(panel: QWidget, in_sight: bool) -> None:
    """A panel that comes to the front of its tabs shows what it missed behind them."""
    if in_sight:
        for refresher in panel.findChildren(VisibleUpdate):
            refresher.catch_up()


class Workspaces(QObject):
    """The docks of the window's panels, workspace by workspace; ``by_name``: one for each panel."""

    turned = Signal(str)  # which workspace is in sight
    allHidden = Signal(bool)  # every panel is hidden on purpose, or no longer

    def __init__(
        self,
        window: QMainWindow,
        panels: Mapping[str, QWidget],
        canvas: QWidget,
        entrances: Mapping[str, Callable[[], None]],
    ) -> None:
        """Dock panels, by name as in `TITLES`, in the window; the canvas gets the keyboard focus
        when they are closed. Entrances put it where text is entered in a panel."""
        super().__init__(window)
        self._window, self._canvas, self._entrances = window, canvas, entrances
        self._open = QByteArray()
        self._hidden = False
        self.by_name: dict[str, QDockWidget] = {}
        for name, title in TITLES.items():
            dock = QDockWidget(tr(title), window)
            dock.setObjectName(f"dock_{name}")
            dock.setWidget(panels[name])
            panels[name].setMinimumWidth(_NARROWEST)
            dock.visibilityChanged.connect(partial(_catch_up, panels[name]))
            self.by_name[name] = dock
        self.workspace = next(iter(WORKSPACES))
        self._looks: dict[str, _Look] = {}
        self._sized_late = True  # the window is not shown yet
        self.arrange()

    def arrange(self) -> None:
        """The layout the window starts with."""
        window, docks = self._window, self.by_name
        window.setDockNestingEnabled(True)
        for name, dock in docks.items():
            dock.setFloating(False)
            dock.hide()  # one above the other they would need more height than the window has
            window.addDockWidget(_LEFT if name == "frames" else _RIGHT, dock)
        window.splitDockWidget(docks["field_map"], docks["elements"], Qt.Orientation.Vertical)
        for before, after in pairwise(n for names in WORKSPACES.values() for n in names):
            window.tabifyDockWidget(docks[before], docks[after])
        self._looks = {workspace: _first_look(workspace) for workspace in WORKSPACES}
        self.workspace = next(iter(WORKSPACES))
        docks["field_map"].show()
        self._show_workspace()

    def settle(self) -> None:
        """The window has its size: the docks take theirs, unless they came back with them."""
        if self._sized_late:
            self._sized_late = False
            self._resize(self._looks[self.workspace])

    def reset_layout(self) -> None:
        """Forget the arrangement of panels."""
        self._set_hidden(False)
        self.arrange()

    # --- workspaces ---------------------------------------------------------------------------

    def turn_to(self, workspace: str) -> None:
        """Show the panels of one kind of work as they were left; a torn off panel stays."""
        self._unhide()
        self._turn_to(workspace)
        self.turned.emit(workspace)  # a tick that was taken away by hand comes back

    def _turn_to(self, workspace: str) -> None:
        if workspace != self.workspace:
            self._looks[self.workspace] = self._look()
            self.workspace = workspace
            self._show_workspace()

    def _show_workspace(self) -> None:
        look, docks = self._looks[self.workspace], self.by_name
        for workspace, names in WORKSPACES.items():
            for name in names:
                if not docks[name].isFloating():
                    docks[name].setVisible(workspace == self.workspace and name in look.open)
        if not docks["frames"].isFloating():
            docks["frames"].setVisible(look.frames)
        if look.front in look.open:
            docks[look.front].raise_()
        self._resize(look)
        self.show_whole_tabs()
        self.turned.emit(self.workspace)

    def _resize(self, look: _Look) -> None:
        """Give the columns the sizes they were left with, or those they have at first."""
        window, line = self._window, self._window.fontMetrics().height()
        frames, above, below = (self.by_name[n] for n in ("frames", "field_map", look.front))
        most = round(_MOST_OF_WINDOW * window.width())
        asked = _WIDTHS[self.workspace] * line, self._width_of_tabs(look.open)
        width = look.width or min(most, max(*asked, round(_LEAST_OF_WINDOW * window.width())))
        window.resizeDocks([above, below], [width, width], Qt.Orientation.Horizontal)
        if not look.width:
            window.resizeDocks(
                [frames], [min(most, _FRAMES_WIDTH * line)], Qt.Orientation.Horizontal
            )
        highest = window.height() // 3
        height = look.map_height or min(highest, round(width * _MAP_SHAPE) + 3 * line)
        rest = max(1, window.height() - height)
        window.resizeDocks([above, below], [height, rest], Qt.Orientation.Vertical)

    def _width_of_tabs(self, names: Collection[str]) -> int:
        around = self._window.style().pixelMetric(QStyle.PixelMetric.PM_TabBarTabHSpace)
        advance = self._window.fontMetrics().horizontalAdvance
        return sum(advance(self.by_name[name].windowTitle()) + around + 1 for name in names)

    def _look(self) -> _Look:
        docks = self.by_name
        names = WORKSPACES[self.workspace]
        opened = tuple(name for name in names if not docks[name].isHidden())
        shown = [n for n in opened if not docks[n].visibleRegion().isEmpty()]
        front = (shown or opened or names)[0]
        field_map = docks["field_map"]
        height = 0 if field_map.isHidden() or field_map.isFloating() else field_map.height()
        width = docks[front].width() if opened and not docks[front].isFloating() else 0
        return _Look(opened, front, not docks["frames"].isHidden(), width, height)

    def show(self, name: str) -> None:
        """Open a dock in its workspace and bring it to the front of its tabs."""
        self._unhide()
        dock = self.by_name[name]
        found = (n for n, panels in WORKSPACES.items() if name in panels)
        workspace = next(found, self.workspace)
        if not dock.isFloating():
            self._turn_to(workspace)
        dock.show()
        dock.raise_()
        self.show_whole_tabs()

    def show_unless_hidden(self, name: str) -> None:
        """The same, unless all panels are hidden on purpose."""
        if not self._hidden:
            self.show(name)

    def enter(self, name: str) -> None:
        """Open a panel and put the keyboard focus where text is entered in it."""
        self.show(name)
        self._entrances[name]()

    def toggle(self, name: str) -> None:
        """Bring a panel into sight, a torn off one to the front; close one that is in sight."""
        dock = self.by_name[name]
        if dock.visibleRegion().isEmpty() or dock.isFloating():
            self.show(name)
        else:
            self._canvas.setFocus()
            dock.hide()

    def show_whole_tabs(self) -> None:
        """Whole words of some panels, with arrows to the rest, rather than "Ca..." of all."""
        direct = Qt.FindChildOption.FindDirectChildrenOnly
        for bar in self._window.findChildren(QTabBar, options=direct):
            bar.setElideMode(Qt.TextElideMode.ElideNone)
            bar.setUsesScrollButtons(True)

    def hide_all(self, hidden: bool) -> None:
        """Close every dock, or open those again that were open."""
        self._set_hidden(hidden)
        if hidden:
            self._open = self.state()
            self._canvas.setFocus()  # first: Qt would pass the focus from dock to dock
            for dock in self.by_name.values():
                dock.hide()
        else:
            self.restore(self._open)

    def _unhide(self) -> None:
        if self._hidden:
            self.hide_all(False)

    def _set_hidden(self, hidden: bool) -> None:
        self._hidden = hidden
        self.allHidden.emit(hidden)

    def state(self) -> QByteArray:
        """The arrangement, to be remembered."""
        return self._window.saveState(_VERSION)

    def kept(self) -> dict[str, object]:
        """Return how every workspace looks and which one is in sight, to be remembered."""
        looks = self._looks | {self.workspace: self._look()}
        return {"desk": self.workspace, **{name: asdict(look) for name, look in looks.items()}}

    def restore_kept(self, kept: Mapping[str, object]) -> None:
        """Restore the workspaces; what cannot be read stays as it is at first."""
        for workspace in WORKSPACES:
            if (look := _look_of(workspace, kept.get(workspace))) is not None:
                self._looks[workspace] = look
        if (last := kept.get("desk")) in WORKSPACES:
            self.workspace = str(last)
        self._show_workspace()

    def restore(self, state: QByteArray) -> bool:
        """Arrange the docks as they were; False, and nothing done, if that was another version."""
        restored = self._window.restoreState(state, _VERSION)
        self._sized_late = self._sized_late and not restored
        return restored


def _first_look(workspace: str) -> _Look:
    names = WORKSPACES[workspace]
    return _Look(tuple(n for n in names if n != _LATER), names[0], workspace == _LISTED)


def _look_of(workspace: str, kept: object) -> _Look | None:
    """Return a look as it was kept, without unknown docks; None if it cannot be read. A panel that
    waits for something to be opened is closed until then."""
    try:
        look = msgspec.convert(kept, _Look)
    except msgspec.ValidationError:
        return None
    names = [n for n in WORKSPACES[workspace] if n in look.open and n != _LATER]
    front = look.front if look.front in names else (names or WORKSPACES[workspace])[0]
    return replace(look, open=tuple(names), front=front)


_TITLES = {
    "annotate": word("Annotate", "desk"),
    "judge": word("Judge", "desk"),
    "review": word("Review", "desk"),
}


class WorkspaceSwitch(QWidget):
    """Buttons of the actions that turn to a workspace."""

    def __init__(self, actions: Actions) -> None:
        super().__init__()
        self.setObjectName("deskSwitch")
        row = hbox(spacing=2, margins=0)
        for workspace in WORKSPACES:
            action = actions[f"desk_{workspace}"]
            action.setIconText(tr(_TITLES[workspace], "desk"))
            button = named(QToolButton(autoRaise=True), f"desk_{workspace}")
            button.setDefaultAction(action)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
            row.addWidget(button)
        self.setLayout(row)
