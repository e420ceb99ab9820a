"""Overlay pictures without a window: the painter of the canvas on pixels in memory, or in SVG."""

from __future__ import annotations

import math
from base64 import b64encode
from collections.abc import Sequence

import cv2
import numpy as np
from PySide6.QtCore import QBuffer, QByteArray, QCoreApplication, QIODevice, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter
from PySide6.QtSvg import QSvgGenerator
from PySide6.QtWidgets import QApplication

from procc_annotator.figures.overlay import encode_picture, resized, scene_content
from procc_annotator.gui.canvas.overlay_painter import paint_overlay, paint_samples
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction.legend import LegendEntry, legend_of
from procc_annotator.interaction.overlay import OverlayBuilder
from procc_annotator.report.overlay_scene import (
    GROUND_BGRA,
    OverlayLook,
    Scene,
    caption,
    check_overlay_suffix,
    check_pixels,
    pixels_of,
)
from procc_annotator.translation import in_english


def paint_caption(painter: QPainter, text: str, area: QRectF, unit: float, font_px: int) -> None:
    """Paint a line of words on a dark band of an area, px of the painter; nothing for none.
    ``unit`` is px of a point, ``font_px`` the height of the letters."""
    if not text:
        return
    font = QFont()
    font.setPixelSize(font_px)
    metrics = QFontMetricsF(font)
    band = QRectF(0, 0, metrics.horizontalAdvance(text) + 16 * unit, metrics.height() + 8 * unit)
    band.moveBottomLeft(area.bottomLeft())
    painter.fillRect(band, QColor(32, 32, 32, 200))
    painter.setFont(font)
    painter.setPen(QColor("white"))
    painter.drawText(band, Qt.AlignmentFlag.AlignCenter, text)


_BACKGROUND, _TEXT = QColor("#202020"), QColor("#ffffff")
# In points.
_FONT = 13.0
_SAMPLE = 36.0
_GAP = 8.0  # between a sample and its text
_MARGIN = 10.0
_BETWEEN = 22.0  # between entries of a line
_LINE = 21.0
# Other fonts than the one measured here may be wider: a browser has its own.
_SLACK = 1.08

_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


class LegendBand:
    """A heading and entries, wrapped to a width.

    Args:
        heading: one line or more above the entries; may be empty.
        width: px of the picture.
        unit: px per point.

    Attributes:
        height: px.
    """

    def __init__(
        self, heading: str, entries: Sequence[LegendEntry], width: int, unit: float
    ) -> None:
        self._unit = unit
        self._width = width
        self._font = QFont()
        self._font.setPixelSize(max(1, round(_FONT * unit)))
        self._metrics = QFontMetricsF(self._font)
        self._heading = self._wrapped(heading)
        self._placed: list[tuple[LegendEntry, float, int]] = []  # entry, x in px, line
        lines = self._place(entries)
        self.height = math.ceil((2 * _MARGIN + _LINE * lines) * unit)

    def _wrapped(self, text: str) -> list[str]:
        room = self._width - 2 * _MARGIN * self._unit
        lines: list[str] = []
        for word in text.split():
            longer = f"{lines[-1]} {word}" if lines else word
            if lines and self._metrics.horizontalAdvance(longer) * _SLACK <= room:
                lines[-1] = longer
            else:
                lines.append(word)
        return lines

    def _place(self, entries: Sequence[LegendEntry]) -> int:
        """Flow the entries below the heading; returns the number of lines."""
        line, x = len(self._heading), _MARGIN * self._unit
        for entry in entries:
            text = self._metrics.horizontalAdvance(entry.text) * _SLACK
            taken = (_SAMPLE + _GAP) * self._unit + text
            beyond = x + taken > self._width - _MARGIN * self._unit
            if beyond and x > _MARGIN * self._unit:
                line, x = line + 1, _MARGIN * self._unit
            self._placed.append((entry, x, line))
            x += taken + _BETWEEN * self._unit
        return line + 1 if self._placed else line

    def paint(self, painter: QPainter, top: float) -> None:
        """Paint the band with its upper edge at ``top``, device px."""
        unit = self._unit
        area = QRectF(0, top, self._width, self.height)
        painter.fillRect(area, _BACKGROUND)
        middles = [
            top + (_MARGIN + _LINE * (row + 0.5)) * unit
            for row in range(1 + max([line for *_, line in self._placed], default=0))
        ]
        places = [(x, middles[row] if row < len(middles) else top) for _, x, row in self._placed]
        entries = [entry for entry, *_ in self._placed]
        paint_samples(painter, entries, places, length=_SAMPLE * unit, unit=unit)
        painter.setFont(self._font)
        painter.setPen(_TEXT)
        half = _LINE * unit / 2
        for row, text in enumerate(self._heading):
            y = top + (_MARGIN + _LINE * row) * unit
            room = QRectF(_MARGIN * unit, y, self._width, _LINE * unit)
            painter.drawText(room, _LEFT, text)
        for entry, x, row in self._placed:
            start = x + (_SAMPLE + _GAP) * unit
            room = QRectF(start, middles[row] - half, self._width, 2 * half)
            painter.drawText(room, _LEFT, entry.text)


_JPEG = (cv2.IMWRITE_JPEG_QUALITY, 88)


