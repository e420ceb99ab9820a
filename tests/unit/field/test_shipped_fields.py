"""What every shipped field keeps: it loads at all legal sizes, lies centred, and can be told apart.

The floors and the few elements that reach over the field's edge are listed here; whoever ships
another field adds a line where it has one.
"""

import itertools
import math
from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from procc_annotator.field.dimensions import violated_relation
from procc_annotator.field.geometry import Geometry, Spot, outline_of, rotated
from procc_annotator.field.load import default_field_name, field_names, load_field
from procc_annotator.field.model import Element, Field, NoPartnerError, find_symmetry
from procc_annotator.field.sampling import sample_evenly

FloatArray = NDArray[np.float64]

NAMES = field_names()
CENTIMETRE = 0.01

# The floor that most halls and stadiums of a sport have; wood where nothing is said.
WOOD, GRASS, ICE = "#B98A55", "#4F7F3A", "#E8EEF2"
FLOORS = {
    "american_football": GRASS,
    "athletics": "#A8492F",
    "ice_hockey_iihf": ICE,
    "ice_hockey_nhl": ICE,
    "soccer": GRASS,
    "tennis": "#3A5F9A",
}
# CIE 1976 distances between colours; 2 is just seen between patches side by side, thin lines on
# moving ground need far more.
APART_IN_A_GROUP, APART_FROM_THE_FLOOR = 12.0, 15.0

# Elements on the ground that a set has to have and that the rules let reach over the edge: metres.
BEYOND = {
    # 15 cm beyond the boundary line's outer edge; the court is measured to its inner one.
    ("basketball_fiba", "Midcourt line"): 0.2,
}
RUN_OFF_M = 2.0  # optional marks beside the field: zones, extensions, a ninth lane


@cache
def sizes(name: str) -> tuple[Field, ...]:
    """The field as it is, at the least and at the largest size the rules allow, and mixed."""
    field = load_field(name)
    free = [d for d in field.dimensions if d.is_open]
    if not free:
        return (field,)
    least = {d.name: d.minimum for d in free}
    most = {d.name: d.maximum for d in free}
    mixed = [
        {**one, "width": other["width"]}
        for one, other in ((least, most), (most, least))
        if "width" in one
    ]
    nominal = {d.name: d.nominal for d in field.dimensions}
    legal = [
        chosen
        for chosen in (least, most, *mixed)
        if not violated_relation(field.relations, nominal | chosen)
    ]
    assert len(legal) >= 2
    return (field, *(load_field(name, **chosen) for chosen in legal))


def sides(field: Field) -> tuple[float, float]:
    length, width = field.dimension("length"), field.dimension("width")
    return length.value, width.value


