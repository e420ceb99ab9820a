"""NeRF ``transforms.json``: shared intrinsics and a pose per picture.

Facts: https://docs.nerf.studio/quickstart/data_conventions.html and instant-ngp's docs. A pose is
camera -> world; a camera's axes are OpenGL's (x right, y up, z back), the world's z points up.
Pixels count from the corner of the picture, not from the centre of its first pixel.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from procc_annotator.camera.base import FloatArray
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.krt import krt_from
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
    frame_of_image,
    with_notices,
)

KIND = "a transforms.json"
_POSE = "transform_matrix"
_FISHEYE = "OPENCV_FISHEYE"
_MODELS = ("OPENCV", "PINHOLE", "SIMPLE_PINHOLE", _FISHEYE)
_USED = (
    _POSE, "camera_model", "is_fisheye", "w", "h", "fl_x", "fl_y", "camera_angle_x",
    "camera_angle_y", "cx", "cy", "k1", "k2", "k3", "k4", "p1", "p2",
)  # fmt: skip
_OPENCV_FROM_OPENGL = np.diag([1.0, -1.0, -1.0])
# Their world has z up and ours z down: half a turn about the x axis they share.
_WORLD_TURN = np.diag([1.0, -1.0, -1.0])
CORNER = 0.5  # px from the corner of a picture to the centre of its first pixel


def is_transforms(content: object) -> bool:
    """Return whether a decoded value is such a file."""
    frames = content.get("frames") if type(content) is dict else None
    return type(frames) is list and any(type(f) is dict and _POSE in f for f in frames)


def transforms_records(content: object, path: str) -> CameraRecords:
    """The camera of every picture of a decoded file.

    Raises:
        CameraError: it lists no pictures.
    """
    values = JsonValues.of(content, path, kind=KIND)
    frames = values.content.get("frames")
    if type(frames) is not list or not frames:
        raise values.error("expected a list of pictures with their poses", "frames")
    shared = {key: value for key, value in values.content.items() if key != "frames"}
    found = []
    for i, frame in enumerate(frames):
        own = JsonValues.of(frame, path, f"frames[{i}]", KIND)
        name = own.content.get("file_path")
        if type(name) is not str or not frame_of_image(name):
            raise own.error("expected the path of a picture", "file_path")
        found.append((name, CameraRecord(f"frames[{i}]", {**shared, **frame})))
    return CameraRecords.of(path, found, _camera)


def _camera(content: Any, path: str, inside: str) -> LoadedCamera:
    values = JsonValues(content, path, inside, KIND)
    model = values.content.get("camera_model", "OPENCV")
    if model not in _MODELS:
        raise values.error(f"expected {' or '.join(_MODELS)}", "camera_model")
    size = _size(values)
    fisheye = model == _FISHEYE or values.content.get("is_fisheye") is True
    rotation, t = _pose(values)
    own = {
        "model": "fisheye" if fisheye else "pinhole",
        "K": _calibration(values, size),
        "R": rotation.tolist(),
        "t": t.tolist(),
        "dist": _distortion(values, fisheye),
        "width": size[0],
        "height": size[1],
    }
    return with_notices(krt_from(own, path, inside), values.unused(*_USED))


def _size(values: JsonValues) -> tuple[int, int]:
    size = values.size_under(("w", "h"), ("width", "height"))
    if size is None:
        raise values.missing("the size of the pictures", "w", "h")
    return size


def _calibration(values: JsonValues, size: tuple[int, int]) -> list[list[float]]:
    width, height = size
    if "fl_x" in values:
        fx = values.focal("fl_x")
    else:
        key = values.need("a focal length or an angle of view", "camera_angle_x", "fl_x")
        fx = width / 2 / _tangent(values, key)
    if "fl_y" in values:
        fy = values.focal("fl_y")
    else:
        fy = height / 2 / _tangent(values, "camera_angle_y") if "camera_angle_y" in values else fx
    cx = values.number("cx") if "cx" in values else width / 2
    cy = values.number("cy") if "cy" in values else height / 2
    return [[fx, 0.0, cx - CORNER], [0.0, fy, cy - CORNER], [0.0, 0.0, 1.0]]


def _tangent(values: JsonValues, key: str) -> float:
    angle = values.number(key)
    if not 0 < angle < math.pi:
        raise values.error("expected an angle between 0 and pi", key)
    return math.tan(angle / 2)


def _distortion(values: JsonValues, fisheye: bool) -> list[float]:
    k1, k2, k3, k4, p1, p2 = (
        values.number(key) if key in values else 0.0 for key in ("k1", "k2", "k3", "k4", "p1", "p2")
    )
    if fisheye:
        return [k1, k2, k3, k4]
    if k4:
        raise values.error("expected 0 for a lens that is no fisheye", "k4")
    return [k1, k2, p1, p2, k3]


def _pose(values: JsonValues) -> tuple[FloatArray, FloatArray]:
    """R and t of x_cam = R x_world + t, in our axes and metres."""
    rows = len(values.content[_POSE]) if type(values.content.get(_POSE)) is list else 4
    matrix = values.matrix(_POSE, 3 if rows == 3 else 4, 4)
    rotation = _OPENCV_FROM_OPENGL @ matrix[:3, :3].T @ _WORLD_TURN
    with np.errstate(over="ignore", invalid="ignore"):
        t = -rotation @ (_WORLD_TURN @ matrix[:3, 3])
    if not np.isfinite(t).all():
        raise values.error("is without bounds", _POSE)
    return rotation, t
