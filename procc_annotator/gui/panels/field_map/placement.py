"""Where the field map's lines are in its widget."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPolygonF

from procc_annotator.gui.panels.field_map.shape import FieldShape, FloatArray


@dataclass(frozen=True, eq=False)
class Placement:
    """A field laid into a part of a widget as large as it fits.

    Attributes:
        scale: points of the widget per metre of the map.
        origin: the field's centre in the widget.
        polygons: the line of each element.
        anchors: where each element bears its sign: no other line crosses there.
        ground: the field without what stands upright.
    """

    scale: float
    origin: QPointF
    polygons: tuple[QPolygonF, ...]
    anchors: tuple[QPointF, ...]
    ground: QRectF

    @classmethod
    def of(
        cls, shape: FieldShape, room: QRectF, zoom: float = 1.0, shift: QPointF | None = None
    ) -> Placement:
        """Lay a field into a part of a widget.

        Args:
            shape: the field.
            room: the part, which it fits into at zoom 1.
            zoom: so many times as large.
            shift: moved by this, widget points.
        """
        left, top, right, bottom = shape.bounds
        width, height = max(1.0, room.width()), max(1.0, room.height())
        scale = zoom * min(width / (right - left), height / (bottom - top))
        centre = QPointF((left + right) / 2, (top + bottom) / 2)
        origin = room.topLeft() + QPointF(width, height) / 2 - centre * scale
        origin += shift if shift is not None else QPointF()

        def place(line: FloatArray) -> list[QPointF]:
            at = line * scale + (origin.x(), origin.y())
            return [QPointF(x, y) for x, y in at.tolist()]

        corners = place(np.reshape(shape.ground, (2, 2)))
        return cls(
            scale,
            origin,
            tuple(QPolygonF(place(line)) for line in shape.lines),
            tuple(place(shape.anchors)),
            QRectF(*corners),
        )

    def to_widget(self, x: float, y: float) -> QPointF:
        """The position in the widget of metres on the map."""
        return self.origin + QPointF(x, y) * self.scale

    def to_field(self, position: QPointF) -> tuple[float, float]:
        """Metres on the map at a position of the widget."""
        at = (position - self.origin) / self.scale
        return at.x(), at.y()
