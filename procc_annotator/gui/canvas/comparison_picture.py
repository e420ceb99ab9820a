"""Pictures of two cameras' disagreement without a window: the frame, and a panel next to it."""

from __future__ import annotations

import itertools
import math

import cv2
import numpy as np
from PySide6.QtCore import QCoreApplication, QLineF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter, QPen, QTransform
from PySide6.QtWidgets import QApplication

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.base import Camera
from procc_annotator.errors import SaveError
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.gui.canvas.map_painting import paint_lines, paint_shapes
from procc_annotator.gui.canvas.overlay_picture import paint_caption
from procc_annotator.gui.state.maps import segments, shapes_in_picture, shapes_on_field
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction import palette
from procc_annotator.interaction.camera_view import DISAGREEMENT
from procc_annotator.metrics.error_maps import (
    DISAGREEMENT_LEVELS_M,
    OFFSIDE_ACCURACY_M,
    Disagreement,
    MapSummary,
)
from procc_annotator.metrics.ground_plane import GroundRectangle, field_rectangle
from procc_annotator.metrics.legacy import LegacyMetrics
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.comparison import ComparisonScene
from procc_annotator.report.tables.metrics import LEGACY, METRES, PIXELS, WITHIN
from procc_annotator.report.tables.table import DASH


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


PANEL_SIZE = (430.0, 540.0)
"""Width and height in points; the panel may be higher than that."""

_BACK, _TEXT, _MUTED = QColor("#1E1E1E"), QColor("#F2F2F2"), QColor("#B8B8B8")
_FIELD_LINE = "#FFFFFF"
_MARGIN, _ROW = 12.0, 19.0
_MAP_HEIGHT = 252.0
_RUN_OFF_M = 4.0
_CURVE_SPACING_M = 0.5
_SHORT = {
    "iou_part": "IoU part {}",
    "iou_whole": "whole {}",
    "projection_m": "projection {}",
    "reprojection": "reprojection {} of height",
}


class _Sheet:
    """Draws text and boxes in points from a corner of the device."""

    def __init__(self, painter: QPainter, area: QRectF, unit: float) -> None:
        self.painter, self.area, self.unit = painter, area, unit
        self.width = area.width() / unit

    def box(self, x: float, y: float, width: float, height: float) -> QRectF:
        unit = self.unit
        return QRectF(
            self.area.left() + x * unit, self.area.top() + y * unit, width * unit, height * unit
        )

    def text(
        self,
        box: QRectF,
        text: str,
        *,
        bold: bool = False,
        muted: bool = False,
        right: bool = False,
    ) -> None:
        """One line in a box; what does not fit gives way in the middle."""
        font = QFont()
        font.setPixelSize(round(13 * self.unit))
        font.setBold(bold)
        self.painter.setFont(font)
        self.painter.setPen(_MUTED if muted else _TEXT)
        side = Qt.AlignmentFlag.AlignRight if right else Qt.AlignmentFlag.AlignLeft
        shown = QFontMetricsF(font).elidedText(text, Qt.TextElideMode.ElideMiddle, box.width())
        self.painter.drawText(box, side | Qt.AlignmentFlag.AlignVCenter, shown)

    def line(self, box: QRectF, colour: str, dash: tuple[float, ...] = ()) -> None:
        """A sample of a line, in the middle of a box."""
        y = box.center().y()
        pen = QPen(QColor(colour), palette.LIMIT_WIDTH * self.unit)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        if dash:
            pen.setDashPattern([d / palette.LIMIT_WIDTH for d in dash])
        self.painter.setPen(pen)
        self.painter.drawLine(QLineF(box.left(), y, box.right(), y))


def paint_panel(
    painter: QPainter, scene: ComparisonScene, area: QRectF, unit: float, ground: QColor
) -> None:
    """Paint the panel.

    Args:
        area: of the device, at least `PANEL_SIZE` times ``unit``.
        unit: device px per point.
        ground: what map and legend have under the bands.
    """
    painter.save()
    painter.fillRect(area, _BACK)
    sheet = _Sheet(painter, area, unit)
    y = _paint_names(sheet, scene, 8.0)
    y = _paint_map(sheet, scene, y + 4.0, ground)
    y = _paint_legend(sheet, y + 6.0, ground)
    _paint_figures(sheet, scene, y + 6.0)
    painter.restore()


def _paint_names(sheet: _Sheet, scene: ComparisonScene, y: float) -> float:
    full = sheet.width - 2 * _MARGIN
    size = f"compared at {scene.disagreement.size[0]}x{scene.disagreement.size[1]}"
    sheet.text(sheet.box(_MARGIN, y, full - 145, _ROW), f"Frame {scene.compared.name}", bold=True)
    sheet.text(sheet.box(_MARGIN, y, full, _ROW), size, muted=True, right=True)
    y += _ROW
    half = full / 2
    for i, (name, colour) in enumerate(zip(scene.names, palette.PAIR_COLOURS, strict=True)):
        x = _MARGIN + i * half
        sheet.line(sheet.box(x, y, 22, _ROW), colour)
        sheet.text(sheet.box(x + 28, y, half - 34, _ROW), f"{'AB'[i]}: {name}")
    return y + _ROW


