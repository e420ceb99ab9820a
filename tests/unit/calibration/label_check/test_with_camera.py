"""Wrong labels are found and explained with the camera of the others; right ones are left alone."""

import re
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px, points_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.candidate_classes import (
    MIRROR_X,
    MIRROR_Y,
    mirrored_names,
    relabelled,
)
from procc_annotator.calibration.label_check.check import check_labels
from procc_annotator.calibration.label_check.finding import RemedyKind, Rule, Severity
from procc_annotator.dataset.editing import change_class, move_point, swap_classes

SIZE = (960, 540)
FRONT, SMALL_FRONT = "Big rect. left main", "Small rect. left main"


@pytest.fixture(scope="module")
def clean(views) -> FrameAnnotation:
    return views.main(np.random.default_rng(51)).annotation


def check(annotation, field, *, model="R", size=SIZE):
    fit = fit_camera(annotation, field, model=model, size=size)
    return check_labels(annotation, field, size=size, fit=fit)


def test_plain_clicks_from_anywhere_are_neither_errors_nor_warnings(views, field):
    rng = np.random.default_rng(52)
    sides = set()
    for count in range(40):
        view = views.random(rng, at_least=1 + count % 6)
        found = check(view.annotation, field)
        assert [f.reason for f in found if f.severity is not Severity.HINT] == []
        sides.add(view.side)
    assert sides == {0, 1, 2, 3}


@pytest.mark.parametrize("model", ["R", "R+"])
def test_a_wrong_label_is_to_be_exchanged_for_the_one_that_fits(clean, field, model):
    found = check(change_class(clean, SMALL_FRONT, "Middle line"), field, model=model)
    (first, *rest) = found
    assert (first.rule, first.severity, first.elements) == (
        Rule.RESIDUAL,
        Severity.ERROR,
        ("Middle line",),
    )
    assert first.remedies[0].kind is RemedyKind.RELABEL
    assert first.remedies[0].renamed == (("Middle line", SMALL_FRONT),)
    assert first.remedies[0].text == "relabel to Left goal area front"
    assert first.remedies[-1].kind is RemedyKind.LOOK
    assert "it lies where Left goal area front should be" in first.reason
    assert all(f.severity is Severity.HINT for f in rest)


def test_the_reason_tells_what_the_others_say(clean, field):
    (found, *_) = check(change_class(clean, SMALL_FRONT, "Middle line"), field)
    told = re.search(
        r"without Halfway line the others drop from ([\d.]+) to ([\d.]+) px", found.reason
    )
    assert float(told[1]) > 10 * float(told[2])
    assert float(told[2]) < 4


def test_distances_are_told_in_the_pixels_of_the_picture(clean, field):
    wrong = change_class(clean, "Big rect. left top", "Middle line")
    small, large = (check(wrong, field, size=size)[0] for size in (SIZE, (1919, 1079)))
    assert large.error_px == pytest.approx(2 * small.error_px, rel=0.02)
    assert small.elements == large.elements


@pytest.mark.parametrize(
    "pair",
    [
        (FRONT, SMALL_FRONT),
        ("Big rect. left top", "Small rect. left top"),
        ("Goal left post left ", "Goal left post right"),
        ("Side line left", "Circle left"),
    ],
)
def test_two_labels_that_are_swapped_are_one_finding(clean, field, pair):
    (first, *rest) = check(swap_classes(clean, *pair), field)
    assert (first.rule, first.severity) == (Rule.SWAPPED, Severity.ERROR)
    assert set(first.elements) == set(pair)
    assert first.remedies[0].kind is RemedyKind.SWAP
    assert dict(first.remedies[0].renamed) == {pair[0]: pair[1], pair[1]: pair[0]}
    for name in pair:
        assert field.title_of(name) in first.reason
    assert all(f.severity is Severity.HINT for f in rest)


