"""Sizes of the pictures beside annotations, read from their headers."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from procc_annotator.errors import ImageError
from procc_annotator.image.header import require_valid_size, displayed_size
from procc_annotator.image.suffixes import PICTURE_SUFFIXES
from procc_annotator.io.annotation_files.exchange import Size
from procc_annotator.io.collections import ANNOTATIONS_FOLDER
from procc_annotator.io.frame_names import PICTURE_FOLDERS, FrameTable
from procc_annotator.regular_file import open_regular
from procc_annotator.session.dataset.dataset_folder import is_known_dataset, has_pictures_below
from procc_annotator.session.dataset.picture_names import PicturesByName
from procc_annotator.session.dataset.picture_tree import find_pictures


class PictureSizes:
    """Pictures by frame name, in the folders around a set of annotations."""

    def __init__(
        self, folders: Iterable[Path], otherwise: Size | None = None, tree: Path | None = None
    ) -> None:
        """List the pictures.

        Args:
            folders: where they may be; earlier ones count first.
            otherwise: the size of those that are not there.
            tree: a folder that is looked through, however deep, where neither pictures nor
                annotations lie at its top.
        """
        self._paths = FrameTable[Path]()
        self._names = PicturesByName(self._paths)
        self._otherwise = otherwise
        for folder in folders:
            for inner in ("", *PICTURE_FOLDERS):
                self._list(folder / inner)
        if tree is not None and has_pictures_below(tree):
            found = find_pictures(tree)
            if found.in_tree:
                self._paths.clear()
            for frame, picture in found.frames():
                self._paths.setdefault(frame, tree / picture)

    def size(self, frame: str) -> Size | None:
        """(width, height) px of a frame's picture as it is shown; None if nobody knows."""
        path = self._paths.get(self.called(frame))
        try:
            return picture_size(path) if path is not None else self._otherwise
        except ImageError:
            return self._otherwise

    def path(self, frame: str) -> Path | None:
        """A frame's picture, if there is one."""
        return self._paths.get(self.called(frame))

    def name(self, frame: str) -> str | None:
        """The file name of a frame's picture, with the path of the frame, if there is one."""
        path = self.path(frame)
        folder, slash, _ = frame.rpartition("/")
        return folder + slash + path.name if path is not None else None

    def called(self, frame: str) -> str:
        """As `PictureNames.called`."""
        return self._names.called(frame)

    def names(self) -> list[str]:
        """The names of the pictures, in a tree with their paths, in plain order."""
        return sorted(frame + path.suffix for frame, path in self._paths.items())

    def frames(self) -> list[str]:
        """The frames that have a picture."""
        return list(self._paths)

    def files(self) -> list[Path]:
        """The pictures that were found."""
        return list(self._paths.values())

    def _list(self, folder: Path) -> None:
        try:
            names = sorted(os.listdir(folder))
        except OSError:  # usually: no such folder
            return
        for name in names:
            stem, suffix = os.path.splitext(name)
            if suffix.lower() in PICTURE_SUFFIXES and not name.startswith("."):
                self._paths.setdefault(stem, folder / name)


def picture_folders(dataset: Path, annotations: Path) -> list[Path]:
    """Where the pictures of a dataset may be, the likeliest place first.

    Args:
        dataset: as the user named it: a folder, archive or file.
        annotations: what its annotations are read from: the same, or a folder in it.
    """
    found = [annotations, dataset] if dataset.is_dir() else []
    if not dataset.is_dir() or dataset.resolve().name == ANNOTATIONS_FOLDER:
        found.append(dataset.resolve().parent)
    return found


def picture_tree(dataset: Path) -> Path | None:
    """The folder below which the pictures of a dataset may lie; None where nobody named any.

    Args:
        dataset: as the user named it.
    """
    if not dataset.is_dir():
        return None
    above = dataset.resolve().parent
    if dataset.resolve().name != ANNOTATIONS_FOLDER:
        return dataset
    return above if is_known_dataset(above) else None


def picture_size(path: Path) -> Size:
    """(width, height) px of a picture as it is shown.

    Raises:
        ImageError: it is not a readable picture, or has the shape of none.
    """
    size = None
    if path.is_file():
        try:
            with open_regular(path, buffering=0) as file:
                size = displayed_size(file)
        except OSError as error:
            raise ImageError(path, f"cannot be read: {error.strerror or error}") from error
    if size is None:
        from procc_annotator.image.decode import read_size  # OpenCV: most headers tell

        size = read_size(path)
    require_valid_size(path, *size)
    return size
