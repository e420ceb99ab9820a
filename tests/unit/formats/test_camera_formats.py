"""Every camera format on a reproduced or real file, and damage named with its place."""

import json
import math
import re
from typing import Any

import cv2
import numpy as np
import pytest

from procc_annotator.camera.base import Camera, ElementProjections
from procc_annotator.camera.models import FisheyeCamera, PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.krt import write_krt
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera, fit_to_size
from procc_annotator.formats.cameras.opencv import write_opencv
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.cameras.soccernet import write_camera

POINTS = np.random.default_rng(4).uniform((-50, -34, -2.5), (50, 30, 0), (200, 3))
SIZE = (1280, 720)
PINHOLE = PinholeCamera(
    math.radians(-18.5),
    math.radians(80.0),
    math.radians(0.4),
    (-1.2, 71.0, -13.5),
    (2592.3, 2590.1),
    (640.0, 360.0),
    (0.11, -0.02, 0.003, 0.0, 0.0, 0.0),
)
BENT = PinholeCamera(
    PINHOLE.pan_rad,
    PINHOLE.tilt_rad,
    PINHOLE.roll_rad,
    PINHOLE.position_world,
    (700.0, 705.0),
    (639.5, 359.5),
    (-0.2, 0.05, 0.01, 0.02, 0.003, 0.001),
    (0.003, -0.002),
    (0.001, 0.0005, -0.001, 0.0002),
)
FISHEYE = FisheyeCamera(
    0.1, 1.2, -0.02, (3.0, 55.0, -12.0), (600.0, 601.0), (641.0, 358.0), (0.02, -0.01, 0.003, -1e-3)
)


def agree(loaded: LoadedCamera, expected: Camera, atol: float = 1e-9) -> None:
    px, valid = loaded.camera.project(POINTS)
    expected_px, expected_valid = expected.project(POINTS)
    assert (valid == expected_valid).all()
    near = valid & (np.abs(expected_px) < 5000).all(axis=1)
    assert near.sum() > 20
    np.testing.assert_allclose(px[near], expected_px[near], atol=atol)


def problem(data: bytes, fmt: str, path: str = "") -> str:
    path = path or ("1.yml" if fmt == "opencv" else "1.json")
    with pytest.raises(CameraError) as caught:
        read_camera_file(data, path=path, fmt=fmt)
    message = str(caught.value)
    assert message.startswith(path)
    assert "\n" not in message
    return message


def encoded(value: Any) -> bytes:
    return json.dumps(value).encode()


# ------------------------------------------------------------------------------------------- krt


@pytest.mark.parametrize("camera", [PINHOLE, BENT, FISHEYE])
@pytest.mark.parametrize("fmt", ["krt", "auto"])
def test_k_r_t_as_written_here(camera, fmt):
    loaded = read_camera_file(write_krt(camera, SIZE), path="1.json", fmt=fmt)
    agree(loaded, camera)
    assert loaded.size == SIZE
    assert loaded.model == ("fisheye" if camera is FISHEYE else "pinhole")
    assert not loaded.notices
    assert read_camera_file(write_krt(camera, None), path="1.json", fmt=fmt).size is None


def test_k_r_t_in_other_spellings():
    content = json.loads(write_krt(BENT, SIZE))
    flat = {
        "camera_matrix": np.array(content["K"]).ravel().tolist(),
        "rvec": cv2.Rodrigues(np.array(content["R"]))[0].ravel().tolist(),
        "tvec": [[v] for v in content["t"]],
        "D": [content["dist"]],
        "image_width": 1280.0,
        "image_height": 720,
    }
    loaded = read_camera_file(encoded(flat), path="1.json")
    agree(loaded, BENT, 1e-8)
    assert loaded.size == SIZE
    placed = {"K": content["K"], "R": content["R"], "position": list(BENT.position_world)}
    agree(read_camera_file(encoded(placed | {"dist": content["dist"]}), path="1.json"), BENT, 1e-8)


def krt(**changes: Any) -> bytes:
    content = json.loads(write_krt(PINHOLE, SIZE)) | changes
    return encoded({k: v for k, v in content.items() if v is not ...})


