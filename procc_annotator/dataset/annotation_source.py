"""Open annotations of any format; annotations of dataset frames for read-only commands;
reference frames.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import replace
from functools import partial
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.diagnostics import refuse_other_content
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.layout import annotations_of, find_pictures, folder_of_dataset
from procc_annotator.dataset.picture_sizes import PictureSizes, size_in_annotation
from procc_annotator.dataset.season import Match, annotated_matches
from procc_annotator.errors import AnnotationError, InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.exchange import ExchangedFrame
from procc_annotator.formats.annotations.label_map import LABELS_FILE, LabelMap, read_label_map
from procc_annotator.formats.annotations.registry import (
    PLAIN,
    ReadSet,
    SetReader,
    detect_formats,
    read_plain,
)
from procc_annotator.formats.annotations.soccernet import write_annotation
from procc_annotator.formats.file_listing import AnnotationFiles, list_annotations
from procc_annotator.formats.file_source import (
    FileSource,
    FolderSource,
    OpenedSource,
    from_base,
    open_source,
    read_file,
    read_optional,
)
from procc_annotator.messages import pluralize

_SUFFIX = ".json"


def open_annotations(
    path: Path, field: Field, names: LabelMap | None = None, base: Path | None = None
) -> FileSource:
    """Open annotations of any format.

    Those of this program are the very files; others look like such files, read at once and never
    written: anyone who goes over a set need not know what it was kept in.

    Args:
        path: a folder, an archive or a file, see `annotations_of`.
        names: which classes the labels of the files stand for; None: as the dataset's own
            ``labels.toml`` says, and where it has none they are classes.
        base: the folder a relative path starts from, as of `open_source`.

    Raises:
        UsageError: nothing at the path, or annotations of several formats or of another sport.
        InputError: what is there cannot be opened or listed, or none of it can be read; or the
            dataset's own ``labels.toml`` cannot be used.
    """
    place = from_base(base, path)
    with ExitStack() as opened:
        source = opened.enter_context(open_files(path, base))
        names = names or own_label_map(place, field)
        formats = [known.name for known in detect_formats(source)]
        if not formats or (PLAIN in formats and names is None):
            opened.pop_all()  # it stays open
            return source
        found = _read(source, place, field, names)
    if not found.frames:
        raise next(iter(found.unread.values()), _nothing_in(path, found))
    return ReadSource(path, found, names, partial(open_annotations, path, field, names))


def open_files(path: Path, base: Path | None = None) -> FileSource:
    """Open the files of annotations, whatever their format.

    Where their only folder is called like one that pictures of their dataset, a tree, lie in,
    frames are called by their paths as those of the tree are.

    Args, Raises: as of `open_source`; and of `annotated_matches`.
    """
    if matches := annotated_matches(from_base(base, path)):
        return SeasonSource(path, matches)
    source = open_source(path, base)
    if isinstance(source, FolderSource):
        folder, slash, _ = next(iter(source.files()), "").rpartition("/")
        root = folder_of_dataset(from_base(base, path)) if slash else None
        source.of_tree = root is not None and find_pictures(root).has(folder + slash)
    return source


class SeasonSource(OpenedSource):
    """Annotations of the matches of a season, as files of a tree: ``MATCH/FRAME.json``."""

    def __init__(self, path: Path, matches: Sequence[tuple[Match, Path]]) -> None:
        self.path = path
        self._files: dict[str, Path] = {}
        for match, place in matches:
            found = list_annotations(FolderSource(place))
            self.notices += tuple(f"{match.name}: {notice}" for notice in found.notices)
            self._files |= {f"{match.name}/{own}{_SUFFIX}": place / f for own, f in found.items()}
        self.decoded = tuple(map(str, self._files.values()))

    def files(self) -> list[str]:
        return []  # all are called by their paths

    def tree(self) -> list[str]:
        return list(self._files)

    def read(self, name: str) -> bytes:
        return read_file(self._files[name])

    def display(self, name: str) -> str:
        return str(self._files[name])

    def opener(self, base: Path) -> Callable[[], FileSource]:
        return partial(open_files, self.path, base)


def read_labels(path: Path, field: Field) -> ReadSet:
    """Annotations of any format with the labels they have in their files; arguments and errors
    are those of `open_annotations`."""
    with open_source(path) as source:
        refuse_other_content(source)
        return _read(source, path, field, None)


def _read(source: FileSource, place: Path, field: Field, names: LabelMap | None) -> ReadSet:
    sizes = PictureSizes.around(place, place)
    return SetReader(
        source, field, names, size_of=sizes.size, pictures=sizes.names(), called=sizes.called
    ).read_all()


def own_label_map(place: Path, field: Field) -> LabelMap | None:
    """The ``labels.toml`` of a dataset (a place of `folder_of_dataset`); None where it has none.
    `InputError` if it cannot be used."""
    folder = folder_of_dataset(place)
    path = None if folder is None else folder / LABELS_FILE
    return None if path is None or not os.path.lexists(path) else read_label_map(path, field)


def _nothing_in(path: Path, found: ReadSet) -> UsageError:
    said = f" ({'; '.join(found.losses)})" if found.losses else ""
    return UsageError(
        f"nothing to do: {path} is {found.title}, but no frame of it is annotated{said}"
    )


class ReadSource(OpenedSource):
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
        count = pluralize(len(found.frames), "annotated frame")
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

    def read(self, name: str) -> bytes:
        found = self._files[name]
        if isinstance(found, InputError):
            raise found
        return found

    def display(self, name: str) -> str:
        return f"{self.path}: {name.removesuffix(_SUFFIX)}"

    def opener(self, base: Path) -> Callable[[], FileSource]:
        return partial(self._opening, base=base)


def _written(frame: ExchangedFrame) -> bytes:
    annotation = frame.annotation
    # The size of the picture comes along as annotation files give it, next to their classes.
    if frame.size is not None and annotation.polylines and size_in_annotation(annotation) is None:
        width, height = frame.size
        told = (*annotation.extra, ("image_width", width), ("image_height", height))
        annotation = replace(annotation, extra=told)
    return write_annotation(annotation)


class FrameAnnotations:
    """Annotations by frame: those of this program in each frame's own file, others as they were
    read from their set.

    Attributes:
        notices: what a person should know of it.
        unknown: labels of another program that stand for no class, and how many shapes have them.
    """

    def __init__(self, source: FileSource | None = None, notices: tuple[str, ...] = ()) -> None:
        """Read nothing yet; without a source each frame knows its own file."""
        self._source = source
        self._files = AnnotationFiles() if source is None else list_annotations(source)
        self.unknown = source.unknown if isinstance(source, ReadSource) else {}
        self.notices = (*notices, *self._files.notices)

    @classmethod
    def of(
        cls, place: Path, given: Path | None, field: Field, names: LabelMap | None = None
    ) -> FrameAnnotations:
        """Look what the annotations of some pictures are kept in.

        Args:
            place: the dataset: a folder, a picture, or a video.
            given: a folder, archive or file of annotations, where a person named one.
            names: which classes the labels of the files stand for; None: as the ``labels.toml`` of
                the dataset says, or of what was named, and if absent they are classes.

        Raises:
            UsageError: what was named is of another sport, or holds no annotation that can be
                reported.
            InputError: none of the annotations can be read, or the map cannot be used.
        """
        names = names or own_label_map(place, field)
        if given is not None:
            # The folder of annotations that are to come need not exist yet.
            return _annotations_at(given, field, names) if given.exists() else cls()
        try:
            beside = annotations_of(place if place.is_dir() else place.parent)
            return _annotations_at(beside, field, names)
        except UsageError as error:  # files beside the pictures that nobody asked for
            return cls(notices=(str(error),))

    def read(self, frame: Frame, field: Field) -> FrameAnnotation | None:
        """Return what is annotated in a frame; None where it has no annotation. `InputError` if it
        cannot be read."""
        data = self.bytes_of(frame)
        return None if data is None else read_plain(data, self.display(frame), field)

    def bytes_of(self, frame: Frame) -> bytes | None:
        """The same as a file of this program; errors as of `read`."""
        if self._source is None:
            return read_optional(frame.annotation_path, AnnotationError)
        file = self._files.get(frame.name)
        return None if file is None else self._source.read(file)

    def has(self, frame: Frame) -> bool:
        """Return whether a frame has an annotation, even an empty one; not whether it can be
        read."""
        if self._source is None:
            return frame.annotation_path.exists()
        return frame.name in self._files

    def display(self, frame: Frame) -> str:
        """Return how to name a frame's annotation to a person."""
        if self._source is None:
            return str(frame.annotation_path)
        return self._source.display(self._files.get(frame.name, frame.name))


def _annotations_at(place: Path, field: Field, names: LabelMap | None) -> FrameAnnotations:
    source = open_annotations(place, field, names)
    if source.decoded or not place.is_dir():
        return FrameAnnotations(source)
    with source:
        return FrameAnnotations(notices=list_annotations(source).notices)
