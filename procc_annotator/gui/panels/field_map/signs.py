"""The signs of states on the field map: on single places, and next to lines."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPalette

from procc_annotator.gui.panels.states import ElementState, paint_symbol, state_colour
from procc_annotator.gui.theme import muted
from procc_annotator.interaction import palette as tones

_SPOT = 2.2  # radius of a single place


def paint_spot(
    painter: QPainter,
    at: QPointF,
    state: ElementState,
    palette: QPalette,
    *,
    chosen: bool,
    hovered: bool,
) -> None:
    """A single place: a dot until there is something to say of it, then the state's sign."""
    painter.setPen(Qt.PenStyle.NoPen)
    if chosen:
        for colour, radius in ((tones.OUTLINE, _SPOT + 5), (tones.HALO, _SPOT + 4)):
            painter.setBrush(QColor(colour))
            painter.drawEllipse(at, radius, radius)
    elif hovered:
        painter.setBrush(muted(palette, 0.75))
        painter.drawEllipse(at, _SPOT + 4, _SPOT + 4)
    if state is ElementState.UNTOUCHED:
        painter.setBrush(state_colour(state, palette))
        painter.drawEllipse(at, _SPOT, _SPOT)
        return
    painter.setBrush(palette.color(QPalette.ColorRole.Base))
    painter.drawEllipse(at, _SPOT + 3, _SPOT + 3)
    _paint_sign(painter, at, 2 * _SPOT + 7, state, palette)


def paint_badge(painter: QPainter, at: QPointF, state: ElementState, palette: QPalette) -> None:
    """Both solid lines bear their sign as well: tick or cross."""
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(palette.color(QPalette.ColorRole.Base))
    painter.drawEllipse(at, 5, 5)
    _paint_sign(painter, at, 11, state, palette)


def _paint_sign(
    painter: QPainter, at: QPointF, side: float, state: ElementState, palette: QPalette
) -> None:
    painter.setBrush(Qt.BrushStyle.NoBrush)
    box = QRectF(at.x() - side / 2, at.y() - side / 2, side, side)
    paint_symbol(painter, box, state, state_colour(state, palette))
