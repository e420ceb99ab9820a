"""``procc-annotator evaluate``: score a set of cameras against annotations."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from procc_annotator.cli import options
from procc_annotator.cli.datasets import report_notices

if TYPE_CHECKING:
    from procc_annotator.report.scoring import Scored

HELP = """Score cameras against annotations.

ANNOTATIONS and CAMERAS are folders or zip archives: 00037.json and camera_00037.json (or a
homography), directly or inside one split folder.

Exit code: 0; 1 if some files were unreadable (listed, one line each); 2 if there was nothing to do.

An unreadable annotation is listed and left out of every figure. A missing or unreadable camera
lowers the completeness. A camera without annotation is reported and not counted.
"""

EXAMPLE = """
Example:

\b
  procc-annotator evaluate annotations/ cameras.zip -t 5 -t 2 --output scores.json
"""


def evaluate(
    annotations: Annotated[Path, typer.Argument(help="Folder or zip of annotation files.")],
    cameras: Annotated[Path, typer.Argument(help="Folder or zip of camera files.")],
    threshold: options.Thresholds = None,
    protocol: options.Protocol = "soccernet",
    size: options.Size = "960x540",
    field: options.FieldName = "soccer",
    camera_format: options.CameraFormat = "auto",
    camera_size: options.CameraSize = None,
    off_plane: options.OffPlane = "missed",
    mirrored: options.Mirrored = False,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", metavar="FILE", help="Write every figure to a .json or .csv file."
        ),
    ] = None,
    workers: Annotated[
        int | None,
        typer.Option(
            min=1,
            metavar="N",
            show_default=False,
            help="Processes that share the work.  [default: 1; from 2000 frames one a CPU]",
        ),
    ] = None,
) -> None:
    from procc_annotator.cli.console import with_progress
    from procc_annotator.io.camera_collection import CameraCollection
    from procc_annotator.io.source import open_source
    from procc_annotator.report.score_files import score_format
    from procc_annotator.report.scoring import score_set

    if output is not None:
        score_format(output)
        options.check_output_folder(output)
    setup = options.make_setup(field, size, protocol, off_plane, mirrored)
    thresholds = options.thresholds_or_default(threshold)
    with (
        open_source(annotations) as annotation_source,
        open_source(cameras) as camera_source,
    ):
        if output is not None:
            options.check_not_an_input(output, (annotation_source, camera_source))
        scored = score_set(
            annotation_source,
            CameraCollection(camera_source, camera_format),
            setup,
            thresholds,
            outputs=[output] if output else [],
            camera_size=options.shown_size(camera_size),
            workers=workers or 0,
            progress=with_progress,
        )
    print_scores(scored)
    if output is not None:
        typer.echo(f"written: {output}")
    raise typer.Exit(report_problems(scored))


def print_scores(scored: Scored) -> None:
    """The tables of one set."""
    from procc_annotator.cli.console import stdout_console
    from procc_annotator.report import tables

    console = stdout_console()
    title = f"Summary of {scored.frames} frames, {scored.with_camera} with a camera"
    console.print(tables.summary_table(scored.summaries, scored.described, title=title))
    if scored.worst:
        console.print(
            tables.worst_frames_table(scored.worst, scored.first_threshold, scored.described)
        )
    console.print(tables.classes_table(scored.summaries, scored.described))


def report_problems(scored: Scored) -> int:
    """Say on stderr what could not be used; returns the exit code."""
    report_notices(scored.notices)
    if scored.unmatched_cameras:
        names = ", ".join(scored.unmatched_cameras[:5])
        more = ", ..." if len(scored.unmatched_cameras) > 5 else ""
        typer.echo(
            f"note: without annotation, not counted: {_files(len(scored.unmatched_cameras))}"
            f" ({names}{more})",
            err=True,
        )
    for error in scored.errors:
        typer.echo(f"unreadable: {error}", err=True)
    return 1 if scored.errors else 0


def _files(count: int) -> str:
    return f"{count} camera" if count == 1 else f"{count} cameras"
