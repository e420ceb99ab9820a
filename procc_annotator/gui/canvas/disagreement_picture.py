"""A disagreement painted over a picture."""

from __future__ import annotations

from PySide6.QtGui import QPainter, QTransform

from procc_annotator.gui.canvas.metre_map_picture import paint_shapes
from procc_annotator.gui.state.map_shapes import shapes_in_picture
from procc_annotator.interaction.camera_view import DISAGREEMENT
from procc_annotator.metrics.error_maps import Disagreement


def paint_disagreement(
    painter: QPainter,
    found: Disagreement,
    *,
    scale: tuple[float, float],
    offset: tuple[float, float],
    unit: float = 1.0,
    opacity: float = DISAGREEMENT.opacity,
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
