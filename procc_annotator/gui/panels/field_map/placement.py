"""Where the field map's lines are in its widget, magnified and moved by hands."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPolygonF

from procc_annotator.gui.panels.field_map.shape import FieldShape, FloatArray

_LARGEST = 40.0
_STEP = 1.0015  # an eighth of a degree of the wheel
_DRAG = 4.0  # widget points: less is a click


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


class MapView:
    """Zoom and shift of a map, changed by hands.

    Attributes:
        zoom: 1 where the whole map is in sight.
        shift: widget points.
        dragging: whether the map is being moved, and the button that is held means no click.
    """

    def __init__(self) -> None:
        self.zoom, self.shift, self.dragging = 1.0, QPointF(), False
        self._pressed: QPointF | None = None
        self._before = QPointF()

    def reset(self) -> None:
        """Show the whole map."""
        self.zoom, self.shift = 1.0, QPointF()

    def wheel(self, turned: float, cursor: QPointF, centre: QPointF) -> None:
        """Magnify; what is under the cursor stays there.

        Args:
            turned: eighths of a degree, forward is larger.
            cursor, centre: the mouse, and the middle of the map's room, widget points.
        """
        zoom = min(_LARGEST, max(1.0, self.zoom * _STEP**turned))
        beside = cursor - centre
        self.shift = beside - (beside - self.shift) * (zoom / self.zoom)
        self.zoom = zoom
        if zoom == 1.0:
            self.shift = QPointF()

    def press(self, cursor: QPointF) -> None:
        """A button went down: the map may be moved from now on."""
        self._pressed, self._before, self.dragging = cursor, self.shift, False

    def move(self, cursor: QPointF) -> bool:
        """The mouse moved; whether the map did."""
        if self._pressed is None or self.zoom == 1.0:
            return False
        moved = cursor - self._pressed
        self.dragging = self.dragging or moved.manhattanLength() > _DRAG
        if self.dragging:
            self.shift = self._before + moved
        return self.dragging

    def release(self) -> bool:
        """The button came up; whether it moved the map."""
        moved, self.dragging, self._pressed = self.dragging, False, None
        return moved


_STEEPEST = 3.0  # how much farther aside than along the way something may lie
_ASIDE = 2.0  # how much farther counts what lies aside of the way


def nearest(start: QPointF, anchors: Mapping[str, QPointF], way: QPointF) -> str | None:
    """The element that lies next in a direction; None at the edge."""
    best, least = None, math.inf
    for name, anchor in anchors.items():
        gap = anchor - start
        along = QPointF.dotProduct(gap, way)
        aside = abs(gap.x() * way.y()) + abs(gap.y() * way.x())
        if along > max(0.5, aside / _STEEPEST) and (far := along + _ASIDE * aside) < least:
            best, least = name, far
    return best
