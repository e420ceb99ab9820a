"""Formats that keep poses and intrinsics in two files: table of pairs, EasyMocap."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import Any

from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.colmap import CAMERAS, IMAGES, colmap_records
from procc_annotator.formats.cameras.json_values import is_camera_key
from procc_annotator.formats.cameras.krt import krt_from
from procc_annotator.formats.cameras.loaded_camera import CameraRecord, CameraRecords, LoadedCamera
from procc_annotator.formats.cameras.opencv import storage_numbers
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.strict_json import printable

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


@dataclass(frozen=True)
class PairedFormat:
    """A camera format of two files.

    Attributes:
        name, title: as of `CameraFormat`.
        poses, lenses: the names of the two files.
        records: the cameras, of the bytes of both and their names for messages.
    """

    name: str
    title: str
    poses: str
    lenses: str
    records: Callable[[bytes, bytes, str, str], CameraRecords]


PAIRED_FORMATS = (
    PairedFormat(
        "colmap",
        "COLMAP text model, images.txt and cameras.txt",
        IMAGES,
        CAMERAS,
        lambda poses, lenses, path, other: colmap_records(
            poses, lenses, path=path, cameras_path=other
        ),
    ),
    PairedFormat(
        "easymocap",
        "EasyMocap, extri.yml and intri.yml",
        EXTRINSICS,
        INTRINSICS,
        lambda poses, lenses, path, other: easymocap_records(
            poses, lenses, path=path, intrinsics_path=other
        ),
    ),
)


def paired_records(
    source: FileSource,
    files: Mapping[str, str],
    fmt: str,
    about_to_read: Callable[[str], None],
) -> dict[str, CameraRecords]:
    """File of poses -> its cameras, for each pair that a source has, of one format: at its top, or
    in each folder of a tree.

    Args:
        source: where they are.
        files: frame name, as if each file were a frame's -> file to look at.
        fmt: what was asked for: ``auto``, or a name.
        about_to_read: told of each file of poses before it is read.

    Raises:
        CameraError: one of a pair is there without the other, or it was asked for and none is.
        InputError: damaged, or not readable.
    """
    for known in PAIRED_FORMATS:
        if fmt not in ("auto", known.name):
            continue
        pairs = _pairs(source, known, files, asked_for=fmt != "auto")
        found = {}
        for folder, (poses, lenses) in pairs.items():
            about_to_read(poses)
            data = source.read(poses), source.read(lenses)
            shown = source.display(poses), source.display(lenses)
            found[poses] = known.records(*data, *shown).below(folder)
        if found:
            return found
    return {}


def _pairs(
    source: FileSource, known: PairedFormat, files: Mapping[str, str], asked_for: bool
) -> dict[str, tuple[str, str]]:
    """Folder that frames are called by -> both files of the pair in it."""
    by_folder: dict[str, dict[str, str]] = {"": {}} if asked_for and not files else {}
    for frame, file in files.items():
        name = PurePosixPath(file).name.lower()
        by_folder.setdefault(frame.rpartition("/")[0], {})[name] = file
    found = {}
    for folder, by_name in by_folder.items():
        poses, lenses = (by_name.get(name) for name in (known.poses, known.lenses))
        if poses is not None and lenses is not None:
            found[folder] = poses, lenses
        elif poses is not None or asked_for:  # cameras.txt and intri.yml alone may be anything
            missing = known.poses if poses is None else known.lenses
            raise CameraError(
                source.path / folder,
                f"is without {missing}, expected {known.poses} and {known.lenses} side by side",
                advice="give the folder that holds both",
            )
    return found


def raise_half_of_pair(data: bytes, *, path: str, known: PairedFormat) -> LoadedCamera:
    """No file of a pair is a camera alone.

    Raises:
        CameraError: always.
    """
    raise CameraError(
        path,
        f"is one file, expected {known.poses} and {known.lenses} side by side",
        advice="give the folder that holds both",
    )
