"""The mouse rests on a sign of the label check in the picture: what it says there."""

from __future__ import annotations

from PySide6.QtCore import QObject, QPointF
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QToolTip

from procc_annotator.annotation import points_px
from procc_annotator.dataset.review import StoredFinding
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.panels.findings.finding_rows import reasons_of
from procc_annotator.gui.state.document import Document

_REACH = 32.0  # screen px: a sign stands beside its point, on whichever side there is room


class FindingTips(QObject):
    """Answers when the canvas is asked for a tip."""

    def __init__(self, document: Document, canvas: Canvas) -> None:
        super().__init__(canvas)
        self._document, self._canvas = document, canvas
        canvas.tipWanted.connect(self._tell)

    def _tell(self, event: QHelpEvent) -> None:
        if text := self.tip_at(QPointF(event.pos())):
            QToolTip.showText(event.globalPos(), text, self._canvas.viewport())

    def tip_at(self, cursor: QPointF) -> str:
        """Return what was found at a place of the viewport; empty where no sign is."""
        if self._canvas.drawing.hidden:
            return ""
        near = [f for f in self._document.label_check.shown if self._stands_at(f, cursor)]
        return reasons_of(near)

    def _stands_at(self, found: StoredFinding, cursor: QPointF) -> bool:
        size, annotation = self._document.state.picture_size, self._document.state.annotation
        for name, row in found.places:
            drawn = annotation.get(name)
            if drawn is None or size is None or row >= len(drawn.points):
                continue
            at = self._canvas.to_view(*points_px(drawn, size)[row].tolist())
            if (at - cursor).manhattanLength() <= _REACH:
                return True
        return False