MIRRORED = (np.diag([1.0, 1.0, -1.0]) @ PINHOLE.rotation_cam_from_world).tolist()


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        (krt(K=...), "the key 'K' or 'camera_matrix' or 'cameraMatrix' is missing"),
        (krt(R=...), "the key 'R' or 'rotation_matrix' or 'rvec' is missing"),
        (krt(K=[[1, 2], [3, 4]]), "K: expected 3 x 3 numbers, found 4"),
        (krt(C=[0, 0, 1]), "C: says something else than t, expected the same"),
        (krt(K=[0] * 9), "K: K is not of the form"),
        (krt(K=[[1500, 9, 600], [0, 1500, 300], [0, 0, 1]]), "K: K has a skew"),
        (krt(K=[[1e400, 0, 0]]), "K[0][0]: expected a finite number"),
        (krt(R=MIRRORED), "R: R is no rotation: it mirrors"),
        (krt(R=(np.eye(3) * 1.01).tolist()), "R: R is no rotation: R times its transpose differs"),
        (krt(R="identity"), "R: expected a list of numbers, found text"),
        (krt(R=[1e6, 0, 0]), "R: expected a rotation vector in radians"),
        (krt(t=[1, 2]), "t: expected 3 numbers, found 2"),
        (krt(t=[1, 2, None]), "t[2]: expected a finite number, found null"),
        (krt(t=[1.7e308, -1.7e308, 1.7e308]), "t: t is without bounds"),
        (krt(dist=[0.1]), "dist: the distortion has 1 entries"),
        (krt(dist=[0.0] * 12 + [0.1, 0.0]), "dist: the distortion tilts the sensor"),
        (krt(dist={"k1": 1}), "dist: expected a list of numbers, found an object"),
        (krt(model="omnidirectional"), "model: expected 'pinhole' or 'fisheye'"),
        (krt(model="fisheye", dist=[0.0] * 5), "dist: a fisheye distortion has 4 entries, found 5"),
        (krt(width=0), "width and height: expected whole pixels"),
        (krt(width=..., height=540), "height: has 'height' without 'width', expected both"),
        (b"[]", "expected an object with the keys of a K, R, t camera, found a list"),
        (krt()[:-20], "may be cut off"),
        (b"", "is empty"),
        (krt().decode().encode("utf-16"), "is not UTF-8 text"),
        (b'{"K": 1, "K": 2}', "'K' occurs twice"),
        (b'{"K":' + b"[" * 70 + b"]" * 70 + b"}", "is nested too deeply"),
    ],
)  # fmt: skip
def test_damage_in_k_r_t(data, expected):
    assert expected in problem(data, "krt")


# ---------------------------------------------------------------------------------------- opencv


def storage(suffix: str, camera: PinholeCamera, **more: Any) -> bytes:
    """A calibration as OpenCV itself writes it."""
    file = cv2.FileStorage(suffix, cv2.FILE_STORAGE_WRITE | cv2.FILE_STORAGE_MEMORY)
    k1, k2, k3, k4, k5, k6 = camera.radial
    distortion = [k1, k2, *camera.tangential, k3, k4, k5, k6, *camera.thin_prism]
    rotation = camera.rotation_cam_from_world
    (fx, fy), (cx, cy) = camera.focal_px, camera.principal_point_px
    for key, value in {
        "calibration_time": "Mon 1 Jan 2024",
        "image_width": 1280,
        "image_height": 720,
        "camera_matrix": np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]),
        "distortion_coefficients": np.array([distortion]).T,
        "rvec": cv2.Rodrigues(rotation)[0],
        "tvec": (-rotation @ np.array(camera.position_world)).reshape(3, 1),
        "avg_reprojection_error": 0.3,
        "image_points": np.zeros((4, 500, 2)),
        **more,
    }.items():
        file.write(key, value)
    return file.releaseAndGetString().encode()


