"""Fields with their lines in the middle of their paint: by how much, and what stays."""

import math
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.errors import FieldError
from procc_annotator.field.geometry import (
    Arc,
    Chain,
    Circle,
    Line,
    ends_of,
    outline_of,
    same_geometry,
)
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.load import (
    builtin_field_file,
    field_names,
    load_field,
    with_dimensions,
    with_lines,
)
from procc_annotator.field.markings import (
    class_of_border,
    marking_field,
    marking_side,
    with_centred_markings,
)
from procc_annotator.field.model import Element, Field, Landmark, find_symmetry
from procc_annotator.field.sampling import sample_evenly


def geometry_of(field: str, name: str) -> object:
    element = with_centred_markings(load_field(field)).element(name)
    return element.geometry


def ends(field: str, name: str) -> np.ndarray:
    return np.array(ends_of(geometry_of(field, name)))


def test_soccer_lines_move_by_half_their_width_inwards():
    assert ends("soccer", "Side line top") == pytest.approx(
        np.array([(-52.44, -33.94, 0), (52.44, -33.94, 0)])  # to the corners' own middle
    )
    assert ends("soccer", "Side line left")[:, 0] == pytest.approx(-52.44)
    assert ends("soccer", "Big rect. left main")[:, 0] == pytest.approx(-52.5 + 16.5 - 0.06)
    circle = geometry_of("soccer", "Circle central")
    assert isinstance(circle, Circle)
    assert circle.radius == pytest.approx(9.15 - 0.06)
    arc = geometry_of("soccer", "Circle left")
    assert isinstance(arc, Arc)
    assert (arc.radius, arc.centre[0]) == pytest.approx((9.15 - 0.06, -52.5 + 11))


def test_basketball_borders_move_outwards_and_all_else_inwards():
    assert ends("basketball_fiba", "Court edge top") == pytest.approx(
        np.array([(-14.025, -7.525, 0), (14.025, -7.525, 0)])
    )
    front = ends("basketball_fiba", "Key area left front")
    assert front == pytest.approx(np.array([(-8.225, -2.425, 0), (-8.225, 2.425, 0)]))
    area = geometry_of("basketball_fiba", "No-charge area left")
    assert isinstance(area, Chain)
    assert [p.radius for p in area.parts if isinstance(p, Arc)] == pytest.approx([1.275])
    # The arc of the three-point line goes on from its straight part, at another angle than before.
    arc = geometry_of("basketball_fiba", "3-points left arc")
    assert isinstance(arc, Arc)
    assert arc.radius == pytest.approx(6.725)
    (begin, _), straight = ends_of(arc), ends("basketball_fiba", "3-points left top")
    assert min(math.dist(begin, end) for end in straight) < 1e-9
    assert begin[1] == pytest.approx(-(7.5 - 0.9 - 0.025))


def test_wide_paint_moves_far():
    side = load_field("american_football").element("Side line top")
    moved = ends("american_football", "Side line top")
    assert moved[:, 1] == pytest.approx(side.geometry.start[1] - 1.8288 / 2)


@pytest.mark.parametrize("name", field_names())
def test_a_shipped_field_stays_the_same_but_for_its_paint(name):
    field = load_field(name)
    moved = with_centred_markings(field)
    assert [replace(e, geometry=None, inside=None) for e in moved.elements] == [
        replace(e, geometry=None, inside=None) for e in field.elements
    ]
    assert replace(moved, elements=field.elements, lines="measured") == field
    for turn in field.symmetries:
        there = find_symmetry(moved.elements, math.degrees(turn.turn_rad))
        assert there.partner == turn.partner
    at_an_edge = {e.name for e in field.elements if marking_side(e)}
    assert {e.name for e in moved.elements if e != field.element(e.name)} == at_an_edge
    assert not any(marking_side(e) for e in moved.elements)
    assert with_centred_markings(moved) is moved
    assert with_centred_markings(replace(moved, lines="measured")) == moved
    assert moved.described == f"{name}, lines at their middle"


