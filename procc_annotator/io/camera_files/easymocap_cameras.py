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
from procc_annotator.io.camera_files.free_world import with_doubt
from procc_annotator.io.camera_files.krt_camera import krt_from
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.camera_files.opencv_camera import storage_numbers

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
    poses = _by_name(extrinsics, path, _POSE)
    lenses = _by_name(intrinsics, intrinsics_path, _LENS)
    found = [
        (name, CameraRecord(f"camera {name}", {**lenses.get(name, {}), **pose}))
        for name, pose in poses.items()
    ]
    if not found:
        raise CameraError(path, "holds no camera, expected Rot_NAME (or R_NAME) and T_NAME")
    return CameraRecords.of(path, found, _camera)


def _by_name(data: bytes, path: str, parts: dict[str, str]) -> dict[str, dict[str, Any]]:
    content = storage_numbers(
        data, path, lambda names: sorted(n for n in names if n.startswith(tuple(parts)))
    )
    found: dict[str, dict[str, Any]] = {}
    for key, value in content.items():
        start = next(part for part in parts if key.startswith(part))
        found.setdefault(key[len(start) :], {})[parts[start]] = value
    return found


def _camera(content: Any, path: str, inside: str) -> LoadedCamera:
    return with_doubt(krt_from(content, path, inside))
