"""Cameras as K, R, t and distortion: single, nested or stacked, and 3 x 4 projection matrices."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.matrices import (
    calibration_matrix,
    decompose_projection,
    distortion_vector,
    fisheye_from_parts,
    intrinsics_from_matrix,
    pinhole_from_parts,
    pose_from_rt,
    translation,
)
from procc_annotator.camera.models import FisheyeCamera, PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
    with_notices,
)

MODELS = ("pinhole", "fisheye")
# Of 1 and of the largest number: files round. A lens may differ by 0.03 px.
_SAME_POSE, _SAME_LENS = 1e-3, 1e-5


@dataclass(frozen=True)
class KrtKeys:
    """The keys, units and axes of a format of K, R, t; several spellings of a part must agree.

    Attributes:
        unit_m: metres of the format's unit of length.
        axes: (3, 3) our world's axes -> the format's; None where they are the same.
        origin: our world's origin in the format's world, in its unit.
        kind: what the object is, in messages.
    """

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
    repeated: tuple[str, ...] = ()  # keys that repeat what the others say; not read
    unit_m: float = 1.0
    axes: FloatArray | None = None
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)
    kind: str = "a K, R, t camera"

    @property
    def used(self) -> tuple[str, ...]:
        """All spellings."""
        parts = (self.k, self.r, self.t, self.position, self.distortion, self.model, self.fisheye)
        return (*(key for part in parts for key in part), *self.repeated)


KRT_KEYS = KrtKeys()


def is_krt(content: object) -> bool:
    """Return whether a decoded value has the keys of such a camera."""
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
    return camera_of_matrices(JsonValues.of(content, path, inside, KRT_KEYS.kind), KRT_KEYS)


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
        lambda key: _translation(values, key, rotation, keys),
        _SAME_POSE,
    )  # fmt: skip
    rotation = rotation if keys.axes is None else rotation @ keys.axes
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


def _translation(values: JsonValues, key: str, rotation: FloatArray, keys: KrtKeys) -> FloatArray:
    """t in metres from our world's origin."""
    flat = values.numbers(key)
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
        return "K" not in content and any(_is_3x4(value) or _are_twelve(value) for value in found)
    return _is_3x4(content)


def projection_from(content: object, path: str, inside: str = "") -> LoadedCamera:
    """Read a camera from a decoded matrix, or from an object with one.

    Raises:
        CameraError: names the place and what was expected.
    """
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
    """The pinhole camera of a matrix.

    Args:
        matrix: (3, 4), metres of this project's world -> px.
        size: (width, height) px where it is known.
        error: makes the error of a problem.

    Raises:
        CameraError: no camera, or one with a skew.
    """
    try:
        k, rotation, t = decompose_projection(matrix)
        inside, pose = intrinsics_from_matrix(k, size), pose_from_rt(rotation, t)
        camera = pinhole_from_parts(inside, pose, ())
    except ValueError as problem:
        raised: CameraError = error(str(problem))
        raise raised from problem
    return LoadedCamera(camera, "pinhole", size, notices=(*inside.notices, *pose.notices))


def _are_twelve(content: object) -> bool:
    return (
        type(content) is list
        and len(content) == 12
        and not any(type(number) in (list, dict, str) for number in content)
    )


def _is_3x4(content: object) -> bool:
    return (
        type(content) is list
        and len(content) == 3
        and all(type(row) is list and len(row) == 4 for row in content)
        and not any(type(number) in (list, dict, str) for row in content for number in row)
    )


NAME_KEYS = ("frames", "names", "image_names", "filenames", "images")
_OWN_NAME = ("name", "image_name", "frame", "file_name", "id")
_APART = ("intrinsics", "intrinsic", "extrinsics", "extrinsic")
_STACKED = (*KRT_KEYS.r, "rvecs", *KRT_KEYS.t, "tvecs", "P", *KRT_KEYS.position)
# What OpenCV's calibration tutorials call the same in their .npz files.
_OPENCV_NAMES = {"mtx": "K", "rvecs": "rvec", "tvecs": "tvec"}
_SHARED_LISTS = frozenset({*KRT_KEYS.k, "mtx", *KRT_KEYS.distortion})
_DOME = frozenset({"K", "R", "t", "distCoef", "resolution"})
_DOME_KEYS = KrtKeys(
    k=("K",), r=("R",), t=("t",), position=(), distortion=("distCoef",), model=(),
    repeated=("resolution",), unit_m=0.01, kind="a camera of the Panoptic Studio",
    # The dome's axes in ours: x stays, our y is against its z, our z (down) is its y.
    axes=np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]),
)  # fmt: skip
BY_ORDER = "the file names no frames: they are called 0, 1, 2 ... by the order in it"


