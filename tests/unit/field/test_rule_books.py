"""Soccer's marks, futsal, handball and the running track against their rule books."""

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from procc_annotator.field.geometry import (
    Arc,
    Chain,
    Circle,
    Geometry,
    Line,
    Spot,
    length_of,
    middle_of,
    parts_of,
)
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import sample_evenly

FloatArray = NDArray[np.float64]

CENTIMETRE = 0.01
SIDES = (("left", -1.0), ("right", 1.0))


def geometry(field: Field, name: str) -> Geometry:
    element = field.element(name)
    return element.geometry


def line(field: Field, name: str) -> Line:
    return geometry(field, name)


def places(field: Field, name: str, spacing_m: float = 0.1) -> FloatArray:
    return sample_evenly(field, spacing_m).of(field.index[name])


def painted_towards(field: Field, name: str, x: float, y: float) -> bool:
    """Whether the paint of an element lies on the same side of it as a place."""
    element = field.element(name)
    if isinstance(element.geometry, Line):
        (ax, ay, _), (bx, by, _) = element.geometry.start, element.geometry.end
        mine, other = (
            (bx - ax) * (v - ay) - (by - ay) * (u - ax) for u, v in ((x, y), element.inside[:2])
        )
        return mine * other > 0
    centre, radius = element.geometry.centre, element.geometry.radius
    mine, other = (math.dist(centre[:2], p) < radius for p in ((x, y), element.inside[:2]))
    return mine == other


class TestSoccer:
    """IFAB, Law 1."""

    field = load_field("soccer")

    def test_corners_and_marks(self):
        for side, sign in SIDES:
            for row, ahead in (("top", -1.0), ("bottom", 1.0)):
                corner = (sign * 52.5, ahead * 34.0, 0.0)
                assert geometry(self.field, f"Corner flag {side} {row}") == Spot(corner)
                arc = geometry(self.field, f"Corner arc {side} {row}")
                assert isinstance(arc, Arc)
                assert (arc.centre, arc.radius) == (corner, 1.0)
                assert length_of(arc) == pytest.approx(math.pi / 2)
                inside = np.abs(places(self.field, f"Corner arc {side} {row}")) - (52.5, 34.0, 0)
                assert inside.max() <= 1e-9
            assert geometry(self.field, f"Penalty mark {side}") == Spot((sign * 41.5, 0.0, 0.0))
        assert geometry(self.field, "Centre mark") == Spot((0.0, 0.0, 0.0))

    def test_lines_belong_to_the_areas_they_bound(self):
        for side, sign in SIDES:
            for area in ("Big", "Small"):
                for row in ("main", "top", "bottom"):
                    name = f"{area} rect. {side} {row}"
                    assert painted_towards(self.field, name, sign * 51.0, 0.0), name
            assert painted_towards(self.field, f"Side line {side}", 0.0, 0.0)
            assert painted_towards(self.field, f"Circle {side}", sign * 41.5, 0.0)
        assert painted_towards(self.field, "Side line top", 0.0, 0.0)
        assert painted_towards(self.field, "Side line bottom", 0.0, 0.0)
        assert painted_towards(self.field, "Circle central", 0.0, 0.0)
        halfway = self.field.element("Middle line")
        assert halfway.inside is None  # both halves have half of it

    def test_lines_are_at_most_twelve_centimetres_wide(self):
        width = self.field.dimension("line_width")
        assert (width.nominal, width.maximum) == (0.12, 0.12)


class TestFutsal:
    """FIFA Futsal Laws of the Game, Law 1."""

    field = load_field("futsal")

    def test_the_pitch(self):
        sizes = {d.name: (d.minimum, d.maximum) for d in self.field.dimensions if d.is_open}
        assert sizes == {"length": (25.0, 42.0), "width": (16.0, 25.0)}
        assert line(self.field, "Touchline near") == Line((-20, 10, 0), (20, 10, 0))
        assert line(self.field, "Halfway line") == Line((0, -10, 0), (0, 10, 0))
        circle = geometry(self.field, "Centre circle")
        assert isinstance(circle, Circle)
        assert circle.radius == 3.0
        assert {e.line_width for e in self.field.elements if e.on_ground} == {0.08, 0.0}

    def test_penalty_areas_are_six_metres_about_the_outside_of_the_posts(self):
        for side, sign in SIDES:
            name = f"Penalty area line {side}"
            chain = geometry(self.field, name)
            assert isinstance(chain, Chain)
            first, straight, last = chain.parts
            assert isinstance(straight, Line)
            assert length_of(straight) == pytest.approx(3.16)
            assert length_of(first) == length_of(last) == pytest.approx(3 * math.pi)
            for place in places(self.field, name):
                post = np.array([sign * 20, np.clip(place[1], -1.58, 1.58), 0])
                assert np.linalg.norm(place - post) == pytest.approx(6.0, abs=CENTIMETRE)
                assert abs(place[0]) <= 20 + 1e-9

    def test_marks_and_goals(self):
        for side, sign in SIDES:
            assert geometry(self.field, f"Penalty mark {side}") == Spot((sign * 14, 0, 0))
            assert geometry(self.field, f"Second penalty mark {side}") == Spot((sign * 10, 0, 0))
            bar = line(self.field, f"Goal {side} crossbar")
            assert length_of(bar) == 3.0
            assert bar.start[2] == bar.end[2] == -2.0
            for row, ahead in (("far", -1), ("near", 1)):
                post = line(self.field, f"Goal {side} {row} post")
                assert post == Line((sign * 20, ahead * 1.5, -2), (sign * 20, ahead * 1.5, 0))
                arc = geometry(self.field, f"Corner arc {side} {row}")
                assert length_of(arc) == pytest.approx(0.25 * math.pi / 2)

    def test_substitution_zones_are_five_metres_from_the_halfway_line(self):
        zones = [e.geometry for e in self.field.elements if e.group == "Substitution zones"]
        assert sorted(middle_of(z)[0] for z in zones) == [-10, -10, -5, -5, 5, 5, 10, 10]
        assert all(length_of(z) == pytest.approx(0.8) for z in zones)

    def test_the_smallest_pitch_still_holds_its_penalty_areas(self):
        small = load_field("futsal", length=25, width=16)
        assert np.abs(places(small, "Penalty area line left")[:, 1]).max() <= 8.0