@pytest.mark.parametrize("suffix", [".yml", ".xml"])
@pytest.mark.parametrize("fmt", ["opencv", "auto"])
def test_what_opencv_writes(suffix, fmt):
    loaded = read_camera_file(storage(suffix, BENT), path=f"1{suffix}", fmt=fmt)
    agree(loaded, BENT, 1e-7)
    assert (loaded.model, loaded.size) == ("pinhole", SIZE)
    marked = storage(suffix, PINHOLE, fisheye_model=1, distortion_coefficients=np.zeros((4, 1)))
    assert read_camera_file(marked, path=f"1{suffix}", fmt=fmt).model == "fisheye"


VECTORS = {"tvec": [1.0, 50.0, 20.0], "distortion_coefficients": [0.1, 0.0, 0.0, 0.0, 0.0]}


@pytest.mark.parametrize("suffix", [".yml", ".xml"])
def test_vectors_as_opencv_5_writes_them(suffix):
    columns = {key: np.array([numbers]).T for key, numbers in VECTORS.items()}
    text = storage(suffix, BENT, **columns).decode()
    for key, numbers in VECTORS.items():
        values = [f"{number:g}." if number == int(number) else f"{number:g}" for number in numbers]
        written = (
            f"{key}: !!opencv-nd-matrix\n   sizes: [ {len(numbers)} ]\n   dt: d\n"
            f"   data: [ {', '.join(values)} ]\n"
            if suffix == ".yml"
            else f'<{key} type_id="opencv-nd-matrix">\n  <sizes>\n    {len(numbers)}</sizes>\n'
            f"  <dt>d</dt>\n  <data>\n    {' '.join(values)}</data></{key}>\n"
        )
        there = rf"{key}: !!opencv.*?\]\n" if suffix == ".yml" else rf"<{key} .*?</{key}>\n"
        text, count = re.subn(there, written, text, flags=re.DOTALL)
        assert count == 1
    flat = read_camera_file(text.encode(), path=f"1{suffix}").camera
    column = read_camera_file(storage(suffix, BENT, **columns), path=f"1{suffix}").camera
    assert flat == column
    long = text.replace("sizes: [ 3 ]", "sizes: [ 4 ]").replace("    3</sizes>", "    4</sizes>")
    assert "announces 4 x 1 numbers, found 3" in problem(long.encode(), "opencv", f"1{suffix}")


@pytest.mark.parametrize("camera", [PINHOLE, BENT, FISHEYE])
def test_yaml_written_here_is_read_here_and_by_opencv(camera):
    data = write_opencv(camera, SIZE)
    loaded = read_camera_file(data, path="1.yml")
    agree(loaded, camera)
    assert (loaded.model, loaded.size) == ("fisheye" if camera is FISHEYE else "pinhole", SIZE)
    theirs = cv2.FileStorage(data.decode(), cv2.FILE_STORAGE_READ | cv2.FILE_STORAGE_MEMORY)
    assert theirs.getNode("image_width").real() == 1280
    np.testing.assert_array_equal(theirs.getNode("R").mat(), camera.rotation_cam_from_world)
    assert theirs.getNode("camera_matrix").mat()[0, 0] == camera.focal_px[0]


