"""``procc-annotator propose``: a camera for every picture, without a click."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.camera_proposals import (
    ProposalRun,
    Proposer,
    WithPlugin,
    chosen_proposer,
    read_positions,
)
from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.batch.unit_store import field_settings, only_run, unfinished_path
from procc_annotator.calibration.single_image.probability import POSSIBLE_FROM, SURE_FROM
from procc_annotator.calibration.single_image.propose import propose_camera
from procc_annotator.cli import input_files, options, outputs, remarks
from procc_annotator.cli.console import stdout_console, with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.matches import annotations_of_match, for_each_match
from procc_annotator.cli.resuming import is_resuming, resumable
from procc_annotator.dataset.annotation_source import FrameAnnotations
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.season import Match
from procc_annotator.dataset.sequence import open_pictures
from procc_annotator.errors import InputError, UsageError, require_existing
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.packed import PACKED_SUFFIX
from procc_annotator.formats.file_listing import UNSURE_FOLDER
from procc_annotator.messages import pluralize
from procc_annotator.report.camera_proposals import (
    TABLE_FILE,
    ProposedSet,
    doubtful_table,
    positions_words,
    propose_for_set,
    proposed_words,
    states_table,
)

HELP = """\
DATASET is a folder of pictures, a picture, a video (frames match_000123) or a season (see track;
OUT then gets MATCH.npz and unsure/MATCH.npz). The camera is found from the line markings in the
picture. Annotated frames are skipped, unless --all.

OUT gets camera_FRAME.json for sure cameras (SoccerNet JSON in px of the picture); the others go to
OUT/unsure. proposals.csv has one row per frame: state (sure, unsure, none), probability of being
right, reason, coverage (share of the expected lines on paint), explained (share of the paint on the
field that the lines explain), residual in px, margin to the next camera, standard deviations,
seconds.

Known positions are additional hypotheses and never replace a better camera. A position on which
three frames agree, two of them sure, is used in a second search of the others. A detector is a
package that proposes cameras or labelled points (docs/examples/proposer_plugin).

Exit code: 0; 1 if some pictures or annotations were unreadable (listed); 2 if there was nothing to
do. A frame without a camera is no error.
"""

EXAMPLE = """\
  procc-annotator propose sample_data proposed/
  procc-annotator propose sample_data/shot/match.mp4 found/ --every 20
