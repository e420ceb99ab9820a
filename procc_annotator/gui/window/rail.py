"""The rail at the left edge: what the hand does, and what helps it, as icons with their keys."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeySequence, QResizeEvent
from PySide6.QtWidgets import QMenu, QToolBar, QToolButton, QWidgetAction

from procc_annotator.gui.canvas.looks import LookControls
from procc_annotator.gui.keymap import NATIVE
from procc_annotator.gui.window.icon_button import IconButton
from procc_annotator.gui.window.menus import Actions
from procc_annotator.translation import tr

# Icon, action, and whose key is shown where that has none; a None starts a new group.
_BUTTONS: tuple[tuple[str, str, str] | None, ...] = (
    ("undo", "undo", ""),
    ("redo", "redo", ""),
    None,
    ("draw", "draw_mode", "switch_mode"),
    ("edit", "edit_mode", "switch_mode"),
    ("pan", "pan", ""),
    None,
    ("snap", "snapping", ""),
    ("two_clicks", "two_clicks", ""),
    ("loupe", "loupe", ""),
    ("ghosts", "ghosts", ""),
    ("blind", "blind", ""),
)
_BETWEEN, _REST = 2, 50  # px: between two buttons; lines between groups, and the rims
_HELD = {"pan": "Space"}  # not shown


class Rail(QToolBar):
    """Buttons of the table of actions, one below the other, and of how the picture looks."""

    lookChanged = Signal(object)  # how pictures are to be shown

    def __init__(self, actions: Actions) -> None:
        super().__init__(tr("Rail"))
        self.setObjectName("rail")
        self.setMovable(False)
        self.setFloatable(False)
        self.toggleViewAction().setEnabled(False)
        self.setOrientation(Qt.Orientation.Vertical)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        self.buttons: dict[str, IconButton] = {}
        for row in _BUTTONS:
            if row is None:
                self.addSeparator()
                continue
            icon, name, key_of = row
            button = IconButton(icon, with_key=True)
            button.setObjectName(f"rail_{name}")
            other = actions[key_of] if key_of else None
            held = QKeySequence(_HELD.get(name, "")).toString(NATIVE)
            button.show_action(actions[name], other, held)
            self.buttons[name] = button
            self.addWidget(button)
        self.addSeparator()
        self._add_looks()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Where there is no room for all of them, the keys go rather than buttons."""
        super().resizeEvent(event)
        buttons = self.findChildren(IconButton)
        needed = sum(button.height_with_key() + _BETWEEN for button in buttons) + _REST
        for button in buttons:
            button.set_with_key(needed <= self.height())

    def _add_looks(self) -> None:
        """A button that opens brightness and the like."""
        self.looks = LookControls()
        self.looks.lookChanged.connect(self.lookChanged)
        menu = QMenu(self)
        action = QWidgetAction(menu)
        action.setDefaultWidget(self.looks)
        menu.addAction(action)
        button = IconButton("looks", with_key=True)
        button.setObjectName("lookButton")
        button.setAccessibleName(tr("Picture"))
        button.setToolTip(
            tr("Picture\nBrightness, contrast, gamma, line enhance: only what you see changes")
        )
        button.setMenu(menu)
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.addWidget(button)
