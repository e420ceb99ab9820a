"""Intervals against scipy and textbooks, and how often they hold the truth of drawn sets."""

import math
from collections.abc import Callable

import numpy as np
import pytest
import scipy

from procc_annotator.metrics.statistics.intervals import (
    INTERVAL_METHODS,
    BootstrapSettings,
    RatioMetrics,
    bca_acceleration,
    bootstrap,
    confidence_intervals,
    critical_value,
    quantile_confidence_interval,
    student_t_cdf,
    student_t_ppf,
)

DRAWS = BootstrapSettings(10_000, 3)


@pytest.mark.parametrize("freedom", [1, 1.7, 2, 5, 10.8, 100, 1453])
def test_students_distribution_is_that_of_scipy(freedom):
    for share in (0.025, 0.5, 0.8, 0.975, 0.9995):
        expected = scipy.stats.t.ppf(share, freedom)
        assert student_t_ppf(share, freedom) == pytest.approx(expected, rel=1e-8, abs=1e-12)
        assert student_t_cdf(expected, freedom) == pytest.approx(share, abs=1e-10)


@pytest.mark.parametrize(("method", "theirs"), [("percentile", "percentile"), ("bca", "BCa")])
@pytest.mark.parametrize("size", [20, 186])
def test_unexpanded_intervals_are_those_of_scipy(method, theirs, size):
    jacs = skewed(np.random.default_rng(size).random(size))
    expected = scipy.stats.bootstrap(
        (jacs,), np.mean, n_resamples=20_000, method=theirs, rng=np.random.default_rng(1)
    ).confidence_interval
    sampled = bootstrap(RatioMetrics.mean(jacs), np.arange(size), BootstrapSettings(20_000, 3))
    (found,) = confidence_intervals(sampled, DRAWS, method, expanded=False)
    # Two times 20,000 draws differ by as much, or by one element of one frame.
    close = 0.03 * (expected.high - expected.low) + 1 / (9 * size)
    assert (found.low, found.high) == pytest.approx((expected.low, expected.high), abs=close)


def test_bca_of_the_same_draws_is_that_of_scipy_to_the_last_digit():
    jacs = skewed(np.random.default_rng(5).random(40))
    theirs = scipy.stats.bootstrap(
        (jacs,), np.mean, n_resamples=999, method="BCa", rng=np.random.default_rng(1)
    )
    sampled = bootstrap(RatioMetrics.mean(jacs), np.arange(40), BootstrapSettings(10, 3))
    same = type(sampled)(
        sampled.values,
        sampled.without,
        theirs.bootstrap_distribution[:, None],
        sampled.counted,
        sampled.effective,
    )
    (found,) = confidence_intervals(same, BootstrapSettings(999), "bca", expanded=False)
    expected = theirs.confidence_interval
    assert (found.low, found.high) == pytest.approx((expected.low, expected.high), abs=1e-9)


def test_the_t_interval_of_frames_alone_is_students():
    jacs = skewed(np.random.default_rng(2).random(30))
    expected = scipy.stats.ttest_1samp(jacs, 0).confidence_interval(0.95)
    (found,) = confidence_intervals(bootstrap(RatioMetrics.mean(jacs), np.arange(30), DRAWS), DRAWS)
    assert (found.low, found.high) == pytest.approx((expected.low, expected.high), rel=1e-9)


def test_acceleration_is_a_sixth_of_the_skewness_over_the_root_of_the_count():
    values = np.random.default_rng(1).exponential(size=50)
    without = (values.sum() - values) / 49
    assert bca_acceleration(without) == pytest.approx(scipy.stats.skew(values) / 6 / math.sqrt(50))
    assert bca_acceleration(np.ones(5)) == 0.0


