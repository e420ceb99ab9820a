"""Camera files of the field, 2024-2026: each is written here from a camera, as its program does."""

import csv
import io
import json
import math
import re
import struct
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from procc_annotator.camera.matrices import calibration_matrix, distortion_vector, translation
from procc_annotator.camera.models import FisheyeCamera, PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.collection import CameraCollection

SIZE = (1280, 720)
BENT = PinholeCamera(
    0.3, 1.3, 0.02, (4.0, 60.0, -15.0), (1500.0, 1490.0), (640.0, 355.0),
    (-0.1, 0.02, 0.0, 0.0, 0.0, 0.0), (0.001, -0.002),
)  # fmt: skip
RADIAL = replace(BENT, tangential=(0.0, 0.0))
SQUARE = PinholeCamera(0.3, 1.3, 0.02, (4.0, 60.0, -15.0), (1500.0, 1500.0), (639.5, 359.5))
K, R, T = calibration_matrix(BENT), BENT.rotation_cam_from_world, translation(BENT)
DIST = np.array(distortion_vector(BENT))
UP = np.diag([1.0, -1.0, -1.0])  # our world's axes in those of one with z up
POINTS = np.random.default_rng(7).uniform((-20, -15, -2.5), (20, 15, 0), (100, 3))


def npz(**arrays: Any) -> bytes:
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)
    return buffer.getvalue()


def rows(*lines: list[object]) -> bytes:
    text = io.StringIO()
    csv.writer(text).writerows(lines)
    return text.getvalue().encode()


def pose(camera: PinholeCamera) -> np.ndarray:
    return np.column_stack((camera.rotation_cam_from_world, translation(camera)))


def four(matrix: np.ndarray) -> np.ndarray:
    return np.vstack((matrix, [0, 0, 0, 1]))


def fifa(**more: Any) -> bytes:
    parts = {"K": np.stack([K] * 3), "k": np.stack([DIST[:5]] * 3), "R": (R @ UP)[None]}
    return npz(**parts, t=T[None], **more)


def pose2sim() -> bytes:
    import cv2

    def text(values: Any) -> str:
        return json.dumps(np.asarray(values).tolist())

    rvec = cv2.Rodrigues(R @ UP)[0].ravel()
    return (
        f'[cam_01]\nname = "cam_01"\nsize = [1280.0, 720.0]\nmatrix = {text(K)}\n'
        f"distortions = {text(DIST[:4])}\nrotation = {text(rvec)}\ntranslation = {text(T)}\n"
        "fisheye = false\n\n[metadata]\nadjusted = false\nerror = 0.0\n"
    ).encode()


def synloc() -> bytes:
    across = np.array([[0.0, -1, 0], [-1, 0, 0], [0, 0, -1]])  # our axes -> its
    matrix = -np.column_stack((R @ across.T, T))  # its third coordinate may have any sign
    lens = np.polynomial.Polynomial([0, 0.7, 0, -0.08, 0, 0.01])
    image = {
        "id": 0, "file_name": "7.jpg", "width": 1280, "height": 720,
        "camera_matrix": matrix.tolist(), "dist_poly": lens.coef[::-1].tolist(),
        "undist_poly": [0.1] * 9,
    }  # fmt: skip
    return json.dumps({"images": [image], "annotations": [], "categories": []}).encode()


KB = FisheyeCamera(
    BENT.pan_rad, BENT.tilt_rad, BENT.roll_rad, BENT.position_world, (896.0, 896.0),
    (639.5, 359.5), (-0.08 / 0.7, 0.01 / 0.7, 0.0, 0.0),
)  # fmt: skip


