"""Values between the samples of a map."""

from __future__ import annotations

import numpy as np

from procc_annotator.metric.polylines import FloatArray


def bilinear_value(
    values: FloatArray, xs: FloatArray, ys: FloatArray, x: float, y: float
) -> float | None:
    """A value between four samples, in proportion to its distances from them.

    Args:
        values: (h, w); NaN where there is none.
        xs, ys: (w,), (h,) places of the samples, ascending, at least two each.
        x, y: the place asked for.

    Returns:
        None off the grid, and where a sample that counts has no value.
    """
    if not (xs[0] <= x <= xs[-1] and ys[0] <= y <= ys[-1]):
        return None
    column = min(int(np.searchsorted(xs, x, side="right")) - 1, len(xs) - 2)
    row = min(int(np.searchsorted(ys, y, side="right")) - 1, len(ys) - 2)
    across = (x - xs[column]) / (xs[column + 1] - xs[column])
    down = (y - ys[row]) / (ys[row + 1] - ys[row])
    corners = values[row : row + 2, column : column + 2]
    weights = np.outer((1 - down, down), (1 - across, across))
    value = float((np.where(weights > 0, corners, 0.0) * weights).sum())
    return None if np.isnan(value) else value
