"""Cameras as other programs keep them: each shows known points where they were projected."""

import io
import json
import math
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.matrices import calibration_matrix, distortion_vector, translation
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.field.geometry import middle_of, outline_of
from procc_annotator.field.load import load_field
from procc_annotator.field.sampling import FieldSamples, sample_evenly
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.homography import CONVENTIONS
from procc_annotator.formats.cameras.krt import KRT_KEYS, krt_content
from procc_annotator.formats.cameras.krt_sets import BY_ORDER
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera
from procc_annotator.formats.cameras.registry import json_records, read_camera_file
from procc_annotator.formats.cameras.soccernet import write_camera

PLAIN = PinholeCamera(0.3, 1.3, 0.02, (4.0, 60.0, -15.0), (1500.0, 1490.0), (640.0, 355.0))
BENT = PinholeCamera(
    0.3, 1.3, 0.02, (4.0, 60.0, -15.0), (1500.0, 1490.0), (640.0, 355.0),
    (0.1, -0.02, 0.0, 0.0, 0.0, 0.0), (0.001, -0.002),
)  # fmt: skip
POINTS = np.random.default_rng(7).uniform((-40, -30, -2.5), (40, 30, 0), (100, 3))
K, R, T = calibration_matrix(BENT), BENT.rotation_cam_from_world, translation(BENT)
DIST = np.array(distortion_vector(BENT))


def agree(loaded: LoadedCamera, camera: PinholeCamera) -> None:
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
def test_a_projection_matrix(times):
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


def test_arrays_of_one_camera_and_of_a_stack(tmp_path):
    agree(read_camera_file(npz(K=K, R=R, t=T, dist=DIST), path="1.npz"), BENT)
    rvec = cv2.Rodrigues(R)[0]
    file = tmp_path / "all.npz"
    file.write_bytes(
        npz(mtx=K, dist=DIST, rvecs=np.stack([rvec, rvec]), tvecs=np.stack([T, T])[..., None])
    )
    with CameraCollection.open(file) as cameras:
        assert list(cameras.frames) == ["0", "1"]
        agree(cameras.read("1"), BENT)


def test_pickles_are_refused():
    assert "never read" in problem(npz(K=np.array([{}], dtype=object)), "1.npz")


def test_file_storage_as_json():
    storage = cv2.FileStorage(
        ".json", cv2.FILE_STORAGE_WRITE | cv2.FILE_STORAGE_MEMORY | cv2.FILE_STORAGE_FORMAT_JSON
    )
    for key, value in (("camera_matrix", K), ("dist_coeffs", DIST), ("R", R), ("tvec", T)):
        storage.write(key, np.atleast_2d(value))
    agree(read_camera_file(storage.releaseAndGetString().encode(), path="1.json"), BENT)


def test_a_dome_counts_in_centimetres_with_y_down(tmp_path):
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


def test_transforms_of_radiance_fields(tmp_path):
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


def test_colmap(tmp_path):
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


def test_easymocap(tmp_path):
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
        (b'{"K": 1, "t": [0, 0, 9]}', "1.json", "found an object with K, t, expected pan_degrees"),
        (b"[1, 2]", "1.json", "found a list, expected pan_degrees (soccernet);"),
        (b"1 2 3 4 5", "1.txt", "wc14, carwc, world: expected 9 numbers (3 x 3), found 5"),
        (b'{"H": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}', "1.json", "nothing states its ground"),
    ],
)
def test_damage_is_one_line(data, path, expected):
    assert expected in problem(data, path)


def test_matlab_homographies_are_those_of_the_same_pictures(shared_data):
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


HOMOGRAPHY = [[0.05, 0.001, -32.0], [0.002, 0.06, -18.0], [0.0, 1e-4, 1.0]]  # picture -> metres
YARDS = (CONVENTIONS["wc14"].world_from_units, CONVENTIONS["carwc"].world_from_units)
PROJECTION = (calibration_matrix(PLAIN) @ np.column_stack((R, T))).tolist()
ENTRIES: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "soccernet": (json.loads(write_camera(PLAIN)), ()),
    "tvcalib": ({"image_ids": "7.jpg", "homography": HOMOGRAPHY}, ()),
    "broadtrack": ({"7.jpg": {"cp": json.loads(write_camera(PLAIN))}}, ("7.jpg",)),
    "deepsportradar": ([{"K": K.tolist(), "R": R.tolist(), "T": T.tolist()}], (0,)),
    "krt": (krt_content(BENT, (1280, 720)), ()),
    "by frame": ({"7": krt_content(BENT, (1280, 720))}, ("7",)),
    "nested": ({"cameras": {"7": krt_content(BENT, None)}}, ("cameras", "7")),
    "beside nested": ({"cameras": {"7": krt_content(BENT, None)}}, ()),
    "projection": ({"P": PROJECTION}, ()),
    "transforms": (
        {"w": 9, "h": 9, "fl_x": 9, "frames": [{
            "file_path": "7.jpg", "transform_matrix": np.diag([1.0, -1, -1, 1]).tolist(),
        }]}, ("frames", 0),
    ),
    "sccvsd": (
        {"annotation": [{
            "image_name": "7.jpg",
            "homography": np.linalg.inv(np.linalg.inv(YARDS[0]) @ HOMOGRAPHY).tolist(),
        }]}, ("annotation", 0),
    ),
    "ptz-slam": (
        {"annotation": [{"image_name": "7.jpg", "camera": [640, 360, 9, 1, 1, 0, 50, -20, 9]}]},
        ("annotation", 0),
    ),
    "opencv": (
        {"R": {"rows": 3, "cols": 3, "data": R.ravel().tolist()},
         "camera_matrix": {"rows": 3, "cols": 3, "data": K.ravel().tolist()},
         "tvec": T.tolist(), "extrinsic_parameters": [0.0] * 66}, (),
    ),
}  # fmt: skip


