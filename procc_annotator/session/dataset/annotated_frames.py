"""The annotated frames of a set, whether its pictures are there or only annotation files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.annotation_formats import read_plain
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.source import FileSource

if TYPE_CHECKING:
    from procc_annotator.session.dataset.workspace import Workspace


class AnnotatedFrames(Protocol):
    """Frames by number, and what is annotated in them."""

    @property
    def field(self) -> Field:
        """What is annotated."""

    @property
    def names(self) -> Sequence[str]:
        """Of all frames, in natural order; some may have no annotation."""

    @property
    def folders(self) -> Sequence[Path]:
        """Where nothing may be written."""

    def read(self, index: int) -> FrameAnnotation | None:
        """A frame's annotation, however short; None where nobody annotated it.

        Raises:
            InputError: its file cannot be used.
        """


class DatasetFrames:
    """Frames of a dataset with pictures, unsaved edits included."""

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        self.names = tuple(frame.name for frame in workspace.frames)

    @property
    def field(self) -> Field:
        return self._workspace.field

    @property
    def folders(self) -> tuple[Path, ...]:
        return self._workspace.own_folders

    def read(self, index: int) -> FrameAnnotation | None:
        annotation = self._workspace.read(index)
        if annotation.polylines or annotation.extra or self._workspace.has_file(index):
            return annotation
        return None


class FileFrames:
    """Frames of annotation files alone; the source stays open as long as they are read."""

    def __init__(self, source: FileSource, field: Field) -> None:
        self._source, self.field = source, field
        files = list_annotations(source)
        self.names, self._files = tuple(files), tuple(files.values())

    @property
    def folders(self) -> tuple[Path, ...]:
        return (self._source.path,) if self._source.path.is_dir() else ()

    def read(self, index: int) -> FrameAnnotation | None:
        file = self._files[index]
        return read_plain(self._source.read(file), self._source.display(file), self.field)
