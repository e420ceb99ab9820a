"""``procc-annotator check-submission``: what the official evaluation would make of an archive."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, NoReturn

import typer

from procc_annotator.cli import options
from procc_annotator.cli.echo import echo
from procc_annotator.cli.options import chosen_field
from procc_annotator.dataset.annotation_source import open_files
from procc_annotator.dataset.layout import annotations_of
from procc_annotator.field.load import field_fingerprint
from procc_annotator.formats.cameras import submissions
from procc_annotator.formats.cameras.submissions import check_polylines, holds_manifest
from procc_annotator.formats.file_listing import list_annotations

HELP = """\
ZIP is a submission: SPLIT/camera_FRAME.json for each frame, or polylines with a manifest.json as
written by convert --to polylines. Nothing is written.

One line per finding: "refused" (the evaluation stops there), "lowers the score" or "ignored".

Exit code: 0 without findings; 1 with findings; 2 if the archive cannot be opened.
"""

EXAMPLE = """\
  procc-annotator convert sample_data/cameras/true test.zip --to submission --split test
  procc-annotator check-submission test.zip --split test
  procc-annotator convert sample_data/cameras/true lines.zip --to polylines --frames sample_data
  procc-annotator check-submission lines.zip --annotations sample_data
"""


def check_submission(
    submission: Annotated[Path, typer.Argument(metavar="ZIP", help="The archive.")],
    annotations: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR", help="The annotations it will be judged by: names missing frames."
        ),
    ] = None,
    field: options.FieldName = None,
    split: Annotated[
        str, typer.Option(metavar="NAME", help="The folder the evaluation looks into.")
    ] = "test",
) -> None:
    frames = None
    if annotations is not None:
        with open_files(annotations_of(annotations)) as source:
            frames = list_annotations(source)
    if holds_manifest(submission):
        shown = chosen_field(field, annotations)
        found = check_polylines(submission, shown, field_fingerprint(shown), frames)
        _print_findings(found, "nothing to say: every polyline will be read")
    findings = submissions.check_submission(submission, frames, split)
    _print_findings(findings, "nothing to say: the official evaluation will read every camera")


def _print_findings(findings: Sequence[submissions.SubmissionRemark], nothing: str) -> NoReturn:
    for finding in findings:
        echo(str(finding))
    if not findings:
        echo(nothing)
    raise typer.Exit(1 if findings else 0)
