"""A map in metres as bands and lines over the picture."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QTransform
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from procc_annotator.gui.canvas.metre_map_picture import paint_shapes
from procc_annotator.gui.state.map_shapes import MapShapes


class MetreMapItem(QGraphicsItem):
    """Lies on the picture, under everything that is annotated or projected."""

    def __init__(self) -> None:
        super().__init__()
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemUsesExtendedStyleOption)
        self.setZValue(0.25)
        self._area = QRectF()
        self._shapes: MapShapes | None = None
        self._to_scene = QTransform()

    def show_shapes(
        self,
        shown: MapShapes | None,
        size: tuple[int, int],
        picture_size: tuple[int, int] | None,
    ) -> None:
        """Show another map, or none.

        Args:
            shown: px of ``size``.
            size: (width, height) of the picture whose pixels they are in.
            picture_size: of the picture on screen.
        """
        self.prepareGeometryChange()
        if shown is None or picture_size is None:
            self._shapes, self._area = None, QRectF()
            return
        self._shapes = shown
        self._area = QRectF(0, 0, *picture_size)
        across, down = ((p - 1) / (s - 1) for p, s in zip(picture_size, size, strict=True))
        # Pixel centres are whole numbers in the shapes and halves in the scene.
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
        if self._shapes is None:
            return
        world = painter.worldTransform()
        painter.save()
        painter.setClipRect(option.exposedRect, Qt.ClipOperation.IntersectClip)
        painter.resetTransform()
        paint_shapes(painter, self._shapes, self._to_scene * world)
        painter.restore()
