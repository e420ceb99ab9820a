"""``extri.yml`` with poses and ``intri.yml`` with lenses of named cameras, as EasyMocap keeps them.

Facts: https://chingswy.github.io/easymocap-public-doc/quickstart/calibration.html. Both are
FileStorage: ``K_NAME``, ``dist_NAME`` here, ``Rot_NAME`` (or the vector ``R_NAME``) and ``T_NAME``
there; world -> camera, metres, axes as here.
"""

from __future__ import annotations

from typing import Any

from procc_annotator.errors import CameraError
from procc_annotator.io.camera_files.camera_records import (
    CameraRecord,
    CameraRecords,
)
from procc_annotator.io.camera_files.krt_camera import krt_from
from procc_annotator.io.camera_files.opencv_camera import storage_numbers
from procc_annotator.io.json_text import printable
from procc_annotator.io.json_values import is_camera_key

EXTRINSICS, INTRINSICS = "extri.yml", "intri.yml"
_LENS = {"K_": "K", "dist_": "dist", "W_": "width", "H_": "height"}
_POSE = {"Rot_": "R", "R_": "rvec", "T_": "t"}


def easymocap_records(
    extrinsics: bytes, intrinsics: bytes, *, path: str, intrinsics_path: str
) -> CameraRecords:
    """The named cameras of a pair of files.

    Args:
        extrinsics, intrinsics: the two files. path, intrinsics_path: for messages.

    Raises:
        CameraError: damaged, or no camera in both.
    """
    poses, left = _by_name(extrinsics, path, _POSE)
    lenses, other = _by_name(intrinsics, intrinsics_path, _LENS)
    left |= other | {f"lens of {name}" for name in lenses.keys() - poses.keys()}
    found = [
        (name, CameraRecord(f"camera {name}", {**lenses.get(name, {}), **pose}))
        for name, pose in poses.items()
    ]
    if not found:
        raise CameraError(path, "holds no camera, expected Rot_NAME (or R_NAME) and T_NAME")
    notices = (f"not used: {printable(', '.join(sorted(left)), 200)}",) if left else ()
    return CameraRecords.of(path, found, krt_from, notices)


def _by_name(
    data: bytes, path: str, parts: dict[str, str]
) -> tuple[dict[str, dict[str, Any]], set[str]]:
    """Return the numbers of each camera, and the camera keys that are not read."""
    others: set[str] = set()

    def wanted(names: set[str]) -> list[str]:
        own = sorted(n for n in names if n.startswith(tuple(parts)))
        others.update(n for n in names.difference(own) if is_camera_key(n) or n[1:2] == "_")
        return own

    content = storage_numbers(data, path, wanted)
    found: dict[str, dict[str, Any]] = {}
    for key, value in content.items():
        start = next(part for part in parts if key.startswith(part))
        found.setdefault(key[len(start) :], {})[parts[start]] = value
    return found, others
