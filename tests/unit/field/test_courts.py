"""Basketball, tennis and volleyball against an independent drawing of them and the rule books."""

import math
import warnings
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from procc_annotator.field.geometry import (
    Arc,
    Chain,
    Circle,
    Line,
    ends_of,
    length_of,
    middle_of,
    outline_of,
    parts_of,
)
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sampling import sample_evenly

FloatArray = NDArray[np.float64]

FOOT_M = 0.3048
SAME_M = 0.01
BASKETBALL = ("basketball_fiba", "basketball_nba")
COURTS = (*BASKETBALL, "tennis")
SIDES = ("left", "right")
LANE = "FreeThrowLaneBoundary"

# Elements (those of a field that has them) and what the other drawing calls their paint.
PAINT = {
    ("Court edge top", "Court edge bottom"): "Sideline",
    ("Court edge left", "Court edge right"): "Endline",
    ("Midcourt line",): "DivisionLine",
    ("Central circle", "Central circle inner"): "CenterCircleOutline",
    tuple(f"Key area {s} {n}" for s in SIDES for n in ("top", "front", "bottom")): LANE,
    tuple(f"3-points {s} {n}" for s in SIDES for n in ("arc", "top", "bottom")): "ThreePointLine",
    ("Key area left circle", "Key area right circle"): "FreeThrowCircleOutline",
    ("No-charge area left", "No-charge area right"): "RestrictedArc",
    ("Backboard left", "Backboard right"): "Backboard",
    ("Rim left", "Rim right"): "Net",
    tuple(f"Hash mark {s} {n}" for s in SIDES for n in ("top", "bottom")): "InboundingLine",
    ("Baseline left", "Baseline right"): "Baseline",
    tuple(f"{game} sideline {n}" for game in ("Doubles", "Singles") for n in ("far", "near")): (
        "Sideline"
    ),
    ("Service line left", "Service line right"): "ServiceLine",
    ("Centre service line",): "CenterServiceline",
    ("Centre mark left", "Centre mark right"): "CenterMark",
    ("Net top",): "Net",
}


@cache
def other_court(name: str) -> Any:
    """The same court as sportypy knows it."""
    import matplotlib

    matplotlib.use("Agg")
    from sportypy.surfaces.basketball import FIBACourt, NBACourt
    from sportypy.surfaces.tennis import ITFCourt

    kinds = {"basketball_fiba": FIBACourt, "basketball_nba": NBACourt, "tennis": ITFCourt}
    with warnings.catch_warnings():  # it opens its data by a way that Python is to lose
        warnings.simplefilter("ignore", DeprecationWarning)
        return kinds[name]()


def metres(name: str, value: Any) -> float:
    """A measure of the other court; of two (an older lane, an inner circle) the first."""
    unit = 1.0 if name == "basketball_fiba" else FOOT_M
    return unit * float(value[0] if isinstance(value, list) else value)


def thinned(outline: FloatArray) -> FloatArray:
    """An outline without what lies less than 5 mm behind the vertex before it."""
    walked = np.concatenate(([0], np.cumsum(np.linalg.norm(np.diff(outline, axis=0), axis=1))))
    kept = np.unique(np.floor(walked / 0.005), return_index=True)[1]
    return np.asarray(outline[kept])


@cache
def outlines(name: str) -> dict[str, list[FloatArray]]:
    """Name of a kind of paint -> its closed outlines, (n, 2) metres in our frame.

    The colleges' narrower lane, which shared NBA floors have inside the other, is left out.
    """
    found: dict[str, list[FloatArray]] = {}
    for feature in other_court(name)._features:
        outline = feature.create_feature_mpl_polygon().get_xy() * metres(name, 1.0)
        narrow_lane = type(feature).__name__ == LANE and np.ptp(outline[:, 1]) < 12.5 * FOOT_M
        if np.ptp(outline, axis=0).min() > 0 and not narrow_lane:
            found.setdefault(type(feature).__name__, []).append(thinned(outline * (1, -1)))
    return found


@cache
def court(name: str) -> Field:
    return load_field(name)


def element(name: str, element_name: str) -> Element:
    found = court(name).element(element_name)
    assert found is not None
    return found


def samples(name: str, element_name: str) -> FloatArray:
    """(n, 2) metres: an element as seen from above, at least every 25 cm."""
    field = court(name)
    return sample_evenly(field, 0.25).of(field.index[element_name])[:, :2]


def solid(element_name: str, places: FloatArray) -> FloatArray:
    """Places along an element where its paint is not broken, as the NBA's circle is in the key."""
    if not element_name.endswith(" circle") or element_name.startswith("Central"):
        return places
    x = np.abs(places[:, 0])
    return places[x <= (x.min() + x.max()) / 2]


