"""Paired differences, their tests, ranks, bands, power, and what the clicks leave open."""

import math
from itertools import product

import numpy as np
import pytest
import scipy

from procc_annotator.metrics.statistics.intervals import (
    BootstrapSettings,
    RatioMetrics,
    annotation_noise_sensitivity,
    bootstrap,
    confidence_intervals,
    curve_band,
    noise_from_median_distance,
)
from procc_annotator.metrics.statistics.significance import (
    corrected_for,
    holm_correction,
    minimum_detectable_difference,
    paired_differences,
    permutation_p_values,
    probability_of_best,
    required_frames,
    significant_ranks,
    significantly_best,
)

DRAWS = BootstrapSettings(10_000, 3)


def compared(a, b, clusters=None, draws=DRAWS):
    clusters = np.arange(len(a)) if clusters is None else clusters
    first, second = RatioMetrics.mean(a), RatioMetrics.mean(b)
    both = (first.denominators > 0).all(axis=1) & (second.denominators > 0).all(axis=1)
    first, second = first.of(both), second.of(both)
    drawn = bootstrap(RatioMetrics.beside([first, second]), clusters, draws)
    columns = first.parts.shape[1]
    pair = drawn.at(slice(0, columns)), drawn.at(slice(columns, None))
    return paired_differences(first, second, pair, clusters, draws)


def test_the_difference_is_that_of_the_frames_both_have():
    rng = np.random.default_rng(1)
    a, b = rng.random(40), rng.random(40)
    a[3] = b[7] = np.nan
    (found,) = compared(a, b)
    shared = np.isfinite(a) & np.isfinite(b)
    expected = scipy.stats.ttest_rel(a[shared], b[shared])
    bounds = expected.confidence_interval(0.95)
    assert found.frames == 38
    assert found.value == pytest.approx((a - b)[shared].mean())
    assert (found.interval.low, found.interval.high) == pytest.approx((bounds.low, bounds.high))
    assert found.p == pytest.approx(expected.pvalue, abs=0.02)


def test_few_exchanges_are_all_tried_as_scipy_does():
    rng = np.random.default_rng(2)
    a, b = rng.random(9), rng.random(9) - 0.3
    expected = scipy.stats.permutation_test(
        (a, b), lambda x, y, axis: x.mean(axis) - y.mean(axis), permutation_type="samples",
        vectorized=True, n_resamples=np.inf,
    ).pvalue  # fmt: skip
    (share,) = permutation_p_values(RatioMetrics.mean(a), RatioMetrics.mean(b), np.arange(9), DRAWS)
    assert share == pytest.approx(expected, abs=1e-12)


def test_an_exchange_takes_whole_clusters_with_it():
    off = np.array([0.3, 0.2, 0.1, -0.1, 0.2, 0.4])
    clusters = np.array([0, 0, 1, 1, 2, 2])
    (share,) = permutation_p_values(
        RatioMetrics.mean(off), RatioMetrics.mean(0 * off), clusters, DRAWS
    )
    sums = np.array([0.5, 0.0, 0.6])
    every = [abs(np.dot(signs, sums)) for signs in product((1, -1), repeat=3)]
    assert share == pytest.approx(np.mean([value >= 1.1 - 1e-9 for value in every]))


def test_of_errors_parts_and_wholes_are_exchanged():
    rng = np.random.default_rng(3)
    counts = rng.integers(1, 30, (2, 8)).astype(float)
    sums = rng.random((2, 8)) * counts
    a, b = (RatioMetrics(s[:, None], c[:, None]) for s, c in zip(sums, counts, strict=True))

    def of(signs) -> float:
        first = np.where(np.array(signs) > 0, 0, 1)
        at = np.arange(8)
        mine = sums[first, at].sum() / counts[first, at].sum()
        return abs(mine - sums[1 - first, at].sum() / counts[1 - first, at].sum())

    least = of([1] * 8)
    expected = np.mean([of(s) >= least - 1e-12 for s in product((1, -1), repeat=8)])
    assert permutation_p_values(a, b, np.arange(8), DRAWS)[0] == pytest.approx(expected)


