"""What follows from the clicks of one frame."""

import json

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px
from procc_annotator.assist.frame_analysis import (
    analyse_frame,
    apply_remedy,
    contradicts,
    ghosts_without_clicks,
    rename_classes,
)
from procc_annotator.calibration.label_check.finding import (
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
)
from procc_annotator.calibration.prediction.visible_elements import visible_stretches
from procc_annotator.calibration.result import FitResult, external_camera_fit
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation

FIELD = load_field()
SIZE = (1280, 720)
SOME = {"Big rect. left bottom", "Big rect. left main", "Big rect. left top", "Circle left"}


@pytest.fixture(scope="module")
def clicked(sample_data) -> FrameAnnotation:
    path = sample_data / "00002.json"
    annotation = read_annotation(path.read_bytes(), path=str(path), field=FIELD)
    return FrameAnnotation(tuple(p for p in annotation if p.class_name in SOME))


def test_out_of_sight_is_what_the_camera_has_nowhere_in_the_picture(clicked):
    insight = analyse_frame(clicked, FIELD, size=SIZE)
    assert insight.fit.camera is not None
    away = insight.out_of_sight(FIELD)
    seen = {s.name for s in visible_stretches(FIELD, insight.fit.camera, SIZE) if s.length_px > 20}
    assert seen
    assert not away & (seen | SOME)
    assert {"Side line right", "Goal right crossbar", "Circle right"} <= away
    assert "Penalty mark left" not in away
    assert {"Penalty mark right", "Corner arc right top"} <= away


def test_a_homography_says_nothing_of_what_is_off_the_ground(clicked):
    away = analyse_frame(clicked, FIELD, size=SIZE, model="H").out_of_sight(FIELD)
    assert "Circle right" in away
    assert all(element.on_ground for n in away if (element := FIELD.element(n)))


def test_without_a_camera_usual_views_say_what_is_hardly_in_sight(clicked, sample_data):
    one = FrameAnnotation(clicked.polylines[:1])
    away = analyse_frame(one, FIELD, size=SIZE).out_of_sight(FIELD)
    truth = json.loads((sample_data / "00002.json").read_text())
    assert not away & SOME
    assert {"Goal right crossbar", "Circle right", "Side line right"} <= away
    assert len(away & truth.keys()) < len(truth) / 3


# What a camera found without clicks tells of a frame.

SCORED_SIZE = (960, 540)
NOTHING = FrameAnnotation()


@pytest.fixture
def fit(sample_data) -> FitResult:
    found = CameraSet.open(sample_data / "cameras" / "true").camera("00002", SCORED_SIZE)
    return external_camera_fit(found.camera, SCORED_SIZE)


