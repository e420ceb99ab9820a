"""Figures of two cameras' disagreement: the frame, and a panel with the field and the values."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.errors import printable
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.figures.overlay import (
    encode_picture,
    figure_file,
    figure_pixels,
    figure_style,
    pixel_figure,
    polylines_patch,
)
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction import palette
from procc_annotator.interaction.camera_view import DISAGREEMENT
from procc_annotator.metrics.error_maps import (
    DISAGREEMENT_LEVELS_M,
    OFFSIDE_ACCURACY_M,
    contour_lines,
    filled_contours,
)
from procc_annotator.metrics.ground_plane import field_rectangle
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.comparison import ComparisonScene
from procc_annotator.report.tables.metrics import LEGACY, METRES, PIXELS, WITHIN
from procc_annotator.report.tables.table import DASH

SUFFIXES = (".png", ".jpg", ".svg", ".pdf")
_WIDTH, _HEIGHT = 430.0, 540.0  # points of the panel; it may be higher than that
_BACK, _TEXT, _MUTED, _GREY = "#1E1E1E", "#F2F2F2", "#B8B8B8", (96, 96, 96, 255)
_MAT = "#606060"
_MARGIN, _ROW, _MAP_HEIGHT, _FONT = 12.0, 19.0, 252.0, 12.0
_RUN_OFF_M, _LINE_SPACING_M = 4.0, 0.5
_LONGEST = 34  # characters of a name; the middle of a longer one is left out
_SHORT = {
    "iou_part": "IoU part {}",
    "iou_whole": "whole {}",
    "projection_m": "projection {}",
    "reprojection": "reprojection {} of height",
}


class DisagreementPainter:
    """Called with a scene, gives the figure encoded as one of `SUFFIXES`."""

    def __init__(self, suffix: str = ".png") -> None:
        self._suffix = suffix

    def __call__(self, scene: ComparisonScene) -> bytes:
        """The encoded figure; ImageError if the frame's picture cannot be decoded."""
        pixels = _background(scene)
        with figure_style():
            figure = _figure(scene, pixels)
            if self._suffix in (".svg", ".pdf"):
                return figure_file(figure, self._suffix)
            drawn = figure_pixels(figure)
        return encode_picture(drawn, self._suffix, scene.compared.name)


def _background(scene: ComparisonScene) -> PixelArray:
    if scene.image_path is not None:
        return decode_bgra(scene.image_path)
    width, height = scene.disagreement.size
    return np.full((height, width, 4), _GREY, dtype=np.uint8)


def _figure(scene: ComparisonScene, pixels: PixelArray) -> Any:
    """The picture on the left; the panel as high as it, with text that grows with it."""
    height, width = pixels.shape[:2]
    unit = max(1.0, height / _HEIGHT)
    whole, full = max(float(height), _HEIGHT * unit), width + _WIDTH * unit
    figure = pixel_figure(full, whole)
    figure.set_facecolor(_MAT)
    left: Any = figure.add_axes((0, 1 - height / whole, width / full, height / whole))
    left.set_axis_off()
    left.imshow(pixels[:, :, 2::-1], extent=(0, width, height, 0), aspect="auto")
    left.set(xlim=(0, width), ylim=(height, 0))
    _draw_frame(left, scene, (width, height), max(0.6, height / _HEIGHT) * 0.72)
    right: Any = figure.add_axes((width / full, 0, 1 - width / full, 1))
    right.set(xlim=(0, _WIDTH), ylim=(whole / unit, 0))
    right.set_axis_off()
    right.add_patch(_box(0, 0, _WIDTH, whole / unit, _BACK))
    _draw_panel(right, scene, unit * 0.72, _ground_tone(scene, pixels))
    return figure


def _box(x: float, y: float, width: float, height: float, colour: Any, alpha: float = 1.0) -> Any:
    from matplotlib.patches import Rectangle

    return Rectangle((x, y), width, height, facecolor=colour, alpha=alpha, linewidth=0)


def _ground_tone(scene: ComparisonScene, pixels: PixelArray) -> NDArray[np.float64]:
    """(3,) RGB, 0 to 1, of the mean colour under the bands: tones of the panel are the
    picture's."""
    found = scene.disagreement
    rows, columns = np.nonzero(~np.isnan(found.metres))
    height, width = pixels.shape[:2]
    x = np.rint(found.xs_px[columns] * (width - 1) / (found.size[0] - 1)).astype(np.intp)
    y = np.rint(found.ys_px[rows] * (height - 1) / (found.size[1] - 1)).astype(np.intp)
    tone = pixels[y, x, 2::-1].mean(axis=0) if len(x) else np.array(_GREY[:3])
    return np.asarray(tone / 255)


