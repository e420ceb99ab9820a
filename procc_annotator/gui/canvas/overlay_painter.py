"""Painting an overlay from its arrays: the one painter of the window and of overlay pictures.

Widths, sizes and dash lengths of an overlay are in points and do not grow with the picture. Lines
are painted by `drawLines` with flat caps, which is several times faster than paths; dashes are
therefore cut here, along whole curves, since Qt would start the pattern anew at every segment.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import cast

import numpy as np
import shiboken6
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF, QTransform

from procc_annotator.gui.canvas.label_plates import arranged, paint_plates
from procc_annotator.interaction.legend import LegendEntry
from procc_annotator.interaction.overlay_primitives import (
    Box,
    FilledArea,
    Labels,
    Overlay,
    PointMarks,
    Strokes,
)

Array = NDArray[np.float64]

_REACH = 24.0  # how far, in points, anything but text reaches beyond its position
_RIM = "#202020"


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
    lines_only: bool = False,
    text_times: float = 1.0,
    texts: tuple[Labels, ...] = (),
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
        lines_only: without marks and texts.
        text_times: how large texts are of what they usually are.
        texts: the texts of all layers, if it is one of several; they do not cover each other.
    """
    area = clip if clip is not None else QRectF(painter.viewport())
    seen = room if room is not None else QRectF(painter.viewport())
    view = _View(scale, offset[0] + 0.5 * scale, offset[1] + 0.5 * scale, unit, area)
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    near = view.reach(_REACH * unit)
    device = painter.worldTransform()
    painter.setWorldTransform(QTransform(scale, 0, 0, scale, view.x, view.y), combine=True)
    for patch in overlay.patches:
        _paint_patch(painter, patch, near)
    for strokes in overlay.seen_strokes:
        if _touches(strokes.box, near):
            _paint_strokes(painter, strokes, unit / scale, near)
    painter.setWorldTransform(device)
    for marks in () if lines_only else overlay.seen_marks:
        if _touches(marks.box, near):
            _paint_marks(painter, marks, view, near)
    if labelled and not lines_only and overlay.labels:
        at = scale, view.x, view.y
        room_box = seen.left(), seen.top(), seen.right(), seen.bottom()
        every = arranged(texts or overlay.labels, at, room_box, unit=unit, times=text_times)
        plates = [plate for plate in every if plate.labels in overlay.labels]
        paint_plates(painter, plates, view.area, unit=unit, times=text_times)
    painter.restore()


@dataclass(frozen=True, slots=True)
class _View:
    """From picture px to device px, and what of the device is wanted."""

    scale: float
    x: float  # device px of the first pixel's centre
    y: float
    unit: float
    area: QRectF

    def reach(self, margin: float) -> Box:
        """Picture px within a margin, device px, of what is wanted."""
        area, scale, x, y = self.area, self.scale, self.x, self.y
        left, top = (area.left() - margin - x) / scale, (area.top() - margin - y) / scale
        return left, top, (area.right() + margin - x) / scale, (area.bottom() + margin - y) / scale

    def places(self, positions: Array, near: Box) -> Iterator[tuple[int, float, float]]:
        """Those of some positions that lie near, with their rows, in device px."""
        left, top, right, bottom = near
        for row, (x, y) in enumerate(positions.tolist()):
            if left <= x <= right and top <= y <= bottom:
                yield row, x * self.scale + self.x, y * self.scale + self.y


def _touches(box: Box | None, other: Box) -> bool:
    if box is None:
        return False
    across = box[0] <= other[2] and box[2] >= other[0]
    return across and box[1] <= other[3] and box[3] >= other[1]


