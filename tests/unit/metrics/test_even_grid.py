"""Values between the samples of a map."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.metrics.error_maps import bilinear_value

XS, YS = np.array([0.0, 2.0, 4.0]), np.array([-1.0, 0.0])
VALUES = np.array([[0.0, 1.0, np.nan], [4.0, 5.0, 6.0]])


@pytest.mark.parametrize(
    ("x", "y", "expected"),
    [
        (0.0, -1.0, 0.0),
        (2.0, 0.0, 5.0),
        (4.0, 0.0, 6.0),  # its neighbour above has no say
        (1.0, -0.5, 2.5),
        (3.0, 0.0, 5.5),
        (3.0, -0.5, None),
        (4.1, 0.0, None),
        (1.0, -1.1, None),
        (np.nan, 0.0, None),
    ],
)
def test_in_proportion_to_the_distances(x, y, expected) -> None:
    assert bilinear_value(VALUES, XS, YS, x, y) == (expected and pytest.approx(expected))