class OverlayPictures:
    """Called with a scene, gives the picture encoded as ``.png``, ``.jpg`` or ``.svg``;
    `UsageError` for another suffix."""

    def __init__(self, suffix: str, look: OverlayLook | None = None) -> None:
        check_overlay_suffix(suffix)
        self._suffix = suffix
        self._look = look if look is not None else OverlayLook()
        # Text needs an application object, though no display; it must outlive the painting.
        self._application = QCoreApplication.instance() or QApplication(
            ["procc-annotator", "-platform", "offscreen"]
        )

    def __call__(self, scene: Scene) -> bytes:
        """The encoded picture; `ImageError` if it cannot be decoded, `UsageError` if the result
        would be too large."""
        with in_english():
            drawing = _Drawing(scene, self._look)
            if self._suffix == ".svg":
                return drawing.svg()
            settings = _JPEG if self._suffix == ".jpg" else ()
            return encode_picture(drawing.pixels(), self._suffix, scene.title, settings)

    def pixels(self, scene: Scene) -> PixelArray:
        """The picture as (H, W, 3) BGR; errors as of a call."""
        with in_english():
            return _Drawing(scene, self._look).pixels()


class _Drawing:
    """A scene with its measures: where the picture, its overlay and its legend go."""

    def __init__(self, scene: Scene, look: OverlayLook) -> None:
        self._scene = scene
        self._caption = caption(scene) if look.caption else ""
        self._pixels = pixels_of(scene)
        height, width = self._pixels.shape[:2]
        self._scale, self._unit = look.scale_and_unit(width)
        self._size = max(1, round(width * self._scale)), max(1, round(height * self._scale))
        self._overlay = OverlayBuilder().build(scene_content(scene, self._pixels))
        self._band = None
        if look.legend:
            setup = scene.setup
            entries = legend_of(
                scene.annotation, setup.field, scene.measurement, scene.score, setup.size,
                with_paint=scene.paint is not None,
            )  # fmt: skip
            heading = " – ".join(part for part in (scene.title, caption(scene)) if part)
            self._band = LegendBand(heading, entries, self._size[0], self._legend_unit)

    @property
    def _legend_unit(self) -> float:
        """Px per point of the legend, which must be read though the picture is made small."""
        return float(max(self._unit, min(1.0, self._size[0] / 640)))

    @property
    def _whole(self) -> tuple[int, int]:
        below = 0 if self._band is None else self._band.height
        return self._size[0], self._size[1] + below

    def pixels(self) -> PixelArray:
        """(H, W, 3) BGR."""
        width, height = self._whole
        check_pixels(width, height)
        canvas = np.zeros((height, width, 4), dtype=np.uint8)
        canvas[: self._size[1]] = resized(self._pixels, self._scale)
        # Painting goes straight into the array, whose memory the image shares.
        image = QImage(canvas.data, width, height, canvas.strides[0], QImage.Format.Format_RGB32)
        painter = QPainter(image)
        self._paint(painter)
        painter.end()
        return canvas[:, :, :3]

    def svg(self) -> bytes:
        """The picture as SVG: the pixels as they are, everything else as lines and text."""
        width, height = self._whole
        content = QByteArray()
        buffer = QBuffer(content)
        buffer.open(QIODevice.OpenModeFlag.WriteOnly)
        generator = QSvgGenerator()
        generator.setOutputDevice(buffer)
        generator.setSize(QSize(width, height))
        generator.setViewBox(QRectF(0, 0, width, height))
        generator.setTitle(self._scene.title or "Overlay picture")
        generator.setDescription(caption(self._scene) or "Annotation without a camera")
        painter = QPainter(generator)
        painter.setClipRect(QRectF(0, 0, width, height))
        self._paint(painter)
        painter.end()
        buffer.close()
        return _with_picture(bytes(content.data()), self._embedded(), width, height)

    def _embedded(self) -> str:
        """The picture below the strokes, as an SVG element."""
        width, height = self._size
        if self._scene.image_path is None:
            blue, green, red, _ = GROUND_BGRA
            return f'<rect width="{width}" height="{height}" fill="rgb({red},{green},{blue})"/>'
        lossless = self._scene.image_path.suffix.lower() in (".png", ".bmp")
        suffix, kind = (".png", "png") if lossless else (".jpg", "jpeg")
        settings = () if lossless else (cv2.IMWRITE_JPEG_QUALITY, 95)
        encoded = encode_picture(self._pixels, suffix, self._scene.title, settings)
        data = b64encode(encoded).decode("ascii")
        return (
            f'<image width="{width}" height="{height}" preserveAspectRatio="none"'
            f' xlink:href="data:image/{kind};base64,{data}"/>'
        )

    def _paint(self, painter: QPainter) -> None:
        width, height = self._size
        area = QRectF(0, 0, width, height)
        painter.save()
        painter.setClipRect(area)
        paint_overlay(
            painter, self._overlay, scale=self._scale, unit=self._unit, clip=area, room=area
        )  # fmt: skip
        painter.restore()
        if self._band is None:
            font_px = max(1, round(14 * self._unit))
            paint_caption(painter, self._caption, area, self._unit, font_px)
        else:
            self._band.paint(painter, float(height))


def _with_picture(svg: bytes, picture: str, width: int, height: int) -> bytes:
    """Put the picture first, and say the size in px: Qt writes millimetres of its own resolution.

    Qt would embed any picture as PNG, several times as large as the JPEG most frames are.
    """
    head, end, rest = svg.decode().partition("</defs>")
    before, _, after = head.partition(' width="')
    _, _, after = after.partition(' viewBox="')
    sized = f'{before} width="{width}" height="{height}" viewBox="{after}'
    # A reader without the font must not fall back to one with serifs, which is of another width.
    drawn = rest.replace('" font-size="', ', sans-serif" font-size="')
    return f"{sized}{end}\n{picture}{drawn}".encode()
