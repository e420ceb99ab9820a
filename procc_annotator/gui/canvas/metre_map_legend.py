"""What the colours of a map in metres mean, at the lower edge of the picture."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QPoint, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPaintEvent, QPen, QTransform
from PySide6.QtWidgets import QWidget

from procc_annotator.gui.canvas.metre_map_picture import paint_lines
from procc_annotator.gui.canvas.pinned import Pinned
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.camera_view import DISAGREEMENT, LevelLine, MapStyle
from procc_annotator.translation import tr

_BAR = QSize(252, 12)
_SAMPLE = 36
_EDGE = 8
_WRAPPED = Qt.TextFlag.TextWordWrap.value | Qt.AlignmentFlag.AlignLeft.value
_ONE_LINE = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_PLATE = QColor(20, 20, 20, 215)
_TEXT = QColor("#f4f4f4")


@dataclass(frozen=True, slots=True)
class MapWords:
    """What a map is of, in what unit, and what each of its lines says."""

    title: str
    unit: str  # a line of its own: titles may be as long as they like
    lines: tuple[str, ...]


class MetreMapLegend(Pinned):
    """A bar of the bands with their limits in metres, and the lines with what they say; or why
    there is nothing to be seen."""

    def __init__(self, viewport: QWidget) -> None:
        super().__init__(viewport, "metreMapLegend")
        self._viewport = viewport
        self._look = DISAGREEMENT
        self._words: MapWords | None = None
        self.problem = ""

    @property
    def title(self) -> str:
        """Return what the map is of; empty while there is none."""
        return self._words.title if self._words is not None else ""

    @property
    def lines(self) -> tuple[str, ...]:
        """Return what the lines say."""
        return self._words.lines if self._words is not None else ()

    def show_for(self, look: MapStyle, words: MapWords | None, problem: str = "") -> None:
        """Explain a map.

        Args:
            words: None if there are no colours.
            problem: a remark below, or why there is nothing to be seen.
        """
        shown = look, words, problem
        if shown == (self._look, self._words, self.problem) and not self.isHidden():
            return
        self._look, self._words, self.problem = shown
        said = f"{words.title}, {words.unit}. {'; '.join(words.lines)}" if words else ""
        self.setAccessibleName(f"{tr(look.name)}. {said} {problem}")
        self.place()
        self.show()
        self.raise_()
        self.update()

    def place(self) -> None:
        """Stand at the lower left corner of the viewport as it is now."""
        room = self._viewport.size()
        line = math.ceil(QFontMetricsF(self.font()).height())
        width = _BAR.width() + 2 * _EDGE + 12
        height = 2 * _EDGE
        if self._words is not None:
            height += (3 + len(self._words.lines)) * line + _BAR.height() + 8
        if self.problem:
            height += math.ceil(self._problem_room(width).height())
        top = max(0, room.height() - height - _EDGE)
        self.put(QRect(QPoint(_EDGE, top), QSize(width, height)))

    def _problem_room(self, width: int) -> QRectF:
        """Return what the wrapped remark takes."""
        room = QRectF(0, 0, width - 2 * _EDGE, 1000)
        return QFontMetricsF(self.font()).boundingRect(room, _WRAPPED, self.problem)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(_PLATE)
        painter.drawRoundedRect(QRectF(self.rect()), 4, 4)
        painter.setPen(_TEXT)
        if self._words is not None:
            self._paint_scale(painter, self._words)
        if self.problem:
            room = self._problem_room(self.width())
            room.moveBottomLeft(QPointF(_EDGE, self.height() - _EDGE))
            painter.drawText(room, _WRAPPED, self.problem)

    def _paint_scale(self, painter: QPainter, words: MapWords) -> None:
        metrics = QFontMetricsF(self.font())
        line = metrics.height()
        room = QRectF(_EDGE, _EDGE, self.width() - 2 * _EDGE, line)
        title = metrics.elidedText(words.title, Qt.TextElideMode.ElideMiddle, room.width())
        painter.drawText(room, _ONE_LINE, title)
        room.translate(0, line)
        painter.drawText(room, _ONE_LINE, words.unit)
        top = _EDGE + 2 * line + 4
        self._paint_bar(painter, top, line)
        top += _BAR.height() + line + 2
        for style, text in zip(self._look.lines, words.lines, strict=True):
            self._paint_line(painter, style, text, QRectF(_EDGE, top, self.width(), line))
            top += line

    def _paint_bar(self, painter: QPainter, top: float, line: float) -> None:
        look = self._look
        cell = _BAR.width() / len(look.colours)
        drawn = {style.metres for style in look.lines}
        for level, colour, i in zip(look.levels_m, look.colours, range(99), strict=False):
            left = _EDGE + 6 + i * cell
            painter.fillRect(QRectF(left, top, cell, _BAR.height()), QColor(colour))
            label = QRectF(left - cell / 2, top + _BAR.height(), cell, line)
            painter.setPen(_TEXT)
            painter.drawText(label, Qt.AlignmentFlag.AlignCenter, f"{level:g}")
            if level in drawn:
                painter.setPen(QPen(QColor(tones.OUTLINE), 1))
                painter.drawLine(QPointF(left, top), QPointF(left, top + _BAR.height()))

    def _paint_line(self, painter: QPainter, style: LevelLine, text: str, room: QRectF) -> None:
        left, middle = _EDGE + 6, room.center().y()
        sample = np.array([[left, middle, left + _SAMPLE, middle]], dtype=np.float64)
        paint_lines(
            painter, sample, QTransform(), tones.HALO,
            width=tones.LIMIT_WIDTH, casing=0.0, dash=style.dash,
        )  # fmt: skip
        painter.setPen(_TEXT)
        painter.drawText(room.adjusted(_SAMPLE + 14, 0, 0, 0), _ONE_LINE, text)
