"""Painting the timeline: the band of its frames, marks, statuses, numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetrics,
    QImage,
    QPainter,
    QPalette,
    QPen,
    QPolygonF,
)

from procc_annotator.dataset.records import Status
from procc_annotator.gui.panels.timeline.content import Axis, Band, StripContent, band_pixels
from procc_annotator.gui.theme import muted
from procc_annotator.interaction import palette as tones

_TOP, _MARKS, _BAND, _STATUS, _GAP = 1, 8, 10, 4, 2  # px
_NUMBERS = 0.75  # height of the digits, of a line of text
_ANCHOR = 4.0  # half of a diamond
_LEAST_BETWEEN = 7.0  # px between two frames of the dataset that are ticked one by one
_CURRENT = 2.0
# How high a frame's status stands, and its tone.
_STATUSES = {
    Status.IN_PROGRESS: (0.4, tones.NOT_ANNOTATED),
    Status.DONE: (0.7, tones.UNCONFIRMED),
    Status.APPROVED: (1.0, tones.PASSES),
    Status.REJECTED: (1.0, tones.TOO_FAR),
}


class StripPainter:
    """Paints a strip: what stays the same from frame to frame, or what changes with the frame."""

    def __init__(self, metrics: QFontMetrics, axis: Axis, area: QRectF, colours: QPalette) -> None:
        """Paint the frames in sight along the width of an area: the strip without the room next to
        the frames."""
        self._axis, self._area, self._colours = axis, area, colours
        self._line = metrics.height()
        self._marks = _TOP + self._line
        self._band = self._marks + _MARKS
        self._status = self._band + _BAND + 1
        self._numbers = self._status + _STATUS

    @staticmethod
    def height(metrics: QFontMetrics) -> int:
        """Return the height of a strip, px."""
        lines = round((1 + _NUMBERS) * metrics.height())
        return _TOP + _MARKS + _BAND + 1 + _STATUS + _GAP + lines

    def paint_frames(
        self, painter: QPainter, content: StripContent, stretch: tuple[int, int] | None
    ) -> None:
        """Paint all that stays the same from frame to frame, on something of the strip's size, with
        the stretch (first and last number) that a person marked."""
        area, colours = self._area, self._colours
        painter.fillRect(painter.viewport(), colours.color(QPalette.ColorRole.Window))
        band = QRectF(0, self._band, area.width(), _BAND)
        painter.fillRect(band.translated(area.left(), 0), colours.color(QPalette.ColorRole.Base))
        painter.setClipRect(area.adjusted(-_ANCHOR - 1, 0, _ANCHOR + 1, 0))
        painter.translate(area.left(), 0)
        if stretch is not None:
            self._paint_stretch(painter, stretch)
        if not content.hidden and len(content.band.lost):
            self._paint_band(painter, content.band, band)
        self._paint_ticks(painter, content)
        self._paint_cuts(painter, content)
        self._paint_statuses(painter, content)
        self._paint_anchors(painter, content)
        self._paint_numbers(painter)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(colours.color(QPalette.ColorRole.Mid))
        painter.drawRect(band.adjusted(-0.5, -0.5, 0.5, 0.5))

    def paint_here(self, painter: QPainter, number: int | None, left: str, right: str) -> None:
        """Paint what changes with the frame: words at both ends, and the frame on screen."""
        metrics, area = painter.fontMetrics(), self._area
        line = QRectF(area.left(), _TOP, area.width(), self._line)
        taken = metrics.horizontalAdvance(right) + 16 if right else 0
        middle = Qt.AlignmentFlag.AlignVCenter
        painter.setPen(self._colours.color(QPalette.ColorRole.WindowText))
        shown = metrics.elidedText(left, Qt.TextElideMode.ElideRight, int(line.width() - taken))
        painter.drawText(line, middle | Qt.AlignmentFlag.AlignLeft, shown)
        painter.drawText(line, middle | Qt.AlignmentFlag.AlignRight, right)
        if number is not None:
            painter.translate(area.left(), 0)
            self._paint_current(painter, number)

    # --- parts --------------------------------------------------------------------------------

    def _paint_band(self, painter: QPainter, band: Band, box: QRectF) -> None:
        ratio = painter.device().devicePixelRatio()
        width, height = (max(1, round(side * ratio)) for side in (box.width(), box.height()))
        pixels = band_pixels(band, self._axis, (width, height))
        form = QImage.Format.Format_ARGB32_Premultiplied
        painter.drawImage(box, QImage(pixels.tobytes(), width, height, 4 * width, form))

    def _paint_stretch(self, painter: QPainter, stretch: tuple[int, int]) -> None:
        left, right = self._axis.x_of(stretch[0]), self._axis.x_of(stretch[1] + 1)
        tone = QColor(self._colours.color(QPalette.ColorRole.Highlight))
        tone.setAlphaF(0.35)
        box = QRectF(left, self._marks, right - left, self._numbers - self._marks)
        painter.fillRect(box, tone)

    def _paint_ticks(self, painter: QPainter, content: StripContent) -> None:
        """Ticks below the frames of the dataset, unless they are too many to be distinguished."""
        sequence, axis = content.sequence, self._axis
        if sequence is None or len(sequence.numbers) == sequence.count:
            return
        numbers = sequence.numbers
        shown = numbers[(numbers >= axis.begin - 1) & (numbers <= axis.end)]
        if len(shown) * _LEAST_BETWEEN > axis.width:
            return
        painter.setPen(muted(self._colours, 0.5))
        bottom = self._band + _BAND
        painter.drawLines(
            [QLineF(x, bottom - 4, x, bottom) for x in map(axis.middle_of, shown.tolist())]
        )

    def _paint_cuts(self, painter: QPainter, content: StripContent) -> None:
        painter.setPen(QPen(self._colours.color(QPalette.ColorRole.WindowText), 1.4))
        for cut in content.cuts:
            if self._axis.begin <= cut <= self._axis.end:
                x = self._axis.x_of(cut)
                painter.drawLine(QLineF(x, self._marks + 1, x, self._status))

    def _paint_statuses(self, painter: QPainter, content: StripContent) -> None:
        axis, bottom = self._axis, self._status + _STATUS - 1
        width = max(2.0, axis.per_frame - 1.0)
        for number, status in content.statuses.items():
            if status in _STATUSES and axis.begin - 1 <= number <= axis.end:
                share, tone = _STATUSES[status]
                height, left = share * (_STATUS - 1), axis.middle_of(number) - width / 2
                painter.fillRect(QRectF(left, bottom - height, width, height), QColor(tone))

    def _paint_anchors(self, painter: QPainter, content: StripContent) -> None:
        """Diamonds, hollow where only the camera was dragged; uprights where they would lie on each
        other."""
        places = self._places(content.anchors)
        dragged = self._places(() if content.hidden else content.dragged)
        dragged = np.setdiff1d(dragged, places)
        tone, y = self._colours.color(QPalette.ColorRole.Highlight), self._marks + _MARKS / 2
        if len(places) * 2 * _ANCHOR > self._axis.width / 2:
            painter.setPen(QPen(tone, 1.0))
            top, bottom = y - _ANCHOR, y + _ANCHOR
            painter.drawLines([QLineF(x, top, x, bottom) for x in places.tolist()])
            places = places[:0]
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(tone)
        for x in places.tolist():
            painter.drawPolygon(_diamond(x, y))
        painter.setPen(QPen(tone, 1.4))
        painter.setBrush(self._colours.color(QPalette.ColorRole.Window))
        for x in dragged.tolist():
            painter.drawPolygon(_diamond(x, y))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)

    def _places(self, numbers: Sequence[int]) -> NDArray[np.float64]:
        """Px of the area where frames in sight have their marks."""
        axis, every = self._axis, np.array(numbers, dtype=np.float64)
        every = every[(every >= axis.begin - 1) & (every <= axis.end)]
        return np.unique(np.round((every + 0.5 - axis.begin) * axis.per_frame))

    def _paint_numbers(self, painter: QPainter) -> None:
        axis, top, font = self._axis, self._numbers, QFont(painter.font())
        font.setPointSizeF(font.pointSizeF() * _NUMBERS)
        painter.setFont(font)
        widest = painter.fontMetrics().horizontalAdvance(str(axis.last)) + 24
        step = _round_step((axis.end - axis.begin) * widest / axis.width)
        painter.setPen(muted(self._colours, 0.3))
        number = math.ceil(axis.begin / step) * step
        while number < axis.end:
            x = axis.middle_of(number)
            painter.drawLine(QLineF(x, top - 1, x, top + 2))
            box = QRectF(x - widest / 2, top + 2, widest, self._line * _NUMBERS)
            if box.left() >= -8 and box.right() <= axis.width + 8:
                painter.drawText(box, Qt.AlignmentFlag.AlignCenter, str(number))
            number += step

    def _paint_current(self, painter: QPainter, number: int) -> None:
        x, top, bottom = self._axis.middle_of(number), self._marks, self._numbers - 1
        tone = self._colours.color(QPalette.ColorRole.WindowText)
        outline = self._colours.color(QPalette.ColorRole.Base)
        for colour, width, above in ((outline, _CURRENT + 2.0, 4), (tone, _CURRENT, 2)):
            painter.setPen(QPen(colour, width))
            painter.drawLine(QLineF(x, top + above, x, bottom))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(tone)
        corners = [QPointF(x - 4.5, top), QPointF(x + 4.5, top), QPointF(x, top + 6)]
        painter.drawPolygon(QPolygonF(corners))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)


def _diamond(x: float, y: float) -> QPolygonF:
    r = _ANCHOR
    return QPolygonF([QPointF(x, y - r), QPointF(x + r, y), QPointF(x, y + r), QPointF(x - r, y)])


def _round_step(least: float) -> int:
    """The least of 1, 2, 5, 10, 20, 50, ... that is not less."""
    power = 1
    while True:
        for times in (1, 2, 5):
            if times * power >= least:
                return times * power
        power *= 10
