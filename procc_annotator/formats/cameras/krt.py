"""Cameras as K, R, t (or a pose matrix) and distortion, and as 3 x 4 projection matrices."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.matrices import (
    SKEW_TOLERANCE_PX,
    calibration_matrix,
    decompose_projection,
    distortion_vector,
    fisheye_from_parts,
    intrinsics_from_matrix,
    pinhole_from_parts,
    pose_from_rt,
    skew_px,
    translation,
)
from procc_annotator.camera.models import FisheyeCamera, MatrixCamera, PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera, with_notices

MODELS = ("pinhole", "fisheye")
# Of 1 and of the largest number: files round. A lens may differ by 0.03 px.
_SAME_POSE, _SAME_LENS = 1e-3, 1e-5


@dataclass(frozen=True)
class KrtKeys:
    """The keys, units and axes of a format of K, R, t; several spellings of a part must agree.

    Attributes:
        k, r, t, position, distortion, model: spellings of each part.
        pose: of a matrix [R | t], 3 x 4 or 4 x 4, world -> camera.
        inverse_pose: the same, camera -> world; a camera's axes are x right, y down, z forward.
        fisheye: flags in place of a model.
        repeated: keys that repeat what the others say; not read.
        size: of [width, height] of the picture, px.
        unit_m: metres of the format's unit of length.
        axes: (3, 3) our world's axes -> the format's; None where they are the same.
        up_or_down: whether its files have z up or down: up if the camera stands at z > 0, for none
            stands below the ground.
        origin: our world's origin in the format's world, in its unit.
        kind: what the object is, in messages.
        remark: what a person should know of every camera of the format.
    """

    k: tuple[str, ...] = (
        "K", "camera_matrix", "cameraMatrix", "Camera_Matrix", "intrinsics", "intrinsic",
        "intrinsic_matrix", "intrinsics_matrix", "cam_K", "mtx",
    )  # fmt: skip
    r: tuple[str, ...] = ("R", "rotation_matrix", "rvec", "rotation_vector", "rotation")
    t: tuple[str, ...] = ("t", "T", "tvec", "translation_vector", "translation")
    position: tuple[str, ...] = ("position", "C")
    pose: tuple[str, ...] = (
        "extrinsic", "extrinsics", "extrinsic_matrix", "extrinsics_matrix", "w2c", "cam_w2c",
        "world_to_camera", "world2cam", "Rt", "RT",
    )  # fmt: skip
    inverse_pose: tuple[str, ...] = (
        "c2w", "cam_c2w", "camera_to_world", "cam2world",
    )  # fmt: skip
    distortion: tuple[str, ...] = (
        "dist", "distortion", "distortion_coefficients", "distortionCoefficients",
        "Distortion_Coefficients", "dist_coeffs", "distCoeffs", "distCoef", "D", "kc", "k",
    )  # fmt: skip
    model: tuple[str, ...] = ("model", "camera_model")
    fisheye: tuple[str, ...] = ("fisheye", "fisheye_model")
    repeated: tuple[str, ...] = ()
    size: tuple[str, ...] = ()
    unit_m: float = 1.0
    axes: FloatArray | None = None
    up_or_down: bool = False
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)
    kind: str = "a K, R, t camera"
    remark: str = ""

    @property
    def used(self) -> tuple[str, ...]:
        """All spellings."""
        parts = (
            self.k, self.distortion, self.model, self.fisheye, self.size, self.repeated, self.placed
        )  # fmt: skip
        return tuple(key for part in parts for key in part)

    @property
    def placed(self) -> tuple[str, ...]:
        """All spellings of what says where a camera stands and looks."""
        return (*self.r, *self.t, *self.position, *self.pose, *self.inverse_pose)

    def are_in(self, content: object) -> bool:
        """Return whether a decoded value has the keys of such a camera."""
        content = flat_entry(content)
        return (
            type(content) is dict
            and any(key in content for key in self.k)
            and any(key in content for key in (*self.r, *self.pose, *self.inverse_pose))
        )


KRT_KEYS = KrtKeys()
# Our world's axes in those of a world with z up, and the other way round: half a turn about x.
HALF_TURN = np.diag([1.0, -1.0, -1.0])
TURNED = "its world has z up: turned by half about x"
_OF_K = ("fx", "fy", "cx", "cy")
_APART = ("intrinsics", "intrinsic", "extrinsics", "extrinsic")


def krt_from(
    content: object, path: str, inside: str = "", keys: KrtKeys = KRT_KEYS
) -> LoadedCamera:
    """Read a camera from a decoded object. `CameraError` names the place and what was expected."""
    entry = _with_distortion(flat_entry(content), keys)
    return camera_of_matrices(JsonValues.of(entry, path, inside, keys.kind), keys)


_RADIAL, _TANGENTIAL = ("k1", "k2", "k3", "k4", "k5", "k6"), ("p1", "p2")
_LISTED = {
    "radial_distortion": _RADIAL, "radial": _RADIAL, "k1k2": _RADIAL,
    "tangential_distortion": _TANGENTIAL, "tangential": _TANGENTIAL,
}  # fmt: skip


def _with_distortion(entry: Any, keys: KrtKeys) -> Any:
    """The entry with one list of the coefficients that it names one by one, or by their kind."""
    if type(entry) is not dict or any(key in entry for key in keys.distortion):
        return entry
    terms = {key: entry[key] for key in (*_RADIAL, *_TANGENTIAL) if key in entry}
    for key, names in _LISTED.items():
        if type(values := entry.get(key)) is list and len(values) <= len(names):
            terms |= zip(names, values, strict=False)
    if "k1" not in terms:
        return entry
    fisheye = MODELS[1] in (entry.get(key) for key in keys.model)
    fisheye = fisheye or any(entry.get(key) for key in keys.fisheye)
    order = _RADIAL[:4] if fisheye else ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")
    own = {key: value for key, value in entry.items() if key not in (*terms, *_LISTED)}
    return {**own, keys.distortion[0]: [terms.get(name, 0.0) for name in order]}


def flat_entry(entry: Any) -> Any:
    """A decoded camera without the objects that keep its intrinsics and its pose apart, and with K
    of numbers that are named one by one."""
    if type(entry) is not dict:
        return entry
    if apart := [key for key in _APART if type(entry.get(key)) is dict]:
        inner = {name: v for key in apart for name, v in entry[key].items()}
        entry = {key: value for key, value in entry.items() if key not in apart} | inner
    if not entry.keys() >= {*_OF_K} or any(key in entry for key in KRT_KEYS.k):
        return entry
    fx, fy, cx, cy = (entry[key] for key in _OF_K)
    own = {key: value for key, value in entry.items() if key not in _OF_K}
    return own | {KRT_KEYS.k[0]: [[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]]}


def camera_of_matrices(
    values: JsonValues, keys: KrtKeys, size: tuple[int, int] | None = None
) -> LoadedCamera:
    """A camera from the parts a format has, in this project's world frame and metres. `CameraError`
    if a part is missing, or is not what it should be."""
    size = size or _size(values, keys)
    key, k = _agreeing(values, "3 x 3 numbers", keys.k, lambda key: values.matrix(key, 3, 3))
    try:
        inside = intrinsics_from_matrix(k, size)
    except ValueError as problem:
        raise values.error(str(problem), key) from problem
    rotation_key, rotation = _agreeing(
        values, "3 x 3 numbers", (*keys.r, *keys.pose, *keys.inverse_pose),
        lambda key: _rotation(values, key, keys), _SAME_POSE,
    )  # fmt: skip
    t_key, t = _agreeing(
        values, "3 numbers", (*keys.t, *keys.position, *keys.pose, *keys.inverse_pose),
        lambda key: _translation(values, key, rotation, keys),
        _SAME_POSE,
    )  # fmt: skip
    axes, remarks = keys.axes, ((keys.remark,) if keys.remark else ())
    if keys.up_or_down and -(rotation.T @ t)[2] > 0:
        axes, remarks = HALF_TURN, (*remarks, TURNED)
    rotation = rotation if axes is None else rotation @ axes
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
        if len(distortion) == 2:  # k1 and k2
            distortion = np.pad(distortion, (0, 2))
    make = fisheye_from_parts if model == "fisheye" else pinhole_from_parts
    try:
        camera = make(inside, pose, distortion.tolist())
    except ValueError as problem:
        raise values.error(str(problem), lens_key) from problem
    notices = (*inside.notices, *pose.notices, *remarks, *values.unused(*keys.used))
    return LoadedCamera(camera, model, size, notices=notices)


def _size(values: JsonValues, keys: KrtKeys) -> tuple[int, int] | None:
    key = values.first_of(*keys.size)
    if key is None:
        return values.size()
    width, height = values.vector(key, 2)
    return JsonValues({"width": width, "height": height}, values.path, values.inside).size()


def centred_k(fx: float, fy: float, cx: float, cy: float) -> list[list[float]]:
    """K of a format that counts pixels from the corner of the picture, not from the centre of its
    first pixel."""
    return [[fx, 0.0, cx - 0.5], [0.0, fy, cy - 0.5], [0.0, 0.0, 1.0]]


def _agreeing(
    values: JsonValues,
    expected: str,
    keys: Iterable[str],
    read: Callable[[str], FloatArray],
    same: float = _SAME_LENS,
) -> tuple[str, FloatArray]:
    """Return the first spelling that is there and what it holds; CameraError if none is there, or
    two say something else."""
    first, *others = [key for key in keys if key in values] or [values.need(expected, *keys)]
    found = read(first)
    for other in others:
        # A distortion may go on with zeros in one of them.
        a, b = (np.pad(v.ravel(), (0, max(14 - v.size, 0))) for v in (found, read(other)))
        if a.shape != b.shape or not np.abs(a - b).max() <= same * (1 + np.abs(a).max()):
            raise values.error(f"says something else than {first}, expected the same", other)
    return first, found


def _pose_matrix(values: JsonValues, key: str, keys: KrtKeys) -> FloatArray:
    """(3, 4) [R | t], world -> camera, in the format's unit."""
    rows = 4 if len(values.numbers(key)) == 16 else 3
    matrix = values.matrix(key, rows, 4)
    if rows == 4 and not np.allclose(matrix[3], (0, 0, 0, 1), atol=1e-6):
        raise values.error("expected 0 0 0 1 as the last row of a pose", key)
    if key in keys.inverse_pose:
        turned = matrix[:3, :3].T
        return np.column_stack((turned, -turned @ matrix[:3, 3]))
    return matrix[:3]


