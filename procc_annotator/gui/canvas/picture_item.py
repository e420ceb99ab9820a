"""The picture in the scene: every pixel as it is when magnified, averaged when reduced."""

from __future__ import annotations

from collections.abc import Iterable
from typing import cast

from PySide6.QtCore import QPointF, QRect, QRectF
from PySide6.QtGui import QImage, QPainter, QRegion, QTransform
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from procc_annotator.image.pixels import DownscaledImages, PixelArray


def image_of(pixels: PixelArray) -> QImage:
    """A QImage that shares the memory of (H, W, 4) BGRA pixels; keep the array alive next to it."""
    height, width = pixels.shape[:2]
    return QImage(pixels.data, width, height, pixels.strides[0], QImage.Format.Format_RGB32)


class PictureItem(QGraphicsItem):
    """Covers (0, 0, W, H) of the scene: pixel (x, y) is the unit square that begins there."""

    def __init__(self) -> None:
        super().__init__()
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemUsesExtendedStyleOption)
        self._pixels: PixelArray | None = None
        self._size = 0, 0
        self._image = QImage()
        self.reduced = DownscaledImages()
        self._small: PixelArray | None = None
        self._small_image = QImage()
        self.wanted = QRegion()  # of the view, what is painted now

    def set_picture(self, pixels: PixelArray | None, size: tuple[int, int] | None) -> None:
        """Show another picture, or none.

        Args:
            pixels: (h, w, 4) BGRA, as many as there are or half as many a side.
            size: (width, height) px that it covers.
        """
        if (size or (0, 0)) != self._size:
            self.prepareGeometryChange()
            self._size = size or (0, 0)
        self._pixels = pixels
        self._image = QImage() if pixels is None else image_of(pixels)
        self._small, self._small_image = None, QImage()
        self.update()

    @property
    def is_empty(self) -> bool:
        """Return whether there is no picture to be painted."""
        return self._pixels is None

    def boundingRect(self) -> QRectF:
        return QRectF(0, 0, *self._size)

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
            across = self._image.width() / self._size[0], self._image.height() / self._size[1]
            painter.drawImage(part, self._image, QTransform.fromScale(*across).mapRect(part))
            return
        small = self.reduced.of(self._pixels, scale, self._size)
        if small is not self._small:
            self._small, self._small_image = small, image_of(small)
        self._small_image.setDevicePixelRatio(ratio)
        # Pixel by pixel, on whole pixels of the screen: nothing is sampled again.
        world = painter.worldTransform()
        painter.setWorldTransform(QTransform())
        at = QPointF(round(world.dx() * ratio), round(world.dy() * ratio)) / ratio
        if self.wanted.rectCount() > 1 and ratio == round(ratio):
            # Place by place: inside one rectangle a row is copied, inside several it is woven.
            for place in cast(Iterable[QRect], self.wanted):
                painter.setClipRect(place)
                painter.drawImage(at, self._small_image)
            painter.setClipping(False)
        else:
            painter.drawImage(at, self._small_image)
        painter.setWorldTransform(world)
