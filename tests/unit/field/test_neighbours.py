"""How far apart elements are, and which of them meet."""

from __future__ import annotations

import math

import numpy as np
import pytest

from procc_annotator.field.geometry import Arc, Circle, Geometry, Line, Spot
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.load import field_names, load_field
from procc_annotator.field.model import Element, Field, Landmark
from procc_annotator.field.sampling import (
    distances_from,
    distances_to,
    sample_evenly,
    touching_elements,
)


def apart(one: Geometry, other: Geometry) -> float:
    elements = [Element(n, n, "", "#ffffff", "", g) for n, g in (("one", one), ("other", other))]
    field = Field("", "", (), tuple(elements))
    there, back = distances_from(field, ("one",)), distances_from(field, ("other",))
    assert there[1] == pytest.approx(back[0], abs=1e-12)
    assert there[0] == back[1] == 0
    return float(there[1])


LONG = Line((-50.0, 0.0, 0.0), (50.0, 0.0, 0.0))


@pytest.mark.parametrize(
    ("other", "expected"),
    [
        (Line((0.3, -7.0, 0.0), (0.4, 9.0, 0.0)), 0.0),  # they cross
        (Line((0.3, -7.0, 0.0), (0.4, -2.0, 0.0)), 2.0),
        (Line((-50.0, 4.0, 0.0), (50.0, 4.0, 0.0)), 4.0),  # parallel
        (Line((53.0, 4.0, 0.0), (60.0, 4.0, 0.0)), 5.0),
        (Line((7.0, 0.0, -2.44), (7.0, 3.0, -2.44)), 2.44),  # above
        (Spot((1.23, 0.5, 0.0)), 0.5),
        (Spot((-53.0, -4.0, 0.0)), 5.0),
        (Circle((3.0, 12.0, 0.0), 9.15), 2.85),
        (Arc((0.0, 1.0, 0.0), 3.0, 0.0, math.pi), 1.0),  # its lower half is not there
    ],
)
def test_distances_are_those_of_the_drawing(other, expected) -> None:
    assert apart(LONG, other) == pytest.approx(expected, abs=0.02)
    assert apart(other, LONG) == pytest.approx(expected, abs=0.02)


def test_two_places_are_as_far_apart_as_they_are() -> None:
    assert apart(Spot((1.0, 2.0, 0.0)), Spot((4.0, 6.0, 0.0))) == pytest.approx(5.0)


def test_what_is_joined_meets() -> None:
    field = load_field("soccer")
    assert set(touching_elements(field, "Side line left")) >= {
        "Big rect. left top",
        "Goal left post right",
        "Side line top",
        "Corner flag left bottom",
    }
    assert "Circle left" in touching_elements(field, "Big rect. left main")
    assert "Side line right" not in touching_elements(field, "Side line left")
    assert touching_elements(field, "no such class") == ()


@pytest.mark.parametrize("name", field_names())
def test_of_every_field_all_elements_on_the_ground_are_near_some_other(name) -> None:
    field = load_field(name)
    ground = field.on_ground
    for i in ground.nonzero()[0]:
        distances = distances_from(field, (field.elements[i].name,))
        others = [distances[j] for j in ground.nonzero()[0] if j != i]
        assert min(others) < 15, field.elements[i].name


@pytest.mark.parametrize("name", ["athletics", "basketball_fiba"])
def test_the_nearest_segments_are_found_among_all(name) -> None:
    field = load_field(name)
    rng = np.random.default_rng(3)
    for i in rng.choice(len(field.elements), 8, replace=False):
        elements = (field.elements[i],)
        reached = distances_from(field, (field.elements[i].name,))
        for j, other in enumerate(field.elements):
            points = sample_evenly(Field("", "", (), (other,)), 0.25).of(0)
            dense = distances_to(elements, points).min()
            assert reached[j] <= dense + 0.05
            assert reached[j] >= dense - 0.2


def test_landmarks_are_as_near_as_other_elements() -> None:
    field = load_field("soccer")
    spots = {"Seat": (-52.5, 40.0, -3.0), "Board": (-52.5, 37.0, 1.0)}
    placed = with_landmarks(field, [Landmark(name, position=p) for name, p in spots.items()])
    from_board = dict(zip(placed.index, distances_from(placed, ("Board",)), strict=True))
    assert from_board["Seat"] == pytest.approx(5.0)
    assert from_board["Side line left"] == pytest.approx(math.hypot(3.0, 1.0))
    near_both = distances_from(placed, ("Seat", "Side line left"))
    assert near_both[placed.index["Board"]] == pytest.approx(math.hypot(3.0, 1.0))
    assert (near_both[: len(field.elements)] <= distances_from(field, ("Side line left",))).all()


def test_nothing_is_near_what_has_no_place() -> None:
    field = load_field("tennis")
    assert np.isinf(distances_from(field, ())).all()
    assert np.isinf(distances_from(field, ("no such class",))).all()
