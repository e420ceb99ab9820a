"""Lines get their likeliest names without a camera."""

from __future__ import annotations

import json

import numpy as np
import pytest

from procc_annotator.calibration.prediction.suggestions import likely_classes
from procc_annotator.field.load import field_names, load_field

SIZE = (1280, 720)


@pytest.fixture(scope="module")
def frames(sample_data) -> list[dict[str, np.ndarray]]:
    """The elements of the sample's annotated frames, px."""
    field = load_field("soccer")
    found = []
    for path in sorted(sample_data.glob("0*.json")):
        entries = json.loads(path.read_text())
        found.append(
            {
                name: np.array([(p["x"], p["y"]) for p in points]) * (SIZE[0] - 1, SIZE[1] - 1)
                for name, points in entries.items()
                if field.element(name) is not None and len(points) > 1
            }
        )
    return found


def test_with_two_neighbours_most_lines_are_among_the_first_three(frames) -> None:
    field, rng = load_field("soccer"), np.random.default_rng(0)
    asked = right = 0
    for lines in frames:
        for name, line in lines.items():
            others = [other for other in lines if other != name]
            known = {other: lines[other] for other in rng.permutation(others)[:2]}
            found = likely_classes(field, line, SIZE, known)
            assert not set(found) & set(known)
            asked += 1
            right += name in found[:3]
    assert right / asked > 0.7  # of 26 elements; the first three at random would be 12 %


@pytest.mark.parametrize("name", field_names())
def test_every_field_has_an_answer(name) -> None:
    field = load_field(name)
    for line in (np.array([(100.0, 300), (1000, 330)]), np.array([(640.0, 360.0)])):
        found = likely_classes(field, line, SIZE, {})
        assert len(found) == len(set(found))
        assert all(field.element(one) is not None for one in found)
