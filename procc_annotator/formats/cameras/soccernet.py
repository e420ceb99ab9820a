"""Pan-tilt-roll cameras of SoccerNet, TVCalib and BroadTrack."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from procc_annotator.camera.matrices import focal_warnings
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.homography import camera_from_homography
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
    frame_of_image,
    with_notices,
)
from procc_annotator.formats.strict_json import (
    decode_fast,
    is_finite_number,
    json_kind,
    strip_bom,
)

_ANGLES = ("pan_degrees", "tilt_degrees", "roll_degrees")
_FOCALS = ("x_focal_length", "y_focal_length")
_DISTORTIONS = {"radial_distortion": 6, "tangential_distortion": 2, "thin_prism_distortion": 4}
_KEYS = frozenset((*_ANGLES, *_FOCALS, "position_meters", "principal_point", *_DISTORTIONS))
# What PnLCalib and NBJW write again, and what this program says of a fit.
_ROTATION = "rotation_matrix"
_BESIDE = (_ROTATION, "fit")
_SAME_ROTATION = 1e-3
SOCCERNET_KIND = "a SoccerNet camera"


def camera_from(content: object, path: str, inside: str = "", nested: bool = False) -> LoadedCamera:
    """Read a decoded SoccerNet camera.

    Absent distortion lists are zeros; lists of the wrong length are an error. ``image_width`` and
    ``image_height`` (or ``width``, ``height``), where present, give the picture size the pixels
    belong to. Other keys are kept in ``extra``. Nested: values may stand in lists of one.

    Raises:
        CameraError: names the place (``radial_distortion[2]``) and what was expected.
    """
    values = JsonValues.of(content, path, inside, SOCCERNET_KIND, nested)
    pan, tilt, roll = values.radians(*_ANGLES)
    fx, fy = [values.focal(key) for key in _FOCALS]
    x, y, z = values.vector("position_meters", 3)
    centre_x, centre_y = values.vector("principal_point", 2)
    distortions: list[Any] = [
        values.vector(key, length, "leave the key out for no distortion")
        if key in values
        else (0.0,) * length
        for key, length in _DISTORTIONS.items()
    ]
    camera = PinholeCamera(pan, tilt, roll, (x, y, z), (fx, fy), (centre_x, centre_y), *distortions)
    extra = {k: v for k, v in values.content.items() if k not in _KEYS}
    size = values.size() if extra else None
    notices = (*focal_warnings(fx, fy), *values.unused(*_KEYS, *_BESIDE))
    if _contradicts(values, camera):
        notices += (f"{_ROTATION} says something else than pan, tilt and roll, which count",)
    return LoadedCamera(camera, "pinhole", size, extra, notices, values.content)


def _contradicts(values: JsonValues, camera: PinholeCamera) -> bool:
    """Return whether a matrix that stands beside the angles says something else."""
    if _ROTATION not in values:
        return False
    try:
        matrix = values.matrix(_ROTATION, 3, 3)
    except CameraError:  # no matrix: it says nothing
        return False
    return bool(np.abs(matrix - camera.rotation_cam_from_world).max() > _SAME_ROTATION)


def is_soccernet(content: Mapping[str, Any]) -> bool:
    """Return whether an object has keys that only such a camera has."""
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


TVCALIB_KIND = "a TVCalib record"
_NAME_KEYS = ("image_ids", "image_id")
_ASSUMED = (960, 540)


def is_tvcalib(content: object) -> bool:
    """Return whether a decoded value is such a record."""
    return type(content) is dict and _NAME_KEYS[0] in content


def tvcalib_records(content: object, path: str) -> CameraRecords:
    """The records of a file: one a line, or all in one JSON list.

    A line that is no record belongs to no frame anyone knows; it is passed over.

    Raises:
        CameraError: no line is a record.
    """
    found: list[tuple[str, CameraRecord]] = []
    problems: list[CameraError] = []
    for place, part in _parts(content, path):
        try:
            record = _decoded(part, path, place) if isinstance(part, bytes) else part
            found.append((_picture(record, path, place), CameraRecord(place, record)))
        except CameraError as error:
            problems.append(error)
    if not found:
        if problems:
            raise problems[0]
        raise CameraError(path, "is empty, expected one JSON record a line")
    return CameraRecords.of(path, found, tvcalib_from, passed_over=problems)


def tvcalib_from(content: object, path: str, inside: str = "") -> LoadedCamera:
    """Read a decoded record: camera parameters, or else the homography picture -> world metres.
    `CameraError` names the place and what was expected."""
    values = JsonValues.of(content, path, inside, TVCALIB_KIND, nested=True)
    if is_soccernet(values.content):
        loaded = camera_from(content, path=path, inside=inside, nested=True)
        return replace(loaded, extra={}, content={})
    if "homography" not in values:
        raise values.missing("a homography or the keys of a SoccerNet camera", "homography")
    size = values.size()
    own = {"homography": values.bare(values.content["homography"])}
    matrix = JsonValues(own, path, inside).matrix("homography", 3, 3)
    loaded = camera_from_homography(matrix, np.eye(3), size or _ASSUMED, path=path, place=inside)
    if size is None:
        unsized = "names no picture size: taken for pixels of the evaluation size"
        loaded = with_notices(replace(loaded, size=None), (unsized,))
    return with_notices(replace(loaded, size_is_usual=False), values.unused("homography"))


def _parts(content: object, path: str) -> list[tuple[str, Any]]:
    """(place, record) of each; bytes of one that is not decoded yet."""
    if isinstance(content, bytes):
        content = strip_bom(content)
        if content.lstrip()[:1] != b"[":
            lines = enumerate(content.split(b"\n"), 1)
            return [(f"line {number}", line) for number, line in lines if line.strip()]
        content = decode_fast(content, path=path, error=CameraError)
    records = content if isinstance(content, list) else [content]
    return [(f"[{i}]", record) for i, record in enumerate(records)]


def _decoded(line: bytes, path: str, place: str) -> object:
    try:
        return decode_fast(line, path=path, error=CameraError)
    except CameraError as error:
        # The place within the line is of no use where a line has thousands of characters.
        raise CameraError(path, error.problem, place=place, advice=error.advice) from error


def _picture(content: object, path: str, place: str) -> str:
    values = JsonValues.of(content, path, place, TVCALIB_KIND, nested=True)
    name = values.bare(values.content[values.need("the name of a picture", *_NAME_KEYS)])
    if type(name) is not str or not frame_of_image(name):
        problem = f"expected the name of a picture, found {json_kind(name)}"
        raise values.error(problem, _NAME_KEYS[0])
    return name


BROADTRACK_KIND = "a BroadTrack camera"
_SIZE = ("sensorResolutionWidthPixels", "sensorResolutionHeightPixels")
_FIELD_OF_VIEW = "horizontalFieldOfViewDegrees"
_BROADTRACK_ANGLES = ("panDegrees", "tiltDegrees", "rollDegrees")
_POSITION = ("positionXMeters", "positionYMeters", "positionZMeters")
_RADIAL = "normalizedRadialDistortionCoefficients"


def broadtrack_records(content: object, path: str) -> CameraRecords:
    """The cameras of a decoded file.

    Raises:
        CameraError: not an object of objects.
    """
    values = JsonValues.of(content, path, kind="a BroadTrack file (picture name -> camera)")
    found = [(name, CameraRecord(name, entry)) for name, entry in values.content.items()]
    return CameraRecords.of(path, found, broadtrack_from, (), "picture names with cameras")


def broadtrack_from(content: object, path: str, inside: str = "") -> LoadedCamera:
    """Read a decoded entry, ``{"cp": camera, ...}``. `CameraError` names the place and what was
    expected."""
    entry = JsonValues.of(content, path, inside, BROADTRACK_KIND)
    entry.need("the camera", "cp")
    place = f"{inside}: cp" if inside else "cp"
    values = JsonValues.of(entry.content["cp"], path, place, BROADTRACK_KIND)
    if is_soccernet(values.content):
        loaded = camera_from(values.content, path=path, inside=place)
        return with_notices(loaded, entry.unused("cp"))
    for key in _SIZE:
        values.number(key)
    size = values.size_of(*_SIZE)
    angle = math.radians(values.number(_FIELD_OF_VIEW))
    if not 0 < angle < math.pi:
        raise values.error("expected an angle between 0 and 180 degrees", _FIELD_OF_VIEW)
    focal = size[0] / (2 * math.tan(angle / 2))
    pan, tilt, roll = values.radians(*_BROADTRACK_ANGLES)
    x, y, z = (values.number(key) for key in _POSITION)
    k1, k2, k3 = _radial(values, size[1] / focal)
    centre, radial = (size[0] / 2, size[1] / 2), (k1, k2, k3, 0.0, 0.0, 0.0)
    camera = PinholeCamera(pan, tilt, roll, (x, y, z), (focal, focal), centre, radial)
    unused = values.unused(*_SIZE, _FIELD_OF_VIEW, *_BROADTRACK_ANGLES, *_POSITION, _RADIAL)
    return LoadedCamera(camera, "pinhole", size, notices=(*unused, *entry.unused("cp")))


def _radial(values: JsonValues, unit: float) -> tuple[float, float, float]:
    given = values.numbers(_RADIAL) if _RADIAL in values else ()
    if len(given) > 3:
        raise values.error(f"expected at most 3 numbers, found {len(given)}", _RADIAL)
    k1, k2, k3 = (*given, *[0.0] * (3 - len(given)))
    found = k1 / unit**2, k2 / unit**4, k3 / unit**6
    if not all(map(math.isfinite, found)):
        raise values.error("expected finite coefficients", _RADIAL)
    return found
