"""The way round things lie: the same in every picture taken from above the ground."""

import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from procc_annotator import load_annotation
from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.assist.frame_analysis import apply_remedy, rename_classes
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.candidate_classes import (
    MIRROR_X,
    MIRROR_Y,
    mirrored_names,
    relabelled,
)
from procc_annotator.calibration.label_check.check import (
    FittedPosition,
    OppositeSideFrame,
    check_labels,
    find_opposite_frames,
    fitted_position,
    opposite_side_finding,
)
from procc_annotator.calibration.label_check.evidence import annotated_elements
from procc_annotator.calibration.label_check.finding import Finding, RemedyKind, Rule, Severity
from procc_annotator.calibration.label_check.side_rules import (
    contradictions,
    orientation_relations,
    wrong_side_findings,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.editing import swap_classes
from procc_annotator.dataset.review import check_without_fit
from procc_annotator.field.load import load_field
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup
from tests.drawn_shots import looking_at

SIZE = (960, 540)
FRAME = ImageFrame(SIZE)


def look(annotation, field):
    return contradictions(annotated_elements(annotation, field, FRAME), field, FRAME)


def findings(annotation, field):
    return wrong_side_findings(annotated_elements(annotation, field, FRAME), field, FRAME)


def test_no_camera_above_the_ground_contradicts_the_field(views, field):
    rng = np.random.default_rng(41)
    oriented = 0
    for _ in range(40):
        view = views.random(rng, at_least=3)
        found = look(view.annotation, field)
        assert found.all == ()
        oriented += found.kept > 0
        turned = relabelled(
            view.annotation, dict(field.symmetries[0].partner)
        )  # half a turn is no contradiction
        assert look(turned, field).all == ()
    assert oriented > 20


def test_orientations_of_the_field_are_those_of_its_points(field):
    """The table of triples, against points chosen at random on the elements."""
    known = orientation_relations(field.elements)
    place = {name: row for row, name in enumerate(known.rows)}
    rng = np.random.default_rng(42)
    checked = 0
    for _ in range(400):
        names = [str(name) for name in rng.choice(known.rows, 3, replace=False)]
        a, b, c = (_some_point(field.element(name).geometry, rng) for name in names)
        turn = np.linalg.det([[*a, 1], [*b, 1], [*c, 1]])
        said = known.triples[place[names[0]], place[names[1]], place[names[2]]]
        assert said * turn >= 0
        checked += said != 0
    assert checked > 100


def _some_point(shape, rng) -> np.ndarray:
    if hasattr(shape, "position"):
        return np.array(shape.position[:2])
    if hasattr(shape, "start"):
        share = rng.random()
        return (1 - share) * np.array(shape.start[:2]) + share * np.array(shape.end[:2])
    low = getattr(shape, "start_rad", 0.0)
    angle = rng.uniform(low, getattr(shape, "end_rad", 2 * np.pi))
    return np.array(shape.centre[:2]) + shape.radius * np.array([np.cos(angle), np.sin(angle)])


@pytest.mark.parametrize("signs", [MIRROR_X, MIRROR_Y])
def test_a_reflected_frame_is_all_turned(views, field, signs):
    view = views.main(np.random.default_rng(43))
    (found,) = findings(relabelled(view.annotation, mirrored_names(field, signs)), field)
    assert (found.rule, found.severity) == (Rule.REFLECTED, Severity.ERROR)
    names = mirrored_names(field, signs)
    assert any(all(names[old] == new for old, new in remedy.renamed) for remedy in found.remedies)


def test_an_element_on_the_wrong_side_is_named(views, field):
    """Four elements; one of them on the other side of the others."""
    view = views.main(np.random.default_rng(44))
    kept = ("Big rect. left main", "Big rect. left top", "Small rect. left top", "Side line top")
    few = FrameAnnotation(tuple(p for p in view.annotation if p.class_name in kept))
    assert findings(few, field) == ()
    wrong = relabelled(few, {"Side line top": "Side line bottom"})
    (found,) = findings(wrong, field)
    assert found.rule is Rule.SIDE
    assert "Side line bottom" in found.elements


def test_two_elements_on_each_others_side_are_to_be_swapped(views, field):
    view = views.main(np.random.default_rng(45))
    pair = ("Big rect. left main", "Small rect. left main")
    (found,) = findings(swap_classes(view.annotation, *pair), field)
    swaps = [r.renamed for r in found.remedies if r.kind is RemedyKind.SWAP]
    assert (pair, pair[::-1]) in swaps or (pair[::-1], pair) in swaps


def test_two_exchanged_keypoints_are_named(field):
    """Corners that elements share, as of keypoints made lines: no element is wrong as a whole."""
    camera = looking_at((0.0, 90.0, -40.0), (0.0, 5.0, 0.0), 700.0, SIZE)
    lines = [e for e in field.elements if e.on_ground and e.is_straight]
    ends = {e.name: camera.project(np.array([e.geometry.start, e.geometry.end]))[0] for e in lines}

    def annotation(exchanged: dict[tuple[float, ...], tuple[float, ...]]) -> FrameAnnotation:
        places = {
            name: [exchanged.get(p, p) for p in map(tuple, px.round(1).tolist())]
            for name, px in ends.items()
        }
        return FrameAnnotation(
            tuple(
                Polyline(name, tuple(Point(x / 959, y / 539) for x, y in points))
                for name, points in places.items()
            )
        )

    def check(annotation: FrameAnnotation) -> tuple[Finding, ...]:
        fit = fit_camera(annotation, field, size=SIZE)
        return check_labels(annotation, field, size=SIZE, fit=fit)

    assert check(annotation({})) == ()
    one, other = (
        tuple(ends[name][0 if name.startswith("Big") else -1].round(1).tolist())
        for name in ("Big rect. right main", "Side line right")
    )
    found, *rest = check(annotation({one: other, other: one}))
    assert Severity.ERROR not in {finding.severity for finding in rest}
    assert found.severity is Severity.ERROR
    assert "two points are exchanged" in found.reason
    assert set(found.elements) == {
        "Big rect. right main", "Big rect. right top", "Side line right", "Side line bottom",
    }  # fmt: skip


def test_sides_are_told_where_there_is_no_camera(views, field):
    """Three lines across the field, the middle one called an outer one."""
    camera = replace(
        views.main(np.random.default_rng(46)).camera, pan_rad=0.0, focal_px=(600.0, 600.0)
    )
    every = views.clicks(camera, np.random.default_rng(46))
    kept = ("Big rect. left main", "Middle line", "Big rect. right main")
    few = FrameAnnotation(tuple(p for p in every if p.class_name in kept))
    none = FitResult("R", SIZE, None, "not fitted")
    assert check_labels(few, field, size=SIZE, fit=none)[0].rule is not Rule.SIDE
    wrong = swap_classes(few, "Big rect. left main", "Middle line")
    told = check_labels(wrong, field, size=SIZE, fit=none)
    (found,) = [f for f in told if f.rule is Rule.SIDE]
    assert found.severity is Severity.WARNING
    assert set(found.elements) == {"Big rect. left main", "Middle line"}
    assert found.remedies[0].kind is RemedyKind.SWAP
    assert dict(found.remedies[0].renamed)["Middle line"] == "Big rect. left main"


# Turned labels are found in a set, told with a remedy, and only where they can be turned.

STAND = FittedPosition((0.0, -70.0, -16.0), ((0.1, 0, 0), (0, 1.0, 0), (0, 0, 0.1)), "R", True)
FOUND = OppositeSideFrame(5, 9, STAND)


@pytest.fixture(scope="module")
def frames(views) -> dict[str, FrameAnnotation]:
    rng = np.random.default_rng(8)
    made = {}
    for i, pan in enumerate(np.deg2rad([-28, -15, 4, 17, 30])):
        tilt = float(np.arctan2(np.hypot(70, 60 * np.tan(pan)), 16))
        camera = PinholeCamera(pan, tilt, 0.0, (0, 70, -16), (1700, 1700), (479.5, 269.5))
        made[f"f{i}"] = views.clicks(camera, rng)
    return made


def test_turned_frames_are_found_and_turned_back(frames, field):
    turned = {name: field.half_turn.name_of(name) for name in field.index}
    given = {n: relabelled(a, turned) if n == "f3" else a for n, a in frames.items()}
    stands = {name: fitted_position(fit_camera(a, field)) for name, a in given.items()}
    found = find_opposite_frames(stands, field)
    assert set(found) == {"f3"}
    finding = opposite_side_finding(given["f3"], field, found["f3"])
    assert (finding.rule, finding.severity) == (Rule.OTHER_SIDE, Severity.ERROR)
    (remedy,) = finding.remedies
    assert remedy.kind is RemedyKind.RELABEL
    mended = rename_classes(given["f3"], dict(remedy.renamed), field)
    assert mended == frames["f3"]


def test_a_homography_and_a_failed_fit_stand_nowhere(frames, field):
    assert fitted_position(fit_camera(frames["f1"], field, model="H")) is None
    assert fitted_position(fit_camera(FrameAnnotation(()), field)) is None


def test_a_field_whose_sides_differ_tells_by_itself(frames, field):
    stands = {name: fitted_position(fit_camera(a, field)) for name, a in frames.items()}
    stands["f0"] = replace(stands["f0"], position_m=(0.0, -70.0, -16.0))
    assert find_opposite_frames(stands, replace(field, symmetries=())) == {}


def test_labels_that_half_a_turn_leaves_as_they_are_say_nothing(field):
    middle = FrameAnnotation((Polyline("Middle line", (Point(0.2, 0.2), Point(0.3, 0.6))),))
    assert opposite_side_finding(middle, field, FOUND) is None


@pytest.mark.parametrize(
    ("found", "severity"),
    [
        (replace(FOUND, stand=replace(STAND, is_sure=False)), Severity.WARNING),
        (replace(FOUND, opposite=0), Severity.HINT),
    ],
)
def test_how_sure_it_is(frames, field, found, severity):
    finding = opposite_side_finding(frames["f2"], field, found)
    assert finding.severity is severity
    assert RemedyKind.RELABEL in {remedy.kind for remedy in finding.remedies}


# Class names the field does not know, and pixels where normalised coordinates belong.

FIELD = load_field()
SAMPLE = load_annotation(Path(__file__).parents[4] / "sample_data" / "00002.json")


def check(annotation: FrameAnnotation) -> tuple[Finding, ...]:
    fit = fit_camera(annotation, FIELD, size=SIZE)
    return check_labels(annotation, FIELD, size=SIZE, fit=fit)


def renamed(old: str, new: str) -> FrameAnnotation:
    return FrameAnnotation(
        tuple(
            replace(p, class_name=new) if p.class_name.strip() == old else p
            for p in SAMPLE.polylines
        )
    )


def of_rule(found: tuple[Finding, ...], rule: Rule) -> list[Finding]:
    return [f for f in found if f.rule is rule]


@pytest.mark.parametrize("slip", ["Side line tpo", "side line top", "Far touch line"])
def test_a_slip_in_a_name_is_an_error_with_the_right_name(slip):
    wrong = renamed("Side line top", slip)
    assert slip in wrong.annotated
    (found,) = of_rule(check(wrong), Rule.UNKNOWN_CLASS)
    assert (found.severity, found.elements) == (Severity.ERROR, (slip,))
    assert found.reason == (f"no such class: {slip!r}, did you mean Far touchline (Side line top)?")
    assert found.remedies[0].kind is RemedyKind.RELABEL
    mended = apply_remedy(wrong, found, found.remedies[0], FIELD)
    assert mended == SAMPLE
    assert of_rule(check(mended), Rule.UNKNOWN_CLASS) == []


def test_a_name_that_is_taken_is_not_offered():
    line = SAMPLE.get("Side line top")
    both = SAMPLE.with_polyline(Polyline("Side line tpo", line.points))
    (found,) = of_rule(check(both), Rule.UNKNOWN_CLASS)
    assert "annotated already" in found.reason
    assert [r.kind for r in found.remedies] == [RemedyKind.LOOK]


def test_names_like_no_other_are_a_warning_and_known_ones_nothing():
    points = (Point(0.1, 0.2), Point(0.3, 0.2))
    more = SAMPLE.with_polyline(Polyline("Advertising board", points))
    more = more.with_polyline(Polyline("Line unknown", points))
    more = more.with_polyline(Polyline("Corner flag", ()))  # absent
    found = of_rule(check(more), Rule.UNKNOWN_CLASS)
    assert [(f.elements, f.severity) for f in found] == [(("Advertising board",), Severity.WARNING)]
    assert "counts as missed where it is scored" in found[0].reason
    fit = fit_camera(more, FIELD, size=SIZE)
    assert fit.camera is not None
    scores = [
        score(measure(annotation, fit.camera, EvaluationSetup(FIELD, SIZE)), 5.0)
        for annotation in (SAMPLE, more)
    ]
    assert scores[1].fn > scores[0].fn
    without_fit = check_without_fit(more, FIELD, size=SIZE)
    assert Rule.UNKNOWN_CLASS in {f.finding.rule for f in without_fit.found}


def test_pixels_are_the_one_thing_that_is_told():
    pixels = FrameAnnotation(
        tuple(
            replace(p, points=tuple(Point(q.u * 959, q.v * 539) for q in p.points))
            for p in SAMPLE.polylines
        )
    )
    (found,) = check(pixels)
    assert (found.rule, found.severity) == (Rule.PIXELS, Severity.ERROR)
    assert "look like pixels, expected 0 to 1" in found.reason
    (alone,) = check_without_fit(pixels, FIELD, size=SIZE).found
    assert alone.finding == found


def test_points_in_one_place_or_on_one_line_make_no_noise():
    names = ("Middle line", "Side line top", "Side line bottom", "Big rect. left main")
    one_place = tuple(Polyline(n, (Point(0.4, 0.4),) * 2) for n in names)
    one_line = tuple(Polyline(n, (Point(0.1, 0.5), Point(0.9, 0.5))) for n in names)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for polylines in (one_place, one_line):
            check(FrameAnnotation(polylines))
