"""What a place holds where something else was looked for, and the command that takes it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from procc_annotator.errors import InputError, UsageError
from procc_annotator.image.suffixes import PICTURE_SUFFIXES, VIDEO_SUFFIXES
from procc_annotator.io.annotation_files.annotation_formats import PLAIN, detect_formats
from procc_annotator.io.annotation_files.yolo_pose import is_pose_label
from procc_annotator.io.camera_files.json_cameras import detected_title
from procc_annotator.io.camera_files.registry import suffixes_of
from procc_annotator.io.collections import CAMERA_PREFIX, list_annotations
from procc_annotator.io.source import FileSource, open_source
from procc_annotator.words import count_words

# Suffixes that annotations, lists and notes have as well tell nothing of cameras.
_NOT_CAMERAS_ALONE = frozenset({".json", ".xml", ".txt", ".yml", ".yaml"})
_ANNOTATIONS = frozenset({".json", ".xml"})
_PACKED = "Frames-v3.zip"  # as SoccerNet-v3 is downloaded, one a game
# So many files are read to tell what a set holds.
_LOOKED_INTO = 3


def found_instead_of_annotations(source: FileSource) -> str:
    """What a source without annotations holds, to go on after "nothing to do: .."; empty where
    that tells nothing."""
    try:
        names = source.tree()
    except InputError:  # too large or too deep for a set: nothing is to be said of it
        return ""
    pictures = sum(_suffix(name) in PICTURE_SUFFIXES for name in names)
    videos = sum(_suffix(name) in VIDEO_SUFFIXES for name in names)
    cameras = sum(name.rpartition("/")[2].startswith(CAMERA_PREFIX) for name in names)
    if cameras:
        return f"; it holds {count_words(cameras, 'camera')} ({CAMERA_PREFIX}*): give the annotations"
    if labels := _pose_labels(source, names):
        return (
            f"; it holds {count_words(labels, 'file')} of YOLO pose, which is not read: get it as COCO"
            " keypoints, and procc-annotator propose-map says what its places are"
        )
    if suffixes := {_suffix(name) for name in names} & camera_suffixes():
        files = sum(_suffix(name) in suffixes for name in names)
        kinds = ", ".join(sorted(suffixes))
        return f"; it holds {count_words(files, 'file')} of cameras ({kinds}): give the annotations"
    if pictures or videos:
        what = count_words(pictures, "picture") if pictures else count_words(videos, "video")
        return (
            f"; it holds {what}, not annotated yet: procc-annotator open {source.path} to click,"
            " propose and annotate without a click"
        )
    return ""


def camera_suffixes() -> frozenset[str]:
    """Lower-case suffixes of files that hold cameras and nothing else this program reads."""
    return suffixes_of() - _NOT_CAMERAS_ALONE


def refuse_cameras(source: FileSource, names: Sequence[str]) -> None:
    """Refuse files that are cameras, by the first of them, where annotations were asked for.

    Raises:
        UsageError: they are.
    """
    first = names[:_LOOKED_INTO]
    titles = [_camera_title(source, name) for name in first]
    if not titles or not all(titles):
        return
    what = count_words(len(names), "file") if len(names) > 1 else "a file"
    raise UsageError(
        f"nothing to do: no annotation in {source.path}; it holds {what} of cameras ({titles[0]}):"
        " give the annotations"
    )


def refuse_other_content(source: FileSource) -> None:
    """Refuse a source without annotations of any format, where it can be told what it is instead.

    Raises:
        UsageError: it holds something else.
    """
    try:
        names, files = source.tree(), list(list_annotations(source).values())
    except InputError:  # told by the reader of the format, for which it may be no problem
        return
    refuse_cameras(source, files)
    if any(_suffix(name) in _ANNOTATIONS for name in names):
        return  # even if damaged: its reader says how
    if instead := found_instead_of_annotations(source):
        raise UsageError(f"nothing to do: no annotation in {source.path}{instead}")


def found_instead_of_cameras(place: Path) -> str:
    """What a place without cameras holds, to go on after "nothing to do: .."; empty where that
    tells nothing. The program's own annotations are told by the reader of cameras."""
    try:
        with open_source(place) as source:
            told = [known for known in detect_formats(source) if known.name != PLAIN]
            files = source.tree()
            labels = _pose_labels(source, files)
    except (InputError, UsageError):  # what cannot be opened is told where it is needed
        return ""
    if told:
        titles = " and ".join(known.title for known in told)
        return (
            f"; it holds annotations ({titles}): procc-annotator calibrate {place} OUT fits cameras"
            " to them"
        )
    if labels:
        return f"; it holds annotations ({count_words(labels, 'file')} of YOLO pose, not read)"
    if any(_suffix(name) in suffixes_of() for name in files):
        return ""
    return f"; cameras are looked for in files of {', '.join(sorted(suffixes_of()))}"


def _camera_title(source: FileSource, name: str) -> str:
    try:
        return detected_title(source.read(name), source.display(name))
    except InputError:  # told where it is read
        return ""


def _pose_labels(source: FileSource, names: Sequence[str]) -> int:
    texts = [name for name in names if _suffix(name) == ".txt"]
    try:
        told = any(is_pose_label(source.read(name)) for name in texts[:_LOOKED_INTO])
    except InputError:  # what cannot be read tells nothing
        return 0
    return len(texts) if told else 0


def found_instead_of_pictures(place: Path) -> str:
    """The same of a dataset without pictures."""
    if _suffix(place.name) in PICTURE_SUFFIXES:
        return ""
    try:
        with open_source(place) as source:
            told = detect_formats(source)
            packed = [name for name in source.tree() if name.rpartition("/")[2] == _PACKED]
    except (InputError, UsageError):  # what cannot be opened is told where it is needed
        return ""
    if not told:
        return ""
    titles = " and ".join(known.title for known in told)
    if packed:
        return (
            f", only annotations ({titles}); the pictures are still packed: unpack each {_PACKED}"
            " into a folder v3_frames beside it"
        )
    return (
        f", only annotations ({titles}): evaluate, check, calibrate, report and convert do without"
        " pictures"
    )


def _suffix(name: str) -> str:
    return Path(name).suffix.lower()
