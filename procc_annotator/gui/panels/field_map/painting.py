"""Painting the field map: its place in the widget, the ground, the signs of states."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPalette, QPolygonF, QTransform

from procc_annotator.arrays import FloatArray
from procc_annotator.gui.canvas.map_painting import paint_shapes
from procc_annotator.gui.panels.element_states import ElementState, paint_symbol, state_colour
from procc_annotator.gui.panels.field_map.field_shape import Bounds, FieldShape
from procc_annotator.gui.state.maps import MapShapes, TopViewImage, even_odd_path
from procc_annotator.gui.theme import blend, muted
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.camera_view import VisibleField

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
    def of(cls, shape: FieldShape, room: QRectF, view: MapView, turns: int = 0) -> Placement:
        """Lay a field into a part of a widget.

        Args:
            room: the part, which it fits into at zoom 1.
            view: so many times as large, and moved by hand.
            turns: so many quarter turns clockwise.
        """
        whole = QTransform().rotate(90.0 * turns).mapRect(_rect(shape.bounds))
        width, height = max(1.0, room.width()), max(1.0, room.height())
        scale = view.zoom * min(width / whole.width(), height / whole.height())
        origin = room.topLeft() + QPointF(width, height) / 2 - whole.center() * scale + view.shift
        moved = QTransform(scale, 0, 0, scale, origin.x(), origin.y())
        transform = QTransform().rotate(90.0 * turns) * moved

        def placed(points: FloatArray) -> QPolygonF:
            return transform.map(QPolygonF([QPointF(x, y) for x, y in points.tolist()]))

        lines, anchors = tuple(map(placed, shape.lines)), tuple(placed(shape.anchors).toList())
        return cls(scale, transform, lines, anchors, transform.mapRect(_rect(shape.ground)))

    def to_widget(self, x: float, y: float) -> QPointF:
        """The position in the widget of metres on the map."""
        return self.transform.map(QPointF(x, y))

    def to_field(self, position: QPointF) -> tuple[float, float]:
        """Metres on the map at a position of the widget."""
        back, _ = self.transform.inverted()
        at = back.map(position)
        return at.x(), at.y()


def _rect(part: Bounds) -> QRectF:
    left, top, right, bottom = part
    return QRectF(left, top, right - left, bottom - top)


class MapView:
    """Zoom and shift of a map, changed by the mouse.

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
        """Magnify; what is under the cursor stays there. ``turned`` is in eighths of a degree,
        forward is larger; the places are widget points, the centre is that of the map's room."""
        zoom = min(_LARGEST, max(1.0, self.zoom * _STEP**turned))
        offset = cursor - centre
        self.shift = offset - (offset - self.shift) * (zoom / self.zoom)
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
_ASIDE = 2.0  # how much farther an element counts that is off the direction


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


_INTERSECT = Qt.ClipOperation.IntersectClip
_RIM = 4.0  # widget points of grass around the lines
_FAINT = 0.35  # of the ground's tone, where it is out of sight


def ground_colour(palette: QPalette, share: float = 1.0) -> QColor:
    """The field's surface, on either theme; fainter by a share."""
    return blend(palette.color(QPalette.ColorRole.Base), QColor("#3f9b4f"), 0.14 * share)


def paint_ground(
    painter: QPainter, placed: Placement, sight: VisibleField | None, palette: QPalette
) -> None:
    """Grass; fainter where the camera does not see it."""
    around = placed.ground.adjusted(-_RIM, -_RIM, _RIM, _RIM)
    if sight is None:
        painter.fillRect(around, ground_colour(palette))
        return
    painter.fillRect(around, ground_colour(palette, _FAINT))
    painter.save()
    painter.setClipRect(around, _INTERSECT)
    painter.fillPath(placed.transform.map(even_odd_path(sight.ground)), ground_colour(palette, 2.0))
    painter.restore()


def paint_top_view(painter: QPainter, placed: Placement, above: TopViewImage) -> None:
    """The picture as seen from above, as far as the field reaches."""
    painter.save()
    painter.setClipRect(placed.ground.adjusted(-_RIM, -_RIM, _RIM, _RIM), _INTERSECT)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.setTransform(above.metres_from_px * placed.transform, True)
    painter.drawImage(0, 0, above.image)
    painter.restore()


def paint_metres(painter: QPainter, placed: Placement, shapes: MapShapes) -> None:
    """Bands of a map in metres, as far as the field reaches."""
    painter.save()
    painter.setClipRect(placed.ground, _INTERSECT)
    paint_shapes(painter, shapes, placed.transform, unit=0.75)
    painter.restore()


_SPOT = 2.2  # radius of a single place


def paint_spot(
    painter: QPainter,
    at: QPointF,
    state: ElementState,
    palette: QPalette,
    *,
    chosen: bool,
    hovered: bool,
) -> None:
    """A single place: a dot until there is something to say of it, then the state's sign."""
    painter.setPen(Qt.PenStyle.NoPen)
    if chosen:
        for colour, radius in ((tones.OUTLINE, _SPOT + 5), (tones.HALO, _SPOT + 4)):
            painter.setBrush(QColor(colour))
            painter.drawEllipse(at, radius, radius)
    elif hovered:
        painter.setBrush(muted(palette, 0.75))
        painter.drawEllipse(at, _SPOT + 4, _SPOT + 4)
    if state is ElementState.UNTOUCHED:
        painter.setBrush(state_colour(state, palette))
        painter.drawEllipse(at, _SPOT, _SPOT)
        return
    paint_badge(painter, at, state, palette, radius=_SPOT + 3, side=2 * _SPOT + 7)


def paint_badge(
    painter: QPainter,
    at: QPointF,
    state: ElementState,
    palette: QPalette,
    *,
    radius: float = 5.0,
    side: float = 11.0,
) -> None:
    """Paint the sign of a state on a disc; solid lines bear it too: tick or cross."""
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(palette.color(QPalette.ColorRole.Base))
    painter.drawEllipse(at, radius, radius)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    box = QRectF(at.x() - side / 2, at.y() - side / 2, side, side)
    paint_symbol(painter, box, state, state_colour(state, palette))
