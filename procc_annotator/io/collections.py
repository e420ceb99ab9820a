"""Which file belongs to which frame: ``00037.json`` and ``camera_00037.json`` are frame 00037."""

from __future__ import annotations

from pathlib import PurePosixPath

from procc_annotator.errors import InputError
from procc_annotator.io.registry import suffixes_of
from procc_annotator.io.source import FileSource

CAMERA_PREFIX = "camera_"
_HOMOGRAPHY_ENDING = "_homography"
# What this program writes beside annotations; a frame cannot have these names.
OWN_FILES = frozenset({"jac.json", "procc.json"})


def list_annotations(source: FileSource) -> dict[str, str]:
    """Frame name -> annotation file, in natural order; camera files beside them do not count."""
    found: dict[str, str] = {}
    for name in source.files():
        path = PurePosixPath(name)
        if (
            path.suffix.lower() == ".json"
            and not path.name.startswith(CAMERA_PREFIX)
            and path.name not in OWN_FILES
        ):
            _add(found, path.stem, name, source)
    return found


def list_cameras(source: FileSource, fmt: str = "auto") -> dict[str, str]:
    """Frame name -> camera file, in natural order.

    In a folder that holds annotations too, only ``camera_*.json`` are cameras; a folder of plain
    ``00037.json`` is taken for cameras when no file has the prefix.

    Raises:
        InputError: two files claim to be the camera of the same frame.
    """
    suffixes = suffixes_of(fmt)
    paths = [PurePosixPath(name) for name in source.files()]
    paths = [p for p in paths if p.suffix.lower() in suffixes and p.name not in OWN_FILES]
    prefixed = any(p.name.startswith(CAMERA_PREFIX) for p in paths if p.suffix.lower() == ".json")
    found: dict[str, str] = {}
    for path in paths:
        is_json = path.suffix.lower() == ".json"
        if is_json and prefixed and not path.name.startswith(CAMERA_PREFIX):
            continue
        _add(found, camera_frame(path.name), str(path), source)
    return found


def camera_frame(file_name: str) -> str:
    """The frame a camera file belongs to: its stem without ``camera_`` and ``_homography``."""
    stem = PurePosixPath(file_name).stem
    return stem.removeprefix(CAMERA_PREFIX).removesuffix(_HOMOGRAPHY_ENDING)


def _add(found: dict[str, str], frame: str, name: str, source: FileSource) -> None:
    if frame in found:
        raise InputError(
            source.display(name),
            f"is the second file for frame {frame!r}, beside {found[frame]}",
            advice="keep one of them, or choose a camera format",
        )
    found[frame] = name
