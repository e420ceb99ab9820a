"""Plots as pictures and as numbers, to the clipboard and to files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QRectF, QSizeF, Qt
from PySide6.QtGui import QFont, QFontMetricsF, QImage, QImageWriter, QPainter, QPalette

from procc_annotator.gui.panels.plots.base import PlotPage
from procc_annotator.gui.panels.plots.legend import Legend

SHARPNESS = 3.0  # pixels of a picture for every pixel of the window, whatever its scale
_MARGIN = 10.0


class PlotPicture:
    """A page with its title, its legend and what is said of it, on anything that can be painted.

    Args:
        page: with something drawn.
        legend: of the sources.
        words: title and subtitle, and the notes below.
    """

    def __init__(self, page: PlotPage[Any], legend: Legend, words: tuple[str, str, str]) -> None:
        self._page, self._legend = page, legend
        self._title, self._subtitle, self._notes = words
        view = page.view.size()
        self._width = float(view.width())
        metrics = QFontMetricsF(page.font())
        self._line = metrics.height()
        self._title_height = 2.6 * self._line if self._subtitle else 1.5 * self._line
        self._legend_height = float(legend.heightForWidth(round(self._width)))
        bounds = metrics.boundingRect(
            QRectF(0, 0, self._width, 10_000), int(Qt.TextFlag.TextWordWrap), self._notes or " "
        )
        self._notes_height = bounds.height() + 4 if self._notes else 0.0
        height = self._title_height + self._legend_height + 6 + view.height() + self._notes_height
        self.size = QSizeF(self._width + 2 * _MARGIN, height + 2 * _MARGIN)

    def paint(self, painter: QPainter) -> None:
        """Paint it at the painter's origin, `size` large."""
        palette = self._page.palette()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(QRectF(0, 0, self.size.width(), self.size.height()), palette.base())
        text = palette.color(QPalette.ColorRole.Text)
        painter.setPen(text)
        bold = QFont(self._page.font())
        bold.setBold(True)
        painter.setFont(bold)
        top = _MARGIN
        left = int(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        painter.drawText(QRectF(_MARGIN, top, self._width, self._line), left, self._title)
        painter.setFont(self._page.font())
        if self._subtitle:
            second = QRectF(_MARGIN, top + 1.2 * self._line, self._width, self._line)
            painter.drawText(second, left, self._subtitle)
        top += self._title_height
        painter.save()
        painter.translate(_MARGIN, top)
        self._legend.paint(painter, self._width)
        painter.restore()
        top += self._legend_height + 6
        view = self._page.view
        place = QRectF(_MARGIN, top, self._width, view.height())
        view.render(painter, place, view.rect())
        top += view.height()
        if self._notes:
            painter.setPen(text)
            painter.setFont(self._page.font())
            notes = QRectF(_MARGIN, top + 4, self._width, self._notes_height)
            painter.drawText(notes, int(Qt.TextFlag.TextWordWrap), self._notes)

    def image(self) -> QImage:
        """As pixels, sharp enough to print."""
        size = (self.size * SHARPNESS).toSize()
        image = QImage(size, QImage.Format.Format_RGB32)
        image.setDevicePixelRatio(SHARPNESS)  # so that lines and dots grow with it
        image.fill(self._page.palette().color(QPalette.ColorRole.Base))
        painter = QPainter(image)
        self.paint(painter)
        painter.end()
        image.setDotsPerMeterX(round(96 * SHARPNESS / 0.0254))
        image.setDotsPerMeterY(round(96 * SHARPNESS / 0.0254))
        return image

    def svg(self) -> bytes:
        """As an SVG file's bytes."""
        from PySide6.QtSvg import QSvgGenerator  # only here: opening a window needs no SVG

        held = QByteArray()
        buffer = QBuffer(held)
        buffer.open(QIODevice.OpenModeFlag.WriteOnly)
        generator = QSvgGenerator()
        generator.setOutputDevice(buffer)
        generator.setTitle(self._title)
        generator.setSize(self.size.toSize())
        generator.setViewBox(QRectF(0, 0, self.size.width(), self.size.height()))
        painter = QPainter(generator)
        self.paint(painter)
        painter.end()
        return bytes(held.data())


def picture_writer(picture: PlotPicture, path: Path) -> Callable[[], bytes]:
    """Return what gives the bytes of a file of this name, SVG or PNG, from any thread.

    Call this itself on the interface thread: only there plots can be painted.
    """
    if path.suffix.lower() == ".svg":
        content = picture.svg()
        return lambda: content
    image = picture.image()
    return lambda: _png(image)


def _png(image: QImage) -> bytes:
    held = QByteArray()
    buffer = QBuffer(held)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, QByteArray(b"png")).write(image)
    return bytes(held.data())
