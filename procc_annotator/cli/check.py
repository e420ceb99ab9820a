"""``procc-annotator check``: find wrong labels in the annotations of a set."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.batch.label_check import CheckRun
from procc_annotator.batch.set_run import WORTH_WORKERS, annotation_files
from procc_annotator.calibration.fitting import require_known_model
from procc_annotator.calibration.label_check.finding import severity_from_name
from procc_annotator.cli import options, outputs
from procc_annotator.cli.console import stdout_console, with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.remarks import report_remarks, report_set, report_unreadable
from procc_annotator.cli.set_fits import fit_sizes
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.dataset.layout import annotations_of
from procc_annotator.report import label_check
from procc_annotator.report.label_check import CheckReport

HELP = """\
DATASET is a dataset folder, or a folder or zip archive of annotations. A camera is fitted to every
frame; elements that do not fit are reported with the correct label, the swap, or the one bad point.
Other rules need no camera: unknown classes, pixel coordinates, bent lines, two classes on one line,
elements on the wrong side, too few points, short ends, repeated points, points that are not on
paint. Frames whose labels are rotated by 180 degrees are found by comparison with the set.

error: certainly wrong; warning: probably wrong; hint: worth a look. --output writes one row per
finding: frame, severity, rule, elements, reason, suggestion, point (from 1), error in px, camera
model (empty: none), and the picture size of the px. A frame without a camera has a row with the
rule "no camera".

Exit code: 0, whatever was found; 1 with findings as severe as --fail-on, or if some annotations
were unreadable (listed); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator check sample_data --output findings.csv
  procc-annotator check sample_data/volleyball --min-severity warning
"""


def check(
    dataset: options.AnnotatedSet,
    given: options.PictureFieldOptions,
    output: options.FigureFiles = None,
    least: Annotated[
        str,
        typer.Option(
            "--min-severity", metavar="error|warning|hint", help="Leave out what is less severe."
        ),
    ] = "hint",
    fail_on: Annotated[
        str | None,
        typer.Option(
            "--fail-on",
            metavar="error|warning|hint",
            help="Exit code 1 if something at least so severe is found.",
        ),
    ] = None,
    model: options.Model = "R",
    size: options.FitSize = None,
    paint: Annotated[
        bool,
        typer.Option(
            "--line-evidence/--no-line-evidence",
            help="Look for line pixels under the elements, if there are pictures.",
        ),
    ] = True,
    workers: options.FitWorkers = None,
    dask: options.Dask = None,
) -> None:
    require_known_model(model)
    shown = severity_from_name(least)
    failing = None if fail_on is None else severity_from_name(fail_on)
    written_to = outputs.output_files(output, label_check.check_findings_suffix)
    place = annotations_of(dataset)
    known = given.of(dataset)
    with open_annotations(place, known, given.names(known)) as source:
        outputs.check_not_inputs(written_to, [source])
        sizes = fit_sizes(source, place, dataset, size)
        mismatch = report_set(source, known)
        pictures = [(name, sizes.picture_of(name)) for name, _ in annotation_files(source)]
        known = options.with_estimated_pixels(known, pictures, size)
        run = CheckRun(source, known, sizes, model, looks=paint)
        wrong = mismatch is not None and mismatch.is_whole
        with make_executor(workers, dask, frames=run.total, worth_from=WORTH_WORKERS) as executor:
            run.executor = executor
            report = label_check.check_set(
                run, with_progress, outputs=written_to, least=shown, wrong_field=wrong
            )
    _print_report(report, written_to)
    if paint and not run.seen:
        echo("no pictures next to the annotations: line evidence was not used")
    report_remarks(report.remarks)
    code = report_unreadable([problem for _, problem in report.unreadable])
    raise typer.Exit(1 if failing is not None and report.has_any(failing) else code)


def _print_report(report: CheckReport, written_to: Sequence[Path]) -> None:
    console = stdout_console()
    console.print(label_check.counts_table(report))
    if report.worth_listing:
        console.print(label_check.findings_table(report, in_file=bool(written_to)))
    for line in label_check.frames_without_camera_words(report):
        echo(line)
    for path in written_to:
        echo(f"written: {path}")
