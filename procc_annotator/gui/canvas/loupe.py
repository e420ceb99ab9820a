"""A magnifier next to the cursor: the picture's own pixels, whatever the zoom of the view."""

from __future__ import annotations

import math

import cv2
import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from procc_annotator.gui.canvas.overlay_painter import paint_overlay
from procc_annotator.gui.canvas.picture_item import image_of
from procc_annotator.gui.canvas.viewport_overlays import ViewportOverlay
from procc_annotator.gui.theme import fixed_width
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction.overlay_primitives import Overlay

_SIDE = 200  # of the magnified square, points
_LINE = 22  # of text below it
_DISTANCE = 28  # from the cursor to the nearest edge
_RIM = QColor("#101010")
_FRAME = QColor("#f0f0f0")
_CROSS_RIM = QColor(16, 16, 16, 150)
_OUTSIDE = np.array([24, 24, 24, 255], np.uint8).view(np.uint32)[0]  # b, g, r, a beyond the picture


class Loupe(ViewportOverlay):
    """A square of the picture around the cursor, with what is drawn over it and its position.

    It keeps clear of the cursor.
    """

    FACTOR = 8  # points per picture px

    def __init__(self, viewport: QWidget) -> None:
        # Not opaque, as far as Qt knows: an opaque child that moves is painted twice a move.
        super().__init__(viewport, "loupe")
        self._viewport = viewport
        self.resize(_SIDE, _SIDE + _LINE)
        self._centre = (0.0, 0.0)
        self._pixels: PixelArray | None = None
        self._layers: tuple[Overlay, ...] = ()

    def show_at(
        self,
        cursor: QPointF,
        picture_px: tuple[float, float],
        pixels: PixelArray,
        *layers: Overlay,
    ) -> None:
        """Show the surroundings of a picture position.

        Args:
            cursor: viewport, points; the loupe stands next to it, or is hidden when the viewport
                has no room for it there.
            picture_px: the middle of what is shown; pixel centres are whole numbers.
            pixels: (H, W, 4) BGRA; kept until the next call.
            layers: drawn over the pixels, first to last, without their labels, which would cover
                them.
        """
        place = place_beside(cursor, self.size(), self._viewport.size())
        if place is None:
            self.hide()
            return
        self._centre, self._pixels, self._layers = picture_px, pixels, layers
        self.put(QRect(place, self.size()))
        if not self.isVisible():
            self.show()
            self.raise_()
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        ratio = self.devicePixelRatioF()
        # From here on in whole pixels of the screen, wherever the window lies on them.
        painter.scale(1 / ratio, 1 / ratio)
        device = painter.deviceTransform()
        painter.translate(round(device.dx()) - device.dx(), round(device.dy()) - device.dy())
        width, side = math.ceil(self.width() * ratio), math.ceil(_SIDE * ratio)
        height = math.ceil(self.height() * ratio)
        painter.fillRect(QRectF(0, 0, width, height), _RIM)
        if self._pixels is not None:
            self._paint_picture(painter, self._pixels, side, ratio)
        self._paint_text(painter, QRectF(0, side, width, height - side), ratio)
        self._paint_border(painter, width, height, ratio)
        painter.end()

    def _paint_picture(
        self, painter: QPainter, pixels: PixelArray, side: int, ratio: float
    ) -> None:
        factor = max(1, round(self.FACTOR * ratio))
        line = max(1, round(ratio))
        middle = (side - line) // 2 + line / 2  # of a line that lies on whole screen pixels
        # The picture's corner on whole screen pixels: then the edges of all its pixels are, too.
        corner = tuple(round(middle - (c + 0.5) * factor) for c in self._centre)
        magnified = magnify(pixels, corner, factor, side)
        painter.drawImage(QPointF(0, 0), image_of(magnified))
        area = QRectF(0, 0, side, side)
        painter.save()
        painter.setClipRect(area)
        offset = float(corner[0]), float(corner[1])
        for layer in self._layers:
            paint_overlay(
                painter, layer, scale=factor, offset=offset, unit=ratio, clip=area, labelled=False
            )
        painter.restore()
        _paint_crosshair(painter, middle, side, line)

    def _paint_text(self, painter: QPainter, area: QRectF, ratio: float) -> None:
        font = QFont(fixed_width(self.font()))
        font.setPixelSize(round(12 * ratio))
        painter.setFont(font)
        painter.setPen(_FRAME)
        painter.drawText(area, Qt.AlignmentFlag.AlignCenter, position_text(self._centre))

    def _paint_border(self, painter: QPainter, width: int, height: int, ratio: float) -> None:
        """Light between two dark lines: one of them differs from whatever lies next to it."""
        line = max(1, round(ratio))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for inset, colour in ((0, _RIM), (line, _FRAME), (2 * line, _RIM)):
            edge = inset + line / 2
            pen = QPen(colour, line)
            pen.setJoinStyle(Qt.PenJoinStyle.MiterJoin)
            painter.setPen(pen)
            painter.drawRect(QRectF(edge, edge, width - 2 * edge, height - 2 * edge))


