"""Workspaces: docks of panels, the tab bar that switches them, the drawer of plots."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from functools import partial
from itertools import pairwise

from PySide6.QtCore import QByteArray, QEvent, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QDockWidget,
    QHBoxLayout,
    QMainWindow,
    QSizePolicy,
    QTabBar,
    QToolButton,
    QWidget,
)

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
_ALONE = ("frames", "field_map")  # the others share a column as tabs, desk by desk
DESKS: Mapping[str, tuple[str, ...]] = {
    "annotate": ("elements", "findings", "landmarks"),
    "judge": ("scores", "cameras", "fit", "plots"),
    "review": ("review", "agreement"),
}
_BELOW = frozenset(["plots"])  # in a drawer below the picture, which is shut at first
_LATER = frozenset(["agreement"])  # until there is a second annotator
_DRAWER_HEIGHT = 0.38  # of the window's height


@dataclass(frozen=True, slots=True)
class DeskLook:
    """How a desk was left.

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


class Docks:
    """The window's docks by name.

    Attributes:
        by_name: one for each panel.
        desk: the one in sight.
        turned: called with which desk is in sight after another was.
    """

    def __init__(self, window: QMainWindow, panels: Mapping[str, QWidget]) -> None:
        self._window = window
        self.turned: Callable[[str], object] = _nobody
        self._open = QByteArray()
        self.by_name: dict[str, QDockWidget] = {}
        for name, title in TITLES.items():
            dock = QDockWidget(tr(title), window)
            dock.setObjectName(f"dock_{name}")
            dock.setWidget(panels[name])
            narrowest = _NARROWEST_FRAMES if name == "frames" else _NARROWEST_PANEL
            panels[name].setMinimumWidth(narrowest)
            dock.visibilityChanged.connect(partial(_catch_up, panels[name]))
            self.by_name[name] = dock
        self.desk = next(iter(DESKS))
        self._looks: dict[str, DeskLook] = {}
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
        in_tabs = [name for desk in DESKS.values() for name in desk if name not in _BELOW]
        for before, after in pairwise(in_tabs):
            window.tabifyDockWidget(docks[before], docks[after])
        self._looks = {desk: _first_look(desk) for desk in DESKS}
        self.desk = next(iter(DESKS))
        for name in _ALONE:
            docks[name].show()
        self._show_desk()
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

    # --- desks --------------------------------------------------------------------------------

    def turn_to(self, desk: str) -> None:
        """Show the panels of one kind of work as they were left; a torn off panel stays."""
        if desk != self.desk:
            self._looks[self.desk] = self._look()
            self.desk = desk
            self._show_desk()

    def _show_desk(self) -> None:
        look, docks = self._looks[self.desk], self.by_name
        for desk, names in DESKS.items():
            for name in names:
                if not docks[name].isFloating():
                    docks[name].setVisible(desk == self.desk and name in look.open)
        if look.front in look.open:
            docks[look.front].raise_()
            if look.width:
                self._resize(look)
        self._resize_drawer(look.drawer_height)
        self.show_whole_tabs()
        self.turned(self.desk)

    def _resize(self, look: DeskLook) -> None:
        above, below = self.by_name["field_map"], self.by_name[look.front]
        self._window.resizeDocks([below], [look.width], Qt.Orientation.Horizontal)
        if look.map_height:
            self._window.resizeDocks([above], [look.map_height], Qt.Orientation.Vertical)

    def _resize_drawer(self, height: int = 0) -> None:
        """Have the drawer so high, px; 0: as it is at first."""
        drawers = [d for name in _BELOW if not (d := self.by_name[name]).isHidden()]
        height = height or round(_DRAWER_HEIGHT * self._window.height())
        if drawers:
            sizes = [height] * len(drawers)
            self._window.resizeDocks(drawers, sizes, Qt.Orientation.Vertical)

    def _look(self) -> DeskLook:
        docks = self.by_name
        names = DESKS[self.desk]
        opened = tuple(name for name in names if not docks[name].isHidden())
        in_tabs = [n for n in opened if n not in _BELOW]
        shown = [n for n in in_tabs if not docks[n].visibleRegion().isEmpty()]
        front = shown[0] if shown else (in_tabs or names)[0]
        field_map = docks["field_map"]
        height = 0 if field_map.isHidden() or field_map.isFloating() else field_map.height()
        width = docks[front].width() if opened and not docks[front].isFloating() else 0
        drawer = self._looks[self.desk].drawer_height
        for name in _BELOW & set(opened):
            drawer = docks[name].height()
        return DeskLook(opened, front, width, height, drawer)

    def show(self, name: str) -> None:
        """Open a dock, turning to its desk, and bring it to the front of its tabs."""
        dock = self.by_name[name]
        desk = next((desk for desk, names in DESKS.items() if name in names), self.desk)
        if not dock.isFloating():
            self.turn_to(desk)
        opens = dock.isHidden() and name in _BELOW
        dock.show()
        dock.raise_()
        if opens:
            self._resize_drawer(self._looks[desk].drawer_height)
        self.show_whole_tabs()

    def hide(self, name: str) -> None:
        """Close a dock."""
        if name in _BELOW and self.by_name[name].isVisible():
            self._looks[self.desk] = self._look()  # as high it opens again
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

    def desks(self) -> dict[str, object]:
        """Return how every desk looks and which one is in sight, to be remembered."""
        looks = self._looks | {self.desk: self._look()}
        return {"desk": self.desk, **{name: asdict(look) for name, look in looks.items()}}

    def restore_desks(self, kept: Mapping[str, object]) -> None:
        """Have the desks look as they did; what cannot be read of it stays as it is at first."""
        for desk in DESKS:
            if (look := _look_of(desk, kept.get(desk))) is not None:
                self._looks[desk] = look
        if (last := kept.get("desk")) in DESKS:
            self.desk = str(last)
        self._show_desk()

    def restore(self, state: QByteArray) -> bool:
        """Arrange the docks as they were; False, and nothing done, if that was another version."""
        restored = self._window.restoreState(state, _VERSION)
        self._sized_late = self._sized_late and not restored
        return restored


