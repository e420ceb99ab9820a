"""Texts beside points of the picture, on plates that keep them readable on anything."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter

from procc_annotator.fit.labels.finding import Severity
from procc_annotator.gui.picture.finding_sign import paint_finding_sign
from procc_annotator.gui.picture.hand_signs import (
    GAP,
    MAGNET,
    SWATCH,
    paint_magnet,
    paint_swatch,
)
from procc_annotator.interact.label_places import place_apart
from procc_annotator.interact.overlay_shapes import Box, HandSigns, Labels

LABEL_REACH = 300.0  # how far, in points, a text reaches beyond its point
_GAP = 9.0
_FONT_PIXELS = 12.0  # in points of the overlay, as all sizes here
_SIGN = 15.0  # of a finding, before its text
_PLATE = QColor(20, 20, 20, 190)
_WIDTHS_KEPT = 2_000
_widths: dict[tuple[str, tuple[str, int]], float] = {}  # of texts, by their fonts


def paint_labels(
    painter: QPainter,
    near: Sequence[tuple[Labels, int, float, float]],
    area: QRectF,
    room: QRectF,
    unit: float,
    *,
    apart: bool,
    times: float,
) -> None:
    """Paint texts on plates.

    Args:
        near: a group, which of its texts, and the place of its point, device px.
        area: what needs painting, device px.
        room: what can be seen; texts of points in it stay inside.
        unit: device px per point.
        apart: whether texts give way to each other.
        times: how large texts are of what they usually are.
    """
    if not near:
        return
    font = QFont(painter.font())
    font.setPixelSize(max(1, round(_FONT_PIXELS * unit * times)))
    painter.setFont(font)
    metrics, known = QFontMetricsF(font), (font.family(), font.pixelSize())
    letter, taken = metrics.height(), list[Box]()
    for labels, row, x, y in near:
        text, sign = labels.texts[row], _SIGN * unit if labels.sign else 0.0
        # A plate behind the text keeps it readable on grass, lines and crowd alike.
        wide = _width(text, known, metrics) + (8 * unit if text else 4 * unit) + sign
        wide += sum(_hand_room(labels.hand, letter))
        size = QSizeF(wide, max(letter, sign) + 2 * unit)
        plate = place_label(QPointF(x, y), size, room, unit, below=labels.below)
        if apart:
            taken.append(place_apart(_box(plate), taken, _box(room)))
            plate.moveTo(*taken[-1][:2])
        if plate.intersects(area):
            _paint_label(painter, labels, text, plate, unit, letter)


def _hand_room(signs: HandSigns | None, letter: float) -> tuple[float, float]:
    """What the signs of the hand take before and behind a text, device px."""
    if signs is None:
        return 0.0, 0.0
    return (SWATCH + GAP) * letter, (MAGNET + GAP) * letter if signs.snap else 0.0


def _box(rectangle: QRectF) -> Box:
    return rectangle.left(), rectangle.top(), rectangle.right(), rectangle.bottom()


def _width(text: str, font: tuple[str, int], metrics: QFontMetricsF) -> float:
    """Of a text; kept, for a text is painted again and again."""
    wide = _widths.get((text, font))
    if wide is None:
        if len(_widths) >= _WIDTHS_KEPT:
            _widths.clear()
        wide = _widths[text, font] = metrics.horizontalAdvance(text)
    return wide


def _paint_label(
    painter: QPainter, labels: Labels, text: str, plate: QRectF, unit: float, letter: float
) -> None:
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(_PLATE)
    painter.drawRoundedRect(plate, 3 * unit, 3 * unit)
    if labels.sign:
        sign = _SIGN * unit
        box = QRectF(plate.left() + 2 * unit, plate.center().y() - sign / 2, sign, sign)
        paint_finding_sign(painter, box, Severity(labels.sign))
        plate.setLeft(box.right())
    if (signs := labels.hand) is not None:
        _paint_hand(painter, signs, plate, letter, 4 * unit)
        before, behind = _hand_room(signs, letter)
        plate.adjust(before, 0, -behind, 0)
    painter.setPen(QColor(labels.colour))
    painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, text)


def _paint_hand(
    painter: QPainter, signs: HandSigns, plate: QRectF, letter: float, margin: float
) -> None:
    side, middle = SWATCH * letter, plate.center().y()
    swatch = QRectF(plate.left() + margin, middle - side / 2, side, side)
    paint_swatch(painter, swatch, signs)
    if signs.snap:
        side = MAGNET * letter
        magnet = QRectF(plate.right() - margin - side, middle - side / 2, side, side)
        paint_magnet(painter, magnet, signs)


def place_label(
    point: QPointF, size: QSizeF, room: QRectF, unit: float, *, below: bool = False
) -> QRectF:
    """Where the text of a point goes: right above it (or below it), or to its left or on the other
    side where that is cut off. It comes into sight if any of the point's mark does.

    Args:
        point, size, room: of the point, the text, and what can be seen, in device px.
        unit: device px per point.
        below: which side is the usual one.
    """
    gap = _GAP * unit
    wide, high = size.width(), size.height()
    x, y = point.x(), point.y()
    over, under = y + 2 * unit - gap - high, y + gap
    left, top = x + gap, under - 2 * unit if below else over
    first, last, upper, lower = room.left(), room.right(), room.top(), room.bottom()
    if first - gap <= x <= last + gap and upper - gap <= y <= lower + gap:
        if left + wide > last:
            left = x - gap - wide
        if top < upper:
            top = under
        elif below and top + high > lower:
            top = over
        left = max(first, left)
    return QRectF(left, top, wide, high)