def test_sources_that_are_alike_are_called_different_in_5_of_100_sets():
    rng = np.random.default_rng(4)
    clusters = np.repeat(np.arange(12), 4)
    wrong = sum(
        compared(rng.random(48), rng.random(48), clusters, BootstrapSettings(499))[0].p < 0.05
        for _ in range(400)
    )
    assert wrong / 400 <= 0.05 + 3 * math.sqrt(0.05 * 0.95 / 400)


def test_holm():
    assert holm_correction([0.01, 0.04, 0.03, 0.005]) == pytest.approx([0.03, 0.06, 0.06, 0.02])
    assert holm_correction([0.9]) == [0.9]
    assert holm_correction([]) == []
    assert holm_correction([0.6, 0.5]) == [1.0, 1.0]


def pairs_of(sources):
    found = {
        (i, j): compared(sources[i], sources[j])[0]
        for i in range(len(sources))
        for j in range(i + 1, len(sources))
    }
    return dict(zip(found, corrected_for(list(found.values())), strict=True))


def test_ranks_are_tied_where_the_data_cannot_tell():
    rng = np.random.default_rng(5)
    base = rng.random(100)
    sources = [base, base + 0.002 * rng.standard_normal(100), base - 0.3]
    pairs = pairs_of(sources)
    assert significant_ranks(3, pairs, +1) == [1, 1, 3]
    assert significant_ranks(3, pairs, -1) == [2, 2, 1]
    assert significantly_best(3, pairs, +1) is None
    assert significantly_best(3, pairs, -1) == 2
    assert significantly_best(1, {}, +1) is None


def test_chances_of_being_best_share_ties_and_sum_to_one():
    drawn = [np.array([1.0, 2.0, 3.0]), np.array([1.0, 1.0, 4.0]), np.array([0.0, 0.0, 0.0])]
    assert probability_of_best(drawn, +1) == pytest.approx([0.5, 0.5, 0.0])
    assert probability_of_best(drawn, -1) == pytest.approx([0.0, 0.0, 1.0])


def test_a_band_holds_the_whole_of_the_true_curve_in_95_of_100_sets():
    rng = np.random.default_rng(6)
    taus = np.linspace(0.5, 10, 40)
    inside = everywhere = 0
    for _ in range(200):
        jacs = (rng.gamma(2.0, 2.0, (60, 9, 1)) < taus).mean(axis=1)
        band = curve_band(
            bootstrap(RatioMetrics.mean(jacs), np.arange(60), BootstrapSettings(400)),
            BootstrapSettings(400),
        )
        truth = scipy.stats.gamma.cdf(taus, 2.0, scale=2.0)
        known = (band.high - band.low > 0) & (truth > 0.03) & (truth < 0.97)
        within = (band.low <= truth) & (truth <= band.high)
        inside += within[known].all()
        everywhere += known.any()
    assert everywhere == 200
    assert 0.9 <= inside / 200 <= 0.99


def test_a_band_says_where_the_difference_is_beyond_chance():
    rng = np.random.default_rng(7)
    off = rng.standard_normal((80, 3)) * 0.1
    off += np.array([0.01, 0.2, -0.2]) - off.mean(axis=0)
    band = curve_band(bootstrap(RatioMetrics.mean(off), np.arange(80), DRAWS), DRAWS)
    assert band.beyond_chance.tolist() == [0.0, 1.0, -1.0]
    single = curve_band(bootstrap(RatioMetrics.mean(off[:, :1]), np.arange(80), DRAWS), DRAWS)
    assert (band.high - band.low)[0] > (single.high - single.low)[0]


@pytest.mark.parametrize("true", [0.05, 0.1])
def test_power_is_what_drawn_sets_of_that_many_frames_show(true):
    rng = np.random.default_rng(8)
    off = rng.standard_normal(60) * 0.2
    deviation = off.std(ddof=1) / math.sqrt(60)
    needed = required_frames(true, deviation, 60, 60.0)
    spread = off.std(ddof=1)
    found = sum(
        scipy.stats.ttest_1samp(true + spread * rng.standard_normal(needed), 0).pvalue < 0.05
        for _ in range(1000)
    )
    assert found / 1000 == pytest.approx(0.8, abs=0.045)