def _nobody(_: str) -> None:
    """Nobody is notified yet."""


def _first_look(desk: str) -> DeskLook:
    names = DESKS[desk]
    return DeskLook(tuple(name for name in names if name not in _LATER | _BELOW), names[0])


def _area_of(name: str) -> Qt.DockWidgetArea:
    if name in _BELOW:
        return _BOTTOM
    return _LEFT if name == "frames" else _RIGHT


def _look_of(desk: str, kept: object) -> DeskLook | None:
    """A look as it was kept; what belongs to no dock of the desk is none. A panel that waits for
    something to be opened is closed until then."""
    if not isinstance(kept, dict) or not isinstance(kept.get("open"), list):
        return None
    names = [n for n in DESKS[desk] if n in kept["open"] and n not in _LATER]
    front = kept.get("front")
    sizes = [kept.get(name) for name in ("width", "map_height", "drawer_height")]
    width, height, drawer = (size if isinstance(size, int) else 0 for size in sizes)
    return DeskLook(
        tuple(names),
        str(front) if front in names else (names or DESKS[desk])[0],
        width,
        height,
        drawer,
    )


_TITLES = {
    "annotate": word("Annotate", "desk"),
    "judge": word("Judge", "desk"),
    "review": word("Review", "desk"),
}
_ROOM = 6  # px around the words: no more than the menus have beside them


class DeskSwitch(QWidget):
    """Buttons of the actions that turn to a desk."""

    def __init__(self, window: QMainWindow, actions: Actions) -> None:
        super().__init__(window)
        self.setObjectName("deskSwitch")
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 4, 0)
        row.setSpacing(2)
        for desk in DESKS:
            action = actions[f"desk_{desk}"]
            action.setIconText(tr(_TITLES[desk], "desk"))
            button = QToolButton()
            button.setObjectName(f"desk_{desk}")
            button.setDefaultAction(action)
            button.setAutoRaise(True)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
            row.addWidget(button)
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
