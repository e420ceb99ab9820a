"""Files that hold the cameras of many frames: alone, in folders, in archives."""

import json
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.errors import CameraError, InputError
from procc_annotator.formats.cameras import collection
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.krt import krt_content
from procc_annotator.formats.cameras.soccernet import write_camera

CAMERA = PinholeCamera(0.1, 1.3, 0.0, (0.0, 60.0, -15.0), (1500.0, 1500.0), (479.5, 269.5))
SOCCERNET: dict[str, Any] = json.loads(write_camera(CAMERA))


def line(name: str) -> str:
    return json.dumps({"image_ids": name, **SOCCERNET}) + "\n"


def zipped(folder: Path, inside: str = "") -> Path:
    target = folder.with_suffix(".zip")
    with zipfile.ZipFile(target, "w") as archive:
        for path in sorted(folder.iterdir()):
            archive.write(path, inside + path.name)
    return target


def make(folder: Path, files: dict[str, object]) -> Path:
    folder.mkdir()
    for name, content in files.items():
        text = content if isinstance(content, str) else json.dumps(content)
        (folder / name).write_text(text)
    return folder


@pytest.mark.parametrize("fmt", ["auto", "tvcalib"])
def test_a_container_alone_in_a_folder_and_in_an_archive(tmp_path, fmt):
    lines = line("00010.jpg") + line("9.jpg")
    folder = make(tmp_path / "run", {"per_sample_output.json": lines})
    for path in (folder, folder / "per_sample_output.json", zipped(folder), zipped(folder, "a/")):
        with CameraCollection.open(path, fmt) as cameras:
            assert list(cameras.frames) == ["9", "00010"]
            assert cameras.read("9").camera == CAMERA
            assert len(list(cameras.files())) == 1
            assert cameras.display("9").endswith("per_sample_output.json: line 2")
            assert not cameras.notices
            found = CameraSet(cameras, "run").camera("00010", (960, 540))
            assert found.camera == CAMERA


def test_what_lies_beside_a_container_does_no_harm(tmp_path):
    folder = make(
        tmp_path / "run",
        {
            "per_sample_output.json": line("1.jpg"),
            "results.json": {"meanAccuracies": 0.8},
            "hparams.yml": "a: 1",
            "README.txt": "read me",
        },
    )
    with CameraCollection.open(folder) as cameras:
        assert set(cameras.frames) == {"1", "results", "hparams", "README"}
        assert cameras.read("1").camera == CAMERA
    with CameraCollection.open(folder, "tvcalib") as cameras:
        assert set(cameras.frames) == {"1"}
        assert len(cameras.notices) == 1
        assert "passed over: " in cameras.notices[0]
        assert "results.json" in cameras.notices[0]


def test_cameras_deeper_than_others_are_named(tmp_path):
    folder = make(tmp_path / "run", {"camera_1.json": SOCCERNET})
    make(folder / "a", {"camera_2.json": SOCCERNET, "notes.txt": "1"})
    with CameraCollection.open(folder) as cameras:
        assert [*cameras.frames] == ["1"]
        assert cameras.notices[0].startswith("1 file (a/camera_2.json) in folders below left out")


def test_several_containers_are_one_collection_unless_they_share_a_frame(tmp_path):
    halves = {
        "half1.json": {"1.jpg": {"cp": SOCCERNET}},
        "half2.json": {"2.jpg": {"cp": SOCCERNET}},
    }
    folder = make(tmp_path / "game", dict(halves))
    for fmt in ("auto", "broadtrack"):
        with CameraCollection.open(folder, fmt) as cameras:
            assert list(cameras.frames.items()) == [("1", "half1.json"), ("2", "half2.json")]
    (folder / "again.json").write_text(json.dumps(halves["half2.json"]))
    with pytest.raises(InputError, match=r"second file for frame '2', after again\.json"):
        CameraCollection.open(folder)


def test_one_damaged_container_among_several_is_passed_over_with_a_notice(tmp_path):
    folder = make(
        tmp_path / "game", {"half1.json": {"1.jpg": {"cp": SOCCERNET}}, "half2.json": '{"2.jpg": {'}
    )
    with CameraCollection.open(folder, "broadtrack") as cameras:
        assert list(cameras.frames) == ["1"]
        assert "half2.json" in cameras.notices[0]
    (folder / "half1.json").unlink()
    with pytest.raises(CameraError, match="may be cut off"):
        CameraCollection.open(folder, "broadtrack")