class TestHandball:
    """IHF Rules of the Game, Rule 1."""

    field = load_field("handball")

    @pytest.mark.parametrize(
        ("name", "radius"), [("Goal-area line", 6.0), ("Free-throw line", 9.0)]
    )
    def test_curves_keep_their_distance_from_the_posts(self, name, radius):
        for side, sign in SIDES:
            chain = geometry(self.field, f"{name} {side}")
            straight = parts_of(chain)[1]
            assert isinstance(straight, Line)
            assert length_of(straight) == pytest.approx(3.0)
            for place in places(self.field, f"{name} {side}"):
                post = np.array([sign * 20, np.clip(place[1], -1.5, 1.5), 0])
                assert np.linalg.norm(place - post) == pytest.approx(radius, abs=CENTIMETRE)

    def test_curves_end_at_the_goal_line_and_at_the_side_lines(self):
        for side, sign in SIDES:
            ends = places(self.field, f"Goal-area line {side}")[[0, -1]]
            assert np.allclose(ends, [[sign * 20, -7.5, 0], [sign * 20, 7.5, 0]])
            ends = places(self.field, f"Free-throw line {side}")[[0, -1]]
            away = 20 - math.sqrt(9**2 - 8.5**2)
            assert np.allclose(ends, [[sign * away, -10, 0], [sign * away, 10, 0]])

    def test_short_lines_and_goals(self):
        for side, sign in SIDES:
            for name, away, length in (("7-metre line", 7, 1.0), ("4-metre line", 4, 0.15)):
                found = geometry(self.field, f"{name} {side}")
                assert middle_of(found) == (sign * (20 - away), 0, 0)
                assert length_of(found) == pytest.approx(length)
                assert painted_towards(self.field, f"{name} {side}", sign * 20, 0)
            bar = line(self.field, f"Goal {side} crossbar")
            assert (length_of(bar), bar.start[2]) == (3.0, -2.0)
        area = geometry(self.field, "Throw-off area")
        assert isinstance(area, Circle)
        assert area.radius == 2.0
        for row, ahead in (("far", -1), ("near", 1)):
            for side, sign in SIDES:
                mark = geometry(self.field, f"Substitution line {row} {side}")
                assert middle_of(mark) == pytest.approx((sign * 4.5, ahead * 10, 0))
                assert length_of(mark) == pytest.approx(0.3)

    def test_the_court_has_one_size_and_lines_of_five_centimetres(self):
        assert {d.name for d in self.field.dimensions if d.is_open} == set()
        assert line(self.field, "Side line far") == Line((-20, -10, 0), (20, -10, 0))
        assert {e.line_width for e in self.field.elements if e.on_ground} == {0.05}


STRAIGHT, RADIUS, LANE = 84.39, 36.50, 1.22
LANES = range(1, 9)


def run_radius(lane: int) -> float:
    """Metres: where a lane is measured, 0.30 m from the kerb, 0.20 m from a line."""
    return RADIUS + (0.30 if lane == 1 else (lane - 1) * LANE + 0.20)


