"""Painting a map in metres: bands and lines, for the canvas, the field map and files."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPolygonF, QTransform

from procc_annotator.gui.picture.items import draw_lines, visible_parts
from procc_annotator.interact import palette
from procc_annotator.interact.map_looks import MapLook
from procc_annotator.metric.contours import Band, contour_lines, filled_contours
from procc_annotator.metric.polylines import FloatArray

_CASING = 1.5  # points by which a dark line shows on both sides of a coloured one


@dataclass(frozen=True, eq=False)
class MapShapes:
    """A map as shapes of Qt, in one frame of coordinates; not to be changed.

    Attributes:
        look: what they are painted with.
        bands: between each two levels.
        lines: (N, 4) of each of the look's lines, segment by segment.
        area: as far as the map reaches; None where its shapes end there by themselves.
    """

    look: MapLook
    bands: tuple[QPainterPath, ...]
    lines: tuple[FloatArray, ...]
    area: QPainterPath | None = None


def map_shapes(
    look: MapLook, values: FloatArray, x: FloatArray, y: FloatArray, area: Band | None = None
) -> MapShapes:
    """The shapes of a map; safe from any thread, and too slow for that of the interface.

    Args:
        values, x, y: as for `metric.contours.filled_contours`.
        area: nothing is painted outside.
    """
    return MapShapes(
        look,
        tuple(_path(band) for band in filled_contours(values, x, y, look.levels_m)),
        tuple(segments(contour_lines(values, x, y, line.metres)) for line in look.lines),
        None if area is None else _path(area),
    )


def paint_shapes(
    painter: QPainter,
    shapes: MapShapes,
    transform: QTransform,
    *,
    unit: float = 1.0,
    opacity: float | None = None,
) -> None:
    """Paint bands and lines.

    Args:
        painter: its state is restored.
        transform: from the coordinates of the shapes to the device.
        unit: device px per point; line widths do not follow the transform.
        opacity: of the bands, 0 to 1; as the look says if None.
    """
    look = shapes.look
    painter.save()
    if shapes.area is not None:
        painter.setClipPath(transform.map(shapes.area), Qt.ClipOperation.IntersectClip)
    # Neighbouring bands share their edges: smoothed, each would let the ground through there.
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    painter.setPen(Qt.PenStyle.NoPen)
    for band, colour in zip(shapes.bands, look.colours, strict=True):
        tone = QColor(colour)
        tone.setAlphaF(look.opacity if opacity is None else opacity)
        painter.setBrush(tone)
        painter.drawPath(transform.map(band))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for line, course in zip(look.lines, shapes.lines, strict=True):
        paint_lines(
            painter, course, transform, palette.HALO,
            width=palette.LIMIT_WIDTH * unit, casing=_CASING * unit, dash=line.dash,
        )  # fmt: skip
    painter.restore()


def paint_lines(
    painter: QPainter,
    lines: FloatArray,
    transform: QTransform,
    colour: str,
    *,
    width: float,
    casing: float,
    dash: Sequence[float] = (),
) -> None:
    """Paint lines in a colour, with a dark rim so that they show on every ground.

    Args:
        lines: (N, 4) segments, see `segments`.
        width, casing: device px of the line, and of the rim on either side of it.
        dash: lengths on and off in units of points of the palette, () for a solid line.
    """
    reach = width + 2 * casing
    room = painter.clipBoundingRect() if painter.hasClipping() else QRectF(painter.viewport())
    pattern = [d * width / palette.LIMIT_WIDTH for d in dash]
    shown = visible_parts(
        _mapped(lines, transform), room.adjusted(-reach, -reach, reach, reach), pattern
    )
    for tone, thickness in ((palette.RIM, width + 2 * casing), (colour, width)):
        pen = QPen(QColor(tone), thickness)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        draw_lines(painter, shown, pen)


def segments(lines: Iterable[FloatArray]) -> FloatArray:
    """(N, 4) the segments x, y, x, y of polylines (n, 2), one after the other."""
    pieces = [np.hstack((line[:-1], line[1:])) for line in lines]
    return np.concatenate(pieces) if pieces else np.empty((0, 4))


def _mapped(lines: FloatArray, transform: QTransform) -> FloatArray:
    """(N, 4) segments through an affine transform."""
    matrix = np.array([[transform.m11(), transform.m12()], [transform.m21(), transform.m22()]])
    points = lines.reshape(-1, 2) @ matrix + (transform.dx(), transform.dy())
    return np.asarray(points.reshape(-1, 4))


def _path(band: Band) -> QPainterPath:
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.OddEvenFill)
    for outlines in band.polygons:
        for outline in outlines:
            path.addPolygon(QPolygonF([QPointF(u, v) for u, v in outline.tolist()]))
    return path
