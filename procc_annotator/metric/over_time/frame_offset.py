"""By how many frames cameras and annotations, or cameras and pictures, are shifted in time.

The cameras are tried at every shift: a cost is asked for of frame n under the camera that is filed
under frame n + shift. What fits best with the camera of a later frame has cameras that are late.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from procc_annotator.metric.polylines import FloatArray, IntArray

MAX_SHIFT = 5
MIN_FRAMES = 3
_MIN_MARGIN_SE = 3.0  # standard errors by which the best shift is better than any other
_MIN_MARGIN_PX = 0.05


@dataclass(frozen=True)
class FrameOffset:
    """Of one shot.

    Attributes:
        shift: frames; 1: the camera filed one frame later fits, cameras are one frame late.
        cost_px: mean over the frames at that shift, and ``cost_as_is_px`` without a shift.
        margin_px: by how much the next best shift is worse, and ``margin_se_px`` its standard
            error over frames.
        frames: that have a camera at every shift.
        costs_px: (2 K + 1,) at the shifts from -K to K.
    """

    shift: int
    cost_px: float
    cost_as_is_px: float
    margin_px: float
    margin_se_px: float
    frames: int
    costs_px: tuple[float, ...]

    @property
    def is_sure(self) -> bool:
        """Whether no other shift could be the right one: never where nothing moves."""
        least = max(_MIN_MARGIN_PX, _MIN_MARGIN_SE * self.margin_se_px)
        return self.frames >= MIN_FRAMES and self.margin_px > least

    @property
    def in_words(self) -> str:
        """``cameras are 1 frame late``, for people."""
        if not self.is_sure:
            return "cannot be told"
        if self.shift == 0:
            return "none"
        frames = f"{abs(self.shift)} frame" + ("" if abs(self.shift) == 1 else "s")
        return f"cameras are {frames} {'late' if self.shift > 0 else 'early'}"


def shift_range(largest: int = MAX_SHIFT) -> IntArray:
    """(2 K + 1,) from -K to K."""
    return np.arange(-largest, largest + 1)


def frame_offset(costs_px: FloatArray) -> FrameOffset | None:
    """The shift at which a shot fits best.

    Args:
        costs_px: (F, 2 K + 1) of each frame at each shift, NaN where there is no camera.

    Returns:
        None where fewer than three frames have a camera at every shift. Shifts at the ends that
        would leave hardly any frame are not tried.
    """
    half = costs_px.shape[1] // 2
    for largest in range(half, 0, -1):
        table = costs_px[:, half - largest : half + largest + 1]
        whole = table[np.isfinite(table).all(axis=1)]
        if len(whole) >= max(MIN_FRAMES, len(costs_px) // 2):
            return _best_shift(whole, largest)
    return None


def _best_shift(table: FloatArray, largest: int) -> FrameOffset:
    mean = table.mean(axis=0)
    best = int(mean.argmin())
    worse = table - table[:, best : best + 1]
    margins = worse.mean(axis=0)
    margins[best] = np.inf
    next_best = int(margins.argmin())
    spread = float(worse[:, next_best].std(ddof=1)) if len(table) > 1 else math.inf
    return FrameOffset(
        shift=best - largest,
        cost_px=float(mean[best]),
        cost_as_is_px=float(mean[largest]),
        margin_px=float(margins[next_best]),
        margin_se_px=spread / math.sqrt(len(table)),
        frames=len(table),
        costs_px=tuple(mean.tolist()),
    )