def test_a_ratio_of_sums_is_the_same_however_its_frames_are_ordered_or_drawn_again():
    rng = np.random.default_rng(4)
    ratios = RatioMetrics(rng.random((30, 2)), rng.integers(1, 9, (30, 2)).astype(float))
    clusters = rng.integers(0, 7, 30)
    found = bootstrap(ratios, clusters, DRAWS)
    order = rng.permutation(30)
    again = bootstrap(
        RatioMetrics(ratios.parts[order], ratios.denominators[order]), clusters[order], DRAWS
    )
    assert found.values == pytest.approx(ratios.parts.sum(axis=0) / ratios.denominators.sum(axis=0))
    assert again.drawn == pytest.approx(found.drawn)
    assert again.deviation == pytest.approx(found.deviation)
    same = bootstrap(ratios, clusters, DRAWS)
    assert np.array_equal(same.drawn, found.drawn)
    other = bootstrap(ratios, clusters, BootstrapSettings(10_000, 4))
    assert not np.array_equal(other.drawn, found.drawn)


def test_what_cannot_vary_has_no_interval_and_one_cluster_none_either():
    alone = bootstrap(RatioMetrics.mean(np.array([0.2, 0.4])), np.array([0, 0]), DRAWS)
    assert [confidence_intervals(alone, DRAWS, method) for method in INTERVAL_METHODS] == [
        [None]
    ] * 3
    never = bootstrap(RatioMetrics.mean(np.array([np.nan, np.nan])), np.array([0, 1]), DRAWS)
    assert confidence_intervals(never, DRAWS) == [None]
    still = bootstrap(RatioMetrics.mean(np.ones(9)), np.arange(9), DRAWS)
    for method in INTERVAL_METHODS:
        (found,) = confidence_intervals(still, DRAWS, method)
        assert (found.low, found.high) == (1.0, 1.0)


def test_a_cluster_without_a_frame_that_counts_is_none():
    jacs = np.array([0.1, 0.5, 0.4, np.nan, np.nan])
    found = bootstrap(RatioMetrics.mean(jacs), np.arange(5), DRAWS)
    alone = bootstrap(RatioMetrics.mean(jacs[:3]), np.arange(3), DRAWS)
    assert found.deviation == pytest.approx(alone.deviation)
    assert found.effective == pytest.approx(alone.effective)


# ------------------------------------------------------------- how often the truth lies within


def skewed(shares: np.ndarray) -> np.ndarray:
    """JaC of nine elements, most of which pass."""
    return np.round(9 * scipy.stats.beta.ppf(shares, 4, 1)) / 9


def low(shares: np.ndarray) -> np.ndarray:
    return np.round(9 * scipy.stats.beta.ppf(shares, 1, 2)) / 9


def difference(shares: np.ndarray) -> np.ndarray:
    """Of two methods: most frames alike, some far off."""
    return np.round(1.5 * scipy.stats.t.ppf(shares, 4)) / 9


EQUAL = {f"{n}x{each}": (each,) * n for n, each in ((20, 1), (200, 1), (5, 4), (10, 10), (20, 10))}
UNEQUAL = {"20 of 1-20": (1, 2, 3, 4, 5, 10, 15, 20) * 2 + (5,) * 4, "5 of 2-20": (2, 4, 8, 16, 20)}
KINDS = {"skewed": skewed, "low": low, "difference": difference}
ALL = [
    (kind, sizes, alike)
    for kind in KINDS
    for sizes in (EQUAL | UNEQUAL)
    for alike in ((0.0,) if set((EQUAL | UNEQUAL)[sizes]) == {1} else (0.1, 0.5))
]
TASTE = [("skewed", "20x1", 0.0), ("difference", "5x4", 0.5)]


