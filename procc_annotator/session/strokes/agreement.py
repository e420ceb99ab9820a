"""Which of many places found beside a course lie on one smooth line."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]

AGREE_PX = 0.8  # offsets this near to the smooth ones lie on the line


def smooth_inliers(
    places: FloatArray, values: FloatArray, reach: float, *, terms: int
) -> tuple[BoolArray, FloatArray]:
    """Which offsets lie on one smooth course, and its coefficients.

    The course through two of the offsets that most others agree with, then fitted to those.

    Args:
        places: (n,) along the course, -1 to 1, ascending.
        values: (n,) px across it, n >= 2.
        reach: px; how far the line may lie.
        terms: of the series at most; 2 where it is straight.

    Returns:
        (n,) which agree, and the coefficients of a Legendre series of the offsets.
    """
    i, j = np.triu_indices(len(places), 1)
    slopes = (values[j] - values[i]) / np.maximum(places[j] - places[i], 1e-9)
    level = values[i] - slopes * places[i]
    possible = np.abs(level) + np.abs(slopes) <= reach + 1.0
    level = np.concatenate([level[possible], values])
    slopes = np.concatenate([slopes[possible], np.zeros(len(values))])
    apart = np.abs(level[:, None] + slopes[:, None] * places - values)
    # Many that agree, and well; near the prediction where that leaves a choice.
    merit = np.maximum(1.0 - (apart / (2 * AGREE_PX)) ** 2, 0.0).sum(axis=1)
    merit -= 0.1 * (np.abs(level) + np.abs(slopes)) / reach
    best = int(merit.argmax())
    kept = apart[best] <= 2 * AGREE_PX
    coefficients = np.array([level[best], slopes[best]])
    for _ in range(4):
        used = min(terms, max(1, int(kept.sum()) // 3))
        basis = np.polynomial.legendre.legvander(places, used - 1)
        penalty = 0.02 * np.diag(np.arange(used) ** 2.0)
        own = basis[kept]
        coefficients = np.linalg.solve(own.T @ own + penalty, own.T @ values[kept])
        kept = np.abs(basis @ coefficients - values) <= AGREE_PX
        if kept.sum() < 3:
            break
    return kept, coefficients
