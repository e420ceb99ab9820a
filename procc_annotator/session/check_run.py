"""Check the labels of every annotated frame of a set: here, in processes, or on a cluster."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.fit.fitting import fit_camera
from procc_annotator.fit.labels.check import check_labels
from procc_annotator.fit.labels.finding import Finding
from procc_annotator.io.annotation_files.soccernet_annotation import read_annotation
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.source import FileSource, open_source
from procc_annotator.session.execution.executor import Executor, InProcess

# Frames a worker takes at once: about half a second's work.
CHUNK = 16
# Below this many frames starting processes costs more than it saves.
WORTH_WORKERS = 200


@dataclass(frozen=True, slots=True)
class CheckedFrame:
    """What the check of one frame found.

    Attributes:
        name: the frame.
        findings: the surest first; empty where nothing is wrong.
        elements: number of annotated elements that have a place on the field.
        error: why its annotation cannot be read (a class that stands in it twice, for instance).
    """

    name: str
    findings: tuple[Finding, ...] = ()
    elements: int = 0
    error: str | None = None


def check_frame(
    name: str,
    annotation: FrameAnnotation,
    field: Field,
    *,
    size: tuple[int, int],
    model: str = "R",
) -> CheckedFrame:
    """Fit a camera to one annotation and check its labels with it; safe from any thread.

    Args:
        name: the frame.
        annotation: normalised points.
        field: the elements.
        size: (width, height) px of the picture that distances are told in.
        model: see `fit_camera`.
    """
    fit = fit_camera(annotation, field, model=model, size=size)
    findings = check_labels(annotation, field, size=size, fit=fit)
    known = sum(field.element(class_name) is not None for class_name in annotation.annotated)
    return CheckedFrame(name, findings, known)


def check_frames(
    frames: Iterable[tuple[str, Callable[[], FrameAnnotation]]],
    field: Field,
    *,
    size: tuple[int, int],
    model: str = "R",
    cancelled: Callable[[], bool] = lambda: False,
) -> Iterator[CheckedFrame]:
    """Check frames one after the other, in this thread.

    Args:
        frames: their names, and what reads their annotations (`Workspace.read`, for instance).
        field, size, model: as for `check_frame`.
        cancelled: asked before every frame; the rest is left out once it says so.

    Yields:
        One a frame; of a frame that cannot be read the reason.
    """
    for name, read in frames:
        if cancelled():
            return
        try:
            annotation = read()
        except InputError as error:
            yield CheckedFrame(name, error=str(error))
            continue
        yield check_frame(name, annotation, field, size=size, model=model)


@dataclass(frozen=True)
class CheckChunk:
    """Checks chunks of frames; opens the set where it is, with the first one."""

    annotations: Path
    base: Path
    field: Field
    size: tuple[int, int]
    model: str

    @cached_property
    def source(self) -> FileSource:
        """The annotations, opened once in each worker."""
        return open_source(self.annotations, self.base)

    def __call__(self, chunk: Sequence[tuple[str, str]]) -> list[CheckedFrame]:
        frames = ((name, lambda file=file: self._read(file)) for name, file in chunk)
        return list(check_frames(frames, self.field, size=self.size, model=self.model))

    def close(self) -> None:
        """Close what a worker opened."""
        source = self.__dict__.pop("source", None)
        if source is not None:
            source.__exit__(None, None, None)

    def _read(self, file: str) -> FrameAnnotation:
        return read_annotation(
            self.source.read(file), path=self.source.display(file), field=self.field
        )


@dataclass
class CheckRun:
    """One pass over a set; iterate it once.

    Attributes:
        source: the annotations.
        task: how a frame is checked.
        executor: who does the work.
    """

    source: FileSource
    task: CheckChunk
    executor: Executor = field(default_factory=InProcess)

    def __post_init__(self) -> None:
        self._files = list(list_annotations(self.source).items())
        if not self._files:
            raise UsageError(f"nothing to do: no annotation (*.json) in {self.source.path}")

    @property
    def total(self) -> int:
        """Number of annotation files, i.e. of results to come."""
        return len(self._files)

    def __iter__(self) -> Iterator[CheckedFrame]:
        chunks = (self._files[i : i + CHUNK] for i in range(0, self.total, CHUNK))
        for results in self.executor.map(self.task, chunks, name=_frames_of):
            yield from results

    def describe(self) -> str:
        """Model, field and size, in words."""
        width, height = self.task.size
        return f"model {self.task.model}, {self.task.field.title}, {width}x{height}"


def _frames_of(chunk: Sequence[tuple[str, str]]) -> str:
    return f"frames {chunk[0][0]} to {chunk[-1][0]}"
