"""SoccerNet camera files: pan, tilt, roll in degrees, position in metres, OpenCV's distortion."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any

from procc_annotator.camera.matrices import focal_warnings
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.json_text import decode_fast, is_finite_number
from procc_annotator.io.json_values import JsonValues, degrees

_ANGLES = ("pan_degrees", "tilt_degrees", "roll_degrees")
_FOCALS = ("x_focal_length", "y_focal_length")
_DISTORTIONS = {"radial_distortion": 6, "tangential_distortion": 2, "thin_prism_distortion": 4}
_KEYS = frozenset((*_ANGLES, *_FOCALS, "position_meters", "principal_point", *_DISTORTIONS))
# What PnLCalib and NBJW write again, and what this program says of a fit.
_BESIDE = ("rotation_matrix", "fit")
SOCCERNET_KIND = "a SoccerNet camera"


def read_camera(data: bytes, *, path: str) -> LoadedCamera:
    """Read a SoccerNet camera.

    Absent distortion lists are zeros; lists of the wrong length are an error. ``image_width`` and
    ``image_height`` (or ``width``, ``height``), where present, tell the picture size the pixels
    belong to. Other keys are kept in ``extra``.

    Raises:
        CameraError: names the place (``radial_distortion[2]``) and what was expected.
    """
    return camera_from(decode_fast(data, path=path, error=CameraError), path=path)


def camera_from(
    content: object, *, path: str, inside: str = "", nested: bool = False
) -> LoadedCamera:
    """As `read_camera`, from what was decoded.

    Args:
        inside: where in the file it stands.
        nested: whether values may stand in lists of one.
    """
    values = JsonValues.of(content, path, inside, SOCCERNET_KIND, nested)
    pan, tilt, roll = degrees(values, _ANGLES)
    fx, fy = [values.focal(key) for key in _FOCALS]
    position = values.vector("position_meters", 3)
    principal_point = values.vector("principal_point", 2)
    distortions: list[Any] = [
        values.vector(key, length, "leave the key out for no distortion")
        if key in values
        else (0.0,) * length
        for key, length in _DISTORTIONS.items()
    ]
    camera = PinholeCamera(
        pan, tilt, roll, _three(position), (fx, fy), _two(principal_point), *distortions
    )
    extra = {k: v for k, v in values.content.items() if k not in _KEYS}
    size = values.size() if extra else None
    notices = (*focal_warnings(fx, fy), *values.unused(*_KEYS, *_BESIDE))
    return LoadedCamera(camera, "pinhole", size, extra, notices, values.content)


def is_soccernet(content: Mapping[str, Any]) -> bool:
    """Whether an object has keys that only such a camera has."""
    return not _KEYS.isdisjoint(content)


def write_camera(camera: PinholeCamera, extra: Mapping[str, Any] | None = None) -> bytes:
    """A camera as file content, with all keys of the format.

    Args:
        camera: in pixels of the size the file is for.
        extra: further keys; a `LoadedCamera`'s ``extra``, or its ``content``: then the file keeps
            its order and all numbers that the camera did not change, digit by digit.

    Raises:
        ValueError: a parameter is not finite or a focal length zero; no reader would take the file.
    """
    content = dict(extra or {})
    angles_rad = dict(zip(_ANGLES, (camera.pan_rad, camera.tilt_rad, camera.roll_rad), strict=True))
    for key, value in _parameters(camera, angles_rad).items():
        own = content.get(key)
        if key in angles_rad:
            unchanged = is_finite_number(own) and math.radians(own) == angles_rad[key]
        else:
            unchanged = _as_floats(own) == value
        if not unchanged:
            content[key] = value
    return (json.dumps(content, indent=2, ensure_ascii=False) + "\n").encode()


def _parameters(
    camera: PinholeCamera, angles_rad: Mapping[str, float]
) -> dict[str, float | list[float]]:
    """The camera by the file's keys, angles in degrees."""
    x_focal, y_focal = camera.focal_px
    content: dict[str, float | list[float]] = {
        **{key: _degrees(angle) for key, angle in angles_rad.items()},
        "position_meters": list(camera.position_world),
        "x_focal_length": x_focal,
        "y_focal_length": y_focal,
        "principal_point": list(camera.principal_point_px),
        "radial_distortion": list(camera.radial),
        "tangential_distortion": list(camera.tangential),
        "thin_prism_distortion": list(camera.thin_prism),
    }
    for key, value in content.items():
        numbers = value if isinstance(value, list) else [value]
        if not all(map(math.isfinite, numbers)) or (key in _FOCALS and value == 0):
            raise ValueError(f"not a camera: {key} is {value}")
    return content


def _as_floats(value: object) -> object:
    """A file's numbers as they were read: whole ones may have more digits than a float holds."""
    if isinstance(value, list):
        return [_as_floats(number) for number in value]
    return float(value) if is_finite_number(value) else value


def _degrees(angle_rad: float) -> float:
    """The shortest number of degrees that reads back as exactly this angle, where there is one."""
    degrees = math.degrees(angle_rad)
    rounded = (float(f"{degrees:.{digits}g}") for digits in range(12, 17))
    neighbours = (degrees, math.nextafter(degrees, math.inf), math.nextafter(degrees, -math.inf))
    return next((d for d in (*rounded, *neighbours) if math.radians(d) == angle_rad), degrees)


def _three(values: tuple[float, ...]) -> tuple[float, float, float]:
    x, y, z = values
    return x, y, z


def _two(values: tuple[float, ...]) -> tuple[float, float]:
    x, y = values
    return x, y
