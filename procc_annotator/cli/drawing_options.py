"""Options of commands that draw scored frames, and the dataset they open."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli import input_files, options
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.overlay_scene import Rendering

Threshold = Annotated[
    float, typer.Option("--threshold", "-t", metavar="PX", help="Decides the colours.")
]


@dataclass(frozen=True, kw_only=True)
class DrawingOptions:
    """What is drawn, and how it is scored."""

    annotations: input_files.Annotations = None
    labels: options.LabelsFile = None
    threshold: Threshold = options.DEFAULT_THRESHOLD
    protocol: options.Protocol = "soccernet"
    size: options.Size = "960x540"
    field: options.FieldName = None
    lines: options.Lines = None
    camera_format: options.CameraFormat = "auto"
    camera_size: options.CameraSize = None
    off_plane: options.OffPlane = "missed"
    mirrored: options.Mirrored = False

    def setup(self, dataset: Path) -> EvaluationSetup:
        """How frames are scored; raises UsageError."""
        return options.make_setup(
            self.field, self.size, self.protocol, self.off_plane, self.mirrored,
            datasets=[dataset], lines=self.lines,
        )  # fmt: skip

    def open(self, dataset: Path, setup: EvaluationSetup) -> Workspace:
        """A folder, a video or annotations alone; raises as `input_files.open_dataset`."""
        labels = options.label_map(self.labels, setup.field)
        return input_files.open_dataset(dataset, setup.field, self.annotations, labels)

    def rendering(
        self,
        workspace: Workspace,
        setup: EvaluationSetup,
        cameras: CameraSet | None,
        *,
        painted_width: bool = False,
    ) -> Rendering:
        """The frames with the cameras of a method."""
        (threshold,) = options.thresholds_or_default([self.threshold])
        return Rendering(workspace, setup, threshold, cameras, painted_width)
