"""Painting an overlay from its arrays: the one painter of the window and of overlay pictures.

Widths, sizes and dash lengths of an overlay are in points and do not grow with the picture. Lines
are painted by `drawLines` with flat caps, which is several times faster than paths; dashes are
therefore cut here, along whole curves, since Qt would start the pattern anew at every segment.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import cast

import numpy as np
import shiboken6
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen, QPolygonF

from procc_annotator.fit.labels.finding import Severity
from procc_annotator.gui.picture.finding_sign import paint_finding_sign
from procc_annotator.interact.overlay_shapes import Box, Labels, Marks, Overlay, Patch, Strokes

Array = NDArray[np.float64]

_REACH = 24.0  # how far, in points, anything but text reaches beyond its position
_FAR = 4000.0  # px beyond what is wanted that a line may lead without being cut
_FEW = 64  # lines; more of them are looked at before they are painted
_LABEL_REACH = 260.0
_LABEL_GAP = 9.0
_FONT_PIXELS = 12.0  # in points of the overlay, as all sizes here
_SIGN = 15.0  # of a finding, before its text
_RIM = QColor("#202020")
_PLATE = QColor(20, 20, 20, 190)


def paint_overlay(
    painter: QPainter,
    overlay: Overlay,
    *,
    scale: float,
    offset: tuple[float, float] = (0.0, 0.0),
    unit: float = 1.0,
    clip: QRectF | None = None,
    room: QRectF | None = None,
    labelled: bool = True,
) -> None:
    """Paint an overlay.

    Args:
        painter: in the coordinates of its device (logical px); its state is restored.
        overlay: positions in picture px, whose pixel centres are whole numbers.
        scale: device px per picture px.
        offset: device position of the picture's top left corner (not of that pixel's centre).
        unit: device px per point.
        clip: what needs painting, in device px; None for the whole device.
        room: what can be seen of the device; texts of points in it stay inside. None for all.
        labelled: whether with its texts.
    """
    area = clip if clip is not None else QRectF(painter.viewport())
    seen = room if room is not None else QRectF(painter.viewport())
    view = _View(scale, np.array(offset) + 0.5 * scale, unit, area)
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for patch in overlay.patches:
        _paint_patch(painter, patch, view)
    near, far = view.reach(_REACH * unit), view.reach(_FAR)
    for strokes in overlay.seen_strokes:
        if _touches(strokes.box, near):
            _paint_strokes(painter, strokes, view, whole=_contains(far, strokes.box))
    for marks in overlay.seen_marks:
        if _touches(marks.box, near):
            _paint_marks(painter, marks, view, near)
    if labelled:
        for labels in overlay.labels:
            _paint_labels(painter, labels, view, seen)
    painter.restore()


@dataclass(frozen=True, slots=True)
class _View:
    """From picture px to device px, and what of the device is wanted."""

    scale: float
    origin: Array
    unit: float
    area: QRectF

    def reach(self, margin: float) -> Box:
        """Picture px within a margin, device px, of what is wanted."""
        room, (x, y) = self.area.adjusted(-margin, -margin, margin, margin), self.origin.tolist()
        left, top = (room.left() - x) / self.scale, (room.top() - y) / self.scale
        return left, top, (room.right() - x) / self.scale, (room.bottom() - y) / self.scale


def _touches(box: Box | None, other: Box) -> bool:
    if box is None:
        return False
    across = box[0] <= other[2] and box[2] >= other[0]
    return across and box[1] <= other[3] and box[3] >= other[1]


def _contains(box: Box, other: Box | None) -> bool:
    if other is None:
        return True
    across = box[0] <= other[0] and other[2] <= box[2]
    return across and box[1] <= other[1] and other[3] <= box[3]


def _paint_patch(painter: QPainter, patch: Patch, view: _View) -> None:
    outline = patch.outline * view.scale + view.origin
    (left, top), (right, bottom) = outline.min(axis=0).tolist(), outline.max(axis=0).tolist()
    if not view.area.intersects(QRectF(left, top, right - left, bottom - top)):
        return
    colour = QColor(patch.colour)
    colour.setAlphaF(patch.opacity)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour)
    painter.drawPolygon(QPolygonF([QPointF(x, y) for x, y in outline.tolist()]))
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _paint_strokes(painter: QPainter, strokes: Strokes, view: _View, *, whole: bool) -> None:
    """Paint what of some strokes is wanted; or simply all of them, ``whole``, where they are few
    and none leads so far away that painting it would take longer."""
    lines = strokes.segments * view.scale + np.concatenate([view.origin, view.origin])
    if strokes.dash or len(lines) > _FEW or not whole:
        reach = _REACH * view.unit
        pattern = [d * view.unit for d in strokes.dash]
        lines = visible_parts(lines, view.area.adjusted(-reach, -reach, reach, reach), pattern)
    draw_lines(painter, lines, _pen(strokes.colour, strokes.width * view.unit))


@lru_cache(maxsize=256)
def _pen(colour: str, width: float) -> QPen:
    pen = QPen(QColor(colour), width)
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    return pen


def draw_lines(painter: QPainter, lines: Array, pen: QPen) -> None:
    """Draw (N, 4) device px; the array is handed to Qt as it is (four doubles make a QLineF)."""
    if not len(lines):
        return
    memory = np.ascontiguousarray(lines, dtype=np.float64)
    painter.setPen(pen)
    first = cast(QLineF, shiboken6.wrapInstance(memory.ctypes.data, QLineF))
    painter.drawLines(first, len(memory))


def clip_lines(lines: Array, room: QRectF) -> tuple[NDArray[np.intp], Array, Array]:
    """The part of each line inside a rectangle (Liang-Barsky).

    Args:
        lines: (N, 4) device px.
        room: device px.

    Returns:
        Rows of the lines that touch the rectangle, and where on them (0 to 1) the inside begins and
        ends.
    """
    begin, end = np.zeros(len(lines)), np.ones(len(lines))
    step = lines[:, 2:] - lines[:, :2]
    low = np.array([room.left(), room.top()])
    high = np.array([room.right(), room.bottom()])
    with np.errstate(divide="ignore", invalid="ignore"):
        first = (low - lines[:, :2]) / step
        second = (high - lines[:, :2]) / step
    outside = np.zeros(len(lines), dtype=bool)
    for axis in (0, 1):
        still = step[:, axis] == 0
        at = lines[:, axis]
        outside |= still & ((at < low[axis]) | (at > high[axis]))
        near = np.minimum(first[:, axis], second[:, axis])
        far = np.maximum(first[:, axis], second[:, axis])
        begin = np.where(still, begin, np.maximum(begin, near))
        end = np.where(still, end, np.minimum(end, far))
    (kept,) = np.nonzero(~outside & (begin < end))
    return kept, begin[kept], end[kept]


def visible_parts(lines: Array, room: QRectF, pattern: Sequence[float] = ()) -> Array:
    """What of lines is to be drawn: inside a rectangle, cut into dashes.

    Args:
        lines: (N, 4) device px; segments that go on from the one before make up one curve.
        room: device px.
        pattern: lengths on, off, on, off ... in px; () for solid lines.

    Returns:
        (M, 4) device px.
    """
    kept, begin, end = clip_lines(lines, room)
    if not pattern:
        return _parts(lines[kept], begin, end)
    return cut_dashes(lines[kept], begin, end, _arc_starts(lines)[kept], pattern)


def _parts(lines: Array, begin: Array, end: Array) -> Array:
    step = lines[:, 2:] - lines[:, :2]
    return np.hstack([lines[:, :2] + begin[:, None] * step, lines[:, :2] + end[:, None] * step])


def _arc_starts(lines: Array) -> Array:
    """Length of the curve before each segment; a segment that does not go on from the last begins
    a curve."""
    lengths = np.hypot(lines[:, 2] - lines[:, 0], lines[:, 3] - lines[:, 1])
    before = np.cumsum(lengths) - lengths
    breaks = np.ones(len(lines), dtype=bool)
    breaks[1:] = (np.abs(lines[1:, :2] - lines[:-1, 2:]) > 1e-6).any(axis=1)
    starts: Array = before - before[breaks][np.cumsum(breaks) - 1]
    return starts


def cut_dashes(
    lines: Array, begin: Array, end: Array, starts: Array, pattern: Sequence[float]
) -> Array:
    """Cut lines into dashes.

    Args:
        lines: (N, 4) device px.
        begin, end: (N,) the part of each line that is wanted, 0 to 1.
        starts: (N,) length of the curve before each line, px.
        pattern: lengths on, off, on, off ... in px.

    Returns:
        (M, 4) device px.
    """
    step = lines[:, 2:] - lines[:, :2]
    lengths = np.hypot(step[:, 0], step[:, 1])
    some = lengths > 1e-9
    lines, step, lengths = lines[some], step[some], lengths[some]
    starts, begin, end = starts[some], begin[some], end[some]
    period = sum(pattern)
    first = np.floor((starts + begin * lengths) / period)
    counts = (np.floor((starts + end * lengths) / period) - first + 1).astype(np.intp)
    row = np.repeat(np.arange(len(lines)), counts)
    number = first[row] + np.arange(len(row)) - np.repeat(np.cumsum(counts) - counts, counts)
    pieces = []
    edges = np.concatenate([[0.0], np.cumsum(pattern)])
    for on, off in zip(edges[0:-1:2], edges[1::2], strict=True):
        # positions on the line, as its fraction
        a = np.maximum((number * period + on - starts[row]) / lengths[row], begin[row])
        b = np.minimum((number * period + off - starts[row]) / lengths[row], end[row])
        keep = b > a
        pieces.append(_parts(lines[row[keep]], a[keep], b[keep]))
    return np.concatenate(pieces)


def _inside(positions: Array, room: Box) -> NDArray[np.bool_]:
    inside = (positions >= room[:2]) & (positions <= room[2:])
    return np.asarray(inside.all(axis=1))


def _paint_marks(painter: QPainter, marks: Marks, view: _View, near: Box) -> None:
    centres, unit = marks.centres, view.unit
    if not _contains(near, marks.box):
        centres = centres[_inside(centres, near)]
    centres = centres * view.scale + view.origin
    half = marks.size * unit / 2
    if marks.shape == "cross":
        corners = half * np.array([[-1, -1, 1, 1], [-1, 1, 1, -1]])
        lines = (np.tile(centres, 2)[:, None, :] + corners).reshape(-1, 4)
        draw_lines(painter, lines, _pen("#202020", 3.5 * unit))
        draw_lines(painter, lines, _pen(marks.colour, 1.8 * unit))
        return
    points = [QPointF(x, y) for x, y in centres.tolist()]
    if marks.shape == "ring":
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for colour, width in ((_RIM, 3.0), (QColor(marks.colour), 1.5)):
            painter.setPen(QPen(colour, width * unit))
            for point in points:
                painter.drawEllipse(point, half, half)
    elif marks.shape == "handle":
        painter.setPen(QPen(_RIM, unit))
        painter.setBrush(QColor(marks.colour))
        painter.drawRects([QRectF(p.x() - half, p.y() - half, 2 * half, 2 * half) for p in points])
    else:
        painter.setPen(QPen(_RIM, unit))
        painter.setBrush(QColor(marks.colour))
        for point in points:
            painter.drawEllipse(point, half, half)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _paint_labels(painter: QPainter, labels: Labels, view: _View, room: QRectF) -> None:
    if not labels.texts:
        return
    unit = view.unit
    font = QFont(painter.font())
    font.setPixelSize(max(1, round(_FONT_PIXELS * unit)))
    painter.setFont(font)
    metrics = QFontMetricsF(font)
    positions = labels.positions * view.scale + view.origin
    severity = Severity(labels.sign) if labels.sign else None
    sign = _SIGN * unit if severity is not None else 0.0
    near = _inside(labels.positions, view.reach(_LABEL_REACH * unit))
    for index in np.nonzero(near)[0].tolist():
        text = labels.texts[index]
        # A plate behind the text keeps it readable on grass, lines and crowd alike.
        wide = metrics.horizontalAdvance(text) + (8 * unit if text else 4 * unit) + sign
        size = QSizeF(wide, max(metrics.height(), sign) + 2 * unit)
        at = QPointF(*positions[index].tolist())
        plate = place_label(at, size, room, unit, below=labels.below)
        if not plate.intersects(view.area):
            continue
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(_PLATE)
        painter.drawRoundedRect(plate, 3 * unit, 3 * unit)
        if severity is not None:
            box = QRectF(plate.left() + 2 * unit, plate.center().y() - sign / 2, sign, sign)
            paint_finding_sign(painter, box, severity)
            plate.setLeft(box.right())
        painter.setPen(QColor(labels.colour))
        painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, text)


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
    gap = _LABEL_GAP * unit
    up = 2 * unit - gap - size.height()
    plate = QRectF(point, size).translated(gap, gap - 2 * unit if below else up)
    if not room.adjusted(-gap, -gap, gap, gap).contains(point):
        return plate
    if plate.right() > room.right():
        plate.moveRight(point.x() - gap)
    if plate.top() < room.top():
        plate.moveTop(point.y() + gap)
    elif below and plate.bottom() > room.bottom():
        plate.moveTop(point.y() + up)
    plate.moveLeft(max(room.left(), plate.left()))
    return plate
