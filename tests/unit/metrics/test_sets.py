"""Figures of a set, reckoned by hand."""

import math
import pickle
import statistics
from operator import attrgetter
from pathlib import Path

import pytest

from procc_annotator.batch.evaluation import run_evaluation
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_source import open_source
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.sets import SetAccumulator, SetSummary, most_distinct_views
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (101, 51)
TAUS = (2.0, 5.0)


@pytest.fixture
def setup(small_field):
    return EvaluationSetup(small_field, SIZE, "procc")


@pytest.fixture
def frames(setup, map_camera, annotate):
    """Three frames; the camera of the last one looks elsewhere."""
    annotations = [
        annotate({"left": [(31, 20), (34, 30)], "middle": [(50, 25)], "Circle": [(59, 25)]}),
        annotate({"left": [(30, 20)], "moon": [(1, 1), (2, 2), (3, 3)]}),
        annotate({"right": [(70, 20), (70, 22)]}),
    ]
    cameras = [map_camera((50.0, 25.0))] * 2 + [map_camera((1e6, 0.0))]
    measured = [measure(a, c, setup) for a, c in zip(annotations, cameras, strict=True)]
    return [(m, {tau: score(m, tau) for tau in TAUS}) for m in measured]


def gathered(setup, frames, missing=1):
    accumulator = SetAccumulator(setup, TAUS)
    for i, (measurement, scores) in enumerate(frames):
        accumulator.add(f"{i}", measurement, scores)
    for _ in range(missing):
        accumulator.add_missing_camera("none")
    return accumulator


def test_the_figures_of_a_small_set(setup, frames):
    """At 2 px: 2 of 5 (right and bar are only projected), 1 of 6, 0 of 1; at 5 px: 3 of 5."""
    summary = gathered(setup, frames).summary()
    jacs = [2 / 5, 1 / 6, 0]
    at = summary[2.0]
    assert (at.images, at.evaluated) == (4, 3)
    assert at.mean_jac == pytest.approx(statistics.fmean(jacs))
    assert at.sd_jac == pytest.approx(statistics.pstdev(jacs))
    assert at.median_jac == pytest.approx(1 / 6)
    assert at.completeness == 3 / 4
    assert at.final_score == pytest.approx(3 / 4 * statistics.fmean(jacs))
    assert at.mean_precision == pytest.approx((2 / 5 + 1 / 5) / 2)
    assert at.mean_recall == pytest.approx((1 + 1 / 2 + 0) / 3)
    assert at.mean_reprojection_error == pytest.approx((1 + 4 + 0 + 0 + 0) / 5)
    assert summary[5.0].mean_jac == pytest.approx(statistics.fmean([3 / 5, 1 / 6, 0]))


def test_classes_are_summed_in_points(setup, frames):
    per_class = gathered(setup, frames).summary()[2.0].per_class
    figures = {name: (c.tp, c.fp, c.fn) for name, c in per_class.items()}
    assert figures == {
        "left": (2, 1, 0),
        "middle": (1, 2, 0),
        "Circle": (1, 9, 0),
        "bar": (0, 4, 0),
        "right": (0, 4, 2),
        "moon": (0, 0, 3),
    }
    assert per_class["left"].precision == pytest.approx(2 / 3)
    assert per_class["left"].recall == 1
    assert per_class["moon"].precision is None
    assert per_class["right"].jac == 0


def test_a_set_without_frames_is_undefined_not_zero(setup):
    at = SetAccumulator(setup, TAUS).summary()[2.0]
    assert (at.images, at.mean_jac, at.completeness, at.final_score) == (0, None, None, None)
    assert at.mean_reprojection_error is None
    assert at.per_class == {}


def test_a_set_without_any_camera_has_completeness_zero(setup):
    accumulator = SetAccumulator(setup, TAUS)
    accumulator.add_missing_camera("a")
    at = accumulator.summary()[5.0]
    assert (at.completeness, at.mean_jac, at.final_score) == (0, None, None)


def test_parts_gathered_elsewhere_merge_to_the_same_figures(setup, frames):
    whole = gathered(setup, frames).summary()
    first = gathered(setup, frames[:1], missing=0)
    second = gathered(setup, frames[1:])
    first.merge(pickle.loads(pickle.dumps(second)))  # noqa: S301
    assert first.summary() == whole


def test_scores_survive_the_trip_from_a_worker(setup, frames):
    travelled = [(None, pickle.loads(pickle.dumps(scores))) for _, scores in frames]  # noqa: S301
    assert gathered(setup, travelled).summary() == gathered(setup, frames).summary()


