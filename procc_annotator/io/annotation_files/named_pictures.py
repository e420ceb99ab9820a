"""Which frame a picture means that a file of another program names."""

from __future__ import annotations

from collections.abc import Container, Iterable
from typing import Any

from procc_annotator.errors import AnnotationError
from procc_annotator.io.frame_names import PICTURE_SUFFIX, picture_folders_of, posix_path
from procc_annotator.io.json_text import json_kind, printable

_LONGEST_NAME = 200


class PictureFrames:
    """How the pictures of one file are called as frames: by their last parts, or by their paths
    where they lie in several folders, or in one folder of the dataset's tree.

    Paths that lead out of the dataset (absolute ones, ``..``) tell no folder.

    Args:
        pictures: their names, as the file tells them.
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

    Raises:
        AnnotationError: it is no text, or cannot be the name of a frame.
    """
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