def otio(model: str = "Brown-Conrady U-D") -> dict[str, Any]:
    # Its axes: x right, y forward, z up. R = Rz(pan) Rx(tilt) Ry(roll), camera -> stage.
    turn = UP @ R.T @ np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]).T
    tilt = math.asin(turn[2, 1])
    pan, roll = math.atan2(-turn[0, 1], turn[1, 1]), math.atan2(-turn[2, 0], turn[2, 2])
    f = 1500 * 12.8 / 1280
    x, y, z = UP @ np.array(BENT.position_world)
    zero = {"pan": 0, "tilt": 0, "roll": 0}
    angles = {k: math.degrees(v) for k, v in (("pan", pan), ("tilt", tilt), ("roll", roll))}
    k1, k2, p1, p2 = DIST[:4]
    return {
        "static": {"camera": {
            "activeSensorResolution": {"width": 1280, "height": 720},
            "activeSensorPhysicalDimensions": {"width": 12.8, "height": 7.2 * 1500 / 1490},
        }},
        "lens": {
            "pinholeFocalLength": f,
            "projectionOffset": {"x": 0.5 * 0.01, "y": -4.5 * 0.01 * 1500 / 1490},
            "distortion": [{"model": model, "radial": [k1 / f**2, 0, k2 / f**4],
                            "tangential": [p1 / f**2, p2 / f**2]}],
        },
        "transforms": [{"translation": {"x": x, "y": y, "z": 0}, "rotation": zero},
                       {"translation": {"x": 0, "y": 0, "z": z}, "rotation": angles}],
    }  # fmt: skip


def qualisys() -> bytes:
    turn = UP @ R @ UP  # its camera looks along -z
    entries = " ".join(f'r{i + 1}{j + 1}="{turn[i, j]!r}"' for i in range(3) for j in range(3))
    x, y, z = UP @ np.array(BENT.position_world) * 1000
    u, v = 64 * (K[0, 2] + 10), 64 * (K[1, 2] + 20)
    intrinsic = zip(("radialDistortion1", "radialDistortion2", "tangentalDistortion1",
                     "tangentalDistortion2"), DIST[:4], strict=True)  # fmt: skip
    lens = " ".join(f'{key}="{64 * value}"' for key, value in intrinsic)
    text = (
        '<?xml version="1.0"?><calibration><cameras><camera serial="21" model="Miqus Video">'
        '<fov_video left="10" top="20" right="1289" bottom="739"/>'
        f'<transform x="{x}" y="{y}" z="{z}" {entries}/>'
        f'<intrinsic focalLengthU="{64 * K[0, 0]}" focalLengthV="{64 * K[1, 1]}"'
        f' centerPointU="{u}" centerPointV="{v}" {lens}/></camera></cameras></calibration>'
    )
    return re.sub(r"np\.float64\(([^)]*)\)", r"\1", text).encode()


