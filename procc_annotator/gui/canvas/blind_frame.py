"""An amber frame around the picture and a badge while nothing of a camera is shown."""

from __future__ import annotations

from PySide6.QtCore import QObject, QRect
from PySide6.QtGui import QColor, QPainter, QPaintEvent

from procc_annotator.gui.canvas.pinned import Pinned
from procc_annotator.gui.canvas.split_view import NamePlate
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.state import State
from procc_annotator.interaction.palette import UNSURE_GHOST
from procc_annotator.translation import tr, word

_WIDTH = 3  # screen px of the frame
_BESIDE = 8
_WORDS = word("Blind: no camera is shown before Ctrl+Enter")
_COMMITTED = word("Blind mode, this frame is committed")


class BlindFrame(QObject):
    """Four edges and a badge; none of them takes the mouse or moves the picture."""

    def __init__(self, document: Document, view: PictureView) -> None:
        viewport = view.viewport()
        super().__init__(viewport)
        self._viewport, self._store = viewport, document.store
        self.edges = [_Edge(viewport, f"blindEdge{i}") for i in range(4)]  # not shown
        self.badge = NamePlate(viewport, "blindBadge")
        view.resized.connect(self._stand_if_shown)
        document.store.watch(_shown, self._show)
        self._show()

    def _stand_if_shown(self) -> None:
        if not self.badge.isHidden():
            self._stand()

    def _show(self) -> None:
        blind, committed = _shown(self._store.state)
        self.badge.say(tr(_COMMITTED if committed else _WORDS), UNSURE_GHOST)
        for part in (*self.edges, self.badge):
            part.setVisible(blind)
        if blind:
            self._stand()

    def _stand(self) -> None:
        width, height = self._viewport.width(), self._viewport.height()
        boxes = (
            QRect(0, 0, width, _WIDTH),
            QRect(0, height - _WIDTH, width, _WIDTH),
            QRect(0, 0, _WIDTH, height),
            QRect(width - _WIDTH, 0, _WIDTH, height),
        )
        for edge, box in zip(self.edges, boxes, strict=True):
            edge.put(box)
        size = self.badge.wanted_size()
        size.setWidth(min(size.width(), width - 2 * _BESIDE))
        left = width - size.width() - _BESIDE
        self.badge.put(QRect(left, height - size.height() - _BESIDE, size.width(), size.height()))


class _Edge(Pinned):
    """A plain strip."""

    def paintEvent(self, event: QPaintEvent) -> None:
        QPainter(self).fillRect(self.rect(), QColor(UNSURE_GHOST))


def _shown(state: State) -> tuple[bool, bool]:
    """Return whether the mode is on while a frame is on screen, and whether that frame is
    committed."""
    return state.blind and state.frame is not None, state.projection_visible
