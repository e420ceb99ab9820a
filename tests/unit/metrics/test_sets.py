"""Figures of a set, reckoned by hand."""

from __future__ import annotations

import pickle
import statistics

import pytest

from procc_annotator.errors import UsageError
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.sets import SetAccumulator
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
