"""The picture in the scene: every pixel as it is when magnified, averaged when reduced."""

from __future__ import annotations

import cv2
import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from procc_annotator.image.decode import PixelArray


def image_of(pixels: PixelArray) -> QImage:
    """A QImage that shares the memory of (H, W, 4) BGRA pixels; keep the array alive beside it."""
    height, width = pixels.shape[:2]
    return QImage(pixels.data, width, height, pixels.strides[0], QImage.Format.Format_RGB32)


def reduced(pixels: PixelArray, size: tuple[int, int]) -> PixelArray:
    """A picture made smaller, to (width, height), without losing thin lines.

    Below one half, sampling between four neighbours would skip pixels; averaging comes first. It
    is done by whole factors, where it takes a thirtieth of the time.
    """
    factor = 1
    while pixels.shape[1] >= 2 * factor * size[0] and pixels.shape[0] >= 2 * factor * size[1]:
        factor *= 2
    small = pixels
    if factor > 1:
        inner = pixels.shape[1] // factor, pixels.shape[0] // factor
        small = np.asarray(cv2.resize(pixels, inner, interpolation=cv2.INTER_AREA), dtype=np.uint8)
    return np.asarray(cv2.resize(small, size, interpolation=cv2.INTER_LINEAR), dtype=np.uint8)


class PictureItem(QGraphicsItem):
    """Covers (0, 0, W, H) of the scene: pixel (x, y) is the unit square that begins there."""

    def __init__(self) -> None:
        super().__init__()
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemUsesExtendedStyleOption)
        self._pixels: PixelArray | None = None
        self._image = QImage()
        self._reduced: PixelArray | None = None
        self._reduced_image = QImage()

    def set_picture(self, pixels: PixelArray | None) -> None:
        """Show another picture, or none."""
        if pixels is None or self._pixels is None or pixels.shape != self._pixels.shape:
            self.prepareGeometryChange()
        self._pixels = pixels
        self._image = QImage() if pixels is None else image_of(pixels)
        self._reduced, self._reduced_image = None, QImage()
        self.update()

    def boundingRect(self) -> QRectF:
        return QRectF(self._image.rect())

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionGraphicsItem,
        widget: QWidget | None = None,
    ) -> None:
        if self._pixels is None:
            return
        ratio = painter.device().devicePixelRatio()
        scale = painter.worldTransform().m11() * ratio
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, False)
        if scale >= 1:
            shown = option.exposedRect
            part = QRectF(shown.toAlignedRect()) & self.boundingRect()
            painter.drawImage(part, self._image, part)
            return
        height, width = self._pixels.shape[:2]
        size = max(1, round(width * scale)), max(1, round(height * scale))
        if self._reduced is None or self._reduced.shape[1::-1] != size:
            self._reduced = reduced(self._pixels, size)
            self._reduced_image = image_of(self._reduced)
        painter.drawImage(self.boundingRect(), self._reduced_image)
