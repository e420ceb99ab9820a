"""Check the labels of many frames: here, in processes, or on a cluster."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError, ProccError
from procc_annotator.field.landmarks import field_of_frame
from procc_annotator.field.model import Field
from procc_annotator.io.source import FileSource
from procc_annotator.session.dataset.fit_sizes import FitSizes, SizesUsed
from procc_annotator.session.facts.frame_check import FrameCheck, check_frame, check_without_fit
from procc_annotator.session.runs.execution.annotated_set import (
    AnnotationTask,
    FrameFile,
    annotation_files,
    each_chunk,
)
from procc_annotator.session.runs.execution.executor import Executor, InProcess

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
        given = frame.annotation, field_of_frame(self.field, frame.name)
        try:
            if not frame.fitted:
                return check_without_fit(*given, size=frame.size)
            return check_frame(*given, size=frame.size, model=self.model)
        except ProccError as error:
            return str(error)


@dataclass(frozen=True)
class CheckFiles(AnnotationTask):
    """Checks chunks of annotation files, each at its own size."""

    field: Field
    sizes: FitSizes
    model: str

    def __call__(self, chunk: Sequence[FrameFile]) -> tuple[list[Checked], SizesUsed]:
        """What was found in every frame, or why it cannot be read; and at which sizes."""
        used = SizesUsed(self.sizes.asked)
        return [(name, self._check(name, file, used)) for name, file in chunk], used

    def _check(self, name: str, file: str, used: SizesUsed) -> FrameCheck | str:
        try:
            annotation = self.read(file, self.field)
        except InputError as error:
            return str(error)
        size = self.sizes.of_frame(name, annotation)
        used.add(size)
        field = field_of_frame(self.field, name)
        return check_frame(annotation, field, size=size.fitted, model=self.model)


@dataclass
class CheckRun:
    """One pass over a set; iterate it once.

    Attributes:
        source: the annotations.
        task: how a frame is checked.
        executor: who does the work.
        sizes: what the frames so far were fitted at.
    """

    source: FileSource
    task: CheckFiles
    executor: Executor = field(default_factory=InProcess)
    sizes: SizesUsed = field(init=False)

    def __post_init__(self) -> None:
        self._files = annotation_files(self.source)
        self.sizes = SizesUsed(self.task.sizes.asked)

    @property
    def total(self) -> int:
        """Number of annotation files, i.e. of results to come."""
        return len(self._files)

    def __iter__(self) -> Iterator[Checked]:
        for results, used in each_chunk(self.executor, self.task, self._files):
            self.sizes.counts.update(used.counts)
            yield from results

    def describe(self) -> str:
        """Model, field with what is its own, and size, in words."""
        field = self.task.field
        words = f"model {self.task.model}", field.title, field.own_terms, self.sizes.describe()
        return ", ".join(filter(None, words))
