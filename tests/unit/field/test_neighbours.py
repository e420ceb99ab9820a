"""How far apart elements are, and which of them meet."""

from __future__ import annotations

import math

import pytest

from procc_annotator.field.geometry import Arc, Circle, Geometry, Line, Spot
from procc_annotator.field.load import field_names, load_field
from procc_annotator.field.model import Element, Field
from procc_annotator.field.neighbours import distances_between, meeting


def apart(one: Geometry, other: Geometry) -> float:
    elements = [Element(n, n, "", "#ffffff", "", g) for n, g in (("one", one), ("other", other))]
    distances = distances_between(Field("", "", (), tuple(elements)))
    assert distances[0, 1] == pytest.approx(distances[1, 0], abs=1e-12)
    return float(distances[0, 1])


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
def test_distances_are_those_of_the_drawing(other: Geometry, expected: float) -> None:
    assert apart(LONG, other) == pytest.approx(expected, abs=0.02)
    assert apart(other, LONG) == pytest.approx(expected, abs=0.02)


def test_two_places_are_as_far_apart_as_they_are() -> None:
    assert apart(Spot((1.0, 2.0, 0.0)), Spot((4.0, 6.0, 0.0))) == pytest.approx(5.0)


def test_what_is_joined_meets() -> None:
    field = load_field("soccer")
    assert set(meeting(field, "Side line left")) >= {
        "Big rect. left top",
        "Goal left post right",
        "Side line top",
        "Corner flag left bottom",
    }
    assert "Circle left" in meeting(field, "Big rect. left main")
    assert "Side line right" not in meeting(field, "Side line left")
    assert meeting(field, "no such class") == ()


@pytest.mark.parametrize("name", field_names())
def test_of_every_field_all_elements_on_the_ground_are_near_some_other(name: str) -> None:
    field = load_field(name)
    distances = distances_between(field)
    ground = field.on_ground
    for i in ground.nonzero()[0]:
        others = [distances[i, j] for j in ground.nonzero()[0] if j != i]
        assert min(others) < 15, field.elements[i].name
