"""Cameras written in other formats: round trips, and what a format cannot hold."""

import json
import math
import zipfile
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.camera.base import Camera, ElementProjections
from procc_annotator.camera.models import FisheyeCamera, HomographyCamera, PinholeCamera
from procc_annotator.errors import CameraError, SaveError, UsageError
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera, fit_to_size
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.formats.cameras.writers import (
    CAMERA_TARGETS,
    WRITERS,
    encode_camera,
    write_cameras,
    writer_of,
)
from procc_annotator.report.conversion import export_cameras

SIZE = (1280, 720)
POINTS = np.random.default_rng(4).uniform((-50, -34, -2.5), (50, 30, 0), (200, 3))
GROUND = POINTS * (1, 1, 0)
PLAIN = PinholeCamera(0.1, 1.3, 0.01, (2.0, 60.0, -15.0), (1400.0, 1410.0), (640.0, 360.0))
BENT = PinholeCamera(
    0.1, 1.3, 0.01, (2.0, 60.0, -15.0), (1400.0, 1410.0), (640.0, 360.0),
    (-0.2, 0.05, 0.01, 0.02, 0.003, 0.001), (0.003, -0.002), (0.001, 0.0, 0.0, 2e-4),
)  # fmt: skip
FISHEYE = FisheyeCamera(
    0.1, 1.2, -0.02, (3.0, 55.0, -12.0), (600.0, 601.0), (641.0, 358.0), (0.02, -0.01, 0.003, 0.0)
)
FLAT = HomographyCamera.from_world_from_image(
    np.array([[0.05, 0.001, -32.0], [0.002, 0.06, -18.0], [0.0, 1e-3, 1.0]]), SIZE
)
MODELS = {"plain": PLAIN, "bent": BENT, "fisheye": FISHEYE, "flat": FLAT}
HOLDS = {
    "soccernet": {"plain", "bent"},
    "submission": {"plain", "bent"},
    "krt": {"plain", "bent", "fisheye"},
    "opencv": {"plain", "bent", "fisheye"},
    "wc14": {"plain", "flat"},
    "carwc": {"plain", "flat"},
    "world": {"plain", "flat"},
}


def loaded(name: str, size: tuple[int, int] | None = SIZE) -> LoadedCamera:
    model = {"fisheye": "fisheye", "flat": "homography"}.get(name, "pinhole")
    return LoadedCamera(MODELS[name], model, size)


def agree(found: object, expected: Camera, points: np.ndarray) -> None:
    px, valid = found.project(points)
    expected_px, expected_valid = expected.project(points)
    assert (valid == expected_valid).all()
    near = valid & (np.abs(expected_px) < 5000).all(axis=1)
    assert near.sum() > 20
    np.testing.assert_allclose(px[near], expected_px[near], atol=1e-7)


@pytest.mark.parametrize("target", CAMERA_TARGETS)
@pytest.mark.parametrize("name", MODELS)
def test_what_a_format_holds_comes_back_and_the_rest_is_refused(target, name):
    if name not in HOLDS[target]:
        with pytest.raises(ValueError, match=r"cannot hold (a |lens )"):
            encode_camera(loaded(name), target)
        return
    data, losses = encode_camera(loaded(name), target)
    fmt = {"submission": "soccernet"}.get(target, target)
    suffix = Path(writer_of(target).file_name).suffix
    again = read_camera_file(data, path=f"1{suffix}", fmt=fmt)
    assert again.model == ("homography" if target in ("wc14", "carwc", "world") else
                           loaded(name).model)  # fmt: skip
    to = again.size or (960, 540)
    assert to == (SIZE if target != "submission" else (960, 540))
    expected, _ = fit_to_size(loaded(name), to)
    flat = again.model == "homography"
    agree(again.camera, expected, GROUND if flat else POINTS)
    assert losses == (("everything off the ground",) if flat and name == "plain" else ())


def test_every_format_of_these_is_read_by_itself_too():
    for writer in WRITERS:
        if writer.name in ("world", "submission"):
            continue  # nothing in a text of nine numbers tells metres from yards
        data, _ = encode_camera(loaded("plain"), writer.name)
        path = writer.file_name.format("1")
        again = read_camera_file(data, path=path)
        expected, _ = fit_to_size(loaded("plain"), again.size or SIZE)
        agree(again.camera, expected, GROUND)


def test_a_camera_is_written_for_the_size_asked_for():
    for target in ("soccernet", "krt", "opencv"):
        suffix = Path(writer_of(target).file_name).suffix
        data, _ = encode_camera(loaded("bent"), target, size=(640, 360))
        again = read_camera_file(data, path=f"1{suffix}")
        assert again.size == (640, 360)
        agree(again.camera, BENT.scaled(SIZE, (640, 360)), POINTS)
        unknown = read_camera_file(
            encode_camera(loaded("bent", None), target)[0], path="1" + suffix
        )
        assert unknown.size is None