def _rotation(values: JsonValues, key: str, keys: KrtKeys) -> FloatArray:
    if key in (*keys.pose, *keys.inverse_pose):
        return _pose_matrix(values, key, keys)[:, :3]
    flat = values.numbers(key)
    if len(flat) == 3:
        vector = np.array(flat)
        if np.abs(vector).max() > 1e3:  # no turn about an axis; its sine would be noise
            raise values.error("expected a rotation vector in radians", key)
        import cv2  # most sets have none of these files

        return np.asarray(cv2.Rodrigues(vector)[0], dtype=np.float64)
    return values.matrix(key, 3, 3)


def _translation(values: JsonValues, key: str, rotation: FloatArray, keys: KrtKeys) -> FloatArray:
    """t in metres from our world's origin."""
    is_matrix = key in (*keys.pose, *keys.inverse_pose)
    flat = _pose_matrix(values, key, keys)[:, 3] if is_matrix else values.numbers(key)
    if len(flat) != 3:
        raise values.error(f"expected 3 numbers, found {len(flat)}", key)
    origin = np.array(keys.origin)
    with np.errstate(over="ignore", invalid="ignore"):
        if key in keys.position:
            return np.asarray(keys.unit_m * (-rotation @ (np.array(flat) - origin)))
        return np.asarray(keys.unit_m * (np.array(flat) + rotation @ origin))


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
        size: (width, height) px; None if unknown.

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


