"""Ice hockey and American football lie where sportypy draws them and where the rule books say."""

import importlib
import math
import warnings
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from procc_annotator.field.geometry import Line, outline_of
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Element, Field

Outlines = dict[str, list[NDArray[np.float64]]]

CENTIMETRE = 0.01
FOOT, INCH, YARD = 0.3048, 0.0254, 0.9144
METRES = {"m": 1.0, "ft": FOOT, "yd": YARD}
SURFACES = {
    "ice_hockey_iihf": ("sportypy.surfaces.hockey", "IIHFRink"),
    "ice_hockey_nhl": ("sportypy.surfaces.hockey", "NHLRink"),
    "american_football": ("sportypy.surfaces.football", "NFLField"),
}
RINKS = ("ice_hockey_iihf", "ice_hockey_nhl")


@pytest.fixture(scope="module")
def drawings() -> dict[str, Outlines]:
    """Field -> kind of feature -> its outlines (n, 2), metres, y towards the main camera."""
    pytest.importorskip("sportypy")
    found: dict[str, Outlines] = {}
    for name, (module, surface) in SURFACES.items():
        with warnings.catch_warnings():  # sportypy reads its own data in an old way
            warnings.simplefilter("ignore", DeprecationWarning)
            drawn: Any = getattr(importlib.import_module(module), surface)()
        for feature in drawn._features:
            corners = feature._translate_feature()[["x", "y"]].to_numpy(dtype=float)
            metres = corners * METRES[feature.feature_units] * np.array([1.0, -1.0])
            found.setdefault(name, {}).setdefault(type(feature).__name__, []).append(metres)
    return found


@cache
def nominal(field: str) -> Field:
    return load_field(field)


def element(field: str, class_name: str) -> Element:
    found = nominal(field).element(class_name)
    assert found is not None, class_name
    return found


def line(field: str, class_name: str) -> Line:
    return element(field, class_name).geometry


def off_the_outlines(places: NDArray[np.float64], outlines: list[NDArray[np.float64]]) -> float:
    """Metres from places (n, 2) to the nearest edge of the outlines, at worst."""
    nearest = np.full(len(places), np.inf)
    for outline in outlines:
        start, along = outline[:-1], np.diff(outline, axis=0)
        squared = np.maximum((along**2).sum(axis=1), 1e-18)
        for i, place in enumerate(places):
            share = np.clip(((place - start) * along).sum(axis=1) / squared, 0, 1)
            gaps = np.linalg.norm(start + share[:, None] * along - place, axis=1)
            nearest[i] = min(nearest[i], gaps.min())
    return float(nearest.max())


@pytest.mark.parametrize("rink", RINKS)
@pytest.mark.parametrize(
    ("feature", "class_names"),
    [
        ("Boards", ["Board side top", "Board end left", "Board corner left bottom"]),
        ("Boards", ["Board side bottom", "Board end right", "Board corner right top"]),
        ("CenterFaceoffCircle", ["Circle centre"]),
        ("ODZoneFaceoffCircle", ["Circle left top", "Circle right bottom"]),
        ("GoalCreaseOutline", ["Goal crease left", "Goal crease right"]),
        ("GoaltendersRestrictedArea", ["Trapezoid left top", "Trapezoid right bottom"]),
        ("RefereeCrease", ["Referee crease bottom"]),
    ],
)
def test_a_rink_runs_along_the_edges_that_sportypy_draws(drawings, rink, feature, class_names):
    for name in class_names:
        places = outline_of(element(rink, name).geometry)[:, :2]
        off = off_the_outlines(places, drawings[rink][feature])
        assert off < CENTIMETRE, f"{name} is {off:.3f} m off"