def test_a_soccernet_camera_keeps_what_its_file_said():
    content = json.loads(write_camera(PLAIN)) | {"pan_degrees": 5.0, "score": 0.9, "width": 1280}
    content |= {"height": 720}
    first = read_camera_file(json.dumps(content).encode(), path="1.json")
    data, losses = encode_camera(first, "soccernet", size=(960, 540))
    again = json.loads(data)
    assert again["pan_degrees"] == 5.0
    assert again["score"] == 0.9
    assert (again["image_width"], again["image_height"]) == (960, 540)
    assert "width" not in again
    assert not losses
    data, losses = encode_camera(first, "submission")
    assert set(json.loads(data)) == set(json.loads(write_camera(PLAIN)))
    assert losses == ("keys left out: score",)
    assert encode_camera(first, "krt")[1] == ("keys left out: score",)
    assert "names no picture size" in encode_camera(loaded("plain", None), "submission")[1][0]


def test_what_cannot_be_written_says_why():
    drawn = LoadedCamera(ElementProjections({}), "projections", (2, 2))

    class Lens:
        model = "division"

        def project(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            return points[:, :2], np.ones(len(points), dtype=bool)

    for target in CAMERA_TARGETS:
        with pytest.raises(ValueError, match="cannot hold projected polylines"):
            encode_camera(drawn, target)
        with pytest.raises(
            ValueError, match=r"cannot hold a camera model of a plug-in \(division\)"
        ):
            encode_camera(LoadedCamera(Lens(), "division", SIZE), target)
        endless = PinholeCamera(0, 1, 0, (0, math.inf, 0), (1, 1), (0, 0))
        with pytest.raises(ValueError, match=r"without bounds|not a camera"):
            encode_camera(LoadedCamera(endless, "pinhole", SIZE), target)
    with pytest.raises(ValueError, match="names no picture size"):
        encode_camera(loaded("flat", None), "world")
    buried = PinholeCamera(0, 1, 0, (0, 0, 0), (1000, 1000), (0, 0))
    with pytest.raises(ValueError, match="the camera lies in the ground"):
        encode_camera(LoadedCamera(buried, "pinhole", SIZE), "world")
    with pytest.raises(UsageError, match="no format 'mat' to write cameras to"):
        encode_camera(loaded("plain"), "mat")


def test_a_set_is_written_to_a_folder_and_to_an_archive(tmp_path):
    cameras = [
        ("00001", loaded("plain")),
        ("00002", loaded("flat")),
        ("00003", CameraError("3.json", "is empty")),
        ("../b", loaded("plain")),
        ("00004", loaded("bent")),
    ]
    steps: list[tuple[int, int]] = []
    done = write_cameras(
        cameras, tmp_path / "new" / "krt", "krt", total=5, progress=lambda *s: steps.append(s)
    )
    assert sorted(p.name for p in (tmp_path / "new" / "krt").iterdir()) == [
        "00001.json", "00004.json",
    ]  # fmt: skip
    assert done.written == 2
    assert steps[-1] == (5, 5)
    assert done.problems[0].startswith("00002: K, R and t cannot hold a homography")
    assert done.problems[1] == "3.json: is empty"
    assert done.problems[2].startswith("../b: is no name for a file")
    archive = tmp_path / "submission.zip"
    done = write_cameras(cameras, archive, "submission", split="challenge")
    with zipfile.ZipFile(archive) as zipped:
        assert zipped.namelist() == ["challenge/camera_00001.json", "challenge/camera_00004.json"]
    first = archive.read_bytes()
    write_cameras(cameras, archive, "submission", split="challenge")
    assert archive.read_bytes() == first
    packed = tmp_path / "krt.zip"
    write_cameras(cameras, packed, "krt")
    with CameraCollection.open(packed) as collection:
        assert list(collection.frames) == ["00001", "00004"]
        agree(collection.read("00004").camera, BENT, POINTS)


def test_nothing_is_written_where_it_must_not_be(tmp_path):
    with pytest.raises(UsageError, match=r"must end in \.zip"):
        write_cameras([("1", loaded("plain"))], tmp_path / "out", "submission")
    for split in ("", "..", "a/b", "a\\b"):
        with pytest.raises(UsageError, match="not the name of a split"):
            write_cameras([("1", loaded("plain"))], tmp_path / "o.zip", "submission", split=split)
    (tmp_path / "file").write_text("mine")
    with pytest.raises(SaveError):
        write_cameras([("1", loaded("plain"))], tmp_path / "file" / "out", "krt")
    done = write_cameras([("1", loaded("flat"))], tmp_path / "none.zip", "submission")
    assert not (tmp_path / "none.zip").exists()
    assert len(done.problems) == 1
    source = tmp_path / "cameras"
    source.mkdir()
    (source / "camera_1.json").write_bytes(write_camera(PLAIN))
    for path in (source, source / "camera_1.json"):
        with (
            CameraCollection.open(path) as collection,
            pytest.raises(UsageError, match="this is where the cameras are"),
        ):
            export_cameras(collection, source, "soccernet")


def test_a_collection_is_converted(tmp_path):
    source = tmp_path / "cameras"
    source.mkdir()
    (source / "camera_1.json").write_bytes(write_camera(PLAIN))
    (source / "camera_2.json").write_bytes(b"{}")
    with CameraCollection.open(source) as collection:
        done = export_cameras(collection, tmp_path / "yaml", "opencv")
    assert (done.written, len(done.problems)) == (1, 1)
    assert "camera_2.json: the key 'pan_degrees' is missing" in done.problems[0]
    agree(
        read_camera_file((tmp_path / "yaml" / "1.yml").read_bytes(), path="1.yml").camera,
        PLAIN,
        POINTS,
    )