def yaml(old: bytes = b"", new: bytes = b"") -> bytes:
    data = write_opencv(PINHOLE, SIZE)
    assert old in data
    return data.replace(old, new)


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        (b"", "is empty"),
        (b"hello", "is not a readable OpenCV FileStorage"),
        (yaml(b"camera_matrix", b"matrix"), "the key 'K' or 'camera_matrix' or "),
        (yaml(b"tvec:", b"wherever:"), "the key 't' or 'T' or 'tvec' "),
        (yaml(b"rows: 3\n   cols: 3", b"rows: 2\n   cols: 3"), "announces 2 x 3 numbers, found 9"),
        (yaml(b"2592.3", b".Nan"), "camera_matrix[0][0]: expected a finite number"),
        (yaml(b"2592.3", b'"wide"'), "camera_matrix[0]: expected a number"),
        (yaml(b"model: pinhole", b"model: mirror"), "model: expected 'pinhole' or 'fisheye'"),
        (yaml(b"image_width: 1280", b"image_width: 0"), "image_width and image_height: expected"),
        (b"%YAML:1.0\n---\ncamera_matrix: 5\n", "camera_matrix: expected a list of numbers"),
        (b"%YAML:1.0\n---\ncamera_matrix: [" + b"1., " * 99 + b"1.]\n", "has 100 entries"),
        (b"%YAML:1.0\n---\ncamera_matrix: { a: 1 }\n", "camera_matrix: expected a matrix"),
        (b"%YAML:1.0\n---\n- 1\n- 2\n", "is not a readable OpenCV FileStorage"),
        (b'<?xml version="1.0"?><opencv_storage>' + b"<a>" * 100_000, "is nested too deeply"),
        (yaml().decode().encode("utf-16"), "is not UTF-8 text"),
        (b"\xff\xfe\xff", "is not UTF-8 text"),
        (b"%YAML:1.0\n---\n" + b"# x\n" * 2_000_000, "is larger than 5 MB"),
    ],
)  # fmt: skip
def test_damage_in_opencvs_files(data, expected):
    assert expected in problem(data, "opencv")


# --------------------------------------------------------------------------- tvcalib, broadtrack


def tvcalib_line(name: str, camera: PinholeCamera, **changes: Any) -> bytes:
    content = json.loads(write_camera(camera))
    record = {"image_ids": name, "time_s": 0.04, "loss_ndc_total": 0.0087, "stadium": "None"}
    kept = {k: v for k, v in (record | content | changes).items() if v is not ...}
    return encoded(kept) + b"\n"


WORLD_FROM_IMAGE = [[0.05, 0.001, -32.0], [0.002, 0.06, -18.0], [0.0, 1e-4, 1.0]]


def test_tvcalib_records_and_homographies(tmp_path):
    file = tmp_path / "per_sample_output.json"
    sized = {"image_width": 1280, "image_height": 720}
    file.write_bytes(
        tvcalib_line("00002.jpg", PINHOLE, position_meters=[[[-1.2, 71.0, -13.5]]])
        + encoded({"image_ids": "10.jpg", "homography": WORLD_FROM_IMAGE, **sized})
        + b"\n\n"
        + encoded({"image_ids": "9.jpg", "homography": [WORLD_FROM_IMAGE]})
    )
    for fmt in ("tvcalib", "auto"):
        with CameraCollection.open(file, fmt) as cameras:
            assert list(cameras.frames) == ["00002", "9", "10"]
            agree(cameras.read("00002"), PINHOLE)
            sized_one = cameras.read("10")
            assert (sized_one.model, sized_one.size) == ("homography", (1280, 720))
            ground = np.array([[3.0, -4.0, 0.0]])
            px, valid = sized_one.camera.project(ground)
            back = np.array(WORLD_FROM_IMAGE) @ [*px[0], 1.0]
            assert valid.all()
            np.testing.assert_allclose(back[:2] / back[2], ground[0, :2], atol=1e-9)
            unsized = cameras.read("9")
            assert unsized.size is None
            assert "names no picture size" in unsized.notices[0]
            assert cameras.display("10") == f"{file}: line 2"


def test_one_bad_tvcalib_record_spoils_no_other(tmp_path):
    file = tmp_path / "per_sample_output.json"
    file.write_bytes(
        tvcalib_line("1.jpg", PINHOLE)
        + tvcalib_line("2.jpg", PINHOLE, x_focal_length=None)
        + tvcalib_line("3.jpg", PINHOLE, position_meters=[1, 2])
        + tvcalib_line("4.jpg", PINHOLE)
        + tvcalib_line("4.png", PINHOLE)
        + b'{"image_ids": 7}\n'
        + tvcalib_line("5.jpg", PINHOLE)[:-30]
    )
    with CameraCollection.open(file) as cameras:
        assert list(cameras.frames) == ["1", "2", "3", "4"]
        agree(cameras.read("1"), PINHOLE)
        for frame, said in (
            ("2", "line 2: x_focal_length: expected a finite number, found null"),
            ("3", "line 3: position_meters: expected 3 numbers, found 2 values"),
            ("4", "line 4 and line 5: holds 2 cameras for frame '4'"),
        ):
            with pytest.raises(CameraError) as caught:
                cameras.read(frame)
            assert str(caught.value).startswith(f"{file}: {said}")
        assert [n.split(": ", 2)[2].split(":")[0] for n in cameras.notices] == ["line 6", "line 7"]