def held(
    make: Callable[[np.ndarray], np.ndarray], sizes: tuple[int, ...], alike: float, sets: int
) -> dict[str, float]:
    """The share of drawn sets whose interval holds the truth, by method.

    Args:
        alike: the correlation of frames of one cluster, before they are made figures of.
    """
    rng = np.random.default_rng(sum(sizes))
    clusters = np.repeat(np.arange(len(sizes)), sizes)
    truth = float(make((np.arange(200_000) + 0.5) / 200_000).mean())
    methods = INTERVAL_METHODS if sets > 500 else ("t",)
    draws = BootstrapSettings(1000 if sets > 500 else 2)
    count = dict.fromkeys(methods, 0)
    for _ in range(sets):
        common = rng.standard_normal(len(sizes))[clusters]
        own = rng.standard_normal(len(clusters))
        values = make(scipy.special.ndtr(math.sqrt(alike) * common + math.sqrt(1 - alike) * own))
        sampled = bootstrap(RatioMetrics.mean(values), clusters, draws)
        for method in methods:
            (found,) = confidence_intervals(sampled, draws, method)
            count[method] += not found.excludes(truth)
    return {method: n / sets for method, n in count.items()}


@pytest.mark.parametrize(("kind", "sizes", "alike"), TASTE)
def test_95_of_100_intervals_hold_the_truth(kind, sizes, alike):
    share = held(KINDS[kind], (EQUAL | UNEQUAL)[sizes], alike, 300)["t"]
    assert 0.91 <= share <= 0.99  # three standard deviations of 300 sets


@pytest.mark.soak
@pytest.mark.parametrize(("kind", "sizes", "alike"), ALL)
def test_95_of_100_intervals_hold_the_truth_of_1000_sets(kind, sizes, alike, capsys):
    shares = held(KINDS[kind], (EQUAL | UNEQUAL)[sizes], alike, 1000)
    with capsys.disabled():
        told = ", ".join(f"{method} {100 * share:.1f} %" for method, share in shares.items())
        print(f"\n{kind}, clusters {sizes}, alike {alike:g}: {told}")
    # 93 to 97 %, and what 1,000 sets are unsure about.
    assert 0.92 <= shares["t"] <= 0.98


def test_few_clusters_reach_farther():
    assert critical_value(1e6, 0.95) == pytest.approx(1.95996, abs=1e-4)
    assert critical_value(5, 0.95) == pytest.approx(2.7764, abs=1e-4)
    assert critical_value(1.2, 0.95) == pytest.approx(12.7062, abs=1e-3)


# Intervals of medians: as often right as they say, wider where frames are alike.

USUAL = BootstrapSettings()


def drawn(rng, clusters: int, frames: int, alike: float):
    """Distances of 20 clicks a frame; a cluster's share of their logarithm's variance."""
    of_cluster = np.repeat(np.arange(clusters), frames)
    level = rng.normal(0, alike**0.5, clusters)[of_cluster]
    own = rng.normal(0, (1 - alike) ** 0.5, (clusters * frames, 20))
    values = np.exp(level[:, None] + own).ravel()
    return values, np.repeat(np.arange(clusters * frames), 20), of_cluster


@pytest.mark.parametrize(("share", "z"), [(0.5, 0.0), (0.95, 1.6448536)])
@pytest.mark.parametrize("alike", [0.0, 0.2])
def test_it_holds_the_truth_in_95_of_100_sets(share, z, alike):
    rng = np.random.default_rng(4)
    held = 0
    for _ in range(400):
        values, frames, clusters = drawn(rng, 15, 4, alike)
        found = quantile_confidence_interval(values, frames, clusters, share, USUAL)
        held += found.low <= np.exp(z) <= found.high
    assert 0.92 <= held / 400 <= 0.985


def test_frames_that_are_alike_make_it_wider():
    values, frames, clusters = drawn(np.random.default_rng(5), 15, 8, 0.5)
    together = quantile_confidence_interval(values, frames, clusters, 0.5, USUAL)
    apart = quantile_confidence_interval(values, frames, np.arange(len(clusters)), 0.5, USUAL)
    assert together.high - together.low > 1.5 * (apart.high - apart.low)


def test_nothing_and_one_cluster_have_none():
    nothing = np.empty(0)
    assert (
        quantile_confidence_interval(nothing, nothing.astype(int), np.zeros(3, int), 0.5, USUAL)
        is None
    )
    one = quantile_confidence_interval(np.ones(4), np.arange(4), np.zeros(4, int), 0.5, USUAL)
    assert one is None
