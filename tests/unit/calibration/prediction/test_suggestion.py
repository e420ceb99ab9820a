"""What next: what is said to help does help."""

import json

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.prediction.suggestions import (
    AnnotationSuggestion,
    likely_classes,
    suggest_annotations,
)
from procc_annotator.field.load import field_names, load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.setup import EvaluationSetup

FIELD = load_field("soccer")
SIZE = (960, 540)
SETUP = EvaluationSetup(FIELD, SIZE, "procc")


def only(annotation: FrameAnnotation, names: set[str]) -> FrameAnnotation:
    return FrameAnnotation(tuple(p for p in annotation if p.class_name in names))


@pytest.fixture(scope="module")
def clicked(views) -> FrameAnnotation:
    return views.main(np.random.default_rng(4)).annotation


def test_all_that_is_missing_and_in_sight_by_what_it_brings(clicked):
    some = only(clicked, {"Big rect. left main", "Big rect. left top", "Circle left"})
    found = suggest_annotations(some, FIELD, fit_camera(some, FIELD, size=SIZE))
    names = [s.name for s in found]
    assert len(set(names)) == len(names)
    assert {n for n in clicked.annotated if some.get(n) is None} <= set(names)
    after = [s.sd_after_px for s in found]
    assert after == sorted(after)
    assert all(0 < s.sd_after_px < s.sd_before_px for s in found)
    # Most is to be learnt where nothing is known: at the near side of the picture.
    assert names[0] == "Side line bottom"


def test_without_a_camera_there_is_nothing_to_say(clicked):
    two = only(clicked, {"Big rect. left main", "Circle left"})
    assert suggest_annotations(two, FIELD, fit_camera(two, FIELD, size=SIZE)) == ()


def test_the_place_is_what_is_in_sight_of_it(clicked):
    some = only(clicked, {"Big rect. left main", "Big rect. left top", "Circle left"})
    fit = fit_camera(some, FIELD, size=SIZE)
    found = suggest_annotations(some, FIELD, fit)
    px, shown = fit.camera.project(np.array([s.place_world for s in found]))
    assert shown.all()
    assert ((px >= 0) & (px <= np.array(SIZE) - 1)).all()


def test_what_changes_next_to_nothing_is_not_worthwhile():
    place = (0.0, 0.0, 0.0)
    assert AnnotationSuggestion("Middle line", 3.0, 2.0, place).is_worthwhile
    assert not AnnotationSuggestion("Middle line", 3.0, 2.8, place).is_worthwhile  # a fifteenth
    assert not AnnotationSuggestion("Middle line", 0.3, 0.25, place).is_worthwhile  # of a pixel


def test_what_cannot_be_seen_is_not_suggested(clicked):
    some = only(clicked, {"Big rect. left main", "Big rect. left top", "Circle left"})
    fit = fit_camera(some, FIELD, size=SIZE)
    best, *rest = suggest_annotations(some, FIELD, fit)
    assert suggest_annotations(some, FIELD, fit, without={best.name}) == tuple(rest)


@pytest.mark.parametrize("model", ["H", "P", "R", "R+"])
def test_the_promise_is_kept_by_the_next_fit(clicked, model):
    """With the best element annotated the projection is as sure as promised, and the more so the
    better it is; as far as the points' own error is the same."""
    names = {"Big rect. left main", "Big rect. left top", "Big rect. left bottom", "Circle left"}
    some = only(clicked, names)
    fit = fit_camera(some, FIELD, model=model, size=SIZE)
    found = [s for s in suggest_annotations(some, FIELD, fit) if clicked.get(s.name) is not None]
    if model == "H":
        assert all(element.on_ground for s in found if (element := FIELD.element(s.name)))
    reached = []
    for suggestion in (found[0], found[-1]):
        more = only(clicked, names | {suggestion.name})
        again = fit_camera(more, FIELD, model=model, size=SIZE, start=fit.camera)
        then = suggest_annotations(more, FIELD, again)[0].sd_before_px
        assert fit.error_px is not None
        assert again.error_px is not None
        reached.append(then * fit.error_px / again.error_px)
        # Where the camera turns out to look elsewhere, less of the uncertain part is in sight.
        assert 0.35 * suggestion.sd_after_px < reached[-1] < 1.2 * suggestion.sd_after_px
    assert reached[0] < reached[1] < found[0].sd_before_px


