"""Cameras of a dataset: found by frame, scaled with a remark, a damaged file not the end of all."""

import json
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.assist.track_anchors import anchors_of
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.tracking.track import FrameState, TrackedFrame
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.computed_cameras import TrackedCameras, review_reason
from procc_annotator.dataset.sequence import FrameSequence
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import CameraError
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras import collection
from procc_annotator.formats.cameras.soccernet import write_camera

CAMERA = PinholeCamera(0.1, 1.3, 0.0, (0.0, 60.0, -15.0), (1500.0, 1500.0), (479.5, 269.5))


def test_cameras_by_frame(tmp_path):
    (tmp_path / "camera_1.json").write_bytes(write_camera(CAMERA))
    (tmp_path / "camera_2.json").write_text(json.dumps({"pan_degrees": 1}))
    cameras = CameraSet.open(tmp_path)
    assert cameras.name == tmp_path.name
    assert list(cameras.frames) == ["1", "2"]
    found = cameras.camera("1", (960, 540))
    assert (found.model, found.notice) == ("pinhole P", None)
    assert cameras.camera("3", (960, 540)) is None
    with pytest.raises(CameraError, match=r"camera_2\.json: the key 'tilt_degrees' is missing"):
        cameras.camera("2", (960, 540))


def test_a_homography_is_scaled_and_says_so(tmp_path):
    np.save(tmp_path / "1.npy", np.array([[0.05, 0, 25.5], [0, 0.05, 19.0], [0, 0, 1]]))
    cameras = CameraSet.open(tmp_path, name="CARWC")
    found = cameras.camera("1", (960, 540))
    assert found.notice == "scaled from 1280x720 to 960x540"
    assert found.model == "homography"
    assert cameras.name == "CARWC"


def test_a_camera_file_that_vanished(tmp_path):
    (tmp_path / "camera_1.json").write_bytes(write_camera(CAMERA))
    cameras = CameraSet.open(tmp_path)
    (tmp_path / "camera_1.json").unlink()
    with pytest.raises(CameraError, match="cannot be read"):
        cameras.camera("1", (960, 540))


def test_sets_are_named_so_that_they_can_be_told_apart(tmp_path, monkeypatch):
    for name in ("run.1", "run.2"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "camera_1.json").write_bytes(write_camera(CAMERA))
    assert [CameraSet.open(tmp_path / n).name for n in ("run.1", "run.2")] == ["run.1", "run.2"]
    assert CameraSet.open(tmp_path / "run.1" / "camera_1.json").name == "camera_1"
    monkeypatch.chdir(tmp_path / "run.2")
    assert CameraSet.open(Path()).name == "run.2"


def put(folder: Path, name: str, camera: PinholeCamera = CAMERA) -> None:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(write_camera(camera))


def later(folder: Path) -> None:
    """As if it was changed a second later: clocks of file systems are coarse."""
    for path in (folder, folder.parent):
        changed = path.stat().st_mtime_ns + 10**9
        os.utime(path, ns=(changed, changed))


@pytest.mark.parametrize("written", ["g1/camera_2.json", "season/h2/camera_1.json"])
def test_cameras_that_come_to_a_folder_of_a_tree_are_found(tmp_path, written):
    put(tmp_path, "g1/camera_1.json")
    put(tmp_path, "season/h1/camera_1.json")
    cameras = CameraSet.open(tmp_path)
    frame = written.replace("camera_", "").removesuffix(".json")
    asked = ["g1/1", frame]
    assert cameras.look_again(asked) is None
    put(tmp_path, written)
    later((tmp_path / written).parent)
    found = cameras.look_again(asked)
    assert found is not None
    newer, changed = found
    assert changed == {frame}
    assert newer.camera(frame, (960, 540)) is not None
    (tmp_path / written).unlink()
    later((tmp_path / written).parent)
    again = newer.look_again(asked)
    assert again[1] == {frame}


def test_changed_cameras_are_told_by_the_names_they_are_asked_for(tmp_path):
    """Frames of a tree are called `1` by cameras that all lie in one folder."""
    put(tmp_path, "g1/camera_1.json")
    put(tmp_path, "g1/camera_2.json")
    cameras = CameraSet.open(tmp_path)
    asked = ["g1/1", "g1/2"]
    for name in asked:
        assert cameras.camera(name, (960, 540)) is not None
    put(tmp_path, "g1/camera_1.json", replace(CAMERA, pan_rad=0.1234567))
    found = cameras.look_again(asked)
    assert found[1] == {"g1/1"}


