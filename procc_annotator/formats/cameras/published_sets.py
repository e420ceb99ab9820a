"""Cameras of published datasets: DeepSportRadar JSON, WorldCup 2014 and PTZ MATLAB structures."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from procc_annotator.camera.base import FloatArray
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.homography import (
    CONVENTIONS,
    HOMOGRAPHY_SIZE,
    camera_from_homography,
)
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.krt import KrtKeys, camera_of_matrices, krt_from
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
    with_notices,
)
from procc_annotator.formats.strict_json import json_kind

DEEPSPORTRADAR_KIND = "a K, R, T camera of DeepSportRadar"
_CM = 0.01
# The centre of a FIBA court, in the file's units from the corner that is its origin.
COURT_CENTRE_CM = (1400.0, 750.0, 0.0)
_KEYS = KrtKeys(
    k=("K",), r=("R",), t=("T",), position=(), distortion=("kc",), model=(),
    repeated=("C", "P"),
)  # fmt: skip
# What the challenge's code writes where it found no camera.
_NO_CAMERA = [1.0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1]


_REMARK = "cameras of a basketball court, for frames called 0, 1, 2 ... by their order in the file"


def is_deepsportradar(content: object) -> bool:
    """Return whether a decoded value is such a list."""
    return type(content) is list and any(
        type(entry) is dict and {"K", "R", "T"} <= entry.keys() for entry in content
    )


def deepsportradar_records(content: object, path: str) -> CameraRecords:
    """The cameras of a decoded list; the first entry may tell the pictures' size alone.

    Raises:
        CameraError: not a list, or one without cameras.
    """
    if type(content) is not list:
        raise CameraError(
            path, f"expected a list of cameras, found {json_kind(content)}", place="top level"
        )
    size = None
    entries = list(enumerate(content))
    if entries and type(content[0]) is dict and set(content[0]) == {"width", "height"}:
        size = JsonValues(content[0], path, "[0]", DEEPSPORTRADAR_KIND, nested=True).size()
        entries = entries[1:]
    if not entries:
        raise CameraError(path, "holds no camera, expected a list of cameras")
    found = [
        (str(frame), CameraRecord(f"[{i}]", (entry, size)))
        for frame, (i, entry) in enumerate(entries)
    ]
    return CameraRecords.of(path, found, _from_entry, (_REMARK,))


def _from_entry(content: tuple[object, tuple[int, int] | None], path: str, at: str) -> LoadedCamera:
    entry, size = content
    values = JsonValues.of(entry, path, at, DEEPSPORTRADAR_KIND, nested=True)
    if "P" in values and list(values.numbers("P")) == _NO_CAMERA:
        raise values.error('stands for "no camera found"', "P", advice="")
    rotation, t = values.matrix("R", 3, 3), values.numbers("T")
    if len(t) != 3:
        raise values.error(f"expected 3 numbers, found {len(t)}", "T")
    moved = {**values.content, "T": _centred(rotation, t, values)}
    own = JsonValues(moved, path, at, DEEPSPORTRADAR_KIND, nested=True)
    return camera_of_matrices(own, _KEYS, own.size() or size)


def _centred(rotation: FloatArray, t: tuple[float, ...], values: JsonValues) -> list[float]:
    """t in metres, for a world whose origin is the court's centre."""
    with np.errstate(over="ignore", invalid="ignore"):
        moved: list[float] = (_CM * (np.array(t) + rotation @ np.array(COURT_CENTRE_CM))).tolist()
    if not all(map(math.isfinite, moved)):
        raise values.error("is without bounds", "T")
    return moved


MATLAB_SET_KIND = "an annotation of a MATLAB structure"
_YARD_M = 0.9144
# The field's centre in their axes, and those in ours: half a turn about x.
_CENTRE = np.array([115 / 2 * _YARD_M, 74 / 2 * _YARD_M, 0.0])
_TURN = np.diag([1.0, -1.0, -1.0])
_FIELD = "soccer"


def is_homography_set(content: object) -> bool:
    """Return whether a decoded value is the first of these sets."""
    return any("homography" in entry for entry in _entries(content))


def is_ptz_set(content: object) -> bool:
    """Return whether a decoded value is the second."""
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
