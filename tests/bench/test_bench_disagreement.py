"""What a disagreement map costs: run with ``pytest tests/bench --benchmark-only``."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.metrics.error_maps import (
    DISAGREEMENT_LEVELS_M,
    OFFSIDE_ACCURACY_M,
    contour_lines,
    disagreement,
    filled_contours,
)

FIELD = load_field("soccer")
SIZE = (1280, 720)
LIMIT_S = 0.050
MAIN = PinholeCamera(
    math.radians(-12.0),
    math.radians(78.0),
    0.0,
    (0.0, 58.0, -16.0),
    (1500.0, 1500.0),
    (639.5, 359.5),
)
DISTORTED = replace(MAIN, radial=(-0.08, 0.02, 0.0, 0.0, 0.0, 0.0))


def held(benchmark: Any) -> None:
    if benchmark.enabled:
        median = benchmark.stats.stats.median
        print(f"\n{benchmark.name}: {1e3 * median:.1f} ms (median)")
        assert median <= LIMIT_S


@pytest.mark.parametrize("first", [MAIN, DISTORTED], ids=["plain", "distorted"])
def test_map_of_two_pinholes(benchmark: Any, first: PinholeCamera) -> None:
    second = replace(first, pan_rad=first.pan_rad + 0.003, tilt_rad=first.tilt_rad - 0.001)
    found = benchmark(disagreement, first, second, FIELD, SIZE)
    assert found.statistics.metres.median is not None
    held(benchmark)


def test_contours_of_a_map(benchmark: Any) -> None:
    found = disagreement(MAIN, replace(MAIN, pan_rad=MAIN.pan_rad + 0.003), FIELD, SIZE)
    x, y = found.ground_a[..., 0], found.ground_a[..., 1]

    def run() -> None:
        for places in ((found.xs_px, found.ys_px), (x, y)):
            assert filled_contours(found.metres, *places, DISAGREEMENT_LEVELS_M)
            contour_lines(found.metres, *places, OFFSIDE_ACCURACY_M)

    benchmark(run)
    held(benchmark)
