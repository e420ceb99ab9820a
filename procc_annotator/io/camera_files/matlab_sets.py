"""Two sets of soccer cameras that are published as MATLAB structures, ``annotation(i)`` a picture.

- ``homography``: the World Cup 2014 homographies as lood339/SCCvSD publishes them. They take the
  ground to pixels of 1280x720; the ground is in yards, 115 x 74, origin top left.
- ``camera``: frames of one tripod as lulufa390/Pan-tilt-zoom-SLAM publishes them. Principal point,
  focal length (px), Rodrigues vector, camera's place; metres, z up, origin at the corner nearest to
  the left goal and the cameras, y away from them. The file does not say how long and wide the field
  is; 115 x 74 yards are taken, as in the authors' other sets.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from procc_annotator.camera.base import FloatArray
from procc_annotator.errors import CameraError
from procc_annotator.io.camera_files.camera_records import (
    CameraRecord,
    CameraRecords,
)
from procc_annotator.io.camera_files.homography_file import (
    CONVENTIONS,
    HOMOGRAPHY_SIZE,
    camera_from_homography,
)
from procc_annotator.io.camera_files.krt_camera import krt_from
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera, with_notices
from procc_annotator.io.json_values import JsonValues

MATLAB_SET_KIND = "an annotation of a MATLAB structure"
_YARD_M = 0.9144
# The field's centre in their axes, and those in ours: half a turn about x.
_CENTRE = np.array([115 / 2 * _YARD_M, 74 / 2 * _YARD_M, 0.0])
_TURN = np.diag([1.0, -1.0, -1.0])
_FIELD = "soccer"


def is_homography_set(content: object) -> bool:
    """Whether a decoded value is the first of these sets."""
    return any("homography" in entry for entry in _entries(content))


def is_ptz_set(content: object) -> bool:
    """Whether a decoded value is the second."""
    return any("camera" in entry for entry in _entries(content))


def homography_records(content: object, path: str) -> CameraRecords:
    """The homographies of a decoded file.

    Raises:
        CameraError: there is none.
    """
    return _records(content, path, _homography)


def ptz_records(content: object, path: str) -> CameraRecords:
    """The cameras of a decoded file.

    Raises:
        CameraError: there is none.
    """
    return _records(content, path, _ptz)


def _entries(content: object) -> list[dict[str, Any]]:
    found = content.get("annotation") if type(content) is dict else None
    entries = [found] if type(found) is dict else found
    if type(entries) is not list:
        return []
    return [entry for entry in entries if type(entry) is dict and "image_name" in entry]


def _records(content: object, path: str, read: Any) -> CameraRecords:
    entries = _entries(content)
    if not entries:
        raise CameraError(path, "holds no camera, expected annotation(i) with image_name")
    found = [
        (str(entry["image_name"]), CameraRecord(f"annotation({i})", entry))
        for i, entry in enumerate(entries, 1)
    ]
    return CameraRecords.of(path, found, read)


def _homography(content: Any, path: str, inside: str) -> LoadedCamera:
    values = JsonValues.of(content, path, inside, MATLAB_SET_KIND)
    image_from_ground = values.matrix("homography", 3, 3)
    try:
        matrix: FloatArray = np.linalg.inv(image_from_ground).astype(np.float64)
    except np.linalg.LinAlgError as error:
        raise values.error("cannot be inverted", "homography") from error
    world = CONVENTIONS["wc14"].world_from_units
    loaded = camera_from_homography(matrix, world, HOMOGRAPHY_SIZE, path=path, place=inside)
    return with_notices(replace(loaded, assumed_field=_FIELD), values.unused("homography"))


def _ptz(content: Any, path: str, inside: str) -> LoadedCamera:
    values = JsonValues.of(content, path, inside, MATLAB_SET_KIND)
    cx, cy, focal, *rest = values.vector("camera", 9)
    place = _TURN @ (np.array(rest[3:]) - _CENTRE)
    rotation = _matrix_of(np.array(rest[:3])) @ _TURN
    own = {
        "K": [[focal, 0.0, cx], [0.0, focal, cy], [0.0, 0.0, 1.0]],
        "R": rotation.tolist(),
        "position": place.tolist(),
        "width": round(2 * cx),
        "height": round(2 * cy),
    }
    loaded = krt_from(own, path, inside)
    return with_notices(replace(loaded, assumed_field=_FIELD), values.unused("camera"))


def _matrix_of(vector: Any) -> Any:
    import cv2  # most sets have none of these files

    return np.asarray(cv2.Rodrigues(vector)[0], dtype=np.float64)