def test_what_was_measured_differently_is_refused(setup, frames, small_field):
    other = SetAccumulator(EvaluationSetup(small_field, SIZE, "soccernet"), TAUS)
    measurement, scores = frames[0]
    with pytest.raises(UsageError, match="first: measured with procc, 101x51"):
        other.add("first", measurement, scores)
    with pytest.raises(UsageError, match="cannot be merged"):
        other.merge(SetAccumulator(setup, TAUS))
    with pytest.raises(UsageError, match="second: no score at 9 px"):
        SetAccumulator(setup, (9,)).add("second", measurement, scores)


def test_at_each_threshold_the_labelling_that_counts_there_is_summed(
    small_field, map_camera, annotate
):
    setup = EvaluationSetup(small_field, SIZE, "procc", allow_mirrored=True)
    annotation = annotate({"left": [(88, 20)], "right": [(94, 22)]})
    measurement = measure(annotation, map_camera((70.0, 25.0)), setup)
    scores = {tau: score(measurement, tau) for tau in (3.0, 5.0)}
    accumulator = SetAccumulator(setup, (3.0, 5.0))
    accumulator.add("frame", measurement, scores)
    summary = accumulator.summary()
    assert [scores[tau].mirrored for tau in (3.0, 5.0)] == [True, False]
    assert (summary[3.0].per_class["right"].tp, summary[3.0].per_class["left"].fp) == (1, 1)
    assert (summary[5.0].per_class["right"].tp, summary[5.0].per_class["left"].fp) == (1, 1)
    assert summary[3.0].mean_reprojection_error == pytest.approx((2 + 44) / 2)
    assert summary[5.0].mean_reprojection_error == pytest.approx((38 + 4) / 2)


# The views that differ most, by where cameras look and how far they zoom.


def camera(pan_degrees: float, focal_px: float = 1000.0) -> PinholeCamera:
    centre = (639.5, 359.5)
    pan = math.radians(pan_degrees)
    return PinholeCamera(pan, 1.3, 0.0, (0.0, 60.0, -15.0), (focal_px, focal_px), centre)


def chosen(cameras: list[PinholeCamera], count: int) -> list[int]:
    return most_distinct_views(cameras, [1280] * len(cameras), count)


def test_the_usual_view_comes_first_then_the_ends_of_a_pan():
    cameras = [camera(pan) for pan in (-30, -20, -10, 0, 10, 20, 31)]
    assert chosen(cameras, 3) == [3, 6, 0]


def test_a_zoom_is_another_view():
    cameras = [camera(0), camera(1), camera(2), camera(1, focal_px=3000), camera(3)]
    assert set(chosen(cameras, 2)) == {2, 3} or set(chosen(cameras, 2)) == {1, 3}


def test_a_pan_past_half_a_turn_is_no_jump():
    cameras = [camera(pan) for pan in (170, 175, 179, -179, -175, -140)]
    assert chosen(cameras, 2) == [2, 5]


def test_no_more_than_there_are_each_once():
    assert chosen([], 3) == []
    assert sorted(chosen([camera(0), camera(0), camera(5)], 9)) == [0, 1, 2]


# The setup: what it accepts and how it names itself.


def test_it_says_what_was_evaluated(soccer):
    assert EvaluationSetup(soccer).describe() == "soccernet, 960x540"
    other = EvaluationSetup(load_field("volleyball"), protocol="procc")
    assert other.describe() == "procc, 960x540, volleyball"
    left_out = EvaluationSetup(soccer, (1280, 720), off_plane="left_out")
    assert left_out.describe() == "soccernet, 1280x720"
    assert left_out.describe(ground_only=True) == "soccernet, 1280x720, off-plane elements left out"
    missed = EvaluationSetup(soccer).describe(ground_only=True)
    assert missed == "soccernet, 960x540, off-plane elements counted as missed"
    lenient = EvaluationSetup(soccer, protocol="procc", allow_mirrored=True)
    assert lenient.describe() == "procc, 960x540, mirrored labels allowed"


def test_a_misspelt_protocol_is_refused_with_a_hint(soccer):
    with pytest.raises(UsageError, match=r"'soccer-net'; did you mean 'soccernet'\?"):
        EvaluationSetup(soccer, protocol="soccer-net")
    with pytest.raises(UsageError, match="choose one of missed, left_out"):
        EvaluationSetup(soccer, off_plane="?")
    with pytest.raises(UsageError, match="1x540"):
        EvaluationSetup(soccer, size=(1, 540))


def test_it_travels_to_a_worker_process(soccer):
    setup = EvaluationSetup(soccer, protocol="procc")
    assert len(setup.tables.names) == len(soccer.elements)
    copy = pickle.loads(pickle.dumps(setup))  # noqa: S301
    assert copy == setup
    assert copy.tables.names == setup.tables.names


