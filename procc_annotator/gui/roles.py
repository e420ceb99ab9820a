"""Accessible roles of self-painted widgets, which Qt calls a client area only."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QAccessibleWidget, QWidget

_WHEN = (QEvent.Type.Show, QEvent.Type.FocusIn)


class _Role(QObject):
    """Reports what a widget is, when it is shown and whenever the keyboard comes to it.

    Qt keeps what is given by an object and its class, and the class becomes another one each time a
    method of Python is first connected: what was set before that is not read any more.
    """

    def __init__(self, widget: QWidget, role: QAccessible.Role) -> None:
        super().__init__(widget)
        self._widget, self._role = widget, role
        self._told: list[QAccessibleWidget] = []  # Qt deletes them with the widget
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in _WHEN and watched is self._widget:
            self._tell()
        return False

    def _tell(self) -> None:
        known = QAccessible.queryAccessibleInterface(self._widget)
        if known is None or known.role() != self._role:
            told = QAccessibleWidget(self._widget, self._role, "")
            QAccessible.registerAccessibleInterface(told)
            self._told.append(told)


def give_role(widget: QWidget, role: QAccessible.Role) -> None:
    """Have a widget exposed as something; its name and description are its own."""
    _Role(widget, role)
