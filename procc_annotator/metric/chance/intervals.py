"""Intervals of figures: between which values the truth lies, in 95 of 100 sets.

Three ways. ``t``: the figure and its jackknife deviation times Student's quantile for as many
clusters as there effectively are. ``percentile`` and ``bca`` (bias-corrected and accelerated:
Efron, *Better bootstrap confidence intervals*, Journal of the American Statistical Association
1987) read it off the sets drawn. Sets drawn from few clusters vary less than the truth does, so
both look farther out in the tails, as far as Student's quantile lies beyond the normal one
(Hesterberg, *What teachers should know about the bootstrap*, The American Statistician 2015).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from procc_annotator.metric.chance.distributions import (
    normal_ppf,
    normal_cdf,
    student_t_ppf,
)
from procc_annotator.metric.chance.sampling import BootstrapSettings, BootstrapSample
from procc_annotator.metric.polylines import FloatArray

IntervalMethodName = Literal["t", "percentile", "bca"]
INTERVAL_METHODS: tuple[IntervalMethodName, ...] = get_args(IntervalMethodName)


@dataclass(frozen=True, slots=True)
class Interval:
    """Where a figure lies, chance considered.

    Attributes:
        low, high: in the unit of the figure.
        level: the share of sets in which the truth lies within.
        method: how it was found.
    """

    low: float
    high: float
    level: float
    method: IntervalMethodName

    def excludes(self, value: float) -> bool:
        """Whether a value lies outside."""
        return not self.low <= value <= self.high


def confidence_intervals(
    sampled: BootstrapSample, draws: BootstrapSettings, method: IntervalMethodName = "t", *, expanded: bool = True
) -> list[Interval | None]:
    """One interval a figure; None where fewer than two clusters count.

    Args:
        expanded: whether ``percentile`` and ``bca`` look farther out for few clusters; without,
            they are what the textbooks call so.
    """
    deviations = sampled.deviation
    found: list[Interval | None] = []
    for k, value in enumerate(sampled.values):
        if not math.isfinite(value) or not math.isfinite(deviations[k]):
            found.append(None)
            continue
        far = critical_value(float(sampled.effective[k]), draws.level)
        if method == "t":
            half = far * float(deviations[k])
            found.append(Interval(float(value) - half, float(value) + half, draws.level, method))
            continue
        tail = far if expanded else normal_ppf((1 + draws.level) / 2)
        if expanded:  # sets drawn vary as if one cluster less told of it
            count = int(sampled.counted[:, k].sum())
            tail *= math.sqrt(count / (count - 1))
        drawn = sampled.drawn[:, k]
        ascending = np.sort(drawn[np.isfinite(drawn)])
        without = sampled.without[sampled.counted[:, k], k]
        found.append(_interval_from_resamples(float(value), ascending, without, tail, draws.level, method))
    return found


def critical_value(effective: float, level: float) -> float:
    """How many deviations an interval reaches to either side: Student's quantile for as many
    clusters as there effectively are, less one."""
    return student_t_ppf((1 + level) / 2, max(1.0, round(effective - 1, 6)))


def bca_acceleration(without: FloatArray) -> float:
    """How fast a figure's deviation changes with it (Efron 1987).

    Args:
        without: (G,) the figure without each cluster.
    """
    off = without.mean() - without
    squares = float((off * off).sum())
    return float((off**3).sum()) / (6 * squares**1.5) if squares > 0 else 0.0


def _interval_from_resamples(
    value: float,
    ascending: FloatArray,
    without: FloatArray,
    tail: float,
    level: float,
    method: IntervalMethodName,
) -> Interval | None:
    if not len(ascending):
        return None
    ends = (-tail, tail)
    if method == "bca":
        below = np.searchsorted(ascending, value) + np.searchsorted(ascending, value, "right")
        least = 0.5 / len(ascending)  # where all sets lie on one side of the figure
        bias = normal_ppf(min(max(below / (2 * len(ascending)), least), 1 - least))
        faster = bca_acceleration(without[np.isfinite(without)])
        ends = tuple(bias + (bias + z) / (1 - faster * (bias + z)) for z in ends)  # type: ignore[assignment]
    low, high = np.quantile(ascending, [normal_cdf(z) for z in ends])
    return Interval(float(low), float(high), level, method)