@pytest.mark.parametrize(
    ("every", "enough"), [(6, 15), pytest.param(3, 30, marks=pytest.mark.soak)]
)
def test_following_it_helps_more_than_another_element_on_real_frames(shared_data, every, enough):
    rng = np.random.default_rng(2)
    better, before, followed, others = [], [], [], []
    paths = sorted((shared_data / "wc14" / "annotations").glob("*.json"))
    for number, path in enumerate(paths[1::every]):
        annotation = read_annotation(path.read_bytes(), path=str(path), field=FIELD)
        names = [n for n in annotation.annotated if n in FIELD.index]
        count = 4 + number % 2
        if len(names) < count + 3:
            continue
        chosen = set(rng.choice(names, count, replace=False).tolist())
        fit = fit_camera(only(annotation, chosen), FIELD, size=SIZE)
        ranked = [s.name for s in suggest_annotations(only(annotation, chosen), FIELD, fit)]
        ranked = [n for n in ranked if n in names]
        if len(ranked) < 2:
            continue
        other = ranked[1 + int(rng.integers(len(ranked) - 1))]
        before.append(_error(annotation, fit))
        for name, into in ((ranked[0], followed), (other, others)):
            more = only(annotation, chosen | {name})
            into.append(_error(annotation, fit_camera(more, FIELD, size=SIZE, start=fit.camera)))
        better.append(followed[-1] < others[-1])
    assert len(better) > enough
    assert np.mean(better) > 0.55
    assert np.median(followed) < np.median(others) < np.median(before)


def _error(annotation: FrameAnnotation, fit) -> float:
    """Mean over the frame's elements of their mean distance to the projection, px."""
    if fit.camera is None:
        return 50.0
    found = measure(annotation, fit.camera, SETUP).plain.distances
    return float(np.mean([50.0 if d is None else min(d.mean(), 50.0) for d in found]))


# Lines get their likeliest names without a camera.

HD_SIZE = (1280, 720)


@pytest.fixture(scope="module")
def frames(sample_data) -> list[dict[str, np.ndarray]]:
    """The elements of the sample's annotated frames, px."""
    field = load_field("soccer")
    found = []
    for path in sorted(sample_data.glob("0*.json")):
        entries = json.loads(path.read_text())
        found.append(
            {
                name: np.array([(p["x"], p["y"]) for p in points])
                * (HD_SIZE[0] - 1, HD_SIZE[1] - 1)
                for name, points in entries.items()
                if field.element(name) is not None and len(points) > 1
            }
        )
    return found


def test_with_two_neighbours_most_lines_are_among_the_first_three(frames):
    field, rng = load_field("soccer"), np.random.default_rng(0)
    asked = right = 0
    for lines in frames:
        for name, line in lines.items():
            others = [other for other in lines if other != name]
            known = {other: lines[other] for other in rng.permutation(others)[:2]}
            found = likely_classes(field, line, HD_SIZE, known)
            assert not set(found) & set(known)
            asked += 1
            right += name in found[:3]
    assert right / asked > 0.7  # of 26 elements; the first three at random would be 12 %


@pytest.mark.parametrize("name", field_names())
def test_every_field_has_an_answer(name):
    field = load_field(name)
    for line in (np.array([(100.0, 300), (1000, 330)]), np.array([(640.0, 360.0)])):
        found = likely_classes(field, line, HD_SIZE, {})
        assert len(found) == len(set(found))
        assert all(field.element(one) is not None for one in found)
