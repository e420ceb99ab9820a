"""Annotations of any format, as the files of frames that commands work on."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Self

from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.annotation_formats import PLAIN, detect_formats
from procc_annotator.io.annotation_files.exchange import ExchangedFrame
from procc_annotator.io.annotation_files.label_map import LABELS_FILE, LabelMap, read_label_map
from procc_annotator.io.annotation_files.read_set import ReadSet, read_set
from procc_annotator.io.annotation_files.soccernet_annotation import write_annotation
from procc_annotator.io.source import FileSource, FolderSource, open_source
from procc_annotator.session.dataset.dataset_folder import folder_of_dataset
from procc_annotator.session.dataset.fit_sizes import size_in_annotation
from procc_annotator.session.dataset.picture_sizes import (
    PictureSizes,
    picture_folders,
    picture_tree,
)
from procc_annotator.session.dataset.picture_tree import find_pictures
from procc_annotator.session.dataset.what_lies_there import refuse_other_content
from procc_annotator.words import count_words

_SUFFIX = ".json"


def open_annotations(
    path: Path, field: Field, names: LabelMap | None = None, base: Path | None = None
) -> FileSource:
    """Open annotations of any format.

    Those of this program are the very files; others look like such files, read at once and never
    written: whoever goes over a set need not know what it was kept in.

    Args:
        path: a folder, an archive or a file, see `annotations_of`.
        field: knows the official names.
        names: which classes the labels of the files stand for; None: as the dataset's own
            ``labels.toml`` says, and where it has none they are classes.
        base: the folder a relative path starts from, as of `open_source`.

    Raises:
        UsageError: nothing at the path, or annotations of several formats or of another sport.
        InputError: what is there cannot be opened or listed, or none of it can be read; or the
            dataset's own ``labels.toml`` cannot be used.
    """
    source = open_files(path, base)
    place = path if base is None else base / path
    names = names or own_label_map(place, field)
    try:
        told = [known.name for known in detect_formats(source)]
        if not told or (PLAIN in told and names is None):
            return source
        found = _read(source, place, field, names)
    except BaseException:
        source.__exit__()
        raise
    source.__exit__()
    if not found.frames:
        raise next(iter(found.unread.values()), _nothing_in(path, found))
    return ReadSource(path, found, names, partial(open_annotations, path, field, names))


def open_files(path: Path, base: Path | None = None) -> FileSource:
    """Open the files of annotations, whatever their format.

    Where their only folder is called like one that pictures of their dataset, a tree, lie in,
    frames are called by their paths as those of the tree are.

    Args, Raises: as of `open_source`.
    """
    source = open_source(path, base)
    if isinstance(source, FolderSource):
        folder, slash, _ = next(iter(source.files()), "").rpartition("/")
        root = folder_of_dataset(path if base is None else base / path) if slash else None
        source.of_tree = root is not None and find_pictures(root).has(folder + slash)
    return source


def read_labels(path: Path, field: Field) -> ReadSet:
    """Annotations of any format with the labels they have in their files.

    Args: as of `open_annotations`.

    Raises:
        UsageError, InputError: as of `open_annotations`.
    """
    with open_source(path) as source:
        refuse_other_content(source)
        return _read(source, path, field, None)


def _read(source: FileSource, place: Path, field: Field, names: LabelMap | None) -> ReadSet:
    sizes = PictureSizes(picture_folders(place, place), tree=picture_tree(place))
    return read_set(
        source, field, names, size_of=sizes.size, pictures=sizes.names(), called=sizes.called
    )


def own_label_map(place: Path, field: Field) -> LabelMap | None:
    """The ``labels.toml`` of a dataset; None where it has none.

    Args:
        place: see `folder_of_dataset`.
        field: whose classes the labels stand for.

    Raises:
        InputError: it cannot be used.
    """
    folder = folder_of_dataset(place)
    path = None if folder is None else folder / LABELS_FILE
    return None if path is None or not os.path.lexists(path) else read_label_map(path, field)


def _nothing_in(path: Path, found: ReadSet) -> UsageError:
    said = f" ({'; '.join(found.losses)})" if found.losses else ""
    return UsageError(
        f"nothing to do: {path} is {found.title}, but no frame of it is annotated{said}"
    )


class ReadSource:
    """Annotations that were read from another format, as a source of this program's files.

    What could not be read is a file too, which cannot be read.

    Attributes:
        labels: the map that was used; None without.
        unknown: labels that stand for no class of the field, and how many shapes have them.
    """

    def __init__(
        self,
        path: Path,
        found: ReadSet,
        labels: LabelMap | None,
        opening: Callable[..., FileSource],
    ) -> None:
        count = count_words(len(found.frames), "annotated frame")
        by = f", names by {labels.path}" if labels is not None else ""
        self.path = path
        self.notices = (f"{path}: read as {found.title}, {count}{by}", *found.losses)
        self.labels = labels
        self.unknown = found.unknown
        self.decoded = tuple(found.files)
        self._opening = opening
        self._files: dict[str, bytes | InputError] = {
            f"{name}{_SUFFIX}": _written(frame) for name, frame in found.frames.items()
        }
        for name, error in found.unread.items():
            while f"{name}{_SUFFIX}" in self._files:
                name += " (again)"
            self._files[f"{name}{_SUFFIX}"] = error

    def files(self) -> list[str]:
        # Where any frame lies in a folder, all are called by their paths.
        return [] if any("/" in name for name in self._files) else list(self._files)

    def tree(self) -> list[str]:
        return list(self._files)

    def folders(self) -> list[str]:
        return []

    def read(self, name: str) -> bytes:
        found = self._files[name]
        if isinstance(found, InputError):
            raise found
        return found

    def display(self, name: str) -> str:
        return f"{self.path}: {name.removesuffix(_SUFFIX)}"

    def opener(self, base: Path) -> Callable[[], FileSource]:
        return partial(self._opening, base=base)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *failure: object) -> None:
        return None


def _written(frame: ExchangedFrame) -> bytes:
    annotation = frame.annotation
    # The size of the picture comes along as annotation files tell it, beside their classes.
    if frame.size is not None and annotation.polylines and size_in_annotation(annotation) is None:
        width, height = frame.size
        told = (*annotation.extra, ("image_width", width), ("image_height", height))
        annotation = replace(annotation, extra=told)
    return write_annotation(annotation)
