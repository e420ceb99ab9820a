"""Painting a map in metres: bands and lines, for the canvas, the field map and files."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QTransform

from procc_annotator.arrays import FloatArray
from procc_annotator.gui.canvas.overlay_painter import draw_lines, visible_parts
from procc_annotator.gui.state.maps import MapShapes
from procc_annotator.interaction import palette

_CASING = 1.5  # points by which a dark line shows on both sides of a coloured one


def paint_shapes(
    painter: QPainter,
    shapes: MapShapes,
    transform: QTransform,
    *,
    unit: float = 1.0,
) -> None:
    """Paint bands and lines.

    Args:
        painter: its state is restored.
        transform: from the coordinates of the shapes to the device.
        unit: device px per point; line widths do not follow the transform.
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
        tone.setAlphaF(look.opacity)
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
    for tone, thickness in ((palette.OUTLINE, width + 2 * casing), (colour, width)):
        pen = QPen(QColor(tone), thickness)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        draw_lines(painter, shown, pen)


def _mapped(lines: FloatArray, transform: QTransform) -> FloatArray:
    """(N, 4) segments through an affine transform."""
    matrix = np.array([[transform.m11(), transform.m12()], [transform.m21(), transform.m22()]])
    points = lines.reshape(-1, 2) @ matrix + (transform.dx(), transform.dy())
    return np.asarray(points.reshape(-1, 4))