def _draw_map(axes: Any, values: FloatArray, x: FloatArray, y: FloatArray, width: float) -> None:
    """Bands of a disagreement and its dashed limit, in the coordinates of the axes."""
    style = DISAGREEMENT
    for band, colour in zip(
        filled_contours(values, x, y, style.levels_m), style.colours, strict=True
    ):
        outlines = [outline for polygon in band.polygons for outline in polygon]
        if outlines:  # smoothed, neighbouring bands would let the ground through
            axes.add_patch(
                polylines_patch(
                    outlines, fill=True, color=colour, alpha=style.opacity, linewidth=0,
                    antialiased=False,
                )
            )  # fmt: skip
    for line in style.lines:
        _draw_lines(
            axes, contour_lines(values, x, y, line.metres), palette.HALO,
            palette.LIMIT_WIDTH * width, line.dash,
        )  # fmt: skip


def _draw_lines(
    axes: Any, lines: Any, colour: str, width: float, dash: tuple[float, ...] = ()
) -> None:
    """Lines with a dark rim, which show on every ground."""
    found = list(lines)
    if not any(len(line) > 1 for line in found):
        return
    style = (0, tuple(length / palette.LIMIT_WIDTH for length in dash)) if dash else "-"
    for tone, thickness in ((palette.OUTLINE, 2 * width), (colour, width)):
        axes.add_patch(polylines_patch(found, color=tone, linewidth=thickness, linestyle=style))


def _draw_frame(axes: Any, scene: ComparisonScene, size: tuple[int, int], unit: float) -> None:
    """Bands, limit, the projections of both cameras, and a note where there is no picture."""
    found = scene.disagreement
    scale = (np.array(size) - 1) / (np.array(found.size) - 1)
    x, y = found.xs_px * scale[0] + 0.5, found.ys_px * scale[1] + 0.5
    _draw_map(axes, found.metres, x, y, unit)
    setup = EvaluationSetup(scene.field, found.size, "procc")
    cameras = (scene.cameras.a, scene.cameras.b)
    for camera, colour in zip(cameras, palette.PAIR_COLOURS, strict=True):
        shown = project_field(camera, setup)
        lines = [piece * scale + 0.5 for pieces in shown.pieces.values() for piece in pieces]
        _draw_lines(axes, lines, colour, 1.6 * unit)
    if scene.image_path is None:
        axes.text(
            8, size[1] - 8, "no picture of this frame", color="white", va="bottom",
            fontsize=_FONT * unit,
        )  # fmt: skip


