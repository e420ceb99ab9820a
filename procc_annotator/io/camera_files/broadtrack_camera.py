"""BroadTrack's JSON: picture name -> {``cp``: the camera, ``score``, ...}.

Source of the keys and of their meaning: the files the published program writes. The principal
point is the middle of the sensor, (W / 2, H / 2); the radial coefficients are given for lengths
divided by (height / focal length).
"""

from __future__ import annotations

import math

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import CameraError
from procc_annotator.io.camera_files.camera_records import (
    CameraRecord,
    CameraRecords,
)
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera, with_notices
from procc_annotator.io.camera_files.soccernet_camera import camera_from, is_soccernet
from procc_annotator.io.json_values import JsonValues, degrees

BROADTRACK_KIND = "a BroadTrack camera"
_SIZE = ("sensorResolutionWidthPixels", "sensorResolutionHeightPixels")
_FIELD_OF_VIEW = "horizontalFieldOfViewDegrees"
_BROADTRACK_ANGLES = ("panDegrees", "tiltDegrees", "rollDegrees")
_POSITION = ("positionXMeters", "positionYMeters", "positionZMeters")
_RADIAL = "normalizedRadialDistortionCoefficients"


def is_broadtrack(content: object) -> bool:
    """Whether a decoded value is such a file: an object of objects with ``cp``."""
    return type(content) is dict and any(
        type(entry) is dict and "cp" in entry for entry in content.values()
    )


def broadtrack_records(content: object, path: str) -> CameraRecords:
    """The cameras of a decoded file.

    Raises:
        CameraError: not an object of objects.
    """
    values = JsonValues.of(content, path, kind="a BroadTrack file (picture name -> camera)")
    if not values.content:
        raise CameraError(path, "holds no camera, expected picture names with cameras")
    found = [(name, CameraRecord(name, entry)) for name, entry in values.content.items()]
    return CameraRecords.of(path, found, broadtrack_from)


def broadtrack_from(content: object, path: str, inside: str = "") -> LoadedCamera:
    """Read a decoded entry, ``{"cp": camera, ...}``.

    Raises:
        CameraError: names the place and what was expected.
    """
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
    pan, tilt, roll = degrees(values, _BROADTRACK_ANGLES)
    x, y, z = (values.number(key) for key in _POSITION)
    k1, k2, k3 = _radial(values, size[1] / focal)
    camera = PinholeCamera(
        pan,
        tilt,
        roll,
        (x, y, z),
        (focal, focal),
        (size[0] / 2, size[1] / 2),
        (k1, k2, k3, 0.0, 0.0, 0.0),
    )
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
