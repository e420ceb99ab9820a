"""``procc-annotator export``: the annotations of a dataset and their scores, to hand on."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli import datasets, options, outputs
from procc_annotator.report.export import JAC_FILES, Scoring, export_dataset
from procc_annotator.words import count_of

HELP = """\
OUT is a folder, or an archive if it ends in .zip. Without --cameras the score files list the frames
and say that there was nothing to score. Frames that were never annotated get no file.
Files that are there already are replaced only with --overwrite.

Exit code: 0; 1 if some files were unreadable (listed); 2 if there was nothing to do.
"""

EXAMPLE = """
Example:

\b
  procc-annotator export match/ match.zip --cameras predictions/ -t 5 -t 2
"""


def export(
    dataset: datasets.Dataset,
    out: Annotated[Path, typer.Argument(help="Folder or .zip to write.")],
    annotations: datasets.Annotations = None,
    cameras: datasets.Cameras = None,
    threshold: options.Thresholds = None,
    protocol: options.Protocol = "soccernet",
    size: options.Size = "960x540",
    field: options.FieldName = None,
    lines: options.Lines = None,
    camera_format: options.CameraFormat = "auto",
    camera_size: options.CameraSize = None,
    off_plane: options.OffPlane = "missed",
    mirrored: options.Mirrored = False,
    keep_optional: options.KeepOptional = False,
    overwrite: options.Overwrite = False,
) -> None:
    setup = options.make_setup(
        field, size, protocol, off_plane, mirrored, datasets=[dataset], lines=lines
    )
    thresholds = options.thresholds_or_default(threshold)
    workspace = datasets.open_dataset(dataset, setup.field, annotations)
    camera_set = datasets.open_cameras(cameras, camera_format, options.shown_size(camera_size))
    outputs.check_place(out, [camera_set] if camera_set is not None else [])
    names = [*(f"{frame.name}.json" for frame in workspace.frames), *JAC_FILES]
    outputs.check_replaces_nothing(out, names, overwrite=overwrite)
    exported = export_dataset(
        workspace, out, Scoring(setup, thresholds, camera_set), keep_optional=keep_optional
    )
    written = count_of(exported.annotations, "annotation")
    without = count_of(exported.unannotated, "frame has", "frames have")
    typer.echo(f"{written} written to {out} ({without} none)")
    if camera_set is None:
        typer.echo("no --cameras given: jac.csv and jac.json name the frames and hold no scores")
    else:
        for tau, figures in (exported.summary or {}).items():
            jac = "-" if figures.mean_jac is None else f"{100 * figures.mean_jac:.2f}"
            typer.echo(
                f"JaC@{tau:g} {jac} over {count_of(exported.scored, 'frame')}"
                f" ({setup.describe(exported.ground_only)})"
            )
    datasets.report_notices(exported.notices)
    datasets.report_remarks(
        f"{what} ({count_of(frames, 'frame')})" for what, frames in exported.left_out.items()
    )
    raise typer.Exit(datasets.report_unreadable(exported.problems))
