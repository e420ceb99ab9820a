"""Compare two annotators' files frame by frame; one bad file never stops the set."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.soccernet_annotation import read_annotation
from procc_annotator.io.source import FileSource
from procc_annotator.metric.agreement import (
    AgreementSummary,
    AgreementSums,
    FrameAgreement,
    compare_annotations,
)
from procc_annotator.metric.setup import check_thresholds
from procc_annotator.session.runs.set_run import (
    KeptOpen,
    SetRun,
    require_annotations,
    source_kept_open,
)


@dataclass(frozen=True, slots=True)
class AgreementResult:
    """What became of one frame that both annotated.

    ``agreement`` is None where a file could not be read: ``errors`` then names it, or both, and the
    frame belongs to no figure.
    """

    name: str
    agreement: FrameAgreement | None
    errors: tuple[str, ...] = ()


class SharedFrame(NamedTuple):
    """A frame both annotated, with its file of each."""

    name: str
    file_a: str
    file_b: str


@dataclass(frozen=True)
class CompareAnnotations:
    """Compares chunks of frames."""

    a: KeptOpen[FileSource]
    b: KeptOpen[FileSource]
    field: Field
    size: tuple[int, int]

    def __call__(self, chunk: Sequence[SharedFrame]) -> tuple[list[AgreementResult], None]:
        return [self._compare(frame) for frame in chunk], None

    def close(self) -> None:
        """Close what a worker opened."""
        self.a.close()
        self.b.close()

    def _compare(self, frame: SharedFrame) -> AgreementResult:
        errors: list[str] = []
        a = self._read(self.a.opened, frame.file_a, errors)
        b = self._read(self.b.opened, frame.file_b, errors)
        if a is None or b is None:
            return AgreementResult(frame.name, None, tuple(errors))
        return AgreementResult(frame.name, compare_annotations(a, b, self.field, self.size))

    def _read(self, source: FileSource, file: str, errors: list[str]) -> FrameAnnotation | None:
        try:
            return read_annotation(source.read(file), path=source.display(file), field=self.field)
        except InputError as error:
            errors.append(str(error))
            return None


class AgreementRun(SetRun[SharedFrame, AgreementResult, None]):
    """One pass over the frames two annotators have in common; iterate, then ask for the `summary`.

    Args:
        a, b: folder or archive of annotation files of each annotator.
        field: the sports field.
        size: (width, height) in px in which distances are taken.
        thresholds: tau of the JaC, px, at least one.
        among: names of frames of b, where others are not to be compared.
        own: names of frames of a, where nothing is to be told of others.

    Attributes:
        only_a, only_b: names of the frames only one annotated: reported, not compared.

    Raises:
        UsageError: nothing to compare, a threshold that is none, or a size that is no picture.
        InputError: a folder or archive that cannot be listed.
    """

    def __init__(
        self,
        a: FileSource,
        b: FileSource,
        field: Field,
        size: tuple[int, int],
        thresholds: Sequence[float],
        among: Collection[str] | None = None,
        own: Collection[str] | None = None,
    ) -> None:
        if min(size) < 2:
            raise UsageError(f"the size {size[0]}x{size[1]} is too small")
        self.a, self.b, self.field, self.size = a, b, field, size
        self.thresholds = check_thresholds(thresholds)
        files_a, files_b = require_annotations(a), require_annotations(b)
        named = ((name, files_a.called_in(files_b, name)) for name in files_a)
        shared = {name: there for name, there in named if there is not None}
        frames = [
            SharedFrame(name, files_a[name], files_b[there])
            for name, there in shared.items()
            if (among is None or there in among) and (own is None or name in own)
        ]
        if not frames:
            raise UsageError(
                "nothing to do: no frame has annotations of both"
                f" (those in {a.path} are named like {next(iter(files_a))!r},"
                f" those in {b.path} like {next(iter(files_b))!r})"
            )
        super().__init__(
            frames, CompareAnnotations(source_kept_open(a), source_kept_open(b), field, size)
        )
        in_b = set(shared.values())
        told = (name for name in files_a if own is None or name in own)
        self.only_a = tuple(name for name in told if name not in shared)
        self.only_b = tuple(name for name in files_b if name not in in_b)
        self._sums = AgreementSums(self.thresholds, self.only_a, self.only_b)

    def _take(self, results: Sequence[AgreementResult], sums: None) -> None:
        for result in results:
            if result.agreement is not None:
                self._sums.add(result.name, result.agreement)

    def summary(self) -> AgreementSummary:
        """Figures of the frames seen so far."""
        return self._sums.summary()

    def describe(self) -> str:
        """What the numbers depend on, in words."""
        return f"{self.field.described}, {self.size[0]}x{self.size[1]}"
