"""DeepSportRadar's (calib3d's) JSON list of K, R, T: centimetres, a basketball court's corner.

The list names no frames: they are 0, 1, 2, ... in the order of the cameras.
"""

from __future__ import annotations

import math

import numpy as np

from procc_annotator.camera.base import FloatArray
from procc_annotator.errors import CameraError
from procc_annotator.io.camera_files.camera_records import CameraRecord, CameraRecords
from procc_annotator.io.camera_files.krt_camera import KrtKeys, camera_of_matrices
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.json_text import json_kind
from procc_annotator.io.json_values import JsonValues

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
    """Whether a decoded value is such a list."""
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