def _paint_patch(painter: QPainter, patch: FilledArea, near: Box) -> None:
    outline = patch.outline
    if not _touches((*outline.min(axis=0).tolist(), *outline.max(axis=0).tolist()), near):
        return
    colour = QColor(patch.colour)
    colour.setAlphaF(patch.opacity)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour)
    painter.drawPolygon(QPolygonF([QPointF(x, y) for x, y in outline.tolist()]))
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _paint_strokes(painter: QPainter, strokes: Strokes, point: float, near: Box) -> None:
    """Paint some strokes in picture px; ``point`` px make a point.

    Qt finds out sooner than we do what of a line is wanted; only dashes of curves are cut first.
    """
    lines, alone = strokes.segments, len(strokes.segments) == 1
    if strokes.dash and not alone:
        left, top, right, bottom = near
        room = QRectF(left, top, right - left, bottom - top)
        lines = visible_parts(lines, room, [d * point for d in strokes.dash])
    dashes = tuple(d / strokes.width for d in strokes.dash) if alone else ()
    draw_lines(painter, lines, _pen(strokes.colour, strokes.width * point, dashes))


@lru_cache(maxsize=256)
def _pen(colour: str, width: float, dashes: tuple[float, ...] = ()) -> QPen:
    """``dashes``: lengths on, off, on, off ... in widths."""
    pen = QPen(QColor(colour), width)
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    if dashes:
        pen.setDashPattern(dashes)
    return pen


@lru_cache(maxsize=64)
def _colour(name: str) -> QColor:
    return QColor(name)


def draw_lines(painter: QPainter, lines: Array, pen: QPen) -> None:
    """Draw (N, 4) px; the array is passed to Qt as it is (four doubles make a QLineF)."""
    if not len(lines):
        return
    memory = np.ascontiguousarray(lines, dtype=np.float64)
    painter.setPen(pen)
    address = memory.__array_interface__["data"][0]  # sooner than by `ctypes`
    painter.drawLines(cast(QLineF, shiboken6.wrapInstance(address, QLineF)), len(memory))


def clip_lines(lines: Array, room: QRectF) -> tuple[NDArray[np.intp], Array, Array]:
    """The part of each line (N, 4), device px, inside a rectangle (Liang-Barsky): rows of the lines
    that touch it, and where on them (0 to 1) the inside begins and ends."""
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
    """Return what of lines is to be drawn: inside a rectangle, cut into dashes.

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


def _paint_marks(painter: QPainter, marks: PointMarks, view: _View, near: Box) -> None:
    unit, half = view.unit, marks.size * view.unit / 2
    places = [(x, y) for _, x, y in view.places(marks.centres, near)]
    if marks.shape == "cross":
        for pen in (_pen(_RIM, 3.5 * unit), _pen(marks.colour, 1.8 * unit)):
            painter.setPen(pen)
            for x, y in places:
                left, top, right, bottom = x - half, y - half, x + half, y + half
                painter.drawLine(QPointF(left, top), QPointF(right, bottom))
                painter.drawLine(QPointF(left, bottom), QPointF(right, top))
        return
    boxes = [QRectF(x - half, y - half, 2 * half, 2 * half) for x, y in places]
    if marks.shape == "ring":
        for pen in (_pen(_RIM, 3.0 * unit), _pen(marks.colour, 1.5 * unit)):
            painter.setPen(pen)
            for box in boxes:
                painter.drawEllipse(box)
        return
    painter.setPen(_pen(_RIM, unit))
    painter.setBrush(_colour(marks.colour))
    if marks.shape == "handle":
        painter.drawRects(boxes)
    else:
        for box in boxes:
            painter.drawEllipse(box)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def paint_samples(
    painter: QPainter,
    entries: Iterable[LegendEntry],
    places: Iterable[tuple[float, float]],
    *,
    length: float,
    unit: float = 1.0,
) -> None:
    """Paint the samples of a legend: the lines of each entry, and its mark on their middle.

    Args:
        places: left end of each sample, device px.
        length: of the lines, device px.
        unit: device px per point.
    """
    strokes, marks = [], []
    for entry, (x, y) in zip(entries, places, strict=True):
        line = np.array([[x, y, x + length, y]])
        strokes += [Strokes(line, s.colour, s.width, s.dash) for s in entry.lines]
        if (mark := entry.mark) is not None:
            centre = np.array([[x + length / 2, y]])
            marks.append(PointMarks(centre, mark.shape, mark.colour, mark.size))
    # The painter of overlays puts whole numbers on pixel centres; here they are edges.
    overlay = Overlay(tuple(strokes), tuple(marks), ())
    paint_overlay(painter, overlay, scale=1.0, offset=(-0.5, -0.5), unit=unit)