def apart(points: FloatArray, course: FloatArray) -> FloatArray:
    """(n,) metres from points (n, 2) to a polyline (m, 2)."""
    start, along = course[:-1], np.diff(course, axis=0)
    squared = np.maximum((along**2).sum(axis=1), 1e-18)
    nearest = np.full(len(points), np.inf)
    for i, point in enumerate(points):
        t = np.clip(((point - start) * along).sum(axis=1) / squared, 0, 1)
        nearest[i] = np.linalg.norm(start + t[:, None] * along - point, axis=1).min()
    return nearest


def within(points: FloatArray, areas: list[FloatArray]) -> NDArray[np.bool_]:
    """(n,) whether points (n, 2) lie in one of the areas."""
    from matplotlib.path import Path

    return np.any([Path(area).contains_points(points) for area in areas], axis=0)


def towards_paint(element: Element, part: Line | Arc | Circle, distance_m: float) -> FloatArray:
    """(n, 2) metres: places beside a part of an element, on the side of its paint."""
    inside = np.array(element.inside[:2])
    if isinstance(part, Line):
        start, end = np.array(part.start[:2]), np.array(part.end[:2])
        along = (end - start) / np.linalg.norm(end - start)
        normal = np.array((-along[1], along[0]))
        normal *= np.sign(normal @ (inside - start))
        return np.asarray(np.linspace(start, end, 9)[1:-1] + distance_m * normal)
    centre = np.array(part.centre[:2])
    inwards = np.linalg.norm(inside - centre) < part.radius
    places = outline_of(part)[1:-1, :2]
    outwards = (places - centre) / part.radius
    return np.asarray(places + outwards * (-distance_m if inwards else distance_m))


@pytest.mark.parametrize("name", COURTS)
def test_lines_lie_where_an_independent_drawing_has_them(name):
    field, compared = court(name), set()
    for elements, kind in PAINT.items():
        known = [n for n in elements if n in field.index]
        if not known or not (areas := outlines(name).get(kind)):
            continue
        if kind == "Net" and name == "tennis":
            continue  # the net has no thickness of its own: the next test has its length
        compared |= set(known)
        for one in known:
            found = solid(one, samples(name, one))
            edge = np.min([apart(found, np.vstack((a, a[:1]))) for a in areas], axis=0)
            if element(name, one).inside is None and kind not in ("Net", "Backboard"):
                assert within(found[1:-1], areas).all(), one
                assert edge[[0, -1]].max() < SAME_M, one
            else:
                assert edge.max() < SAME_M, one
        courses = [samples(name, one) for one in known]
        width = max(field.elements[field.index[one]].line_width for one in known)
        for area in areas:
            reached = np.min([apart(area[::20], course) for course in courses], axis=0)
            assert reached.max() < max(width, 0.05) * math.sqrt(2) + SAME_M, known
    assert len(compared) == {"basketball_fiba": 26, "basketball_nba": 31, "tennis": 11}[name]


@pytest.mark.parametrize("name", COURTS)
def test_paint_lies_on_the_side_an_independent_drawing_has_it(name):
    field, compared = court(name), 0
    for elements, kind in PAINT.items():
        for one in elements:
            if one not in field.index or (painted := element(name, one)).inside is None:
                continue
            geometry = painted.geometry
            parts = geometry.parts if isinstance(geometry, Chain) else parts_of(geometry)
            if isinstance(geometry, Chain):  # an arch: its round part tells the side of all
                parts = tuple(p for p in parts if isinstance(p, Arc))
            for part in parts:
                beside = solid(one, towards_paint(painted, part, 0.015))
                assert within(beside, outlines(name)[kind]).all(), one
                beyond = solid(one, towards_paint(painted, part, -0.015))
                assert not within(beyond, outlines(name)[kind]).any(), one
            compared += 1
    assert compared == {"basketball_fiba": 21, "basketball_nba": 26, "tennis": 8}[name]


