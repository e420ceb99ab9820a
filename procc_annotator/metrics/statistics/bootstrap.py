"""Cluster bootstrap and jackknife of ratio metrics.

A figure is a sum over frames divided by another one: the mean JaC is the sum of JaC over the number
of frames with a camera. So a set drawn with replacement needs only how often each cluster was
drawn, times the clusters' sums: all figures of all sources are one product of two matrices, and
nothing is projected or scored again.

Efron and Tibshirani, *An Introduction to the Bootstrap*, Chapman & Hall 1993; whole clusters are
drawn as in Davison and Hinkley, *Bootstrap Methods and their Application*, Cambridge 1997, 3.8.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

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
    """K figures over F frames, each a sum of parts over a sum of wholes.

    Attributes:
        parts, wholes: (F, K); a frame that does not count for a figure has 0 in both.
    """

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

    def of(self, frames: NDArray[np.bool_]) -> RatioMetrics:
        """The same over some of the frames alone; (F,)."""
        chosen = frames[:, None]
        # Not by multiplying: what is undefined in the others would remain.
        return RatioMetrics(
            np.where(chosen, self.parts, 0.0), np.where(chosen, self.denominators, 0.0)
        )

    def by_cluster(self, clusters: IntArray) -> RatioMetrics:
        """The sums of each cluster, (G, K).

        Args:
            clusters: (F,) number of each frame's cluster, from 0 on.
        """
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
        ratios: K figures over F frames.
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
