"""``procc-annotator export``: the annotations of a dataset and their scores, to hand on."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli import input_files, options, outputs, remarks
from procc_annotator.cli.echo import echo
from procc_annotator.errors import UsageError
from procc_annotator.formats.frame_names import is_file_name
from procc_annotator.messages import first_names, pluralize
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.export import JAC_FILES, Exported, Scoring, export_dataset, split_scores
from procc_annotator.report.outputs import is_archive

HELP = """\
DATASET has pictures and annotations, or annotations alone, in any format that is read. OUT is a
folder or .zip with SoccerNet JSON, jac.csv and jac.json. Frames that were never annotated get no
file. Existing files are replaced only with --overwrite.

With --split OUT has the layout of the official SoccerNet evaluation, SPLIT/FRAME.json; whatever it
would stop at is left out and listed. Scores are then written next to it (match_jac.csv for
match.zip), if there are --cameras.

Exit code: 0; 1 if some files were unreadable (listed); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator export sample_data match.zip --cameras sample_data/cameras/bad -t 5 -t 2
  procc-annotator export sample_data test_json.zip --split test
"""


def export(
    dataset: input_files.Dataset,
    out: Annotated[Path, typer.Argument(help="Folder or .zip to write.")],
    given: options.ScoringOptions,
    annotations: input_files.Annotations = None,
    cameras: input_files.Cameras = None,
    threshold: options.Thresholds = None,
    keep_optional: options.KeepOptional = False,
    split: Annotated[
        str,
        typer.Option(
            "--split",
            metavar="NAME",
            help="Write what the official evaluation reads, as this split (test, valid, …).",
        ),
    ] = "",
    overwrite: options.Overwrite = False,
) -> None:
    _check_split(split, keep_optional)
    setup = given.setup(dataset)
    thresholds = options.thresholds_or_default(threshold)
    with input_files.annotated_frames(dataset, setup.field, annotations, given.labels) as (
        frames,
        source,
    ):
        camera_set = input_files.open_cameras(
            cameras, given.camera_format, given.own_size, setup.field
        )
        scoring = Scoring(setup, thresholds, camera_set)
        inputs = [one for one in (camera_set, source) if one is not None]
        outputs.check_place(out, inputs)
        scores = JAC_FILES if not split or camera_set is not None else ()
        if split and is_archive(out) and scores:
            beside = (path.name for path in split_scores(out))
            outputs.check_replaces_nothing(out.parent, beside, overwrite=overwrite)
        folder = f"{split}/" if split else ""
        names = [*(f"{folder}{name}.json" for name in frames.names), *scores]
        with outputs.replacing_nothing(out, names, "export", overwrite=overwrite):
            exported = export_dataset(
                frames, out, scoring, split=split, keep_optional=keep_optional
            )
    _print_summary(exported, setup, scored=camera_set is not None, split=split)
    raise typer.Exit(remarks.report_unreadable(exported.problems))


def _check_split(split: str, keep_optional: bool) -> None:
    if split and not is_file_name(split):
        raise UsageError(f"--split {split!r} is not the name of a folder")
    if split and keep_optional:
        raise UsageError(
            "--keep-optional does not go with --split: the official evaluation stops at elements"
            " it has no class for"
        )


def _print_summary(exported: Exported, setup: EvaluationSetup, *, scored: bool, split: str) -> None:
    written = pluralize(exported.annotations, "annotation")
    without = pluralize(exported.unannotated, "frame has", "frames have")
    place = f"{exported.path}, split {split}" if split else str(exported.path)
    echo(f"{written} written to {place} ({without} none)")
    if scored:
        for tau, figures in (exported.summary or {}).items():
            jac = "-" if figures.mean_jac is None else f"{100 * figures.mean_jac:.2f}"
            echo(
                f"JaC@{tau:g} {jac} over {pluralize(exported.scored, 'frame')}"
                f" ({setup.describe(exported.ground_only)})"
            )
        if split:
            echo(f"scores in {' and '.join(map(str, split_scores(exported.path)))}")
    elif not split:
        echo("no --cameras given: jac.csv and jac.json name the frames and hold no scores")
    if exported.others:
        held = pluralize(len(exported.others), "other annotation")
        words = f"{exported.path} holds {held}, not written now and not touched"
        remarks.report_remarks([f"{words}: {first_names(exported.others)}"])
    remarks.report_notices(exported.notices)
    remarks.report_remarks(
        f"{what} ({pluralize(frames, 'frame')})" for what, frames in exported.left_out.items()
    )
