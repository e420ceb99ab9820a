"""Work on every annotation file of a set, a chunk of frames at a time."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TypeVar

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.soccernet_annotation import read_annotation
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.source import FileSource, open_source
from procc_annotator.io.strays import require_lists
from procc_annotator.session.runs.execution.executor import Executor

# Frames a worker takes at once where each gets a fit: about half a second's work.
CHUNK = 16
# Below this many fits starting processes costs more than it saves.
WORTH_WORKERS = 200

FrameFile = tuple[str, str]  # a frame's name, and its annotation file in the source
R = TypeVar("R")


@dataclass(frozen=True)
class AnnotationTask:
    """Base of tasks on chunks of annotation files; opens the set where it is, with the first one.

    Attributes:
        annotations: folder or archive.
        base: what it is relative to, and paths in messages too.
    """

    annotations: Path
    base: Path

    @cached_property
    def source(self) -> FileSource:
        """The annotations, opened once in each worker."""
        return open_source(self.annotations, self.base)

    def read(self, file: str, field: Field) -> FrameAnnotation:
        """The annotation in a file of the source.

        Raises:
            InputError: it cannot be used.
        """
        data, shown = self.source.read(file), self.source.display(file)
        annotation = read_annotation(data, path=shown, field=field)
        require_lists(annotation, shown)
        return annotation

    def close(self) -> None:
        """Close what a worker opened."""
        source = self.__dict__.pop("source", None)
        if source is not None:
            source.__exit__(None, None, None)


def annotation_files(source: FileSource) -> list[FrameFile]:
    """The frames of a set with their files.

    Raises:
        UsageError: there are none.
    """
    files = list(list_annotations(source).items())
    if not files:
        raise UsageError(f"nothing to do: no annotation (*.json) in {source.path}")
    return files


def each_chunk(
    executor: Executor, task: Callable[[Sequence[FrameFile]], R], files: Sequence[FrameFile]
) -> Iterator[R]:
    """What a task makes of each chunk of the frames, in their order."""
    chunks = (files[i : i + CHUNK] for i in range(0, len(files), CHUNK))
    return executor.map(task, chunks, name=_first_to_last)


def _first_to_last(chunk: Sequence[FrameFile]) -> str:
    return first_to_last(chunk[0][0], chunk[-1][0])


def first_to_last(first: str, last: str) -> str:
    """How a chunk of frames is called where something happens to its worker."""
    return f"frames {first} to {last}"
