"""The picture in the scene, and its pixels after display adjustment."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import cast

from PySide6.QtCore import QObject, QPointF, QRect, QRectF, Signal
from PySide6.QtGui import QImage, QPainter, QTransform
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from procc_annotator.gui.state.background import ComputedValue, Inputs
from procc_annotator.image.pixels import (
    DisplayAdjustment,
    DownscaledImages,
    PixelArray,
    adjust_image,
)


class ShownPicture(QObject):
    """Pixels of the frame on screen in the chosen look; the frame's own pixels are never touched.

    A lookup table is applied at once. Line enhancement takes too long for that: until it is done
    the picture is shown without.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.look = self._without = DisplayAdjustment()  # and without enhancement
        self._picture: PixelArray | None = None
        self._whole = True
        self._plain = ComputedValue(self._given, adjust_image, self, background=False)
        self._enhanced = ComputedValue(self._to_enhance, adjust_image, self)
        self._enhanced.changed.connect(self._arrived)

    @property
    def pixels(self) -> PixelArray | None:
        """Return what to show; None without a picture."""
        enhanced = self._enhanced.value
        return self._plain.value if enhanced is None else enhanced

    def set_picture(self, picture: PixelArray | None, *, whole: bool = True) -> None:
        """Another frame, or a first look at it; announced by no one, the caller shows `pixels`."""
        self._picture, self._whole = picture, whole
        self._enhanced.invalidate()

    def set_look(self, look: DisplayAdjustment) -> None:
        """Another look, kept across frames."""
        if look != self.look:
            self.look, self._without = look, replace(look, enhance=False)
            self._enhanced.clear()
            self._enhanced.invalidate()
            self.changed.emit()

    def _given(self) -> Inputs | None:
        return None if self._picture is None else (self._picture, self._without)

    def _to_enhance(self) -> Inputs | None:
        if self._picture is None or not (self._whole and self.look.enhance):
            return None
        return self._picture, self.look

    def _arrived(self) -> None:
        if self._enhanced.value is not None:
            self.changed.emit()


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

    def set_picture(self, pixels: PixelArray | None, size: tuple[int, int] | None) -> None:
        """Show another picture, (h, w, 4) BGRA, or none; it covers ``size``, (width, height) px,
        and has as many pixels or half as many a side."""
        if (size or (0, 0)) != self._size:
            self.prepareGeometryChange()
            self._size = size or (0, 0)
        self._pixels = pixels
        self._image = QImage() if pixels is None else image_of(pixels)
        self._small, self._small_image = None, QImage()
        self.update()

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
        for place in exposed_rects(painter):
            painter.setClipRect(place)
            painter.drawImage(at, self._small_image)
        painter.setClipping(False)
        painter.setWorldTransform(world)


def exposed_rects(painter: QPainter) -> list[QRectF]:
    """Return the rectangles that are painted now, logical px, by a painter without a world
    transform: Qt copies or blends an image several times as fast within one rectangle as within a
    region of several."""
    region = painter.paintEngine().systemClip()
    if region.isEmpty():
        return [QRectF(painter.viewport())]
    to_logical, _ = painter.deviceTransform().inverted()
    return [to_logical.mapRect(QRectF(place)) for place in cast(Iterable[QRect], region)]
