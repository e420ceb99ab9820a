"""Several K, R, t cameras in one object: under ``cameras``, as stacked arrays, or of a dome.

A file of the Panoptic Studio counts in centimetres with y down and the floor at y = 0; all others
in this project's world. See docs/camera-formats.md.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from procc_annotator.errors import CameraError
from procc_annotator.io.camera_files.camera_records import (
    CameraRecord,
    CameraRecords,
)
from procc_annotator.io.camera_files.krt_camera import (
    KRT_KEYS,
    KrtKeys,
    camera_of_matrices,
    is_krt,
    krt_from,
)
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.camera_files.projection_camera import is_projection, projection_from
from procc_annotator.io.json_values import JsonValues

NESTED_KIND = "a K, R, t camera"
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
    repeated=("resolution",),
)  # fmt: skip
_CM = 0.01
# The dome's axes in ours: x stays, our y is against its z, our z (down) is its y.
_DOME_FROM_WORLD = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
BY_ORDER = "the file names no frames: they are called 0, 1, 2 ... by the order in it"


def is_nested(content: object) -> bool:
    """Whether a decoded value holds cameras under ``cameras``."""
    return type(content) is dict and any(is_krt(entry) for _, _, entry in _nested(content))


def is_stack(content: object) -> bool:
    """Whether a decoded value is an object of stacked matrices, one a frame."""
    return type(content) is dict and _frames_of_stack(content) is not None


def nested_records(content: object, path: str) -> CameraRecords:
    """The cameras of a decoded file with ``cameras``.

    Raises:
        CameraError: there is none.
    """
    found = [(name, CameraRecord(place, entry)) for name, place, entry in _nested(content)]
    if not found:
        raise CameraError(path, "holds no camera, expected K, R and t under 'cameras'")
    beside = JsonValues.of(content, path, kind=NESTED_KIND).unused("cameras")
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
    """(name, place, entry) of each camera."""
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
    if type(content) is dict and content.keys() >= _DOME:
        return _dome_camera(content, path, inside)
    return krt_from(content, path, inside)


def _dome_camera(content: dict[str, Any], path: str, inside: str) -> LoadedCamera:
    values = JsonValues(content, path, inside, "a camera of the Panoptic Studio")
    rotation, t = values.matrix("R", 3, 3), values.numbers("t")
    width, height = values.vector("resolution", 2)
    sized = JsonValues({"width": width, "height": height}, path, inside)
    if len(t) != 3:
        raise values.error(f"expected 3 numbers, found {len(t)}", "t")
    own = {
        **content,
        "R": (rotation @ _DOME_FROM_WORLD).tolist(),
        "t": [_CM * number for number in t],
    }
    turned = JsonValues(own, path, inside, NESTED_KIND)
    return camera_of_matrices(turned, _DOME_KEYS, sized.size())


def _frames_of_stack(content: dict[str, Any]) -> int | None:
    """How many frames an object of stacked matrices is of; None for one that is no stack."""
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
    """How deeply lists nest, and how long the innermost one is."""
    depth = length = 0
    while type(value) is list:
        depth, length = depth + 1, len(value)
        value = value[0] if value else None
    return depth, length
