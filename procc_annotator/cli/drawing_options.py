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


@dataclass(frozen=True, kw_only=True)
class DrawingOptions(options.ScoringOptions):
    """What is drawn, and how it is scored."""

    annotations: input_files.Annotations = None
    threshold: Annotated[
        float, typer.Option("--threshold", "-t", metavar="PX", help="Decides the colours.")
    ] = options.DEFAULT_THRESHOLD

    def open(self, dataset: Path, setup: EvaluationSetup) -> Workspace:
        """A folder, a video or annotations alone; raises as `input_files.open_dataset`."""
        return input_files.open_dataset(
            dataset, setup.field, self.annotations, self.names(setup.field)
        )

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
