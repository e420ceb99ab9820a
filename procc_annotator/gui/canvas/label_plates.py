"""Texts next to points of the picture, on plates that keep them readable on anything."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QGuiApplication,
    QPainter,
    QPainterPath,
    QPen,
)

from procc_annotator.calibration.label_check.finding import Severity
from procc_annotator.gui.canvas.finding_sign import paint_finding_sign
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.label_placement import covers, place_apart, within
from procc_annotator.interaction.overlay_primitives import Box, CursorSigns, Labels

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


LABEL_REACH = 300.0  # how far, in points, a text reaches beyond its point
_GAP = 9.0
_FONT_PIXELS = 12.0  # in points of the overlay, as all sizes here
_SIGN = 15.0  # of a finding, before its text
_PLATE = QColor(20, 20, 20, 190)


class Plate(NamedTuple):
    """A text, and the plate it stands on: left, top, right, bottom, device px."""

    labels: Labels
    row: int
    place: Box

    @property
    def text(self) -> str:
        return self.labels.texts[self.row]


@lru_cache(maxsize=16)  # painted again and again, part by part
def arranged(
    groups: tuple[Labels, ...],
    at: tuple[float, float, float],
    room: Box,
    *,
    unit: float = 1.0,
    times: float = 1.0,
) -> tuple[Plate, ...]:
    """Return where texts go so that they do not cover each other, signs of findings before others;
    a text without room is left out. Nothing gives way to what is at the cursor: that goes to a
    corner of its point where it covers no other, if there is one.
    What needs painting does not matter: a part that is painted anew fits the rest.

    Args:
        groups: texts and their points, picture px.
        at: device px per picture px, and the device px of the first pixel's centre.
        room: what can be seen, device px; texts of points in it stay inside.
        unit: device px per point.
        times: how large texts are of what they usually are.
    """
    letter = QFontMetricsF(_font(unit, times)).height()
    seen = QRectF(QPointF(*room[:2]), QPointF(*room[2:]))
    reach = LABEL_REACH * unit * times
    near = seen.adjusted(-reach, -reach, reach, reach)
    found: list[Plate] = []
    for labels in groups:
        for row, (x, y) in enumerate(labels.positions.tolist()):
            point = QPointF(x * at[0] + at[1], y * at[0] + at[2])
            if near.contains(point):
                size = _size(labels, labels.texts[row], letter, unit, times)
                box = place_label(point, size, seen, unit, below=labels.below)
                found.append(Plate(labels, row, _box(box)))
    shown, taken = list[Plate](), [place for labels in groups for place in labels.covered]
    for plate in sorted(found, key=lambda plate: (plate.labels.carried, not plate.labels.sign)):
        if plate.labels.carried:
            free = (c for c in _corners(plate, at) if within(c, room) and not covers(c, taken))
            shown.append(plate._replace(place=next(free, plate.place)))
            continue
        # A sign beyond the edge stays there.
        stays = plate.labels.sign and not covers(plate.place, taken)
        place = plate.place if stays else place_apart(plate.place, taken, room)
        if not covers(place, taken):
            taken.append(place)
            shown.append(plate._replace(place=place))
    return tuple(shown)


def _corners(plate: Plate, at: tuple[float, float, float]) -> tuple[Box, ...]:
    """Return the place of a text, and those mirrored at its point."""
    x, y = plate.labels.positions[plate.row].tolist()
    across, down = 2 * (x * at[0] + at[1]), 2 * (y * at[0] + at[2])
    left, top, right, bottom = plate.place
    columns = (left, right), (across - right, across - left)
    rows = (top, bottom), (down - bottom, down - top)
    return tuple((a, c, b, d) for a, b in columns for c, d in rows)


def paint_plates(
    painter: QPainter, plates: Sequence[Plate], area: QRectF, *, unit: float, times: float
) -> None:
    """Paint texts on plates, as far as they lie in what needs painting, device px."""
    font = _font(unit, times)
    painter.setFont(font)
    letter = QFontMetricsF(font).height()
    for plate in plates:
        left, top, right, bottom = plate.place
        box = QRectF(left, top, right - left, bottom - top)
        if box.intersects(area):
            _paint_label(painter, plate.labels, plate.text, box, unit, letter)


def _font(unit: float, times: float) -> QFont:
    font = QGuiApplication.font()
    font.setPixelSize(max(1, round(_FONT_PIXELS * unit * times)))
    return font


def _size(labels: Labels, text: str, letter: float, unit: float, times: float) -> QSizeF:
    """Of a plate: behind the text it keeps it readable on grass, lines and crowd alike."""
    sign = _SIGN * unit if labels.sign else 0.0
    wide = _width(text, unit, times) + (8 * unit if text else 4 * unit) + sign
    wide += sum(_hand_room(labels.hand, letter))
    return QSizeF(wide, max(letter, sign) + 2 * unit)


@lru_cache(maxsize=2_000)
def _width(text: str, unit: float, times: float) -> float:
    return QFontMetricsF(_font(unit, times)).horizontalAdvance(text)


def _hand_room(signs: CursorSigns | None, letter: float) -> tuple[float, float]:
    """Return the widths of the cursor signs before and behind a text, device px."""
    if signs is None:
        return 0.0, 0.0
    return (SWATCH + GAP) * letter, (MAGNET + GAP) * letter if signs.snap else 0.0


def _box(rectangle: QRectF) -> Box:
    return rectangle.left(), rectangle.top(), rectangle.right(), rectangle.bottom()


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
    painter: QPainter, signs: CursorSigns, plate: QRectF, letter: float, margin: float
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
    """Return where the text of a point goes: right above it (or below it), or to its left or on the
    other side where that is cut off. It comes into sight if any of the point's mark does.

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
