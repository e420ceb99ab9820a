"""Whether a figure rises or falls over the order of work."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.metric.chance.sampling import BootstrapSettings
from procc_annotator.metric.polylines import FloatArray

_MIN_VALUES = 4  # of fewer values no order is rare


@dataclass(frozen=True, slots=True)
class Trend:
    """A trend.

    Attributes:
        slope: the median of the slopes between every two values, in their unit, from one to the
            next (Sen, Journal of the American Statistical Association 1968).
        p: the share of random orders in which values rise or fall as steadily: Kendall's count of
            pairs that rise less those that fall, permuted.
    """

    slope: float
    p: float


def trend_test(values: FloatArray, draws: BootstrapSettings) -> Trend | None:
    """The trend of (n,) values in their order; None of fewer than four."""
    count = len(values)
    if count < _MIN_VALUES:
        return None
    first, second = np.triu_indices(count, 1)
    slope = float(np.median((values[second] - values[first]) / (second - first)))

    def rises(order: FloatArray) -> FloatArray:
        return np.asarray(np.sign(order[..., second] - order[..., first]).sum(axis=-1))

    least = abs(float(rises(values)))
    rng = np.random.default_rng(draws.seed)
    reached = sum(
        int((np.abs(rises(rng.permuted(np.tile(values, (rows, 1)), axis=1))) >= least).sum())
        for rows in _rows(draws.count, len(first))
    )
    return Trend(slope, (1 + reached) / (1 + draws.count))


def _rows(count: int, pairs: int) -> list[int]:
    """So many at once that a matrix of all pairs stays small."""
    most = max(1, (1 << 20) // pairs)
    return [min(most, count - begin) for begin in range(0, count, most)]
