"""The pictures of a dataset, in its folder or in a tree of folders below it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from natsort import natsort_keygen

from procc_annotator.errors import InputError
from procc_annotator.image.suffixes import PICTURE_SUFFIXES, VIDEO_SUFFIXES
from procc_annotator.io.folders import walk
from procc_annotator.io.frame_names import PICTURE_FOLDERS


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
        """What the names of the frames in one of the folders begin with."""
        return below.removeprefix(self.container) if self.in_tree else ""

    def has(self, folder: str) -> bool:
        """Whether the names of frames begin with a folder, with a slash at its end."""
        return any(self.called(below).startswith(folder) for below, _ in self.folders)

    def frames(self) -> Iterator[tuple[str, str]]:
        """The name of each frame, and its picture below the dataset, with slashes."""
        for below, names in self.folders:
            called = self.called(below)
            for name in names:
                yield called + os.path.splitext(name)[0], below + name


def find_pictures(root: Path) -> PictureTree:
    """The pictures at the top of a folder; of a folder without any those of the folders below it,
    where what was kept of a video does not count.

    Pictures that all lie in one folder just below are called as if they lay at the top.

    Raises:
        InputError: the folder itself cannot be listed, or the tree is too deep or too large.
    """
    if top := pictures_in(root):
        return PictureTree((("", tuple(top)),))
    unread: list[InputError] = []
    found = tuple(_below(root, unread.append))
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
    beside = (name for folder in folders if found for name in os.listdir(root / folder))
    return "" if any(suffix_of(name) == ".json" for name in beside) else found


def has_pictures(root: Path) -> bool:
    """Whether there is any picture in a folder, or below it.

    Raises:
        InputError: as of `find_pictures`.
    """
    return bool(pictures_in(root)) or any(True for _ in _below(root, lambda _: None))


def _below(
    root: Path, on_unread: Callable[[InputError], None]
) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Folders below a place that hold pictures, with these; those kept of videos left out."""
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


def video_frames_folder_name(name: str) -> str:
    """What the folder is called that keeps annotations and pictures of a video, beside it."""
    return f"{os.path.splitext(name)[0]}_frames"


def suffix_of(name: str) -> str:
    """Of a file's name, in small letters."""
    return os.path.splitext(name)[1].lower()


def pictures_in(folder: Path) -> list[str]:
    """File names of a folder's pictures, their frames in natural order; none of those below it.

    Raises:
        InputError: the folder cannot be listed.
    """
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
    if len({(len(name), suffix_of(name)) for name in names}) < 2 and _only_numbers(names):
        return sorted(names)  # numbers of one length, as most are: the same order, at once
    natural = natsort_keygen()
    return sorted(names, key=lambda name: tuple(natural(p) for p in os.path.splitext(name)))


def _only_numbers(names: Iterable[str]) -> bool:
    return all(name.isascii() and os.path.splitext(name)[0].isdigit() for name in names)


def _is_file(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_file()
    except OSError:  # a link that leads nowhere or in a circle does not end the listing
        return False
