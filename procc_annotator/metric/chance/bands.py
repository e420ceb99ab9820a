"""Bands about a curve: wide enough for the whole of it at once, not only for each place."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.metric.chance.distributions import normal_ppf
from procc_annotator.metric.chance.intervals import critical_value
from procc_annotator.metric.chance.sampling import BootstrapSettings, BootstrapSample
from procc_annotator.metric.polylines import FloatArray


@dataclass(frozen=True, eq=False)
class CurveBand:
    """A curve over T thresholds with its band; NaN where there is none.

    Attributes:
        values: (T,) the curve.
        low, high: (T,) between which the true curve runs everywhere at once, in as many sets as the
            level says.
    """

    values: FloatArray
    low: FloatArray
    high: FloatArray

    @property
    def beyond_chance(self) -> FloatArray:
        """(T,) 1 where the whole band lies above 0, -1 where it lies below, else 0."""
        return np.where(self.low > 0, 1.0, np.where(self.high < 0, -1.0, 0.0))


def curve_band(
    sampled: BootstrapSample, draws: BootstrapSettings, least: float = -np.inf, most: float = np.inf
) -> CurveBand:
    """The band of a curve whose places are the figures sampled.

    The largest deviation among all thresholds, in standard deviations of each, is taken from the
    sets drawn (Montiel Olea and Plagborg-Møller, Journal of Applied Econometrics 2019); few
    clusters widen it as they do an interval. Where no set drawn deviates the band has no width.

    Args:
        least, most: beyond which no curve can be.
    """
    deviation = sampled.deviation
    half = np.where(np.isfinite(deviation), 0.0, np.nan)
    # A set drawn may hold no frame that counts.
    drawn = sampled.drawn[np.isfinite(sampled.drawn[:, np.isfinite(deviation)]).all(axis=1)]
    spread = drawn.std(axis=0) if len(drawn) else np.zeros(len(deviation))
    there = np.isfinite(deviation) & (spread > 0)
    if there.any():
        off = np.abs(drawn[:, there] - sampled.values[there]) / spread[there]
        largest = float(np.quantile(off.max(axis=1), draws.level))
        few = critical_value(float(sampled.effective[there].min()), draws.level)
        few /= normal_ppf((1 + draws.level) / 2)
        half[there] = largest * few * deviation[there]
    low, high = (np.clip(sampled.values + side * half, least, most) for side in (-1, 1))
    return CurveBand(sampled.values, low, high)
