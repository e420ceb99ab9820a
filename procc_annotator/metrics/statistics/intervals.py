"""Cluster bootstrap of ratio metrics; confidence intervals of metrics, quantiles and curves.

A metric is a sum over frames divided by another one: the mean JaC is the sum of JaC over the number
of frames with a camera. So a resample only needs how often each cluster was drawn, times the
clusters' sums: all metrics of all methods are one product of two matrices.

Efron and Tibshirani, *An Introduction to the Bootstrap*, Chapman & Hall 1993; whole clusters are
drawn as in Davison and Hinkley, *Bootstrap Methods and their Application*, Cambridge 1997, 3.8.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from statistics import NormalDist
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray

_BATCH_ENTRIES = 1 << 20  # entries of a matrix of counts
_CACHED_ENTRIES = 1 << 22  # entries of all matrices that are kept, two bytes each


@dataclass(frozen=True)
class BootstrapSettings:
    """Settings of statistical inference.

    Attributes:
        count: how many sets are drawn, or labels exchanged.
        seed: the same one draws the same sets.
        level: of intervals; what is outside is beyond chance.
    """

    count: int = 10_000
    seed: int = 1
    level: float = 0.95


@dataclass(frozen=True, eq=False)
class RatioMetrics:
    """K figures over F frames, each a sum of parts over a sum of denominators, both (F, K); a frame
    that does not count for a figure has 0 in both."""

    parts: FloatArray
    denominators: FloatArray

    @classmethod
    def mean(cls, values: FloatArray) -> RatioMetrics:
        """The plain mean of (F,) or (F, K) values; NaN does not count."""
        columns = values.reshape(len(values), -1).astype(np.float64)
        there = np.isfinite(columns)
        return cls(np.where(there, columns, 0.0), there.astype(np.float64))

    @classmethod
    def beside(cls, several: Sequence[RatioMetrics]) -> RatioMetrics:
        """The figures of several over the same frames, one after the other."""
        return cls(
            np.hstack([r.parts for r in several]), np.hstack([r.denominators for r in several])
        )

    def value(self, column: int) -> float | None:
        """A figure over all frames; None if no frame counts for it or it is undefined."""
        whole = float(self.denominators[:, column].sum())
        found = float(self.parts[:, column].sum()) / whole if whole else np.nan
        return found if np.isfinite(found) else None

    def of(self, frames: NDArray[np.bool_]) -> RatioMetrics:
        """The same over some of the frames alone; (F,)."""
        chosen = frames[:, None]
        # Not by multiplying: what is undefined in the others would remain.
        return RatioMetrics(
            np.where(chosen, self.parts, 0.0), np.where(chosen, self.denominators, 0.0)
        )

    def by_cluster(self, clusters: IntArray) -> RatioMetrics:
        """The sums of each cluster, (G, K), by the number (F,), from 0 on, of each frame's
        cluster."""
        order = np.argsort(clusters, kind="stable")
        starts = np.flatnonzero(np.diff(clusters[order], prepend=-1))
        if not len(starts):
            return self
        return RatioMetrics(
            np.add.reduceat(self.parts[order], starts),
            np.add.reduceat(self.denominators[order], starts),
        )


@dataclass(frozen=True, eq=False)
class BootstrapSample:
    """K figures of a set and how they vary; G clusters, B sets drawn. NaN where undefined.

    Attributes:
        values: (K,) of the set as it is.
        without: (G, K) of the set without each cluster.
        drawn: (B, K) of the sets drawn.
        counted: (G, K) whether the cluster counts for the figure.
        effective: (K,) as many clusters of equal size vary as much as these do: their sizes'
            squared sum over the sum of their squares (Kish 1965; for degrees of freedom Carter,
            Schnepel and Steigerwald, Review of Economics and Statistics 2017).
    """

    values: FloatArray
    without: FloatArray
    drawn: FloatArray
    counted: NDArray[np.bool_]
    effective: FloatArray

    def at(self, columns: slice | Sequence[int]) -> BootstrapSample:
        """Some of the figures."""
        return BootstrapSample(
            self.values[columns], self.without[:, columns], self.drawn[:, columns],
            self.counted[:, columns], self.effective[columns],
        )  # fmt: skip

    def minus(self, other: BootstrapSample) -> BootstrapSample:
        """The differences of figures of the same sets, column by column."""
        return BootstrapSample(
            self.values - other.values,
            self.without - other.without,
            self.drawn - other.drawn,
            self.counted | other.counted,
            np.minimum(self.effective, other.effective),
        )

    @property
    def deviation(self) -> FloatArray:
        """(K,) the standard deviation of each figure, from leaving out one cluster after the other.

        The jackknife of clusters; with few or unequal ones it is the estimate that errs least
        (Hansen 2022; MacKinnon, Nielsen and Webb, Journal of Econometrics 2023, their CV3). NaN
        where fewer than two clusters count.
        """
        count = self.counted.sum(axis=0)
        off = np.where(self.counted, self.without - self.values, 0.0)
        squares = (off * off).sum(axis=0)
        with np.errstate(divide="ignore", invalid="ignore"):
            found = np.sqrt((count - 1) / count * squares)
        return np.where(count > 1, found, np.nan)


def bootstrap(
    ratios: RatioMetrics, clusters: IntArray, draws: BootstrapSettings | None
) -> BootstrapSample:
    """Draw sets of as many clusters, with replacement.

    Args:
        clusters: (F,) number of each frame's cluster, from 0 on; where every frame is drawn for
            itself, a number for each.
        draws: None to draw nothing: the deviation and an interval ``t`` need no more.
    """
    sums = ratios.by_cluster(clusters)
    parts, denominators = sums.parts.sum(axis=0), sums.denominators.sum(axis=0)
    both = np.hstack((sums.parts, sums.denominators))
    figures = len(parts)
    drawn = np.empty((0, 2 * figures))
    if draws is not None:
        drawn = np.concatenate(
            [counts @ both for counts in resample_counts(len(sums.parts), draws)]
        )
    squares = (sums.denominators**2).sum(axis=0)
    return BootstrapSample(
        _ratio_or_nan(parts, denominators),
        _ratio_or_nan(parts - sums.parts, denominators - sums.denominators),
        _ratio_or_nan(drawn[:, :figures], drawn[:, figures:]),
        sums.denominators > 0,
        _ratio_or_nan(denominators**2, squares),
    )


def resample_counts(clusters: int, draws: BootstrapSettings) -> Iterator[FloatArray]:
    """Return how often each cluster is in each set drawn, (b, G), until all sets are drawn."""
    if clusters * draws.count > _CACHED_ENTRIES or clusters > np.iinfo(np.uint16).max:
        return _resample_counts(clusters, draws)
    return (counts.astype(np.float64) for counts in _cached_resample_counts(clusters, draws))


@lru_cache(maxsize=1)
def _cached_resample_counts(
    clusters: int, draws: BootstrapSettings
) -> tuple[NDArray[np.uint16], ...]:
    """The same of a set of usual size: a command draws the same sets for every source and curve."""
    return tuple(counts.astype(np.uint16) for counts in _resample_counts(clusters, draws))


def _resample_counts(clusters: int, draws: BootstrapSettings) -> Iterator[FloatArray]:
    def drawn(rng: np.random.Generator, rows: int) -> FloatArray:
        chosen = rng.integers(0, clusters, (rows, clusters), dtype=np.uint32)
        counts = np.empty((rows, clusters))
        for row, own in zip(counts, chosen, strict=True):  # faster than all rows at once
            row[:] = np.bincount(own, minlength=clusters)
        return counts

    return random_batches(clusters, draws, drawn)


def random_batches(
    clusters: int, draws: BootstrapSettings, make: Callable[[np.random.Generator, int], FloatArray]
) -> Iterator[FloatArray]:
    """Random matrices of some rows at once, until there are as many as are drawn."""
    rng = np.random.default_rng(draws.seed)
    rows = max(1, _BATCH_ENTRIES // max(clusters, 1))
    for begin in range(0, draws.count, rows):
        yield make(rng, min(rows, draws.count - begin))


def _ratio_or_nan(parts: FloatArray, denominators: FloatArray) -> FloatArray:
    # Sums of floats in another order leave a remainder where nothing is left.
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(denominators > 1e-9, parts / denominators, np.nan)


_STANDARD_NORMAL = NormalDist()
_QUADRATURE_NODES, _QUADRATURE_WEIGHTS = np.polynomial.legendre.leggauss(64)
_BISECTIONS = 60


def normal_ppf(share: float) -> float:
    """The place, in standard deviations, below which a share in (0, 1) of a normal
    distribution lies."""
    return _STANDARD_NORMAL.inv_cdf(share)


def student_t_cdf(t: float, freedom: float) -> float:
    """The share of Student's distribution below ``t``; its degrees of freedom, above 0, need not be
    whole."""
    # With t = sqrt(freedom) tan(angle) the density is a power of the cosine.
    half = math.atan(t / math.sqrt(freedom)) / 2
    constant = math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2))
    powers = np.cos(half * (_QUADRATURE_NODES + 1)) ** (freedom - 1)
    return 0.5 + constant / math.sqrt(math.pi) * half * float(_QUADRATURE_WEIGHTS @ powers)


@lru_cache(maxsize=512)
def student_t_ppf(share: float, freedom: float) -> float:
    """The place below which a share in (0, 1) of Student's distribution lies; at least one degree
    of freedom."""
    if share < 0.5:
        return -student_t_ppf(1 - share, freedom)
    low, high = 0.0, 1.0
    while student_t_cdf(high, freedom) < share:
        low, high = high, 2 * high
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        low, high = (middle, high) if student_t_cdf(middle, freedom) < share else (low, middle)
    return (low + high) / 2


IntervalMethodName = Literal["t", "percentile", "bca"]
INTERVAL_METHODS: tuple[IntervalMethodName, ...] = get_args(IntervalMethodName)


@dataclass(frozen=True, slots=True)
class Interval:
    """Confidence interval of a figure.

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
        """Return whether a value lies outside."""
        return not self.low <= value <= self.high


