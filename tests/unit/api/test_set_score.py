"""Scores of sets: the figures of the command, tables, and what chance leaves."""

import shutil
import sys
from operator import attrgetter

import numpy as np
import pytest

from procc_annotator import (
    FrameAnnotation,
    UsageError,
    corrected_for,
    evaluate,
    evaluate_set,
    fit_camera,
    jac_curve,
    load_annotations,
    load_camera,
    load_cameras,
    load_dataset,
    load_field,
    save_camera,
)
from procc_annotator.batch.evaluation import run_evaluation
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_source import open_source
from procc_annotator.metrics.setup import EvaluationSetup


@pytest.mark.parametrize(("method", "protocol"), [("bad", "soccernet"), ("homography", "procc")])
def test_the_figures_are_those_of_the_command(sample_data, method, protocol):
    taus = (2.0, 5.0)
    cameras = sample_data / "cameras" / method
    setup = EvaluationSetup(load_field(), (960, 540), protocol)
    with open_source(sample_data) as source, CameraCollection.open(cameras) as collection:
        run = run_evaluation(source, collection, setup, taus, attrgetter("result"))
        results = {result.name: result for result in run}
    found = evaluate_set(sample_data, cameras, thresholds=taus, protocol=protocol)
    assert found.summaries == run.summary()
    assert found.described == run.tally.described
    assert list(found.frames) == list(results)
    models = {row["frame"]: row["model"] or "" for row in found.rows()}
    assert models == {name: result.model for name, result in results.items()}
    for name, result in results.items():
        assert {t: s.tp for t, s in found.frames[name].items()} == {
            t: s.tp for t, s in result.scores.items()
        }


@pytest.mark.parametrize("off_plane", ["missed", "left_out"])
def test_cameras_that_know_the_ground_alone_are_known_as_such(sample_data, off_plane):
    cameras = sample_data / "cameras" / "homography"
    setup = EvaluationSetup(load_field(), (960, 540), off_plane=off_plane)
    with open_source(sample_data) as source, CameraCollection.open(cameras) as collection:
        run = run_evaluation(source, collection, setup, (5.0,), attrgetter("result"))
        assert all(result.ground_only for result in run if result.scores)
    found = evaluate_set(sample_data, cameras, off_plane=off_plane)
    assert found.described == run.tally.described
    assert found._sums.ground_only


def test_cameras_fitted_to_the_clicks_they_are_judged_by_are_marked(sample_data, tmp_path):
    annotations = load_annotations(sample_data)
    names = ("00001", "00002")
    for name in names:
        fit = fit_camera(annotations[name], model="R")
        save_camera(fit, tmp_path / f"camera_{name}.json", fitted_to=annotations[name])
    fits = load_cameras(tmp_path)
    found = evaluate_set({name: annotations[name] for name in names}, fits)
    assert found.described == "soccernet, 960x540, fitted on these clicks"
    loaded_annotation = {name: fit_camera(annotations[name], model="R") for name in names}
    assert (
        evaluate_set({n: annotations[n] for n in names}, loaded_annotation).described
        == found.described
    )
    moved = annotations | {"00001": annotations["00003"]}
    some = evaluate_set(moved, fits)
    mark = "fitted on these clicks, or to another version of these annotations"
    assert some.described == f"soccernet, 960x540, {mark}"
    method = evaluate_set(annotations, sample_data / "cameras" / "bad")
    assert method.described == "soccernet, 960x540"
    assert method.differences(some)[5.0]["mean_jac"].value is not None


def test_annotations_and_cameras_may_be_values(sample_data):
    dataset = load_dataset(sample_data)
    cameras = load_cameras(sample_data / "cameras" / "bad")
    score = evaluate_set(dataset, cameras)
    assert score.summaries == evaluate_set(dataset.annotations, cameras).summaries
    fits = {name: fit_camera(a) for name, a in list(dataset.annotations.items())[:3]}
    fits["00004"] = fit_camera(FrameAnnotation())  # failed: as if there were none
    some = evaluate_set(dataset, fits)
    assert some.summaries[5.0].evaluated == sum(fit.camera is not None for fit in fits.values())
    assert some.summaries[5.0].images == len(dataset.annotations)
    assert some.frames["00004"] == {}
    larger = {name: fit_camera(dataset.annotations[name], size=(1920, 1080)) for name in ("00002",)}
    assert evaluate_set(dataset, larger).summaries[5.0].mean_jac > 0.9


def test_rows_and_classes(sample_data):
    annotations = load_annotations(sample_data)
    cameras = dict(list(load_cameras(sample_data / "cameras" / "true").items())[:4])
    score = evaluate_set(annotations, cameras, thresholds=(2.0, 5.0))
    rows = score.rows()
    assert len(rows) == 2 * len(annotations)
    for row in rows:
        of = score.frames[row["frame"]].get(row["threshold"])
        told = evaluate(
            annotations[row["frame"]], cameras[row["frame"]], threshold=row["threshold"]
        ) if of else None  # fmt: skip
        assert row["jac"] == (told.jac if told else None)
        assert (row["tp"] is None) == (row["model"] is None) == (of is None)
        assert set(row) >= {"tp", "fp", "fn", "mirrored", "precision", "recall", "mean_error"}
    summary = score.summaries[5.0]
    classes = [row for row in score.class_rows() if row["threshold"] == 5.0]
    assert {row["class"] for row in classes} == set(summary.per_class)
    assert classes[0]["jac"] == summary.per_class[classes[0]["class"]].jac


