"""Where the field map's lines are in its widget, magnified and moved by hands."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPolygonF, QTransform

from procc_annotator.arrays import FloatArray
from procc_annotator.gui.panels.field_map.shape import FieldShape
from procc_annotator.gui.panels.field_map.unfolding import Bounds

_LARGEST = 40.0
_STEP = 1.0015  # an eighth of a degree of the wheel
_DRAG = 4.0  # widget points: less is a click


@dataclass(frozen=True, eq=False)
class Placement:
    """A field laid into a part of a widget as large as it fits.

    Attributes:
        scale: points of the widget per metre of the map.
        transform: from metres of the map to the widget.
        polygons: the line of each element.
        anchors: where each element bears its sign: no other line crosses there.
        ground: the field without what stands upright.
    """

    scale: float
    transform: QTransform
    polygons: tuple[QPolygonF, ...]
    anchors: tuple[QPointF, ...]
    ground: QRectF

    @classmethod
    def of(
        cls,
        shape: FieldShape,
        room: QRectF,
        view: MapView,
        turns: int = 0,
        part: Bounds | None = None,
    ) -> Placement:
        """Lay a field into a part of a widget.

        Args:
            shape: the field.
            room: the part, which it fits into at zoom 1.
            view: so many times as large, and moved by hand.
            turns: so many quarter turns clockwise.
            part: the part of the map to lay into the room, metres of the map; None: all of it.
        """
        part = part or shape.bounds
        scale = view.zoom * scale_to_fit(part, room, turns)
        middle = _turned(part, turns).center() * scale
        origin = room.topLeft() + QPointF(*_size(room)) / 2 - middle + view.shift
        moved = QTransform(scale, 0, 0, scale, origin.x(), origin.y())
        transform = QTransform().rotate(90.0 * turns) * moved
        matrix = np.array([[transform.m11(), transform.m12()], [transform.m21(), transform.m22()]])

        def place(line: FloatArray) -> list[QPointF]:
            at = line @ matrix + (origin.x(), origin.y())
            return [QPointF(x, y) for x, y in at.tolist()]

        corners = place(np.reshape(shape.ground, (2, 2)))
        return cls(
            scale,
            transform,
            tuple(QPolygonF(place(line)) for line in shape.lines),
            tuple(place(shape.anchors)),
            QRectF(*corners).normalized(),
        )

    def to_widget(self, x: float, y: float) -> QPointF:
        """The position in the widget of metres on the map."""
        return self.transform.map(QPointF(x, y))

    def to_field(self, position: QPointF) -> tuple[float, float]:
        """Metres on the map at a position of the widget."""
        back, _ = self.transform.inverted()
        at = back.map(position)
        return at.x(), at.y()


def scale_to_fit(part: Bounds, room: QRectF, turns: int) -> float:
    """Points of the widget per metre, so that a part of the map fits into a room."""
    extent, (width, height) = _turned(part, turns), _size(room)
    return min(width / extent.width(), height / extent.height())


def _turned(part: Bounds, turns: int) -> QRectF:
    left, top, right, bottom = part
    turned = QTransform().rotate(90.0 * turns)
    return turned.mapRect(QRectF(left, top, right - left, bottom - top))


def _size(room: QRectF) -> tuple[float, float]:
    return max(1.0, room.width()), max(1.0, room.height())


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