def confidence_intervals(
    sampled: BootstrapSample,
    draws: BootstrapSettings,
    method: IntervalMethodName = "t",
    *,
    expanded: bool = True,
) -> list[Interval | None]:
    """One interval a figure; None where fewer than two clusters count. ``expanded``: ``percentile``
    and ``bca`` look farther out for few clusters than the textbooks say."""
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
        found.append(
            _interval_from_resamples(float(value), ascending, without, tail, draws.level, method)
        )
    return found


def with_rule_of_three(interval: Interval, clusters: float) -> Interval:
    """The interval of a share, or of a difference of shares, over n clusters of equal size; of one
    that is equal in all clusters, so that its interval has no width, it reaches 3/n to both sides,
    exactly -ln(1 - level)/n (Hanley and Lippman-Hand, Journal of the American Medical Association
    1983)."""
    if interval.high - interval.low > 1e-9 or clusters <= 0:
        return interval
    reach = -math.log(1 - interval.level) / clusters
    return replace(interval, low=interval.low - reach, high=interval.high + reach)


def critical_value(effective: float, level: float) -> float:
    """Return how many deviations an interval reaches to either side: Student's quantile for as many
    clusters as there effectively are, less one."""
    return student_t_ppf((1 + level) / 2, max(1.0, round(effective - 1, 6)))