def broadtrack_entry(camera: PinholeCamera) -> dict[str, Any]:
    width, height = SIZE
    focal = camera.focal_px[0]
    unit = height / focal
    return {
        "cp": {
            "sensorResolutionWidthPixels": float(width),
            "sensorResolutionHeightPixels": float(height),
            "horizontalFieldOfViewDegrees": math.degrees(2 * math.atan2(width / 2, focal)),
            "panDegrees": math.degrees(camera.pan_rad),
            "tiltDegrees": math.degrees(camera.tilt_rad),
            "rollDegrees": math.degrees(camera.roll_rad),
            "positionXMeters": camera.position_world[0],
            "positionYMeters": camera.position_world[1],
            "positionZMeters": camera.position_world[2],
            "normalizedRadialDistortionCoefficients": [
                k * unit ** (2 * i) for i, k in enumerate(camera.radial[:3], 1)
            ],
        },
        "score": 0.9,
        "time": 12.5,
        "reinit": False,
    }


SQUARE = PinholeCamera(
    PINHOLE.pan_rad, PINHOLE.tilt_rad, PINHOLE.roll_rad, PINHOLE.position_world,
    (2592.3, 2592.3), (640.0, 360.0), PINHOLE.radial,
)  # fmt: skip


@pytest.mark.parametrize("fmt", ["broadtrack", "auto"])
def test_broadtracks_cameras(tmp_path, fmt):
    file = tmp_path / "half1.json"
    damaged = broadtrack_entry(SQUARE)
    damaged["cp"]["tiltDegrees"] = None
    file.write_bytes(
        encoded(
            {
                "img/000010.jpg": broadtrack_entry(SQUARE),
                "img/000011.jpg": damaged,
                "img/000012": {"cp": json.loads(write_camera(SQUARE)), "score": 1},
                "img/000013.jpg": {"score": 0},
                "img/000014.jpg": {"cp": {**damaged["cp"], "horizontalFieldOfViewDegrees": 180}},
                "img/000015.jpg": [],
            }
        )
    )
    with CameraCollection.open(file, fmt) as cameras:
        assert len(cameras.frames) == 6
        loaded = cameras.read("000010")
        agree(loaded, SQUARE, 1e-6)
        assert loaded.size == SIZE
        agree(cameras.read("000012"), SQUARE)
        for frame, said in (
            ("000011", "000011.jpg: cp: tiltDegrees: expected a finite number, found null"),
            ("000013", "000013.jpg: the key 'cp' is missing"),
            ("000014", "000014.jpg: cp: horizontalFieldOfViewDegrees: expected an angle between"),
            ("000015", "000015.jpg: expected an object with the keys of a BroadTrack camera"),
        ):
            with pytest.raises(CameraError) as caught:
                cameras.read(frame)
            assert said in str(caught.value)


# --------------------------------------------------------------------------------- deepsportradar


def test_the_real_basketball_cameras_project_as_their_own_matrices(shared_data):
    worst = count = 0.0
    for name in ("val", "test"):
        file = shared_data / "deepsportradar" / f"ground_truth_{name}.json"
        entries = json.loads(file.read_bytes())[1:]
        with CameraCollection.open(file) as cameras:
            assert list(cameras.frames) == [str(i) for i in range(len(entries))]
            for frame, entry in zip(cameras.frames, entries, strict=True):
                loaded = cameras.read(frame)
                assert (loaded.model, loaded.size) == ("pinhole", (960, 540))
                random = np.random.default_rng(int(frame))
                court = random.uniform((0, 0, -300), (2800, 1500, 0), (4000, 3))  # cm
                homogeneous = np.column_stack((court, np.ones(len(court))))
                seen = homogeneous @ np.array(entry["P"]).reshape(3, 4).T
                px = seen[:, :2] / seen[:, 2:]
                inside = (seen[:, 2] > 0) & ((px >= 0) & (px <= (959, 539))).all(axis=1)
                world = (court - (1400, 750, 0)) / 100
                found, valid = loaded.camera.project(world)
                assert valid[inside].all()
                assert inside.sum() > 20
                worst = max(worst, float(np.abs(found - px)[inside].max()))
                position = (np.array(entry["C"]) - (1400, 750, 0)) / 100
                np.testing.assert_allclose(loaded.camera.position_world, position, atol=1e-4)
                count += 1
    assert count == 248
    assert worst < 1e-3  # K has a skew of 0.003, and numbers of single precision