class TestAthletics:
    """World Athletics: Technical Rule 14, Track and Field Facilities Manual, 2.2 and its tables."""

    field = load_field("athletics")

    def test_a_lap_of_lane_one_is_400_metres(self):
        kerb = geometry(self.field, "Kerb")
        straights = [p for p in parts_of(kerb) if isinstance(p, Line)]
        bends = [p for p in parts_of(kerb) if isinstance(p, Arc)]
        assert [length_of(p) for p in straights] == pytest.approx([STRAIGHT] * 2)
        assert [p.radius for p in bends] == pytest.approx([RADIUS] * 2)
        assert length_of(kerb) == pytest.approx(398.12, abs=CENTIMETRE)
        lap = sum(map(length_of, straights)) + sum((p.radius + 0.30) * math.pi for p in bends)
        assert lap == pytest.approx(400.00, abs=CENTIMETRE)

    def test_lanes_are_as_wide_as_the_rules_say(self):
        for lane in LANES:
            edges = [
                parts_of(geometry(self.field, name))[1]
                for name in ("Kerb" if lane == 1 else f"Lane line {lane - 1}", f"Lane line {lane}")
            ]
            inner, outer = (e.radius for e in edges if isinstance(e, Arc))
            assert outer - inner == pytest.approx(LANE)

    def test_the_finish_and_the_straight_starts(self):
        finish = middle_of(geometry(self.field, "Finish line"))
        assert length_of(geometry(self.field, "Finish line")) == pytest.approx(8 * LANE)
        for name, away in (("100 m start", 100.0), ("110 m start", 110.0)):
            start = middle_of(geometry(self.field, name))
            assert math.dist(start, finish) == pytest.approx(away)
            assert painted_towards(self.field, name, *finish[:2])
        assert not painted_towards(self.field, "Finish line", 0.0, finish[1])

    @pytest.mark.parametrize(("race", "bends"), [(200, 1), (400, 2)])
    def test_starts_in_lanes_are_that_far_from_the_finish(self, race, bends):
        for lane in range(1 if race == 200 else 2, 9):
            angle = self.angle_of_start(race, lane)
            run = run_radius(lane) * (angle + (bends - 1) * math.pi) + bends * STRAIGHT
            assert run == pytest.approx(race, abs=CENTIMETRE), lane

    def test_staggers_of_the_800_metres_are_those_of_the_manual(self):
        manual = (3.526, 7.384, 11.259, 15.151, 19.061, 22.989, 26.933)
        for lane, expected in zip(LANES[1:], manual, strict=True):
            stagger = run_radius(lane) * (math.pi - self.angle_of_start(800, lane))
            assert stagger == pytest.approx(expected, abs=CENTIMETRE), lane

    def test_common_starts_are_equally_far_from_everywhere(self):
        for name, begin, centre in (
            ("10,000 m start", math.pi / 2, STRAIGHT / 2),
            ("5000 m start", 3 * math.pi / 2, -STRAIGHT / 2),
        ):
            curve = places(self.field, name, 0.05)[:, :2] - (centre, 0)
            away = np.linalg.norm(curve, axis=1)
            curve, away = curve[away > 36.80], away[away > 36.80]
            tangent = np.sqrt(away**2 - 36.80**2)
            angle = np.unwrap(np.arctan2(curve[:, 1], curve[:, 0]))
            angle += begin - angle[0]
            touched = begin - (angle - np.arctan2(tangent, 36.80))  # run of the tangent point
            assert np.abs(tangent - 36.80 * touched).max() < CENTIMETRE
            assert painted_beyond(self.field, name)

    def test_from_all_of_the_break_line_the_next_bend_is_equally_far(self):
        ways = []
        for x, y, _ in places(self.field, "Break line"):
            away = math.hypot(x + STRAIGHT / 2, y)
            turn = math.acos(36.80 / away) - math.atan2(x + STRAIGHT / 2, -y)
            ways.append(math.sqrt(away**2 - 36.80**2) - 36.80 * turn)
        assert np.ptp(ways) < CENTIMETRE
        assert ways[0] == pytest.approx(STRAIGHT, abs=CENTIMETRE)

    def angle_of_start(self, race: int, lane: int) -> float:
        """What is left of the bend at a lane's start, rad; the line itself spans the lane."""
        start = line(self.field, f"{race} m start lane {lane}")
        centre = np.array([-STRAIGHT / 2 if race == 200 else STRAIGHT / 2, 0])
        ends = np.array([start.start, start.end])[:, :2] - centre
        assert np.linalg.norm(ends, axis=1) == pytest.approx(
            [RADIUS + (lane - 1) * LANE, RADIUS + lane * LANE]
        )
        angle = math.atan2(ends[0, 1], ends[0, 0])
        bend_ends = math.pi / 2 if race == 200 else -math.pi / 2
        left = (angle - bend_ends) % (2 * math.pi)
        return left if left < 1.5 * math.pi else left - 2 * math.pi


def painted_beyond(field: Field, name: str) -> bool:
    """Whether the paint of a start line lies ahead of it, within the way that is run."""
    element = field.element(name)
    centre = math.copysign(STRAIGHT / 2, element.inside[0])
    ahead = math.atan2(element.inside[1], element.inside[0] - centre)
    x, y, _ = middle_of(element.geometry)
    return math.remainder(math.atan2(y, x - centre) - ahead, 2 * math.pi) > 0
