"""Check the labels of many frames: here, in processes, or on a cluster."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError, ProccError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.soccernet_annotation import read_annotation
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.source import FileSource, open_source
from procc_annotator.session.execution.executor import Executor, InProcess
from procc_annotator.session.frame_check import FrameCheck, check_frame, check_without_fit

# Frames a worker takes at once: about half a second's work.
CHUNK = 16
# Below this many frames starting processes costs more than it saves.
WORTH_WORKERS = 200


Checked = tuple[str, FrameCheck | str]  # a frame's name; what was found, or why nothing could be


@dataclass(frozen=True)
class FrameToCheck:
    """One frame on its way to a worker.

    Attributes:
        name: of the frame.
        annotation: normalised points.
        size: (width, height) px of its picture, which distances are told in.
        fitted: whether a camera may be fitted to it.
    """

    name: str
    annotation: FrameAnnotation
    size: tuple[int, int]
    fitted: bool = True


@dataclass(frozen=True)
class CheckFrames:
    """Checks chunks of frames whose annotations are at hand."""

    field: Field
    model: str

    def __call__(self, chunk: Sequence[FrameToCheck]) -> list[Checked]:
        """What was found in every frame, or why it cannot be checked."""
        return [(frame.name, self._check(frame)) for frame in chunk]

    def _check(self, frame: FrameToCheck) -> FrameCheck | str:
        given = frame.annotation, self.field
        try:
            if not frame.fitted:
                return check_without_fit(*given, size=frame.size)
            return check_frame(*given, size=frame.size, model=self.model)
        except ProccError as error:
            return str(error)


@dataclass(frozen=True)
class CheckFiles:
    """Checks chunks of (frame, annotation file); opens the set where it is, with the first one."""

    annotations: Path
    base: Path
    field: Field
    size: tuple[int, int]
    model: str

    @cached_property
    def source(self) -> FileSource:
        """The annotations, opened once in each worker."""
        return open_source(self.annotations, self.base)

    def __call__(self, chunk: Sequence[tuple[str, str]]) -> list[Checked]:
        """What was found in every frame, or why it cannot be read."""
        return [(name, self._check(file)) for name, file in chunk]

    def close(self) -> None:
        """Close what a worker opened."""
        source = self.__dict__.pop("source", None)
        if source is not None:
            source.__exit__(None, None, None)

    def _check(self, file: str) -> FrameCheck | str:
        try:
            annotation = read_annotation(
                self.source.read(file), path=self.source.display(file), field=self.field
            )
        except InputError as error:
            return str(error)
        return check_frame(annotation, self.field, size=self.size, model=self.model)


@dataclass
class CheckRun:
    """One pass over a set; iterate it once.

    Attributes:
        source: the annotations.
        task: how a frame is checked.
        executor: who does the work.
    """

    source: FileSource
    task: CheckFiles
    executor: Executor = field(default_factory=InProcess)

    def __post_init__(self) -> None:
        self._files = list(list_annotations(self.source).items())
        if not self._files:
            raise UsageError(f"nothing to do: no annotation (*.json) in {self.source.path}")

    @property
    def total(self) -> int:
        """Number of annotation files, i.e. of results to come."""
        return len(self._files)

    def __iter__(self) -> Iterator[Checked]:
        chunks = (self._files[i : i + CHUNK] for i in range(0, self.total, CHUNK))
        for results in self.executor.map(self.task, chunks, name=_frames_of):
            yield from results

    def describe(self) -> str:
        """Model, field and size, in words."""
        width, height = self.task.size
        return f"model {self.task.model}, {self.task.field.title}, {width}x{height}"


def _frames_of(chunk: Sequence[tuple[str, str]]) -> str:
    return f"frames {chunk[0][0]} to {chunk[-1][0]}"