GROUND = (calibration_matrix(SQUARE) @ pose(SQUARE))[:, [0, 1, 3]]
KITTI = (calibration_matrix(SQUARE) @ pose(SQUARE)).ravel().tolist()
FILES: dict[str, tuple[str, Callable[[], bytes], str, Any]] = {
    "fifa": ("seq.npz", fifa, "0", BENT),
    "one fifa camera of each frame": (
        "seq.npz", lambda: npz(K=np.stack([K] * 2), k=np.stack([DIST[:5]] * 2),
                               R=np.stack([R @ UP] * 2), t=np.stack([T] * 2)), "1", BENT,
    ),
    "k in an npz with z down": (
        "seq.npz", lambda: npz(K=K[None], k=DIST[None, :5], R=R[None], t=T[None]), "0", BENT,
    ),
    "pose2sim": ("Calib.toml", pose2sim, "cam_01", BENT),
    "synloc": ("val.json", synloc, "7", KB),
    "opentrackio": ("sample.json", lambda: json.dumps(otio()).encode(), "sample", BENT),
    "opentrackio lines, static once": (
        "clip.jsonl", lambda: b"\n \n".join(json.dumps({k: v for k, v in otio().items() if k not in
                                                     left}).encode() for left in ((), ("static",))),
        "1", BENT,
    ),
    "qualisys": ("a.qca.txt", qualisys, "21", BENT),
    "vggt": (
        "predictions.npz", lambda: npz(extrinsic=pose(SQUARE)[None, None],
                                       intrinsic=calibration_matrix(SQUARE)[None, None],
                                       depth=np.zeros((1, 1, 720, 1280, 1), np.float16)),
        "0", SQUARE,
    ),
    "megasam": (
        "a_sgd_cvd_hr.npz", lambda: npz(cam_c2w=np.linalg.inv(four(pose(SQUARE)))[None],
                                        intrinsic=calibration_matrix(SQUARE),
                                        images=np.zeros((2, 1080, 1920, 3), np.uint8)),
        "0", SQUARE,
    ),
    "fifa, two coefficients": (
        "seq.npz", lambda: npz(K=np.stack([K] * 3), k=np.stack([[-0.1, 0.02]] * 3),
                               R=(R @ UP)[None], t=T[None]), "0", RADIAL,
    ),
    "coefficients one by one": (
        "1.json", lambda: json.dumps({"K": K.tolist(), "R": R.tolist(), "t": T.tolist(), **dict(
            zip(("k1", "k2", "p1", "p2"), DIST.tolist(), strict=False))}).encode(), "1", BENT,
    ),
    "radial and tangential apart": (
        "1.json", lambda: json.dumps({
            "K": K.tolist(), "R": R.tolist(), "t": T.tolist(),
            "radial_distortion": DIST[:2].tolist(),
            "tangential_distortion": DIST[2:4].tolist()}).encode(), "1", BENT,
    ),
    "numbers of K one by one": (
        "1.json", lambda: json.dumps({
            "intrinsics": {"fx": K[0, 0], "fy": K[1, 1], "cx": K[0, 2], "cy": K[1, 2],
                           "k1": DIST[0], "k2": DIST[1], "p1": DIST[2], "p2": DIST[3]},
            "extrinsics": {"R": R.tolist(), "t": T.tolist()},
        }).encode(), "1", BENT,
    ),
    "4x4 beside K": (
        "1.json", lambda: json.dumps({"K": K.tolist(), "w2c": four(pose(BENT)).tolist(),
                                      "dist": DIST.tolist()}).encode(), "1", BENT,
    ),
    "kitti": ("calib.txt", lambda: f"\ufeffP0: {' '.join(map(str, KITTI))}\n".encode(),
              "P0", SQUARE),
    "dlt3d": (
        "a.dlt3d", lambda: rows(["frame", *(f"dlt_param_{i}" for i in range(1, 12))],
                                [0, *(v / KITTI[11] for v in KITTI[:11])]), "0", SQUARE,
    ),
    "dlt2d": (
        "a.dlt2d", lambda: rows(["frame", *(f"dlt_param_{i}" for i in range(1, 9))],
                                [0, *(GROUND / GROUND[2, 2]).ravel()[:8]]), "0", SQUARE,
    ),
    "homography table": (
        "h.csv", lambda: rows(["frame", "homography_matrix"],
                              ["7.jpg", json.dumps(np.linalg.inv(GROUND).tolist())]), "7", SQUARE,
    ),
    "homographies, a line each": (
        "h.csv", lambda: rows(["frame", *(f"h{i}{j}" for i in "123" for j in "123")],
                              [7, *np.linalg.inv(GROUND).ravel()]), "7", SQUARE,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", FILES)
def test_cameras_of_the_field_are_read(name, tmp_path):
    file_name, write, frame, camera = FILES[name]
    (file := tmp_path / file_name).write_bytes(write())
    points = POINTS * ([1, 1, 0] if name[0] in "dh" and "3d" not in name else 1)
    with CameraCollection.open(file) as cameras:
        loaded = cameras.read(frame)
    found, valid = loaded.camera.project(points)
    assert valid.all()
    np.testing.assert_allclose(found, camera.project(points)[0], atol=2e-3)
    assert not [n for n in loaded.notices if "not used" in n or "below" in n]
    assert name not in ("vggt", "synloc", "pose2sim", "qualisys") or loaded.size == SIZE


@pytest.mark.parametrize("kind", ["OPENCV", "OPENCV_FISHEYE", "FOV"])
def test_binary_models_of_colmap(kind, tmp_path):
    import cv2

    number, lens = {
        "OPENCV": (4, [1500, 1490, 640.5, 355.5, *DIST[:4]]),
        "OPENCV_FISHEYE": (5, [896, 896, 640, 360, *KB.coefficients]),
        "FOV": (7, [900, 900, 640, 360, 0.9]),
    }[kind]
    half = cv2.Rodrigues(R)[0].ravel() / 2
    angle = float(np.linalg.norm(half))
    quaternion = [math.cos(angle), *(math.sin(angle) * half / angle)]
    (tmp_path / "cameras.bin").write_bytes(
        struct.pack(f"<QiiQQ{len(lens)}d", 1, 3, number, *SIZE, *lens)
    )
    entry = struct.pack("<i7di", 1, *quaternion, *T, 3) + b"a/7.jpg\0"
    images = struct.pack("<Q", 2) + entry + struct.pack("<Q2dq", 1, 3, 4, -1)
    images += entry.replace(b"7.jpg", b"8.jpg") + struct.pack("<Q", 0)
    (tmp_path / "images.bin").write_bytes(images)
    (tmp_path / "points3D.bin").write_bytes(struct.pack("<Q", 0))
    with CameraCollection.open(tmp_path) as cameras:
        assert list(cameras.frames) == ["7", "8"]
        if kind == "FOV":
            with pytest.raises(CameraError, match="the model 'FOV'; SIMPLE_PINHOLE"):
                cameras.read("8")
            return
        found = cameras.read("8").camera.project(POINTS)[0]
    np.testing.assert_allclose(found, (BENT if number == 4 else KB).project(POINTS)[0], atol=1e-6)
    for cut in range(0, len(images) - 8, 7):
        (tmp_path / "images.bin").write_bytes(images[:cut])
        with pytest.raises(CameraError, match="ends within an entry"):
            CameraCollection.open(tmp_path)


def test_what_is_left_out_or_approximate_is_said(tmp_path):
    for name in ("a", "b"):
        (tmp_path / f"{name}.npz").write_bytes(fifa(lens=[0.1, 0.2]))
    with CameraCollection.open(tmp_path) as cameras:
        assert list(cameras.frames) == ["a/0", "b/0"]
        assert "R and t are of the first frame alone: 2 frames without a camera" in cameras.notices
        said = "; ".join(cameras.read("b/0").notices)
    assert "its world has z up" in said
    assert "not used, though it looks like lens, pose or size: lens" in said
    (tmp_path / "a.npz").write_bytes(npz(K=np.stack([K] * 4), R=np.stack([R] * 3), t=T))
    with pytest.raises(CameraError, match="holds 4 of K, 3 of R"):
        CameraCollection.open(tmp_path / "a.npz")


def test_a_distortion_from_picture_to_scene_is_inverted(tmp_path):
    sample = otio("Brown-Conrady D-U")
    sample["lens"]["distortion"][0]["tangential"] = [0.0, 0.0]
    (file := tmp_path / "c.json").write_text(json.dumps(sample))
    with CameraCollection.open(file) as cameras:
        found, _ = cameras.read("c").camera.project(POINTS)
    shown = (found - (640.0, 355.0)) / (1500.0, 1490.0)
    r2 = (shown**2).sum(axis=1, keepdims=True)
    rays = POINTS @ R.T + T
    undistorted = shown * (1 + DIST[0] * r2 + DIST[1] * r2**2)
    inside = ((found > 0) & (found < SIZE)).all(axis=1)
    off_px = 1500 * np.abs(undistorted - rays[:, :2] / rays[:, 2:])[inside]
    assert inside.sum() > 20
    assert off_px.max() < 0.01


@pytest.mark.parametrize(
    ("model", "radial", "problem"),
    [
        ("D-U", [0.05], "moves the corner"), ("U-D", [0.05, 0, -0.02], "moves the corner"),
        ("U-D", [-0.05], "moves the corner"),
        ("D-U", [0.06, 0, -0.0011], "the closest lens differs"),
    ],
)  # fmt: skip
def test_a_distortion_in_other_units_is_refused(model, radial, problem, tmp_path):
    sample = otio(f"Brown-Conrady {model}")
    sample["lens"]["distortion"][0]["radial"] = radial
    (file := tmp_path / "c.json").write_text(json.dumps(sample))
    expected = f"{problem}.*by powers of mm"
    with CameraCollection.open(file) as cameras, pytest.raises(CameraError, match=expected):
        cameras.read("c")


def test_calibrations_in_the_folders_of_matches_and_names_of_a_sequence(tmp_path):
    for match in ("a", "b"):
        (tmp_path / match).mkdir()
        (tmp_path / match / "Calib.toml").write_bytes(pose2sim())
    with CameraCollection.open(tmp_path) as cameras:
        assert {"a/cam_01", "b/cam_01"} <= set(cameras.frames)
    data = npz(K=np.stack([K] * 2), R=np.stack([R] * 2), t=np.stack([T] * 2), frame_ids=[7, 8])
    (file := tmp_path / "seq.npz").write_bytes(data)
    with CameraCollection.open(file) as cameras:
        assert [*cameras.frames] == ["7", "8"]


def test_hints_about_a_world_are_those_of_every_format(tmp_path):
    up = np.column_stack((R @ UP, T))
    for name, data, expected in (
        ("a.npz", npz(K=K[None], R=(R @ UP)[None], t=T[None]), "its z is up"),
        ("a.toml", f"[c]\nK = {K.tolist()}\nw2c = {up.tolist()}".encode(), "its z is up"),
        ("a.csv", rows(["frame", "H"], [1, GROUND.tolist()]), "takes the ground to the picture"),
        ("c.csv", rows(["frame", "H"], [1, (np.diag([1, -1, 1]) @ np.linalg.inv(GROUND)).tolist()]),
         "mirrors the ground"),
        ("b.csv", rows(["frame", "H"], [1, (np.diag([100, 100, 1]) @ np.linalg.inv(GROUND))
                                        .tolist()]), "looks like centimetres"),
        ("a.dlt2d", rows(["frame", *(f"dlt_param_{i}" for i in range(1, 9))],
                         [0, *(np.linalg.inv(GROUND) / np.linalg.inv(GROUND)[2, 2]).ravel()[:8]]),
         "takes the ground to the picture"),
    ):  # fmt: skip
        (file := tmp_path / name).write_bytes(data)
        with CameraCollection.open(file) as cameras:
            notices = cameras.read(next(iter(cameras.frames))).notices
        assert any(expected in notice for notice in notices), name


@pytest.mark.parametrize(
    ("name", "data", "expected"),
    [
        ("poses.txt", b"1 0 0 0 0 1 0 0 0 0 1 0\n" * 3, "a pose .* without a lens.*w2c=pose"),
        ("a.xml", b'<document version="2.0.0">\n<chunk id="0">', "Metashape.*COLMAP"),
        ("a.json", b'{"sfm_data_version": "0.3", "views": []}', "OpenMVG.*COLMAP"),
        ("a.toml", b"a = [", "is no TOML"),
        ("a_cam.txt", b"extrinsic\n1 0 0 0\n", "MVSNet or Pix4D.*w2c"),
        ("a.json", b'{"1": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}', "holds a homography.*make CSV"),
        ("a.json", b'{"frames": [{"frame": 1, "H": []}]}', "holds a homography.*make CSV"),
        ("a.json", b'{"K": [[9, 0, 1], [0, 9, 1], [0, 0, 1]]}', "a lens without a place"),
        ("a.yaml", b"image_width: 9\ndistortion_model: a\n", "ROS or Kalibr.*add R and tvec"),
        ("a.yaml", b"D: [0]\ndistortion_model: plumb_bob\n---\n", "ROS or Kalibr.*add R and tvec"),
    ],
)
def test_what_is_not_read_is_named_with_the_way_out(name, data, expected, tmp_path):
    (file := tmp_path / name).write_bytes(data)
    with pytest.raises(CameraError, match=expected), CameraCollection.open(file) as cameras:
        cameras.read(next(iter(cameras.frames)))
