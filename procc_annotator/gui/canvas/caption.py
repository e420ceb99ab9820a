"""Words in the lower left corner of a picture that is written to a file."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter


def paint_caption(painter: QPainter, text: str, area: QRectF, unit: float, font_px: int) -> None:
    """Paint a line of words on a dark band; nothing for none.

    Args:
        area: of the picture, px of the painter.
        unit: px of a point.
        font_px: height of the letters.
    """
    if not text:
        return
    font = QFont()
    font.setPixelSize(font_px)
    metrics = QFontMetricsF(font)
    band = QRectF(0, 0, metrics.horizontalAdvance(text) + 16 * unit, metrics.height() + 8 * unit)
    band.moveBottomLeft(area.bottomLeft())
    painter.fillRect(band, QColor(32, 32, 32, 200))
    painter.setFont(font)
    painter.setPen(QColor("white"))
    painter.drawText(band, Qt.AlignmentFlag.AlignCenter, text)
