"""Which folder a dataset's own things lie in, and what else does: pictures and annotations."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

import msgspec

from procc_annotator.errors import InputError, UsageError
from procc_annotator.image.suffixes import VIDEO_SUFFIXES
from procc_annotator.io.annotation_files.label_map import LABELS_FILE
from procc_annotator.io.collections import ANNOTATIONS_FOLDER, CAMERA_PREFIX, list_annotations
from procc_annotator.io.json_text import strip_bom
from procc_annotator.io.landmark_file import LANDMARKS_FILE
from procc_annotator.io.source import FileSource, open_source
from procc_annotator.session.database.file import FOLDER as WORKSPACE_FOLDER
from procc_annotator.session.dataset.picture_tree import (
    find_pictures,
    video_frames_folder_name,
    pictures_in,
    suffix_of,
)
from procc_annotator.session.dataset.what_lies_there import camera_suffixes

FIELD_FILE = "field.toml"
VIEWS_FILE = "views.csv"
FRAMES_FILE = "frames.csv"
STADIUMS_FILE = "stadiums.csv"

_LOOKED_INTO = 20
_ARCHIVES = frozenset({".zip"})
_ANNOTATION_SUFFIXES = (".zip", ".json", ".xml")
OWN_FILES_AND_FOLDERS = (FIELD_FILE, LABELS_FILE, LANDMARKS_FILE, VIEWS_FILE, FRAMES_FILE, STADIUMS_FILE)


def camera_name_remark(pictures: Iterable[str]) -> str:
    """A remark on pictures whose annotation files would bear a camera's name; empty without any.

    Args:
        pictures: file names.
    """
    found = [name for name in pictures if name.startswith(CAMERA_PREFIX)]
    if not found:
        return ""
    those = "a name" if len(found) == 1 else "names"
    more = "has" if len(found) == 1 else f"and {len(found) - 1} more have"
    return (
        f"{found[0]} {more} {those} that files of cameras have ({CAMERA_PREFIX}*): what is"
        " annotated there is not evaluated, calibrated or reported; rename pictures and their"
        " annotation files"
    )


def camera_name_remark_in(place: Path) -> str:
    """`camera_name_remark` of the pictures that belong to a folder of annotations, beside them or in the
    folder above.

    Raises:
        InputError: a folder cannot be listed.
    """
    folder = folder_of_dataset(place) if place.is_dir() else None
    return camera_name_remark(pictures_in(folder)) if folder is not None else ""


def annotation_folder(root: Path) -> Path:
    """Where annotations of a folder's pictures are: in its ``annotations/`` if that holds any JSON,
    or beside them."""
    inner = root / ANNOTATIONS_FOLDER
    return inner if json_stems(inner) else root


def frames_folder(video: Path) -> Path:
    """Where annotations and kept pictures of a video belong: ``match_frames`` beside it."""
    return video.with_name(video_frames_folder_name(video.name))


def folder_of_dataset(place: Path) -> Path | None:
    """The folder that a dataset's own things lie in, as the window keeps them: its field, its
    landmarks, its workspace; None for an archive and what is not there.

    Args:
        place: the dataset's folder, its ``annotations/``, a picture or annotation in one of them;
            a video, or the folder of one, whose frames are a dataset of their own.
    """
    if not place.is_dir():
        if not place.is_file() or place.suffix.lower() in _ARCHIVES:
            return None
        if place.suffix.lower() in VIDEO_SUFFIXES:
            return frames_folder(place)
        place = place.parent
    whole = place.resolve()
    if whole.name == ANNOTATIONS_FOLDER and not _has_own_files(place):
        return whole.parent
    of_videos = annotated_videos(place)
    return of_videos[0] if len(of_videos) == 1 else place


def _has_own_files(folder: Path) -> bool:
    """Whether a folder called ``annotations`` was worked on as a dataset itself."""
    if any((folder / name).is_file() for name in OWN_FILES_AND_FOLDERS):
        return True
    return (folder / WORKSPACE_FOLDER).is_dir() and bool(pictures_in(folder))


def annotations_of(dataset: Path) -> Path:
    """Where the annotations of a dataset are: in its ``annotations/`` if that holds any, or in it;
    for a video, or a folder of one, in ``match_frames/`` beside ``match.mp4``.

    Args:
        dataset: a folder of pictures and annotations, a folder or archive of annotations alone, an
            annotation, or a video.

    Raises:
        UsageError: a file of another kind, a video without annotations, or a folder of several
            videos with theirs.
    """
    if dataset.is_file():
        return _annotations_of_file(dataset)
    found = annotated_videos(dataset)
    if len(found) > 1:
        names = ", ".join(str(folder) for folder in found)
        raise UsageError(f"{dataset}: holds the annotations of several videos, name one: {names}")
    if found:
        return found[0]
    inner = dataset / ANNOTATIONS_FOLDER
    if holds_annotations(inner) or _holds(inner, ".xml"):
        return inner
    if _holds(inner, ".json") and not holds_annotations(dataset, deeper=False):
        return inner  # one file of another program
    return _beside_only_pictures(dataset) or dataset


def annotations_or_path(place: Path) -> Path:
    """`annotations_of` a folder or an annotated video; anything else is itself: what it holds is
    told where it is read.

    Raises:
        UsageError: a folder of several videos with their annotations.
    """
    if place.is_dir():
        return annotations_of(place)
    beside = frames_folder(place) if place.suffix.lower() in VIDEO_SUFFIXES else None
    return beside if beside is not None and holds_annotations(beside) else place


def _beside_only_pictures(dataset: Path) -> Path | None:
    """Where the annotations are of a dataset whose pictures all lie in one folder just below, if
    they are there and none is at its top."""
    if not dataset.is_dir() or _annotated_at_top(dataset):
        return None
    only = find_pictures(dataset).only_folder
    place = annotation_folder(dataset / only)
    return place if only and holds_annotations(place, deeper=False) else None


def _holds(folder: Path, suffix: str) -> bool:
    try:
        return any(suffix_of(name) == suffix for name in os.listdir(folder))
    except OSError:  # usually: no such folder
        return False


def _annotations_of_file(dataset: Path) -> Path:
    suffix = dataset.suffix.lower()
    if suffix in VIDEO_SUFFIXES:
        folder = frames_folder(dataset)
        if not holds_annotations(folder):
            raise UsageError(f"nothing to do: no annotation (*.json) in {folder}")
        return folder
    if suffix in camera_suffixes():
        raise UsageError(
            f"nothing to do: no annotation in {dataset}; it is a file of cameras by its name"
            f" ({suffix}): give the annotations"
        )
    if suffix not in _ANNOTATION_SUFFIXES:
        raise UsageError(
            f"{dataset}: is neither a folder nor an archive (.zip), nor an annotation (.json) or a"
            " video"
        )
    return dataset


def annotated_videos(folder: Path) -> list[Path]:
    """`frames_folder` of the videos in a folder, as far as they are annotated; none where the
    folder has annotations of its own."""
    try:
        names = sorted(n for n in os.listdir(folder) if suffix_of(n) in VIDEO_SUFFIXES)
    except OSError:  # usually: no such folder
        return []
    found = [f for f in (frames_folder(folder / name) for name in names) if holds_annotations(f)]
    if not found or holds_annotations(folder / ANNOTATIONS_FOLDER):
        return []
    if holds_annotations(folder, deeper=False):
        return []
    return found


def has_pictures_below(dataset: Path) -> bool:
    """Whether the pictures of a dataset, if it has any, are those of the folders below it: neither
    pictures nor annotations lie at its top. Beside annotations such folders are other things, of
    overlays for example.

    Raises:
        InputError: it cannot be listed.
    """
    if not dataset.is_dir() or pictures_in(dataset):
        return False
    return not _annotated_at_top(dataset)


def _annotated_at_top(folder: Path) -> bool:
    """Whether annotations lie in a folder itself; a list of labels that CVAT adds is none."""
    with open_source(folder) as source:
        found = list_annotations(source)
        looked_at = [] if found.in_tree else list(found.values())[:_LOOKED_INTO]
        return any(_may_be_json_object(source, file) for file in looked_at)


def _may_be_json_object(source: FileSource, file: str) -> bool:
    """Whether JSON is an object, or damaged so that nobody knows."""
    try:
        return type(msgspec.json.decode(strip_bom(source.read(file)))) is dict
    except (InputError, msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return True


def is_known_dataset(folder: Path) -> bool:
    """Whether a folder was worked on as a dataset, so that it may be looked through unasked."""
    own = any((folder / name).is_file() for name in OWN_FILES_AND_FOLDERS)
    return own or (folder / WORKSPACE_FOLDER).is_dir()


def holds_annotations(folder: Path, *, deeper: bool = True) -> bool:
    """Whether there is any annotation file in a folder, or deeper in it."""
    if not folder.is_dir():
        return False
    with open_source(folder) as source:
        found = list_annotations(source)
    return bool(found) and (deeper or not found.in_tree)


def json_stems(folder: Path) -> list[str]:
    """Names of a folder's JSON files without their suffix; none of a folder that is not there."""
    return [name[:-5] for name in json_names(folder)]


def json_names(folder: Path) -> list[str]:
    """Names of a folder's JSON files; none of a folder that is not there."""
    try:
        with os.scandir(folder) as entries:
            return [e.name for e in entries if e.name.lower().endswith(".json")]
    except OSError:  # usually: no such folder
        return []
