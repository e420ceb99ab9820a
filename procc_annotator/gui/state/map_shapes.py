"""A map in metres as shapes of Qt: made once, painted again and again."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainterPath, QPolygonF

from procc_annotator.arrays import FloatArray
from procc_annotator.interaction.camera_view import DISAGREEMENT, MapStyle
from procc_annotator.metrics.error_maps import (
    ContourBand,
    Disagreement,
    contour_lines,
    filled_contours,
)


@dataclass(frozen=True, eq=False)
class MapShapes:
    """A map as shapes of Qt, in one frame of coordinates; not to be changed.

    Attributes:
        look: what they are painted with.
        bands: between each two levels.
        lines: (N, 4) of each of the look's lines, segment by segment.
        area: as far as the map reaches; None where its shapes end there by themselves.
    """

    look: MapStyle
    bands: tuple[QPainterPath, ...]
    lines: tuple[FloatArray, ...]
    area: QPainterPath | None = None


def map_shapes(
    look: MapStyle,
    values: FloatArray,
    x: FloatArray,
    y: FloatArray,
    area: ContourBand | None = None,
) -> MapShapes:
    """The shapes of a map; safe from any thread, and too slow for that of the interface.

    Args:
        values, x, y: as for `metrics.error_maps.filled_contours`.
        area: nothing is painted outside.
    """
    return MapShapes(
        look,
        tuple(_path(band) for band in filled_contours(values, x, y, look.levels_m)),
        tuple(segments(contour_lines(values, x, y, line.metres)) for line in look.lines),
        None if area is None else _path(area),
    )


def shapes_in_picture(found: Disagreement) -> MapShapes:
    """The shapes of a disagreement in px of the evaluation size."""
    return map_shapes(DISAGREEMENT, found.metres, found.xs_px, found.ys_px)


def shapes_on_field(found: Disagreement) -> MapShapes:
    """Its shapes in metres of the field, where the first camera sees the ground."""
    ground = found.ground_a
    return map_shapes(DISAGREEMENT, found.metres, ground[..., 0], ground[..., 1])


def segments(lines: Iterable[FloatArray]) -> FloatArray:
    """(N, 4) the segments x, y, x, y of polylines (n, 2), one after the other."""
    pieces = [np.hstack((line[:-1], line[1:])) for line in lines]
    return np.concatenate(pieces) if pieces else np.empty((0, 4))


def _path(band: ContourBand) -> QPainterPath:
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.OddEvenFill)
    for outlines in band.polygons:
        for outline in outlines:
            path.addPolygon(QPolygonF([QPointF(u, v) for u, v in outline.tolist()]))
    return path
