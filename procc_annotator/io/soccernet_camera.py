"""SoccerNet camera files: pan, tilt, roll in degrees, position in metres, OpenCV's distortion."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.io.json_text import decode_fast, is_finite_number, kind_of, shown
from procc_annotator.io.loaded_camera import LoadedCamera

_ANGLES = ("pan_degrees", "tilt_degrees", "roll_degrees")
_FOCALS = ("x_focal_length", "y_focal_length")
_DISTORTIONS = {"radial_distortion": 6, "tangential_distortion": 2, "thin_prism_distortion": 4}
_KEYS = frozenset((*_ANGLES, *_FOCALS, "position_meters", "principal_point", *_DISTORTIONS))
_WIDEST = 1_000_000
_SIZE_KEYS = (("image_width", "image_height"), ("width", "height"))


def read_camera(data: bytes, *, path: str) -> LoadedCamera:
    """Read a SoccerNet camera.

    Absent distortion lists are zeros; lists of the wrong length are an error. ``image_width`` and
    ``image_height`` (or ``width``, ``height``), where present, tell the picture size the pixels
    belong to. Other keys are kept in ``extra``.

    Raises:
        CameraError: names the place (``radial_distortion[2]``) and what was expected.
    """
    content = decode_fast(data, path=path, error=CameraError)
    if type(content) is not dict:
        raise CameraError(
            path,
            f"expected an object with the keys of a SoccerNet camera, found {kind_of(content)}",
            place="top level",
            advice="is this a camera?",
        )
    pan, tilt, roll = [math.radians(_number(content, key, path)) for key in _ANGLES]
    fx, fy = [_focal(content, key, path) for key in _FOCALS]
    position = _vector(content, "position_meters", 3, path)
    principal_point = _vector(content, "principal_point", 2, path)
    distortions: list[Any] = [
        _vector(content, key, length, path) if key in content else (0.0,) * length
        for key, length in _DISTORTIONS.items()
    ]
    camera = PinholeCamera(pan, tilt, roll, position, (fx, fy), principal_point, *distortions)
    extra = {k: v for k, v in content.items() if k not in _KEYS}
    size = _size(extra, path) if extra else None
    return LoadedCamera(camera, "pinhole", size, extra, content=content)


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


def _number(content: dict[str, Any], key: str, path: str) -> float:
    value = content.get(key)
    if not is_finite_number(value):
        if key not in content:
            raise _missing(key, "a number", path)
        raise CameraError(
            path,
            f"expected a finite number, found {shown(value)}",
            place=key,
            advice="correct the file",
        )
    return float(value)


def _focal(content: dict[str, Any], key: str, path: str) -> float:
    value = _number(content, key, path)
    if value == 0:
        raise CameraError(
            path, "expected a focal length in pixels, found 0", place=key, advice="correct the file"
        )
    return value


def _vector(content: dict[str, Any], key: str, length: int, path: str) -> Any:
    if key not in content:
        raise _missing(key, f"{length} numbers", path)
    value = content[key]
    if type(value) is not list or len(value) != length:
        found = f"{len(value)} values" if type(value) is list else shown(value)
        advice = (
            "leave the key out for no distortion" if key in _DISTORTIONS else "correct the file"
        )
        raise CameraError(
            path, f"expected {length} numbers, found {found}", place=key, advice=advice
        )
    for i, number in enumerate(value):
        if not is_finite_number(number):
            raise CameraError(
                path,
                f"expected a finite number, found {shown(number)}",
                place=f"{key}[{i}]",
                advice="correct the file",
            )
    return tuple([float(number) for number in value])


def _missing(key: str, expected: str, path: str) -> CameraError:
    return CameraError(
        path,
        f"the key {key!r} is missing, expected {expected}",
        advice="is this a SoccerNet camera?",
    )


def _size(extra: Mapping[str, Any], path: str) -> tuple[int, int] | None:
    for keys in _SIZE_KEYS:
        if all(key in extra for key in keys):
            width, height = (extra[key] for key in keys)
            # A larger picture does not exist; scaling by it would leave a camera of nothing.
            if all(
                is_finite_number(n) and n == int(n) and 2 <= n <= _WIDEST for n in (width, height)
            ):
                return int(width), int(height)
            raise CameraError(
                path,
                f"expected whole pixels, found {shown(width)} x {shown(height)}",
                place=" and ".join(keys),
                advice="correct the file",
            )
    return None