def notices_of(file: Path, content: Any, fmt: str = "auto") -> str:
    file.write_bytes(content if isinstance(content, bytes) else json.dumps(content).encode())
    with CameraCollection.open(file, fmt) as cameras:
        loaded = cameras.read(next(iter(cameras.frames)))
        return "; ".join(n for n in (*cameras.notices, *loaded.notices) if n != BY_ORDER)


@pytest.mark.parametrize("name", ENTRIES)
def test_a_key_of_a_lens_a_pose_or_a_size_is_used_or_named(name, tmp_path):
    content, way = ENTRIES[name]
    file = tmp_path / "file.json"
    assert "not used" not in notices_of(file, content)
    for key, value in (
        ("lensDistortion", [0.1, 0.2]), ("camera_pose", [1.0]), ("img_size", [1, 2]),
        ("radial2", "0.1"),
    ):  # fmt: skip
        assert f"not used, though it looks like lens, pose or size: {key}" in notices_of(
            file, _with(content, way, {key: value, "score": 0.5, "position_sd": [1.0]})
        )


def _with(content: Any, way: tuple[Any, ...], more: dict[str, Any]) -> Any:
    changed = json.loads(json.dumps(content))
    entry = changed
    for step in way:
        entry = entry[step]
    entry.update(more)
    return changed


def test_no_lens_of_easymocap_is_dropped(tmp_path):
    for name, parts in (
        ("intri.yml", {"K_01": K, "D_01": DIST, "K_02": K}),
        ("extri.yml", {"Rot_01": R, "T_01": T}),
    ):
        storage = cv2.FileStorage(str(tmp_path / name), cv2.FILE_STORAGE_WRITE)
        for key, value in parts.items():
            storage.write(key, np.atleast_2d(value))
        storage.release()
    with CameraCollection.open(tmp_path) as cameras:
        assert cameras.notices == ("not used: D_01, lens of 02",)


@pytest.mark.parametrize("key", KRT_KEYS.distortion)
def test_every_spelling_of_a_distortion_is_read_and_two_must_agree(key):
    content = krt_content(BENT, (1280, 720))
    dist = content.pop("dist")
    one = {**content, key: dist}
    agree(read_camera_file(json.dumps(one).encode(), path="1.json"), BENT)
    other = {"distortion" if key == "dist" else "dist": [*dist, 0.0, 0.0, 0.0]}
    agree(read_camera_file(json.dumps(one | other).encode(), path="1.json"), BENT)
    stack = {"K": [K.tolist()] * 2, "R": [R.tolist()] * 2, "t": [T.tolist()] * 2, key: [dist] * 2}
    records = json_records(json.dumps(stack).encode(), path="1.json")
    agree(records.read("1"), BENT)
    wrong = {next(iter(other)): [0.0] * 5}
    assert "says something else than" in problem(json.dumps(one | wrong).encode(), "1.json")


@pytest.mark.parametrize("fmt", ["soccernet", "krt", "projection"])
def test_a_world_with_z_up_is_named_for_every_format(fmt, tmp_path):
    up = replace(PLAIN, position_world=(4.0, 60.0, 22.0))
    pose = np.column_stack((up.rotation_cam_from_world, translation(up)))
    content = {
        "soccernet": json.loads(write_camera(up)),
        "krt": krt_content(up, None),
        "projection": {"P": (calibration_matrix(up) @ pose).tolist()},
    }[fmt]
    assert "stands 22 m below the ground" in notices_of(tmp_path / "1.json", content)


@pytest.mark.parametrize(
    ("fmt", "world"), [("world", np.eye(3)), ("wc14", YARDS[0]), ("carwc", YARDS[1])]
)
def test_a_homography_upside_down_or_in_centimetres_is_named(fmt, world, tmp_path):
    units = np.linalg.inv(world) @ HOMOGRAPHY
    file = tmp_path / "1.npy"
    assert not notices_of(file, npy(units), fmt)
    assert "takes the ground to the picture" in notices_of(file, npy(np.linalg.inv(units)), fmt)
    corner = np.array([[100.0, 0, 5250], [0, 100, 3400], [0, 0, 1]])
    assert "looks like centimetres from a corner" in notices_of(file, npy(corner @ HOMOGRAPHY), fmt)


