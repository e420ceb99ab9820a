"""Painting the timeline: the band of its frames, marks, statuses, numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import (
    QColor,
    QFontMetrics,
    QImage,
    QPainter,
    QPalette,
    QPen,
    QPolygonF,
)

from procc_annotator.dataset.records import Status
from procc_annotator.gui.panels.timeline.content import Axis, StripContent, band_pixels
from procc_annotator.gui.theme import blend, muted
from procc_annotator.interaction import palette as tones

_MARKS, _BAND, _STATUS, _GAP = 9, 16, 6, 3
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


@dataclass(frozen=True, slots=True)
class Rows:
    """Tops of the rows of a strip, px from its top."""

    words: int
    marks: int
    band: int
    status: int
    numbers: int
    height: int


def strip_rows(metrics: QFontMetrics) -> Rows:
    """The rows for a font."""
    words = 2
    marks = words + metrics.height()
    band = marks + _MARKS
    status = band + _BAND + 1
    numbers = status + _STATUS
    return Rows(words, marks, band, status, numbers, numbers + metrics.height() + _GAP)


def paint_strip(
    painter: QPainter,
    content: StripContent,
    axis: Axis,
    area: QRectF,
    *,
    colours: QPalette,
    stretch: tuple[int, int] | None,
) -> None:
    """Paint all that stays the same from frame to frame.

    Args:
        painter: on something of the strip's size.
        content: what is shown.
        axis: which frames are in sight, along the area's width.
        area: without the room next to the frames.
        colours: of the window.
        stretch: first and last number that a person marked.
    """
    rows = strip_rows(painter.fontMetrics())
    painter.fillRect(painter.viewport(), colours.color(QPalette.ColorRole.Window))
    band = QRectF(area.left(), rows.band, area.width(), _BAND)
    painter.fillRect(band, colours.color(QPalette.ColorRole.Base))
    painter.setClipRect(area.adjusted(-_ANCHOR - 1, 0, _ANCHOR + 1, 0))
    painter.translate(area.left(), 0)
    if stretch is not None:
        _paint_stretch(painter, axis, rows, stretch, colours)
    _paint_band(painter, content, axis, band)
    _paint_frames(painter, content, axis, rows, colours)
    _paint_cuts(painter, content, axis, rows, colours)
    _paint_status(painter, content, axis, rows)
    _paint_anchors(painter, content, axis, rows, colours)
    _paint_numbers(painter, axis, rows, colours)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(colours.color(QPalette.ColorRole.Mid))
    painter.drawRect(band.translated(-area.left(), 0).adjusted(-0.5, -0.5, 0.5, 0.5))


def paint_here(
    painter: QPainter,
    axis: Axis,
    area: QRectF,
    *,
    colours: QPalette,
    number: int | None,
    words: tuple[str, str],
) -> None:
    """Paint what changes with the frame.

    Args:
        painter: on the widget.
        axis, area, colours: as for `paint_strip`.
        number: of the frame on screen.
        words: on the left, and on the right.
    """
    rows = strip_rows(painter.fontMetrics())
    _paint_words(painter, area, rows, colours, words)
    if number is not None:
        painter.translate(area.left(), 0)
        _paint_current(painter, axis, rows, colours, number)


def _paint_words(
    painter: QPainter, area: QRectF, rows: Rows, colours: QPalette, words: tuple[str, str]
) -> None:
    metrics = painter.fontMetrics()
    line = QRectF(area.left(), rows.words, area.width(), metrics.height())
    left, right = words
    taken = metrics.horizontalAdvance(right) + 16 if right else 0
    middle = Qt.AlignmentFlag.AlignVCenter
    painter.setPen(colours.color(QPalette.ColorRole.WindowText))
    shown = metrics.elidedText(left, Qt.TextElideMode.ElideRight, int(line.width() - taken))
    painter.drawText(line, middle | Qt.AlignmentFlag.AlignLeft, shown)
    painter.drawText(line, middle | Qt.AlignmentFlag.AlignRight, right)


def _paint_band(painter: QPainter, content: StripContent, axis: Axis, band: QRectF) -> None:
    if content.hidden or not len(content.band.lost):
        return
    ratio = painter.device().devicePixelRatio()
    size = max(1, round(band.width() * ratio)), max(1, round(band.height() * ratio))
    pixels = band_pixels(content.band, axis, size)
    image = QImage(
        pixels.tobytes(), size[0], size[1], 4 * size[0], QImage.Format.Format_ARGB32_Premultiplied
    )
    painter.drawImage(QRectF(0, band.top(), band.width(), band.height()), image)


def _paint_stretch(
    painter: QPainter, axis: Axis, rows: Rows, stretch: tuple[int, int], colours: QPalette
) -> None:
    left, right = axis.x_of(stretch[0]), axis.x_of(stretch[1] + 1)
    tone = QColor(colours.color(QPalette.ColorRole.Highlight))
    tone.setAlphaF(0.35)
    painter.fillRect(QRectF(left, rows.marks, right - left, rows.numbers - rows.marks), tone)


def _paint_frames(
    painter: QPainter, content: StripContent, axis: Axis, rows: Rows, colours: QPalette
) -> None:
    """Ticks below the frames of the dataset, unless they are too many to be distinguished."""
    sequence = content.sequence
    if sequence is None or len(sequence.numbers) == sequence.count:
        return
    shown = sequence.numbers[(sequence.numbers >= axis.begin - 1) & (sequence.numbers <= axis.end)]
    if len(shown) * _LEAST_BETWEEN > axis.width:
        return
    painter.setPen(muted(colours, 0.5))
    bottom = rows.band + _BAND
    painter.drawLines(
        [QLineF(x, bottom - 4, x, bottom) for x in map(axis.middle_of, shown.tolist())]
    )


def _paint_cuts(
    painter: QPainter, content: StripContent, axis: Axis, rows: Rows, colours: QPalette
) -> None:
    painter.setPen(QPen(colours.color(QPalette.ColorRole.WindowText), 1.4))
    for cut in content.cuts:
        if axis.begin <= cut <= axis.end:
            x = axis.x_of(cut)
            painter.drawLine(QLineF(x, rows.marks + 1, x, rows.status))


def _paint_status(painter: QPainter, content: StripContent, axis: Axis, rows: Rows) -> None:
    width = max(2.0, axis.per_frame - 1.0)
    for number, status in content.statuses.items():
        if status in _STATUSES and axis.begin - 1 <= number <= axis.end:
            share, tone = _STATUSES[status]
            height = share * (_STATUS - 1)
            left = axis.middle_of(number) - width / 2
            painter.fillRect(
                QRectF(left, rows.status + _STATUS - 1 - height, width, height), QColor(tone)
            )


def _paint_anchors(
    painter: QPainter, content: StripContent, axis: Axis, rows: Rows, colours: QPalette
) -> None:
    """Diamonds, hollow where only the camera was dragged; uprights where they would lie on each
    other."""
    places = _places(content.anchors, axis)
    dragged = _places(() if content.hidden else content.dragged, axis)
    dragged = np.setdiff1d(dragged, places)
    tone, y = colours.color(QPalette.ColorRole.Highlight), rows.marks + _MARKS / 2
    if len(places) * 2 * _ANCHOR > axis.width / 2:
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
    painter.setBrush(colours.color(QPalette.ColorRole.Window))
    for x in dragged.tolist():
        painter.drawPolygon(_diamond(x, y))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)


def _places(numbers: Sequence[int], axis: Axis) -> NDArray[np.float64]:
    """Px of the widget where frames in sight have their marks."""
    every = np.array(numbers, dtype=np.float64)
    every = every[(every >= axis.begin - 1) & (every <= axis.end)]
    return np.unique(np.round((every + 0.5 - axis.begin) * axis.per_frame))


def _diamond(x: float, y: float) -> QPolygonF:
    r = _ANCHOR
    return QPolygonF([QPointF(x, y - r), QPointF(x + r, y), QPointF(x, y + r), QPointF(x - r, y)])


def _paint_numbers(painter: QPainter, axis: Axis, rows: Rows, colours: QPalette) -> None:
    metrics = painter.fontMetrics()
    widest = metrics.horizontalAdvance(str(axis.last)) + 24
    step = _round_step((axis.end - axis.begin) * widest / axis.width)
    painter.setPen(muted(colours, 0.3))
    number = math.ceil(axis.begin / step) * step
    while number < axis.end:
        x = axis.middle_of(number)
        painter.drawLine(QLineF(x, rows.numbers - 1, x, rows.numbers + 2))
        box = QRectF(x - widest / 2, rows.numbers + 1, widest, metrics.height())
        if box.left() >= -8 and box.right() <= axis.width + 8:
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, str(number))
        number += step


def _round_step(least: float) -> int:
    """The least of 1, 2, 5, 10, 20, 50, ... that is not less."""
    power = 1
    while True:
        for times in (1, 2, 5):
            if times * power >= least:
                return times * power
        power *= 10


def _paint_current(
    painter: QPainter, axis: Axis, rows: Rows, colours: QPalette, number: int
) -> None:
    x = axis.middle_of(number)
    tone = colours.color(QPalette.ColorRole.WindowText)
    rim = blend(colours.color(QPalette.ColorRole.Base), tone, 0.0)
    top, bottom = rows.marks, rows.numbers - 1
    painter.setPen(QPen(rim, _CURRENT + 2.0))
    painter.drawLine(QLineF(x, top + 4, x, bottom))
    painter.setPen(QPen(tone, _CURRENT))
    painter.drawLine(QLineF(x, top + 2, x, bottom))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(tone)
    painter.drawPolygon(
        QPolygonF([QPointF(x - 4.5, top), QPointF(x + 4.5, top), QPointF(x, top + 6)])
    )
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