def is_nested(content: object) -> bool:
    """Return whether a decoded value holds cameras under ``cameras``."""
    return type(content) is dict and any(is_krt(entry) for _, _, entry in _nested(content))


def is_stack(content: object) -> bool:
    """Return whether a decoded value is an object of stacked matrices, one a frame."""
    return type(content) is dict and _frames_of_stack(content) is not None


def nested_records(content: object, path: str) -> CameraRecords:
    """The cameras of a decoded file with ``cameras``.

    Raises:
        CameraError: it holds no camera.
    """
    found = [(name, CameraRecord(place, entry)) for name, place, entry in _nested(content)]
    if not found:
        raise CameraError(path, "holds no camera, expected K, R and t under 'cameras'")
    beside = JsonValues.of(content, path, kind=KRT_KEYS.kind).unused("cameras")
    return CameraRecords.of(path, found, _nested_from, beside)


def stack_records(content: object, path: str) -> CameraRecords:
    """One object of a frame's own matrices for each frame of a stack; read by what is in it.

    Raises:
        CameraError: stacks of different heights, or other names than frames.
    """
    assert type(content) is dict
    count = _frames_of_stack(content)
    assert count is not None
    key = next((k for k in NAME_KEYS if type(content.get(k)) is list), None)
    names = [str(name) for name in content[key]] if key else [str(i) for i in range(count)]
    if len(names) != count:
        raise CameraError(path, f"holds {len(names)} names for {count} cameras", place=str(key))
    stacked = {k for k, v in content.items() if _is_stacked(k, v, count)}
    entries = []
    for i, name in enumerate(names):
        own = {
            _OPENCV_NAMES.get(k, k): v[i] if k in stacked else v
            for k, v in content.items()
            if k not in NAME_KEYS
        }
        entries.append((name.strip(), CameraRecord(f"[{i}]", own)))
    return CameraRecords.of(path, entries, _own_from, () if key else (BY_ORDER,))


def _own_from(content: object, path: str, inside: str) -> LoadedCamera:
    read = projection_from if is_projection(content) else krt_from
    return read(content, path, inside)


def _nested(content: object) -> Iterator[tuple[str, str, Any]]:
    cameras = content.get("cameras") if type(content) is dict else None
    if type(cameras) is dict:
        for name, entry in cameras.items():
            yield name, f"cameras.{name}", _flatten_entry(entry)
    elif type(cameras) is list:
        for i, entry in enumerate(cameras):
            own = entry if type(entry) is dict else {}
            name = next((own[key] for key in _OWN_NAME if key in own), i)
            yield str(name), f"cameras[{i}]", _flatten_entry(entry)


def _flatten_entry(entry: Any) -> Any:
    """A camera without the objects that keep its intrinsics and its pose apart."""
    apart = [key for key in _APART if type(entry) is dict and type(entry.get(key)) is dict]
    if not apart:
        return entry
    own = {key: value for key, value in entry.items() if key not in apart}
    return own | {name: value for key in apart for name, value in entry[key].items()}


def _nested_from(content: object, path: str, inside: str) -> LoadedCamera:
    if type(content) is not dict or not content.keys() >= _DOME:
        return krt_from(content, path, inside)
    values = JsonValues(content, path, inside, _DOME_KEYS.kind)
    width, height = values.vector("resolution", 2)
    size = JsonValues({"width": width, "height": height}, path, inside).size()
    return camera_of_matrices(values, _DOME_KEYS, size)


def _frames_of_stack(content: dict[str, Any]) -> int | None:
    """Return how many frames an object of stacked matrices is of; None for one that is no stack."""
    counts = {
        len(value)
        for key, value in content.items()
        if key in _STACKED and type(value) is list and _is_stacked(key, value, len(value))
    }
    return counts.pop() if len(counts) == 1 else None


def _is_stacked(key: str, value: Any, count: int) -> bool:
    if key in NAME_KEYS or type(value) is not list or len(value) != count:
        return False
    depth, inner = _depth(value)
    if key in ("R", "rotation_matrix", "P"):
        return depth == 3
    if key in _SHARED_LISTS and key not in KRT_KEYS.distortion:
        return depth == 3
    if key in _STACKED:  # vectors: (N, 3) or (N, 3, 1), but not one column of three
        return depth == 3 or (depth == 2 and inner == 3 and count > 1)
    return depth == 2 and key in _SHARED_LISTS and inner >= 4 and count > 1


def _depth(value: Any) -> tuple[int, int]:
    """Return how deeply lists nest, and how long the innermost one is."""
    depth = length = 0
    while type(value) is list:
        depth, length = depth + 1, len(value)
        value = value[0] if value else None
    return depth, length
