"""The band below an overlay picture that says what its colours, dashes and marks mean."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter

from procc_annotator.gui.canvas.items import paint_overlay
from procc_annotator.interaction.legend import LegendEntry
from procc_annotator.interaction.overlay_primitives import Overlay, PointMarks, Strokes

_BACKGROUND, _TEXT = QColor("#202020"), QColor("#ffffff")
# In points.
_FONT = 13.0
_SAMPLE = 36.0
_GAP = 8.0  # between a sample and its text
_MARGIN = 10.0
_BETWEEN = 22.0  # between entries of a line
_LINE = 21.0
# Other fonts than the one measured here may be wider: a browser has its own.
_SLACK = 1.08

_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


class LegendBand:
    """A heading and entries, wrapped to a width.

    Args:
        heading: one line or more above the entries; may be empty.
        entries: what to explain.
        width: px of the picture.
        unit: px per point.

    Attributes:
        height: px.
    """

    def __init__(
        self, heading: str, entries: Sequence[LegendEntry], width: int, unit: float
    ) -> None:
        self._unit = unit
        self._width = width
        self._font = QFont()
        self._font.setPixelSize(max(1, round(_FONT * unit)))
        self._metrics = QFontMetricsF(self._font)
        self._heading = self._wrapped(heading)
        self._placed: list[tuple[LegendEntry, float, int]] = []  # entry, x in px, line
        lines = self._place(entries)
        self.height = math.ceil((2 * _MARGIN + _LINE * lines) * unit)

    def _wrapped(self, text: str) -> list[str]:
        room = self._width - 2 * _MARGIN * self._unit
        lines: list[str] = []
        for word in text.split():
            longer = f"{lines[-1]} {word}" if lines else word
            if lines and self._metrics.horizontalAdvance(longer) * _SLACK <= room:
                lines[-1] = longer
            else:
                lines.append(word)
        return lines

    def _place(self, entries: Sequence[LegendEntry]) -> int:
        """Flow the entries below the heading; returns the number of lines."""
        line, x = len(self._heading), _MARGIN * self._unit
        for entry in entries:
            text = self._metrics.horizontalAdvance(entry.text) * _SLACK
            taken = (_SAMPLE + _GAP) * self._unit + text
            beyond = x + taken > self._width - _MARGIN * self._unit
            if beyond and x > _MARGIN * self._unit:
                line, x = line + 1, _MARGIN * self._unit
            self._placed.append((entry, x, line))
            x += taken + _BETWEEN * self._unit
        return line + 1 if self._placed else line

    def paint(self, painter: QPainter, top: float) -> None:
        """Paint the band with its upper edge at ``top``, device px."""
        unit = self._unit
        area = QRectF(0, top, self._width, self.height)
        painter.fillRect(area, _BACKGROUND)
        middles = [
            top + (_MARGIN + _LINE * (row + 0.5)) * unit
            for row in range(1 + max([line for *_, line in self._placed], default=0))
        ]
        strokes, marks = [], []
        for entry, x, row in self._placed:
            y = middles[row] if row < len(middles) else top
            sample = np.array([[x, y, x + _SAMPLE * unit, y]])
            strokes += [Strokes(sample, s.colour, s.width, s.dash) for s in entry.lines]
            if entry.mark is not None:
                centre = np.array([[x + _SAMPLE * unit / 2, y]])
                marks.append(
                    PointMarks(centre, entry.mark.shape, entry.mark.colour, entry.mark.size)
                )
        overlay = Overlay(tuple(strokes), tuple(marks), ())
        # The painter of overlays puts whole numbers on pixel centres; here they are edges.
        paint_overlay(painter, overlay, scale=1.0, offset=(-0.5, -0.5), unit=unit, clip=area)
        painter.setFont(self._font)
        painter.setPen(_TEXT)
        half = _LINE * unit / 2
        for row, text in enumerate(self._heading):
            y = top + (_MARGIN + _LINE * row) * unit
            room = QRectF(_MARGIN * unit, y, self._width, _LINE * unit)
            painter.drawText(room, _LEFT, text)
        for entry, x, row in self._placed:
            start = x + (_SAMPLE + _GAP) * unit
            room = QRectF(start, middles[row] - half, self._width, 2 * half)
            painter.drawText(room, _LEFT, entry.text)