@pytest.mark.parametrize("name", ["soccer", "basketball_nba", "handball", "athletics"])
def test_the_paint_stays_where_it_is(name):
    """One of its borders is where the element was, the other where it was before."""
    field = load_field(name)
    moved = with_centred_markings(field)
    for element in field.elements:
        if not marking_side(element):
            continue
        before = [element.geometry, *_borders(field, element)]
        after = _borders(moved, element)
        if isinstance(element.geometry, Line):  # how far it goes on at a corner may change
            assert _across(before, element) == pytest.approx(_across(after, element)), element.name
        elif isinstance(element.geometry, Circle | Arc):
            radii = sorted(p.radius for p in before)
            assert sorted(p.radius for p in after) == pytest.approx(radii), element.name
        else:
            assert any(same_geometry(p, q) for p in element.geometry.parts for q in after)


def _borders(field: Field, element: Element) -> list:
    return [
        e.geometry for e in marking_field(field).elements if class_of_border(e.name) == element.name
    ]


def _across(borders: list, element: Element) -> list[float]:
    """Where borders lie across a straight element, metres."""
    way = np.subtract(element.geometry.end, element.geometry.start)
    across = np.cross((0, 0, 1), way / np.linalg.norm(way))
    return sorted(float(across @ np.subtract(b.start, element.geometry.start)) for b in borders)


def test_what_has_no_paint_or_no_known_side_stays():
    soccer = load_field("soccer")
    bar = Line((0.0, -1.0, -2.0), (0.0, 1.0, -2.0))
    ring = Circle((0.0, 0.0, 0.0), 0.03)
    odd = (
        replace(soccer.elements[0], name="bar", geometry=bar, line_width=0.1, inside=None),
        replace(soccer.elements[0], name="dot", geometry=ring, line_width=0.1, inside=(0, 0, 0)),
        *(e for e in soccer.elements if e.line_width == 0),
    )
    assert any(e.is_spot for e in odd)
    assert with_centred_markings(replace(soccer, elements=odd)).elements == odd


def test_lines_are_moved_and_put_back_with_dimensions_and_landmarks():
    sized = with_landmarks(
        load_field("soccer", length=101.0), [Landmark("Seat", position=(60.0, 0.0, -5.0))]
    )
    moved = with_lines(sized, "middle")
    assert moved.described == "soccer 101 x 68 m, lines at their middle"
    assert moved.element("Side line left").geometry.start[0] == pytest.approx(-50.5 + 0.06)
    assert moved.element("Seat") == sized.element("Seat")
    wider = with_dimensions(moved, {"length": 103.0})
    assert (wider.lines, wider.landmarks) == ("middle", sized.landmarks)
    assert wider.element("Side line left").geometry.start[0] == pytest.approx(-51.5 + 0.06)
    assert with_lines(moved, "measured") == sized
    with pytest.raises(FieldError, match="expected one of measured, middle"):
        with_lines(sized, "edge")


def test_a_field_file_may_say_where_its_lines_are(tmp_path):
    own = tmp_path / "field.toml"
    text = builtin_field_file("volleyball").read_text()
    own.write_text('lines = "middle"\n' + text)
    field, shipped = load_field(own), load_field("volleyball")
    assert field == with_centred_markings(shipped)
    assert field.full_name == "volleyball"  # it is no other field
    assert with_lines(field, "measured") == shipped
    own.write_text('lines = "edge"\n' + text)
    with pytest.raises(FieldError, match="line 1: lines: expected one of measured, middle"):
        load_field(own)


# The borders of painted lines: as far from the elements as the paint is wide, on its side.

SOCCER = load_field("soccer")


def borders_of(field: Field, name: str) -> list[Element]:
    return [e for e in marking_field(field).elements if class_of_border(e.name) == name]