def _draw_panel(axes: Any, scene: ComparisonScene, unit: float, ground: Any) -> None:
    panel = _Panel(axes, unit)
    full = _WIDTH - 2 * _MARGIN
    size = scene.disagreement.size
    y = 8.0
    panel.text(_MARGIN, y, f"Frame {_shortened(scene.compared.name)}", weight="bold")
    panel.text(_WIDTH - _MARGIN, y, f"compared at {size[0]}x{size[1]}", ha="right", color=_MUTED)
    y += _ROW
    for name, colour, letter in zip(scene.names, palette.PAIR_COLOURS, "AB", strict=True):
        panel.line(_MARGIN, y, colour)
        panel.text(_MARGIN + 28, y, f"{letter}: {_shortened(name)}")
        y += _ROW
    y = _draw_field(axes, scene, unit, ground, y + 4)
    texts = [_range(low, high) for low, high in itertools.pairwise(DISAGREEMENT_LEVELS_M)]
    rows, column = math.ceil((len(texts) + 1) / 2), full / 2
    for i, (text, colour) in enumerate(zip(texts, palette.DISAGREEMENT_COLOURS, strict=True)):
        x, top = _MARGIN + (i // rows) * column, y + 6 + (i % rows) * _ROW
        axes.add_patch(_box(x, top + 3, 22, _ROW - 5, ground))
        axes.add_patch(_box(x, top + 3, 22, _ROW - 5, colour, palette.DISAGREEMENT_OPACITY))
        panel.text(x + 28, top, text)
    x, top = _MARGIN + column, y + 6 + (rows - 1) * _ROW
    panel.line(x, top, palette.HALO, (4.5, 3.0))
    panel.text(x + 28, top, f"{OFFSIDE_ACCURACY_M:g} m, offside")
    _draw_values(panel, scene, y + 12 + rows * _ROW)


def _draw_field(axes: Any, scene: ComparisonScene, unit: float, ground: Any, y: float) -> float:
    """The field from above, the main camera's side down, with the bands where A sees them."""
    area = field_rectangle(scene.field)
    left, top = area.left - _RUN_OFF_M, area.top - _RUN_OFF_M
    wide = area.right - area.left + 2 * _RUN_OFF_M
    high = area.bottom - area.top + 2 * _RUN_OFF_M
    per_metre = min((_WIDTH - 2 * _MARGIN) / wide, _MAP_HEIGHT / high)
    x = (_WIDTH - per_metre * wide) / 2
    box = (x, y, per_metre * wide, per_metre * high)
    inner: Any = axes.inset_axes(box, transform=axes.transData)
    inner.set(xlim=(left, left + wide), ylim=(top + high, top))
    inner.set_axis_off()
    inner.add_patch(_box(left, top, wide, high, ground))
    seen = scene.disagreement.ground_a
    _draw_map(inner, scene.disagreement.metres, seen[..., 0], seen[..., 1], 0.75 * unit)
    samples = sample_evenly(scene.field, _LINE_SPACING_M)
    lines = [samples.of(i)[:, :2] for i, e in enumerate(scene.field.elements) if e.on_ground]
    _draw_lines(inner, lines, "#FFFFFF", 0.9 * unit)
    return y + box[3]


def _draw_values(panel: _Panel, scene: ComparisonScene, y: float) -> None:
    compared = scene.compared
    if compared.statistics is None or compared.legacy is None:
        return
    found = compared.statistics
    metres, pixels = ([one.text(one.of(v)) for one in of]
                      for of, v in ((METRES, found.metres), (PIXELS, found.pixels)))  # fmt: skip
    rows = (
        ("Disagreement", ["min", "median", "max"], _TEXT),
        ("on the ground, m", metres, _MUTED),
        ("in the picture, px", pixels, _MUTED),
    )
    column = (_WIDTH - 2 * _MARGIN - 130.0) / 3
    for title, cells, colour in rows:
        panel.text(_MARGIN, y, title, color=colour)
        for i, cell in enumerate(cells, 1):
            panel.text(_MARGIN + 130 + i * column, y, cell, ha="right", color=colour)
        y += _ROW
    within = DASH if compared.within is None else f"{WITHIN.text(compared.within)} %"
    texts = [f"Within {OFFSIDE_ACCURACY_M:g} m: {within} of the compared area"]
    for start, keys in (("B against A: ", ("iou_part", "iou_whole")),
                        ("errors: ", ("projection_m", "reprojection"))):  # fmt: skip
        words = []
        for key in keys:
            metric = next(one for one in LEGACY if one.key == key)
            value = metric.of(compared.legacy)
            number = DASH if value is None else f"{metric.text(value)} {metric.unit}"
            words.append(_SHORT[key].format(number))
        texts.append(start + ", ".join(words))
    for i, text in enumerate(texts):
        panel.text(_MARGIN, y + i * _ROW, text)


class _Panel:
    """Text and samples of lines, in points from the upper left corner."""

    def __init__(self, axes: Any, unit: float) -> None:
        self._axes, self._unit = axes, unit

    def text(self, x: float, y: float, text: str, **style: Any) -> None:
        look = {"color": _TEXT, "fontsize": _FONT * self._unit, "va": "center", **style}
        self._axes.text(x, y + _ROW / 2, text, **look)

    def line(self, x: float, y: float, colour: str, dash: tuple[float, ...] = ()) -> None:
        line = np.array([(x, y + _ROW / 2), (x + 22, y + _ROW / 2)])
        style = (0, dash) if dash else "-"
        width = palette.LIMIT_WIDTH * self._unit
        self._axes.add_patch(polylines_patch([line], color=colour, lw=width, linestyle=style))


def _shortened(name: str) -> str:
    half, name = (_LONGEST - 1) // 2, printable(name)
    return name if len(name) <= _LONGEST else f"{name[:half]}…{name[-half:]}"


def _range(low: float, high: float) -> str:
    return f"over {low:g} m" if math.isinf(high) else f"{low:g} – {high:g} m"
