"""Overlays drawn with matplotlib: pixels, SVG, or a part of a figure."""

from __future__ import annotations

import io
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.errors import SaveError
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction.label_placement import place_apart
from procc_annotator.interaction.overlay import OverlayBuilder, OverlayContent
from procc_annotator.interaction.overlay_primitives import Box, Labels, Overlay, PointMarks, Strokes
from procc_annotator.report.overlay_scene import (
    OverlayLook,
    Scene,
    caption,
    check_pixels,
    pixels_of,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure


_DPI = 100.0
_FONT_PIXELS, _GAP = 12.0, 9.0  # points of the overlay
_RIM, _PLATE = "#202020", "#141414"
MARKERS = {"dot": "o", "ring": "o", "handle": "s", "cross": "x"}
_SETTINGS: Any = {
    "lines.scale_dashes": False,
    "text.parse_math": False,  # titles come from files: a dollar sign in one is no formula
    "svg.fonttype": "none",
    "pdf.fonttype": 42,
    "svg.hashsalt": "procc-annotator",
    "path.simplify": False,
}


def draw_overlay(
    pixels: NDArray[np.uint8],
    shown: OverlayContent,
    look: OverlayLook,
    *,
    caption: str = "",
    svg: bool = False,
) -> NDArray[np.uint8] | bytes:
    """A picture with an overlay.

    Args:
        pixels: (H, W, 4) BGRA, the picture.
        look: its scale; legend and width are not used.
        caption: in the lower left corner.
        svg: as SVG, instead of an array (H, W, 4) BGRA.

    Raises:
        UsageError: the result would be too large.
    """
    scale, unit = look.scale_and_unit(pixels.shape[1])
    pixels = resized(pixels, scale)
    overlay = OverlayBuilder().build(shown)
    height, width = pixels.shape[:2]
    with figure_style():
        figure = pixel_figure(width, height)
        axes: Any = figure.add_axes((0, 0, 1, 1))
        point = unit * 72.0 / _DPI  # matplotlib's points
        draw_picture(axes, pixels, overlay, scale=scale, point=point)
        _draw_labels(axes, figure.canvas, overlay.labels, scale, unit)
        if caption:
            plate = {"facecolor": _RIM, "alpha": 0.8, "linewidth": 0, "pad": 4 * point}
            axes.text(
                8 * unit, height - 8 * unit, caption, color="white", va="bottom",
                fontsize=14 * point, bbox=plate,
            )  # fmt: skip
        return figure_file(figure, ".svg") if svg else figure_pixels(figure)


def scene_content(scene: Scene, pixels: NDArray[np.uint8]) -> OverlayContent:
    """The content of a scene's overlay on its picture, (H, W, 4)."""
    return OverlayContent(
        annotation=scene.annotation,
        size=scene.setup.size,
        field=scene.setup.field,
        measurement=scene.measurement,
        score=scene.score,
        picture_size=(pixels.shape[1], pixels.shape[0]),
        paint=scene.paint,
    )


def resized(pixels: NDArray[np.uint8], scale: float) -> NDArray[np.uint8]:
    """A picture at another scale; UsageError if the result would be too large."""
    height, width = (max(1, round(extent * scale)) for extent in pixels.shape[:2])
    check_pixels(width, height)
    if (height, width) == pixels.shape[:2]:
        return pixels
    method = cv2.INTER_AREA if scale < 1 else cv2.INTER_CUBIC
    return np.asarray(cv2.resize(pixels, (width, height), interpolation=method), np.uint8)


def encode_picture(
    pixels: NDArray[np.uint8], suffix: str, title: str, settings: Sequence[int] = ()
) -> bytes:
    """(H, W, 3 or 4) BGR(A) as a file's content, without alpha; SaveError if that cannot be."""
    done, encoded = cv2.imencode(suffix, pixels[:, :, :3], settings)
    if not done:
        raise SaveError(f"{title}: the picture cannot be encoded as {suffix}")
    return encoded.tobytes()


def figure_style() -> Any:
    """Context of matplotlib's settings for the figures of this package."""
    from matplotlib import rc_context

    return rc_context(_SETTINGS)


def pixel_figure(width: float, height: float) -> Figure:
    """Figure of a size in px, with a raster canvas."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width / _DPI, height / _DPI), dpi=_DPI)
    FigureCanvasAgg(figure)
    return figure


def figure_pixels(figure: Figure) -> NDArray[np.uint8]:
    """(H, W, 4) BGRA of a figure of `pixel_figure`."""
    canvas: Any = figure.canvas
    canvas.draw()
    found: NDArray[np.uint8] = np.asarray(canvas.buffer_rgba())[:, :, [2, 1, 0, 3]]
    return found


def figure_file(figure: Figure, suffix: str, dpi: float = _DPI) -> bytes:
    """A figure as ``.svg``, ``.pdf``, ``.png`` or ``.jpg``, without the time it was made; ``dpi``
    is of what is not vectors."""
    stream = io.BytesIO()
    dated = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
    figure.savefig(stream, format=suffix[1:], dpi=dpi, metadata=dated.get(suffix))
    return stream.getvalue()


def draw_picture(
    axes: Any, pixels: NDArray[np.uint8], overlay: Overlay, *, scale: float, point: float
) -> None:
    """Draw a picture with strokes and marks, without labels, into axes of its own.

    Args:
        pixels: (H, W, 4) BGRA.
        overlay: in px of the picture as it was.
        scale: px of ``pixels`` per px of that picture.
        point: matplotlib's points per point of the overlay.
    """
    height, width = pixels.shape[:2]
    axes.set(xlim=(0, width), ylim=(height, 0))
    axes.set_axis_off()
    axes.imshow(pixels[:, :, 2::-1], extent=(0, width, height, 0), aspect="auto")
    for strokes in overlay.seen_strokes:
        _draw_strokes(axes, strokes, scale, point)
    for marks in overlay.seen_marks:
        _draw_marks(axes, marks, scale, point)


def polylines_patch(lines: Iterable[FloatArray], **style: Any) -> Any:
    """Patch of polylines, each (n, 2), for matplotlib's axes."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    paths = [Path(line) for line in lines if len(line) > 1]
    return PathPatch(Path.make_compound_path(*paths), **{"fill": False, **style})


def _draw_strokes(axes: Any, strokes: Strokes, scale: float, point: float) -> None:
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    ends = (strokes.segments.reshape(-1, 2, 2) + 0.5) * scale
    goes_on = np.zeros(len(ends), dtype=bool)
    goes_on[1:] = (np.abs(ends[1:, 0] - ends[:-1, 1]) < 1e-6).all(axis=1)
    # A segment that goes on from the one before adds its end only, so dashes run on along a curve.
    kept = np.stack((~goes_on, np.ones_like(goes_on)), axis=1).ravel()
    codes = np.tile([Path.MOVETO, Path.LINETO], len(ends))[kept]
    dash = tuple(length * point for length in strokes.dash)
    axes.add_patch(
        PathPatch(
            Path(ends.reshape(-1, 2)[kept], codes), fill=False, color=strokes.colour,
            linewidth=strokes.width * point, linestyle=(0, dash) if dash else "-",
            capstyle="butt",
        )
    )  # fmt: skip


def _draw_marks(axes: Any, marks: PointMarks, scale: float, point: float) -> None:
    at = (marks.centres + 0.5) * scale
    marker, size = MARKERS.get(marks.shape, "o"), (marks.size * point) ** 2
    if marks.shape in ("cross", "ring"):
        rim = 3.5 if marks.shape == "cross" else 3.0
        for colour, width in ((_RIM, rim), (marks.colour, rim / 2)):
            face = {"c": colour} if marker == "x" else {"facecolors": "none", "edgecolors": colour}
            axes.scatter(*at.T, size, marker=marker, linewidths=width * point, zorder=3, **face)
        return
    axes.scatter(
        *at.T, size, marker=marker, c=marks.colour, edgecolors=_RIM, linewidths=point, zorder=3
    )


def _draw_labels(
    axes: Any, canvas: Any, groups: Sequence[Labels], scale: float, unit: float
) -> None:
    size, height, taken = _FONT_PIXELS * unit, canvas.get_width_height()[1], list[Box]()
    room = (0.0, 0.0, float(canvas.get_width_height()[0]), float(height))
    renderer = canvas.get_renderer()
    for labels in groups:
        for at, words in zip((labels.positions + 0.5) * scale, labels.texts, strict=True):
            if not words:
                continue
            text = axes.text(
                0, 0, words, color=labels.colour, va="center", ha="left", zorder=5,
                fontsize=size * 72.0 / _DPI,
                bbox={"facecolor": _PLATE, "alpha": 0.75, "linewidth": 0, "pad": unit},
            )  # fmt: skip
            found = text.get_window_extent(renderer)
            wide, high = found.width + 6 * unit, found.height + 3 * unit
            x, y = float(at[0]), float(at[1])
            top = y + _GAP * unit if labels.below else y - _GAP * unit - high
            left = x + _GAP * unit
            if left + wide > room[2]:
                left = x - _GAP * unit - wide
            box = place_apart((left, top, left + wide, top + high), taken, room)
            taken.append(box)
            text.set_position((box[0] + 3 * unit, (box[1] + box[3]) / 2))


class PlainPictures:
    """Paint overlays without Qt: called with a scene, gives the encoded picture."""

    def __init__(self, suffix: str, look: OverlayLook) -> None:
        self._suffix, self._look = suffix, look

    def __call__(self, scene: Scene) -> bytes:
        drawn = self._drawn(scene, svg=self._suffix == ".svg")
        if isinstance(drawn, bytes):
            return drawn
        return encode_picture(drawn, self._suffix, scene.title)

    def pixels(self, scene: Scene) -> PixelArray:
        drawn = self._drawn(scene, svg=False)
        assert not isinstance(drawn, bytes)
        return drawn

    def _drawn(self, scene: Scene, *, svg: bool) -> PixelArray | bytes:
        pixels = pixels_of(scene)
        words = caption(scene) if self._look.caption else ""
        return draw_overlay(
            pixels, scene_content(scene, pixels), self._look, caption=words, svg=svg
        )