def lab(colour: str) -> FloatArray:
    """CIE L*a*b* (D65) of an sRGB colour; IEC 61966-2-1 and CIE 15."""
    coded = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    linear = np.where(coded <= 0.04045, coded / 12.92, ((coded + 0.055) / 1.055) ** 2.4)
    to_xyz = np.array(
        [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
    )
    share = (to_xyz @ linear) / (0.9505, 1.0, 1.089)
    f = np.where(share > 216 / 24389, np.cbrt(share), (24389 / 27 * share + 16) / 116)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def colours_apart(one: str, other: str) -> float:
    return float(np.linalg.norm(lab(one) - lab(other)))


def test_the_default_field_is_shipped():
    assert default_field_name() in NAMES


@pytest.mark.parametrize("name", NAMES)
def test_a_field_says_what_it_is_and_where_it_comes_from(name):
    field = load_field(name)
    assert field.name == name
    assert field.title.strip()
    assert field.rules.strip()
    assert field.cameras is not None
    assert field.is_nominal
    assert all(element.group.strip() for element in field.elements)


@pytest.mark.parametrize("name", NAMES)
def test_people_can_tell_elements_apart(name):
    """Names, titles and keys are unique; so are the colours of a group."""
    field = load_field(name)
    for texts in (
        [e.name.strip().casefold() for e in field.elements],
        [e.title.casefold() for e in field.elements],
        [e.shortcut.casefold() for e in field.elements if e.shortcut],
    ):
        assert len(set(texts)) == len(texts)
    for one, other in itertools.combinations(field.elements, 2):
        if one.group == other.group:
            apart = colours_apart(one.colour, other.colour)
            assert apart >= APART_IN_A_GROUP, (one.name, other.name)


@pytest.mark.parametrize("name", NAMES)
def test_colours_are_seen_on_the_floor(name):
    floor = FLOORS.get(name, WOOD)
    for element in load_field(name).elements:
        if element.on_ground:
            assert colours_apart(element.colour, floor) >= APART_FROM_THE_FLOOR, element.name


@pytest.mark.parametrize("name", NAMES)
def test_keys_reach_what_a_set_has_to_have(name):
    field = load_field(name)
    needed = [e for e in field.elements if not e.optional]
    assert sum(bool(e.shortcut) for e in needed) >= min(len(needed), 20)


@pytest.mark.parametrize("name", NAMES)
def test_every_legal_size_loads_centred_on_the_field(name):
    for field in sizes(name):
        length, width = sides(field)
        assert length >= width
        limits = np.array([length, width]) / 2
        ground = [e for e in field.elements if e.on_ground]
        reach = np.zeros(2)
        for element in ground:
            own = np.abs(outline_of(element.geometry)[:, :2]).max(axis=0)
            over = float((own - limits).max())
            spare = RUN_OFF_M if element.optional else BEYOND.get((name, element.name), 0.0)
            assert over <= spare + 1e-9, element.name
            reach = np.maximum(reach, own)
        assert (reach >= limits - 1e-9).all()
        every = np.concatenate([outline_of(e.geometry) for e in ground])
        assert np.abs(every.min(axis=0) + every.max(axis=0)).max() < 1e-9


@pytest.mark.parametrize("name", NAMES)
def test_nothing_lies_below_the_ground_or_in_the_clouds(name):
    for field in sizes(name):
        for element in field.elements:
            z = outline_of(element.geometry)[:, 2]
            assert z.max() <= 1e-9, element.name
            assert z.min() > -20, element.name


@pytest.mark.parametrize("name", NAMES)
def test_every_symmetry_maps_the_geometry_onto_itself(name):
    for field in sizes(name):
        samples = sample_evenly(field, 1.0)
        for symmetry in field.symmetries:
            assert sorted(symmetry.partner) == sorted(symmetry.partner.values())
            assert sorted(symmetry.partner) == sorted(field.index)
            for own, partner in symmetry.partner.items():
                there = [field.elements[field.index[n]].geometry for n in (own, partner)]
                moved = samples.of(field.index[own]) @ rotation(symmetry.turn_rad).T
                assert distance_to(moved, there[1]).max() < CENTIMETRE, (own, partner)
                back = samples.of(field.index[partner]) @ rotation(-symmetry.turn_rad).T
                assert distance_to(back, there[0]).max() < CENTIMETRE, (own, partner)


@pytest.mark.parametrize("name", NAMES)
def test_a_field_lists_the_symmetries_it_has(name):
    field = load_field(name)
    listed = {round(math.degrees(s.turn_rad)) for s in field.symmetries}
    needed = [e for e in field.elements if not e.optional]
    found = set()
    for turn in (60, 72, 90, 120, 180, 240, 270, 300):
        try:
            find_symmetry(needed, turn)
        except NoPartnerError:
            continue
        found.add(turn)
    assert listed == found


@pytest.mark.parametrize("name", NAMES)
def test_partners_are_alike(name):
    """An element and what it becomes: the same paint on the same side, both optional or neither."""
    field = load_field(name)
    for symmetry in field.symmetries:
        for own, partner in symmetry.partner.items():
            one, other = (field.elements[field.index[n]] for n in (own, partner))
            assert one.optional == other.optional, own
            assert one.line_width == other.line_width, own
            assert (one.inside is None) == (other.inside is None), own
            if one.inside is None or other.inside is None:
                continue
            there = rotated(one.geometry, symmetry.turn_rad)
            inside = outline_of(rotated(Spot(one.inside), symmetry.turn_rad))[0]
            assert side_of(there, inside) == pytest.approx(side_of(there, np.array(other.inside)))


@pytest.mark.parametrize("name", NAMES)
def test_paint_lies_on_one_side_of_what_is_measured_at_its_edge(name):
    for element in load_field(name).elements:
        if element.inside is not None:
            assert side_of(element.geometry, np.array(element.inside)) != 0, element.name
        if element.is_spot or not element.on_ground:
            assert element.inside is None, element.name


@pytest.mark.parametrize("name", NAMES)
def test_the_lines_follow_the_width_that_is_chosen(name):
    """A line width that the rules leave open moves no element, it only changes the paint."""
    field = load_field(name)
    width = field.dimension("line_width")
    painted = [e for e in field.elements if e.line_width > 0]
    assert any(e.line_width == width.value for e in painted)
    assert all(e.on_ground and not e.is_spot for e in painted)
    if not width.is_open:
        return
    thin = load_field(name, line_width=width.minimum)
    assert [e.geometry for e in thin.elements] == [e.geometry for e in field.elements]
    assert any(e.line_width == width.minimum for e in thin.elements)


def rotation(turn_rad: float) -> FloatArray:
    c, s = math.cos(turn_rad), math.sin(turn_rad)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def distance_to(points: FloatArray, geometry: Geometry) -> FloatArray:
    """(n,) metres from points to a geometry, by its own samples a centimetre apart."""
    element = Element("it", "it", "", "#ffffff", "", geometry)
    places = sample_evenly(Field("", "", (), (element,)), 0.1).points_world
    starts, along = places[:-1], np.diff(places, axis=0)
    if not len(along):
        return np.linalg.norm(points - places[0], axis=1)
    squares = (along**2).sum(axis=1)
    offset = points[:, None] - starts[None]
    share = ((offset * along).sum(axis=2) / squares).clip(0, 1)
    away = offset - share[..., None] * along
    return np.asarray(np.linalg.norm(away, axis=2).min(axis=1))


def side_of(geometry: Geometry, place: FloatArray) -> float:
    """-1 or 1: on which side of an element a place lies, seen from its first end; 0: on it.

    Beyond the ends of a straight element its prolongation counts.
    """
    element = Element("it", "it", "", "#ffffff", "", geometry)
    places = sample_evenly(Field("", "", (), (element,)), 0.1).points_world
    nearest = int(np.linalg.norm((places[1:] + places[:-1]) / 2 - place, axis=1).argmin())
    (ax, ay, _), (bx, by, _) = places[nearest], places[nearest + 1]
    return float(np.sign(round((bx - ax) * (place[1] - ay) - (by - ay) * (place[0] - ax), 9)))