def test_a_short_end_waits_until_the_labels_are_right(clean, field):
    points = points_px(clean.get(SMALL_FRONT), SIZE)
    points[-1] -= 20 * (points[-1] - points[0]) / np.hypot(*(points[-1] - points[0]))
    ends = tuple(point_from_px(x, y, SIZE) for x, y in points[[0, -1]])
    short = clean.with_polyline(Polyline(SMALL_FRONT, ends))
    assert {f.rule for f in check(short, field)} == {Rule.SHORT}
    wrong = swap_classes(short, FRONT, "Side line left")
    assert {f.rule for f in check(wrong, field)} == {Rule.SWAPPED}


def test_three_labels_in_a_circle_are_one_finding(clean, field):
    names = (FRONT, SMALL_FRONT, "Side line left")
    becomes = dict(zip(names, (*names[1:], names[0]), strict=True))
    (first, *_) = check(relabelled(clean, becomes), field)
    assert (first.rule, set(first.elements)) == (Rule.SWAPPED, set(names))
    back = {new: old for old, new in becomes.items()}
    assert first.remedies[0].kind is RemedyKind.RELABEL
    assert dict(first.remedies[0].renamed) == back


def test_two_independent_mistakes_are_explained_together(clean, field):
    wrong = swap_classes(clean, "Goal left post left ", "Goal left post right")
    wrong = change_class(wrong, "Big rect. left top", "Middle line")
    found = [f for f in check(wrong, field) if f.severity is Severity.ERROR]
    assert {(f.rule, f.elements[0]) for f in found} >= {(Rule.RESIDUAL, "Middle line")}
    assert {f.rule for f in found} == {Rule.RESIDUAL, Rule.SWAPPED}
    assert all("without" in f.reason for f in found)


@pytest.mark.parametrize("name", ["Side line left", "Circle left"])
def test_one_bad_point_is_named(clean, field, name):
    points = points_px(clean.get(name), SIZE)
    index = len(points) // 2
    along = points[index] - points[index - 1]
    across = np.array([-along[1], along[0]]) / np.hypot(*along)
    moved = points[index] + 15 * across
    (first, *rest) = check(
        move_point(clean, name, index, point_from_px(moved[0], moved[1], SIZE)), field
    )
    assert (first.rule, first.severity, first.elements) == (Rule.POINT, Severity.ERROR, (name,))
    assert first.point == index
    assert f"point {index + 1} of {field.title_of(name)}" in first.reason
    assert [r.kind for r in first.remedies] == [RemedyKind.REMOVE_POINT, RemedyKind.LOOK]
    assert 10 < first.error_px < 20
    assert all(f.severity is Severity.HINT for f in rest)


def test_of_two_points_the_bad_one_is_shown_but_not_removed(clean, field):
    name = "Small rect. left top"
    points = points_px(clean.get(name), SIZE)[[0, -1]]
    points[1, 1] += 40
    two = Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in points))
    (first, *_) = check(clean.with_polyline(two), field)
    assert first.elements == (name,)
    assert RemedyKind.REMOVE_POINT not in {r.kind for r in first.remedies}
    assert first.severity is Severity.ERROR


@pytest.mark.parametrize("signs", [MIRROR_X, MIRROR_Y])
def test_a_reflected_frame_is_one_finding(clean, field, signs):
    wrong = relabelled(clean, mirrored_names(field, signs))
    (first, *rest) = check(wrong, field)
    assert (first.rule, first.severity) == (Rule.REFLECTED, Severity.ERROR)
    # The first remedy puts the camera on the near side, where the main camera stands.
    mended = relabelled(wrong, dict(first.remedies[0].renamed))
    fit = fit_camera(mended, field)
    assert fit.camera.position_world[1] > 0
    assert max(e.max_px for e in fit.elements) < 9
    assert {r.text for r in first.remedies} == {
        "exchange left and right in the whole frame",
        "exchange far and near in the whole frame",
    }
    assert all(f.severity is Severity.HINT for f in rest)


def test_the_other_end_of_the_field_is_no_mistake(clean, field):
    """Half a turn is a symmetry of everything: it cannot be seen."""
    turned = relabelled(clean, dict(field.symmetries[0].partner))
    assert all(f.severity is Severity.HINT for f in check(turned, field))


