"""A fit kept as the camera of its frame remembers what it was fitted from."""

import hashlib
import json

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.batch.calibration import leave_one_out, save_fit
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.computed_cameras import FittedCameras, FittedFrame
from procc_annotator.errors import SaveError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.fit_record import annotation_digest
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.metrics.setup import EvaluationSetup

FIELD = load_field("soccer")
SIZE = (1280, 720)


@pytest.fixture(scope="module")
def clicks(sample_data) -> FrameAnnotation:
    path = sample_data / "00002.json"
    return read_annotation(path.read_bytes(), path=str(path), field=FIELD)


@pytest.fixture(scope="module")
def pinhole(clicks) -> FitResult:
    return fit_camera(clicks, FIELD, model="P", size=SIZE)


@pytest.fixture(scope="module")
def homography(clicks) -> FitResult:
    return fit_camera(clicks, FIELD, model="H", size=SIZE)


def test_it_is_a_camera_like_any_other(tmp_path, clicks, sample_data, pinhole):
    path = save_fit(tmp_path / "fitted", "00002", clicks, pinhole, field=FIELD.name)
    cameras = CameraSet.open(path.parent)
    found = cameras.camera("00002", SIZE)
    points = np.array([[0.0, 0.0, 0.0], [20.0, -10.0, 0.0]])
    assert found.camera.project(points)[0] == pytest.approx(pinhole.camera.project(points)[0])
    content = json.loads(path.read_text())["fit"]
    assert content["model"] == "P"
    assert content["elements"] + content["left_out"]
    written = (sample_data / "00002.json").read_bytes()
    assert content["annotation_sha256"] == hashlib.sha256(written).hexdigest()


def test_a_frame_has_one_saved_fit(tmp_path, clicks, pinhole, homography):
    for fit, files in (
        (pinhole, {"camera_a.json"}),
        (homography, {"a.npy"}),
        (homography, {"a.npy"}),
        (pinhole, {"camera_a.json"}),
    ):
        save_fit(tmp_path, "a", clicks, fit, field=FIELD.name)
        assert {p.name for p in tmp_path.iterdir()} == files
        assert list(CameraSet.open(tmp_path).frames) == ["a"]


@pytest.mark.parametrize("frames", [["a", "b"], ["game 1/a", "game 2/a", "game 2/second half/a"]])
@pytest.mark.parametrize("model", ["P", "H"])
def test_what_it_was_fitted_to_is_known_in_folders_too(
    tmp_path, clicks, pinhole, homography, model, frames
):
    for frame in frames:
        fit = pinhole if model == "P" else homography
        save_fit(tmp_path, frame, clicks, fit, field=FIELD.name)
    with CameraCollection.open(tmp_path) as cameras:
        assert list(cameras.frames) == frames
        told = [cameras.read(frame).fitted_on for frame in frames]
    assert told == [annotation_digest(clicks)] * len(frames)


def test_a_table_tells_of_files_that_are_composed_otherwise(tmp_path):
    """As where files were copied to a Mac, and the table was not written anew."""
    camera = PinholeCamera(0.1, 1.3, 0.0, (0.0, 60.0, -15.0), (1500.0, 1500.0), (479.5, 269.5))
    (tmp_path / "camera_cafe\u0301.json").write_bytes(write_camera(camera))
    rows = "name,annotation_sha256\ncaf\u00e9,0123\n"
    (tmp_path / "calibration.csv").write_text(rows, "utf-8")
    with CameraCollection.open(tmp_path) as cameras:
        assert cameras.read("caf\u00e9").fitted_on == "0123"


@pytest.mark.parametrize("theirs", ["camera_a.json", "a.npy"])
def test_other_cameras_are_not_replaced(tmp_path, clicks, pinhole, theirs):
    path = tmp_path / theirs
    if path.suffix == ".npy":
        np.save(path, np.eye(3))
    else:
        path.write_text(json.dumps({"pan_degrees": 1, "fit": {"program": "another"}}))
    before = path.read_bytes()
    with pytest.raises(SaveError, match="not saved as a fit"):
        save_fit(tmp_path, "a", clicks, pinhole, field=FIELD.name)
    assert [p.name for p in tmp_path.iterdir()] == [theirs]
    assert path.read_bytes() == before


class TestFittedCameras:
    def test_they_are_scaled_to_the_size_asked_for(self, clicks, pinhole):
        cameras = FittedCameras().with_fit("a", FittedFrame(clicks, pinhole))
        found = cameras.camera("a", (640, 360))
        point = np.array([[0.0, 0.0, 0.0]])
        whole, _ = pinhole.camera.project(point)
        half, _ = found.camera.project(point)
        assert half * (1279 / 639, 719 / 359) == pytest.approx(whole, abs=1e-6)

    def test_a_failure_says_why_and_others_never_change(self, clicks):
        failed = FitResult("P", SIZE, None, "2 elements, 3 needed")
        before = FittedCameras()
        cameras = before.with_fit("a", FittedFrame(clicks, failed))
        assert before.fits == {}
        assert cameras.frames == {}
        assert cameras.camera("a", SIZE) is None
        assert cameras.why_none("a") == "2 elements, 3 needed"
        assert cameras.without(["a"]).why_none("a") == "no fit of a yet"
        assert cameras.without(["b"]) is cameras


def test_of_cameras_in_one_file_it_is_known_too(tmp_path, clicks, pinhole):
    own = json.loads(save_fit(tmp_path / "a", "1", clicks, pinhole, field=FIELD.name).read_text())
    plain = {key: value for key, value in own.items() if key != "fit"}
    (tmp_path / "all.json").write_text(json.dumps({"1": own, "2": plain}))
    with CameraCollection.open(tmp_path / "all.json") as cameras:
        told = {frame: cameras.read(frame).fitted_on for frame in cameras.frames}
    assert told == {"1": annotation_digest(clicks), "2": None}


def test_what_has_no_place_on_the_field_is_not_left_out(clicks, pinhole):
    few = FrameAnnotation(clicks.polylines[:5])
    unnamed = Polyline("Line unknown", (Point(0.1, 0.1), Point(0.2, 0.12)))
    setup = EvaluationSetup(FIELD, size=SIZE)
    plain, more = (
        leave_one_out(one, pinhole, setup, "P")
        for one in (few, FrameAnnotation((*few.polylines, unnamed)))
    )
    assert plain
    assert [e.name for e in more] == [e.name for e in plain]
