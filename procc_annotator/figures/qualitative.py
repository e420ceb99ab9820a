"""Qualitative figures: a grid of frames and methods, coloured by the threshold."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke

from procc_annotator.errors import UsageError, printable
from procc_annotator.figures.overlay import (
    MARKERS,
    draw_picture,
    figure_file,
    figure_style,
    pixel_figure,
    resized,
    scene_content,
)
from procc_annotator.interaction import palette
from procc_annotator.interaction.legend import LegendEntry, legend_of
from procc_annotator.interaction.overlay import OverlayBuilder
from procc_annotator.report.overlay_scene import Scene, pixels_of

SUFFIXES = (".svg", ".pdf", ".png")
_DPI = 100.0  # of `pixel_figure`: inches are this many of its px
_FONT, _LINE = 8.0, 14.0  # points; px of a line of text
_GAP = 4.0  # px between cells
_ENTRY = 240.0  # px of an entry of the legend
_POINTS_WIDE = 420.0  # points of an overlay in the width of a cell: half the picture on screen
_SHARPEST_PX_PER_INCH = 300.0
_HIGHEST = 5  # times as high as wide
_RIM = withStroke(linewidth=2.2, foreground=palette.OUTLINE)  # white lines on white paper


def qualitative_figure(
    rows: Sequence[Sequence[Scene]], methods: Sequence[str], suffix: str, width_in: float
) -> bytes:
    """Draw frames (rows) by methods (columns), with JaC in each cell and a legend below.

    Args:
        rows: of each frame one scene per method.
        methods: headings of the columns.
        suffix: one of `SUFFIXES`; lines and text of SVG and PDF stay sharp.
        width_in: inches, of the whole figure.

    Raises:
        ImageError: a picture cannot be decoded. UsageError: too many frames for one figure.
    """
    pictures = [pixels_of(scenes[0]) for scenes in rows]
    width, side = width_in * _DPI, _LINE + 2
    cell = (width - side - _GAP * (len(methods) - 1)) / len(methods)
    heights = [cell * p.shape[0] / p.shape[1] for p in pictures]
    entries = _legend([scene for scenes in rows for scene in scenes])
    columns = max(1, min(len(entries), int(width // _ENTRY)))
    below = _LINE * (2 + -(-len(entries) // columns))
    height = _LINE + sum(heights) + _GAP * (len(rows) - 1) + below
    if height > _HIGHEST * width:
        fit = int(len(rows) * _HIGHEST * width / height)
        raise UsageError(
            f"{len(rows)} frames make a figure of {width_in:g} x {height / _DPI:.0f} inches,"
            f" expected at most {_HIGHEST} times as high as wide: take at most {fit} frames"
            " (--count), or several figures of some frames each (--frame)"
        )
    with figure_style():
        figure = pixel_figure(width, height)
        y = _LINE
        for pixels, scenes, high in zip(pictures, rows, heights, strict=True):
            # One picture for all methods, no sharper than a printer shows.
            scale = min(1.0, cell / _DPI * _SHARPEST_PX_PER_INCH / pixels.shape[1])
            small = resized(pixels, scale)
            for at, (scene, method) in enumerate(zip(scenes, methods, strict=True)):
                x = side + at * (cell + _GAP)
                axes: Any = figure.add_axes(
                    (x / width, 1 - (y + high) / height, cell / width, high / height)
                )
                overlay = OverlayBuilder().build(scene_content(scene, pixels))
                point = cell / _DPI * 72 / _POINTS_WIDE
                draw_picture(axes, small, overlay, scale=scale, point=point)
                _caption(axes, scene)
                if y == _LINE:
                    place = (x + cell / 2) / width, 1 - 2 / height
                    figure.text(*place, printable(method), ha="center", va="top", size=_FONT)
            side_title: Any = {"rotation": 90, "va": "center", "ha": "left", "size": _FONT}
            middle = 1 - (y + high / 2) / height
            figure.text(2 / width, middle, printable(scenes[0].title), **side_title)
            y += high + _GAP
        handles = [_handle(entry) for entry in entries]
        figure.legend(
            handles=handles, loc="lower center", ncols=columns, frameon=False, fontsize=_FONT - 1,
            handlelength=2.5, columnspacing=1.2, borderaxespad=0.1,
        )  # fmt: skip
        return figure_file(figure, suffix, dpi=_SHARPEST_PX_PER_INCH)


def _caption(axes: Any, scene: Scene) -> None:
    text = "no camera" if scene.camera is None else ""
    if scene.score is not None:
        mirrored = ", labels mirrored" if scene.score.mirrored else ""
        text = f"JaC@{scene.score.threshold:g} {100 * scene.score.jac:.1f} %{mirrored}"
    if text:
        axes.text(
            0.01, 0.02, text, transform=axes.transAxes, color="white", size=_FONT - 1,
            bbox={"facecolor": palette.OUTLINE, "alpha": 0.8, "linewidth": 0, "pad": 1.5},
        )  # fmt: skip


def _legend(scenes: Sequence[Scene]) -> list[LegendEntry]:
    found = [
        entry
        for scene in scenes
        for entry in legend_of(
            scene.annotation, scene.setup.field, scene.measurement, scene.score, scene.setup.size
        )
        if scene.camera is not None
    ]
    return list({entry.text: entry for entry in found}.values())


def _handle(entry: LegendEntry) -> Line2D:
    line = entry.lines[-1] if entry.lines else None
    style: dict[str, Any] = {"color": "none"} if line is None else {
        "color": line.colour, "linewidth": 1.5, "path_effects": [_RIM],
        "linestyle": (0, tuple(d / 2 for d in line.dash)) if line.dash else "-",
    }  # fmt: skip
    if entry.mark is not None:
        hollow = entry.mark.shape == "ring"
        style |= {
            "marker": MARKERS.get(entry.mark.shape, "o"), "markersize": 4,
            "markeredgecolor": entry.mark.colour,
            "markerfacecolor": "none" if hollow else entry.mark.colour,
        }  # fmt: skip
    return Line2D([], [], label=entry.text, **style)
