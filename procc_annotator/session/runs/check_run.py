"""Check the labels of many frames: here, in processes, or on a cluster."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError, ProccError
from procc_annotator.field.landmarks import field_of_frame
from procc_annotator.field.model import Field
from procc_annotator.io.source import FileSource
from procc_annotator.session.dataset.fit_sizes import FitSizes, SizesUsed
from procc_annotator.session.facts.frame_check import FrameCheck, check_frame, check_without_fit
from procc_annotator.session.runs.set_run import (
    AnnotationTask,
    FrameFile,
    SetRun,
    annotation_files,
    source_kept_open,
)

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


class CheckRun(SetRun[FrameFile, Checked, SizesUsed]):
    """One pass over a set; iterate it once.

    Attributes:
        sizes: what the frames so far were fitted at.
    """

    task: CheckFiles

    def __init__(self, source: FileSource, field: Field, sizes: FitSizes, model: str) -> None:
        task = CheckFiles(source_kept_open(source), field, sizes, model)
        super().__init__(annotation_files(source), task)
        self.sizes = SizesUsed(sizes.asked)

    def _take(self, results: Sequence[Checked], sums: SizesUsed) -> None:
        self.sizes.counts.update(sums.counts)

    def describe(self) -> str:
        """Model, field with what is its own, and size, in words."""
        field = self.task.field
        words = f"model {self.task.model}", field.title, field.own_terms, self.sizes.describe()
        return ", ".join(filter(None, words))
