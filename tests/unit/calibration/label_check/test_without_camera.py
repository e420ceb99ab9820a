"""Rules that need no camera: they speak up for a mistake and stay silent for plain clicks."""

import tracemalloc
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px, points_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.check import (
    add_line_evidence,
    check_labels,
    check_without_camera,
)
from procc_annotator.calibration.label_check.evidence import LineEvidence, LinePresence
from procc_annotator.calibration.label_check.finding import Finding, RemedyKind, Rule, Severity
from procc_annotator.calibration.result import FitResult

SIZE = (960, 540)
MAIN, FAR, NEAR = "Big rect. left main", "Big rect. left top", "Big rect. left bottom"
GOAL_LINE = "Side line left"


def line(name: str, *points: tuple[float, float], size=SIZE) -> Polyline:
    return Polyline(name, tuple(point_from_px(x, y, size) for x, y in points))


def check(field, *polylines: Polyline, size=SIZE) -> tuple[Finding, ...]:
    annotation = FrameAnnotation(polylines)
    return check_labels(annotation, field, size=size, fit=fit_camera(annotation, field, size=size))


def rules(findings) -> list[Rule]:
    return [finding.rule for finding in findings]


def ellipse(count: int, *, begin=0.0, turns=1.0, centre=(480, 300), axes=(200, 60)) -> Polyline:
    angles = begin + 2 * np.pi * turns * np.arange(count) / count
    return line(
        "Circle central",
        *np.column_stack(
            [centre[0] + axes[0] * np.cos(angles), centre[1] + axes[1] * np.sin(angles)]
        ).tolist(),
    )


# ------------------------------------------------------------------------------------------ bent


@pytest.mark.parametrize(
    ("off", "severity"), [(16, Severity.WARNING), (40, Severity.ERROR), (-40, Severity.ERROR)]
)
def test_a_bent_line_is_told(field, off, severity):
    (found,) = check(field, line(MAIN, (300, 200), (350, 290 + off), (400, 380)))
    assert (found.rule, found.severity, found.elements) == (Rule.BENT, severity, (MAIN,))
    assert "Left penalty front" in found.reason
    assert found.remedies[0].kind is RemedyKind.LOOK


@pytest.mark.parametrize("size", [(960, 540), (1920, 1080)])
@pytest.mark.parametrize("kappa", [-0.11, 0.0, 0.1, 0.25])
def test_a_line_as_bent_as_a_lens_bends_it_is_none(field, size, kappa):
    """A line along the upper edge, where a lens bends most: barrel below 0, pincushion above."""
    half = np.hypot(*size) / 2
    straight = np.column_stack([np.linspace(-0.45, 0.45, 6) * size[0], np.full(6, -0.4 * size[1])])
    bent = straight * (1 + kappa * (straight**2).sum(axis=1) / half**2)[:, None]
    points = bent + np.array(size) / 2
    assert check(field, line("Side line top", *points.tolist(), size=size), size=size) == ()


def test_one_bad_point_of_many_is_named_and_can_be_removed(field):
    points = [(100 + 60 * i, 200 + 20 * i) for i in range(6)]
    points[2] = (points[2][0], points[2][1] + 60)
    (found,) = check(field, line("Side line top", *points))
    assert (found.rule, found.point) == (Rule.BENT, 2)
    assert found.remedies[0].kind is RemedyKind.REMOVE_POINT
    assert "point 3" in found.remedies[0].text


@pytest.mark.parametrize("bad", [None, 15_000])
def test_memory_does_not_grow_with_the_square_of_the_points(field, bad):
    """Nor are many points near each other taken for one."""
    points = np.linspace((100.0, 250.0), (860.0, 290.0), 20_000)
    if bad is not None:
        points[bad, 1] += 60
    tracemalloc.start()
    found = check(field, line("Side line top", *points.tolist()))
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert [finding.point for finding in found if finding.rule is Rule.BENT] == (
        [] if bad is None else [bad]
    )
    assert all(finding.rule is not Rule.FEW_POINTS for finding in found)
    assert peak < 60e6


# -------------------------------------------------------------------------------- number and order


