"""What a place holds where something else was looked for, and the command that takes it."""

from __future__ import annotations

from pathlib import Path

from procc_annotator.errors import InputError, UsageError
from procc_annotator.image.suffixes import PICTURE_SUFFIXES, VIDEO_SUFFIXES
from procc_annotator.io.annotation_files.annotation_formats import told_formats
from procc_annotator.io.collections import CAMERA_PREFIX
from procc_annotator.io.source import FileSource, open_source
from procc_annotator.words import count_of


def instead_of_annotations(source: FileSource) -> str:
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
        return f"; it holds {count_of(cameras, 'camera')} ({CAMERA_PREFIX}*): give the annotations"
    if pictures or videos:
        what = count_of(pictures, "picture") if pictures else count_of(videos, "video")
        return (
            f"; it holds {what}, not annotated yet: procc-annotator open {source.path} to click,"
            " propose and annotate without a click"
        )
    return ""


def instead_of_pictures(place: Path) -> str:
    """The same of a dataset without pictures."""
    if _suffix(place.name) in PICTURE_SUFFIXES:
        return ""
    try:
        with open_source(place) as source:
            told = told_formats(source)
    except (InputError, UsageError):  # what cannot be opened is told where it is needed
        return ""
    if not told:
        return ""
    titles = " and ".join(known.title for known in told)
    return (
        f", only annotations ({titles}): evaluate, check, calibrate, report and convert do without"
        " pictures"
    )


def _suffix(name: str) -> str:
    return Path(name).suffix.lower()
