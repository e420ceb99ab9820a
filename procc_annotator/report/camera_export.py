"""Cameras of a set in another format: what converting a set of cameras does."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

from procc_annotator.errors import CameraError, UsageError
from procc_annotator.io.camera_files.camera_collection import CameraCollection
from procc_annotator.io.camera_files.camera_writers import ConvertedCameras, write_cameras
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera

Progress = Callable[[int, int], None]


def export_cameras(
    cameras: CameraCollection,
    out: Path,
    to: str,
    *,
    size: tuple[int, int] | None = None,
    camera_size: tuple[int, int] | None = None,
    split: str = "test",
    progress: Progress | None = None,
) -> ConvertedCameras:
    """Write every camera of a collection in another format.

    Args:
        cameras: where they are.
        out: a folder (made if needed), or an archive if it ends in ``.zip``.
        to: one of `io.camera_writers.CAMERA_TARGETS`.
        size: (width, height) px the cameras shall be written for; by default their own.
        camera_size: the picture size their pixels belong to, where their files do not say.
        split: the folder inside a submission.
        progress: called with cameras done and cameras in all.

    Raises:
        UsageError: no such format, or ``out`` is where the cameras are.
        SaveError: writing failed; an archive is then not there, or the old one.
    """
    _check_apart_from_source(cameras.path, out)
    return write_cameras(
        _read(cameras, camera_size),
        out,
        to,
        size=size,
        split=split,
        total=len(cameras.frames),
        progress=progress,
    )


def _read(
    cameras: CameraCollection, camera_size: tuple[int, int] | None
) -> Iterator[tuple[str, LoadedCamera | CameraError]]:
    for frame in cameras.frames:
        try:
            loaded = cameras.read(frame)
        except CameraError as error:
            yield frame, error
        else:
            yield frame, replace(loaded, size=loaded.size_where(camera_size))


def _check_apart_from_source(source: Path, out: Path) -> None:
    """What is read must never be replaced by what is written."""
    target = os.path.realpath(out)
    own = os.path.realpath(source)
    if target == own or (os.path.isfile(own) and target == os.path.dirname(own)):
        raise UsageError(f"{out}: this is where the cameras are, write to another place")