@pytest.mark.parametrize(
    ("field", "feature", "class_name"),
    [
        *((rink, "CenterLine", "Line centre") for rink in RINKS),
        *((rink, "GoalLine", f"Line goal {side}") for rink in RINKS for side in ("left", "right")),
        *(("ice_hockey_nhl", "ZoneLine", f"Line blue {side}") for side in ("left", "right")),
        ("american_football", "MajorYardLine", "Yard line 50"),
        *(
            ("american_football", "MajorYardLine", f"Yard line {side} {yards:02d}")
            for side in ("left", "right")
            for yards in (5, 20, 45)
        ),
        ("american_football", "TryMark", "Try mark left"),
    ],
)
def test_a_line_is_the_middle_of_the_paint_that_sportypy_draws(
    drawings, field, feature, class_name
):
    own = line(field, class_name)
    middles = {
        (outline[:, 0].max() + outline[:, 0].min()) / 2: outline
        for outline in drawings[field][feature]
    }
    nearest = min(middles, key=lambda x: abs(x - own.start[0]))
    assert own.start[0] == own.end[0] == pytest.approx(nearest, abs=CENTIMETRE)
    if feature != "GoalLine":  # whose ends are as round as the boards
        assert own.end[1] == pytest.approx(np.abs(middles[nearest][:, 1]).max(), abs=CENTIMETRE)


@pytest.mark.parametrize(
    ("feature", "class_names"),
    [
        ("Sideline", ["Side line bottom", "Side line top"]),
        ("EndLine", ["End line left", "End line right"]),
        ("GoalLine", ["Goal line left", "Goal line right"]),
    ],
)
def test_a_football_field_is_measured_to_the_edges_that_sportypy_draws(
    drawings, feature, class_names
):
    for name in class_names:
        own = element("american_football", name)
        places = outline_of(own.geometry)[:, :2]
        drawn = drawings["american_football"][feature]
        assert off_the_outlines(places, drawn) < CENTIMETRE
        towards_paint = np.sign(np.array(own.inside[:2]) - places.mean(axis=0))
        middle = places.mean(axis=0) + towards_paint * own.line_width / 2
        inside = [(o.min(axis=0) < middle).all() and (middle < o.max(axis=0)).all() for o in drawn]
        assert any(inside), f"the paint of {name} lies on the wrong side"


def test_rows_of_hash_marks_face_the_middle(drawings):
    """The rows lie at the inner ends of the short lines between the yard lines."""
    short = [np.abs(o[:, 1]).min() for o in drawings["american_football"]["MinorYardLine"]]
    inner = [y for y in short if y < 10]
    assert len(inner) == 160
    for name in ("Hash marks bottom", "Hash marks top"):
        row = line("american_football", name)
        assert np.abs(np.array(inner) - abs(row.start[1])).max() < CENTIMETRE


@pytest.mark.parametrize("rink", RINKS)
def test_goal_lines_end_at_the_boards(rink):
    boards = [
        outline_of(e.geometry)[:, :2] for e in nominal(rink).elements if e.name.startswith("Board")
    ]
    for side in ("left", "right"):
        ends = np.array(
            [line(rink, f"Line goal {side}").start, line(rink, f"Line goal {side}").end]
        )
        assert off_the_outlines(ends[:, :2], boards) < 0.05  # the arc is a few chords here


def spot(field: str, class_name: str) -> tuple[float, float, float]:
    geometry = element(field, class_name).geometry
    return geometry.position


