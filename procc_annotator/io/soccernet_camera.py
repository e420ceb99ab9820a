"""SoccerNet camera files: pan, tilt, roll in degrees, position in metres, OpenCV's distortion."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.io.json_text import decode_fast, decode_strict, is_finite_number
from procc_annotator.io.loaded_camera import LoadedCamera

_ANGLES = ("pan_degrees", "tilt_degrees", "roll_degrees")
_VECTORS = {
    "position_meters": 3,
    "principal_point": 2,
    "radial_distortion": 6,
    "tangential_distortion": 2,
    "thin_prism_distortion": 4,
}
_FOCALS = ("x_focal_length", "y_focal_length")
_DISTORTIONS = ("radial_distortion", "tangential_distortion", "thin_prism_distortion")
_KEYS = frozenset((*_ANGLES, *_FOCALS, *_VECTORS))
_SIZE_KEYS = (("image_width", "image_height"), ("width", "height"))


def read_camera(data: bytes, *, path: str) -> LoadedCamera:
    """Read a SoccerNet camera.

    Absent distortion lists are zeros, as is a null one; lists of the wrong length are an error.
    ``image_width`` and ``image_height`` (or ``width``, ``height``), where present, tell the picture
    size the pixels belong to. Other keys are kept in ``extra``.

    Raises:
        CameraError: names the place (``radial_distortion[2]``) and what was expected.
    """
    content = decode_fast(data, path=path, error=CameraError)
    if type(content) is not dict:
        raise CameraError(path, "expected a JSON object with the keys of a SoccerNet camera")
    if data.count(b'"pan_degrees"') > 1:
        content = decode_strict(data, path=path, error=CameraError)
    pan, tilt, roll = (math.radians(_number(content, key, path)) for key in _ANGLES)
    fx, fy = (_focal(content, key, path) for key in _FOCALS)
    position = _vector(content, "position_meters", path)
    principal_point = _vector(content, "principal_point", path)
    radial, tangential, thin_prism = (
        _vector(content, key, path) if content.get(key) is not None else None
        for key in _DISTORTIONS
    )
    camera = PinholeCamera(
        pan,
        tilt,
        roll,
        position,
        (fx, fy),
        principal_point,
        radial or (0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        tangential or (0.0, 0.0),
        thin_prism or (0.0, 0.0, 0.0, 0.0),
    )
    extra = {k: v for k, v in content.items() if k not in _KEYS}
    return LoadedCamera(camera, "pinhole", _size(extra, path) if extra else None, extra)


def write_camera(camera: PinholeCamera, extra: Mapping[str, Any] | None = None) -> bytes:
    """A camera as file content, all keys of the format present, ``extra`` behind them.

    Angles are converted back to degrees, which may differ from the file's text in the last digit.
    """
    content: dict[str, Any] = {
        "pan_degrees": math.degrees(camera.pan_rad),
        "tilt_degrees": math.degrees(camera.tilt_rad),
        "roll_degrees": math.degrees(camera.roll_rad),
        "position_meters": list(camera.position_world),
        "x_focal_length": camera.focal_px[0],
        "y_focal_length": camera.focal_px[1],
        "principal_point": list(camera.principal_point_px),
        "radial_distortion": list(camera.radial),
        "tangential_distortion": list(camera.tangential),
        "thin_prism_distortion": list(camera.thin_prism),
    }
    content |= {k: v for k, v in (extra or {}).items() if k not in content}
    return (json.dumps(content, indent=2, allow_nan=False) + "\n").encode()


def _number(content: dict[str, Any], key: str, path: str) -> float:
    if key not in content:
        raise CameraError(path, f"the key {key!r} is missing", advice="is this a SoccerNet camera?")
    value = content[key]
    if not is_finite_number(value):
        raise CameraError(path, f"expected a finite number, found {_shown(value)}", place=key)
    return float(value)


def _focal(content: dict[str, Any], key: str, path: str) -> float:
    value = _number(content, key, path)
    if value == 0:
        raise CameraError(path, "expected a focal length in pixels, found 0", place=key)
    return value


def _vector(content: dict[str, Any], key: str, path: str) -> Any:
    length = _VECTORS[key]
    if key not in content:
        raise CameraError(path, f"the key {key!r} is missing", advice="is this a SoccerNet camera?")
    value = content[key]
    if type(value) is not list or len(value) != length:
        found = f"{len(value)} values" if type(value) is list else _shown(value)
        raise CameraError(path, f"expected {length} numbers, found {found}", place=key)
    for i, number in enumerate(value):
        if not is_finite_number(number):
            raise CameraError(
                path, f"expected a finite number, found {_shown(number)}", place=f"{key}[{i}]"
            )
    return tuple([float(number) for number in value])


def _size(extra: Mapping[str, Any], path: str) -> tuple[int, int] | None:
    for keys in _SIZE_KEYS:
        if all(key in extra for key in keys):
            width, height = (extra[key] for key in keys)
            if type(width) is int and type(height) is int and min(width, height) >= 2:
                return width, height
            raise CameraError(
                path,
                f"expected whole pixels, found {_shown(width)} x {_shown(height)}",
                place=" and ".join(keys),
            )
    return None


def _shown(value: object) -> str:
    text = json.dumps(value, default=repr)
    return text if len(text) <= 40 else f"{text[:37]}..."
