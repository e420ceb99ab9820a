"""Painting a disagreement: bands and the dashed limit, for the canvas, the field map and files."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPolygonF, QTransform

from procc_annotator.interact import palette
from procc_annotator.metric.contours import (
    DISAGREEMENT_LEVELS_M,
    OFFSIDE_ACCURACY_M,
    Band,
    contour_lines,
    filled_contours,
)
from procc_annotator.metric.disagreement import Disagreement
from procc_annotator.metric.polylines import FloatArray

_CASING = 1.5  # points by which a dark line shows on both sides of a coloured one


@dataclass(frozen=True, eq=False)
class DisagreementShapes:
    """A disagreement as bands and the line of the limit, in one frame of coordinates."""

    bands: tuple[Band, ...]
    limit: tuple[FloatArray, ...]


@lru_cache(maxsize=4)
def shapes_in_picture(found: Disagreement) -> DisagreementShapes:
    """In px of the evaluation size; computed once for what is painted again and again."""
    return _shapes(found, found.xs_px, found.ys_px)


@lru_cache(maxsize=4)
def shapes_on_field(found: Disagreement) -> DisagreementShapes:
    """In metres of the field, where the first camera sees the ground."""
    return _shapes(found, found.ground_a[..., 0], found.ground_a[..., 1])


def paint_disagreement(
    painter: QPainter,
    found: Disagreement,
    *,
    scale: tuple[float, float],
    offset: tuple[float, float],
    unit: float = 1.0,
    opacity: float = palette.DISAGREEMENT_OPACITY,
) -> None:
    """Paint the bands of a disagreement and its dashed limit over a picture.

    Args:
        painter: its state is restored.
        found: in px of the evaluation size.
        scale: device px per px of the evaluation size, along x and y.
        offset: device position of the centre of the picture's first pixel.
        unit: device px per point.
        opacity: of the bands, 0 to 1.
    """
    transform = QTransform(scale[0], 0, 0, scale[1], *offset)
    paint_shapes(painter, shapes_in_picture(found), transform, unit=unit, opacity=opacity)


def paint_shapes(
    painter: QPainter,
    shapes: DisagreementShapes,
    transform: QTransform,
    *,
    unit: float = 1.0,
    opacity: float = palette.DISAGREEMENT_OPACITY,
) -> None:
    """Paint bands and limit.

    Args:
        painter: its state is restored.
        transform: from the coordinates of the shapes to the device.
        unit: device px per point; line widths do not follow the transform.
        opacity: of the bands, 0 to 1.
    """
    painter.save()
    # Neighbouring bands share their edges: smoothed, each would let the ground through there.
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    painter.setPen(Qt.PenStyle.NoPen)
    for band, colour in zip(shapes.bands, palette.DISAGREEMENT_COLOURS, strict=True):
        tone = QColor(colour)
        tone.setAlphaF(opacity)
        painter.setBrush(tone)
        painter.drawPath(transform.map(_path(band)))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    paint_lines(
        painter, shapes.limit, transform, "#FFFFFF",
        width=palette.LIMIT_WIDTH * unit, casing=_CASING * unit, dash=palette.LIMIT_DASH,
    )  # fmt: skip
    painter.restore()


def paint_lines(
    painter: QPainter,
    lines: Iterable[FloatArray],
    transform: QTransform,
    colour: str,
    *,
    width: float,
    casing: float,
    dash: Sequence[float] = (),
) -> None:
    """Paint polylines (n, 2) in a colour, with a dark rim so that they show on every ground.

    Args:
        width, casing: device px of the line, and of the rim on either side of it.
        dash: lengths on and off in units of points of the palette, () for a solid line.
    """
    painter.setBrush(Qt.BrushStyle.NoBrush)
    shapes = [transform.map(polygon(line)) for line in lines]
    for tone, thickness in (("#202020", width + 2 * casing), (colour, width)):
        pen = QPen(QColor(tone), thickness)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        if dash:  # Qt counts dashes in widths of the line
            pen.setDashPattern([d * width / palette.LIMIT_WIDTH / thickness for d in dash])
        painter.setPen(pen)
        for shape in shapes:
            painter.drawPolyline(shape)


def polygon(points: FloatArray) -> QPolygonF:
    """(n, 2) as a polygon of Qt."""
    return QPolygonF([QPointF(x, y) for x, y in points.tolist()])


def _shapes(found: Disagreement, x: FloatArray, y: FloatArray) -> DisagreementShapes:
    return DisagreementShapes(
        filled_contours(found.metres, x, y, DISAGREEMENT_LEVELS_M),
        contour_lines(found.metres, x, y, OFFSIDE_ACCURACY_M),
    )


@lru_cache(maxsize=64)
def _path(band: Band) -> QPainterPath:
    """The band's outlines; kept while only what lies over them changes."""
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.OddEvenFill)
    for outlines in band.polygons:
        for outline in outlines:
            path.addPolygon(polygon(np.asarray(outline)))
    return path
