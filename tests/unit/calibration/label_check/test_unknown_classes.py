"""Class names the field does not know, and pixels where normalised coordinates belong."""

from __future__ import annotations

import warnings
from dataclasses import replace
from pathlib import Path

import pytest

from procc_annotator import load_annotation
from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.assist.frame_analysis import apply_remedy
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.check import check_labels
from procc_annotator.calibration.label_check.finding import Finding, RemedyKind, Rule, Severity
from procc_annotator.dataset.review import check_without_fit
from procc_annotator.field.load import load_field
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

FIELD = load_field()
SIZE = (960, 540)
FRAME = load_annotation(Path(__file__).parents[4] / "sample_data" / "00002.json")


def check(annotation: FrameAnnotation) -> tuple[Finding, ...]:
    fit = fit_camera(annotation, FIELD, size=SIZE)
    return check_labels(annotation, FIELD, size=SIZE, fit=fit)


def renamed(old: str, new: str) -> FrameAnnotation:
    return FrameAnnotation(
        tuple(
            replace(p, class_name=new) if p.class_name.strip() == old else p
            for p in FRAME.polylines
        )
    )


def of_rule(found: tuple[Finding, ...], rule: Rule) -> list[Finding]:
    return [f for f in found if f.rule is rule]


@pytest.mark.parametrize("slip", ["Side line tpo", "side line top", "Far touch line"])
def test_a_slip_in_a_name_is_an_error_with_the_right_name(slip) -> None:
    wrong = renamed("Side line top", slip)
    assert slip in wrong.annotated
    (found,) = of_rule(check(wrong), Rule.UNKNOWN_CLASS)
    assert (found.severity, found.elements) == (Severity.ERROR, (slip,))
    assert found.reason == (f"no such class: {slip!r}, did you mean Far touchline (Side line top)?")
    assert found.remedies[0].kind is RemedyKind.RELABEL
    mended = apply_remedy(wrong, found, found.remedies[0], FIELD)
    assert mended == FRAME
    assert of_rule(check(mended), Rule.UNKNOWN_CLASS) == []


def test_a_name_that_is_taken_is_not_offered() -> None:
    line = FRAME.get("Side line top")
    both = FRAME.with_polyline(Polyline("Side line tpo", line.points))
    (found,) = of_rule(check(both), Rule.UNKNOWN_CLASS)
    assert "annotated already" in found.reason
    assert [r.kind for r in found.remedies] == [RemedyKind.LOOK]


def test_names_like_no_other_are_a_warning_and_known_ones_nothing() -> None:
    points = (Point(0.1, 0.2), Point(0.3, 0.2))
    more = FRAME.with_polyline(Polyline("Advertising board", points))
    more = more.with_polyline(Polyline("Line unknown", points))
    more = more.with_polyline(Polyline("Corner flag", ()))  # absent
    found = of_rule(check(more), Rule.UNKNOWN_CLASS)
    assert [(f.elements, f.severity) for f in found] == [(("Advertising board",), Severity.WARNING)]
    assert "counts as missed where it is scored" in found[0].reason
    fit = fit_camera(more, FIELD, size=SIZE)
    assert fit.camera is not None
    scores = [
        score(measure(annotation, fit.camera, EvaluationSetup(FIELD, SIZE)), 5.0)
        for annotation in (FRAME, more)
    ]
    assert scores[1].fn > scores[0].fn
    without_fit = check_without_fit(more, FIELD, size=SIZE)
    assert Rule.UNKNOWN_CLASS in {f.finding.rule for f in without_fit.found}


def test_pixels_are_the_one_thing_that_is_told() -> None:
    pixels = FrameAnnotation(
        tuple(
            replace(p, points=tuple(Point(q.u * 959, q.v * 539) for q in p.points))
            for p in FRAME.polylines
        )
    )
    (found,) = check(pixels)
    assert (found.rule, found.severity) == (Rule.PIXELS, Severity.ERROR)
    assert "look like pixels, expected 0 to 1" in found.reason
    (alone,) = check_without_fit(pixels, FIELD, size=SIZE).found
    assert alone.finding == found


def test_points_in_one_place_or_on_one_line_make_no_noise() -> None:
    names = ("Middle line", "Side line top", "Side line bottom", "Big rect. left main")
    one_place = tuple(Polyline(n, (Point(0.4, 0.4),) * 2) for n in names)
    one_line = tuple(Polyline(n, (Point(0.1, 0.5), Point(0.9, 0.5))) for n in names)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for polylines in (one_place, one_line):
            check(FrameAnnotation(polylines))