@pytest.mark.parametrize(
    ("count", "severity"),
    [(2, Severity.WARNING), (3, Severity.WARNING), (4, Severity.HINT), (5, None), (9, None)],
)
def test_a_circle_of_too_few_points(field, count, severity):
    found = check(field, ellipse(count))
    assert [f.severity for f in found] == ([] if severity is None else [severity])
    if severity is not None:
        assert found[0].rule is Rule.FEW_POINTS
        assert "Centre circle" in found[0].reason


def test_points_at_one_place_are_one_point(field):
    (found,) = check(field, line(MAIN, (300, 200), (300, 200.3)))
    assert (found.rule, found.severity) == (Rule.FEW_POINTS, Severity.WARNING)
    assert "1 point" in found.reason


@pytest.mark.parametrize(
    "places",
    [
        (0, 0.5, 1, 0.02, 0.5, 0.98),  # along it, then again
        (0, 0.5, 1, 0.98, 0.5, 0.02),  # along it and back
        (0, 1, 0, 1),
    ],
)
def test_a_line_clicked_twice(field, places):
    points = [(200 + 400 * t, 300 - 100 * t + 2 * (i % 2)) for i, t in enumerate(places)]
    (found,) = check(field, line(MAIN, *points))
    assert (found.rule, found.severity) == (Rule.REPEATED, Severity.WARNING)
    assert "more than once" in found.reason


def test_points_out_of_order_are_a_hint(field):
    points = [(200 + 400 * t, 300) for t in (0, 1, 0.5)]
    (found,) = check(field, line(MAIN, *points))
    assert (found.rule, found.severity) == (Rule.REPEATED, Severity.HINT)


def test_a_circle_clicked_twice_and_one_clicked_once(field):
    (found,) = check(field, ellipse(18, turns=2.05))
    assert (found.rule, found.severity) == (Rule.REPEATED, Severity.WARNING)
    closed = ellipse(9)
    assert check(field, Polyline(closed.class_name, (*closed.points, closed.points[0]))) == ()
    edge_on = ellipse(12, axes=(200, 3))  # near and far side in one place
    assert check(field, edge_on) == ()


# -------------------------------------------------------------------------------------- coincident


def test_one_line_under_two_names(field):
    first = line(MAIN, (300, 200), (350, 290), (400, 380))
    again = line("Small rect. left main", (302, 202), (399, 380))
    (found,) = check(field, first, again)
    assert (found.rule, found.severity) == (Rule.COINCIDENT, Severity.WARNING)
    assert set(found.elements) == {MAIN, "Small rect. left main"}
    assert "Left penalty front" in found.reason
    assert "Left goal area front" in found.reason


@pytest.mark.parametrize(
    ("other", "points"),
    [
        ("Small rect. left main", ((330, 195), (430, 375))),  # beside it
        (FAR, ((300, 200), (120, 210))),  # meets it at its end
        ("Side line top", ((200, 280), (500, 300))),  # crosses it
    ],
)
def test_lines_that_meet_or_run_side_by_side_are_apart(field, other, points):
    found = check(field, line(MAIN, (300, 200), (350, 290), (400, 380)), line(other, *points))
    assert Rule.COINCIDENT not in rules(found)


def test_a_crossbar_may_hide_the_goal_line(field):
    found = check(
        field,
        line("Goal left crossbar", (300, 200), (400, 210)),
        line(GOAL_LINE, (250, 195), (450, 215)),
    )
    assert found == ()


# -------------------------------------------------------------------------------------------- ends


def test_an_end_short_of_its_corner_is_a_hint(field):
    front = line(MAIN, (600, 200), (640, 480))
    (found,) = check(field, line(FAR, (300, 190), (575, 200)), front)
    assert (found.rule, found.severity, found.elements) == (Rule.SHORT, Severity.HINT, (FAR,))
    assert "25 px short of its corner" in found.reason
    assert found.model is None


def test_an_end_short_of_the_picture_edge_is_a_hint(field):
    (found,) = check(field, line("Side line top", (20, 100), (700, 120)))
    assert (found.rule, found.severity) == (Rule.SHORT, Severity.HINT)
    assert "20 px short of the picture's edge" in found.reason


