"""What the clicks leave open: how much of a spread comes from where points were put."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.metric.polylines import FloatArray

# The median distance between two annotators, over the standard deviation of one's clicks across a
# line: the difference of two normal errors is root two times as wide, half of it within 0.6745.
_MEDIAN_OF_TWO = 0.6744897501960817 * 2**0.5


@dataclass(frozen=True, eq=False)
class ClickSpread:
    """K figures of a set, evaluated R times with every point moved at random.

    Attributes:
        means: (K,) over the repeats; below the figures themselves, whose clicks had been off once.
        deviations: (K,) standard deviations from repeat to repeat: what other clicks on these very
            frames would make of the figure.
        shares: (K,) how much of the variance from set to set comes from clicks, in [0, 1]; NaN
            where it does not vary.
    """

    means: FloatArray
    deviations: FloatArray
    shares: FloatArray


def click_spread(repeated: FloatArray, deviations: FloatArray) -> ClickSpread:
    """Compare what clicks alone change with what sets of other frames change.

    Args:
        repeated: (R, K) figures of the repeats.
        deviations: (K,) of the figures from set to set, where both frames and clicks are others.
    """
    means = repeated.mean(axis=0)
    own = repeated.std(axis=0, ddof=1) if len(repeated) > 1 else np.full(len(means), np.nan)
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = np.where(deviations > 0, np.minimum(1.0, (own / deviations) ** 2), np.nan)
    return ClickSpread(means, own, shares)


def noise_of_floor(median_px: float) -> float:
    """The standard deviation of one annotator's clicks from the median distance of two, px."""
    return median_px / _MEDIAN_OF_TWO
