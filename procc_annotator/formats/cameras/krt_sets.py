"""Files of many K, R, t cameras: named, listed, or as stacked arrays, one of each part a frame."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.krt import (
    KRT_KEYS,
    PROJECTION_KEYS,
    KrtKeys,
    flat_entry,
    is_projection,
    krt_from,
    projection_from,
)
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
)
from procc_annotator.messages import pluralize

NAME_KEYS = (
    "frames", "frame_ids", "frame_numbers", "frame_names", "names", "image_names", "filenames",
    "images", "image_paths",
)  # fmt: skip
_OWN_NAME = ("name", "image_name", "img_name", "frame", "file_name", "id")
BY_ORDER = "the file names no frames: they are called 0, 1, 2 ... by the order in it"
# What OpenCV's calibration tutorials call the same in their .npz files.
_OPENCV_NAMES = {"rvecs": "rvec", "tvecs": "tvec"}
_VECTORS = {"rvec", "rotation_vector", "rotation"}


def is_krt_file(content: object, keys: KrtKeys = KRT_KEYS) -> bool:
    """Return whether a decoded file holds cameras with the keys of a format."""
    if type(content) is not dict or keys.are_in(content):
        return keys.are_in(content)
    content = _without_batch(content)
    return any(keys.are_in(entry) for _, _, entry in _nested(content)) or _is_stack(content, keys)


def krt_records(content: object, path: str, keys: KrtKeys = KRT_KEYS) -> CameraRecords | None:
    """The cameras of a decoded file that holds several; None for one.

    Raises:
        CameraError: stacks of different heights, or other names than frames.
    """
    if type(content) is not dict:
        return None
    content = _without_batch(content)
    read = partial(krt_from, keys=keys)
    nested = list(_nested(content))
    if any(keys.are_in(entry) for _, _, entry in nested):
        found = [(name, CameraRecord(place, entry)) for name, place, entry in nested]
        beside = JsonValues.of(content, path, kind=keys.kind).unused("cameras")
        return CameraRecords.of(path, found, read, beside)
    if _is_stack(content, keys):
        return _stack_records(content, path, keys)
    entries = {name: flat_entry(entry) for name, entry in content.items()}
    if keys.are_in(content) or not any(map(keys.are_in, entries.values())):
        return None
    # A section that has no part of a camera at all is none: [metadata], "units".
    sections = {n: e for n, e in entries.items() if type(e) is dict and not {*keys.used} & e.keys()}
    found = [(n, CameraRecord(n, entry)) for n, entry in entries.items() if n not in sections]
    return CameraRecords.of(path, found, read, JsonValues(sections, path).unused())


def _nested(content: dict[str, Any]) -> Iterator[tuple[str, str, Any]]:
    cameras = content.get("cameras")
    if type(cameras) is dict:
        for name, entry in cameras.items():
            yield name, f"cameras.{name}", flat_entry(entry)
    elif type(cameras) is list:
        for i, entry in enumerate(cameras):
            own = entry if type(entry) is dict else {}
            name = next((own[key] for key in _OWN_NAME if key in own), i)
            yield str(name), f"cameras[{i}]", flat_entry(entry)


def _stack_records(content: dict[str, Any], path: str, keys: KrtKeys) -> CameraRecords:
    """One object of a frame's own parts for each frame of a stack; read by what is in it."""
    counts = _counts(content, keys)
    placed = {key: n for key, n in counts.items() if key in _placed(keys)}
    frames, poses = max(counts.values()), max(placed.values(), default=1)
    others = [n for key, n in counts.items() if key not in placed]
    if (
        1 < poses < frames
        or any(n != poses for n in placed.values())
        or any(n not in (1, frames) for n in others)
    ):
        some = ", ".join(f"{n} of {key}" for key, n in counts.items())
        raise CameraError(path, f"holds {some}, expected one of each part a frame")
    key = next((k for k in NAME_KEYS if _are_names(content.get(k))), None)
    given = content[key] if key else range(frames)
    names = [str(int(n) if type(n) is float and n.is_integer() else n) for n in given]
    if len(names) != frames:
        raise CameraError(path, f"holds {len(names)} names for {frames} cameras", place=str(key))
    entries = []
    for i, name in enumerate(names[:poses]):
        own = {
            _OPENCV_NAMES.get(k, k): v[i if counts[k] > 1 else 0] if k in counts else v
            for k, v in content.items()
            if k != key
        }
        entries.append((name.strip(), CameraRecord(f"[{i}]", own)))
    notices = () if key else (BY_ORDER,)
    if poses < frames:
        left = pluralize(frames - poses, "frame")
        notices = (*notices, f"R and t are of the first frame alone: {left} without a camera")
    return CameraRecords.of(path, entries, partial(_own_from, keys=keys), notices)


def _own_from(content: object, path: str, inside: str, keys: KrtKeys) -> LoadedCamera:
    if is_projection(content) and not keys.are_in(content):
        return projection_from(content, path, inside)
    return krt_from(content, path, inside, keys)


def _placed(keys: KrtKeys) -> tuple[str, ...]:
    return (*keys.placed, *_OPENCV_NAMES, *PROJECTION_KEYS) if keys is KRT_KEYS else keys.placed


def _is_stack(content: dict[str, Any], keys: KrtKeys) -> bool:
    counts = _counts(content, keys)
    return any(key in _placed(keys) for key in counts) or (
        keys.are_in(content) and max(counts.values(), default=0) > 1
    )


def _counts(content: dict[str, Any], keys: KrtKeys) -> dict[str, int]:
    """Key -> how many of its part are stacked in it; the parts of one camera are none."""
    matrices = {*keys.k, *keys.pose, *keys.inverse_pose, *PROJECTION_KEYS, *keys.r} - _VECTORS
    vectors = {*keys.t, *keys.position, *keys.distortion, *_OPENCV_NAMES, *_VECTORS}
    found = {k: len(v) for k, v in content.items() if k in matrices and depth_of(v) == 3}
    others = sorted(content.keys() & vectors - found.keys(), key=lambda key: (key in _VECTORS, key))
    for key in others:  # (N, 3) or (N, 3, 1), but not (3, 1)
        value, depth = content[key], depth_of(content[key])
        wide = depth == 2 and (len(value[0]) >= 2 if key in keys.distortion else len(value[0]) == 3)
        # Of a rotation that is a matrix three rows are no stack, nor is a vector that is a row.
        is_matrix = key in _VECTORS and depth == 2 and 3 not in found.values()
        if (
            (depth == 3 or wide)
            and (len(value) > 1 or found)
            and not (is_matrix and len(value) == 3)
        ):
            found[key] = len(value)
    return found


def _without_batch(content: dict[str, Any]) -> dict[str, Any]:
    """The same without the axis of one batch that networks put before the frames."""
    return {k: v[0] if depth_of(v) == 4 and len(v) == 1 else v for k, v in content.items()}


def _are_names(value: object) -> bool:
    return type(value) is list and all(type(name) in (str, int, float) for name in value)


def depth_of(value: Any) -> int:
    """Return how deeply lists nest."""
    depth = 0
    while type(value) is list:
        depth, value = depth + 1, value[0] if value else None
    return depth