def deepsportradar(**changes: Any) -> dict[str, Any]:
    rotation = PINHOLE.rotation_cam_from_world
    t = -rotation @ (np.array(PINHOLE.position_world) * 100 + (1400, 750, 0))
    k1, k2, k3 = PINHOLE.radial[:3]
    (fx, fy), (cx, cy) = PINHOLE.focal_px, PINHOLE.principal_point_px
    entry: dict[str, Any] = {
        "K": [fx, 0, cx, 0, fy, cy, 0, 0, 1],
        "R": rotation.ravel().tolist(),
        "T": t.tolist(),
        "kc": [k1, k2, 0, 0, k3],
    }
    return {k: v for k, v in (entry | changes).items() if v is not ...}


def test_a_basketball_list_with_distortion_and_damage(tmp_path):
    file = tmp_path / "predictions.json"
    placeholder = {"K": [1] * 9, "R": [1] * 9, "T": [0, 0, 1],
                   "P": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1]}  # fmt: skip
    file.write_bytes(
        encoded(
            [
                {"width": 1280, "height": 720},
                deepsportradar(),
                deepsportradar(T=[1, 2]),
                deepsportradar(K=[1] * 8),
                placeholder,
                "camera",
                deepsportradar(width=[960.0], height=[540.0], R=...),
                deepsportradar(width=[960.0], height=[540.0]),
                deepsportradar(
                    R=cv2.Rodrigues(PINHOLE.rotation_cam_from_world)[0].ravel().tolist()
                ),
            ]
        )
    )
    with CameraCollection.open(file, "deepsportradar") as cameras:
        assert list(cameras.frames) == ["0", "1", "2", "3", "4", "5", "6", "7"]
        for frame in ("0", "7"):  # a matrix, a rotation vector
            loaded = cameras.read(frame)
            agree(loaded, PINHOLE, 1e-7)
        assert loaded.size == SIZE
        assert cameras.read("6").size == (960, 540)
        for frame, said in (
            ("1", "[2]: T: expected 3 numbers, found 2"),
            ("2", "[3]: K: expected 3 x 3 numbers, found 8"),
            ("3", '[4]: P: stands for "no camera found"'),
            ("4", "[5]: expected an object with the keys of a K, R, T camera"),
            ("5", "[6]: the key 'R' is missing"),
        ):
            with pytest.raises(CameraError) as caught:
                cameras.read(frame)
            assert said in str(caught.value)


BROADTRACK, BASKETBALL = "broadtrack", "deepsportradar"


@pytest.mark.parametrize(
    ("fmt", "data", "expected"),
    [
        (BROADTRACK, b"{}", "holds no camera"),
        (BROADTRACK, b"[1]", "expected an object with the keys of a BroadTrack file"),
        (BROADTRACK, b'{"1.jpg": {"cp": {', "may be cut off"),
        (BROADTRACK, b'{"1.jpg": {}, "1.jpg": {}}', "occurs twice"),
        (BASKETBALL, b"{}", "expected a list of cameras, found an object"),
        (BASKETBALL, b"[]", "holds no camera"),
        (BASKETBALL, b'[{"width": 960, "height": 540}]', "holds no camera"),
        (BASKETBALL, b'[{"width": 0, "height": 540}, {}]', "width and height: expected whole"),
        (BASKETBALL, b'[{"K": [1', "may be cut off"),
    ],
)
def test_damage_to_all_of_a_file(tmp_path, fmt, data, expected):
    (tmp_path / "1.json").write_bytes(data)
    with pytest.raises(CameraError, match=expected):
        CameraCollection.open(tmp_path / "1.json", fmt)


