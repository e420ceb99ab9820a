"""Compare two annotators' files frame by frame; one bad file never stops the set."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.soccernet_annotation import read_annotation
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.source import FileSource
from procc_annotator.metric.agreement import (
    AgreementSummary,
    AgreementSums,
    FrameAgreement,
    compare,
)
from procc_annotator.metric.setup import check_thresholds


@dataclass(frozen=True, slots=True)
class AgreementResult:
    """What became of one frame that both annotated.

    ``agreement`` is None where a file could not be read: ``errors`` then names it, or both, and the
    frame belongs to no figure.
    """

    name: str
    agreement: FrameAgreement | None
    errors: tuple[str, ...] = ()


class AgreementRun:
    """One pass over the frames two annotators have in common; iterate, then ask for the `summary`.

    Args:
        a, b: folder or archive of annotation files of each annotator.
        field: the sports field.
        size: (width, height) in px in which distances are taken.
        thresholds: tau of the JaC, px, at least one.

    Attributes:
        total: frames both annotated, i.e. results to come.
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
    ) -> None:
        if min(size) < 2:
            raise UsageError(f"the size {size[0]}x{size[1]} is too small")
        self.a, self.b, self.field, self.size = a, b, field, size
        self.thresholds = check_thresholds(thresholds)
        files_a, files_b = list_annotations(a), list_annotations(b)
        for source, files in ((a, files_a), (b, files_b)):
            if not files:
                raise UsageError(
                    f"nothing to do: no annotation (*.json) in {source.path}" + _choice(source)
                )
        self._pairs = [
            (name, file, files_b[name]) for name, file in files_a.items() if name in files_b
        ]
        if not self._pairs:
            raise UsageError(
                "nothing to do: no frame has annotations of both"
                f" (those in {a.path} are named like {next(iter(files_a))!r},"
                f" those in {b.path} like {next(iter(files_b))!r})"
            )
        self.total = len(self._pairs)
        self.only_a = tuple(name for name in files_a if name not in files_b)
        self.only_b = tuple(name for name in files_b if name not in files_a)
        self._sums = AgreementSums(self.thresholds, self.only_a, self.only_b)

    def __iter__(self) -> Iterator[AgreementResult]:
        for name, file_a, file_b in self._pairs:
            errors: list[str] = []
            annotation_a = self._read(self.a, file_a, errors)
            annotation_b = self._read(self.b, file_b, errors)
            if annotation_a is None or annotation_b is None:
                yield AgreementResult(name, None, tuple(errors))
                continue
            agreement = compare(annotation_a, annotation_b, self.field, self.size)
            self._sums.add(name, agreement)
            yield AgreementResult(name, agreement)

    def _read(self, source: FileSource, file: str, errors: list[str]) -> FrameAnnotation | None:
        try:
            return read_annotation(source.read(file), path=source.display(file), field=self.field)
        except InputError as error:
            errors.append(str(error))
            return None

    def summary(self) -> AgreementSummary:
        """Figures of the frames seen so far."""
        return self._sums.summary()

    def describe(self) -> str:
        """What the numbers depend on, in words."""
        return f"{self.field.described}, {self.size[0]}x{self.size[1]}"


def _choice(source: FileSource) -> str:
    """What to choose from where several splits lie in one place."""
    folders = source.folders()
    if len(folders) < 2:
        return ""
    return f"; it holds {len(folders)} folders ({', '.join(folders[:5])}), choose one"