def test_a_file_that_comes_while_the_folders_are_listed_is_seen_later(tmp_path, monkeypatch):
    for game in ("game1", "game2"):
        (tmp_path / game).mkdir()
        (tmp_path / game / "1.json").write_bytes(write_camera(CAMERA))
    list_cameras = collection.list_cameras

    def listed(*args: object) -> object:
        found = list_cameras(*args)
        (tmp_path / "game2/2.json").write_bytes(write_camera(CAMERA))
        return found

    monkeypatch.setattr(collection, "list_cameras", listed)
    cameras = CameraSet.open(tmp_path)
    monkeypatch.undo()
    asked = ["game1/1", "game2/1", "game2/2"]
    newer, others = cameras.look_again(asked)
    assert others == {"game2/2"}
    assert list(newer.frames) == asked


# Which annotated frames a track has to pass, and how far pictures follow one another.

SIZE = (960, 540)


def test_clicks_that_leave_the_camera_open_are_no_anchor(sample_data):
    field = load_field("soccer")
    workspace = Workspace.open(sample_data, field=field)
    indices = {n: workspace.index[f"0000{n}"] for n in (1, 2)}

    assert set(anchors_of(workspace, indices, field, size=SIZE)) == {2}  # three lines in the first


def test_pictures_are_missing_between_runs():
    numbers = np.array([3, 4, 5, 8, 9, 12])
    folder = FrameSequence(numbers, 3, 12, 25.0, None, {})
    found = [folder.unbroken(number) for number in (3, 5, 8, 9, 12)]

    assert found == [range(3, 6), range(3, 6), range(8, 10), range(8, 10), range(12, 13)]
    video = FrameSequence(numbers, 0, 20, 25.0, Path("match.mp4"), {})
    assert video.unbroken(8) == range(21)


# Cameras of a shot that was followed: what of them is in doubt, and what a frame is told.

TRACKED_SIZE = (1280, 720)
TRACKED = PinholeCamera(0.1, 1.4, 0.0, (0.0, 60.0, -15.0), (1500.0, 1500.0), (639.5, 359.5))


def frame(
    state: FrameState = "followed", coverage: float = 0.9, residual_px: float | None = 0.4
) -> TrackedFrame:
    fit = None if state == "lost" else FitResult("R", TRACKED_SIZE, TRACKED)
    reason = "a close-up" if state == "lost" else ""
    return TrackedFrame(7, state, reason, fit, coverage, residual_px, 7)


@pytest.mark.parametrize(
    ("found", "doubt"),
    [
        (frame(), ""),
        (frame("anchor", coverage=0.1), ""),  # somebody clicked there
        (frame("lost"), "a close-up"),
        (frame("bridged"), "carried over by the picture's motion, not measured on paint"),
        (frame(coverage=0.59), "only 59% of the lines in sight are on paint"),
        (replace(frame(coverage=0.59), explained=0.95), ""),  # what is missing is worn
        (
            replace(frame(coverage=0.25), explained=0.95),
            "only 25% of the lines in sight are on paint",
        ),
        (frame(residual_px=2.5), "the paint is 2.5 px from the lines"),
        (frame(residual_px=None), ""),
    ],
)
def test_what_should_be_looked_at(found, doubt):
    assert review_reason(found) == doubt


def test_a_camera_is_scaled_to_the_evaluation_and_bears_its_doubt():
    cameras = TrackedCameras({"a": frame(), "b": frame("bridged"), "c": frame("lost")})

    assert set(cameras.frames) == {"a", "b"}
    found = cameras.camera("a", (960, 540))
    assert found.camera.focal_px[0] == pytest.approx(1500 * 959 / 1279)
    assert found.notice is None
    doubtful = cameras.camera("b", (960, 540))
    assert "carried over" in str(doubtful.notice)
    assert cameras.camera("c", (960, 540)) is None
    assert cameras.why_none("c") == "no track here: a close-up"
    assert cameras.why_none("d") == "not followed so far"
