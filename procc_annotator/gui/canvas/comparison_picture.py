"""Pictures of two cameras' disagreement without a window: the frame, and a panel next to it."""

from __future__ import annotations

import cv2
import numpy as np
from PySide6.QtCore import QCoreApplication, QRectF
from PySide6.QtGui import QColor, QImage, QPainter, QTransform
from PySide6.QtWidgets import QApplication

from procc_annotator.camera.base import Camera
from procc_annotator.errors import SaveError
from procc_annotator.field.model import Field
from procc_annotator.gui.canvas.caption import paint_caption
from procc_annotator.gui.canvas.comparison_panel import PANEL_SIZE, paint_panel
from procc_annotator.gui.canvas.disagreement_picture import paint_disagreement
from procc_annotator.gui.canvas.metre_map_picture import paint_lines
from procc_annotator.gui.state.map_shapes import segments
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction import palette
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.comparison import ComparisonScene

_GREY = (96, 96, 96, 255)
_LINE_WIDTH, _RIM_WIDTH = 1.6, 0.6
_LEAST_UNIT = 0.6  # lines on a small picture are thin, but seen


class ComparisonPictures:
    """Called with a scene, gives the picture encoded as ``.png`` or ``.jpg``."""

    def __init__(self, suffix: str = ".png") -> None:
        self._suffix = suffix
        # Text needs an application object, though no display; it must outlive the painting.
        self._application = QCoreApplication.instance() or QApplication(
            ["procc-annotator", "-platform", "offscreen"]
        )

    def __call__(self, scene: ComparisonScene) -> bytes:
        """The encoded picture.

        Raises:
            ImageError: the frame's picture cannot be decoded.
        """
        done, encoded = cv2.imencode(self._suffix, _painted(scene)[:, :, :3])
        if not done:
            raise SaveError(f"{scene.compared.name}: the picture cannot be encoded")
        return encoded.tobytes()


def _painted(scene: ComparisonScene) -> PixelArray:
    background = _background(scene)
    height, width = background.shape[:2]
    # The panel is as high as the picture, and its text grows with it; but never too small to read.
    unit = max(1.0, height / PANEL_SIZE[1])
    panel_width, sheet_height = (
        round(PANEL_SIZE[0] * unit),
        max(height, round(PANEL_SIZE[1] * unit)),
    )
    sheet = np.full((sheet_height, width + panel_width, 4), _GREY, dtype=np.uint8)
    sheet[:height, :width] = background
    image = QImage(
        sheet.data, sheet.shape[1], sheet_height, sheet.strides[0], QImage.Format.Format_RGB32
    )
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setClipRect(QRectF(0, 0, width, height))
    _paint_frame(painter, scene, (width, height), max(_LEAST_UNIT, height / PANEL_SIZE[1]))
    painter.setClipping(False)
    panel = QRectF(width, 0, panel_width, sheet_height)
    paint_panel(painter, scene, panel, unit, _ground_tone(scene, background))
    painter.end()
    return sheet


def _background(scene: ComparisonScene) -> PixelArray:
    if scene.image_path is not None:
        return decode_bgra(scene.image_path)
    width, height = scene.disagreement.size
    return np.full((height, width, 4), _GREY, dtype=np.uint8)


def _ground_tone(scene: ComparisonScene, background: PixelArray) -> QColor:
    """The mean colour under the bands, so that the panel's tones are those of the picture."""
    found = scene.disagreement
    rows, columns = np.nonzero(~np.isnan(found.metres))
    height, width = background.shape[:2]
    x = np.rint(found.xs_px[columns] * (width - 1) / (found.size[0] - 1)).astype(np.intp)
    y = np.rint(found.ys_px[rows] * (height - 1) / (found.size[1] - 1)).astype(np.intp)
    if not len(x):
        return QColor(*_GREY[:3])
    blue, green, red = np.rint(background[y, x, :3].mean(axis=0)).astype(int).tolist()
    return QColor(red, green, blue)


def _paint_frame(
    painter: QPainter, scene: ComparisonScene, size: tuple[int, int], unit: float
) -> None:
    """Bands, limit, the wireframes of both cameras, and a word where there is no picture."""
    own = scene.disagreement.size
    scale = ((size[0] - 1) / (own[0] - 1), (size[1] - 1) / (own[1] - 1))
    paint_disagreement(painter, scene.disagreement, scale=scale, offset=(0.5, 0.5), unit=unit)
    transform = QTransform(scale[0], 0, 0, scale[1], 0.5, 0.5)
    for camera, colour in zip(
        (scene.cameras.a, scene.cameras.b), palette.PAIR_COLOURS, strict=True
    ):
        paint_wireframe(painter, camera, scene.field, own, transform, colour, unit)
    if scene.image_path is None:
        area, font_px = QRectF(0, 0, *size), max(10, round(13 * unit))
        paint_caption(painter, "no picture of this frame", area, unit, font_px)


def paint_wireframe(
    painter: QPainter,
    camera: Camera,
    field: Field,
    size: tuple[int, int],
    transform: QTransform,
    colour: str,
    unit: float,
) -> None:
    """What a camera shows of the field, as lines.

    Args:
        camera: in px of ``size``.
        transform: from px of ``size`` (centres are whole numbers) to the device.
        unit: device px per point.
    """
    shown = project_field(camera, EvaluationSetup(field, size, "procc"))
    lines = [piece for pieces in shown.pieces.values() for piece in pieces if len(piece) > 1]
    paint_lines(
        painter,
        segments(lines),
        transform,
        colour,
        width=_LINE_WIDTH * unit,
        casing=_RIM_WIDTH * unit,
    )
