"""The way round things lie: the same in every picture taken from above the ground."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.label_check.candidate_classes import (
    MIRROR_X,
    MIRROR_Y,
    mirrored_names,
    relabelled,
)
from procc_annotator.calibration.label_check.check import check_labels
from procc_annotator.calibration.label_check.evidence import annotated_elements
from procc_annotator.calibration.label_check.finding import RemedyKind, Rule, Severity
from procc_annotator.calibration.label_check.side_rules import (
    contradictions,
    orientation_relations,
    wrong_side_findings,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.result import FitResult
from procc_annotator.dataset.editing import swap_classes

SIZE = (960, 540)
FRAME = ImageFrame(SIZE)


def look(annotation, field):
    return contradictions(annotated_elements(annotation, field, FRAME), field, FRAME)


def findings(annotation, field):
    return wrong_side_findings(annotated_elements(annotation, field, FRAME), field, FRAME)


def test_no_camera_above_the_ground_contradicts_the_field(views, field) -> None:
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


def test_orientations_of_the_field_are_those_of_its_points(field) -> None:
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
def test_a_reflected_frame_is_all_turned(views, field, signs) -> None:
    view = views.main(np.random.default_rng(43))
    (found,) = findings(relabelled(view.annotation, mirrored_names(field, signs)), field)
    assert (found.rule, found.severity) == (Rule.REFLECTED, Severity.ERROR)
    names = mirrored_names(field, signs)
    assert any(all(names[old] == new for old, new in remedy.renamed) for remedy in found.remedies)


def test_an_element_on_the_wrong_side_is_named(views, field) -> None:
    """Four elements; one of them on the other side of the others."""
    view = views.main(np.random.default_rng(44))
    kept = ("Big rect. left main", "Big rect. left top", "Small rect. left top", "Side line top")
    few = FrameAnnotation(tuple(p for p in view.annotation if p.class_name in kept))
    assert findings(few, field) == ()
    wrong = relabelled(few, {"Side line top": "Side line bottom"})
    (found,) = findings(wrong, field)
    assert found.rule is Rule.SIDE
    assert "Side line bottom" in found.elements


def test_two_elements_on_each_others_side_are_to_be_swapped(views, field) -> None:
    view = views.main(np.random.default_rng(45))
    pair = ("Big rect. left main", "Small rect. left main")
    (found,) = findings(swap_classes(view.annotation, *pair), field)
    swaps = [r.renamed for r in found.remedies if r.kind is RemedyKind.SWAP]
    assert (pair, pair[::-1]) in swaps or (pair[::-1], pair) in swaps


def test_sides_are_told_where_there_is_no_camera(views, field) -> None:
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