def bca_acceleration(without: FloatArray) -> float:
    """Return how fast a figure's deviation changes with it, by the figure (G,) without each cluster
    (Efron 1987)."""
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
    low, high = np.quantile(ascending, [_STANDARD_NORMAL.cdf(z) for z in ends])
    return Interval(float(low), float(high), level, method)


@dataclass(frozen=True, eq=False)
class CurveBand:
    """A curve over T thresholds with its band; NaN if absent.

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
        """(T,) 1 where the whole band lies above 0, -1 where it is below, else 0."""
        return np.where(self.low > 0, 1.0, np.where(self.high < 0, -1.0, 0.0))


def curve_band(
    sampled: BootstrapSample, draws: BootstrapSettings, least: float = -np.inf, most: float = np.inf
) -> CurveBand:
    """The band of a curve whose places are the figures sampled, between the least and the most that
    a curve can be.

    The largest deviation among all thresholds, in standard deviations of each, is taken from the
    sets drawn (Montiel Olea and Plagborg-Møller, Journal of Applied Econometrics 2019); few
    clusters widen it as they do an interval. Where no set drawn deviates the band has no width.
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


def quantile_confidence_interval(
    values: FloatArray, frames: IntArray, clusters: IntArray, share: float, draws: BootstrapSettings
) -> Interval | None:
    """The interval of a quantile; None without values, or of fewer than two clusters.

    Args:
        values: (n,) e.g. distances in px.
        frames: (n,) number of the frame that each belongs to.
        clusters: (F,) number of each frame's cluster, from 0 on.
        share: of the values that are below the quantile.
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


# The median distance between two annotators, over the standard deviation of one's clicks across a
# line: the difference of two normal errors is root two times as wide, half of it within 0.6745.
_MEDIAN_OF_DIFFERENCE = 0.6744897501960817 * 2**0.5


@dataclass(frozen=True, eq=False)
class AnnotationNoiseSensitivity:
    """K means over frames that were judged R times with every point moved at random.

    Attributes:
        means: (K,) over frames and repeats. Below the figures themselves, whose clicks were off
            once already.
        deviations: (K,) standard deviation of a mean: what other clicks on these very frames would
            make of it.
        shares: (K,) how much of the variance from set to set comes from clicks, in [0, 1]; NaN
            where it does not vary.
    """

    means: FloatArray
    deviations: FloatArray
    shares: FloatArray


def annotation_noise_sensitivity(
    moved: FloatArray, deviations: FloatArray
) -> AnnotationNoiseSensitivity:
    """Compare what clicks alone change with what sets of other frames change.

    Frames are clicked each for itself, so that the variance of their mean is the sum of theirs over
    the square of their number; that takes far fewer repeats than the means' own variance.

    Args:
        moved: (F, R, K) figures of F frames in R repeats.
        deviations: (K,) of the means from set to set, where both frames and clicks are others.
    """
    frames, repeats, _ = moved.shape
    own = np.full(moved.shape[2], np.nan)
    if frames and repeats > 1:
        own = np.sqrt(moved.var(axis=1, ddof=1).sum(axis=0)) / frames
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = np.where(deviations > 0, np.minimum(1.0, (own / deviations) ** 2), np.nan)
    means = moved.mean(axis=(0, 1)) if frames else np.full(moved.shape[2], np.nan)
    return AnnotationNoiseSensitivity(means, own, shares)


def noise_from_median_distance(median_px: float) -> float:
    """The standard deviation of one annotator's clicks from the median distance of two, px."""
    return median_px / _MEDIAN_OF_DIFFERENCE