"""

# Below this many pictures starting processes costs more than it saves.
_WORTH_WORKERS = 8


@dataclass(frozen=True, kw_only=True)
class ProposeOptions:
    """Options of `propose`."""

    dataset: options.PicturesOrVideo
    out: Annotated[Path, typer.Argument(help="Folder to write the cameras to.")]
    known: Annotated[
        Path | None,
        typer.Option(
            "--known-positions",
            metavar="CAMERAS",
            help="Where cameras stand: a folder, zip or file of cameras, or positions.csv.",
        ),
    ] = None
    every_frame: Annotated[bool, typer.Option("--all", help="Also frames that are annotated.")] = (
        False
    )
    every: options.Every = 1
    detector: Annotated[
        str | None,
        typer.Option(
            "--detector",
            metavar="NAME",
            help="A detector that is installed: its cameras or points are judged among the others.",
        ),
    ] = None
    sure_from: Annotated[
        float,
        typer.Option(
            "--sure-from",
            min=POSSIBLE_FROM,
            max=1.0,
            metavar="P",
            help="Probability of being right from which on a camera is sure.",
        ),
    ] = SURE_FROM
    annotations: input_files.Annotations = None
    field_options: options.PictureFieldOptions
    camera_format: options.CameraFormat = "auto"
    workers: Annotated[
        int | None,
        typer.Option(
            "--workers",
            min=1,
            metavar="N",
            help=f"Processes that share the work.  [default: 1; from {_WORTH_WORKERS} frames one a"
            " CPU]",
        ),
    ] = None
    dask: options.Dask = None
    resume: options.Resume = False
    overwrite: options.Overwrite = False


def propose(given: ProposeOptions) -> None:
    require_existing(given.annotations, given.known)

    def of_match(match: Match) -> None:
        field = replace(given.field_options, field=match.field or given.field_options.field)
        _propose(
            replace(
                given,
                dataset=match.pictures,
                out=given.out / match.name,
                annotations=annotations_of_match(given.annotations, match),
                field_options=field,
            ),
            packed=given.out if match.name else None,
        )

    outputs.check_is_folder(given.out)
    with only_run(given.out):
        for_each_match(given.dataset, of_match)


def _propose(given: ProposeOptions, *, packed: Path | None) -> None:
    if given.detector is not None:
        chosen_proposer(given.detector)
    shown = given.field_options.of(given.dataset)
    names = given.field_options.names(shown)
    pictures = open_pictures(given.dataset, given.annotations)
    remarks.report_remarks(pictures.notices)
    left = unfinished_path(given.out, "propose")
    going_on = is_resuming(
        left, given.out / TABLE_FILE, given.out, resume=given.resume, overwrite=given.overwrite
    )
    outputs.check_camera_folder(given.out, [pictures.path, given.known])
    if not (given.overwrite or going_on):
        _require_free(given.out, pictures.frames, packed=packed is not None)
    positions = (
        () if given.known is None else read_positions(given.known, shown, given.camera_format)
    )
    annotated = None if given.every_frame else pictures.annotated(given.annotations, shown, names)
    wanted = _frames_to_propose(pictures.frames[:: given.every], shown, annotated)
    chosen = wanted.frames
    shown = options.with_estimated_pixels(
        shown, [(frame.name, frame.image_path) for frame in chosen]
    )
    proposer: Proposer = (
        partial(propose_camera, sure_from=given.sure_from)
        if given.detector is None
        else WithPlugin(given.detector, given.sure_from)
    )
    run = ProposalRun(chosen, shown, proposer, positions)
    asked = {
        "detector": given.detector or "",
        "sure from": str(given.sure_from),
        "field": field_settings(shown),
    }
    with (
        resumable(left, asked, given.out, TABLE_FILE, "sure camera", resume=going_on) as kept,
        make_executor(
            given.workers, given.dask, frames=run.total, worth_from=_WORTH_WORKERS
        ) as executor,
    ):
        run.executor, run.kept = executor, kept
        found = propose_for_set(run, given.out, with_progress, packed=packed)
    raise typer.Exit(_report(found, wanted, pictures.problems, given.out))


def _require_free(out: Path, frames: Sequence[Frame], *, packed: bool) -> None:
    names = [frame.name for frame in frames]
    there = any(outputs.holds_cameras(place, names) for place in (out, out / UNSURE_FOLDER))
    file = out.with_name(out.name + PACKED_SUFFIX)
    if there or (packed and file.exists()) or (out / TABLE_FILE).exists():
        raise UsageError(
            f"{out}: holds cameras or their table already; choose another place, or --overwrite to"
            " replace them"
        )


@dataclass(frozen=True)
class _FramesToPropose:
    """Frames to propose for, the number of annotated others, and why the annotations of the rest
    cannot be read: they may hold points."""

    frames: list[Frame]
    annotated: int = 0
    damaged: tuple[str, ...] = ()


def _frames_to_propose(
    frames: tuple[Frame, ...], field: Field, annotated: FrameAnnotations | None
) -> _FramesToPropose:
    """The frames to look at: those that no one put a point in, or all."""
    if annotated is None:
        return _FramesToPropose(list(frames))
    remarks.report_remarks(annotated.notices)
    chosen, damaged = [], []
    for frame in frames:
        try:
            found = annotated.read(frame, field)
            if found is None or not found.annotated:
                chosen.append(frame)
        except InputError as error:
            damaged.append(str(error))
    if not chosen:
        remarks.report_unreadable(damaged)
        raise UsageError("nothing to do: all frames are annotated (--all looks at them too)")
    return _FramesToPropose(chosen, len(frames) - len(chosen) - len(damaged), tuple(damaged))


def _report(
    found: ProposedSet, wanted: _FramesToPropose, problems: tuple[str, ...], out: Path
) -> int:
    console = stdout_console()
    console.print(states_table(found))
    if any(one.proposal is not None and not one.is_sure for one in found.frames):
        console.print(doubtful_table(found))
    if words := positions_words(found):
        echo(words)
    if wanted.annotated:
        echo(f"passed over: {pluralize(wanted.annotated, 'annotated frame')} (--all)")
    if wanted.damaged:
        frames = pluralize(len(wanted.damaged), "frame")
        echo(f"passed over: {frames} whose annotation cannot be read (--all)")
    echo(f"{proposed_words(found)}; written to {out}, with {TABLE_FILE}")
    return remarks.report_unreadable([*problems, *found.errors, *wanted.damaged])
