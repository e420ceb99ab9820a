"""Measuring and scoring one frame, with cases small enough to reckon by hand."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.field.geometry import Line
from procc_annotator.field.model import Element, Field
from procc_annotator.metrics.measurement import measure, measure_projected, nearest_points
from procc_annotator.metrics.polylines import Polylines
from procc_annotator.metrics.projection import ProjectedField, project_field
from procc_annotator.metrics.score import (
    FrameScore,
    display_score,
    explain_score,
    jac_curve,
    score,
    worst_elements_first,
)
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (101, 51)
CENTRE = (50.0, 25.0)
PROTOCOLS = ("soccernet", "procc")


def counts(result: FrameScore) -> tuple[int, int, int]:
    return result.tp, result.fp, result.fn


def statuses(result: FrameScore) -> dict[str, str]:
    return {e.name: e.status for e in result.elements}


@pytest.fixture(params=PROTOCOLS)
def setup(request, small_field) -> EvaluationSetup:
    return EvaluationSetup(small_field, SIZE, request.param)


@pytest.fixture
def procc(small_field) -> EvaluationSetup:
    return EvaluationSetup(small_field, SIZE, "procc")


def test_each_status_is_counted_where_it_belongs(procc, map_camera, annotate):
    """left within 2 px, right 4 px off, the others not clicked, one class without geometry."""
    annotation = annotate(
        {"left": [(31, 20), (28, 30)], "right": [(70, 20), (74, 30)], "Line unknown": [(5, 5)]}
    )
    result = score(measure(annotation, map_camera(CENTRE), procc), 3)
    assert statuses(result) == {
        "left": "tp",
        "right": "too_far",
        "Line unknown": "missed",
        "middle": "not_annotated",
        "Circle": "not_annotated",
        "bar": "not_annotated",
    }
    assert counts(result) == (1, 4, 1)
    assert result.jac == pytest.approx(1 / 6)
    assert result.precision == pytest.approx(1 / 5)
    assert result.recall == pytest.approx(1 / 2)
    assert not result.mirrored


def test_an_element_tells_its_distances_deciding_point_and_flip(procc, map_camera, annotate):
    annotation = annotate({"right": [(70, 20), (74, 30), (67, 25)]})
    result = score(measure(annotation, map_camera(CENTRE), procc), 3)
    element = result.elements[0]
    assert element.distances.tolist() == pytest.approx([0, 4, 3])
    assert (element.max_distance, element.deciding_point) == (pytest.approx(4), 1)
    assert element.passes_above == element.max_distance
    assert (result.mean_error, result.median_error) == (pytest.approx(7 / 3), pytest.approx(3))
    assert result.max_error == pytest.approx(4)


def test_the_threshold_is_strict(setup, map_camera, annotate):
    measurement = measure(annotate({"left": [(33, 25)]}), map_camera(CENTRE), setup)
    assert score(measurement, 3).elements[0].status == "too_far"
    assert score(measurement, math.nextafter(3, 4)).elements[0].status == "tp"
    assert score(measurement, 3).tp == 0


def test_an_empty_list_of_points_counts_as_absent(setup, map_camera, annotate):
    result = score(measure(annotate({"left": []}), map_camera(CENTRE), setup), 5)
    assert counts(result) == (0, 5, 0)
    assert result.mean_error is None
    assert result.recall is None


def test_nothing_annotated_and_nothing_projected_is_jac_zero(setup, map_camera, annotate):
    result = score(measure(annotate({}), map_camera((1e6, 1e6)), setup), 5)
    assert counts(result) == (0, 0, 0)
    assert (result.jac, result.precision, result.recall, result.mean_error) == (0, None, None, None)
    assert jac_curve(measure(annotate({}), map_camera((1e6, 1e6)), setup), [1, 5]).tolist() == [
        0,
        0,
    ]


def test_everything_annotated_and_nothing_projected_is_missed(setup, map_camera, annotate):
    annotation = annotate({"left": [(30, 25)], "Circle": [(59, 25)]})
    result = score(measure(annotation, map_camera((1e6, 1e6)), setup), 5)
    assert counts(result) == (0, 0, 2)
    assert (result.precision, result.recall) == (None, 0)


def test_a_class_name_with_other_blanks_is_recognised(setup, map_camera, annotate):
    result = score(measure(annotate({"left ": [(30, 25)]}), map_camera(CENTRE), setup), 5)
    assert result.elements[0].annotated_name == "left"
    assert result.elements[0].status == "tp"


def test_classes_the_field_does_not_know_are_missed_under_their_own_name(
    setup, map_camera, annotate
):
    result = score(measure(annotate({"moon": [(30, 25)]}), map_camera(CENTRE), setup), 5)
    assert result.fn == 1
    assert (result.elements[0].name, result.elements[0].status) == ("moon", "missed")


def test_on_a_tie_soccernet_takes_the_mirrored_labels_and_procc_the_plain_ones(
    small_field, map_camera, annotate
):
    annotation = annotate({"middle": [(50, 20)]})
    official = EvaluationSetup(small_field, SIZE)
    clean = EvaluationSetup(small_field, SIZE, "procc", allow_mirrored=True)
    assert score(measure(annotation, map_camera(CENTRE), official), 5).mirrored
    assert not score(measure(annotation, map_camera(CENTRE), clean), 5).mirrored


def test_to_be_read_a_tie_keeps_the_labels_as_they_are(small_field, map_camera, annotate):
    official = EvaluationSetup(small_field, SIZE)
    # Both labellings fail: mirrored labels would tell distances of half a field.
    measurement = measure(annotate({"left": [(20, 20)]}), map_camera(CENTRE), official)
    assert score(measurement, 5).mirrored
    read = display_score(measurement, 5)
    assert not read.mirrored
    assert read.jac == score(measurement, 5).jac == 0.0
    assert read.max_error == pytest.approx(measurement.plain.all_distances.max())


def test_errors_are_told_of_the_labels_as_they_are_on_a_tie(small_field, map_camera, annotate):
    """The counts stay official; its error, of half a field, is a figure of its own."""
    measurement = measure(
        annotate({"left": [(20, 20)]}), map_camera(CENTRE), EvaluationSetup(small_field, SIZE)
    )
    tied = score(measurement, 5)
    assert tied.mirrored
    assert tied.mean_reprojection_error == pytest.approx(50)
    assert (tied.mean_error, tied.median_error, tied.max_error) == pytest.approx((10, 10, 10))
    won = score(measurement, 11)  # the labels as they are pass
    assert not won.mirrored
    assert won.mean_error == won.mean_reprojection_error == pytest.approx(10)
    turned = score(
        measure(
            annotate({"left": [(71, 20)], "right": [(32, 20)]}),
            map_camera(CENTRE),
            EvaluationSetup(small_field, SIZE),
        ),
        5,
    )
    assert turned.mirrored
    assert turned.mean_error == turned.mean_reprojection_error == pytest.approx(1.5)


def test_to_be_read_mirrored_labels_count_where_they_are_better(small_field, map_camera, annotate):
    official = EvaluationSetup(small_field, SIZE)
    annotation = annotate({"left": [(70, 20)], "right": [(30, 20)]})
    read = display_score(measure(annotation, map_camera(CENTRE), official), 5)
    assert read.mirrored
    assert read.tp == 2


def test_procc_considers_mirrored_labels_only_on_request(small_field, map_camera, annotate):
    annotation = annotate({"left": [(70, 20)], "right": [(30, 20)]})
    strict = EvaluationSetup(small_field, SIZE, "procc")
    lenient = EvaluationSetup(small_field, SIZE, "procc", allow_mirrored=True)
    assert measure(annotation, map_camera(CENTRE), strict).mirrored == ()
    result = score(measure(annotation, map_camera(CENTRE), lenient), 5)
    assert result.mirrored
    assert result.tp == 2
    assert [(e.name, e.annotated_name) for e in result.elements[:2]] == [
        ("right", "left"),
        ("left", "right"),
    ]


def test_the_labelling_is_chosen_anew_at_every_threshold(small_field, map_camera, annotate):
    setup = EvaluationSetup(small_field, SIZE, "procc", allow_mirrored=True)
    near = map_camera((70.0, 25.0))  # left at x = 50, right at x = 90, middle at x = 70
    # As they are: 38 and 4 px off; mirrored: 2 and 44 px.
    annotation = annotate({"left": [(88, 20)], "right": [(94, 22)]})
    measurement = measure(annotation, near, setup)
    assert (score(measurement, 3).mirrored, score(measurement, 3).tp) == (True, 1)
    assert (score(measurement, 5).mirrored, score(measurement, 5).tp) == (False, 1)


def test_a_field_without_symmetry_is_never_mirrored(map_camera, annotate):
    setup = EvaluationSetup(replace(_only_left(), symmetries=()), SIZE)
    measurement = measure(annotate({"left": [(30, 25)]}), map_camera(CENTRE), setup)
    assert measurement.mirrored == ()
    assert not score(measurement, 5).mirrored


def _only_left() -> Field:
    shape = Line((-20.0, -10.0, 0.0), (-20.0, 10.0, 0.0))
    return Field("t", "T", (), (Element("left", "left", "g", "#ffffff", "", shape),), {})


def test_a_distance_that_is_nan_fails_every_threshold(small_field, annotate):
    class Still:
        def project(self, points_world):
            return np.full((len(points_world), 2), 20.0), np.ones(len(points_world), bool)

    setup = EvaluationSetup(small_field, SIZE)
    measurement = measure(annotate({"middle": [(20, 20), (21, 20)]}), Still(), setup)
    result = score(measurement, math.inf)
    element = result.elements[0]
    assert (element.status, element.max_distance, element.deciding_point) == ("too_far", None, 0)
    assert (result.tp, result.mean_error, result.median_error, result.max_error) == (
        0, None, None, None,
    )  # fmt: skip
    procc = measure(
        annotate({"middle": [(20, 20), (21, 20)]}),
        Still(),
        EvaluationSetup(small_field, SIZE, "procc"),
    )
    assert procc.plain.all_distances.tolist() == [0, 1]


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_a_ground_camera_misses_raised_elements_or_leaves_them_out(
    protocol, small_field, map_camera, annotate
):
    camera = map_camera(CENTRE, ground_only=True)
    annotation = annotate({"left": [(30, 25)], "bar": [(30, 25)]})
    missed = EvaluationSetup(small_field, SIZE, protocol)
    result = score(measure(annotation, camera, missed), 5)
    assert counts(result) == (1, 3, 1)
    assert statuses(result)["bar"] == "missed"
    left_out = EvaluationSetup(small_field, SIZE, protocol, off_plane="left_out")
    result = score(measure(annotation, camera, left_out), 5)
    assert counts(result) == (1, 3, 0)
    assert "bar" not in statuses(result)
    assert project_field(camera, left_out).left_out == {"bar"}
    full = score(measure(annotation, map_camera(CENTRE), left_out), 5)
    assert counts(full) == (2, 3, 0)


def test_whiskers_end_at_the_nearest_projected_point(setup, map_camera, annotate):
    annotation = annotate({"moon": [(1, 1)], "left": [(33, 25), (30, 40)], "right": [(72, 20)]})
    measurement = measure(annotation, map_camera(CENTRE), setup)
    feet = nearest_points(measurement, measurement.plain)
    assert feet[0] is None
    assert feet[1] is not None
    assert feet[1].tolist() == [[30, 25], [30, 35]]
    assert feet[2] is not None
    assert feet[2].tolist() == [[70, 20]]
    for turned in measurement.mirrored:
        mirrored = nearest_points(measurement, turned)
        assert mirrored[1] is not None
        assert mirrored[1].tolist() == [[70, 25], [70, 35]]


@pytest.mark.parametrize(
    ("protocol", "distances", "foot"),
    [
        ("procc", [0.0, 0.0, 300 / 101], (79.703, 52.970)),
        ("soccernet", [0.0, 0.0, 20.91], (59.091, 50.909)),
    ],
)
def test_a_line_that_grazes_the_border_is_judged_as_it_goes_on(
    protocol, distances, foot, one_line, map_camera, annotate
):
    """It leaves the picture at (50, 50) and is 3 px below the click at (80, 50) there; to the
    official evaluation the last row of pixels is in the picture as a whole."""
    field = one_line(Line((-50.0, 20.0, 0.0), (50.0, 30.0, 0.0)))
    annotation = annotate({"it": [(0, 45), (40, 49), (80, 50)]})
    measurement = measure(annotation, map_camera(CENTRE), EvaluationSetup(field, SIZE, protocol))
    assert measurement.plain.all_distances == pytest.approx(distances, abs=0.02)
    assert (score(measurement, 5).tp == 1) == (protocol == "procc")
    (feet,) = nearest_points(measurement, measurement.plain)
    assert feet[2] == pytest.approx(foot, abs=0.02)
    below = measure(annotation, map_camera((50.0, 31.5)), EvaluationSetup(field, SIZE, protocol))
    assert score(below, 50).fn == 1  # whether it is in sight the picture decides


def test_pieces_are_named_and_only_of_what_is_visible(setup, map_camera):
    projected = project_field(map_camera((30.0, 25.0)), setup)
    assert set(projected.pieces) == {"left", "right", "middle", "Circle", "bar"}
    assert set(project_field(map_camera((0.0, 25.0)), setup).pieces) == {
        "right", "middle", "Circle",
    }  # fmt: skip


place = st.tuples(st.floats(-20, 120), st.floats(-20, 70))
annotations = st.dictionaries(
    st.sampled_from(["left", "right", "middle", "Circle", "bar", "Line unknown"]),
    st.lists(place, max_size=4),
)
cameras = st.tuples(st.floats(-30, 130), st.floats(-30, 80))
taus = st.lists(st.floats(0.01, 60), min_size=1, max_size=12)


def build(polylines: dict[str, list[tuple[float, float]]]) -> FrameAnnotation:
    return FrameAnnotation(
        tuple(
            Polyline(name, tuple(Point(x / 100, y / 50) for x, y in points))
            for name, points in polylines.items()
        )
    )


@settings(derandomize=True, deadline=None)
@given(annotations, cameras, taus, st.sampled_from(PROTOCOLS), st.booleans())
def test_the_curve_is_the_score_at_every_threshold_and_never_falls(
    small_field, map_camera, polylines, shift, thresholds, protocol, allow
):
    setup = EvaluationSetup(small_field, SIZE, protocol, allow_mirrored=allow)
    measurement = measure(build(polylines), map_camera(shift), setup)
    curve = jac_curve(measurement, thresholds)
    one_by_one = [score(measurement, tau).jac for tau in thresholds]
    np.testing.assert_allclose(curve, one_by_one, rtol=0, atol=1e-15)
    assert (np.diff(jac_curve(measurement, sorted(thresholds))) >= 0).all()
    for tau in thresholds:
        result = score(measurement, tau)
        listed = [e.status for e in result.elements]
        assert counts(result) == (
            listed.count("tp"),
            listed.count("too_far") + listed.count("not_annotated"),
            listed.count("missed"),
        )


@settings(derandomize=True, deadline=None)
@given(annotations, cameras)
def test_a_turned_camera_swaps_the_two_labellings(small_field, map_camera, polylines, shift):
    """Mirroring twice is the identity: from the other side, plain and mirrored change places."""
    elements = tuple(e for e in small_field.elements if e.name in ("left", "right", "middle"))
    field = replace(small_field, elements=elements)
    setup = EvaluationSetup(field, SIZE, "procc", allow_mirrored=True)
    here = measure(build(polylines), map_camera(shift), setup)
    there = measure(build(polylines), map_camera(shift, turned=True), setup)
    (turned,), (also,) = here.mirrored, there.mirrored
    np.testing.assert_allclose(here.plain.worst, also.worst, atol=1e-9)
    np.testing.assert_allclose(turned.worst, there.plain.worst, atol=1e-9)
    assert here.plain.element_count == also.element_count
    assert turned.annotated_names == here.plain.names
    back = tuple(field.symmetries[0].name_of(name) for name in turned.names)
    assert back == here.plain.names


def test_measuring_a_projected_field_again_gives_the_same(setup, map_camera, annotate):
    annotation = annotate({"left": [(31, 20)], "Circle": [(60, 25)]})
    camera = map_camera(CENTRE)
    projected = project_field(camera, setup)
    once, again = (
        measure(annotation, camera, setup),
        measure_projected(annotation, projected, setup),
    )
    assert once.plain.all_distances.tolist() == again.plain.all_distances.tolist()


# The sentences that say why an element counts as it does.


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