def place_beside(cursor: QPointF, size: QSize, room: QSize) -> QPoint | None:
    """Return the top left corner, points, of a box next to the cursor in a room that begins at (0,
    0): right and below if it fits, else on the other side. It never covers the cursor; None
    without room."""
    if size.width() > room.width() or size.height() > room.height():
        return None
    x = _beside(cursor.x(), size.width(), room.width())
    y = _beside(cursor.y(), size.height(), room.height())
    if x is None and y is None:
        return None
    # Next to the cursor in one direction is enough.
    if x is None:
        x = _within(cursor.x(), size.width(), room.width())
    if y is None:
        y = _within(cursor.y(), size.height(), room.height())
    return QPoint(x, y)


def _beside(cursor: float, size: int, room: int) -> int | None:
    after = math.ceil(cursor + _DISTANCE)
    before = math.floor(cursor - _DISTANCE - size)
    if 0 <= after <= room - size:
        return after
    return before if 0 <= before <= room - size else None


def _within(cursor: float, size: int, room: int) -> int:
    return min(max(0, round(cursor - size / 2)), room - size)


def magnify(pixels: PixelArray, corner: tuple[int, ...], factor: int, side: int) -> PixelArray:
    """A part (side, side, 4) of a picture (H, W, 4) BGRA, every pixel a square block of so many px;
    dark where there is no picture. ``corner``: its top left corner in the result, px."""
    result = np.empty((side, side, 4), dtype=np.uint8)
    result.view(np.uint32).fill(_OUTSIDE)
    spans = []
    for start, count in zip(corner, pixels.shape[1::-1], strict=True):
        first = max(0, -start // factor)
        last = min(count, -((start - side) // factor))
        if first >= last:
            return result
        begin, end = start + first * factor, start + last * factor
        spans.append((first, last, begin, slice(max(0, begin), min(side, end))))
    (x0, x1, left, across), (y0, y1, top, down) = spans
    part = np.ascontiguousarray(pixels[y0:y1, x0:x1])
    size = (x1 - x0) * factor, (y1 - y0) * factor
    blocks: NDArray[np.uint8] = np.asarray(
        cv2.resize(part, size, interpolation=cv2.INTER_NEAREST), dtype=np.uint8
    )
    result[down, across] = blocks[
        down.start - top : down.stop - top, across.start - left : across.stop - left
    ]
    return result


def position_text(centre: tuple[float, float]) -> str:
    """A picture position as the loupe writes it."""
    return f"{centre[0]:.2f}  {centre[1]:.2f} px".replace("-", "−")


def _paint_crosshair(painter: QPainter, middle: float, side: int, line: int) -> None:
    """Thin lines that end short of the middle, which stays visible, and a dot there; screen px.
    A dark rim of the same width keeps them readable on white."""
    gap, far = 7.0 * line, side - middle
    for colour, half in ((_CROSS_RIM, 1.5 * line), (_FRAME, 0.5 * line)):
        for begin, end in ((-middle, -gap), (gap, far)):
            painter.fillRect(QRectF(middle - half, middle + begin, 2 * half, end - begin), colour)
            painter.fillRect(QRectF(middle + begin, middle - half, end - begin, 2 * half), colour)
        painter.fillRect(QRectF(middle - half, middle - half, 2 * half, 2 * half), colour)
