"""Trends: found where there are any, and not where there are none."""

from __future__ import annotations

import numpy as np
import pytest
import scipy

from procc_annotator.metrics.statistics.bootstrap import BootstrapSettings
from procc_annotator.metrics.statistics.significance import trend_test

DRAWS = BootstrapSettings(2000, 1)


def test_slope_and_p_are_those_of_scipy() -> None:
    rng = np.random.default_rng(3)
    for rise in (0.0, 0.05, 0.3):
        values = 2 + rise * np.arange(14) + rng.normal(0, 0.6, 14)
        found = trend_test(values, DRAWS)
        assert found.slope == pytest.approx(scipy.stats.theilslopes(values).slope)
        expected = scipy.stats.kendalltau(np.arange(14), values, method="exact").pvalue
        assert found.p == pytest.approx(expected, abs=0.035)


def test_of_few_values_and_equal_ones_nothing_is_told() -> None:
    assert trend_test(np.array([1.0, 2.0, 3.0]), DRAWS) is None
    assert trend_test(np.ones(8), DRAWS).p == 1.0
