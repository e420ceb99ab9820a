"""Cameras as other programs keep them: each shows known points where they were projected."""

from __future__ import annotations

import io
import json
import math
import shutil
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from procc_annotator.camera.matrices import calibration_matrix, distortion_vector, translation
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.field.load import load_field
from procc_annotator.io.camera_files.camera_collection import CameraCollection
from procc_annotator.io.camera_files.cameras import read_camera_file
from procc_annotator.io.camera_files.krt_camera import krt_content
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera

PLAIN = PinholeCamera(0.3, 1.3, 0.02, (4.0, 60.0, -15.0), (1500.0, 1490.0), (640.0, 355.0))
BENT = PinholeCamera(
    0.3, 1.3, 0.02, (4.0, 60.0, -15.0), (1500.0, 1490.0), (640.0, 355.0),
    (0.1, -0.02, 0.0, 0.0, 0.0, 0.0), (0.001, -0.002),
)  # fmt: skip
POINTS = np.random.default_rng(7).uniform((-40, -30, -2.5), (40, 30, 0), (100, 3))
K, R, T = calibration_matrix(BENT), BENT.rotation_cam_from_world, translation(BENT)
DIST = np.array(distortion_vector(BENT))


def agree(loaded: LoadedCamera, camera: PinholeCamera) -> None:
    assert isinstance(loaded.camera, PinholeCamera)
    np.testing.assert_allclose(
        loaded.camera.project(POINTS)[0], camera.project(POINTS)[0], atol=1e-6
    )


def npz(**arrays: Any) -> bytes:
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)
    return buffer.getvalue()


def npy(array: Any, **options: Any) -> bytes:
    buffer = io.BytesIO()
    np.save(buffer, array, **options)
    return buffer.getvalue()


def problem(data: bytes, path: str) -> str:
    with pytest.raises(CameraError) as caught:
        read_camera_file(data, path=path)
    assert "\n" not in str(caught.value)
    return str(caught.value)


@pytest.mark.parametrize("times", [1.0, -3.5])
def test_a_projection_matrix(times: float) -> None:
    pose = np.column_stack((PLAIN.rotation_cam_from_world, translation(PLAIN)))
    matrix = times * (calibration_matrix(PLAIN) @ pose)
    text = "\n".join(" ".join(repr(float(v)) for v in row) for row in matrix).encode()
    for data, path in (
        (npy(matrix), "1.npy"),
        (text, "1.txt"),
        (json.dumps({"P": matrix.tolist()}).encode(), "1.json"),
        (json.dumps({"projection": matrix.ravel().tolist()}).encode(), "1.json"),
        (npz(P=matrix), "1.npz"),
    ):
        agree(read_camera_file(data, path=path), PLAIN)


def test_arrays_of_one_camera_and_of_a_stack(tmp_path: Path) -> None:
    agree(read_camera_file(npz(K=K, R=R, t=T, dist=DIST), path="1.npz"), BENT)
    rvec = cv2.Rodrigues(R)[0]
    file = tmp_path / "all.npz"
    file.write_bytes(
        npz(mtx=K, dist=DIST, rvecs=np.stack([rvec, rvec]), tvecs=np.stack([T, T])[..., None])
    )
    with CameraCollection.open(file) as cameras:
        assert list(cameras.frames) == ["0", "1"]
        agree(cameras.read("1"), BENT)


def test_pickles_are_refused() -> None:
    assert "never read" in problem(npz(K=np.array([{}], dtype=object)), "1.npz")


def test_file_storage_as_json() -> None:
    storage = cv2.FileStorage(
        ".json", cv2.FILE_STORAGE_WRITE | cv2.FILE_STORAGE_MEMORY | cv2.FILE_STORAGE_FORMAT_JSON
    )
    for key, value in (("camera_matrix", K), ("dist_coeffs", DIST), ("R", R), ("tvec", T)):
        storage.write(key, np.atleast_2d(value))
    agree(read_camera_file(storage.releaseAndGetString().encode(), path="1.json"), BENT)


def test_a_dome_counts_in_centimetres_with_y_down(tmp_path: Path) -> None:
    dome = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])  # its axes -> ours
    camera = {
        "name": "00_01", "resolution": [1280, 720], "K": K.tolist(), "distCoef": DIST.tolist(),
        "R": (R @ dome).tolist(), "t": [[100 * v] for v in T],
    }  # fmt: skip
    (file := tmp_path / "calibration.json").write_text(json.dumps({"cameras": [camera]}))
    with CameraCollection.open(file) as cameras:
        agree(cameras.read("00_01"), BENT)
    own = krt_content(BENT, (1280, 720))
    inside = {key: own.pop(key) for key in ("K", "dist")}
    apart = {"intrinsics": inside, "extrinsics": own}
    file.write_text(json.dumps({"cameras": {"a": inside | own, "b": apart}}))
    with CameraCollection.open(file) as cameras:
        agree(cameras.read("a"), BENT)
        agree(cameras.read("b"), BENT)


def test_transforms_of_radiance_fields(tmp_path: Path) -> None:
    turn = np.diag([1.0, -1.0, -1.0])
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = turn @ R.T @ turn, turn @ np.array(BENT.position_world)
    content = {
        "w": 1280, "h": 720, "fl_x": 1500.0, "fl_y": 1490.0, "cx": 640.5, "cy": 355.5,
        "k1": 0.1, "k2": -0.02, "p1": 0.001, "p2": -0.002,
        "frames": [{"file_path": "images/7.jpg", "transform_matrix": pose.tolist()}],
    }  # fmt: skip
    (file := tmp_path / "transforms.json").write_text(json.dumps(content))
    with CameraCollection.open(file) as cameras:
        agree(cameras.read("7"), BENT)


