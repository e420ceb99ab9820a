"""Disagreement of two cameras as coloured bands over the picture."""

from __future__ import annotations

import itertools
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPolygonF, QTransform
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from procc_annotator.gui.state.disagreement import Map
from procc_annotator.interact import palette as tones

_OPACITY = 0.5
_LINE_WIDTH, _RIM_WIDTH = 1.5, 3.0  # points


class MapPaths:
    """Bands and lines of a map, ready to be painted."""

    def __init__(self, shown: Map) -> None:
        self._bands: list[tuple[QColor, QPainterPath]] = []
        for band, colour in zip(shown.bands, tones.DISAGREEMENT_COLOURS, strict=True):
            rings = itertools.chain.from_iterable(band.polygons)
            self._bands.append((QColor(colour), _path(rings, closed=True)))
        self._line = _path(shown.accuracy_lines, closed=False)

    def paint(self, painter: QPainter, to_device: QTransform) -> None:
        """Paint bands and the dashed line.

        Args:
            painter: in coordinates of the device, points.
            to_device: from the map's coordinates.
        """
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)  # seams would show
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setOpacity(_OPACITY)
        for colour, path in self._bands:
            if not path.isEmpty():
                painter.setBrush(colour)
                painter.drawPath(to_device.map(path))
        painter.setOpacity(1.0)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        line = to_device.map(self._line)
        for colour, width in ((tones.RIM, _RIM_WIDTH), (tones.HALO, _LINE_WIDTH)):
            painter.setPen(accuracy_pen(colour, width))
            painter.drawPath(line)
        painter.restore()


def accuracy_pen(colour: str, width: float) -> QPen:
    """Dashes of the line where the accuracy asked for ends; alike for every width."""
    pen = QPen(QColor(colour), width)
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    pen.setDashPattern([length / width for length in tones.ACCURACY_DASH])
    return pen


class DisagreementItem(QGraphicsItem):
    """Lies on the picture, under everything that is annotated or projected."""

    def __init__(self) -> None:
        super().__init__()
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemUsesExtendedStyleOption)
        self.setZValue(0.25)
        self._area = QRectF()
        self._paths: MapPaths | None = None
        self._to_scene = QTransform()

    def show_map(
        self, shown: Map | None, size: tuple[int, int], picture_size: tuple[int, int] | None
    ) -> None:
        """Show another map, or none.

        Args:
            shown: px of ``size``.
            size: (width, height) of the evaluation.
            picture_size: of the picture on screen.
        """
        self.prepareGeometryChange()
        if shown is None or picture_size is None:
            self._paths, self._area = None, QRectF()
            return
        self._paths = MapPaths(shown)
        self._area = QRectF(0, 0, *picture_size)
        across, down = ((p - 1) / (s - 1) for p, s in zip(picture_size, size, strict=True))
        # Pixel centres are whole numbers in the map and halves in the scene.
        self._to_scene = QTransform(across, 0, 0, down, 0.5, 0.5)
        self.update()

    def boundingRect(self) -> QRectF:
        return self._area

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionGraphicsItem,
        widget: QWidget | None = None,
    ) -> None:
        if self._paths is None:
            return
        world = painter.worldTransform()
        painter.save()
        painter.setClipRect(option.exposedRect, Qt.ClipOperation.IntersectClip)
        painter.resetTransform()
        self._paths.paint(painter, self._to_scene * world)
        painter.restore()


def _path(lines: Iterable[NDArray[np.float64]], *, closed: bool) -> QPainterPath:
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.OddEvenFill)
    for line in lines:
        path.addPolygon(QPolygonF([QPointF(x, y) for x, y in line.tolist()]))
        if closed:
            path.closeSubpath()
    return path
