"""``procc-annotator agree``: compare two annotators of the same frames."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli import options, outputs
from procc_annotator.cli.console import stdout_console, with_progress
from procc_annotator.cli.datasets import report_like_cameras, report_mismatch, report_unreadable
from procc_annotator.cli.field_option import chosen_field
from procc_annotator.report import agreement
from procc_annotator.report.agreement import Agreed, agree_sets
from procc_annotator.report.scores.score_files import score_format
from procc_annotator.session.dataset.annotation_source import open_annotations
from procc_annotator.session.dataset.dataset_folder import annotations_of
from procc_annotator.session.runs.agreement_run import AgreementRun
from procc_annotator.words import listed

HELP = """\
A and B are dataset folders, or folders or zip archives of annotation files, paired by frame name.

Every click of one is measured against the course the other's clicks give the element, and the
reverse. The median and 95 % of all distances are the noise floor: no camera can be asked to agree
better with such clicks. The JaC is what one annotator would score if the other were a camera:
elements whose points all lie within tau / elements any of the two annotated.

Clicks beyond the other's ends (5 % of its length, at least 3 px) are left out and counted as
"beyond". An element of which the two share (almost) no stretch is "apart", and no agreement: none
of its clicks is compared, all count as "beyond". Swapped classes look like that where they meet.

Exit code: 0; 1 if some files were unreadable (listed, one line each); 2 if there was nothing to do.
"""

EXAMPLE = """
Example:

\b
  procc-annotator agree anna/annotations ben/annotations --tau 5 --tau 2 --output agreement.csv
"""


def agree(
    a: Annotated[Path, typer.Argument(help="Annotations of the first annotator.")],
    b: Annotated[Path, typer.Argument(help="Annotations of the second.")],
    threshold: Annotated[
        list[float] | None,
        typer.Option(
            "--tau",
            "--threshold",
            "-t",
            metavar="PX",
            help="A point agrees if it is closer than this many pixels; repeat for several."
            "  [default: 5]",
        ),
    ] = None,
    size: options.Size = "960x540",
    field: options.FieldName = None,
    labels: options.LabelsFile = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", metavar="FILE", help="Write every figure to a .json or .csv file."
        ),
    ] = None,
) -> None:
    if output is not None:
        score_format(output)
        outputs.check_output_folder(output)
    thresholds = options.thresholds_or_default(threshold)
    shown = chosen_field(field, a, b)
    names = options.label_map(labels, shown)
    with (
        open_annotations(annotations_of(a), shown, names) as source_a,
        open_annotations(annotations_of(b), shown, names) as source_b,
    ):
        if output is not None:
            outputs.check_not_an_input(output, (source_a, source_b))
        for source, of in ((source_a, "A: "), (source_b, "B: ")):
            report_mismatch(source, shown, of)
            report_like_cameras(source, of)
        run = AgreementRun(source_a, source_b, shown, options.parse_size(size), thresholds)
        agreed = agree_sets(run, output=output, progress=with_progress)
    _print_agreement(agreed)
    if output is not None:
        typer.echo(f"written: {output}")
    _report_frames(agreed)
    raise typer.Exit(report_unreadable(agreed.errors))


def _print_agreement(agreed: Agreed) -> None:
    console = stdout_console()
    console.print(agreement.jac_table(agreed))
    if agreed.worst:
        console.print(agreement.worst_agreement_table(agreed))
    console.print(agreement.agreement_classes_table(agreed))
    console.print(agreement.noise_floor_line(agreed))


def _report_frames(agreed: Agreed) -> None:
    """Notes on stderr: frames of one annotator only, and labels that seem to be mirrored."""
    summary = agreed.summary
    for who, names in (("A", summary.frames_only_a), ("B", summary.frames_only_b)):
        if names:
            typer.echo(f"note: only in {who}, not compared: {listed(names, 'frame')}", err=True)
    if summary.mirrored:
        typer.echo(
            "note: left and right seem to be swapped between A and B, counted as they are:"
            f" {listed(summary.mirrored, 'frame')}",
            err=True,
        )
