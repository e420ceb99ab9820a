"""Cameras of published datasets and tools: DeepSportRadar, World Cup 2014, PTZ-SLAM, NeRF.

Facts on transforms.json: https://docs.nerf.studio/quickstart/data_conventions.html and the docs of
instant-ngp. A pose is camera -> world; a camera's axes are OpenGL's (x right, y up, z back).
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.homography import (
    CONVENTIONS,
    HOMOGRAPHY_SIZE,
    YARD_M,
    camera_from_homography,
)
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.krt import (
    HALF_TURN,
    KRT_KEYS,
    KrtKeys,
    camera_of_matrices,
    centred_k,
)
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
    ReadRecord,
    frame_of_image,
    with_notices,
)
from procc_annotator.formats.strict_json import json_kind

_DEEPSPORTRADAR = KrtKeys(
    k=("K",), r=("R",), t=("T",), position=(), pose=(), inverse_pose=(), distortion=("kc",),
    model=(), repeated=("C", "P"),
    unit_m=0.01,
    origin=(1400.0, 750.0, 0.0),  # the centre of a FIBA court from the corner that is their origin
    kind="a K, R, T camera of DeepSportRadar",
)  # fmt: skip
# World Cup 2014 in metres from a corner, z up.
_PTZ = replace(
    KRT_KEYS,
    axes=HALF_TURN,
    origin=(115 / 2 * YARD_M, 74 / 2 * YARD_M, 0.0),
    kind="a K, R, t camera",
)
PANOPTIC = KrtKeys(
    k=("K",), r=("R",), t=("t",), position=(), pose=(), inverse_pose=(), distortion=("distCoef",),
    model=(), size=("resolution",), unit_m=0.01, kind="a camera of the Panoptic Studio",
    # The dome's axes in ours: x stays, our y is against its z, our z (down) is its y.
    axes=np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]),
)  # fmt: skip
_TRANSFORMS = replace(KRT_KEYS, axes=HALF_TURN, kind="a transforms.json")
# What the challenge's code writes where it found no camera.
_NO_CAMERA = [1.0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1]
_REMARK = "cameras of a basketball court, for frames called 0, 1, 2 ... by their order in the file"


def deepsportradar_records(content: object, path: str) -> CameraRecords:
    """The cameras of a decoded list; the first entry may give the pictures' size alone.

    Raises:
        CameraError: not a list, or one without cameras.
    """
    if type(content) is not list:
        raise CameraError(
            path, f"expected a list of cameras, found {json_kind(content)}", place="top level"
        )
    size = None
    entries = list(enumerate(content))
    if entries and type(content[0]) is dict and set(content[0]) == {"width", "height"}:
        size = JsonValues(content[0], path, "[0]", _DEEPSPORTRADAR.kind, nested=True).size()
        entries = entries[1:]

    def camera(entry: object, path: str, at: str) -> LoadedCamera:
        values = JsonValues.of(entry, path, at, _DEEPSPORTRADAR.kind, nested=True)
        if "P" in values and list(values.numbers("P")) == _NO_CAMERA:
            raise values.error('stands for "no camera found"', "P", advice="")
        return camera_of_matrices(values, _DEEPSPORTRADAR, values.size() or size)

    found = [
        (str(frame), CameraRecord(f"[{i}]", entry)) for frame, (i, entry) in enumerate(entries)
    ]
    return CameraRecords.of(path, found, camera, (_REMARK,), "a list of cameras")


_MATLAB_KIND = "an annotation of a MATLAB structure"


def is_annotation_set(key: str, content: object) -> bool:
    """Return whether decoded content is a structure of annotations with a key."""
    return any(key in entry for entry in _annotations(content))


def _annotations(content: object) -> list[dict[str, Any]]:
    found = content.get("annotation") if type(content) is dict else None
    entries = found if type(found) is list else [found]
    return [entry for entry in entries if type(entry) is dict and "image_name" in entry]


def annotation_records(read: ReadRecord, content: object, path: str) -> CameraRecords:
    """The cameras of the entries ``annotation(i)`` of decoded content. `CameraError` if it holds no
    camera."""
    found = [
        (str(entry["image_name"]), CameraRecord(f"annotation({i})", entry))
        for i, entry in enumerate(_annotations(content), 1)
    ]
    return CameraRecords.of(path, found, read, (), "annotation(i) with image_name")


def read_set_homography(content: Any, path: str, inside: str) -> LoadedCamera:
    """The camera of an entry with a homography, world -> picture, in yards."""
    values = JsonValues.of(content, path, inside, _MATLAB_KIND)
    image_from_ground = values.matrix("homography", 3, 3)
    try:
        matrix: FloatArray = np.linalg.inv(image_from_ground).astype(np.float64)
    except np.linalg.LinAlgError as error:
        raise values.error("cannot be inverted", "homography") from error
    world = CONVENTIONS["wc14"].world_from_units
    loaded = camera_from_homography(matrix, world, HOMOGRAPHY_SIZE, path=path, place=inside)
    return with_notices(replace(loaded, assumed_field="soccer"), values.unused("homography"))


def read_ptz(content: Any, path: str, inside: str) -> LoadedCamera:
    """The camera of an entry cx, cy, focal length, rotation vector, position (metres, z up)."""
    values = JsonValues.of(content, path, inside, _MATLAB_KIND)
    cx, cy, focal, *rest = values.vector("camera", 9)
    own = {
        "K": [[focal, 0.0, cx], [0.0, focal, cy], [0.0, 0.0, 1.0]],
        "rvec": rest[:3],
        "position": rest[3:],
        "width": round(2 * cx),
        "height": round(2 * cy),
    }
    loaded = camera_of_matrices(JsonValues(own, path, inside, _PTZ.kind), _PTZ)
    return with_notices(replace(loaded, assumed_field="soccer"), values.unused("camera"))


_POSE = "transform_matrix"
_FISHEYE = "OPENCV_FISHEYE"
_MODELS = ("OPENCV", "PINHOLE", "SIMPLE_PINHOLE", _FISHEYE)
_TERMS = ("k1", "k2", "p1", "p2", "k3", "k4")
_USED = (
    _POSE, "camera_model", "is_fisheye", "w", "h", "fl_x", "fl_y", "camera_angle_x",
    "camera_angle_y", "cx", "cy", *_TERMS,
)  # fmt: skip


def transforms_records(content: object, path: str) -> CameraRecords:
    """The camera of every picture of a decoded transforms.json. `CameraError` if it lists no
    pictures."""
    values = JsonValues.of(content, path, kind=_TRANSFORMS.kind)
    frames = values.content.get("frames")
    if type(frames) is not list or not frames:
        raise values.error("expected a list of pictures with their poses", "frames")
    shared = {key: value for key, value in values.content.items() if key != "frames"}
    found = []
    for i, frame in enumerate(frames):
        own = JsonValues.of(frame, path, f"frames[{i}]", _TRANSFORMS.kind)
        name = own.content.get("file_path")
        if type(name) is not str or not frame_of_image(name):
            raise own.error("expected the path of a picture", "file_path")
        found.append((name, CameraRecord(f"frames[{i}]", {**shared, **frame})))
    return CameraRecords.of(path, found, _transform)


def _transform(content: Any, path: str, inside: str) -> LoadedCamera:
    values = JsonValues(content, path, inside, _TRANSFORMS.kind)
    model = values.content.get("camera_model", "OPENCV")
    if model not in _MODELS:
        raise values.error(f"expected {' or '.join(_MODELS)}", "camera_model")
    size = values.size_under(("w", "h"), ("width", "height"))
    if size is None:
        raise values.missing("the size of the pictures", "w", "h")
    is_fisheye = model == _FISHEYE or values.content.get("is_fisheye") is True
    pose = content.get(_POSE)
    matrix = values.matrix(_POSE, 3 if type(pose) is list and len(pose) == 3 else 4, 4)
    fx = _focal(values, size[0], "fl_x", "camera_angle_x")
    if fx is None:
        raise values.missing("a focal length or an angle of view", "camera_angle_x", "fl_x")
    fy = _focal(values, size[1], "fl_y", "camera_angle_y") or fx
    cx, cy = (
        values.number(key) if key in values else n / 2
        for key, n in zip(("cx", "cy"), size, strict=True)
    )
    k1, k2, p1, p2, k3, k4 = (values.number(key) if key in values else 0.0 for key in _TERMS)
    if k4 and not is_fisheye:
        raise values.error("expected 0 for a lens that is no fisheye", "k4")
    own = {
        "model": "fisheye" if is_fisheye else "pinhole",
        "K": centred_k(fx, fy, cx, cy),
        "R": (HALF_TURN @ matrix[:3, :3].T).tolist(),
        "position": matrix[:3, 3].tolist(),
        "dist": [k1, k2, k3, k4] if is_fisheye else [k1, k2, p1, p2, k3],
        "width": size[0],
        "height": size[1],
    }
    loaded = camera_of_matrices(JsonValues(own, path, inside, KRT_KEYS.kind), _TRANSFORMS)
    return with_notices(loaded, values.unused(*_USED))


def _focal(values: JsonValues, length: int, key: str, angle_key: str) -> float | None:
    """px, from a focal length or an angle of view along a side of the picture."""
    if key in values:
        return values.focal(key)
    if angle_key not in values:
        return None
    angle = values.number(angle_key)
    if not 0 < angle < math.pi:
        raise values.error("expected an angle between 0 and pi", angle_key)
    return length / 2 / math.tan(angle / 2)
