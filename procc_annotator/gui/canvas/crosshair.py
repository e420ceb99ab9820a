"""A cross on the picture that the arrows move: what a mouse does there, done by keys."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from procc_annotator.interaction.gestures import ARROWS, Position
from procc_annotator.interaction.palette import HALO, OUTLINE

_ARM, _GAP = 15.0, 4.0  # screen px
_BACKGROUND_WIDTH, _WIDTH = 4.0, 1.6
_ABOVE_ALL = 1000.0
_HALF_PIXEL = 0.5  # pixel (0, 0) is the scene's square from (0, 0) to (1, 1)


class Crosshair(QGraphicsItem):
    """Where the keys point; hidden while the mouse does.

    Attributes:
        px: its place in picture px; None while the mouse points.
    """

    def __init__(self) -> None:
        super().__init__()
        self.px: Position | None = None
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemIgnoresTransformations)
        self.setZValue(_ABOVE_ALL)
        self.hide()

    def put(self, px: Position | None) -> None:
        """Stand at a place of the picture, or go."""
        self.px = px
        self.setVisible(px is not None)
        if px is not None:
            self.setPos(px[0] + _HALF_PIXEL, px[1] + _HALF_PIXEL)

    def boundingRect(self) -> QRectF:
        reach = _ARM + _BACKGROUND_WIDTH
        return QRectF(-reach, -reach, 2 * reach, 2 * reach)

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: QWidget | None = None
    ) -> None:
        for colour, width in ((OUTLINE, _BACKGROUND_WIDTH), (HALO, _WIDTH)):
            painter.setPen(
                QPen(QColor(colour), width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap)
            )
            for dx, dy in ARROWS.values():
                painter.drawLine(QPointF(dx * _GAP, dy * _GAP), QPointF(dx * _ARM, dy * _ARM))


def moved(px: Position, arrow: str, step: float, size: tuple[int, int]) -> Position:
    """A place so many picture px further, within the picture."""
    dx, dy = ARROWS[arrow]
    x, y = px[0] + dx * step, px[1] + dy * step
    return min(max(x, 0.0), size[0] - 1.0), min(max(y, 0.0), size[1] - 1.0)
