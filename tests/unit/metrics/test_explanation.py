"""The sentences that say why an element counts as it does."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.polylines import Polylines
from procc_annotator.metrics.projection import ProjectedField
from procc_annotator.metrics.score import explain_score, jac_curve, score, worst_elements_first
from procc_annotator.metrics.setup import EvaluationSetup

CENTRE = (50.0, 25.0)


def explained(field, annotation, camera, tau, protocol="procc", **choices):
    setup = EvaluationSetup(field, (101, 51), protocol, **choices)
    measured = measure(annotation, camera, setup)
    found = explain_score(score(measured, tau), measured, field)
    return {said.annotated_name: said for said in found}


def test_too_far_names_the_point_and_the_tau(small_field, annotate, map_camera):
    annotation = annotate({"left": [(30.0, 20.0), (31.0, 24.0), (37.2, 28.0), (30.0, 30.0)]})
    said = explained(small_field, annotation, map_camera(CENTRE), 5)["left"]
    assert said.sentence == "left is too far: point 3 is 7.2 px off; it passes at tau > 7.2."
    assert (said.status, said.deciding_point) == ("too_far", 2)
    assert said.deciding_px == said.passes_above == pytest.approx(7.2)


def test_agreement_names_the_farthest_point(small_field, annotate, map_camera):
    annotation = annotate({"left": [(30.0, 20.0), (31.3, 24.0)]})
    said = explained(small_field, annotation, map_camera(CENTRE), 5)["left"]
    assert said.sentence == (
        "left agrees: its farthest point, 2, is 1.3 px off; it passes at tau > 1.3."
    )


def test_the_tau_of_the_sentence_is_where_the_verdict_turns(small_field, annotate, map_camera):
    setup = EvaluationSetup(small_field, (101, 51), "procc")
    annotation = annotate({"left": [(33.7, 22.0), (30.0, 30.0)]})
    measured = measure(annotation, map_camera(CENTRE), setup)
    (said, *_) = explain_score(score(measured, 5), measured, small_field)
    at, above = said.passes_above, np.nextafter(said.passes_above, 9)
    assert score(measured, at).elements[0].status == "too_far"
    assert score(measured, above).elements[0].status == "tp"
    assert jac_curve(measured, [at, above]).tolist() == [0.0, 0.2]  # of five elements


def test_rounding_never_contradicts_the_verdict(small_field, annotate, map_camera):
    annotation = annotate({"left": [(34.98, 22.0)], "right": [(75.02, 22.0)]})
    said = explained(small_field, annotation, map_camera(CENTRE), 5)
    assert "4.98 px off" in said["left"].sentence
    assert "5.02 px off" in said["right"].sentence


def test_missed_and_not_annotated(small_field, annotate, map_camera):
    away = annotate({"Circle": [(50.0, 34.0)], "Line unknown": [(1.0, 1.0)]})
    camera = map_camera((-400.0, 25.0))
    said = explained(small_field, away, camera, 5)
    assert said["Circle"].sentence == (
        "Circle is missed: it is annotated, but the camera does not show it in the picture."
    )
    assert said["Circle"].deciding_point is said["Circle"].passes_above is None
    assert "the field has no such element" in said["Line unknown"].sentence
    nothing = explained(small_field, annotate({}), map_camera(CENTRE), 5)
    assert nothing["left"].sentence == (
        "left is not annotated, but the camera shows it: a false positive."
    )


def test_missed_because_the_camera_knows_only_the_ground(small_field, annotate, map_camera):
    annotation = annotate({"bar": [(30.0, 24.0)]})
    flat = map_camera(CENTRE, ground_only=True)
    said = explained(small_field, annotation, flat, 5)["bar"]
    assert "the camera knows only the ground" in said.sentence
    away = map_camera((-400.0, 25.0))
    said = explained(small_field, annotation, away, 5)["bar"]
    assert "does not show it in the picture" in said.sentence


def test_mirrored_labels_are_said(small_field, annotate, map_camera):
    """A turned camera shows the line annotated as left where its own right one is."""
    annotation = annotate({"left": [(30.0, 20.0), (30.0, 29.0)]})
    camera = map_camera(CENTRE, turned=True)
    said = explained(small_field, annotation, camera, 5, allow_mirrored=True)
    assert said["left"].name == "right"
    assert said["left"].sentence.startswith("left (judged as right, labels mirrored) agrees")
    assert said["right"].sentence.startswith("right (judged as left, labels mirrored) is not")
    assert said["middle"].sentence.startswith("middle is not annotated")


def test_a_point_without_distance_passes_at_no_tau(one_line, annotate, map_camera):
    """The official evaluation has no distance to a segment without length."""
    from procc_annotator.field.geometry import Line
    from procc_annotator.metrics.measurement import measure_projected

    field = one_line(Line((-20.0, 0.0, 0.0), (20.0, 0.0, 0.0)))
    setup = EvaluationSetup(field, (101, 51), "soccernet")
    vertices = np.array([(30.0, 25.0), (30.0, 25.0), (70.0, 25.0)])
    lines = Polylines(
        vertices, np.zeros(3, np.intp), np.array([False, False, True]), 1, nan_if_zero_length=True
    )
    shown = ProjectedField(("it",), lines, lines)
    measured = measure_projected(annotate({"it": [(50.0, 25.0)]}), shown, setup)
    (said,) = explain_score(score(measured, 1e9), measured, field)
    assert said.status == "too_far"
    assert (said.deciding_point, said.deciding_px, said.passes_above) == (0, None, None)
    assert "point 1 has no distance" in said.sentence
    assert said.sentence.endswith("it passes at no tau.")


def test_titles_are_those_of_the_field(soccer, map_camera, annotate):
    annotation = annotate({"Big rect. left main": [(0.0, 0.0)]})
    said = explained(soccer, annotation, map_camera((-400.0, 25.0)), 5)["Big rect. left main"]
    assert said.sentence.startswith("Left penalty front is missed")


def test_worst_first(small_field, annotate, map_camera):
    annotation = annotate(
        {
            "middle": [(50.5, 20.0)],
            "left": [(36.0, 20.0)],
            "Line unknown": [(0.0, 0.0)],
            "right": [(78.0, 20.0)],
            "Circle": [(50.0, 33.0)],
        }
    )
    found = explained(small_field, annotation, map_camera(CENTRE), 5)
    assert [said.name for said in worst_elements_first(found.values())] == [
        "right", "left", "Line unknown", "bar", "Circle", "middle",
    ]  # fmt: skip


@pytest.mark.parametrize("tau", [2, 5])
def test_what_only_the_clipping_of_soccernet_makes_too_far_is_said(
    tau, one_line, map_camera, annotate
):
    """The line leaves the picture at (59, 51) and is 2.97 px below the click at (80, 50)."""
    from procc_annotator.field.geometry import Line

    field = one_line(Line((-50.0, 20.0, 0.0), (50.0, 30.0, 0.0)))
    annotation = annotate({"it": [(0, 45), (80, 50)]})
    said = explained(field, annotation, map_camera(CENTRE), tau, "soccernet")["it"]
    assert said.status == "too_far"
    plain = "it is too far: point 2 is 20.9 px off; it passes at tau > 20.9."
    reason = (
        " As it goes on beyond the picture it is at most 3.0 px off, but soccernet measures to"
        " what is in the picture alone."
    )
    assert said.sentence == (plain + reason if tau == 5 else plain)
    clean = explained(field, annotation, map_camera(CENTRE), tau)["it"]
    assert "beyond" not in clean.sentence
    assert clean.deciding_px == pytest.approx(300 / 101, abs=0.02)
