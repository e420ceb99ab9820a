"""Labels of others, and the classes that they are called like."""

from __future__ import annotations

import pytest

from procc_annotator.assist.label_proposal import matching_classes
from procc_annotator.field.load import load_field


@pytest.mark.parametrize(
    ("field", "label", "classes"),
    [
        ("tennis", "service-centerline", ["Centre service line"]),
        ("tennis", "Grundlinie links", ["Baseline left"]),
        ("tennis", "sideline-doubles", ["Doubles sideline far", "Doubles sideline near"]),
        ("tennis", "baselines 2", ["Baseline left", "Baseline right"]),
        ("soccer", "penalty_area_left_top", ["Big rect. left top"]),
        ("soccer", "halfwayLine", ["Middle line"]),
        ("soccer", "center circle", ["Circle central"]),
        ("soccer", "circle_centrl", ["Circle central"]),
        ("soccer", "leftGoalCrossbar", ["Goal left crossbar"]),
        ("soccer", "Side line top ", ["Side line top"]),
        ("soccer", "Ligne médiane", ["Middle line"]),
        ("soccer", "player", []),
        ("soccer", "line 2", []),
        ("soccer", "点", []),
    ],
)
def test_labels_and_their_classes(field, label, classes) -> None:
    assert list(matching_classes(label, load_field(field)).classes) == classes


def test_the_other_side_is_never_alike() -> None:
    field = load_field("soccer")
    for side, other in (("left", "right"), ("top", "bottom")):
        for element in field.elements:
            found = matching_classes(f"{element.name} {side}", field).classes
            assert not any(other in name and side not in name for name in found)
