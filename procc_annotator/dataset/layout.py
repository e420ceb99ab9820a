"""Layout of a dataset: folders of pictures and annotations, its own files, the sample copy."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

import msgspec
from natsort import natsort_keygen

from procc_annotator.dataset.database.connection import FOLDER as WORKSPACE_FOLDER
from procc_annotator.dataset.diagnostics import camera_suffixes
from procc_annotator.errors import InputError, SaveError, UsageError
from procc_annotator.formats.annotations.label_map import LABELS_FILE
from procc_annotator.formats.file_listing import ANNOTATIONS_FOLDER, CAMERA_PREFIX, list_annotations
from procc_annotator.formats.file_source import FileSource, in_folders, open_source, suffix_of, walk
from procc_annotator.formats.frame_names import PICTURE_FOLDERS
from procc_annotator.formats.landmark_file import LANDMARKS_FILE
from procc_annotator.formats.strict_json import strip_bom
from procc_annotator.image.archive import ARCHIVE_SUFFIXES, is_archive_file, pictures_in_archive
from procc_annotator.image.headers import PICTURE_SUFFIXES, VIDEO_SUFFIXES
from procc_annotator.resources import data_folder


@dataclass(frozen=True)
class PictureTree:
    """Pictures by the folders they lie in.

    Attributes:
        folders: folder below the dataset with a slash at its end, empty for the dataset's own, and
            the file names in it; both in natural order.
        in_tree: whether frames are called by their paths.
        container: the folder of a tree, with a slash at its end, that holds nothing but all the
            pictures; frames are called without it. Empty without one.
        notices: what a person should know of it.
    """

    folders: tuple[tuple[str, tuple[str, ...]], ...]
    in_tree: bool = False
    container: str = ""
    notices: tuple[str, ...] = ()

    @property
    def only_folder(self) -> str:
        """The folder that holds all pictures while frames are called without it; empty where there
        is none."""
        return self.folders[0][0] if len(self.folders) == 1 and not self.in_tree else ""

    def called(self, below: str) -> str:
        """Return what the names of the frames in one of the folders begin with."""
        return below.removeprefix(self.container) if self.in_tree else ""

    def has(self, folder: str) -> bool:
        """Return whether the names of frames begin with a folder, with a slash at its end."""
        return any(self.called(below).startswith(folder) for below, _ in self.folders)

    def frames(self) -> Iterator[tuple[str, str]]:
        """The name of each frame, and its picture below the dataset, with slashes."""
        for below, names in self.folders:
            called = self.called(below)
            for name in names:
                yield called + os.path.splitext(name)[0], below + name


def find_pictures(root: Path) -> PictureTree:
    """The pictures at the top of a folder or archive; of one without any those of the folders below
    it, where what was kept of a video does not count.

    Pictures that all lie in one folder just below are called as if they lay at the top.
    `InputError` if the folder itself cannot be listed, or the tree is too deep or too large.
    """
    unread: list[InputError] = []
    if is_archive_file(root):
        found = tuple(_in_archive(root))
    elif top := pictures_in(root):
        found = (("", tuple(top)),)
    else:
        found = tuple(_below(root, unread.append))
    if found and not found[0][0]:
        return PictureTree(found[:1])
    folders = [folder for folder, _ in found]
    container = _container(root, folders)
    rest = [folder.removeprefix(container) for folder in folders]
    in_tree = len(rest) > 1 or any(folder.count("/") > 1 for folder in rest)
    notices = tuple(f"{error}; the pictures in it are left out" for error in unread)
    return PictureTree(found, in_tree, container if in_tree else "", notices)


def _container(root: Path, folders: Sequence[str]) -> str:
    """The folder that other programs keep pictures in, if all lie in it and no annotation does:
    files of these programs leave it out."""
    known = sorted((f"{name}/" for name in PICTURE_FOLDERS), key=len, reverse=True)
    inside = (name for name in known if folders and all(f.startswith(name) for f in folders))
    found = next(inside, "")
    beside = (
        name for folder in folders if found and root.is_dir() for name in os.listdir(root / folder)
    )
    return "" if any(suffix_of(name) == ".json" for name in beside) else found


def has_pictures(root: Path) -> bool:
    """Return whether there is any picture in a folder, or below it; raises as `find_pictures`."""
    return bool(pictures_in(root)) or any(True for _ in _below(root, lambda _: None))


def _below(
    root: Path, on_unread: Callable[[InputError], None]
) -> Iterator[tuple[str, tuple[str, ...]]]:
    of_videos: set[str] = set()
    for folder, names in walk(root, on_unread):
        suffixes = {suffix_of(name) for name in names}
        if suffixes & VIDEO_SUFFIXES:
            videos = (name for name in names if suffix_of(name) in VIDEO_SUFFIXES)
            of_videos |= {f"{folder}{video_frames_folder_name(name)}/" for name in videos}
        if folder in of_videos or not suffixes & PICTURE_SUFFIXES:
            continue
        if pictures := pictures_in(root / folder):
            yield folder, tuple(pictures)


def _in_archive(path: Path) -> Iterator[tuple[str, tuple[str, ...]]]:
    names = in_folders(pictures_in_archive(path)[0])
    for folder, group in groupby(names, key=lambda name: name[: name.rfind("/") + 1]):
        yield folder, tuple(name.removeprefix(folder) for name in group)


def video_frames_folder_name(name: str) -> str:
    """Return what the folder is called that keeps annotations and pictures of a video, next to
    it."""
    return f"{os.path.splitext(name)[0]}_frames"


def pictures_in(folder: Path) -> list[str]:
    """File names of a folder's pictures, their frames in natural order; none of those below it.
    `InputError` if the folder cannot be listed."""
    try:
        with os.scandir(folder) as entries:
            names = [
                entry.name
                for entry in entries
                if suffix_of(entry.name) in PICTURE_SUFFIXES
                and not entry.name.startswith(".")
                and _is_file(entry)
            ]
    except OSError as error:
        raise InputError(folder, f"cannot be listed: {error.strerror or error}") from error
    stems = [os.path.splitext(name)[0] for name in names]
    numbered = all(stem.isascii() and stem.isdigit() for stem in stems)
    if numbered and len({(len(name), suffix_of(name)) for name in names}) < 2:
        return sorted(names)  # numbers of one length, as most are: the same order, at once
    natural = natsort_keygen()
    return sorted(names, key=lambda name: tuple(natural(p) for p in os.path.splitext(name)))


def _is_file(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_file()
    except OSError:  # a link that leads nowhere or in a circle does not end the listing
        return False


FIELD_FILE = "field.toml"
VIEWS_FILE = "views.csv"
FRAMES_FILE = "frames.csv"
STADIUMS_FILE = "stadiums.csv"

_LOOKED_INTO = 20
_ANNOTATION_SUFFIXES = (".zip", ".json", ".xml", ".csv")
OWN_FILES_AND_FOLDERS = (
    FIELD_FILE,
    LABELS_FILE,
    LANDMARKS_FILE,
    VIEWS_FILE,
    FRAMES_FILE,
    STADIUMS_FILE,
)


def camera_name_remark(pictures: Iterable[str]) -> str:
    """A remark on picture files that would give their annotation files a camera's name; empty
    without."""
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
    """`camera_name_remark` of the pictures that belong to a folder of annotations, next to them or
    in the folder above. `InputError` if a folder cannot be listed."""
    folder = folder_of_dataset(place) if place.is_dir() else None
    return camera_name_remark(pictures_in(folder)) if folder is not None else ""


def annotation_folder(root: Path) -> Path:
    """Return where annotations of a folder's pictures are: in its ``annotations/`` if that holds
    any JSON, or next to them."""
    inner = root / ANNOTATIONS_FOLDER
    return inner if json_stems(inner) else root


def frames_folder(video: Path) -> Path:
    """Return where annotations and kept pictures of a video belong: ``match_frames`` next to it."""
    return video.with_name(video_frames_folder_name(video.name))


def folder_of_dataset(place: Path) -> Path | None:
    """The folder that a dataset's own things lie in, as the window keeps them: its field, its
    landmarks, its workspace; None for an archive and what is not there.

    Args:
        place: the dataset's folder, its ``annotations/``, a picture or annotation in one of them;
            a video, or the folder of one: its frames are a dataset of their own.
    """
    if not place.is_dir():
        if not place.is_file() or place.suffix.lower() in ARCHIVE_SUFFIXES:
            return None
        if place.suffix.lower() in VIDEO_SUFFIXES:
            return frames_folder(place)
        place = place.parent
    whole = place.resolve()
    if whole.name == ANNOTATIONS_FOLDER and not (
        _has_own_files(place) or ((place / WORKSPACE_FOLDER).is_dir() and pictures_in(place))
    ):
        return whole.parent
    of_videos = annotated_videos(place)
    return of_videos[0] if len(of_videos) == 1 else place


def _has_own_files(folder: Path) -> bool:
    return any((folder / name).is_file() for name in OWN_FILES_AND_FOLDERS)


def annotations_of(dataset: Path) -> Path:
    """Return where the annotations of a dataset are: in its ``annotations/`` if that holds any, or
    in it; for a video, or a folder of one, in ``match_frames/`` next to ``match.mp4``; of a season,
    it is itself: its matches say.

    Args:
        dataset: a folder of pictures and annotations, a folder or archive of annotations alone, an
            annotation, or a video.

    Raises:
        UsageError: a file of another kind, or a video without annotations.
    """
    if dataset.is_file():
        return _annotations_of_file(dataset)
    found = annotated_videos(dataset)
    if found:
        suffixes = [suffix_of(name) for _, names in walk(dataset) for name in names]
        return found[0] if sum(map(VIDEO_SUFFIXES.__contains__, suffixes)) == 1 else dataset
    inner = dataset / ANNOTATIONS_FOLDER
    if holds_annotations(inner) or _holds(inner, ".xml"):
        return inner
    if _holds(inner, ".json") and not holds_annotations(dataset, deeper=False):
        return inner  # one file of another program
    return _beside_only_pictures(dataset) or dataset


def annotations_or_path(place: Path) -> Path:
    """`annotations_of` a folder or an annotated video; anything else is itself: what it holds is
    reported where it is read."""
    if place.is_dir():
        return annotations_of(place)
    beside = frames_folder(place) if place.suffix.lower() in VIDEO_SUFFIXES else None
    return beside if beside is not None and holds_annotations(beside) else place


def _beside_only_pictures(dataset: Path) -> Path | None:
    """Return where the annotations are of a dataset that has all its pictures in one folder just
    below, if they are there and none is at its top."""
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
    """Return whether the pictures of a dataset, if it has any, are those of the folders below it:
    neither pictures nor annotations lie at its top. Next to annotations such folders are other
    things, of overlays for example. `InputError` if it cannot be listed."""
    if not dataset.is_dir() or pictures_in(dataset):
        return False
    return not _annotated_at_top(dataset)


def _annotated_at_top(folder: Path) -> bool:
    """Return whether annotations lie in a folder itself; a list of labels that CVAT adds is
    none."""
    with open_source(folder) as source:
        found = list_annotations(source)
        looked_at = [] if found.in_tree else list(found.values())[:_LOOKED_INTO]
        return any(_may_be_json_object(source, file) for file in looked_at)


def _may_be_json_object(source: FileSource, file: str) -> bool:
    try:
        return type(msgspec.json.decode(strip_bom(source.read(file)))) is dict
    except (InputError, msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return True


def is_known_dataset(folder: Path) -> bool:
    """Return whether a folder was worked on as a dataset, so that it may be looked through
    unasked."""
    return _has_own_files(folder) or (folder / WORKSPACE_FOLDER).is_dir()


def holds_annotations(folder: Path, *, deeper: bool = True) -> bool:
    """Return whether there is any annotation file in a folder, or deeper in it."""
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


def copy_sample(sample: Path) -> Path:
    """The user's copy, below their data folder, of the sample that comes with the program; made if
    absent, wholly or not at all, else as they left it. `SaveError` if it cannot be made."""
    home = data_folder()
    if home is None:
        raise SaveError("the sample cannot be copied: there is no home folder")
    own = home / "procc-annotator" / "sample"
    if own.is_dir():
        return own
    try:
        own.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=own.parent) as begun:
            copied = Path(begun) / own.name
            shutil.copytree(sample, copied, ignore=shutil.ignore_patterns(".procc", "__pycache__"))
            os.replace(copied, own)
    except (OSError, shutil.Error) as error:
        if own.is_dir():  # another window was faster
            return own
        raise SaveError(f"{own}: the sample cannot be copied here ({error})") from error
    return own