@pytest.mark.parametrize(
    ("field", "found", "expected"),
    [
        # IIHF Official Rule Book 2023/24, Rule 1: 22.86 m from the end boards to the blue line.
        ("ice_hockey_iihf", lambda f: 30 - line(f, "Line blue right").start[0], 22.86),
        # Face-off spots of the neutral zone are 1.5 m from the (0.3 m wide) blue line.
        (
            "ice_hockey_iihf",
            lambda f: line(f, "Line blue left").start[0] - spot(f, "Spot neutral left top")[0],
            -(1.5 + 0.15),
        ),
        ("ice_hockey_iihf", lambda f: spot(f, "Spot end left bottom")[0], -30 + 4 + 6),
        ("ice_hockey_iihf", lambda f: spot(f, "Spot end left bottom")[1], 7),
        # Rule 1.3: boards 1.07 m high; Rule 2.1: a goal is 1.83 m by 1.22 m.
        ("ice_hockey_iihf", lambda f: line(f, "Rail side top").start[2], -1.07),
        ("ice_hockey_iihf", lambda f: math.dist(*ends(f, "Goal left crossbar")), 1.83),
        ("ice_hockey_iihf", lambda f: math.dist(*ends(f, "Goal right post left")), 1.22),
        # NHL Official Rules 2024-25, Rules 1.3, 1.5, 1.7, 1.9 and 2.1.
        ("ice_hockey_nhl", lambda f: line(f, "Rail side top").start[2], -42 * INCH),
        ("ice_hockey_nhl", lambda f: line(f, "Line goal left").start[0], -89 * FOOT),
        ("ice_hockey_nhl", lambda f: line(f, "Line blue right").start[0], 25.5 * FOOT),
        ("ice_hockey_nhl", lambda f: spot(f, "Spot neutral right top")[0], 20 * FOOT),
        ("ice_hockey_nhl", lambda f: spot(f, "Spot end right top")[0], 69 * FOOT),
        ("ice_hockey_nhl", lambda f: spot(f, "Spot end right top")[1], -22 * FOOT),
        ("ice_hockey_nhl", lambda f: math.dist(*ends(f, "Goal left crossbar")), 6 * FOOT),
        ("ice_hockey_nhl", lambda f: math.dist(*ends(f, "Goal right post left")), 4 * FOOT),
        # NFL Rule 1, section 1 (field, inbound lines) and section 3 (goal posts).
        ("american_football", lambda f: math.dist(*ends(f, "Side line top")), 120 * YARD),
        ("american_football", lambda f: math.dist(*ends(f, "End line left")), 160 * FOOT),
        (
            "american_football",
            lambda f: line(f, "Side line bottom").start[1] - line(f, "Hash marks bottom").start[1],
            70.75 * FOOT,
        ),
        ("american_football", lambda f: math.dist(*ends(f, "Goal left crossbar")), 18.5 * FOOT),
        ("american_football", lambda f: line(f, "Goal left crossbar").start[2], -10 * FOOT),
        ("american_football", lambda f: line(f, "Goal left crossbar").start[0], -60 * YARD),
        ("american_football", lambda f: math.dist(*ends(f, "Goal right upright left")), 35 * FOOT),
    ],
)
def test_measures_are_those_of_the_rule_books(field, found, expected):
    assert found(field) == pytest.approx(expected, abs=CENTIMETRE)


def ends(field: str, class_name: str) -> tuple[Any, Any]:
    own = line(field, class_name)
    return own.start, own.end


@pytest.mark.parametrize(
    ("field", "dimension", "least", "most"),
    [
        ("ice_hockey_iihf", "width", 26, 30),
        ("ice_hockey_iihf", "corner_radius", 7, 8.5),
        ("ice_hockey_nhl", "board_height", 40 * INCH, 48 * INCH),
    ],
)
def test_what_the_rules_leave_open_may_be_chosen(field, dimension, least, most):
    for value in (least, most):
        own = load_field(field, **{dimension: value}).dimension(dimension)
        assert (own.value, own.is_open) == (value, True)


def test_every_fifth_yard_line_is_a_class_of_its_own():
    names = [e.name for e in nominal("american_football").elements]
    yard_lines = [n for n in names if n.startswith("Yard line")]
    assert len(yard_lines) == 19
    places = [line("american_football", n).start[0] for n in yard_lines]
    assert np.allclose(np.diff(sorted(places)), 5 * YARD)


def test_boards_are_judged_only_where_they_are_annotated():
    """A camera behind the boards cannot see where they meet the ice."""
    for rink in RINKS:
        boards = [e for e in nominal(rink).elements if e.name.startswith(("Board", "Rail"))]
        assert len(boards) == 16
        assert all(e.optional for e in boards)
