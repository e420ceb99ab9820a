"""Write segmentation masks: one grey PNG per frame and ``classes.json``.

Masks are made, never read: what was clicked cannot be distinguished from a picture of lines.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import pairwise
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import Polyline, points_px
from procc_annotator.arrays import FloatArray
from procc_annotator.errors import UsageError
from procc_annotator.formats.annotations.exchange import ExchangedFrame, Size, WriteContext
from procc_annotator.formats.strict_json import json_text, printable

LEGEND_NAME = "classes.json"
BACKGROUND = 0
WIDEST = 200.0
_LARGEST_VALUE = 255
MOST_PX = 100_000_000
"""Of a mask; larger pictures than any camera takes would fill the memory."""
_Mask = NDArray[np.uint8]


def check_line_width(width: float) -> None:
    """Fail before the work. `UsageError` if a line of this width cannot be drawn."""
    if not 1 <= width <= WIDEST:
        raise UsageError(f"a line width is 1 to {WIDEST:g} px, not {width:g}")


def write_many(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    """One mask a frame and the legend. `UsageError` for a line width that cannot be drawn."""
    check_line_width(writing.line_width)
    values = {e.name: i for i, e in enumerate(writing.field.elements, start=1)}
    for name in writing.field.classes_without_geometry:
        values[name] = len(values) + 1
    writing.remarks.add("masks hold pictures of the lines, not the clicks; they are not read back")
    for frame in frames:
        size = writing.size(frame)
        if size is None or not _drawable(frame, size, writing):
            continue
        drawn = []
        for polyline in frame.annotation.polylines:
            if polyline.points and values.setdefault(
                polyline.class_name, len(values) + 1
            ) <= _LARGEST_VALUE:  # fmt: skip
                drawn.append(polyline)
            elif polyline.points:
                writing.remarks.add(f"masks have {_LARGEST_VALUE} values: left out", frame.name)
        mask = draw_mask(drawn, values, size, writing.line_width)
        if any(_leaves_picture(p, size) for p in drawn):
            writing.remarks.add("what lies outside the picture is not in its mask", frame.name)
        done, png = cv2.imencode(".png", mask)
        assert done  # the encoder takes every grey picture
        writing.put_frame_file(f"{frame.name}.png", png.tobytes(), tuple(drawn))
    if not writing.frames:
        return
    legend = _legend({n: v for n, v in values.items() if v <= _LARGEST_VALUE}, writing)
    writing.put(LEGEND_NAME, f"{json_text(legend)}\n".encode())


def _drawable(frame: ExchangedFrame, size: Size, writing: WriteContext) -> bool:
    """Return whether a mask of this size is drawn; otherwise the frame is a problem."""
    if size[0] * size[1] <= MOST_PX:
        return True
    writing.problems.append(
        f"{printable(frame.name)}: not written: a mask of {size[0]}x{size[1]} is too large, at most"
        f" {MOST_PX // 1_000_000} million px are drawn (is the size right?)"
    )
    return False


def draw_mask(
    polylines: Iterable[Polyline], values: dict[str, int], size: Size, line_width: float
) -> _Mask:
    """(H, W) uint8: a class's value where its lines are, 0 elsewhere.

    Where lines cross, the one later in the legend is on top, whatever the order of the file; a
    single point becomes a dot. Size and width in px.
    """
    mask: _Mask = np.full((size[1], size[0]), BACKGROUND, dtype=np.uint8)
    for polyline in sorted(polylines, key=lambda p: values[p.class_name]):
        points = points_px(polyline, size)
        value = values[polyline.class_name]
        if len(points) == 1:
            points = np.repeat(points, 2, axis=0)
        for start, end in pairwise(points):
            _draw_segment(mask, start, end, value, line_width)
    return mask


def _draw_segment(
    mask: _Mask, start: FloatArray, end: FloatArray, value: int, line_width: float
) -> None:
    """Draw every pixel with its centre within half the line width of a segment.

    OpenCV's lines have whole widths and miss or add up to a pixel at their sides and ends. What is
    meant is convex, so that each row of the picture has one run of pixels, found exactly.
    """
    height, width = mask.shape
    radius = line_width / 2
    top = max(0, math.ceil(min(start[1], end[1]) - radius))
    bottom = min(height - 1, math.floor(max(start[1], end[1]) + radius))
    rows = np.arange(top, bottom + 1, dtype=np.float64)
    left, right = _runs(rows, start, end, radius)
    first = np.clip(np.ceil(left), 0, width)  # NaN-free: a row without a run has left > right
    last = np.clip(np.floor(right), -1, width - 1)
    for y, a, b in zip(rows.astype(int), first.astype(int), last.astype(int), strict=True):
        mask[y, a : b + 1] = value


def _runs(
    rows: FloatArray, start: FloatArray, end: FloatArray, radius: float
) -> tuple[FloatArray, FloatArray]:
    """(R,) left and right ends of the run in each row: the hull of two discs and a rectangle."""
    left, right = np.full(len(rows), np.inf), np.full(len(rows), -np.inf)
    for centre in (start, end):
        inside = radius**2 - (rows - centre[1]) ** 2
        half = np.sqrt(np.maximum(inside, 0))
        left = np.where(inside >= 0, np.minimum(left, centre[0] - half), left)
        right = np.where(inside >= 0, np.maximum(right, centre[0] + half), right)
    along = end - start
    length = float(np.hypot(*along))
    if length > 0:
        ux, uy = along / length
        # x relative to the start with 0 <= x ux + y uy <= length and |y ux - x uy| <= radius.
        y = rows - start[1]
        low, high = _slab(ux, y * uy, 0.0, length)
        other_low, other_high = _slab(-uy, y * ux, -radius, radius)
        low, high = np.maximum(low, other_low), np.minimum(high, other_high)
        left = np.where(low <= high, np.minimum(left, start[0] + low), left)
        right = np.where(low <= high, np.maximum(right, start[0] + high), right)
    return left, right


def _slab(
    slope: float, offset: FloatArray, lowest: float, highest: float
) -> tuple[FloatArray, FloatArray]:
    """(R,) range of x with ``lowest <= slope x + offset <= highest``; empty as (inf, -inf)."""
    if slope == 0:
        inside = (lowest <= offset) & (offset <= highest)
        return np.where(inside, -np.inf, np.inf), np.where(inside, np.inf, -np.inf)
    ends = (lowest - offset) / slope, (highest - offset) / slope
    return np.minimum(*ends), np.maximum(*ends)


def _leaves_picture(polyline: Polyline, size: Size) -> bool:
    points = points_px(polyline, size)
    return bool(np.any(points < 0) or np.any(points > (size[0] - 1, size[1] - 1)))


def _legend(values: dict[str, int], writing: WriteContext) -> dict[str, Any]:
    classes = []
    for name, value in values.items():
        element = writing.field.element(name)
        colour = element.colour if element is not None else "#808080"
        classes.append({"value": value, "class": name, "colour": colour})
    return {"background": BACKGROUND, "line_width_px": writing.line_width, "classes": classes}