# ------------------------------------------------------------------------------------- polylines

LINE = [{"x": 0.1, "y": 0.2}, {"x": 0.5, "y": 0.25}]


def test_polylines_belong_to_any_picture_size():
    content = {
        "Middle line": LINE,
        "Circle central": [LINE, [{"x": 0.9, "y": 1.5}]],
        "Goal left post left": [],
    }
    loaded = read_camera_file(encoded(content), path="1.json", fmt="polylines")
    assert loaded.model == "projections"
    for camera_size in (None, (1920, 1080)):
        camera, notice = fit_to_size(loaded, (960, 540), camera_size)
        assert notice is None
        assert isinstance(camera, ElementProjections)
        assert list(camera.pieces) == ["Middle line", "Circle central", "Goal left post left"]
        np.testing.assert_allclose(
            camera.pieces["Middle line"][0], [[95.9, 107.8], [479.5, 134.75]], rtol=1e-15
        )
        assert [p.shape for p in camera.pieces["Circle central"]] == [(2, 2), (1, 2)]
        assert camera.pieces["Goal left post left"] == ()


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        ([], "expected an object with the keys of projected polylines"),
        ({"Middle line": 5}, "Middle line: expected a list of points, found a number"),
        ({"Middle line": [1, 2]}, 'Middle line[0]: expected a point {"x": ..., "y": ...}, found 1'),
        ({"Middle line": [[{"x": 1, "y": None}]]}, "Middle line[0][0].y: expected a finite"),
        ({"Middle line": [{"x": math.nan, "y": 0}]}, "Middle line[0].x: expected a finite number"),
        ({"Goal left post left ": LINE, "Goal left post left": LINE}, "a class that is there"),
        ({"Middle line": [{"x": 480, "y": 270}]}, "no point is near the picture, expected shares"),
    ],
)
def test_damage_in_polylines(content, expected):
    assert expected in problem(encoded(content), "polylines")


# ---------------------------------------------------------------------------------- by the content


@pytest.mark.parametrize(
    "content",
    [
        {"Middle line": LINE},
        {"Middle line": [], "Circle left": LINE},
        {"Circle left": [LINE]},
        {"00001": {"Middle line": LINE}, "00002": {"Circle left": []}},
    ],
)
def test_an_annotation_is_never_taken_for_a_camera(content):
    said = problem(encoded(content), "auto")
    assert "holds points of classes, not a camera (annotations are no cameras" in said
    assert "camera format polylines" in said


def test_what_is_in_a_json_file_decides_what_it_is(tmp_path):
    krt_camera = json.loads(write_krt(PINHOLE, SIZE))
    soccernet = json.loads(write_camera(PINHOLE))
    files: dict[str, tuple[Any, list[str]]] = {
        "krt": ({"a.jpg": krt_camera, "b": krt_camera}, ["a", "b"]),
        "soccernet": ({"a.jpg": soccernet, "b": soccernet}, ["a", "b"]),
        "broadtrack": ({"a.jpg": broadtrack_entry(SQUARE)}, ["a"]),
        "deepsportradar": ([deepsportradar(), deepsportradar()], ["0", "1"]),
        "tvcalib": ([{"image_ids": "a.jpg", **soccernet}, {"image_ids": "b.jpg"}], ["a", "b"]),
        "tvcalib line": ({"image_ids": "a.jpg", **soccernet}, ["a"]),
        "one": (krt_camera, ["one"]),
    }
    for name, (content, frames) in files.items():
        file = tmp_path / f"{name}.json"
        file.write_bytes(encoded(content))
        with CameraCollection.open(file) as cameras:
            assert list(cameras.frames) == frames, name
            agree(cameras.read(frames[0]), SQUARE if name == "broadtrack" else PINHOLE, 1e-6)
