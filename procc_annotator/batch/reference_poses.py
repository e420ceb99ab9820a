"""Poses of cameras fitted to annotations: zoom and side of frames for any methods."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.audit import Pose, pose_in_degrees
from procc_annotator.batch.execution.executor import Executor
from procc_annotator.batch.set_run import (
    AnnotationTask,
    FrameFile,
    SetRun,
    annotation_files,
    reopenable_source,
)
from procc_annotator.calibration.fitting import fit_cameras
from procc_annotator.calibration.result import ill_conditioned_reason
from procc_annotator.errors import InputError
from procc_annotator.field.load import field_for_frame
from procc_annotator.formats.file_source import FileSource
from procc_annotator.metrics.setup import EvaluationSetup

MODEL = "P"  # the simplest one: most frames determine it


@dataclass(frozen=True)
class FitPoses(AnnotationTask):
    """Fits `MODEL` to chunks of annotations."""

    setup: EvaluationSetup

    def __call__(self, chunk: Sequence[FrameFile]) -> tuple[list[tuple[str, Pose | None]], None]:
        read: dict[str, FrameAnnotation] = {}
        for name, file in chunk:
            try:
                read[name] = self.read(file, self.setup.field)
            except InputError:  # the evaluation names it
                continue
        size, field = self.setup.size, self.setup.field
        given = [(clicks, field_for_frame(field, name), size) for name, clicks in read.items()]
        fits = fit_cameras(given, model=MODEL)
        return [
            (
                name,
                None
                if fit.camera is None or ill_conditioned_reason(fit)
                else pose_in_degrees(fit.camera),
            )
            for name, fit in zip(read, fits, strict=True)
        ], None


def reference_poses(
    annotations: FileSource, setup: EvaluationSetup, executor: Executor | None = None
) -> dict[str, Pose | None]:
    """Frame -> pose of the camera fitted to its annotation; None if the clicks determine none.
    Field and size of the setup count; UsageError if there is no annotation."""
    task = FitPoses(reopenable_source(annotations), setup)
    return dict(SetRun(annotation_files(annotations), task, executor))
