"""Which file belongs to which frame: ``00037.json`` and ``camera_00037.json`` are frame 00037."""

from __future__ import annotations

from pathlib import PurePosixPath

from procc_annotator.errors import InputError
from procc_annotator.io.camera_files.registry import suffixes_of
from procc_annotator.io.frame_names import ByFrame
from procc_annotator.io.landmark_file import LANDMARKS_FILE
from procc_annotator.io.source import FileSource
from procc_annotator.io.strays import stray_notices, strays_among

CAMERA_PREFIX = "camera_"
_JSON = frozenset({".json", ".jsonl"})
_STORAGE = frozenset({".yml", ".yaml", ".xml"})
_HOMOGRAPHY_ENDING = "_homography"
# What this program writes beside annotations; a frame cannot have these names.
MANIFEST_FILE = "manifest.json"
OWN_FILES = frozenset({"jac.json", "procc.json", MANIFEST_FILE, LANDMARKS_FILE})


class CameraFiles(ByFrame[str]):
    """Frame name -> camera file; ``notices`` are remarks a person should see."""

    notices: tuple[str, ...] = ()


def may_be_annotation(file_name: str) -> bool:
    """Whether a JSON file of this name can be a frame's annotation, and so whether a picture of
    this stem can be a frame: not cameras, nor what this program writes itself."""
    return not file_name.startswith(CAMERA_PREFIX) and file_name not in OWN_FILES


class AnnotationFiles(ByFrame[str]):
    """Frame name -> annotation file; ``notices`` are remarks a person should see."""

    notices: tuple[str, ...] = ()


def list_annotations(source: FileSource) -> AnnotationFiles:
    """Frame name -> annotation file, in natural order; camera files beside them do not count.

    Nor does JSON of another kind (`procc_annotator.io.strays`): it is named in a notice.

    Raises:
        InputError: two files claim to be the annotation of the same frame.
    """
    found = list_frame_files(source)
    strays = strays_among(source, found)
    for frame in strays:
        del found[frame]
    found.notices = stray_notices(strays)
    return found


def list_frame_files(source: FileSource) -> AnnotationFiles:
    """The same, whatever the JSON holds: annotations of other formats than SoccerNet's, too."""
    found = AnnotationFiles()
    for name in source.files():
        path = PurePosixPath(name)
        if path.suffix.lower() == ".json" and may_be_annotation(path.name):
            _add(found, path.stem, name, source)
    return found


def list_cameras(source: FileSource, fmt: str = "auto") -> CameraFiles:
    """Frame name -> camera file, in natural order.

    Plain ``00037.json`` are cameras too, unless there are ``camera_*.json`` or files of another
    kind for the same frames: then they are annotations. Of a frame's JSON camera and another file
    (a homography) the former is taken, with a notice.

    Raises:
        InputError: two files of one kind claim to be the camera of the same frame.
    """
    suffixes = suffixes_of(fmt)
    paths = [PurePosixPath(name) for name in source.files()]
    paths = [p for p in paths if p.suffix.lower() in suffixes and p.name not in OWN_FILES]
    named = [p for p in paths if _is_json(p) and p.name.startswith(CAMERA_PREFIX)]
    plain = [p for p in paths if _is_json(p) and not p.name.startswith(CAMERA_PREFIX)]
    others = _by_frame([p for p in paths if not _is_json(p)], source)
    passed_over: list[PurePosixPath] = []
    if named or any(camera_frame(p.name) in others for p in plain):
        if named:
            frames = {camera_frame(p.name) for p in named} | others.keys()
            passed_over = [p for p in plain if camera_frame(p.name) not in frames]
        plain = []
    cameras = _by_frame([*named, *plain], source)
    chosen = others | cameras
    # Both lists are in natural order; one pass over all files restores it for their union.
    order = dict.fromkeys(camera_frame(p.name) for p in paths)
    found = CameraFiles((frame, chosen[frame]) for frame in order if frame in chosen)
    if passed_over:
        count = len(passed_over)
        found.notices = (
            f"{count} {'file' if count == 1 else 'files'} like {passed_over[0].name} taken for"
            f" {'an annotation, not a camera' if count == 1 else 'annotations, not cameras'},"
            f" because of camera_*.json beside {'it' if count == 1 else 'them'}",
        )
    both = len(others.keys() & cameras.keys())
    if both:
        found.notices = (
            *found.notices,
            f"{both} {'frame has' if both == 1 else 'frames have'} a JSON camera and"
            f" {_kind(others)}; the JSON camera is taken"
            " (choose a camera format to have the other)",
        )
    return found


def camera_frame(file_name: str) -> str:
    """The frame a camera file belongs to: its stem without ``camera_`` and ``_homography``."""
    stem = PurePosixPath(file_name).stem
    return stem.removeprefix(CAMERA_PREFIX).removesuffix(_HOMOGRAPHY_ENDING)


def _kind(files: dict[str, str]) -> str:
    storage = any(PurePosixPath(name).suffix.lower() in _STORAGE for name in files.values())
    return "another camera file" if storage else "a homography"


def _is_json(path: PurePosixPath) -> bool:
    return path.suffix.lower() in _JSON


def _by_frame(paths: list[PurePosixPath], source: FileSource) -> dict[str, str]:
    found: dict[str, str] = {}
    for path in paths:
        _add(found, camera_frame(path.name), str(path), source)
    return found


def _add(found: dict[str, str], frame: str, name: str, source: FileSource) -> None:
    if dict.__contains__(found, frame):  # letters composed otherwise are another file's business
        raise InputError(
            source.display(name),
            f"is the second file for frame {frame!r}, beside {found[frame]}",
            advice="keep one of them, or choose a camera format",
        )
    found[frame] = name