def test_colmap(tmp_path: Path) -> None:
    angle = np.linalg.norm(vector := cv2.Rodrigues(R)[0].ravel())
    w, xyz = math.cos(angle / 2), vector / angle * math.sin(angle / 2)
    words = " ".join(repr(float(v)) for v in (w, *xyz, *T))
    (tmp_path / "images.txt").write_text(f"# a line\n1 {words} 3 a/7.jpg\n1.5 2.5 -1\n")
    with pytest.raises(CameraError, match=r"without cameras\.txt"):
        CameraCollection.open(tmp_path)
    lens = "3 OPENCV 1280 720 1500 1490 640.5 355.5 0.1 -0.02 0.001 -0.002\n"
    (tmp_path / "cameras.txt").write_text(lens)
    with CameraCollection.open(tmp_path) as cameras:
        assert list(cameras.frames) == ["7"]
        agree(cameras.read("7"), BENT)
    for game in ("one", "two"):
        shutil.copytree(tmp_path, tmp_path / "season" / game, ignore=lambda *_: ["season"])
    for fmt in ("auto", "colmap"):
        with CameraCollection.open(tmp_path / "season", fmt) as cameras:
            assert list(cameras.frames) == ["one/7", "two/7"]
            agree(cameras.read("two/7"), BENT)


def test_easymocap(tmp_path: Path) -> None:
    for name, parts in (
        ("intri.yml", {"K_01": K, "dist_01": DIST}),
        ("extri.yml", {"R_01": cv2.Rodrigues(R)[0], "Rot_01": R, "T_01": T}),
    ):
        storage = cv2.FileStorage(str(tmp_path / name), cv2.FILE_STORAGE_WRITE)
        for key, value in parts.items():
            storage.write(key, np.atleast_2d(value))
        storage.release()
    with CameraCollection.open(tmp_path) as cameras:
        assert list(cameras.frames) == ["01"]
        agree(cameras.read("01"), BENT)


@pytest.mark.parametrize(
    ("data", "path", "expected"),
    [
        (b"PK\3\4 cut", "1.npz", "is not a readable .npz archive"),
        (b"whatever", "1.npz", "neither an .npz archive nor a MATLAB file"),
        (b"MATLAB 7.3 MAT-file", "1.mat", "save it in MATLAB with"),
        (b"MATLAB 5.0 MAT-file" + bytes(99), "1.mat", "is not a readable MATLAB file of level 5"),
        (b'{"here": 1}', "1.json", "tvcalib: lacks 'image_ids'; broadtrack: no entry has 'cp'"),
        (
            b'{"K": [[9, 0, 0], [0, 9, 0], [0, 0, 1]], "t": [0, 0, 9]}',
            "1.json",
            "; krt: lacks 'R';",
        ),
        (b'{"a": {"K": 1, "T": 2}, "b": {"K": 1}}', "1.json", "; krt: 'a' lacks 'R';"),
        (b'{"cameras": [{"K": 1}, 2]}', "1.json", "; krt: 'cameras': no entry has 'R';"),
        (b'{"P": [[1, 0], [0, 1]]}', "1.json", "; projection: 'P' is not 3 x 4;"),
        (b'[{"K": 1}, {"K": 1, "R": 2}]', "1.json", "; deepsportradar: no entry has 'T';"),
        (b'{"frames": [{"pose": 1}]}', "1.json", "'frames': no entry has 'transform_matrix';"),
        (b'{"frames": 3}', "1.json", "; transforms: 'frames': is a number, not an object;"),
        (b"[1, 2]", "1.json", "tvcalib, krt, transforms, sccvsd, ptz-slam: is a list, not an"),
        (b"1 2 3 4 5", "1.txt", "wc14, carwc, world: expected 9 numbers (3 x 3), found 5"),
        (b"1 2 3 4 5", "1.txt", "; projection: expected 12 (3 x 4)"),
        (b'{"H": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}', "1.json", "nothing tells which ground"),
    ],
)
def test_damage_is_one_line(data: bytes, path: str, expected: str) -> None:
    assert expected in problem(data, path)


def test_matlab_homographies_are_those_of_the_same_pictures(shared_data: Path) -> None:
    file = shared_data / "foreign" / "wc14_homographies_test.mat"
    if not file.is_file():
        pytest.skip(f"{file} is not there")
    ground = np.array([(x, y, 0.0) for x in range(-50, 51, 10) for y in range(-30, 31, 10)])
    apart = []
    with (
        CameraCollection.open(file) as published,
        CameraCollection.open(shared_data / "wc14" / "homographies_carwc") as refined,
    ):
        assert set(published.frames) == set(refined.frames)
        for frame in published.frames:
            a, _ = published.read(frame).camera.project(ground)
            b, seen = refined.read(frame).camera.project(ground)
            seen &= (b >= 0).all(axis=1) & (b <= (1279, 719)).all(axis=1)
            apart.append(np.median(np.linalg.norm(a - b, axis=1)[seen]))
        # One set was refined from the other: a few pixels, not another convention.
        assert np.median(apart) < 8
        with pytest.raises(CameraError, match="nothing says which ground"):
            published.read("1", load_field("tennis"))
