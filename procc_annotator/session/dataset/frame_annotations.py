"""What is annotated in the frames of a dataset, for commands that only read it: in files of any
format."""

from __future__ import annotations

from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import AnnotationError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.annotation_formats import read_plain
from procc_annotator.io.annotation_files.label_map import LabelMap
from procc_annotator.io.collections import AnnotationFiles, list_annotations
from procc_annotator.io.source import FileSource, read_optional
from procc_annotator.session.dataset.annotation_source import (
    ReadSource,
    open_annotations,
    own_label_map,
)
from procc_annotator.session.dataset.dataset_folder import annotations_of
from procc_annotator.session.dataset.frames import Frame


class FrameAnnotations:
    """Annotations by frame: those of this program in each frame's own file, others as they were
    read from their set.

    Attributes:
        notices: what a person should know of it.
        unknown: labels of another program that stand for no class, and how many shapes have them.
    """

    def __init__(self, source: FileSource | None = None, notices: tuple[str, ...] = ()) -> None:
        """Nothing is read yet.

        Args:
            source: where they are; None: each frame knows its own file.
        """
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
            given: a folder, archive or file of annotations, where somebody named one.
            field: knows the official names.
            names: which classes the labels of the files stand for; None: as the ``labels.toml`` of
                the dataset says, or of what was named, and where there is none they are classes.

        Raises:
            UsageError: what was named is of another sport, or holds no annotation that can be told.
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
        """What is annotated in a frame; None where it has no annotation.

        Raises:
            InputError: it cannot be read.
        """
        data = self.bytes_of(frame)
        return None if data is None else read_plain(data, self.display(frame), field)

    def bytes_of(self, frame: Frame) -> bytes | None:
        """The same as a file of this program; errors as of `read`."""
        if self._source is None:
            return read_optional(frame.annotation_path, AnnotationError)
        file = self._files.get(frame.name)
        return None if file is None else self._source.read(file)

    def has(self, frame: Frame) -> bool:
        """Whether a frame has an annotation, be it empty; not whether it can be read."""
        if self._source is None:
            return frame.annotation_path.exists()
        return frame.name in self._files

    def display(self, frame: Frame) -> str:
        """How to name a frame's annotation to a person."""
        if self._source is None:
            return str(frame.annotation_path)
        return self._source.display(self._files.get(frame.name, frame.name))


def _annotations_at(place: Path, field: Field, names: LabelMap | None) -> FrameAnnotations:
    source = open_annotations(place, field, names)
    if source.decoded or not place.is_dir():
        return FrameAnnotations(source)
    with source:
        return FrameAnnotations(notices=list_annotations(source).notices)
