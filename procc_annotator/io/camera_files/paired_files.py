"""Cameras that two files tell together: poses in one, lenses in the other.

They are known by their names, and belong together where they lie side by side.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import PurePosixPath

from procc_annotator.errors import CameraError
from procc_annotator.io.camera_files.camera_records import CameraRecords
from procc_annotator.io.camera_files.colmap_model import CAMERAS, IMAGES, colmap_records
from procc_annotator.io.camera_files.easymocap_cameras import (
    EXTRINSICS,
    INTRINSICS,
    easymocap_records,
)
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.source import FileSource


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


def paired_format(
    source: FileSource, names: Iterable[str], fmt: str = "auto"
) -> tuple[PairedFormat, str, str] | None:
    """The format whose two files a source has, with both their names; None for none.

    Args:
        source: where they are. names: of the files to look at.
        fmt: what was asked for: ``auto``, or a name.

    Raises:
        CameraError: one of a pair is there without the other, or it was asked for and none is.
    """
    wanted = [known for known in PAIRED_FORMATS if fmt in ("auto", known.name)]
    by_name = {PurePosixPath(name).name.lower(): name for name in names} if wanted else {}
    for known in wanted:
        poses, lenses = (by_name.get(name) for name in (known.poses, known.lenses))
        if poses is not None and lenses is not None:
            return known, poses, lenses
        if poses is None and fmt == "auto":
            continue  # cameras.txt and intri.yml alone may be anything
        missing = known.poses if poses is None else known.lenses
        raise CameraError(
            source.path,
            f"is without {missing}, expected {known.poses} and {known.lenses} side by side",
            advice="give the folder that holds both",
        )
    return None


def paired_records(
    source: FileSource, known: PairedFormat, poses: str, lenses: str
) -> CameraRecords:
    """The cameras of a pair.

    Raises:
        InputError: damaged, or not readable.
    """
    return known.records(
        source.read(poses), source.read(lenses), source.display(poses), source.display(lenses)
    )


def half_of_pair(data: bytes, *, path: str, known: PairedFormat) -> LoadedCamera:
    """No file of a pair is a camera alone.

    Raises:
        CameraError: always.
    """
    raise CameraError(
        path,
        f"is one file, expected {known.poses} and {known.lenses} side by side",
        advice="give the folder that holds both",
    )
