"""Updates of widgets that wait until the widget can be seen."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Slot
from PySide6.QtWidgets import QWidget

from procc_annotator.gui.state.background import after_paint

_INTERVAL_MS = 60  # between updates of one widget, so that a slow one does not slow a drag


class VisibleUpdate(QObject):
    """Runs the update of a widget after the next paint, once, however often it is requested.

    Qt runs the timers of all widgets that wait before it paints the window. While a widget cannot
    be seen nothing runs; it catches up when it is shown, or its tab is brought to the front.
    """

    def __init__(
        self, widget: QWidget, update: Callable[[], None], requested: Callable[[], bool]
    ) -> None:
        """``requested``: whether a request may follow for what has changed already."""
        super().__init__(widget)
        self._widget, self._update, self._requested = widget, update, requested
        self._stale = True
        self._timer = after_paint(self, self.run)  # it also runs for a while after each update
        widget.installEventFilter(self)

    @Slot()
    def request(self) -> None:
        """Update at the next opportunity."""
        self._stale = True
        if not self._timer.isActive():
            self._timer.start(0)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()  # first: other events come while the widget is being destroyed
        if kind == QEvent.Type.Show:
            self.catch_up()
        elif kind in (QEvent.Type.Paint, QEvent.Type.Resize) and self._stale:
            self.request()
        return False

    def catch_up(self) -> None:
        """The widget is about to be seen: update before it is painted, if anything changed."""
        if (self._stale or self._requested()) and self._widget.isVisible():
            self._run()

    @Slot()
    def run(self) -> None:
        """Update now, if anything changed and the widget can be seen."""
        if self._stale and self._in_sight():
            self._run()

    def _run(self) -> None:
        self._stale = False
        self._update()
        self._timer.start(_INTERVAL_MS)

    def _in_sight(self) -> bool:
        """Return whether any of it is seen: Qt calls docks behind other tabs visible, too, and
        keeps them outside the window."""
        widget = self._widget
        if not widget.isVisible():
            return False
        window = widget.window()
        return window.rect().intersects(QRect(widget.mapTo(window, QPoint()), widget.size()))