@pytest.mark.parametrize("name", BASKETBALL)
def test_lengths_of_basketball_agree_with_an_independent_source(name):
    known = {k: metres(name, v) for k, v in other_court(name).court_params.items()
             if isinstance(v, int | float | list) and not isinstance(v, bool)
             and not (isinstance(v, list) and isinstance(v[0], list | bool))}  # fmt: skip
    turn = math.asin(
        known["basket_center_to_corner_three"] / known["basket_center_to_three_point_arc"]
    )
    straight = known["basket_center_to_baseline"] + known[
        "basket_center_to_three_point_arc"
    ] * math.cos(turn)
    circle = math.pi * known["free_throw_circle_radius"]
    beyond = (
        2 * (known["division_line_extension"] + known["line_thickness"])
        if "division_line_extension" in known
        else 0
    )
    expected = {
        "Court edge top": known["court_length"],
        "Court edge left": known["court_width"],
        "Midcourt line": known["court_width"] + beyond,
        "Central circle": 2 * math.pi * known["center_circle_radius"],
        "Key area left top": known["lane_length"],
        "Key area left front": known["lane_width"],
        "Key area left circle": circle if name == "basketball_fiba" else 2 * circle,
        "3-points left arc": 2 * turn * known["basket_center_to_three_point_arc"],
        "3-points left top": straight,
        "No-charge area left": math.pi * known["restricted_arc_radius"]
        + 2 * (known["basket_center_to_baseline"] - known["backboard_face_to_baseline"]),
        "Rim left": 2 * math.pi * known["basket_ring_inner_radius"],
    }
    field = court(name)
    for one, length in expected.items():
        assert length_of(element(name, one).geometry) == pytest.approx(length, abs=SAME_M), one
        partner = field.symmetries[0].partner[one]
        assert length_of(element(name, partner).geometry) == pytest.approx(length, abs=SAME_M)
    from_endline = middle_of(element(name, "Rim right").geometry)[0]
    assert known["court_length"] / 2 - from_endline == pytest.approx(
        known["basket_center_to_baseline"], abs=SAME_M
    )
    board = outline_of(element(name, "Backboard right").geometry)
    assert np.ptp(board[:, 1]) == pytest.approx(known["backboard_width"], abs=SAME_M)
    assert board[:, 0] == pytest.approx(
        known["court_length"] / 2 - known["backboard_face_to_baseline"], abs=SAME_M
    )


@pytest.mark.parametrize(
    ("name", "lower", "width", "height", "rim", "rectangle"),
    [
        # FIBA Basketball Equipment 1.1 and 1.2: metres; rectangle: width, height, its foot
        ("basketball_fiba", 2.90, 1.80, 1.05, 3.05, (0.59, 0.45, 3.0)),
        # NBA Rule 1, Section I, and its diagram: inches
        ("basketball_nba", 114 * 0.0254, 72 * 0.0254, 42 * 0.0254, 120 * 0.0254,
         (24 * 0.0254, 18 * 0.0254, 118 * 0.0254)),
    ],
)  # fmt: skip
def test_baskets_hang_as_high_as_the_rules_say(name, lower, width, height, rim, rectangle):
    for side in SIDES:
        board = outline_of(element(name, f"Backboard {side}").geometry)
        assert -board[:, 2].max() == pytest.approx(lower)
        assert np.ptp(board[:, 1:], axis=0) == pytest.approx((width, height))
        mark = outline_of(element(name, f"Backboard {side} rectangle").geometry)
        assert (*np.ptp(mark[:, 1:], axis=0), -mark[:, 2].max()) == pytest.approx(rectangle)
        assert board[:, 0] == pytest.approx(mark[0, 0])
        ring = element(name, f"Rim {side}").geometry
        assert -ring.centre[2] == pytest.approx(rim)
        assert middle_of(element(name, f"Rim {side} centre").geometry) == ring.centre
        # from the ring's inside to the board: 150 mm, six inches
        gap = abs(board[0, 0]) - abs(ring.centre[0]) - ring.radius
        assert gap == pytest.approx(0.15 if name == "basketball_fiba" else 6 * 0.0254)


def test_the_first_twenty_classes_are_numbered_as_the_published_label_pictures():
    for name in BASKETBALL:
        centres = [middle_of(e.geometry) for e in court(name).elements[:20]]
        far, near = (1, 3), (3, 1)
        x, y = (np.array(centres)[:, i] for i in (0, 1))
        assert y[far[0] - 1] < 0 < y[near[0] - 1]
        assert x[4 - 1] < 0 < x[2 - 1]
        assert list(np.sign(x[7 - 1 : 10])) == [-1] * 4
        assert list(np.sign(x[11 - 1 : 14])) == [1] * 4
        assert list(np.sign(x[15 - 1 : 17])) == [-1] * 3
        assert list(np.sign(x[18 - 1 : 20])) == [1] * 3
        for top, bottom in ((7, 9), (11, 13), (16, 17), (19, 20)):
            assert y[top - 1] < 0 < y[bottom - 1]
        assert not any(e.optional for e in court(name).elements[:20])


