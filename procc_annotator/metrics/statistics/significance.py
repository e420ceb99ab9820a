"""Paired permutation tests with Holm correction, ranking, power and trend."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.metrics.statistics.intervals import (
    BootstrapSample,
    BootstrapSettings,
    Interval,
    IntervalMethodName,
    RatioMetrics,
    confidence_intervals,
    critical_value,
    random_batches,
    student_t_ppf,
)

_TIE_TOLERANCE = 1e-9  # of a difference: sums of floats in another order


@dataclass(frozen=True, slots=True)
class PairedDifference:
    """The figure of one source less that of another, on the frames both have.

    Attributes:
        value: the difference, in the unit of the figure; None if absent.
        interval: of it; None with fewer than two clusters.
        deviation: its standard deviation; None where there is no interval.
        p: the share of exchanges of the two sources that differ as much (permutation test).
        corrected: the same for as many comparisons as were corrected together (Holm); None where
            none were, and `p` decides.
        frames, clusters: how many it rests on; effective: as many clusters of equal size.
    """

    value: float | None
    interval: Interval | None
    deviation: float | None
    p: float | None
    corrected: float | None
    frames: int
    clusters: int
    effective: float

    @property
    def beyond_chance(self) -> bool:
        """Return whether interval and test, corrected if it was, agree that the two differ."""
        p = self.p if self.corrected is None else self.corrected
        return (
            self.interval is not None
            and p is not None
            and self.interval.excludes(0.0)
            and p < 1 - self.interval.level
        )


def paired_differences(
    a: RatioMetrics,
    b: RatioMetrics,
    sampled: tuple[BootstrapSample, BootstrapSample],
    clusters: IntArray,
    draws: BootstrapSettings,
    method: IntervalMethodName = "t",
) -> list[PairedDifference]:
    """One difference a figure, not yet corrected for several comparisons.

    Args:
        a, b: K figures of both sources; frames that only one has must count for neither.
        sampled: the same, drawn together.
        clusters: (F,) as for `sample`.
    """
    off = sampled[0].minus(sampled[1])
    deviations, ends = off.deviation, confidence_intervals(off, draws, method)
    shares = permutation_p_values(a, b, clusters, draws)
    frames = ((a.denominators > 0) & (b.denominators > 0)).sum(axis=0)
    found = []
    for k, value in enumerate(off.values):
        known = math.isfinite(value)
        share = float(shares[k]) if known and ends[k] is not None else None
        found.append(
            PairedDifference(
                float(value) if known else None,
                ends[k],
                float(deviations[k]) if ends[k] is not None else None,
                share,
                share,
                int(frames[k]),
                int(off.counted[:, k].sum()),
                float(off.effective[k]) if known else 0.0,
            )
        )
    return found


def min_clusters_for_significance(level: float) -> int:
    """Return how many it takes before any exchange of the sources is as rare as a difference must
    be: one and its opposite always differ as much."""
    return math.floor(1 - math.log2(1 - level)) + 1


def corrected_for(several: Sequence[PairedDifference]) -> list[PairedDifference]:
    """The same differences with ``corrected``, and with that ``beyond_chance``, for as many
    comparisons as are tested of these (Holm).

    Args:
        several: of one figure at one threshold, one a pair of methods.

    Returns:
        In the same order; those without a test unchanged.

    Raises:
        AttributeError: one is no difference.
    """
    shares = iter(holm_correction([one.p for one in several if one.p is not None]))
    return [one if one.p is None else replace(one, corrected=next(shares)) for one in several]


def holm_correction(shares: Sequence[float]) -> list[float]:
    """Corrected shares of several tests (Holm, Scandinavian Journal of Statistics 1979).

    Each is what the whole family errs at most in, were this one called a difference with all that
    are smaller.
    """
    order = sorted(range(len(shares)), key=shares.__getitem__)
    corrected = [0.0] * len(shares)
    least = 0.0
    for place, i in enumerate(order):
        least = max(least, min(1.0, (len(shares) - place) * shares[i]))
        corrected[i] = least
    return corrected


def permutation_p_values(
    a: RatioMetrics, b: RatioMetrics, clusters: IntArray, draws: BootstrapSettings
) -> FloatArray:
    """(K,) the share of exchanges of the sources that differ at least as much as they do.

    If the two were alike, each cluster's frames could as well be the other source's. All exchanges
    are tried where they are no more than the draws, else as many at random, the one at hand among
    them (Phipson and Smyth 2010). Either way no share is 0, and of few clusters none is small: five
    have 32 exchanges.
    """
    of_a, of_b = a.by_cluster(clusters), b.by_cluster(clusters)
    counted = ((of_a.denominators > 0) | (of_b.denominators > 0)).any(axis=1)
    sums_a = np.hstack((of_a.parts, of_a.denominators))[counted]
    sums_b = np.hstack((of_b.parts, of_b.denominators))[counted]
    middle, half = (sums_a + sums_b).sum(axis=0) / 2, (sums_a - sums_b) / 2
    figures = a.parts.shape[1]

    def differences(moved: FloatArray) -> FloatArray:
        first, second = middle + moved, middle - moved
        with np.errstate(divide="ignore", invalid="ignore"):
            mine = first[..., :figures] / first[..., figures:]
            other = second[..., :figures] / second[..., figures:]
        return np.asarray(np.abs(mine - other), dtype=np.float64)

    least = differences(half.sum(axis=0)) * (1 - _TIE_TOLERANCE)
    reached = np.zeros(figures)
    tried = 0
    exact = len(half) <= math.log2(draws.count)
    for signs in _all_sign_flips(len(half)) if exact else _random_sign_flips(len(half), draws):
        found = differences(signs @ half)
        # Where an exchange leaves one source nothing, it reports no difference and of none less.
        reached += (~(found < least)).sum(axis=0)
        tried += len(signs)
    shares = reached / tried if exact else (1 + reached) / (1 + tried)
    return np.asarray(shares, dtype=np.float64)


def _all_sign_flips(clusters: int) -> Iterator[FloatArray]:
    yield np.array(list(product((1.0, -1.0), repeat=clusters))).reshape(-1, clusters)


def _random_sign_flips(clusters: int, draws: BootstrapSettings) -> Iterator[FloatArray]:
    def drawn(rng: np.random.Generator, rows: int) -> FloatArray:
        octets = rng.integers(0, 256, (rows, -(-clusters // 8)), dtype=np.uint8)
        return np.where(np.unpackbits(octets, axis=1)[:, :clusters], 1.0, -1.0)

    return random_batches(clusters, draws, drawn)


def significant_ranks(
    count: int, differences: Mapping[tuple[int, int], PairedDifference], better: int
) -> list[int]:
    """The place of each source: one more than those that are significantly better, by the
    differences (a, b) -> a − b. ``better``: +1 where more is better, -1 where less is."""
    beaten = [0] * count
    for (a, b), found in differences.items():
        if found.beyond_chance and found.value is not None:
            beaten[b if found.value * better > 0 else a] += 1
    return [1 + n for n in beaten]


def significantly_best(
    count: int, differences: Mapping[tuple[int, int], PairedDifference], better: int
) -> int | None:
    """The source that is better than every other beyond chance; None if absent."""
    for one in range(count):
        against = [
            (found, better if a == one else -better)
            for (a, b), found in differences.items()
            if one in (a, b)
        ]
        if len(against) == count - 1 > 0 and all(
            found.beyond_chance and found.value is not None and found.value * sign > 0
            for found, sign in against
        ):
            return one
    return None


def probability_of_best(drawn: Sequence[FloatArray], better: int) -> list[float]:
    """In which share of the sets drawn each source, with its figures (B,) in these, on the same
    frames, is the best; ties are shared out. ``better`` as for `significant_ranks`."""
    if not drawn:
        return []
    figures = better * np.stack(drawn, axis=1)
    known = figures[np.isfinite(figures).all(axis=1)]
    if not len(known):
        return [0.0] * len(drawn)
    best = known == known.max(axis=1, keepdims=True)
    return [float(share) for share in (best / best.sum(axis=1, keepdims=True)).mean(axis=0)]


_MIN_CLUSTERS = 2.0


def required_frames(
    difference: float,
    deviation: float,
    frames: int,
    effective: float,
    *,
    level: float = 0.95,
    power: float = 0.8,
    fewest: int = 1,
) -> int:
    """The frames of a set like this one in which a true difference is found beyond chance.

    The deviation of a mean falls with the root of the frames, however alike frames of one cluster
    are, as long as more frames come in clusters like those at hand.

    Args:
        difference: the true one, above 0, in the unit of the figure.
        deviation: of the difference on the frames at hand, in the same unit.
        frames, effective: those at hand, and how many clusters they effectively come in.
        level: of the interval that is to exclude 0.
        power: in which share of such sets it is to.
        fewest: frames below which nothing is found for another reason.
    """

    def suffice(count: int) -> bool:
        clusters = max(_MIN_CLUSTERS, effective * count / frames)
        reached = (
            deviation * math.sqrt(frames / count) * _detection_multiplier(clusters, level, power)
        )
        return reached <= difference * (1 + 1e-9)

    fewest = max(fewest, math.ceil(_MIN_CLUSTERS * frames / effective))
    if suffice(fewest):
        return fewest
    # More frames never reach farther: the bounds are doubled, then halved.
    most = fewest
    while not suffice(most):
        fewest, most = most, 2 * most
    while most - fewest > 1:
        middle = (fewest + most) // 2
        fewest, most = (fewest, middle) if suffice(middle) else (middle, most)
    return most


def minimum_detectable_difference(
    deviation: float, effective: float, *, level: float = 0.95, power: float = 0.8
) -> float:
    """The true difference that these very frames would find in such a share of sets."""
    return deviation * _detection_multiplier(max(_MIN_CLUSTERS, effective), level, power)


def _detection_multiplier(clusters: float, level: float, power: float) -> float:
    freedom = max(1.0, round(clusters - 1, 6))
    return critical_value(clusters, level) + student_t_ppf(power, freedom)
