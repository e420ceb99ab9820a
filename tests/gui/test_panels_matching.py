"""A few letters find the element that is meant."""

from __future__ import annotations

import pytest

from procc_annotator.field.load import load_field
from procc_annotator.gui.panels.field_map.field_shape import FieldShape
from procc_annotator.interaction.class_choice import match_rank


def _ranks(query: str) -> dict[str, int]:
    """The elements that fit, in the order of the field."""
    elements = load_field("soccer").elements
    ranks = {e.name: match_rank(query, e.title, e.name, e.shortcut) for e in elements}
    return {name: rank for name, rank in ranks.items() if rank is not None}


@pytest.mark.parametrize(
    ("query", "expected"),
    [
        ("Circle central", "Circle central"),
        ("centre", "Circle central"),
        ("halfway", "Middle line"),
        ("middle", "Middle line"),
        ("pen left far", "Big rect. left top"),
        ("side line top", "Side line top"),
        ("CROSSBAR R", "Goal right crossbar"),
    ],
)
def test_letters_find_the_element(query: str, expected: str) -> None:
    ranks = _ranks(query)
    assert min(ranks, key=ranks.__getitem__) == expected


@pytest.mark.parametrize("query", ["xyz", "crossbar middle"])
def test_what_fits_nothing_finds_nothing(query: str) -> None:
    assert not _ranks(query)


@pytest.mark.parametrize("query", ["", "  "])
def test_no_letters_fit_all_alike(query: str) -> None:
    assert set(_ranks(query).values()) == {0}


def test_better_fits_come_first() -> None:
    exact = match_rank("goal", "goal")
    start = match_rank("goal", "goal line")
    words = match_rank("goal", "left goal")
    inside = match_rank("goal", "megagoal")
    assert None not in (exact, start, words, inside)
    assert exact < start < words < inside  # type: ignore[operator]
    assert match_rank("goal", "line") is None


def test_goals_lie_outside_the_field_and_can_be_told_apart() -> None:
    shape = FieldShape.of(load_field("soccer"))
    left, top, right, bottom = shape.bounds
    assert left < -52.5 < 52.5 < right
    assert (top, bottom) == pytest.approx((-34, 34), abs=1e-6)
    assert shape.ground == pytest.approx((-52.5, -34, 52.5, 34), abs=1e-6)
    outside = left - 1.0
    assert shape.pick(outside, 0.0, 3.0) == "Goal left crossbar"
    assert shape.pick(-55.0, 4.5, 2.0) == "Goal left post left "
    assert shape.pick(55.0, 4.5, 2.0) == "Goal right post right"
    assert shape.pick(20.0, 15.0, 3.0) is None
