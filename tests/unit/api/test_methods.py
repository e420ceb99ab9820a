"""Cameras of any model written as projections, and read back as a method with equal figures."""

import json

import numpy as np
import pytest

from procc_annotator import (
    CameraError,
    UsageError,
    camera_from_function,
    evaluate_set,
    load_annotations,
    load_cameras,
    save_camera,
    save_projection,
)

THRESHOLDS = (2.0, 5.0, 10.0, 20.0)


def kannala_brandt(x, y, z):
    theta = np.arctan2(np.hypot(x, y), z)
    distorted = theta * (1 + 0.05 * theta**2 - 0.01 * theta**4)
    ratio = np.where(theta < 1.4, distorted, np.nan) / np.maximum(np.hypot(x, y), 1e-12)
    return x * ratio, y * ratio


def equirectangular(x, y, z):
    return np.arctan2(x, z), np.arctan2(y, np.hypot(x, z))


def as_function(camera, lens):
    """A camera of the same pose and focal length with another lens; nothing but a function."""

    def project(points_world):
        places = points_world - np.array(camera.position_world)
        x, y = lens(*(places @ camera.rotation_cam_from_world.T).T)
        return np.column_stack((x, y)) * camera.focal_px[0] + (480.0, 270.0)

    return camera_from_function(project)


@pytest.fixture(scope="module", params=["world cup", "sample data"])
def annotated(request, sample_data):
    if request.param == "sample data":
        return load_annotations(sample_data), load_cameras(sample_data / "cameras" / "bad")
    world_cup = request.getfixturevalue("shared_data") / "wc14"
    return load_annotations(world_cup / "annotations"), load_cameras(world_cup / "cameras_nbjw")


@pytest.mark.parametrize("lens", [kannala_brandt, equirectangular])
def test_a_written_projection_has_the_figures_of_the_function(annotated, lens, tmp_path):
    annotations, cameras = annotated
    functions = {name: as_function(loaded.camera, lens) for name, loaded in cameras.items()}
    out = tmp_path / "method.zip"
    assert set(save_projection(out, functions.get, annotations)) <= set(functions)
    for protocol in ("soccernet", "procc"):
        own, read = (
            evaluate_set(annotations, method, thresholds=THRESHOLDS, protocol=protocol)
            for method in (functions, out)
        )
        assert [s.mean_jac for s in own.summaries.values()] == [
            s.mean_jac for s in read.summaries.values()
        ]
        for name, scores in own.frames.items():
            for threshold, score in scores.items():
                other = read.frames[name][threshold]
                assert (score.tp, score.fp, score.fn) == (other.tp, other.fp, other.fn), name
                assert score.mean_error == pytest.approx(other.mean_error, abs=1e-9)


def test_a_projection_is_for_one_field_and_scales(sample_data, tmp_path):
    annotations = load_annotations(sample_data)
    cameras = load_cameras(sample_data / "cameras" / "bad")
    written = save_projection(tmp_path / "out", cameras)
    with pytest.raises(UsageError, match="is there already"):
        save_projection(tmp_path / "out", cameras)
    for problem, given in [
        ("expected the name of a folder", {"path": tmp_path / "a.json", "cameras": cameras}),
        ("no frame has a camera", {"path": tmp_path / "b", "cameras": {"1": None}}),
        ("names of the frames", {"path": tmp_path / "b", "cameras": list(cameras.values())}),
        (r"found 1 cameras", {"path": tmp_path / "b", "cameras": [None], "frames": ["1", "2"]}),
    ]:
        with pytest.raises(UsageError, match=problem):
            save_projection(**given)
    with pytest.raises(UsageError, match="projection of another field"):
        evaluate_set(annotations, tmp_path / "out", field="futsal")
    own, read = (
        evaluate_set(
            annotations, method, protocol="procc", size=(1920, 1080), camera_size=(960, 540)
        )
        for method in (cameras, tmp_path / "out")
    )
    assert read.summaries[5.0].mean_error == pytest.approx(own.summaries[5.0].mean_error, abs=0.003)
    file = tmp_path / "out" / f"{written[0]}.json"
    content = json.loads(file.read_text())
    file.write_text(json.dumps({**content, "samples": {"Middle line": [[1, 2]]}}))
    with pytest.raises(UsageError, match="holds 1 samples of 'Middle line', expected"):
        evaluate_set(annotations, tmp_path / "out")
    for key, value, place in [
        ("format", "procc-annotator projection 9", "format"),
        ("size", [960], "size"),
        ("samples", {"Middle line": [[1, "a"]]}, r"Middle line\[0\]"),
    ]:
        file.write_text(json.dumps({**content, key: value}))
        with pytest.raises(CameraError, match=place):
            load_cameras(tmp_path / "out")


def test_a_function_cannot_be_saved_as_a_camera_but_as_its_projection(tmp_path):
    camera = camera_from_function(lambda points: points[:, :2])
    with pytest.raises(UsageError, match="save_projection"):
        save_camera(camera, tmp_path / "camera_1.json", size=(960, 540))
