"""Intervals of medians and other quantiles of distances, of frames that come in clusters.

The share of distances below the quantile is a ratio of sums over frames, whose deviation the
jackknife of clusters tells; the distances below which the ends of that share's interval lie are the
ends of the quantile's (Woodruff, Confidence intervals for medians and other position measures,
Journal of the American Statistical Association 1952).
"""

from __future__ import annotations

import numpy as np

from procc_annotator.metric.chance.intervals import Interval, confidence_intervals
from procc_annotator.metric.chance.sampling import BootstrapSettings, RatioMetrics, bootstrap
from procc_annotator.metric.polylines import FloatArray, IntArray


def quantile_confidence_interval(
    values: FloatArray, frames: IntArray, clusters: IntArray, share: float, draws: BootstrapSettings
) -> Interval | None:
    """The interval of a quantile; None without values, or of fewer than two clusters.

    Args:
        values: (n,) e.g. distances in px.
        frames: (n,) number of the frame that each belongs to.
        clusters: (F,) number of each frame's cluster, from 0 on.
        share: of the values that lie below the quantile.
        draws: says the level; nothing is drawn.
    """
    if not len(values):
        return None
    below = values <= np.quantile(values, share)
    count = len(clusters)
    ratios = RatioMetrics(
        np.bincount(frames, below, count)[:, None].astype(np.float64),
        np.bincount(frames, minlength=count)[:, None].astype(np.float64),
    )
    of_share = confidence_intervals(bootstrap(ratios, clusters, None), draws)[0]
    if of_share is None:
        return None
    ends = np.clip((of_share.low, of_share.high), 0.0, 1.0)
    # The share counted is a little off the one asked for where values are few.
    ends = np.clip(ends + share - float(below.mean()), 0.0, 1.0)
    low, high = np.quantile(values, ends)
    return Interval(float(low), float(high), draws.level, of_share.method)
