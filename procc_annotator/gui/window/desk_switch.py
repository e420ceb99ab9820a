"""Three words in the corner of the menus: annotate, judge, review."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QHBoxLayout, QMainWindow, QToolButton, QWidget

from procc_annotator.gui.window.docks import DESKS
from procc_annotator.gui.window.menus import Actions
from procc_annotator.translation import tr, word

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
