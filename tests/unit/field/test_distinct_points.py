"""Places of a field that can be told from all others on their lines."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.field.load import load_field
from procc_annotator.field.sampling import distinctive_points


@pytest.mark.parametrize(
    "place",
    [
        (52.5, 34.0, 0.0),  # a corner
        (0.0, -34.0, 0.0),  # where the halfway line ends
        (0.0, 9.15, 0.0),  # where it crosses the centre circle
        (36.0, 20.16, 0.0),  # of a penalty area
        (41.5, 0.0, 0.0),  # its mark
        (52.5, 3.66, -2.44),  # of a goal
        (36.0, 7.312, 0.0),  # where the arc meets the penalty area
    ],
)
def test_soccer(place) -> None:
    names, places = distinctive_points(load_field().elements)
    assert len(names) == len(places)
    assert np.linalg.norm(places - place, axis=1).min() < 0.05


def test_each_is_there_once() -> None:
    _, places = distinctive_points(load_field().elements)
    apart = np.linalg.norm(places[:, None] - places, axis=2)
    np.fill_diagonal(apart, np.inf)
    assert apart.min() > 0.05


def test_of_no_elements_there_are_none() -> None:
    assert distinctive_points(())[1].shape == (0, 3)