def clicked_off(fit: FitResult, name: str, off_px: float) -> FrameAnnotation:
    """Two points of the first piece of an element, moved aside."""
    ghost = next(g for g in ghosts_without_clicks(NOTHING, FIELD, fit).ghosts if g.name == name)
    course = ghost.pieces[0].points_px
    ends = course[[len(course) // 3, 2 * len(course) // 3]]
    along = (ends[1] - ends[0]) / np.hypot(*(ends[1] - ends[0]))
    ends = ends + off_px * np.array([-along[1], along[0]])
    points = tuple(point_from_px(x, y, SCORED_SIZE) for x, y in ends.tolist())
    return NOTHING.with_polyline(Polyline(name, points))


def test_ghosts_without_a_click(fit):
    insight = ghosts_without_clicks(NOTHING, FIELD, fit)
    names = [ghost.name for ghost in insight.ghosts]

    assert not insight.from_clicks
    assert "Big rect. left main" in names
    hidden = ghosts_without_clicks(NOTHING, FIELD, fit, frozenset(names[:1]))
    assert [ghost.name for ghost in hidden.ghosts] == names[1:]


@pytest.mark.parametrize(("off_px", "contradicted"), [(0.0, False), (6.0, False), (40.0, True)])
def test_clicks_elsewhere_end_it(fit, off_px, contradicted):
    annotation = clicked_off(fit, "Big rect. left main", off_px)

    assert contradicts(annotation, FIELD, fit) is contradicted
    insight = ghosts_without_clicks(annotation, FIELD, fit)
    assert (insight.fit.camera is None) is contradicted
    assert bool(insight.ghosts) is not contradicted


def test_an_element_out_of_sight_contradicts_it(fit):
    points = tuple(point_from_px(x, y, SCORED_SIZE) for x, y in ((300, 200), (500, 300)))
    annotation = NOTHING.with_polyline(Polyline("Big rect. right main", points))

    assert contradicts(annotation, FIELD, fit)


@pytest.mark.parametrize(("off_px", "by_clicks"), [(0.0, False), (12.0, True)])
def test_three_lines_are_judged_with_the_camera_that_they_agree_with(fit, off_px, by_clicks):
    names = "Big rect. left main", "Big rect. left bottom", "Small rect. left main"
    polylines = [clicked_off(fit, name, off_px).polylines[0] for name in names]
    annotation = FrameAnnotation(tuple(polylines))
    fitted = analyse_frame(annotation, FIELD, size=SCORED_SIZE)
    insight = ghosts_without_clicks(annotation, FIELD, fit, fitted=fitted)

    assert fitted.fit.camera is not None
    assert (insight is fitted) is by_clicks
    assert (len(insight.ghosts) > len(fitted.ghosts)) is not by_clicks


# A remedy is one pure edit: names exchanged all at once, points untouched, nothing lost.

A, B, C = "Big rect. left main", "Small rect. left main", "Middle line"


def polyline(name: str, *us: float) -> Polyline:
    return Polyline(name, tuple(Point(u, 0.5, (("seen", True),)) for u in us))


ANNOTATION = FrameAnnotation(
    (polyline(A, 0.1, 0.2), polyline(B, 0.3, 0.4, 0.5)), extra=(("note", "x"),)
)


def finding(*elements: str, point: int | None = None) -> Finding:
    return Finding(Rule.RESIDUAL, Severity.ERROR, elements, "why", (), point)


def remedy(kind: RemedyKind, *renamed: tuple[str, str]) -> Remedy:
    return Remedy(kind, "swap one and the other", renamed)


def test_a_swap_exchanges_names_and_keeps_points_and_order():
    swap = remedy(RemedyKind.SWAP, (A, B), (B, A))
    mended = apply_remedy(ANNOTATION, finding(A, B), swap)
    assert [p.class_name for p in mended] == [B, A]
    assert [p.points for p in mended] == [p.points for p in ANNOTATION]
    assert mended.extra == ANNOTATION.extra
    assert apply_remedy(mended, finding(A, B), swap) == ANNOTATION


def test_many_classes_are_renamed_at_once():
    three = FrameAnnotation((*ANNOTATION.polylines, polyline(C, 0.7)))
    mended = rename_classes(three, {A: B, B: C, C: A})
    assert [p.class_name for p in mended] == [B, C, A]


def test_an_empty_class_and_an_unconfirmed_one_give_way():
    annotation = FrameAnnotation(
        (*ANNOTATION.polylines, Polyline(C, ())), unconfirmed=(polyline(C, 0.9),)
    )
    mended = rename_classes(annotation, {A: C})
    assert [p.class_name for p in mended] == [C, B]
    assert mended.unconfirmed == ()


@pytest.mark.parametrize(
    ("names", "message"),
    [
        ({A: B}, "Left goal area front is annotated already"),
        ({A: C, B: C}, "Halfway line is annotated already"),
        ({C: "Circle left"}, "Halfway line is not annotated any more"),
    ],
)
def test_two_elements_never_become_one(names, message):
    with pytest.raises(UsageError, match=message):
        rename_classes(ANNOTATION, names, FIELD)
    with pytest.raises(UsageError, match="annotated"):
        apply_remedy(ANNOTATION, finding(A), remedy(RemedyKind.RELABEL, *names.items()))


def test_a_point_is_removed():
    mended = apply_remedy(ANNOTATION, finding(B, point=1), remedy(RemedyKind.REMOVE_POINT))
    assert [p.u for p in mended.get(B).points] == [0.3, 0.5]
    assert mended.get(A) == ANNOTATION.get(A)
    for gone in (finding(B, point=3), finding(C, point=0), finding(B)):
        with pytest.raises(UsageError, match="no such point"):
            apply_remedy(ANNOTATION, gone, remedy(RemedyKind.REMOVE_POINT), FIELD)


def test_looking_changes_nothing():
    assert apply_remedy(ANNOTATION, finding(A), remedy(RemedyKind.LOOK)) is ANNOTATION
