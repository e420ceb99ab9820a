"""The ground of the field map: what of it is in the picture, and maps in metres over it."""

from __future__ import annotations

from collections.abc import Collection

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPalette, QPolygonF

from procc_annotator.gui.canvas.metre_map_picture import paint_shapes
from procc_annotator.gui.panels.field_map.placement import Placement, scale_to_fit
from procc_annotator.gui.panels.field_map.shape import FieldShape
from procc_annotator.gui.panels.field_map.unfolding import Bounds
from procc_annotator.gui.state.map_shapes import MapShapes
from procc_annotator.gui.state.maps import MapSight
from procc_annotator.gui.theme import blend
from procc_annotator.interaction.camera_view import VisibleField

_RIM = 4.0  # widget points of grass around the lines
_ACROSS = 0.08  # of the map's length that is shown of the half that is out of sight
_WORTH_IT = 1.2  # so many times as large
_FAINT = 0.35  # of the ground's tone, where it is out of sight


def ground_colour(palette: QPalette, share: float = 1.0) -> QColor:
    """The field's surface, on either theme; fainter by a share."""
    return blend(palette.color(QPalette.ColorRole.Base), QColor("#3f9b4f"), 0.14 * share)


def part_to_show(
    shape: FieldShape, sight: MapSight, needed: Collection[str | None], room: QRectF
) -> Bounds | None:
    """The part of the map to lay out; None: all of it.

    The half that is out of sight leaves its room to the other one, unless that would not be drawn
    much larger.

    Args:
        shape: the field.
        sight: what is seen of it.
        needed: elements that must be seen, wherever they are.
        room: what the map has of the widget.
    """
    if sight.half == 0:
        return None
    left, top, right, bottom = shape.bounds
    across = _ACROSS * (right - left)
    for name, line in zip(shape.names, shape.lines, strict=True):
        if name in needed and (sight.half * line[:, 0]).max() < -across:
            return None
    part = (-across, top, right, bottom) if sight.half > 0 else (left, top, across, bottom)
    gain = scale_to_fit(part, room, sight.turns) / scale_to_fit(shape.bounds, room, sight.turns)
    return part if gain > _WORTH_IT else None


def paint_ground(
    painter: QPainter, placed: Placement, sight: VisibleField | None, palette: QPalette
) -> None:
    """Grass; fainter where the camera does not see it."""
    around = placed.ground.adjusted(-_RIM, -_RIM, _RIM, _RIM)
    if sight is None:
        painter.fillRect(around, ground_colour(palette))
        return
    painter.fillRect(around, ground_colour(palette, _FAINT))
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.OddEvenFill)
    for outlines in sight.ground:
        for outline in outlines:
            path.addPolygon(QPolygonF([QPointF(x, y) for x, y in outline.tolist()]))
    painter.save()
    painter.setClipRect(around, Qt.ClipOperation.IntersectClip)
    painter.fillPath(placed.transform.map(path), ground_colour(palette, 2.0))
    painter.restore()


def paint_metres(painter: QPainter, placed: Placement, shapes: MapShapes) -> None:
    """Bands of a map in metres, as far as the field reaches."""
    painter.save()
    painter.setClipRect(placed.ground, Qt.ClipOperation.IntersectClip)
    paint_shapes(painter, shapes, placed.transform, unit=0.75)
    painter.restore()
