"""Frame names: from file paths and from picture names in other files, and lookups by frame."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Container, Iterable
from pathlib import PurePosixPath
from typing import Any, TypeVar, overload

from procc_annotator.errors import AnnotationError, UsageError
from procc_annotator.formats.strict_json import json_kind, printable

PICTURE_SUFFIX = re.compile(
    r"\.(jpe?g|jfif|png|bmp|webp|tiff?|jp2|gif|avif|heic|ppm|pgm)$", re.IGNORECASE
)
# Where the published sets and other programs keep pictures.
PICTURE_FOLDERS = ("images", "images/default", "img1", "v3_frames")
_DRIVE = re.compile(r"[A-Za-z]:")
_LONGEST_PATH = 600  # of the folders above a picture


def escapes_folder(path: str) -> bool:
    """Return whether a path with slashes, as a file gives it, may lead out of the folder it belongs
    in."""
    return (
        path.startswith("/")
        or "\\" in path
        or "\0" in path
        or _DRIVE.match(path) is not None
        or ".." in path.split("/")
    )


def posix_path(path: str) -> str:
    """A path that may have been written on any system, with slashes and without ``./``."""
    return path.replace("\\", "/").removeprefix("./")


def picture_folders_of(pictures: Iterable[str]) -> frozenset[str]:
    """The folders of the pictures that one file names; none where any leads out of the dataset.
    Frames are called by their paths where there are several."""
    folders = frozenset(picture.rpartition("/")[0] for picture in pictures)
    return folders if all(map(_can_be_folder, folders)) else frozenset()


def _can_be_folder(path: str) -> bool:
    return not escapes_folder(path) and path.isprintable() and len(path) <= _LONGEST_PATH


def is_file_name(name: str) -> bool:
    """Return whether a file or folder can have a name on every system, and a terminal can show
    it."""
    return name not in ("", ".", "..") and name.isprintable() and not set(name) & set('/\\:*?"<>|')


def frame_of_file(path: str, prefix: str = "") -> str:
    """The frame that a file below a tree belongs to; `file_of_frame` is the way back.

    Args:
        path: below the dataset, with slashes: ``game/camera_00037.json``.
    """
    folder, slash, name = path.rpartition("/")
    return folder + slash + PurePosixPath(name).stem.removeprefix(prefix)


def file_of_frame(frame: str, suffix: str, prefix: str = "") -> str:
    """The path of a frame's file below a folder of such files, with slashes.

    Args:
        frame: its name: ``00037``, or ``game/00037`` in a tree.

    Raises:
        UsageError: the name leads out of that folder.
    """
    if escapes_folder(frame):
        raise UsageError(f"the frame {frame!r} leads out of the folder its file belongs in")
    folder, slash, name = frame.rpartition("/")
    return f"{folder}{slash}{prefix}{name}{suffix}"


def files_of_frames(frames: Iterable[str], suffix: str) -> dict[str, str]:
    """The files of frames that are written together, by frame.

    Raises:
        UsageError: a name leads out of the folder, or some lie at the top (or in its only folder)
            and others deeper, where they would not be looked for.
    """
    files = {frame: file_of_frame(frame, suffix) for frame in frames}
    alone = len({file.partition("/")[0] for file in files.values() if "/" in file}) == 1
    top = {frame for frame, file in files.items() if "/" not in file}
    top = top or {frame for frame, file in files.items() if alone and file.count("/") == 1}
    if top and (deeper := [frame for frame in files if frame not in top]):
        raise UsageError(
            f"the frames {min(top)!r} and {deeper[0]!r} lie at several depths, where only"
            " the first is looked for: expected all in folders of one depth"
        )
    return files


T = TypeVar("T")
D = TypeVar("D")


class ByFrame(dict[str, T]):
    """A dict that finds a name in another composition where the very name is not there.

    Iterating gives the names as they are.

    Attributes:
        picture_folders: folders that only keep pictures: a frame of a tree is found with such a
            folder in its path and without it.
        only_folder: the folder, with a slash at its end, that all files lie in while frames are
            called without it; a frame of a tree is found with it, too.
        unreadable: files of many frames that cannot be read, for all frames of folders called so.
    """

    picture_folders: tuple[str, ...] = ()
    only_folder: str = ""
    unreadable: tuple[str, ...] = ()
    _composed: tuple[int, dict[str, str]] | None = None

    def name_there(self, frame: str) -> str | None:
        """Return how a frame is called here; None where there is nothing of it."""
        if (found := self._name_of(frame)) is not None:
            return found
        if self.only_folder:
            composed, folder = (unicodedata.normalize("NFC", s) for s in (frame, self.only_folder))
            if composed.startswith(folder):
                return self.name_there(composed.removeprefix(folder))
        found = self._beside_pictures(frame) if self.picture_folders else None
        return found or next((f for f in self.unreadable if frame.startswith(f"{f}/")), None)

    def called_in(self, others: ByFrame[D], frame: str) -> str | None:
        """Return how one of these frames is called among others, where either may be called without
        the only folder it lies in; None where there is nothing of it."""
        return others.name_there(self.only_folder + frame) or others.name_there(frame)

    def _name_of(self, frame: str) -> str | None:
        """The name itself, or the one that is composed otherwise."""
        if dict.__contains__(self, frame):
            return frame
        if frame.isascii():  # composed in one way only
            return None
        if self._composed is None or self._composed[0] != len(self):
            names: dict[str, str] = {}
            for name in self:
                if not name.isascii():
                    names.setdefault(unicodedata.normalize("NFC", name), name)
            self._composed = len(self), names
        return self._composed[1].get(unicodedata.normalize("NFC", frame))

    def _beside_pictures(self, frame: str) -> str | None:
        above, slash, name = frame.rpartition("/")
        without = (
            f"{above}/".removesuffix(f"{inner}/") + name
            for inner in self.picture_folders
            if f"/{above}".endswith(f"/{inner}")
        )
        within = (f"{above}/{inner}/{name}" for inner in self.picture_folders if slash)
        found = map(self._name_of, (*without, *within))
        return next((name for name in found if name is not None), None)

    def __contains__(self, frame: object) -> bool:
        return isinstance(frame, str) and self.name_there(frame) is not None

    def __missing__(self, frame: str) -> T:
        name = self.name_there(frame)
        if name is None:
            raise KeyError(frame)
        return dict.__getitem__(self, name)

    @overload
    def get(self, frame: str, default: None = None, /) -> T | None: ...
    @overload
    def get(self, frame: str, default: T, /) -> T: ...
    @overload
    def get(self, frame: str, default: D, /) -> T | D: ...
    def get(self, frame: str, default: D | None = None, /) -> T | D | None:
        name = self.name_there(frame)
        return default if name is None else dict.__getitem__(self, name)


class FrameTable(ByFrame[T]):
    """Table by frame name, whichever folders keep the pictures."""

    picture_folders = PICTURE_FOLDERS


def frame_finder(frames: ByFrame[Any]) -> Callable[[str], str | None]:
    """Return what finds the frame that a name in a table means: the one of that name, or of a bare
    number the only one that ends in it (12: ``000012``); UsageError where several do."""
    numbers: dict[int, list[str]] = {}
    for name in frames:
        if digits := re.search(r"[0-9]+$", name):
            numbers.setdefault(int(digits[0]), []).append(name)

    def find(name: str) -> str | None:
        if name in frames or not re.fullmatch("[0-9]+", name):
            return frames.name_there(name)
        alike = numbers.get(int(name), [])
        if len(alike) > 1:
            others = ", ".join(alike[:3])
            raise UsageError(
                f"frame {name}: {len(alike)} end in this number: {others}; name it whole"
            )
        return alike[0] if alike else None

    return find


_LONGEST_NAME = 200


class PictureFrames:
    """Names of frames for the pictures of one file: by their last parts, or by their paths where
    they lie in several folders, or in one folder of the dataset's tree.

    Paths that lead out of the dataset (absolute ones, ``..``) name no folder.

    Args:
        pictures: their names, as the file gives them.
        folder: of the file, below the dataset, if that is a tree.
        there: the frames of the dataset that have a picture.
    """

    def __init__(
        self, pictures: Iterable[Any], folder: str = "", there: Container[str] = frozenset()
    ) -> None:
        paths = [posix_path(p) for p in pictures if type(p) is str]
        folders = picture_folders_of(paths)
        in_one = len(folders) == 1 and "" not in folders
        self._by_path = len(folders) > 1 or (
            in_one and any(PICTURE_SUFFIX.sub("", path) in there for path in paths)
        )
        self._folder = folder

    def frame(self, picture: Any, path: str, place: str) -> str:
        """The frame that a picture's name in the file belongs to; raises as `frame_of_picture`."""
        name = frame_of_picture(picture, path, place)
        inner = posix_path(picture).rpartition("/")[0] if self._by_path else ""
        return "/".join(part for part in (self._folder, inner.strip("/"), name) if part)


def frame_of_picture(picture: Any, path: str, place: str) -> str:
    """The frame a picture's name in a file belongs to: its last part, without the suffix.
    `AnnotationError` if it is no text, or cannot be the name of a frame."""
    if type(picture) is not str:
        raise AnnotationError(
            path,
            f"expected the name of a picture, found {json_kind(picture)}",
            place=place,
            advice="correct the name",
        )
    name = PICTURE_SUFFIX.sub("", picture_name(picture))
    if name in ("", ".", "..") or not name.isprintable() or len(name) > _LONGEST_NAME:
        raise AnnotationError(
            path,
            f"{printable(picture)!r} cannot be the name of a frame",
            place=place,
            advice="correct the name",
        )
    return name


def picture_name(path: str) -> str:
    """The last part of a path that may have been written on any system."""
    return posix_path(path).rpartition("/")[2]
