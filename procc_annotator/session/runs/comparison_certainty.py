"""How surely the figures of a comparison are known, and which of two sources is nearer to a third.

The figures are means over frames: of the frames' median distances, of the metrics of earlier
papers; and the share of the compared area that lies within the accuracy of offside technology.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.metric.chance.intervals import Interval, confidence_intervals
from procc_annotator.metric.chance.paired import (
    PairedDifference,
    corrected_for,
    paired_differences,
)
from procc_annotator.metric.chance.quantiles import quantile_confidence_interval
from procc_annotator.metric.chance.sampling import BootstrapSettings, RatioMetrics, bootstrap
from procc_annotator.metric.legacy import LegacyMetrics
from procc_annotator.metric.polylines import FloatArray, IntArray
from procc_annotator.session.runs.clusters import Clusters
from procc_annotator.session.runs.comparison_run import ComparedFrame

METRES, PIXELS, WITHIN = "metres", "pixels", "within"
EARLIER = ("iou_part", "iou_whole", "projection_m", "reprojection", "six_point_rmse_cm")
SHARES = ("iou_part", "iou_whole", WITHIN)  # the only ones of which more is nearer
KEYS = (METRES, PIXELS, *EARLIER, WITHIN)


@dataclass(frozen=True)
class MetricWithInterval:
    """A figure of a comparison over a set.

    Attributes:
        value: None where no frame has it; interval: None of fewer than two clusters.
        frames: that it rests on.
    """

    value: float | None
    interval: Interval | None
    frames: int


def metrics_with_intervals(
    frames: Sequence[ComparedFrame], clusters: Clusters, draws: BootstrapSettings
) -> dict[str, MetricWithInterval]:
    """Each of `KEYS`, with its interval.

    Args:
        frames: F of them. clusters: of these. draws: says the level.
    """
    ratios = _ratios(frames)
    sampled = bootstrap(ratios, clusters.numbers, None)
    ends = confidence_intervals(sampled, draws)
    counted = (ratios.denominators > 0).sum(axis=0)
    return {
        key: MetricWithInterval(_with_interval(sampled.values[k]), _possible(key, ends[k]), int(counted[k]))
        for k, key in enumerate(KEYS)
    }


def medians_with_intervals(
    frames: Sequence[ComparedFrame], clusters: Clusters, draws: BootstrapSettings
) -> dict[str, MetricWithInterval]:
    """The median over frames of the frames' medians: of `METRES` and of `PIXELS`."""
    found = {}
    for key, values in zip((METRES, PIXELS), _medians(frames).T, strict=True):
        there: IntArray = np.flatnonzero(np.isfinite(values))
        median = float(np.median(values[there])) if len(there) else None
        interval = quantile_confidence_interval(values[there], there, clusters.numbers, 0.5, draws)
        found[key] = MetricWithInterval(median, interval, len(there))
    return found


def closer_source(
    a: Sequence[ComparedFrame], b: Sequence[ComparedFrame], clusters: Clusters, draws: BootstrapSettings
) -> dict[str, PairedDifference]:
    """Each of `KEYS` of one comparison less that of another, corrected for as many figures.

    Args:
        a, b: two comparisons with one source in common, of the same F frames in the same order.
        clusters: of the frames. draws: of the permutation test; says the level.
    """
    sides = [_ratios(a), _ratios(b)]
    both = (sides[0].denominators > 0) & (sides[1].denominators > 0)
    first, second = (
        RatioMetrics(np.where(both, one.parts, 0.0), np.where(both, one.denominators, 0.0)) for one in sides
    )
    together = bootstrap(RatioMetrics.beside([first, second]), clusters.numbers, None)
    count = len(KEYS)
    pair = together.at(slice(0, count)), together.at(slice(count, None))
    found = paired_differences(first, second, pair, clusters.numbers, draws)
    return dict(zip(KEYS, corrected_for(found), strict=True))


def _possible(key: str, interval: Interval | None) -> Interval | None:
    """No distance lies below 0, and no share above 1."""
    if interval is None:
        return None
    high = min(1.0, interval.high) if key in SHARES else interval.high
    return replace(interval, low=max(0.0, interval.low), high=high)


def _ratios(frames: Sequence[ComparedFrame]) -> RatioMetrics:
    """(F, K) parts and wholes of `KEYS`."""
    means = np.column_stack((_medians(frames), _earlier([frame.legacy for frame in frames])))
    shares = np.array([[frame.compared_share] for frame in frames]).reshape(-1, 1)
    within = np.array([[frame.within or 0.0] for frame in frames]).reshape(-1, 1)
    return RatioMetrics.beside([RatioMetrics.mean(means), RatioMetrics(shares * within, shares)])


def _medians(frames: Sequence[ComparedFrame]) -> FloatArray:
    """(F, 2) medians in metres and px, NaN where there are none."""
    rows = [
        (np.nan, np.nan)
        if frame.statistics is None
        else (_number(frame.statistics.metres.median), _number(frame.statistics.pixels.median))
        for frame in frames
    ]
    return np.array(rows, dtype=np.float64).reshape(-1, 2)


def _earlier(frames: Sequence[LegacyMetrics | None]) -> FloatArray:
    rows = [[_number(getattr(frame, key, None)) for key in EARLIER] for frame in frames]
    return np.array(rows, dtype=np.float64).reshape(-1, len(EARLIER))


def _number(value: float | None) -> float:
    return np.nan if value is None else value


def _with_interval(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