def test_more_frames_are_needed_for_less_and_where_frames_are_alike():
    assert required_frames(0.01, 0.02, 100, 100.0) > required_frames(0.02, 0.02, 100, 100.0)
    assert required_frames(0.02, 0.02, 100, 10.0) > required_frames(0.02, 0.02, 100, 100.0)
    least = minimum_detectable_difference(0.02, 100.0)
    assert required_frames(least, 0.02, 100, 100.0) == 100


def test_the_share_of_clicks_in_the_spread():
    rng = np.random.default_rng(9)
    moved = np.stack((rng.normal(0.5, 0.1, (100, 20)), np.full((100, 20), 0.7)), axis=2)
    found = annotation_noise_sensitivity(moved, np.array([0.02, 0.02]))
    assert found.deviations[0] == pytest.approx(0.01, rel=0.05)
    assert found.shares[0] == pytest.approx(0.25, abs=0.03)
    assert found.shares[1] == pytest.approx(0.0, abs=1e-12)
    assert found.means == pytest.approx([0.5, 0.7], abs=0.005)
    alone = annotation_noise_sensitivity(moved[:, :1], np.array([0.02, 0.02]))
    assert np.isnan(alone.shares).all()


def test_the_noise_of_one_annotator_from_the_floor_of_two():
    rng = np.random.default_rng(10)
    apart = np.abs(rng.normal(0, 1.5, 200_000) - rng.normal(0, 1.5, 200_000))
    assert noise_from_median_distance(float(np.median(apart))) == pytest.approx(1.5, rel=0.01)


def test_a_band_of_a_curve_that_few_frames_have():
    jacs = np.full((12, 3), np.nan)
    jacs[:2] = (0.1, 0.5, 0.9), (0.2, 0.5, 0.8)
    band = curve_band(bootstrap(RatioMetrics.mean(jacs), np.arange(12), DRAWS), DRAWS)
    assert band.values == pytest.approx([0.15, 0.5, 0.85])
    assert (band.low <= band.values).all()
    jacs[1] = np.nan
    band = curve_band(bootstrap(RatioMetrics.mean(jacs), np.arange(12), DRAWS), DRAWS)
    assert np.isnan(band.low).all()


def test_a_coarser_answer_never_needs_more_frames():
    for effective in (40.0, 8.0):
        needed = [
            required_frames(0.001 * 1.3**n, 0.02, 40, effective, power=0.5) for n in range(30)
        ]
        assert needed == sorted(needed, reverse=True)
        assert needed[-1] == 2 * 40 / effective  # no interval rests on fewer than two clusters


@pytest.mark.parametrize("alike", [0.1, 0.4])
def test_power_holds_where_frames_come_in_clusters(alike):
    rng = np.random.default_rng(11)
    each, true, spread = 5, 0.06, 0.2
    between, within = spread * math.sqrt(alike), spread * math.sqrt(1 - alike)
    deviation = math.sqrt(between**2 / 20 + within**2 / (20 * each))
    needed = required_frames(true, deviation, 20 * each, 20.0)
    count = round(needed / each)
    clusters = np.repeat(np.arange(count), each)
    found = 0
    for _ in range(600):
        off = true + between * rng.standard_normal(count)[clusters]
        off += within * rng.standard_normal(len(clusters))
        (around,) = confidence_intervals(bootstrap(RatioMetrics.mean(off), clusters, None), DRAWS)
        found += around.excludes(0.0)
    assert found / 600 == pytest.approx(0.8, abs=0.055)


def test_what_is_undefined_in_other_frames_leaves_the_rest_defined():
    values = RatioMetrics(np.array([[np.nan], [6.0], [8.0]]), np.array([[1.0], [2.0], [2.0]]))
    some = values.of(np.array([False, True, True]))
    assert some.parts.sum() / some.denominators.sum() == 3.5
    assert np.isnan(values.of(np.array([True, True, False])).parts.sum())
