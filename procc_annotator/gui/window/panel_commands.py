"""Commands about the panels: opening one, turning to those of a kind of work, hiding them all."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QWidget

from procc_annotator.gui.window.docks import Docks
from procc_annotator.gui.window.drawer import Drawer


class PanelCommands:
    """Opens, enters and hides panels; the ticks of the menu say what is in sight."""

    def __init__(
        self,
        docks: Docks,
        drawer: Drawer,
        canvas: QWidget,
        entrances: Mapping[str, Callable[[], None]],
        action: Callable[[str], QAction],
    ) -> None:
        """
        Args:
            docks, drawer: what is opened and shut.
            canvas: takes the keyboard once panels are gone.
            entrances: panel -> what puts the keyboard where one writes in it.
            action: an action of the menus by its name; asked once the window is assembled.
        """
        self._docks, self._drawer, self._canvas = docks, drawer, canvas
        self._entrances, self._action = entrances, action

    def show(self, name: str) -> None:
        """Open a panel and bring it to the front of its tabs."""
        self._unhide()
        self._docks.show(name)

    def show_unless_hidden(self, name: str) -> None:
        """The same, unless all panels are hidden on purpose."""
        if not self._action("hide_panels").isChecked():
            self.show(name)

    def enter(self, name: str) -> None:
        """Open a panel and put the keyboard where one writes in it."""
        self.show(name)
        self._entrances[name]()

    def turn_to(self, desk: str) -> None:
        """Show the panels of one kind of work: annotate, judge or review."""
        self._unhide()
        self._docks.turn_to(desk)
        self.note_desk(desk)  # a tick that was taken away by hand comes back

    def note_desk(self, desk: str) -> None:
        """A desk came into sight."""
        self._drawer.show_for(desk)
        self._action(f"desk_{desk}").setChecked(True)

    def toggle_plots(self) -> None:
        """Open the drawer with the plots, or shut it."""
        if self._drawer.is_open and not self._docks.by_name["plots"].isFloating():
            self._docks.hide("plots")
            self._canvas.setFocus()
        else:
            self.show("plots")

    def hide_all(self, hidden: bool) -> None:
        """Hide all panels, or bring back those that were open."""
        if hidden:
            self._docks.hide_all()
            self._canvas.setFocus()
        else:
            self._docks.bring_back()

    def reset_layout(self) -> None:
        """Forget the arrangement of panels."""
        self._action("hide_panels").setChecked(False)
        self._docks.arrange()

    def _unhide(self) -> None:
        if self._action("hide_panels").isChecked():
            self._action("hide_panels").setChecked(False)
            self.hide_all(False)