def test_lengths_of_tennis_agree_with_an_independent_source_and_the_rules():
    known = {k: metres("tennis", v) for k, v in other_court("tennis").court_params.items()
             if isinstance(v, int | float)}  # fmt: skip
    expected = {
        "Baseline left": known["doubles_width"],
        "Doubles sideline far": known["court_length"],
        "Singles sideline near": known["court_length"],
        "Service line right": known["singles_width"],
        "Centre service line": 2 * known["serviceline_distance"],
        "Centre mark left": known["center_mark_length"],
    }
    for one, length in expected.items():
        assert length_of(element("tennis", one).geometry) == pytest.approx(length, abs=SAME_M), one
    net = outline_of(element("tennis", "Net top").geometry)
    assert np.ptp(net[:, 1]) == pytest.approx(known["net_length"], abs=SAME_M)


def test_the_net_of_tennis_sags():
    """ITF Rules of Tennis, Rule 1: 1.07 m at the posts, 0.914 m at the strap."""
    net = element("tennis", "Net top").geometry
    assert middle_of(net) == pytest.approx((0, 0, -0.914))
    ends = ends_of(net)
    assert ends is not None
    for end, post in zip(ends, ("far", "near"), strict=True):
        assert end == pytest.approx(ends_of(element("tennis", f"Net post {post}").geometry)[0])
        assert end[2] == pytest.approx(-1.07)
        assert abs(end[1]) == pytest.approx(10.97 / 2 + 0.914)
    # Without sticks the cord is straight from strap to post; with them it is as high there.
    outline = outline_of(net)
    straight = np.interp(np.abs(outline[:, 1]), (0, 10.97 / 2 + 0.914), (0.914, 1.07))
    assert -outline[:, 2] == pytest.approx(straight, abs=0.0005)
    with_sticks = load_field("tennis", net_stick_height=1.07)
    held = outline_of(with_sticks.elements[with_sticks.index["Net top"]].geometry)
    stick = ends_of(element("tennis", "Singles stick near").geometry)
    assert np.linalg.norm(held - stick[0], axis=1).min() < 1e-9
    assert stick[0][1] == pytest.approx(8.23 / 2 + 0.914)


def test_volleyball_is_as_the_rules_say():
    """FIVB Official Volleyball Rules: the numbers of the rules stand beside their measures."""

    def ends(one: str) -> FloatArray:
        both = ends_of(element("volleyball", one).geometry)
        assert both is not None
        return np.array(both)

    expected = {
        "Side line far": 18.0,  # 1.1
        "End line left": 9.0,  # 1.1
        "Centre line": 9.0,  # 1.3.3
        "Attack line right": 9.0,  # 1.3.4
        "Attack line left extension near": 5 * 0.15 + 5 * 0.20,  # 1.3.4: 1.75 m
        "Service mark right far": 0.15,  # 1.4.2
        "Antenna near": 1.80,  # 2.4
        "Post far": 2.55,  # 2.5.1
    }
    for one, length in expected.items():
        assert length_of(element("volleyball", one).geometry) == pytest.approx(length), one
    assert np.abs(ends("Attack line left")[:, 0]) == pytest.approx(3.0)  # 1.3.4, its rear edge
    assert ends("Service mark left near")[0] == pytest.approx((-9.2, 4.5, 0))  # 1.4.2: 20 cm
    assert -ends("Net top band")[:, 2] == pytest.approx(2.43)  # 2.1.1, men
    women = load_field("volleyball", net_height=2.24)  # 2.1.1
    antenna = ends_of(women.elements[women.index["Antenna far"]].geometry)
    assert antenna[0] == pytest.approx((0, -4.5, -2.24 - 0.80))  # 2.4: 80 cm above the net
    assert antenna[1] == pytest.approx((0, -4.5, -2.24 + 1.00))
    top, bottom = ends("Net top band"), ends("Net bottom band")
    assert bottom[:, 2] - top[:, 2] == pytest.approx(1.0)  # 2.2: 1 m wide
    assert 9.5 <= length_of(element("volleyball", "Net top band").geometry) <= 10.0  # 2.2
    assert 0.5 <= abs(ends("Post near")[0, 1]) - 4.5 <= 1.0  # 2.5.1
    for painted in court("volleyball").elements:
        if painted.on_ground:
            assert painted.line_width == pytest.approx(0.05)  # 1.3.1
            assert (painted.inside is None) == (painted.name == "Centre line")  # 1.3.2, 1.3.3


def test_a_womens_net_and_a_narrower_line_are_within_the_rules():
    field = load_field("volleyball", net_height=2.24, post_distance=0.5, net_length=9.5)
    assert (
        field.described == "volleyball net height 2.24 m, net length 9.5 m, post to side line 0.5 m"
    )
    tennis = load_field("tennis", line_width=0.025, baseline_width=0.05)
    widths = {e.name: e.line_width for e in tennis.elements}
    assert (widths["Service line left"], widths["Baseline left"]) == (0.025, 0.05)
    assert widths["Centre service line"] == 0.05