def _paint_map(sheet: _Sheet, scene: ComparisonScene, y: float, ground: QColor) -> float:
    """The field from above, the main camera's side down, with the bands where A sees them."""
    rectangle = field_rectangle(scene.field)
    room = GroundRectangle(
        rectangle.left - _RUN_OFF_M,
        rectangle.top - _RUN_OFF_M,
        rectangle.right + _RUN_OFF_M,
        rectangle.bottom + _RUN_OFF_M,
    )
    wide, high = room.right - room.left, room.bottom - room.top
    per_metre = min((sheet.width - 2 * _MARGIN) / wide, _MAP_HEIGHT / high)
    box = sheet.box((sheet.width - per_metre * wide) / 2, y, per_metre * wide, per_metre * high)
    scale = per_metre * sheet.unit
    to_device = QTransform(
        scale, 0, 0, scale, box.left() - scale * room.left, box.top() - scale * room.top
    )
    painter = sheet.painter
    painter.save()
    painter.fillRect(box, ground)
    painter.setClipRect(box)
    shapes = shapes_on_field(scene.disagreement)
    paint_shapes(painter, shapes, to_device, unit=0.75 * sheet.unit)
    paint_lines(
        painter, segments(_field_lines(scene.field)), to_device, _FIELD_LINE,
        width=0.9 * sheet.unit, casing=0.4 * sheet.unit,
    )  # fmt: skip
    painter.restore()
    return y + per_metre * high


def _field_lines(field: Field) -> list[FloatArray]:
    samples = sample_evenly(field, _CURVE_SPACING_M)
    return [samples.of(i)[:, :2] for i, e in enumerate(field.elements) if e.on_ground]


def _paint_legend(sheet: _Sheet, y: float, ground: QColor) -> float:
    """The bands in two columns, small to large, and the dashed line."""
    texts = [_range(low, high) for low, high in itertools.pairwise(DISAGREEMENT_LEVELS_M)]
    rows = math.ceil((len(texts) + 1) / 2)
    column = (sheet.width - 2 * _MARGIN) / 2
    for i, (text, colour) in enumerate(zip(texts, palette.DISAGREEMENT_COLOURS, strict=True)):
        x, top = _MARGIN + (i // rows) * column, y + (i % rows) * _ROW
        swatch, tone = sheet.box(x, top + 3, 22, _ROW - 5), QColor(colour)
        tone.setAlphaF(palette.DISAGREEMENT_OPACITY)
        sheet.painter.fillRect(swatch, ground)
        sheet.painter.fillRect(swatch, tone)
        sheet.text(sheet.box(x + 28, top, column - 30, _ROW), text)
    x, top = _MARGIN + column, y + (rows - 1) * _ROW
    sheet.line(sheet.box(x, top, 22, _ROW), "#FFFFFF", palette.LIMIT_DASH)
    sheet.text(sheet.box(x + 28, top, column - 30, _ROW), f"{OFFSIDE_ACCURACY_M:g} m, offside")
    return y + rows * _ROW


def _range(low: float, high: float) -> str:
    return f"over {low:g} m" if math.isinf(high) else f"{low:g} – {high:g} m"


def _paint_figures(sheet: _Sheet, scene: ComparisonScene, y: float) -> None:
    compared = scene.compared
    if compared.statistics is None or compared.legacy is None:
        return
    y = _paint_spreads(sheet, compared.statistics.metres, compared.statistics.pixels, y)
    within = DASH if compared.within is None else f"{WITHIN.text(compared.within)} %"
    full = sheet.width - 2 * _MARGIN
    sheet.text(
        sheet.box(_MARGIN, y, full, _ROW),
        f"Within {OFFSIDE_ACCURACY_M:g} m: {within} of the compared area",
    )
    lines = (
        ("B against A: ", ("iou_part", "iou_whole")),
        ("errors: ", ("projection_m", "reprojection")),
    )
    for i, (start, names) in enumerate(lines, start=1):
        text = start + ", ".join(_figure(compared.legacy, name) for name in names)
        sheet.text(sheet.box(_MARGIN, y + i * _ROW, full, _ROW), text)


def _figure(legacy: LegacyMetrics, name: str) -> str:
    """A figure with its title and unit."""
    figure = next(figure for figure in LEGACY if figure.key == name)
    value = figure.of(legacy)
    number = DASH if value is None else f"{figure.text(value)} {figure.unit}"
    return _SHORT[name].format(number)


def _paint_spreads(sheet: _Sheet, metres: MapSummary, pixels: MapSummary, y: float) -> float:
    """Least, median and largest, in columns."""
    first, column = 130.0, (sheet.width - 2 * _MARGIN - 130.0) / 3
    rows = (
        ("Disagreement", ("min", "median", "max"), True),
        ("on the ground, m", [f.text(f.of(metres)) for f in METRES], False),
        ("in the picture, px", [f.text(f.of(pixels)) for f in PIXELS], False),
    )
    for title, cells, muted in rows:
        sheet.text(sheet.box(_MARGIN, y, first, _ROW), title, muted=muted)
        for i, cell in enumerate(cells):
            box = sheet.box(_MARGIN + first + i * column, y, column, _ROW)
            sheet.text(box, cell, muted=muted, right=True)
        y += _ROW
    return y


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
    """Paint the field as a camera shows it, as lines.

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
