"""Reports, comparisons and agreement from values of a program: the figures of the commands."""

import json
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator import (
    UsageError,
    camera_from_function,
    compare_annotators,
    compare_cameras,
    compare_methods,
    evaluate,
    evaluate_set,
    fit_camera,
    leave_one_out,
    load_annotations,
    load_cameras,
    load_dataset,
    project_field,
    save_projection,
    write_report,
)


@pytest.fixture(scope="module")
def given(sample_data):
    cameras = load_cameras(sample_data / "cameras" / "bad")
    functions = {n: camera_from_function(c.camera.project) for n, c in cameras.items()}
    annotations, true = (
        load_annotations(sample_data),
        load_cameras(sample_data / "cameras" / "true"),
    )
    methods = {
        "folder": sample_data / "cameras" / "bad",
        "values": cameras,
        "function": functions.get,
        "list": [true.get(name) for name in annotations],
    }
    return annotations, methods


@pytest.mark.parametrize("protocol", ["soccernet", "procc"])
def test_methods_in_any_form_have_the_figures_of_the_set(given, sample_data, protocol):
    annotations, methods = given
    found = compare_methods(
        annotations, methods, thresholds=5, resamples=200, protocol=protocol, planar_only=True
    )
    for one in found["evaluations"]:
        own = evaluate_set(annotations, methods[one["method"]], protocol=protocol, planar_only=True)
        summary, expected = one["summary"]["5"], own.summaries[5.0]
        assert summary["mean_jac"] == expected.mean_jac
        assert summary["mean_error"] == expected.mean_error
    few = dict(list(annotations.items())[:3])
    changed = replace(load_dataset(sample_data), annotations=few)
    (own,) = compare_methods(changed, {"list": methods["list"][:3]}, resamples=100)["evaluations"]
    assert len(own["images"]) == 3
    chance = found["chance"][0]
    assert len(chance["differences"]["rows"]) == 6
    assert len(chance["intervals"]["rows"]) == 4
    assert all(row["p_holm"] >= row["p"] for row in chance["differences"]["rows"])


def test_a_report_from_values_with_fits_marked(given, sample_data, tmp_path):
    annotations, methods = given
    fits = {name: fit_camera(one) for name, one in list(annotations.items())[:3]}
    files = [tmp_path / "report.html", tmp_path / "report.json"]
    chosen = {"function": methods["function"], "list": methods["list"], "fits": fits}
    said = write_report(
        files, load_dataset(sample_data), chosen, disagreement=[("list", "fits")], title="Ours"
    )
    assert said == ()
    page = files[0].read_text()
    assert "Ours" in page
    assert page.count("data:image") > 4
    report = json.loads(files[1].read_bytes())
    assert {source["name"] for source in report["sources"]} == set(chosen)
    with pytest.raises(UsageError, match="no option 'tau'; there are field, size"):
        compare_methods(annotations, methods, tau=5)
    with pytest.raises(UsageError, match="expected them by name, found list"):
        write_report(tmp_path / "a.html", annotations, [1])


def test_two_methods_annotators_and_shots(given, sample_data):
    annotations, methods = given
    compared = compare_cameras(methods["values"], sample_data / "cameras" / "true", size=(480, 270))
    assert compared["size"] == [480, 270]
    assert 0 < compared["summary"]["metres"]["median"] < 5
    same = compare_cameras(methods["function"], methods["values"])
    assert same["summary"]["metres"]["maximum"] < 1e-4
    agreed = compare_annotators({"a": sample_data, "b": annotations})
    assert agreed["summary"]["mean_jac"] == {"5": 1.0}
    camera = load_cameras(sample_data / "cameras" / "true")["00002"].camera
    shot = {f"{n:05}": replace(camera, pan_rad=camera.pan_rad + 0.002 * n) for n in range(12)}
    clicks = dict.fromkeys(shot, annotations["00002"])
    clicks = {name: clicks[name] for name in list(clicks)[::5]}
    called = {"pan": shot.get, "values": shot}
    found = compare_methods(clicks, called, resamples=100, over_time=True)
    rows = found["over_time"]["over_time"]["rows"]
    assert [(row["frames"], row["jumps"]) for row in rows] == [(12, 0), (12, 0)]
    assert rows[0]["jitter_px"] == rows[1]["jitter_px"]


def test_what_a_fit_predicts_is_worse_than_what_it_explains(given):
    annotations, _ = given
    found = leave_one_out(annotations["00002"], model="P")
    assert {one.name for one in found} <= set(annotations["00002"].annotated)
    predicted = [one.predicted_px for one in found if one.predicted_px is not None]
    assert np.mean(predicted) > np.mean([one.explained_px for one in found])
    assert len(found) > 5


def test_wrong_arguments_are_one_error_each(given, tmp_path):
    annotations, methods = given
    two = {name: methods[name] for name in ("values", "folder")}
    for match, call in (
        ("'00001' in anna, '00002' in ben", lambda: compare_annotators(
            {"anna": {"00001": annotations["00001"]}, "ben": {"00002": annotations["00002"]}})),
        ("no method", lambda: compare_methods(annotations, {})),
        ("by name", lambda: compare_methods(annotations, {1: methods["values"]})),
        ("at least 100", lambda: compare_methods(annotations, two, resamples=3)),
        ("pairs of names", lambda: write_report(
            tmp_path / "a.csv", annotations, two, disagreement=(("values",),))),
        ("names of frames", lambda: save_projection(tmp_path / "p", methods["values"], "00001")),
        ("at least one", lambda: save_projection(tmp_path / "p", methods["values"], [])),
        ("at least one", lambda: compare_cameras(methods["values"], methods["folder"], "00001")),
        ("'1' and 'a/2' lie at several depths", lambda: save_projection(
            tmp_path / "p", lambda _: methods["values"]["00002"], ["1", "a/2"])),
        ("seed: expected a whole", lambda: write_report(
            tmp_path / "a.csv", annotations, two, seed="x")),
        ("workers: expected a whole", lambda: compare_methods(annotations, two, workers="2")),
        ("is no dimension", lambda: evaluate_set(annotations, two["values"], field="soccer:a=x")),
    ):  # fmt: skip
        with pytest.raises(UsageError, match=match):
            call()
    with pytest.warns(UserWarning, match="nothing is measured over time"):
        write_report(tmp_path / "a.csv", annotations, two, over_time=True, thresholds=np.array([5]))
    assert (tmp_path / "a.csv").exists()


def test_a_wrong_size_and_a_world_with_z_up_are_named(given):
    annotations, methods = given
    with pytest.warns(UserWarning, match="no element passes.* evaluated at 1920x1080"):
        evaluate_set(
            annotations, {n: c.camera for n, c in methods["values"].items()}, size=(1920, 1080)
        )
    camera = methods["values"]["00002"].camera
    x, y, z = camera.position_world
    below = replace(camera, position_world=(x, y, -z))
    with pytest.warns(match="m below the ground"), pytest.warns(match="shows no element"):
        evaluate(annotations["00002"], below)


def test_values_are_shown_in_a_line(given, sample_data):
    annotations, methods = given
    fit = fit_camera(annotations["00002"])
    score = evaluate_set(annotations, methods["values"])
    for value in (
        fit,
        score,
        load_dataset(sample_data),
        methods["values"]["00002"],
        score.frames["00002"][5.0],
    ):
        assert len(repr(value)) < 1500
        assert "\n" not in repr(value)
    assert project_field(fit)
    assert np.isfinite(fit.covariance).all()
