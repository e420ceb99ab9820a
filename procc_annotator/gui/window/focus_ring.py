"""A ring around what has the keyboard, in the window and its dialogs, once keys have led there."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QApplication, QGraphicsView, QWidget
from shiboken6 import isValid

from procc_annotator.gui.canvas.held_keys import typed_into

_WIDTH = 2
_MOVES = (QEvent.Type.Move, QEvent.Type.Resize, QEvent.Type.Show, QEvent.Type.Hide)
_WITHOUT = (Qt.WindowType.Popup, Qt.WindowType.ToolTip)


class FocusRing(QObject):
    """Four strips that lie around the widget; none of them takes the mouse, and the picture below
    is not painted anew for them."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self.widget: QWidget | None = None
        self._edges: list[_Edge] = []
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self._follow)

    @property
    def shown(self) -> bool:
        """Return whether the ring is in sight."""
        return bool(self._edges) and not self._edges[0].isHidden()

    def _follow(self, _old: QWidget | None, new: QWidget | None) -> None:
        if self.widget is not None and isValid(self.widget):
            self.widget.removeEventFilter(self)
        self.widget = None
        self._remove()
        if new is not None and self._wanted(new):
            self.widget = new
            new.installEventFilter(self)
            self._edges = [_Edge(new.window()) for _ in range(4)]
            self._stand()

    def _wanted(self, widget: QWidget) -> bool:
        """A line of text has a rim of its own; what was clicked needs no telling."""
        if QApplication.mouseButtons() != Qt.MouseButton.NoButton or typed_into(widget):
            return False
        top = widget.window()
        if top is not self._window and not self._window.isAncestorOf(top):
            return False
        if isinstance(widget, QGraphicsView):  # takes the keyboard from whoever passes over it
            return not widget.underMouse()
        return top.windowType() not in _WITHOUT

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in _MOVES:
            self._stand()
        elif event.type() in (QEvent.Type.MouseButtonPress, QEvent.Type.Enter):
            self._remove()
        return False

    def _remove(self) -> None:
        for edge in filter(isValid, self._edges):  # a dialog takes its own along
            edge.hide()
            edge.deleteLater()
        self._edges = []

    def _stand(self) -> None:
        widget = self.widget
        if widget is None or not self._edges:
            return
        at = widget.mapTo(widget.window(), QPoint(0, 0))
        box = QRect(at, widget.size()).intersected(widget.window().rect())
        boxes = (
            QRect(box.left(), box.top(), box.width(), _WIDTH),
            QRect(box.left(), box.bottom() + 1 - _WIDTH, box.width(), _WIDTH),
            QRect(box.left(), box.top(), _WIDTH, box.height()),
            QRect(box.right() + 1 - _WIDTH, box.top(), _WIDTH, box.height()),
        )
        for edge, place in zip(self._edges, boxes, strict=True):
            edge.setGeometry(place)
            edge.setVisible(widget.isVisible())
            edge.raise_()


class _Edge(QWidget):
    """A plain strip of a colour that is seen on both themes."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)

    def paintEvent(self, event: QPaintEvent) -> None:
        QPainter(self).fillRect(self.rect(), self.palette().link().color())