PROJECTION_KIND = "a projection matrix"
PROJECTION_KEYS = ("P", "projection_matrix", "projection", "proj", "camera_projection_matrix")


def is_projection(content: object) -> bool:
    """Return whether a decoded value is such a matrix, or an object with one and no K next to
    it."""
    if type(content) is dict:
        found = [content[key] for key in PROJECTION_KEYS if key in content]
        return "K" not in content and any(
            _is_3x4(value) or _are_numbers(value, 12) for value in found
        )
    return _is_3x4(content)


def projection_from(content: object, path: str, inside: str = "") -> LoadedCamera:
    """Read a camera from a decoded matrix, or from an object with one. `CameraError` names the
    place and what was expected."""
    values = JsonValues.of(
        {"P": content} if type(content) is list else content, path, inside, PROJECTION_KIND
    )
    key = values.need("3 x 4 numbers", *PROJECTION_KEYS)
    size = values.size()
    loaded = camera_of_projection(values.matrix(key, 3, 4), size, values.error)
    return with_notices(loaded, values.unused(key))


def camera_of_projection(
    matrix: FloatArray, size: tuple[int, int] | None, error: Any
) -> LoadedCamera:
    """The camera of a matrix.

    Args:
        matrix: (3, 4), metres of this project's world -> px.
        size: (width, height) px where it is known.

    Returns:
        One of `MatrixCamera` where the matrix has a skew, which no lens model has.

    Raises:
        CameraError: no camera.
    """
    try:
        k, rotation, t = decompose_projection(matrix)
        if skew_px(k, size) > SKEW_TOLERANCE_PX:
            return LoadedCamera(MatrixCamera.of(matrix), MatrixCamera.model, size)
        inside, pose = intrinsics_from_matrix(k, size), pose_from_rt(rotation, t)
        camera = pinhole_from_parts(inside, pose, ())
    except ValueError as problem:
        raised: CameraError = error(str(problem))
        raise raised from problem
    return LoadedCamera(camera, "pinhole", size, notices=(*inside.notices, *pose.notices))


def _are_numbers(content: object, count: int) -> bool:
    return (
        type(content) is list
        and len(content) == count
        and not any(type(number) in (list, dict, str) for number in content)
    )


def _is_3x4(content: object) -> bool:
    return type(content) is list and len(content) == 3 and all(_are_numbers(r, 4) for r in content)
