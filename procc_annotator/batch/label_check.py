"""Check the labels of many frames."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.set_run import (
    AnnotationTask,
    FrameFile,
    SetRun,
    annotation_files,
    reopenable_source,
)
from procc_annotator.calibration.fitting import FitRequest, fit_cameras
from procc_annotator.calibration.label_check.check import find_opposite_frames
from procc_annotator.calibration.label_check.evidence import LineEvidence
from procc_annotator.calibration.result import FitResult
from procc_annotator.dataset.picture_sizes import FitSizes, SizesUsed
from procc_annotator.dataset.review import (
    FrameCheck,
    check_frame,
    check_with_camera_side,
    check_without_fit,
)
from procc_annotator.errors import ImageError, InputError, ProccError
from procc_annotator.field.load import field_for_frame
from procc_annotator.field.model import Field
from procc_annotator.formats.file_source import FileSource

Checked = tuple[str, FrameCheck | str]  # a frame's name; what was found, or why nothing could be


@dataclass(frozen=True)
class FrameToCheck:
    """One frame on its way to a worker.

    Attributes:
        name: of the frame.
        annotation: normalised points.
        size: (width, height) px of its picture, which distances are reported in.
        fitted: whether a camera may be fitted to it.
        picture: of which the lines are examined; None: none.
    """

    name: str
    annotation: FrameAnnotation
    size: tuple[int, int]
    fitted: bool = True
    picture: Path | None = None


@dataclass(frozen=True)
class CheckFrames:
    """Checks chunks of frames whose annotations are at hand."""

    field: Field
    model: str

    def __call__(self, chunk: Sequence[FrameToCheck]) -> list[Checked]:
        """Return what was found in every frame, or why it cannot be checked."""
        return [(frame.name, self._check(frame)) for frame in chunk]

    def _check(self, frame: FrameToCheck) -> FrameCheck | str:
        given = frame.annotation, field_for_frame(self.field, frame.name)
        try:
            paint = _line_evidence(frame.picture, *given)
            if not frame.fitted:
                return check_without_fit(*given, size=frame.size, paint=paint)
            return check_frame(*given, size=frame.size, model=self.model, paint=paint)
        except ProccError as error:
            return str(error)


@dataclass(frozen=True)
class CheckFiles(AnnotationTask):
    """Checks chunks of annotation files, each at its own size; with ``looks``, its picture too."""

    field: Field
    sizes: FitSizes
    model: str
    looks: bool = False

    def __call__(self, chunk: Sequence[FrameFile]) -> tuple[list[Checked], SizesUsed]:
        """Return what was found in every frame, or why it cannot be read; and at which sizes."""
        used = SizesUsed(self.sizes.asked)
        read = [(name, self._read(name, file, used)) for name, file in chunk]
        given = [frame for _, frame in read if not isinstance(frame, str)]
        fits = iter(fit_cameras(given, model=self.model))
        return [
            (name, frame if isinstance(frame, str) else self._check(name, frame, next(fits)))
            for name, frame in read
        ], used

    def _read(self, name: str, file: str, used: SizesUsed) -> FitRequest | str:
        try:
            annotation = self.read(file, self.field)
        except InputError as error:
            return str(error)
        size = self.sizes.of_frame(name, annotation)
        used.add(size)
        return annotation, field_for_frame(self.field, name), size.fitted

    def _check(self, name: str, given: FitRequest, fit: FitResult) -> FrameCheck:
        annotation, field, size = given
        picture = self.sizes.picture_of(name) if self.looks else None
        paint = _line_evidence(picture, annotation, field)
        return check_frame(annotation, field, size=size, model=self.model, paint=paint, fit=fit)


def _line_evidence(
    picture: Path | None, annotation: FrameAnnotation, field: Field
) -> Mapping[str, LineEvidence] | None:
    """Line evidence of a picture along the elements, by class; None without a picture."""
    if picture is None:
        return None
    # OpenCV: only where there are pictures.
    from procc_annotator.assist.line_evidence import line_evidence_by_class
    from procc_annotator.image.decoding import decode_for_camera

    try:
        return line_evidence_by_class(annotation, decode_for_camera(picture), field)
    except ImageError:
        return None  # its header or the others say its size


def with_set_findings(
    checked: Iterable[Checked], field: Field, read: Callable[[str], FrameAnnotation]
) -> dict[str, FrameCheck]:
    """The checks that get a finding once all frames of a set are examined together: which side of
    the field their cameras stand on."""
    known = {name: found for name, found in checked if isinstance(found, FrameCheck)}
    stands = {name: found.stand for name, found in known.items() if found.stand is not None}
    return {
        name: check_with_camera_side(known[name], read(name), field_for_frame(field, name), other)
        for name, other in find_opposite_frames(stands, field).items()
    }


class CheckRun(SetRun[FrameFile, Checked, SizesUsed]):
    """One pass over a set; iterate it once.

    Attributes:
        sizes: what the frames so far were fitted at.
        looks: whether pictures are examined for paint, where there are some.
        seen: frames so far whose picture was examined.
    """

    task: CheckFiles

    def __init__(
        self,
        source: FileSource,
        field: Field,
        sizes: FitSizes,
        model: str,
        *,
        looks: bool = False,
    ) -> None:
        task = CheckFiles(reopenable_source(source), field, sizes, model, looks)
        super().__init__(annotation_files(source), task)
        self.sizes = SizesUsed(sizes.asked)
        self.looks, self.seen = looks, 0

    def _take(self, results: Sequence[Checked], sums: SizesUsed) -> None:
        self.sizes.counts.update(sums.counts)
        self.seen += sum(not isinstance(found, str) and found.with_paint for _, found in results)

    def together(self, checked: Iterable[Checked]) -> list[Checked]:
        """All frames, with what they say together.

        Args:
            checked: what iterating gives.
        """
        alone, files = list(checked), dict(self.frames)
        field = self.task.field
        told = with_set_findings(alone, field, lambda name: self.task.read(files[name], field))
        return [(name, told.get(name, what)) for name, what in alone]

    def describe(self) -> str:
        """Model, field with what is its own, and size, in words."""
        field = self.task.field
        words = f"model {self.task.model}", field.title, field.own_terms, self.sizes.describe()
        return ", ".join(filter(None, words))
