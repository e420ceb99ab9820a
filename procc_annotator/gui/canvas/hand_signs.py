"""Signs at the cursor while something is drawn: the class's colour, and what snapping does."""

from __future__ import annotations

from functools import lru_cache

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen

from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.overlay_primitives import CursorSigns

# Of the height of the text.
SWATCH, MAGNET, GAP = 0.75, 0.95, 0.4
_DIM = QColor("#a8a8a8")


def paint_swatch(painter: QPainter, box: QRectF, signs: CursorSigns) -> None:
    """A patch of the class's colour."""
    painter.setPen(QPen(QColor(tones.HALO), max(1.0, box.height() / 10)))
    painter.setBrush(QColor(signs.colour))
    painter.drawRoundedRect(box, box.height() / 6, box.height() / 6)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def paint_magnet(painter: QPainter, box: QRectF, signs: CursorSigns) -> None:
    """A magnet: filled on a line, an outline if absent, crossed out where it is off."""
    found = signs.snap == "found"
    tone = QColor(tones.HALO) if signs.snap != "off" else _DIM
    painter.save()
    painter.translate(box.topLeft())
    painter.scale(box.width(), box.height())
    painter.setPen(QPen(tone, 0.09, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
    painter.setBrush(tone if found else Qt.BrushStyle.NoBrush)
    painter.drawPath(_magnet())
    if signs.snap == "off":
        painter.drawLine(QPointF(0.05, 0.05), QPointF(0.95, 0.95))
    painter.restore()


@lru_cache(maxsize=1)
def _magnet() -> QPainterPath:
    """A horseshoe in a square of side 1."""
    path = QPainterPath(QPointF(0.15, 0.08))
    path.lineTo(0.15, 0.5)
    path.arcTo(QRectF(0.15, 0.15, 0.7, 0.7), 180, 180)
    path.lineTo(0.85, 0.08)
    path.lineTo(0.62, 0.08)
    path.lineTo(0.62, 0.5)
    path.arcTo(QRectF(0.38, 0.38, 0.24, 0.24), 0, -180)
    path.lineTo(0.38, 0.08)
    path.closeSubpath()
    return path
