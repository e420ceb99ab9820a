"""The signs of findings: the same on the picture, in lists and on the field map."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPen, QPixmap, QPolygonF

from procc_annotator.calibration.label_check.finding import Severity
from procc_annotator.interaction.palette import FINDING, OUTLINE

_SIDE = 16


def paint_finding_sign(painter: QPainter, box: QRectF, severity: Severity) -> None:
    """Draw the sign of a severity into a square.

    Distinguished without colour: a full triangle is an error, a hollow one a warning, a circle
        a hint.
    """
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    side = min(box.width(), box.height())
    tone, dark = QColor(FINDING), QColor(OUTLINE)
    full = severity is Severity.ERROR
    outline = _circle if severity is Severity.HINT else _triangle
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(dark)
    outline(painter, box, 0.0)
    painter.setBrush(tone)
    outline(painter, box, 0.06 * side)
    if not full:
        painter.setBrush(dark)
        outline(painter, box, 0.14 * side)
    pen = QPen(dark if full else tone, 0.12 * side)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    painter.setPen(pen)
    x, y = box.center().x(), box.center().y()
    if severity is Severity.HINT:  # an i
        painter.drawLine(QPointF(x, y - 0.02 * side), QPointF(x, y + 0.22 * side))
        painter.drawPoint(QPointF(x, y - 0.22 * side))
    elif full:  # an exclamation mark
        painter.drawLine(QPointF(x, y - 0.12 * side), QPointF(x, y + 0.1 * side))
        painter.drawPoint(QPointF(x, y + 0.29 * side))
    else:  # there is no room for more
        painter.drawPoint(QPointF(x, y + 0.16 * side))
    painter.restore()


def finding_icon(severity: Severity, dpr: float) -> QIcon:
    """The sign as an icon, the same in a selected row."""
    pixmap = QPixmap(round(_SIDE * dpr), round(_SIDE * dpr))
    pixmap.setDevicePixelRatio(dpr)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    paint_finding_sign(painter, QRectF(0.5, 0.5, _SIDE - 1, _SIDE - 1), severity)
    painter.end()
    icon = QIcon(pixmap)
    for mode in (QIcon.Mode.Selected, QIcon.Mode.Active):
        icon.addPixmap(pixmap, mode)  # or the style would tint it
    return icon


def _triangle(painter: QPainter, box: QRectF, inset: float) -> None:
    """Each side moved inwards by ``inset``."""
    side = min(box.width(), box.height())
    x, top, bottom = (
        box.center().x(),
        box.center().y() - 0.48 * side,
        box.center().y() + 0.46 * side,
    )
    # Its slopes are 1 across to 1.88 down; so much a move inwards takes off tip and corners.
    tip, corner = 2.13 * inset, 1.66 * inset
    painter.drawPolygon(
        QPolygonF(
            [
                QPointF(x, top + tip),
                QPointF(x + 0.5 * side - corner, bottom - inset),
                QPointF(x - 0.5 * side + corner, bottom - inset),
            ]
        )
    )


def _circle(painter: QPainter, box: QRectF, inset: float) -> None:
    radius = 0.48 * min(box.width(), box.height()) - inset
    painter.drawEllipse(box.center(), radius, radius)