def test_no_real_camera_raises_an_alarm(shared_data):
    said = set[str]()
    for place in (
        "wc14/cameras_pnlcalib", "wc14/cameras_nbjw", "wc14/homographies_carwc",
        "deepsportradar/ground_truth_val.json", "foreign/wc14_homographies_test.mat",
        "foreign/ptz_330_cameras.mat", "official_cases/cameras",
    ):  # fmt: skip
        with CameraCollection.open(shared_data / place) as cameras:
            said.update(n for frame in cameras.frames for n in cameras.read(frame).notices)
    assert said == {"the skew in K is left out (it moves no pixel by 0.01 px)"}


# The real basketball cameras see the court of the FIBA field as a camera in the hall would.

FIELD = load_field("basketball_fiba")
SIZE = (960, 540)


@pytest.fixture(scope="module")
def cameras(shared_data) -> list[tuple[PinholeCamera, FloatArray]]:
    """Each camera, and the (3, 4) matrix its file gives for centimetres from the court's corner."""
    found: list[tuple[PinholeCamera, FloatArray]] = []
    for name in ("val", "test"):
        file = shared_data / "deepsportradar" / f"ground_truth_{name}.json"
        matrices = [np.array(e["P"]).reshape(3, 4) for e in json.loads(file.read_bytes())[1:]]
        with CameraCollection.open(file) as collection:
            for frame, matrix in zip(collection.frames, matrices, strict=True):
                camera = collection.read(frame).camera
                found.append((camera, matrix))
    assert len(found) == 248
    return found


def place(name: str) -> FloatArray:
    """(3,) metres: the middle of an element."""
    element = FIELD.element(name)
    return np.array(middle_of(element.geometry))


def seen(camera: PinholeCamera, samples: FieldSamples) -> set[str]:
    """Elements of which the picture shows 25 cm or more, or a spot."""
    px, valid = camera.project(samples.points_world)
    shown = valid & (px >= 0).all(axis=1) & (px <= np.array(SIZE) - 1).all(axis=1)
    counts = np.add.reduceat(shown.astype(int), samples.offsets[:-1])
    enough = [1 if e.is_spot else 5 for e in FIELD.elements]
    return {n for n, c, least in zip(samples.names, counts, enough, strict=True) if c >= least}


def test_the_court_begins_where_the_files_say(cameras):
    """Its far left corner is their origin, x runs along it, y towards the camera."""
    corners_cm = np.array([(0, 0, 0), (2800, 0, 0), (2800, 1500, 0), (0, 1500, 0)], dtype=float)
    edges = ("top", "right", "bottom", "left")
    for camera, matrix in cameras:
        homogeneous = np.column_stack((corners_cm, np.ones(4))) @ matrix.T
        for i, edge in enumerate(edges):
            element = FIELD.element(f"Court edge {edge}")
            ends, valid = camera.project(outline_of(element.geometry))
            assert valid.all()
            theirs = homogeneous[[i, (i + 1) % 4]]
            theirs_px = theirs[:, :2] / theirs[:, 2:]
            apart = np.linalg.norm(ends[:, None] - theirs_px[None], axis=2)
            nearest = apart.min(axis=1)
            # Numbers of single precision; corners may lie thousands of pixels outside the picture.
            assert (nearest < 1e-5 * (1e3 + np.linalg.norm(ends, axis=1))).all()


def test_cameras_stand_beside_the_court_and_look_down_at_it(cameras):
    places = np.array([camera.position_world for camera, _ in cameras])
    assert (np.abs(places[:, 0]) < 1.1).all()  # at the centre line
    usual = FIELD.cameras
    distance, height = places[:, 1] - 7.5, -places[:, 2]
    for measured, (least, _, most) in ((distance, usual.distance), (height, usual.height)):
        assert least < measured.min() <= measured.max() < most
    assert 9.6 < distance.min() <= distance.max() < 22.1
    assert 7.0 < height.min() <= height.max() < 10.8
    for camera, _ in cameras:
        forward = camera.rotation_cam_from_world[2]
        assert forward[1] < 0 < forward[2]  # away from the near side, and down


def test_each_view_shows_left_on_the_left_far_above_near_and_the_baskets_in_the_air(cameras):
    rims = np.array([place("Rim left centre"), place("Rim right centre")])
    world = np.vstack((
        rims, rims * (1, 1, 0), place("Court edge top"), place("Court edge bottom"),
        place("Court edge left"), place("Court edge right"), place("Midcourt line"),
    ))  # fmt: skip
    for camera, _ in cameras:
        px, valid = camera.project(world)
        assert valid.all()
        (x, y) = px.T
        assert (y[:2] < y[2:4]).all()  # each rim above the floor below it
        assert y[4] < y[8] < y[5]  # far sideline, centre, near sideline
        assert x[6] < x[8] < x[7]  # left endline, centre, right endline
        assert x[0] < x[8] < x[1]


def test_every_class_of_the_baseline_is_seen_and_every_view_shows_some(cameras):
    samples = sample_evenly(FIELD, 0.05)
    views = [seen(camera, samples) for camera, _ in cameras]
    counts = np.array([len(view) for view in views])
    assert counts.min() >= 2
    assert np.median(counts) >= 8
    assert set.union(*views) == {e.name for e in FIELD.elements}