@pytest.mark.parametrize(
    "polylines",
    [
        [(FAR, (300, 190), (598, 200)), (MAIN, (600, 200), (640, 480))],  # near enough
        [(FAR, (300, 190), (500, 198)), (MAIN, (600, 200), (640, 480))],  # hidden, or worn
        [("Side line top", (-3, 100), (700, 120))],
        # The goal line goes on where the penalty area begins.
        [(GOAL_LINE, (300, 100), (300, 180)), (FAR, (300, 200), (500, 205))],
    ],
)
def test_ends_that_are_in_order(field, polylines):
    assert check(field, *(line(*polyline) for polyline in polylines)) == ()


def test_a_camera_knows_where_a_line_ends(views, field):
    """A corner that no other element shows."""
    view = views.main(np.random.default_rng(3), noise_px=0.3)
    name = "Small rect. left main"
    points = points_px(view.annotation.get(name), SIZE)
    along = (points[-1] - points[0]) / np.hypot(*(points[-1] - points[0]))
    points[-1] -= 20 * along
    shortened = [p for p in view.annotation if not p.class_name.startswith("Small rect. left ")]
    annotation = FrameAnnotation((*shortened, line(name, points[0], points[-1])))
    fit = fit_camera(annotation, field)
    (found,) = check_labels(annotation, field, size=SIZE, fit=fit)
    assert (found.rule, found.elements) == (Rule.SHORT, (name,))
    assert "short of its corner" in found.reason
    assert found.model == "R"  # it says something of the camera


# --------------------------------------------------------------------------------- what is no label


def test_nothing_is_said_about_what_has_no_place_on_the_field(field):
    annotation = FrameAnnotation(
        (
            line("Line unknown", (100, 100), (200, 300), (300, 100)),
            Polyline(MAIN, ()),
            Polyline(FAR, (Point(float("nan"), 0.2), Point(0.4, 0.3), Point(0.2, 0.3))),
        ),
        unconfirmed=(line(NEAR, (100, 100), (200, 300), (300, 100)),),
    )
    assert check_labels(annotation, field, size=SIZE, fit=fit_camera(annotation, field)) == ()
    assert check(field) == ()


# What a picture shows under elements, given as data: findings where it is none, or beside.

NO_FIT = FitResult("", SIZE, None, failure="not asked for")
NAMES = ("Goal left crossbar", "Side line left", "Big rect. left main")
NOTHING = (np.zeros(0), np.zeros(0))
NAN = float("nan")


def px_line(name: str, *places: tuple[float, float]) -> Polyline:
    return Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in places))


def seen(*offsets: float, length: float = 200.0) -> LineEvidence:
    count = len(offsets)
    places = np.column_stack([np.linspace(100, 100 + length, count), np.full(count, 200.0)])
    each = np.full(count, length / count)
    zeros = np.zeros(count, dtype=np.intp)
    return LineEvidence(SIZE, places, np.array(offsets), zeros, each, (NOTHING, NOTHING))


GOOD = seen(*[0.1] * 12)


def findings(field, paint: dict[str, LineEvidence]) -> list[Finding]:
    polylines = [px_line(n, (100, 100 + 80 * k), (300, 100 + 80 * k)) for k, n in enumerate(NAMES)]
    annotation = FrameAnnotation(tuple(polylines))
    told = add_line_evidence((), annotation, field, size=SIZE, fit=NO_FIT, paint=paint)
    return [f for f in told if f.elements[0] == NAMES[0]]


def found(field, paint: dict[str, LineEvidence]) -> list[tuple[Rule, Severity, str]]:
    return [(f.rule, f.severity, f.reason) for f in findings(field, paint)]