def test_a_dataframe_where_there_is_pandas(sample_data, monkeypatch):
    cameras = sample_data / "cameras" / "true"
    score = evaluate_set(sample_data, cameras)
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(UsageError, match="pandas is not installed"):
        score.to_dataframe()
    monkeypatch.undo()
    pandas = pytest.importorskip("pandas", reason="pandas is not installed")
    frame = score.to_dataframe()
    assert isinstance(frame, pandas.DataFrame)
    assert frame.to_dict("records") == score.rows()
    assert frame["jac"].mean() == pytest.approx(score.summaries[5.0].mean_jac)


def test_the_curve_goes_through_the_figures(sample_data):
    annotations = load_annotations(sample_data)
    cameras = load_cameras(sample_data / "cameras" / "bad")
    score = evaluate_set(annotations, cameras, thresholds=(2.0, 5.0))
    taus, values = score.mean_curve()
    assert (taus[0], taus[-1], len(taus)) == (0.5, 30.0, 296)
    for tau, summary in score.summaries.items():
        assert values[taus == tau] == pytest.approx(summary.mean_jac, abs=1e-6)
    name = next(iter(cameras))
    one = jac_curve(annotations[name], cameras[name], [5.0, 2.0])
    assert one.tolist() == [score.frames[name][5.0].jac, score.frames[name][2.0].jac]


def test_intervals_and_differences(sample_data):
    dataset = load_dataset(sample_data)
    good, bad = (evaluate_set(dataset, sample_data / "cameras" / m) for m in ("true", "bad"))
    match = {name: str(int(name) // 3) for name in dataset.annotations}
    for cluster in (None, "none", match):
        interval = bad.intervals(cluster)[5.0]["mean_jac"]
        assert interval.low <= bad.summaries[5.0].mean_jac <= interval.high
    assert set(bad.intervals(match, method="bca", draws=500)[5.0]) >= {"mean_jac", "mean_error"}
    found = good.differences(bad, match)[5.0]["mean_jac"]
    assert found.corrected is None
    assert corrected_for([found] * 3)[0].corrected == min(1.0, 3 * found.p)
    assert found.value > 0
    assert found.interval.low <= found.value <= found.interval.high
    for wrong in ({"cluster": "matches"}, {"method": "normal"}, {"draws": 0}, {"level": 95}):
        with pytest.raises(UsageError):
            bad.intervals(**wrong)
    with pytest.raises(UsageError, match="scored differently"):
        good.differences(evaluate_set(dataset, sample_data / "cameras" / "bad", protocol="procc"))


def test_what_cannot_be_scored(sample_data):
    annotations = load_annotations(sample_data)
    with pytest.raises(UsageError, match="named like '00001', cameras like 'other'"):
        evaluate_set(annotations, {"other": None})
    with pytest.raises(UsageError, match="no annotated frame"):
        evaluate_set({}, {})
    with pytest.raises(UsageError, match="expected a path, cameras by frame name"):
        evaluate_set(annotations, [1, 2])
    with pytest.raises(UsageError, match="annotations: expected them by frame name"):
        evaluate_set(None, {})
    with pytest.raises(UsageError, match="camera of 00002: expected a camera"):
        evaluate_set(annotations, {"00002": np.eye(3)})
    with pytest.raises(UsageError, match="expected an annotation"):
        evaluate_set({"00002": {"Middle line": []}}, {"00002": fit_camera(annotations["00002"])})
    with pytest.raises(UsageError, match="at least one threshold"):
        evaluate_set(annotations, {}, thresholds=())


def test_the_path_of_a_dataset_tells_its_field_as_well(sample_data):
    place = sample_data / "basketball"
    by_path = evaluate_set(place, place / "cameras" / "bad")
    assert (
        by_path.described == evaluate_set(load_dataset(place), place / "cameras" / "bad").described
    )
    assert "basketball_fiba" in by_path.described
    assert by_path.summaries[5.0].mean_jac > 0.1
    with pytest.warns(UserWarning, match="classes of no element of the field always count as"):
        nominal = evaluate_set(place, place / "cameras" / "bad", field="soccer")
    assert nominal.described == "soccernet, 960x540"


def test_other_thresholds_are_no_other_frames(sample_data):
    one, other = (
        evaluate_set(sample_data, sample_data / "cameras" / "bad", thresholds=taus)
        for taus in ((5.0,), (5.0, 2.0))
    )
    with pytest.raises(UsageError, match=r"other thresholds: 5 px and 5 px, 2 px"):
        one.differences(other)


def test_annotations_in_pixels_are_told(sample_data):
    annotations = load_annotations(sample_data)
    name = "00002"
    px = FrameAnnotation.from_dict(annotations[name].to_dict(size=(960, 540)))
    with pytest.warns(UserWarning, match=r"look like pixels, expected 0 to 1, in .*00002"):
        evaluate_set({name: px}, {name: fit_camera(annotations[name])})
    with pytest.warns(UserWarning, match=r"no element is annotated in 1 frame \(00002\): whatever"):
        evaluate_set({name: FrameAnnotation()}, {name: fit_camera(annotations[name])})


def test_frames_are_found_however_cameras_call_them(sample_data, tmp_path):
    """Without the folder of pictures, composed otherwise, in the only folder of their place."""
    for place in ("set/cafe\u0301/img1", "cameras/caf\u00e9"):
        (tmp_path / place).mkdir(parents=True)
    camera = sample_data / "cameras/pinhole/camera_00001.json"
    shutil.copy(sample_data / "00001.json", tmp_path / "set/cafe\u0301/img1/1.json")
    shutil.copy(camera, tmp_path / "cameras/caf\u00e9/1.json")
    cameras = load_cameras(tmp_path / "cameras")
    assert list(cameras) == ["1"]
    found = evaluate_set(tmp_path / "set", cameras)
    assert list(found.frames) == ["cafe\u0301/img1/1"]
    by_name = {"caf\u00e9/1": load_camera(camera)}
    assert evaluate_set(tmp_path / "set", by_name).rows() == found.rows()
