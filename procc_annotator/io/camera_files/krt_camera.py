"""Cameras as K, R, t and distortion: the plain JSON of this project, and what others share with it.

See docs/camera-formats.md for the keys.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from procc_annotator.camera.base import FloatArray
from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.matrices import (
    calibration_matrix,
    distortion_vector,
    fisheye_from_parts,
    intrinsics_from_matrix,
    pinhole_from_parts,
    pose_from_rt,
    translation,
)
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.json_values import JsonValues

KRT_KIND = "a K, R, t camera"
MODELS = ("pinhole", "fisheye")
# Of 1 and of the largest number: files round. A lens may differ by 0.03 px.
_SAME_POSE, _SAME_LENS = 1e-3, 1e-5


@dataclass(frozen=True)
class KrtKeys:
    """How a format spells the parts of a camera; several spellings of a part must agree."""

    k: tuple[str, ...] = ("K", "camera_matrix", "cameraMatrix", "Camera_Matrix", "intrinsics")
    r: tuple[str, ...] = ("R", "rotation_matrix", "rvec", "rotation_vector", "rotation")
    t: tuple[str, ...] = ("t", "T", "tvec", "translation_vector", "translation")
    position: tuple[str, ...] = ("position", "C")
    distortion: tuple[str, ...] = (
        "dist", "distortion", "distortion_coefficients", "distortionCoefficients",
        "Distortion_Coefficients", "dist_coeffs", "distCoeffs", "distCoef", "D", "kc", "k",
    )  # fmt: skip
    model: tuple[str, ...] = ("model", "camera_model")
    fisheye: tuple[str, ...] = ("fisheye", "fisheye_model")  # flags in place of a model
    # Keys that repeat what the others say; not read.
    repeated: tuple[str, ...] = ()

    @property
    def used(self) -> tuple[str, ...]:
        """All spellings."""
        return tuple(key for part in vars(self).values() for key in part)


KRT_KEYS = KrtKeys()


def is_krt(content: object) -> bool:
    """Whether a decoded value has the keys of such a camera."""
    return (
        type(content) is dict
        and any(key in content for key in KRT_KEYS.k)
        and any(key in content for key in KRT_KEYS.r)
    )


def krt_from(content: object, path: str, inside: str = "") -> LoadedCamera:
    """Read a camera from a decoded object.

    Raises:
        CameraError: names the place and what was expected.
    """
    return camera_of_matrices(JsonValues.of(content, path, inside, KRT_KIND), KRT_KEYS)


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
    key, k = _agreeing(values, "3 x 3 numbers", keys.k, lambda key: values.matrix(key, 3, 3))
    try:
        inside = intrinsics_from_matrix(k, size)
    except ValueError as problem:
        raise values.error(str(problem), key) from problem
    rotation_key, rotation = _agreeing(
        values, "3 x 3 numbers", keys.r, lambda key: _rotation(values, key), _SAME_POSE
    )
    t_key, t = _agreeing(
        values, "3 numbers", (*keys.t, *keys.position),
        lambda key: _translation(values, key, rotation if key in keys.position else None),
        _SAME_POSE,
    )  # fmt: skip
    try:
        pose = pose_from_rt(rotation, t)
    except ValueError as problem:
        place = t_key if str(problem).startswith("t ") else rotation_key
        raise values.error(str(problem), place) from problem
    model = _model(values, keys)
    lens_key, distortion = "", np.empty(0)
    if values.first_of(*keys.distortion):
        lens_key, distortion = _agreeing(
            values, "", keys.distortion, lambda key: np.array(values.numbers(key))
        )
    make = fisheye_from_parts if model == "fisheye" else pinhole_from_parts
    try:
        camera = make(inside, pose, distortion.tolist())
    except ValueError as problem:
        raise values.error(str(problem), lens_key) from problem
    notices = (*inside.notices, *pose.notices, *values.unused(*keys.used))
    return LoadedCamera(camera, model, size, notices=notices)


def _agreeing(
    values: JsonValues,
    expected: str,
    keys: Iterable[str],
    read: Callable[[str], FloatArray],
    same: float = _SAME_LENS,
) -> tuple[str, FloatArray]:
    """Return the first spelling that is there and what it holds.

    Raises:
        CameraError: none is there, or two say something else.
    """
    first, *others = [key for key in keys if key in values] or [values.need(expected, *keys)]
    found = read(first)
    for other in others:
        # A distortion may go on with zeros in one of them.
        a, b = (np.pad(v.ravel(), (0, max(14 - v.size, 0))) for v in (found, read(other)))
        if a.shape != b.shape or not np.abs(a - b).max() <= same * (1 + np.abs(a).max()):
            raise values.error(f"says something else than {first}, expected the same", other)
    return first, found


def _rotation(values: JsonValues, key: str) -> FloatArray:
    flat = values.numbers(key)
    if len(flat) == 3:
        vector = np.array(flat)
        if np.abs(vector).max() > 1e3:  # no turn about an axis; its sine would be noise
            raise values.error("expected a rotation vector in radians", key)
        import cv2  # most sets have none of these files

        return np.asarray(cv2.Rodrigues(vector)[0], dtype=np.float64)
    return values.matrix(key, 3, 3)


def _translation(values: JsonValues, key: str, rotation: FloatArray | None) -> FloatArray:
    """t, where a rotation is given from the position under the key."""
    vector = _three(values, key)
    with np.errstate(over="ignore", invalid="ignore"):
        return vector if rotation is None else np.asarray(-rotation @ vector)


def _three(values: JsonValues, key: str) -> FloatArray:
    flat = values.numbers(key)
    if len(flat) != 3:
        raise values.error(f"expected 3 numbers, found {len(flat)}", key)
    return np.array(flat)


def _model(values: JsonValues, keys: KrtKeys) -> str:
    named = {key: values.content[key] for key in keys.model if key in values}
    named |= {key: MODELS[1] for key in keys.fisheye if values.content.get(key)}
    for key, model in named.items():
        if model not in MODELS:
            raise values.error(f"expected {' or '.join(map(repr, MODELS))}", key)
    if len({*named.values()}) > 1:
        raise values.error("say different models", " and ".join(named))
    return str(next(iter(named.values()), MODELS[0]))


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