def test_cameras_keyed_by_frame(tmp_path):
    one = krt_content(CAMERA, (960, 540))
    keyed = {"b.png": one, "a": {"K": 1, "R": 2}, "c.v2": one}
    (tmp_path / "all.json").write_text(json.dumps(keyed))
    for fmt in ("auto", "krt"):
        with CameraCollection.open(tmp_path / "all.json", fmt) as cameras:
            assert list(cameras.frames) == ["a", "b", "c.v2"]
            np.testing.assert_allclose(
                cameras.read("b").camera.rotation_cam_from_world,
                CAMERA.rotation_cam_from_world,
                atol=1e-15,
            )
            with pytest.raises(CameraError, match=r"all\.json: a: K: expected a list of numbers"):
                cameras.read("a")
    points = {"1.jpg": {"Middle line": [{"x": 0, "y": 0}]}, "2": {"Middle line": 5}, "3": []}
    (tmp_path / "points.json").write_text(json.dumps(points))
    with pytest.raises(CameraError, match="read with the camera format polylines"):
        CameraCollection.open(tmp_path / "points.json")
    with CameraCollection.open(tmp_path / "points.json", "polylines") as cameras:
        assert list(cameras.frames) == ["1", "2", "3"]
        assert cameras.read("1").model == "projections"
        with pytest.raises(CameraError, match="2: Middle line: expected a list of points"):
            cameras.read("2")
        with pytest.raises(CameraError, match="3: expected an object"):
            cameras.read("3")


def test_a_container_is_decoded_once(tmp_path, monkeypatch):
    (tmp_path / "p.json").write_text("".join(line(f"{i}.jpg") for i in range(50)))
    cameras = CameraCollection.open(tmp_path / "p.json")
    (tmp_path / "p.json").unlink()
    for frame in cameras.frames:
        assert cameras.read(frame).camera == CAMERA


def test_of_many_files_of_one_camera_few_are_opened_to_list_them(tmp_path, monkeypatch):
    data = write_camera(CAMERA)
    for i in range(3000):
        (tmp_path / f"{i:05}.json").write_bytes(data)
    read = []
    original = collection.CameraCollection._read_file
    monkeypatch.setattr(
        collection.CameraCollection,
        "_read_file",
        lambda self, file: read.append(file) or original(self, file),
    )
    for fmt in ("auto", "soccernet", "krt", "polylines"):
        assert len(CameraCollection.open(tmp_path, fmt).frames) == 3000
        assert len(read) <= 16
        read.clear()
    assert CameraCollection.open(tmp_path).read("00017").camera == CAMERA


def test_a_file_of_several_cameras_read_as_one_says_so(tmp_path):
    for i in range(16):
        (tmp_path / f"{i}.json").write_bytes(write_camera(CAMERA))
    (tmp_path / "16.json").write_text(line("a.jpg") + line("b.jpg"))
    with (
        CameraCollection.open(tmp_path) as cameras,
        pytest.raises(CameraError, match="holds the cameras of 2 frames, expected one"),
    ):
        cameras.read("16")


def test_the_files_of_several_matches_belong_to_their_folders(tmp_path):
    for i in range(20):  # more than are opened to see what files hold
        make(tmp_path / f"game{i}", {"cameras.json": line("img1/1.jpg") + line("img1/2.jpg")})
    with CameraCollection.open(tmp_path) as cameras:
        assert len(cameras.frames) == 40
        assert cameras.frames["game1/img1/2"] == "game1/cameras.json"
        assert cameras.read("game19/2").camera == CAMERA
        assert cameras.display("game3/2").endswith("game3/cameras.json: line 2")


def test_two_files_beside_each_other_for_one_frame_say_where_they_belong(tmp_path):
    make(tmp_path / "cameras", {f"game{i}.json": line("1.jpg") for i in (1, 2)})
    with pytest.raises(InputError, match=r"second file for frame '1'.*\(game1/cameras\.json\)"):
        CameraCollection.open(tmp_path / "cameras")


def test_one_file_for_a_tree_of_pictures_calls_them_by_their_paths(tmp_path):
    lines = line("a\\1.jpg") + line("b/1.jpg") + line("b/2.jpg")
    with CameraCollection.open(make(tmp_path / "run", {"all.json": lines})) as cameras:
        assert list(cameras.frames) == ["a/1", "b/1", "b/2"]
        assert cameras.read("b/1").camera == CAMERA


def test_the_only_folder_of_a_file_of_many_cameras_is_known(tmp_path):
    make(tmp_path / "game1", {"cameras.json": line("1.jpg")})
    with CameraCollection.open(tmp_path) as cameras:
        assert list(cameras.frames) == ["1"]
        assert cameras.read("game1/1").camera == CAMERA


def test_files_of_one_match_each_may_tell_its_folder_by_their_pictures(tmp_path):
    files = {f"game{i}.json": line(f"game{i}/1.jpg") + line(f"game{i}/2.jpg") for i in (1, 2)}
    folder = make(tmp_path / "run", files)
    with CameraCollection.open(folder) as cameras:
        assert list(cameras.frames) == ["game1/1", "game1/2", "game2/1", "game2/2"]
        assert cameras.read("game2/img1/2").camera == CAMERA
    with CameraCollection.open(folder / "game1.json") as cameras:
        assert list(cameras.frames) == ["1", "2"]
        assert cameras.read("game1/2").camera == CAMERA
        assert "game2/2" not in cameras.frames
