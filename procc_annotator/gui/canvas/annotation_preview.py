"""A picture made to fit, with an annotation drawn over it; nothing in it reacts."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.gui.canvas.overlay_painter import paint_overlay
from procc_annotator.gui.canvas.picture_item import image_of
from procc_annotator.image.pixels import PixelArray, downscaled
from procc_annotator.interaction.overlay import OverlayBuilder, OverlayContent
from procc_annotator.interaction.overlay_primitives import EMPTY_OVERLAY
from procc_annotator.translation import tr

_NO_PICTURE = QColor("#101214")
_WORDS = QColor("#98a0a8")


class AnnotationPreview(QWidget):
    """Shows polylines in the colours of their classes."""

    def __init__(self, picture: PixelArray | None, field: Field, size: tuple[int, int]) -> None:
        """Show an empty annotation on a picture (H, W, 4) BGRA; without one ``size``, (width,
        height) px, counts."""
        super().__init__()
        self.setObjectName("annotationPreview")
        self.setMinimumSize(160, 90)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._picture = picture
        self._field = field
        self._size = size if picture is None else (picture.shape[1], picture.shape[0])
        self._fitted: PixelArray | None = None
        self._image = QImage()
        self._builder = OverlayBuilder()
        self.overlay = EMPTY_OVERLAY

    def set_annotation(self, annotation: FrameAnnotation) -> None:
        """Show another annotation of the same frame."""
        size = self._size
        self.overlay = self._builder.build(
            OverlayContent(
                annotation=annotation,
                size=size,
                field=self._field,
                picture_size=size,
                colour_by="class",
            )
        )
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(480, 270)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        width, height = self._size
        scale = min(self.width() / width, self.height() / height)
        area = QRectF(0, 0, width * scale, height * scale)
        area.moveCenter(QRectF(self.rect()).center())
        self._paint_picture(painter, area)
        offset = area.left(), area.top()
        paint_overlay(painter, self.overlay, scale=scale, offset=offset, clip=QRectF(self.rect()))
        painter.end()

    def _paint_picture(self, painter: QPainter, area: QRectF) -> None:
        if self._picture is None:
            painter.fillRect(area, _NO_PICTURE)
            painter.setPen(_WORDS)
            corner = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop
            painter.drawText(area.adjusted(8, 6, -8, -6), corner, tr("The picture cannot be shown"))
            return
        ratio = self.devicePixelRatioF()
        size = max(1, round(area.width() * ratio)), max(1, round(area.height() * ratio))
        if self._fitted is None or self._fitted.shape[1::-1] != size:
            self._fitted = downscaled(self._picture, size)
            self._image = image_of(self._fitted)
            self._image.setDevicePixelRatio(ratio)
        painter.drawImage(QPointF(area.topLeft().toPoint()), self._image)
