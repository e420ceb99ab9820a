"""Sampling: the official spacing with its quirks, even spacing, and the symmetry of the field."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.field.geometry import (
    Arc,
    Circle,
    Geometry,
    Line,
    Spot,
    middle_of,
    points_at_angles,
)
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.load import field_names, load_field
from procc_annotator.field.model import Element, Field, Landmark
from procc_annotator.field.sampling import (
    distances_from,
    distances_to,
    distinctive_points,
    sample_evenly,
    sample_official,
    touching_elements,
)


def test_official_sampling_of_a_straight_element():
    field = load_field()
    points = sample_official(field).of(field.index["Goal left crossbar"])
    length = 7.32
    gaps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert len(points) == int(length / 0.9 - 1) + 2
    np.testing.assert_allclose(gaps[:-1], 0.9)
    assert 0.9 <= gaps[-1] < 1.8
    np.testing.assert_allclose(points[0], (-52.5, -3.66, -2.44))
    np.testing.assert_allclose(points[-1], (-52.5, 3.66, -2.44))


def test_official_sampling_of_the_circles():
    field = load_field()
    samples = sample_official(field)
    circle = samples.of(field.index["Circle central"])
    assert len(circle) == int(2 * math.pi * 9.15 / 0.2)
    np.testing.assert_allclose(circle[0], (9.15, 0, 0))
    assert not np.allclose(circle[0], circle[-1])
    arc = samples.of(field.index["Circle left"])
    half = math.acos(5.5 / 9.15)
    assert len(arc) == int(2 * half * 9.15 / 0.2) + 2
    assert arc[0, 1] < 0 < arc[-1, 1]
    np.testing.assert_allclose(arc[[0, -1], 0], -36.0)
    right = samples.of(field.index["Circle right"])
    assert right[0, 1] > 0 > right[-1, 1]


def test_the_official_elements_are_1187_points():
    field = load_field()
    samples = sample_official(field)
    official = sum(not e.optional for e in field.elements)
    assert samples.offsets[official] == 1187
    assert samples.offsets[-1] == len(samples.points_world) > 1187


@given(st.floats(0.05, 20))
def test_even_sampling_keeps_ends_and_closes_circles(spacing):
    field = load_field()
    samples = sample_evenly(field, spacing)
    for i, element in enumerate(field.elements):
        points = samples.of(i)
        if element.is_spot:
            assert points.tolist() == [list(middle_of(element.geometry))]
            continue
        gaps = np.linalg.norm(np.diff(points, axis=0), axis=1)
        assert gaps.max() <= spacing * (1 + 1e-9)
        np.testing.assert_allclose(gaps, gaps[0], rtol=1e-6)
        if isinstance(element.geometry, Line):
            assert tuple(points[0]) == element.geometry.start
            assert tuple(points[-1]) == element.geometry.end
        assert bool(samples.closed[i]) == (element.name == "Circle central")
    circle = samples.of(field.index["Circle central"])
    assert (circle[0] == circle[-1]).all()


@given(length=st.floats(90.1, 120), width=st.floats(45, 90))
def test_the_symmetry_maps_the_field_onto_itself(length, width):
    field = load_field("soccer", length=length, width=width)
    samples = sample_evenly(field, 0.5)
    for i, element in enumerate(field.elements):
        partner = field.symmetries[0].name_of(element.name)
        assert field.symmetries[0].name_of(partner) == element.name
        turned = samples.of(i) * (-1, -1, 1)
        target = samples.of(field.index[partner])
        distances = np.linalg.norm(turned[:, None] - target[None], axis=2).min(axis=1)
        assert distances.max() < 1e-6 if element.is_straight else distances.max() < 0.26


@pytest.mark.parametrize("spacing", [0, -1, math.nan, math.inf])
def test_a_senseless_spacing_is_refused(spacing):
    with pytest.raises(ValueError, match="positive spacing"):
        sample_evenly(load_field(), spacing)


def test_a_rim_is_round_even_at_the_official_spacing():
    field = load_field("basketball_fiba")
    rim = sample_official(field).of(field.index["Rim left"])
    geometry = field.elements[field.index["Rim left"]].geometry
    circle = points_at_angles(geometry, np.linspace(0, 2 * math.pi, 721))
    apart = np.linalg.norm(circle[:, None] - rim[None], axis=2).min(axis=1)
    assert apart.max() < 0.025


# Places of a field that can be told from all others on their lines.


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
def test_soccer(place):
    names, places = distinctive_points(load_field().elements)
    assert len(names) == len(places)
    assert np.linalg.norm(places - place, axis=1).min() < 0.05


def test_each_is_there_once():
    _, places = distinctive_points(load_field().elements)
    apart = np.linalg.norm(places[:, None] - places, axis=2)
    np.fill_diagonal(apart, np.inf)
    assert apart.min() > 0.05


def test_of_no_elements_there_are_none():
    assert distinctive_points(())[1].shape == (0, 3)


# How far apart elements are, and which of them meet.


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
def test_distances_are_those_of_the_drawing(other, expected):
    assert apart(LONG, other) == pytest.approx(expected, abs=0.02)
    assert apart(other, LONG) == pytest.approx(expected, abs=0.02)


def test_two_places_are_as_far_apart_as_they_are():
    assert apart(Spot((1.0, 2.0, 0.0)), Spot((4.0, 6.0, 0.0))) == pytest.approx(5.0)


def test_what_is_joined_meets():
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
def test_of_every_field_all_elements_on_the_ground_are_near_some_other(name):
    field = load_field(name)
    ground = field.on_ground
    for i in ground.nonzero()[0]:
        distances = distances_from(field, (field.elements[i].name,))
        others = [distances[j] for j in ground.nonzero()[0] if j != i]
        assert min(others) < 15, field.elements[i].name


@pytest.mark.parametrize("name", ["athletics", "basketball_fiba"])
def test_the_nearest_segments_are_found_among_all(name):
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


def test_landmarks_are_as_near_as_other_elements():
    field = load_field("soccer")
    spots = {"Seat": (-52.5, 40.0, -3.0), "Board": (-52.5, 37.0, 1.0)}
    placed = with_landmarks(field, [Landmark(name, position=p) for name, p in spots.items()])
    from_board = dict(zip(placed.index, distances_from(placed, ("Board",)), strict=True))
    assert from_board["Seat"] == pytest.approx(5.0)
    assert from_board["Side line left"] == pytest.approx(math.hypot(3.0, 1.0))
    near_both = distances_from(placed, ("Seat", "Side line left"))
    assert near_both[placed.index["Board"]] == pytest.approx(math.hypot(3.0, 1.0))
    assert (near_both[: len(field.elements)] <= distances_from(field, ("Side line left",))).all()


def test_nothing_is_near_what_has_no_place():
    field = load_field("tennis")
    assert np.isinf(distances_from(field, ())).all()
    assert np.isinf(distances_from(field, ("no such class",))).all()
