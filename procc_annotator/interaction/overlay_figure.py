"""Draw an overlay without Qt, with matplotlib; place labels without overlap."""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.interaction.overlay_primitives import Box, Labels, Overlay, PointMarks, Strokes

if TYPE_CHECKING:
    from matplotlib.figure import Figure


_STEPS = 8  # heights of a text that it may be moved up or down


def place_apart(box: Box, taken: Sequence[Box], room: Box) -> Box:
    """The place nearest to where a text would go that no other text covers, and that is in sight.

    Args:
        box: where it would go: left, top, right, bottom.
        taken: texts that are there.
        room: what can be seen.

    Returns:
        A place of the same size; ``box`` itself where there is no better one.
    """
    return next((b for b in _around(box) if _within(b, room) and not _covers(b, taken)), box)


def _around(box: Box) -> Iterator[Box]:
    left, top, right, bottom = box
    wide, high = right - left, bottom - top
    for aside in (0.0, wide, -wide):
        for step in range(_STEPS + 1):
            for sign in (-1, 1) if step else (1,):
                x, y = left + aside, top + sign * step * high
                yield x, y, x + wide, y + high


def _within(box: Box, room: Box) -> bool:
    return box[0] >= room[0] and box[1] >= room[1] and box[2] <= room[2] and box[3] <= room[3]


def _covers(box: Box, taken: Sequence[Box]) -> bool:
    return any(
        box[0] < other[2] and box[2] > other[0] and box[1] < other[3] and box[3] > other[1]
        for other in taken
    )


_DPI = 100.0
_FONT_PIXELS, _GAP = 12.0, 9.0  # points of the overlay
_RIM, _PLATE = "#202020", "#141414"
_MARKERS = {"dot": "o", "ring": "o", "handle": "s", "cross": "x"}
_SETTINGS: Any = {
    "lines.scale_dashes": False,
    "text.parse_math": False,  # titles come from files: a dollar sign in one is no formula
    "svg.fonttype": "none",
    "svg.hashsalt": "procc-annotator",
    "path.simplify": False,
}


def draw_overlay(
    pixels: NDArray[np.uint8],
    overlay: Overlay,
    *,
    scale: float,
    unit: float,
    caption: str = "",
    svg: bool = False,
) -> NDArray[np.uint8] | bytes:
    """A picture with an overlay.

    Args:
        pixels: (H, W, 4) BGRA, of the size of the result.
        overlay: in px of the picture as it was.
        scale: px of the result per px of that picture. unit: px of the result per point.
        caption: in the lower left corner.
        svg: as SVG, instead of an array (H, W, 4) BGRA.
    """
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    height, width = pixels.shape[:2]
    with rc_context(_SETTINGS):
        figure = Figure(figsize=(width / _DPI, height / _DPI), dpi=_DPI)
        axes: Any = figure.add_axes((0, 0, 1, 1))
        axes.set(xlim=(0, width), ylim=(height, 0))
        axes.set_axis_off()
        axes.imshow(pixels[:, :, 2::-1], extent=(0, width, height, 0), aspect="auto")
        point = unit * 72.0 / _DPI  # matplotlib's points
        for strokes in overlay.seen_strokes:
            _draw_strokes(axes, strokes, scale, point)
        for marks in overlay.seen_marks:
            _draw_marks(axes, marks, scale, point)
        canvas = FigureCanvasAgg(figure)
        _draw_labels(axes, canvas, overlay.labels, scale, unit)
        if caption:
            plate = {"facecolor": _RIM, "alpha": 0.8, "linewidth": 0, "pad": 4 * point}
            axes.text(
                8 * unit, height - 8 * unit, caption, color="white", va="bottom",
                fontsize=14 * point, bbox=plate,
            )  # fmt: skip
        return _svg(figure) if svg else _array(canvas)


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
    marker, size = _MARKERS.get(marks.shape, "o"), (marks.size * point) ** 2
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


def _array(canvas: Any) -> NDArray[np.uint8]:
    canvas.draw()
    found: NDArray[np.uint8] = np.asarray(canvas.buffer_rgba())[:, :, [2, 1, 0, 3]]
    return found


def _svg(figure: Figure) -> bytes:
    stream = io.BytesIO()
    figure.savefig(stream, format="svg", dpi=_DPI, metadata={"Date": None})  # not shown
    return stream.getvalue()
