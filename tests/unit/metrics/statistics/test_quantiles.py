"""Intervals of medians: as often right as they say, wider where frames are alike."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.metrics.statistics.intervals import (
    BootstrapSettings,
    quantile_confidence_interval,
)

DRAWS = BootstrapSettings()


def drawn(rng, clusters: int, frames: int, alike: float):
    """Distances of 20 clicks a frame; a cluster's share of their logarithm's variance."""
    of_cluster = np.repeat(np.arange(clusters), frames)
    level = rng.normal(0, alike**0.5, clusters)[of_cluster]
    own = rng.normal(0, (1 - alike) ** 0.5, (clusters * frames, 20))
    values = np.exp(level[:, None] + own).ravel()
    return values, np.repeat(np.arange(clusters * frames), 20), of_cluster


@pytest.mark.parametrize(("share", "z"), [(0.5, 0.0), (0.95, 1.6448536)])
@pytest.mark.parametrize("alike", [0.0, 0.2])
def test_it_holds_the_truth_in_95_of_100_sets(share, z, alike) -> None:
    rng = np.random.default_rng(4)
    held = 0
    for _ in range(400):
        values, frames, clusters = drawn(rng, 15, 4, alike)
        found = quantile_confidence_interval(values, frames, clusters, share, DRAWS)
        held += found.low <= np.exp(z) <= found.high
    assert 0.92 <= held / 400 <= 0.985


def test_frames_that_are_alike_make_it_wider() -> None:
    values, frames, clusters = drawn(np.random.default_rng(5), 15, 8, 0.5)
    together = quantile_confidence_interval(values, frames, clusters, 0.5, DRAWS)
    apart = quantile_confidence_interval(values, frames, np.arange(len(clusters)), 0.5, DRAWS)
    assert together.high - together.low > 1.5 * (apart.high - apart.low)


def test_nothing_and_one_cluster_have_none() -> None:
    nothing = np.empty(0)
    assert (
        quantile_confidence_interval(nothing, nothing.astype(int), np.zeros(3, int), 0.5, DRAWS)
        is None
    )
    one = quantile_confidence_interval(np.ones(4), np.arange(4), np.zeros(4, int), 0.5, DRAWS)
    assert one is None
