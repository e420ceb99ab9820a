"""Small widgets that lie over the picture and do not move with it."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QMoveEvent
from PySide6.QtWidgets import QWidget


class Pinned(QWidget):
    """A child of the viewport that stays where it is put: a view that scrolls would take it along.

    It lets the mouse through unless it says otherwise.
    """

    def __init__(self, viewport: QWidget, name: str) -> None:
        super().__init__(viewport)
        self.setObjectName(name)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._place = QPoint()
        self.hide()

    def put(self, area: QRect) -> None:
        """Stand here from now on."""
        self._place = area.topLeft()
        self.setGeometry(area)

    def moveEvent(self, event: QMoveEvent) -> None:
        super().moveEvent(event)
        if self.pos() != self._place:
            self.move(self._place)
