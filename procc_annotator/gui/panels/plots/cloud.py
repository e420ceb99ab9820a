"""Thousands of dots at once; pyqtgraph's own take three milliseconds a thousand."""

from __future__ import annotations

import pyqtgraph as pg
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QStyleOptionGraphicsItem, QWidget

from procc_annotator.batch.audit import FloatArray

_SIZE = 3.0  # logical px


class DotCloud(pg.GraphicsObject):  # type: ignore[misc]
    """Square dots of one colour; takes no part in finding the range of the axes."""

    def __init__(self) -> None:
        super().__init__()
        self._polygon = QPolygonF()
        self._pen = QPen()
        self._bounds = QRectF()

    def show_dots(self, x: FloatArray, y: FloatArray, colour: QColor) -> None:
        """Show other dots."""
        self.prepareGeometryChange()
        self._polygon = pg.functions.arrayToQPolygonF(x.astype(float), y.astype(float))
        self._bounds = self._polygon.boundingRect()
        self._pen = QPen(colour, _SIZE)
        self.update()

    def boundingRect(self) -> QRectF:
        return self._bounds

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionGraphicsItem,
        widget: QWidget | None = None,
    ) -> None:
        # In px of the device: the axes' scales, which differ, would make dashes of the dots.
        places = painter.worldTransform().map(self._polygon)
        painter.save()
        painter.resetTransform()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        painter.setPen(self._pen)
        painter.drawPoints(places)
        painter.restore()

    def dataBounds(self, *_: object, **__: object) -> tuple[None, None]:
        """Said by pyqtgraph's items: no part in the range."""
        return None, None