def test_what_only_a_poor_model_does_not_fit_is_right(views, field):
    """A wide-angle picture: no camera without distortion fits it, but one with it does."""
    camera = replace(
        views.main(np.random.default_rng(53)).camera,
        focal_px=(700.0, 700.0),
        radial=(0.3, 0.0, 0.0, 0.0, 0.0, 0.0),
    )
    annotation = views.clicks(camera, np.random.default_rng(53), 0.5)
    fit = fit_camera(annotation, field, model="P")
    assert max(e.max_px for e in fit.elements) > 9
    assert all(f.severity is Severity.HINT for f in check(annotation, field, model="P"))


def test_mistakes_are_found_under_a_homography(clean, field):
    (first, *_) = check(swap_classes(clean, FRONT, SMALL_FRONT), field, model="H")
    assert (first.rule, set(first.elements)) == (Rule.SWAPPED, {FRONT, SMALL_FRONT})


def test_one_line_under_two_names_is_told_once(clean, field):
    twice = clean.with_polyline(Polyline("Middle line", clean.get(FRONT).points))
    (first, *rest) = check(twice, field)
    assert first.elements == ("Middle line",)
    assert "it lies on Left penalty front, which is annotated as well" in first.reason
    assert [r.kind for r in first.remedies] == [RemedyKind.LOOK]
    assert all(f.severity is Severity.HINT for f in rest)


def test_few_contradicting_elements_are_a_warning(clean, field):
    """With three elements nobody can tell which one is wrong."""
    few = FrameAnnotation(
        tuple(p for p in clean if p.class_name in (FRONT, "Circle left", "Big rect. left top"))
    )
    wrong = swap_classes(few, FRONT, "Big rect. left top")
    found = check(wrong, field)
    assert Severity.ERROR not in {f.severity for f in found if f.rule is Rule.RESIDUAL}


def test_too_few_clicks_are_no_contradiction(clean, field):
    """Three elements, one of them a single point: nothing is known to be wrong yet."""
    names = (FRONT, "Big rect. left top", "Side line top")
    begun = FrameAnnotation(
        tuple(
            Polyline(p.class_name, p.points[: 1 if p.class_name == names[-1] else 2])
            for p in clean
            if p.class_name in names
        )
    )
    assert len(begun.annotated) == 3
    assert fit_camera(begun, field).camera is None
    assert {f.rule for f in check(begun, field)} <= {Rule.FEW_POINTS, Rule.SHORT}


@pytest.mark.parametrize(
    "seed", [2, 3, *(pytest.param(n, marks=pytest.mark.soak) for n in (0, 1, *range(4, 30)))]
)
def test_nonsense_is_survived(field, seed):
    rng = np.random.default_rng(seed)
    names = [e.name for e in field.elements]
    spread = 10.0 ** rng.uniform(-3, 3)
    annotation = FrameAnnotation(
        tuple(
            Polyline(
                str(name),
                tuple(
                    point_from_px(*p, SIZE)
                    for p in rng.normal(400, 500 * spread, (rng.integers(1, 6), 2))
                ),
            )
            for name in rng.choice(names, size=int(rng.integers(1, 9)), replace=False)
        )
    )
    for found in check(annotation, field):
        assert found.elements
        assert found.remedies
        assert found.reason
        assert not found.reason.endswith(".")
        assert "nan" not in found.reason


def test_nobody_waits_for_an_explanation_that_is_not_wanted(clean, field):
    class Enough(Exception):
        pass

    def stop() -> None:
        raise Enough

    wrong = swap_classes(clean, FRONT, SMALL_FRONT)
    fit = fit_camera(wrong, field)
    with pytest.raises(Enough):
        check_labels(wrong, field, size=SIZE, fit=fit, go_on=stop)
    right = fit_camera(clean, field)
    check_labels(clean, field, size=SIZE, fit=right, go_on=stop)  # no further fit, no question