def one_element(geometry, **looks) -> Field:
    element = replace(
        SOCCER.elements[0], name="it", geometry=geometry, **({"inside": None} | looks)
    )
    return replace(SOCCER, elements=(element,), symmetries=())


def test_soccer_is_measured_at_the_outer_edge():
    (side,) = borders_of(SOCCER, "Side line top")
    assert outline_of(side.geometry)[:, 1] == pytest.approx(-34 + 0.12)
    (circle,) = borders_of(SOCCER, "Circle central")
    assert isinstance(circle.geometry, Circle)
    assert circle.geometry.radius == pytest.approx(9.15 - 0.12)
    (arc,) = borders_of(SOCCER, "Circle left")
    assert isinstance(arc.geometry, Arc)
    assert arc.geometry.radius == pytest.approx(9.15 - 0.12)
    near, far = sorted(borders_of(SOCCER, "Middle line"), key=lambda e: e.geometry.start[0])
    assert [near.geometry.start[0], far.geometry.start[0]] == pytest.approx([-0.06, 0.06])
    assert not borders_of(SOCCER, "Goal left crossbar")
    assert not borders_of(SOCCER, "Penalty mark left")


@pytest.mark.parametrize("name", field_names())
def test_every_border_is_as_far_away_as_the_paint_is_wide(name):
    field = load_field(name)
    own = sample_evenly(field, 0.01 if name == "tennis" else 0.05)
    painted = [e for e in field.elements if e.line_width > 0]
    assert painted
    for border in marking_field(field).elements:
        element = field.element(class_of_border(border.name))
        wanted = element.line_width / (1 if element.inside is not None else 2)
        line = own.of(field.index[element.name])
        middle = outline_of(border.geometry)
        middle = (middle[:-1] + middle[1:]) / 2 if isinstance(border.geometry, Line) else middle
        apart = np.linalg.norm(middle[:, None] - line[None], axis=2).min(axis=1)
        # Where two parts of a chain meet the other part may be nearer.
        assert apart.max() == pytest.approx(wanted, abs=0.03), border.name


def test_corners_of_a_box_stay_corners():
    places = [(0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0), (0, 0, 0)]
    box = Chain(tuple(Line(a, b) for a, b in zip(places, places[1:], strict=False)))  # noqa: RUF007
    field = one_element(box, line_width=0.5, inside=(2.0, 1.5, 0.0))
    corners = {tuple(np.round(e.geometry.start, 9)) for e in borders_of(field, "it")}
    assert corners == {(0.5, 0.5, 0), (3.5, 0.5, 0), (3.5, 2.5, 0), (0.5, 2.5, 0)}
    outside = one_element(box, line_width=0.5, inside=(2.0, 9.0, 0.0))
    corners = {tuple(np.round(e.geometry.start, 9)) for e in borders_of(outside, "it")}
    assert corners == {(-0.5, -0.5, 0), (4.5, -0.5, 0), (4.5, 3.5, 0), (-0.5, 3.5, 0)}


def test_a_curve_is_painted_in_its_own_plane():
    hoop = Circle((0.0, 0.0, -3.0), 1.0, (0.0, 1.0, 0.0), (0.0, 0.0, -1.0))
    inner, outer = sorted(
        e.geometry.radius for e in borders_of(one_element(hoop, line_width=0.2), "it")
    )
    assert (inner, outer) == pytest.approx((0.9, 1.1))
    small = one_element(replace(hoop, radius=0.05), line_width=0.2)
    assert len(borders_of(small, "it")) == 1  # inside of it nothing is left unpainted


def test_a_bar_in_the_air_is_painted_towards_a_place_only():
    bar = Line((0.0, -1.0, -2.0), (0.0, 1.0, -2.0))
    assert not borders_of(one_element(bar, line_width=0.1), "it")
    (lower,) = borders_of(one_element(bar, line_width=0.1, inside=(0.0, 0.0, -1.0)), "it")
    assert outline_of(lower.geometry)[:, 2] == pytest.approx(-1.9)
