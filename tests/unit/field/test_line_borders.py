"""The borders of painted lines: as far from the elements as the paint is wide, on its side."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.field.geometry import Arc, Chain, Circle, Line, outline_of
from procc_annotator.field.load import field_names, load_field
from procc_annotator.field.markings import class_of_border, marking_field
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sampling import sample_evenly

SOCCER = load_field("soccer")


def borders_of(field: Field, name: str) -> list[Element]:
    return [e for e in marking_field(field).elements if class_of_border(e.name) == name]


def one_element(geometry, **looks) -> Field:
    element = replace(
        SOCCER.elements[0], name="it", geometry=geometry, **({"inside": None} | looks)
    )
    return replace(SOCCER, elements=(element,), symmetries=())


def test_soccer_is_measured_at_the_outer_edge() -> None:
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
def test_every_border_is_as_far_away_as_the_paint_is_wide(name) -> None:
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


def test_corners_of_a_box_stay_corners() -> None:
    places = [(0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0), (0, 0, 0)]
    box = Chain(tuple(Line(a, b) for a, b in zip(places, places[1:], strict=False)))  # noqa: RUF007
    field = one_element(box, line_width=0.5, inside=(2.0, 1.5, 0.0))
    corners = {tuple(np.round(e.geometry.start, 9)) for e in borders_of(field, "it")}
    assert corners == {(0.5, 0.5, 0), (3.5, 0.5, 0), (3.5, 2.5, 0), (0.5, 2.5, 0)}
    outside = one_element(box, line_width=0.5, inside=(2.0, 9.0, 0.0))
    corners = {tuple(np.round(e.geometry.start, 9)) for e in borders_of(outside, "it")}
    assert corners == {(-0.5, -0.5, 0), (4.5, -0.5, 0), (4.5, 3.5, 0), (-0.5, 3.5, 0)}


def test_a_curve_is_painted_in_its_own_plane() -> None:
    hoop = Circle((0.0, 0.0, -3.0), 1.0, (0.0, 1.0, 0.0), (0.0, 0.0, -1.0))
    inner, outer = sorted(
        e.geometry.radius for e in borders_of(one_element(hoop, line_width=0.2), "it")
    )
    assert (inner, outer) == pytest.approx((0.9, 1.1))
    small = one_element(replace(hoop, radius=0.05), line_width=0.2)
    assert len(borders_of(small, "it")) == 1  # inside of it nothing is left unpainted


def test_a_bar_in_the_air_is_painted_towards_a_place_only() -> None:
    bar = Line((0.0, -1.0, -2.0), (0.0, 1.0, -2.0))
    assert not borders_of(one_element(bar, line_width=0.1), "it")
    (lower,) = borders_of(one_element(bar, line_width=0.1, inside=(0.0, 0.0, -1.0)), "it")
    assert outline_of(lower.geometry)[:, 2] == pytest.approx(-1.9)
