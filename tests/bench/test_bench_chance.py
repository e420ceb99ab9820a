"""What chance costs: 10,000 sets drawn of 1,454 frames, three sources, four thresholds, in 1 s of
the processor.

``pytest tests/bench/test_bench_chance.py --benchmark-only -s``
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np
import pytest

from procc_annotator.batch.audit import TAU_GRID
from procc_annotator.batch.frame_sums import FrameSums, SourceSums
from procc_annotator.batch.grouping import clusters_of
from procc_annotator.batch.inference import Inference
from procc_annotator.metrics.statistics.intervals import (
    INTERVAL_METHODS,
    BootstrapSettings,
    IntervalMethodName,
)

TAUS = (2.0, 5.0, 10.0, 20.0)
FRAMES, SOURCES = 1454, 3
DRAWS = BootstrapSettings(10_000, 1)
MOST_SECONDS = 1.0


@pytest.fixture(scope="module")
def sources() -> tuple[SourceSums, ...]:
    rng = np.random.default_rng(1)
    found = []
    for place in range(SOURCES):
        jacs = np.clip(rng.beta(4, 2 + place, (FRAMES, len(TAUS))), 0, 1)
        errors = rng.gamma(2, 1 + place, FRAMES)
        frames = []
        for n in range(FRAMES):
            row = np.column_stack(
                (jacs[n], jacs[n], jacs[n], np.full(4, 30 * errors[n]), np.full(4, 30.0))
            )
            curve = np.full(len(TAU_GRID), jacs[n, 1], dtype=np.float32)
            frames.append(FrameSums(f"{n:04d}", row, curve, 8))
        found.append(SourceSums(f"source {place}", TAUS, tuple(frames)))
    return tuple(found)


@pytest.mark.benchmark(timer=time.process_time)
@pytest.mark.parametrize("cluster", ["match", "none"])
@pytest.mark.parametrize("method", INTERVAL_METHODS)
def test_intervals_of_every_source(
    benchmark: Any, sources: tuple[SourceSums, ...], method: IntervalMethodName, cluster: str
) -> None:
    names = sources[0].names
    matches = {name: str(n // 30) for n, name in enumerate(names)}
    clusters = clusters_of(names, cluster, matches)

    def run() -> int:
        return len(Inference(sources, clusters, DRAWS, method).intervals)

    assert benchmark.pedantic(run, rounds=3, warmup_rounds=1) == SOURCES
    assert benchmark.stats["min"] <= MOST_SECONDS


@pytest.mark.benchmark(timer=time.process_time)
@pytest.mark.parametrize("cluster", ["match", "none"])
def test_differences_with_their_permutation_tests(
    benchmark: Any, sources: tuple[SourceSums, ...], cluster: str
) -> None:
    names = sources[0].names
    matches = {name: str(n // 30) for n, name in enumerate(names)}
    clusters = clusters_of(names, cluster, matches)

    def run() -> int:
        return len(Inference(sources, clusters, DRAWS).pairs)

    assert benchmark.pedantic(run, rounds=3, warmup_rounds=1) == 3
    assert benchmark.stats["min"] <= 2 * MOST_SECONDS  # three tests of 10,000 exchanges each
