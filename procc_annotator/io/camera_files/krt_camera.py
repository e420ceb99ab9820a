"""Cameras as K, R, t and distortion: the plain JSON of this project, and what others share with it.

See docs/camera-formats.md for the keys.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

import numpy as np

from procc_annotator.camera.base import FloatArray
from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.matrices import (
    calibration_matrix,
    distortion_vector,
    fisheye_of,
    intrinsics_of,
    pinhole_of,
    pose_of,
    translation,
)
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.json_values import JsonValues

KIND = "a K, R, t camera"
MODELS = ("pinhole", "fisheye")
_SAME_PLACE = 1e-3  # metres, and of the distance: files round


@dataclass(frozen=True)
class KrtKeys:
    """How a format spells the parts of a camera; the first spelling that is there counts."""

    k: tuple[str, ...] = ("K", "camera_matrix")
    r: tuple[str, ...] = ("R", "rotation_matrix", "rvec")
    t: tuple[str, ...] = ("t", "T", "tvec")
    position: tuple[str, ...] = ("position", "C")
    distortion: tuple[str, ...] = ("dist", "distortion", "distortion_coefficients", "D", "kc")
    model: tuple[str, ...] = ("model",)


_KEYS = KrtKeys()


def is_krt(content: object) -> bool:
    """Whether a decoded value has the keys of such a camera."""
    return (
        type(content) is dict
        and any(key in content for key in _KEYS.k)
        and any(key in content for key in _KEYS.r)
    )


def krt_from(content: object, path: str, inside: str = "") -> LoadedCamera:
    """Read a camera from a decoded object.

    Raises:
        CameraError: names the place and what was expected.
    """
    return camera_of_matrices(JsonValues.of(content, path, inside, KIND), _KEYS)


def camera_of_matrices(
    values: JsonValues, keys: KrtKeys, size: tuple[int, int] | None = None
) -> LoadedCamera:
    """A camera from the parts a format has, in this project's world frame and metres.

    Args:
        values: the file's numbers.
        keys: how they are called there.
        size: (width, height) px of the picture; by default what the file says.

    Raises:
        CameraError: a part is missing, or is not what it should be.
    """
    size = size or values.size()
    key = values.need("3 x 3 numbers", *keys.k)
    try:
        inside = intrinsics_of(values.matrix(key, 3, 3), size)
    except ValueError as problem:
        raise values.error(str(problem), key) from problem
    rotation_key = values.need("3 x 3 numbers", *keys.r)
    rotation = _rotation(values, rotation_key)
    t_key, t = _translation(values, keys, rotation)
    try:
        pose = pose_of(rotation, t)
    except ValueError as problem:
        place = t_key if str(problem).startswith("t ") else rotation_key
        raise values.error(str(problem), place) from problem
    model = _model(values, keys)
    distortion_key = values.first_of(*keys.distortion)
    distortion = values.numbers(distortion_key) if distortion_key else ()
    make = fisheye_of if model == "fisheye" else pinhole_of
    try:
        camera = make(inside, pose, distortion)
    except ValueError as problem:
        raise values.error(str(problem), distortion_key or "") from problem
    return LoadedCamera(camera, model, size, notices=(*inside.notices, *pose.notices))


def _rotation(values: JsonValues, key: str) -> FloatArray:
    flat = values.numbers(key)
    if len(flat) == 3:
        vector = np.array(flat)
        if np.abs(vector).max() > 1e3:  # no turn about an axis; its sine would be noise
            raise values.error("expected a rotation vector in radians", key)
        import cv2  # most sets have none of these files

        return np.asarray(cv2.Rodrigues(vector)[0], dtype=np.float64)
    return values.matrix(key, 3, 3)


def _translation(values: JsonValues, keys: KrtKeys, rotation: FloatArray) -> tuple[str, FloatArray]:
    key = values.first_of(*keys.t)
    if key is None:
        key = values.need("3 numbers", *keys.t, *keys.position)
    vector = _three(values, key)
    other = values.first_of(*keys.position)
    with np.errstate(over="ignore", invalid="ignore"):
        if key in keys.position:
            return key, np.asarray(-rotation @ vector)
        if other is not None:
            apart = np.abs(-rotation @ _three(values, other) - vector).max()
            if not apart <= _SAME_PLACE * (1 + np.abs(vector).max()):
                raise values.error(f"says another place than {key}, expected the same", other)
    return key, vector


def _three(values: JsonValues, key: str) -> FloatArray:
    flat = values.numbers(key)
    if len(flat) != 3:
        raise values.error(f"expected 3 numbers, found {len(flat)}", key)
    return np.array(flat)


def _model(values: JsonValues, keys: KrtKeys) -> str:
    key = values.first_of(*keys.model)
    model = values.content[key] if key else MODELS[0]
    if model not in MODELS:
        raise values.error(f"expected {' or '.join(map(repr, MODELS))}", key or "")
    return str(model)


def krt_content(
    camera: PinholeCamera | FisheyeCamera, size: tuple[int, int] | None
) -> dict[str, Any]:
    """A camera as the object of this format.

    Args:
        camera: in pixels of ``size``.
        size: (width, height) px; None where nobody knows.

    Raises:
        ValueError: a parameter is not finite or a focal length zero; no reader would take the file.
    """
    distortion = (
        camera.coefficients if isinstance(camera, FisheyeCamera) else distortion_vector(camera)
    )
    content: dict[str, Any] = {"model": MODELS[isinstance(camera, FisheyeCamera)]}
    if size is not None:
        content |= {"width": size[0], "height": size[1]}
    content |= {
        "K": calibration_matrix(camera).tolist(),
        "R": camera.rotation_cam_from_world.tolist(),
        "t": translation(camera).tolist(),
        "dist": list(distortion),
    }
    matrices = [*map(np.array, (content[key] for key in ("K", "R", "t", "dist")))]
    if not all(np.isfinite(m).all() for m in matrices) or 0 in camera.focal_px:
        raise ValueError("not a camera: a parameter is without bounds, or a focal length is 0")
    return content


def write_krt(camera: PinholeCamera | FisheyeCamera, size: tuple[int, int] | None) -> bytes:
    """A camera as a file of this format; see `krt_content`."""
    lines = [f'  "{key}": {json.dumps(value)}' for key, value in krt_content(camera, size).items()]
    return ("{\n" + ",\n".join(lines) + "\n}\n").encode()