# Elements off the ground taking no part, for every camera and protocol.

CENTRE = (50.0, 25.0)
LINE = [(30.0, 20.0), (30.0, 30.0)]
BAR = [(30.0, 24.0), (30.0, 27.0)]


def planar_setup(field, protocol="soccernet", **choices):
    return EvaluationSetup(field, (101, 51), protocol, **choices)


@pytest.mark.parametrize("protocol", ["soccernet", "procc"])
@pytest.mark.parametrize("ground_only", [False, True])
@pytest.mark.parametrize("off_plane", ["missed", "left_out"])
def test_elements_off_the_ground_are_neither_right_nor_wrong(
    small_field, annotate, map_camera, protocol, ground_only, off_plane
):
    """The bar is shown by the camera in one frame and annotated in the other: neither counts."""
    camera = map_camera(CENTRE, ground_only=ground_only)
    planar = planar_setup(small_field, protocol, planar_only=True, off_plane=off_plane)
    for polylines in ({"left": LINE}, {"left": LINE, "bar": BAR}):
        measured = measure(annotate(polylines), camera, planar)
        verdicts = {e.name: e.status for e in score(measured, 1).elements}
        assert verdicts == {
            "left": "tp",
            "right": "not_annotated",
            "middle": "not_annotated",
            "Circle": "not_annotated",
        }
        assert "bar" not in measured.projected.pieces


@pytest.mark.parametrize("protocol", ["soccernet", "procc"])
def test_without_it_they_count(small_field, annotate, map_camera, protocol):
    measured = measure(
        annotate({"left": LINE}), map_camera(CENTRE), planar_setup(small_field, protocol)
    )
    assert {e.name: e.status for e in score(measured, 1).elements}["bar"] == "not_annotated"


def test_planar_elements_are_measured_as_before(small_field, annotate, map_camera):
    annotation = annotate({"left": [(31.0, 20.0), (30.0, 30.0)], "Circle": [(50.0, 33.0)]})
    camera = map_camera(CENTRE)
    for protocol in ("soccernet", "procc"):
        all_of_it = measure(annotation, camera, planar_setup(small_field, protocol))
        planar = measure(annotation, camera, planar_setup(small_field, protocol, planar_only=True))
        assert planar.plain.all_distances.tolist() == all_of_it.plain.all_distances.tolist()


def test_it_is_said(small_field):
    planar = planar_setup(small_field, planar_only=True)
    assert planar.describe() == "soccernet, 101x51, test, planar elements only"
    assert planar.describe(ground_only=True) == planar.describe()


def test_sets_of_both_kinds_cannot_be_mixed(small_field, annotate, map_camera):
    sums = SetAccumulator(planar_setup(small_field, planar_only=True), (5,))
    measured = measure(annotate({"left": LINE}), map_camera(CENTRE), planar_setup(small_field))
    with pytest.raises(UsageError, match="measured with"):
        sums.add("1", measured, {5: score(measured, 5)})


def summaries(shared_data: Path, **choices) -> dict[float, SetSummary]:
    wc14 = shared_data / "wc14"
    with (
        open_source(wc14 / "annotations") as annotations,
        CameraCollection.open(wc14 / "homographies_carwc") as cameras,
    ):
        run = run_evaluation(
            annotations,
            cameras,
            EvaluationSetup(load_field("soccer"), **choices),
            (2, 5, 10),
            attrgetter("result"),
        )
        assert sum(1 for _ in run) == 186
        return run.summary()


@pytest.mark.parametrize(
    ("choices", "expected"),
    [({"planar_only": True}, (41.3, 83.0, 96.0)), ({}, (35.5, 74.0, 86.1))],
    ids=["planar only", "goals counted as missed"],
)
def test_homographies_of_the_world_cup(shared_data, choices, expected):
    """Figures computed independently of this program."""
    found = summaries(shared_data, **choices)
    jacs = [100 * (found[tau].mean_jac or 0.0) for tau in (2, 5, 10)]
    assert jacs == pytest.approx(expected, abs=0.5)
    # With the labels as they are: at 2 px mirrored ones win some frames, with large errors.
    assert found[10].mean_reprojection_error == pytest.approx(1.73, abs=0.05)


def test_planar_only_is_the_homography_that_leaves_goals_out(shared_data):
    """For cameras that know only the ground both mean the same."""
    planar, left_out = (
        summaries(shared_data, planar_only=True),
        summaries(shared_data, off_plane="left_out"),
    )
    assert planar == left_out
