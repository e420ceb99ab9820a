"""What the colours of a disagreement mean, at the lower edge of the picture."""

from __future__ import annotations

import math

import numpy as np
from PySide6.QtCore import QPoint, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPaintEvent, QPen, QTransform
from PySide6.QtWidgets import QWidget

from procc_annotator.gui.picture.disagreement_picture import paint_lines
from procc_annotator.gui.picture.pinned import Pinned
from procc_annotator.interact import palette as tones
from procc_annotator.metric.contours import DISAGREEMENT_LEVELS_M, OFFSIDE_ACCURACY_M

_CELL = QSize(36, 12)
_EDGE = 8
_UNIT = "metres on the ground"  # a line of its own: names may be as long as they like
_WRAPPED = Qt.TextFlag.TextWordWrap.value | Qt.AlignmentFlag.AlignLeft.value
_PLATE = QColor(20, 20, 20, 215)
_TEXT = QColor("#f4f4f4")


class DisagreementLegend(Pinned):
    """A bar of the bands with their limits in metres, and between whom the distance is taken; or
    why there is nothing to be seen."""

    def __init__(self, viewport: QWidget) -> None:
        super().__init__(viewport, "disagreementLegend")
        self._viewport = viewport
        self.title = ""
        self.problem = ""

    def show_for(self, names: tuple[str, str], problem: str = "") -> None:
        """Explain the colours between two sources, with a remark below if there is one."""
        self._show(f"{names[0]} ↔ {names[1]}", problem)

    def show_problem(self, problem: str) -> None:
        """Say why there are no colours."""
        self._show("", problem)

    def _show(self, title: str, problem: str) -> None:
        self.title, self.problem = title, problem
        unit = f", {_UNIT}" if title else ""
        self.setAccessibleName(f"Disagreement. {title}{unit} {problem}")
        self.place()
        self.show()
        self.raise_()
        self.update()

    def place(self) -> None:
        """Stand at the lower left corner of the viewport as it is now."""
        room = self._viewport.size()
        line = math.ceil(QFontMetricsF(self.font()).height())
        width = len(tones.DISAGREEMENT_COLOURS) * _CELL.width() + 2 * _EDGE + 12
        height = 2 * _EDGE
        if self.title:
            height += 4 * line + _CELL.height() + 8
        if self.problem:
            height += math.ceil(self._problem_room(width).height())
        top = max(0, room.height() - height - _EDGE)
        self.put(QRect(QPoint(_EDGE, top), QSize(width, height)))

    def _problem_room(self, width: int) -> QRectF:
        """What the wrapped remark takes."""
        room = QRectF(0, 0, width - 2 * _EDGE, 1000)
        return QFontMetricsF(self.font()).boundingRect(room, _WRAPPED, self.problem)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(_PLATE)
        painter.drawRoundedRect(QRectF(self.rect()), 4, 4)
        painter.setPen(_TEXT)
        if self.title:
            self._paint_scale(painter)
        if self.problem:
            room = self._problem_room(self.width())
            room.moveBottomLeft(QPointF(_EDGE, self.height() - _EDGE))
            painter.drawText(room, _WRAPPED, self.problem)

    def _paint_scale(self, painter: QPainter) -> None:
        metrics = QFontMetricsF(self.font())
        line = metrics.height()
        room = QRectF(_EDGE, _EDGE, self.width() - 2 * _EDGE, line)
        title = metrics.elidedText(self.title, Qt.TextElideMode.ElideMiddle, room.width())
        painter.drawText(room, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, title)
        room.translate(0, line)
        painter.drawText(room, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, _UNIT)
        top = _EDGE + 2 * line + 4
        self._paint_bar(painter, top, line)
        self._paint_accuracy(painter, top + _CELL.height() + line + 2, line)

    def _paint_bar(self, painter: QPainter, top: float, line: float) -> None:
        levels = DISAGREEMENT_LEVELS_M
        for i, colour in enumerate(tones.DISAGREEMENT_COLOURS):
            left = _EDGE + 6 + i * _CELL.width()
            painter.fillRect(QRectF(left, top, _CELL.width(), _CELL.height()), QColor(colour))
            label = QRectF(left - _CELL.width() / 2, top + _CELL.height(), _CELL.width(), line)
            painter.setPen(_TEXT)
            painter.drawText(label, Qt.AlignmentFlag.AlignCenter, f"{levels[i]:g}")
            if levels[i] == OFFSIDE_ACCURACY_M:
                painter.setPen(QPen(QColor(tones.RIM), 1))
                painter.drawLine(QPointF(left, top), QPointF(left, top + _CELL.height()))

    def _paint_accuracy(self, painter: QPainter, top: float, line: float) -> None:
        middle = top + line / 2
        left = _EDGE + 6
        sample = np.array([[left, middle], [left + _CELL.width(), middle]], dtype=np.float64)
        paint_lines(
            painter,
            [sample],
            QTransform(),
            tones.HALO,
            width=tones.LIMIT_WIDTH,
            casing=0.0,
            dash=tones.LIMIT_DASH,
        )
        painter.setPen(_TEXT)
        room = QRectF(_EDGE + _CELL.width() + 14, top, self.width(), line)
        text = f"{OFFSIDE_ACCURACY_M:g} m, asked of offside technology"
        painter.drawText(room, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, text)
