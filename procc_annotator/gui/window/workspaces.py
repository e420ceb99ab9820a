"""Workspaces: docks of panels, the tab bar that switches them, the drawer of plots."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace
from functools import partial
from itertools import pairwise

import msgspec
from PySide6.QtCore import QByteArray, QEvent, QObject, Qt, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QDockWidget,
    QMainWindow,
    QSizePolicy,
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
_BOTTOM = Qt.DockWidgetArea.BottomDockWidgetArea
_VERSION = 7  # of the arrangement; what another version saved is not restored
_FRAMES_WIDTH, _INSPECTOR_WIDTH = 17, 23  # lines of text: 240 and 320 px at the usual font
_MOST_OF_WINDOW = 0.48  # what both may take of its width
_NARROWEST_FRAMES, _NARROWEST_PANEL = 190, 230  # below that texts are cut off

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
_ALONE = ("frames", "field_map")  # the others share a column as tabs, workspace by workspace
WORKSPACES: Mapping[str, tuple[str, ...]] = {
    "annotate": ("elements", "findings", "landmarks"),
    "judge": ("scores", "cameras", "fit", "plots"),
    "review": ("review", "agreement"),
}
_PLOTS = "plots"  # in a drawer below the picture, which is shut at first
_LATER = "agreement"  # shown once there is a second annotator
_DRAWER_HEIGHT = 0.38  # of the window's height


@dataclass(frozen=True, slots=True)
class _Look:
    """Open docks and sizes of a workspace.

    Attributes:
        open: its docks that are not closed.
        front: the one in front of its tabs.
        width, map_height: of the column and of the field map above it, px; 0 where it is not shown.
        drawer_height: of what is below the picture, px; 0 where it was not seen yet.
    """

    open: tuple[str, ...]
    front: str
    width: int = 0
    map_height: int = 0
    drawer_height: int = 0


def _catch_up(panel: QWidget, in_sight: bool) -> None:
    """A panel that comes to the front of its tabs shows what it missed behind them."""
    if in_sight:
        for refresher in panel.findChildren(VisibleUpdate):
            refresher.catch_up()


class Workspaces(QObject):
    """The docks of the window's panels, workspace by workspace.

    Attributes:
        by_name: one dock for each panel.
        workspace: the one in sight.
    """

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
            narrowest = _NARROWEST_FRAMES if name == "frames" else _NARROWEST_PANEL
            panels[name].setMinimumWidth(narrowest)
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
        # The drawer is as wide as the picture, and leaves the columns next to it their height.
        window.setCorner(Qt.Corner.BottomLeftCorner, _LEFT)
        window.setCorner(Qt.Corner.BottomRightCorner, _RIGHT)
        for name, dock in docks.items():
            dock.setFloating(False)
            dock.hide()  # one above the other they would need more height than the window has
            window.addDockWidget(_area_of(name), dock)
        window.splitDockWidget(docks["field_map"], docks["elements"], Qt.Orientation.Vertical)
        in_tabs = [n for names in WORKSPACES.values() for n in names if n != _PLOTS]
        for before, after in pairwise(in_tabs):
            window.tabifyDockWidget(docks[before], docks[after])
        self._looks = {workspace: _first_look(workspace) for workspace in WORKSPACES}
        self.workspace = next(iter(WORKSPACES))
        for name in _ALONE:
            docks[name].show()
        self._show_workspace()
        self._take_first_sizes()

    def settle(self) -> None:
        """The window has its size: the docks take theirs, unless they came back with them."""
        if self._sized_late:
            self._sized_late = False
            self._take_first_sizes()

    def _take_first_sizes(self) -> None:
        window, docks = self._window, self.by_name
        most = _MOST_OF_WINDOW * window.width() / (_FRAMES_WIDTH + _INSPECTOR_WIDTH)
        line = min(float(window.fontMetrics().height()), most)
        window.resizeDocks(
            [docks["frames"], docks["field_map"]],
            [round(_FRAMES_WIDTH * line), round(_INSPECTOR_WIDTH * line)],
            Qt.Orientation.Horizontal,
        )
        window.resizeDocks(
            [docks["field_map"], docks["elements"]], [260, 400], Qt.Orientation.Vertical
        )

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
        if look.front in look.open:
            docks[look.front].raise_()
            if look.width:
                self._resize(look)
        self._resize_drawer(look.drawer_height)
        self.show_whole_tabs()
        self.turned.emit(self.workspace)

    def _resize(self, look: _Look) -> None:
        above, below = self.by_name["field_map"], self.by_name[look.front]
        self._window.resizeDocks([below], [look.width], Qt.Orientation.Horizontal)
        if look.map_height:
            self._window.resizeDocks([above], [look.map_height], Qt.Orientation.Vertical)

    def _resize_drawer(self, height: int = 0) -> None:
        """Have the drawer so high, px; 0: as it is at first."""
        drawer = self.by_name[_PLOTS]
        if not drawer.isHidden():
            height = height or round(_DRAWER_HEIGHT * self._window.height())
            self._window.resizeDocks([drawer], [height], Qt.Orientation.Vertical)

    def _look(self) -> _Look:
        docks = self.by_name
        names = WORKSPACES[self.workspace]
        opened = tuple(name for name in names if not docks[name].isHidden())
        in_tabs = [n for n in opened if n != _PLOTS]
        shown = [n for n in in_tabs if not docks[n].visibleRegion().isEmpty()]
        front = shown[0] if shown else (in_tabs or names)[0]
        field_map = docks["field_map"]
        height = 0 if field_map.isHidden() or field_map.isFloating() else field_map.height()
        width = docks[front].width() if opened and not docks[front].isFloating() else 0
        drawer = self._looks[self.workspace].drawer_height
        if _PLOTS in opened:
            drawer = docks[_PLOTS].height()
        return _Look(opened, front, width, height, drawer)

    def show(self, name: str) -> None:
        """Open a dock in its workspace and bring it to the front of its tabs."""
        self._unhide()
        dock = self.by_name[name]
        found = (n for n, panels in WORKSPACES.items() if name in panels)
        workspace = next(found, self.workspace)
        if not dock.isFloating():
            self._turn_to(workspace)
        opens = dock.isHidden() and name == _PLOTS
        dock.show()
        dock.raise_()
        if opens:
            self._resize_drawer(self._looks[workspace].drawer_height)
        self.show_whole_tabs()

    def show_unless_hidden(self, name: str) -> None:
        """The same, unless all panels are hidden on purpose."""
        if not self._hidden:
            self.show(name)

    def enter(self, name: str) -> None:
        """Open a panel and put the keyboard focus where text is entered in it."""
        self.show(name)
        self._entrances[name]()

    def toggle_plots(self) -> None:
        """Open the plots below the picture, or close them; a torn off panel comes to the front."""
        dock = self.by_name[_PLOTS]
        if dock.isHidden() or dock.isFloating():
            self.show(_PLOTS)
            return
        self._looks[self.workspace] = self._look()  # as high it opens again
        dock.hide()
        self._canvas.setFocus()

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
            for dock in self.by_name.values():
                dock.hide()
            self._canvas.setFocus()
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
    return _Look(tuple(name for name in names if name not in (_LATER, _PLOTS)), names[0])


def _area_of(name: str) -> Qt.DockWidgetArea:
    if name == _PLOTS:
        return _BOTTOM
    return _LEFT if name == "frames" else _RIGHT


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
_ROOM = 6  # px around the words, as menus have


class WorkspaceSwitch(QWidget):
    """Buttons of the actions that turn to a workspace."""

    def __init__(self, window: QMainWindow, actions: Actions) -> None:
        super().__init__(window)
        self.setObjectName("deskSwitch")
        row = hbox(spacing=2, margins=(0, 0, 4, 0))
        for workspace in WORKSPACES:
            action = actions[f"desk_{workspace}"]
            action.setIconText(tr(_TITLES[workspace], "desk"))
            button = named(QToolButton(autoRaise=True), f"desk_{workspace}")
            button.setDefaultAction(action)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
            row.addWidget(button)
        self.setLayout(row)
        self._lower_buttons()
        if window.menuBar().isNativeMenuBar():  # on macOS it has no corner
            bar = window.addToolBar(tr("Desks"))
            bar.setObjectName("desks")
            bar.addWidget(self)
        else:
            window.menuBar().setCornerWidget(self)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._lower_buttons()

    def _lower_buttons(self) -> None:
        for button in self.findChildren(QToolButton):
            button.setMaximumHeight(self.fontMetrics().height() + _ROOM)


class PlotsHandle(QToolButton):
    """A strip across the foot of the picture while one judges; pulled, the drawer opens or shuts.

    What is torn off is no drawer any more: the handle brings it to the front.
    """

    def __init__(self, workspaces: Workspaces, action: QAction) -> None:
        """Show the keys of an action that does the same."""
        super().__init__()
        self.setObjectName("drawerHandle")
        self._workspaces, self._action = workspaces, action
        self._dock = workspaces.by_name[_PLOTS]
        self.setAutoRaise(True)
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.clicked.connect(action.trigger)
        for changed in (self._dock.visibilityChanged, workspaces.turned, action.changed):
            changed.connect(self._show_state)
        self._show_state()

    def _show_state(self) -> None:
        self.setVisible(_PLOTS in WORKSPACES[self._workspaces.workspace])
        title, keys = tr("Plots"), self._action.shortcut().toString()
        self.setText(f"{title}  {keys}" if keys else title)
        shut = self._dock.isHidden() or self._dock.isFloating()
        self.setArrowType(Qt.ArrowType.UpArrow if shut else Qt.ArrowType.DownArrow)
        words = tr("Open the plots below the picture") if shut else tr("Shut the plots")
        self.setToolTip(words)
        self.setAccessibleName(words)