def test_a_crossbar_on_spectators_is_found_with_share_and_length(field):
    crowd = seen(3.1, NAN, -4.0, 5.5, NAN, -2.0, 4.4, NAN, 0.2, -5.0, NAN, 2.6)
    (told,) = found(field, {NAMES[0]: crowd, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert told[:2] == (Rule.NO_PAINT, Severity.WARNING)
    assert "100 % of Left crossbar" in told[2]
    assert "longest gap 200 px" in told[2]
    half = seen(*[0.2] * 5, *[NAN] * 7)
    (told,) = found(field, {NAMES[0]: half, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert told[:2] == (Rule.NO_PAINT, Severity.HINT)


@pytest.mark.parametrize(
    "offsets", [[0.4] * 12, [*[0.3] * 8, *[NAN] * 4], [1.5, 1.2, 0.9, 0.5, 0.2, 0.0] * 2]
)
def test_what_players_hide_is_no_finding(field, offsets):
    assert found(field, {NAMES[0]: seen(*offsets), NAMES[1]: GOOD, NAMES[2]: GOOD}) == []


def test_a_picture_in_which_hardly_any_paint_is_found_says_nothing(field):
    dark = seen(*[NAN] * 12)
    assert found(field, dict.fromkeys(NAMES, dark)) == []
    assert found(field, {}) == []


def test_bent_paint_beside_a_straight_element_is_told_with_what_mends_it(field):
    t = np.linspace(-1, 1, 12)
    bent = seen(*(4.0 * (1 - t**2)))
    (told,) = found(field, {NAMES[0]: bent, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert told[:2] == (Rule.BESIDE_PAINT, Severity.WARNING)
    assert "up to 4 px" in told[2]
    assert "Press R" in told[2]
    assert set(bent.paint) == {LinePresence.UNDER, LinePresence.RIGHT}
    missing = seen(*np.where(np.abs(t) > 0.4, NAN, 4.0))
    assert Rule.BESIDE_PAINT not in [
        f[0] for f in found(field, {NAMES[0]: missing, NAMES[1]: GOOD, NAMES[2]: GOOD})
    ]


@pytest.mark.parametrize("at_first", [True, False])
def test_an_end_beside_its_paint_is_told_with_its_point(field, at_first):
    """The way there leaves the paint steadily, until it is too far off to be looked for."""
    off = [*(7.0 * (np.arange(9) + 0.5) / 12), NAN, NAN, NAN]
    astray = seen(*(off[::-1] if at_first else off))
    (told,) = findings(field, {NAMES[0]: astray, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert (told.rule, told.severity) == (Rule.BESIDE_PAINT, Severity.WARNING)
    assert "is 7 px off the line" in told.reason
    assert told.point == (0 if at_first else 1)
    near = seen(*(2.0 * (np.arange(12) + 0.5) / 12))  # as a hand clicks
    assert found(field, {NAMES[0]: near, NAMES[1]: GOOD, NAMES[2]: GOOD}) == []


def test_an_end_without_paint_is_told_where_all_else_has_some(field):
    places = replace(seen(*[0.1] * 9, *[NAN] * 3), segments=np.repeat([0, 1, 2, 3], 3))
    (told,) = findings(field, {NAMES[0]: places, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert (told.rule, told.severity, told.point) == (Rule.NO_PAINT, Severity.HINT, 1)
    assert "one end of" in told.reason


def test_a_short_post_without_paint_is_told(field):
    nothing = seen(NAN, NAN, NAN, length=24.0)
    (told,) = found(field, {NAMES[0]: nothing, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert told[:2] == (Rule.NO_PAINT, Severity.HINT)
    assert found(field, {NAMES[1]: nothing, NAMES[0]: GOOD, NAMES[2]: GOOD}) == []


def test_an_end_is_short_only_where_paint_goes_on(field):
    annotation = FrameAnnotation((px_line("Side line top", (20, 100), (700, 120)),))
    told = check_without_camera(annotation, field, size=SIZE)
    assert [f.rule for f in told] == [Rule.SHORT]
    ahead = np.arange(3.0, 24.0, 6.0)
    for offsets, rules in ((np.full(4, NAN), []), (np.full(4, 0.3), [Rule.SHORT])):
        paint = {"Side line top": replace(GOOD, ahead=((ahead, offsets), NOTHING))}
        again = add_line_evidence(told, annotation, field, size=SIZE, fit=NO_FIT, paint=paint)
        assert [f.rule for f in again] == rules
