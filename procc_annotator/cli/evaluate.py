"""``procc-annotator evaluate``: score sets of cameras against annotations."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.batch.grouping import MODEL, Tags
from procc_annotator.cli import inference_options, options, outputs
from procc_annotator.cli.console import with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.evaluation_plan import (
    Plan,
    print_all,
    print_inference,
    report_problems,
    require_submitted_for,
    submitted_source,
)
from procc_annotator.cli.manifest import ManifestFile, ManifestOfRun
from procc_annotator.cli.remarks import report_remarks, report_set, report_unreadable
from procc_annotator.errors import ProccError, UsageError
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.messages import first_names, pluralize
from procc_annotator.report.scores.inference import InferenceSettings
from procc_annotator.report.scores.scoring import EvaluationRequest, Evaluations

HELP = """\
ANNOTATIONS and CAMERAS are folders or zip archives with 00037.json and camera_00037.json (or a
homography). ANNOTATIONS may also be a dataset folder, or a season (see track) with match_frames/
next to match.mp4; CAMERAS may be the output of track.

Several methods: ANNOTATIONS --cameras A=PATH --cameras B=PATH. Several sets: --set S=ANNOTATIONS
--set T=ANNOTATIONS; {set} in the PATH of cameras is replaced by the name of the set. All --size and
--threshold are evaluated; cameras without a picture size belong to --camera-size, or to the first
--size, and are scaled.

Exit code: 0; 1 if some files were unreadable (listed, one line each); 2 if there was nothing to do.

An unreadable annotation is left out of all metrics. A missing or unreadable camera lowers the
completeness. A camera without annotation is reported and not counted.
"""

EXAMPLE = """\
  procc-annotator evaluate sample_data sample_data/cameras/bad -t 5 -t 2 --output scores.json
  procc-annotator evaluate sample_data --cameras a=sample_data/cameras/pinhole \\
      --cameras b=sample_data/cameras/bad --intervals --by zoom
  procc-annotator evaluate --set soccer=sample_data --set again=sample_data \\
      --cameras 'bad=sample_data/cameras/bad' --size 960x540 --size 1280x720 --output scores.csv
"""


@dataclass(frozen=True, kw_only=True)
class EvaluateOptions:
    """Options of `evaluate`."""

    annotations: Annotated[
        Path | None,
        typer.Argument(help="Dataset folder, season, or folder or zip of annotation files."),
    ] = None
    cameras: Annotated[Path | None, typer.Argument(help="Folder or zip of camera files.")] = None
    sets: Annotated[
        list[str] | None,
        typer.Option(
            "--set", metavar="NAME=ANNOTATIONS", help="A set of annotations; repeat for several."
        ),
    ] = None
    sources: options.Sources = None
    threshold: options.Thresholds = None
    protocol: options.Protocol = "soccernet"
    size: Annotated[
        list[str] | None,
        typer.Option(
            "--size",
            metavar="WxH",
            callback=options.checked_size,
            help="Picture size at which everything is compared; repeat for several."
            "  [default: 960x540]",
        ),
    ] = None
    field_options: options.FieldOptions
    camera_format: options.CameraFormat = "auto"
    camera_size: options.CameraSize = None
    off_plane: options.OffPlane = "missed"
    planar_only: options.PlanarOnly = False
    mirrored: options.Mirrored = False
    tags: inference_options.TagsFile = None
    by: Annotated[
        list[str] | None,
        typer.Option(
            metavar="TAG|model|zoom|elements|spread|side|shot",
            help="Also the figures by this tag, or by the model of the camera; with intervals by"
            " zoom, number of elements, how much of the picture they enclose, the camera's side"
            " and shot; zoom and side are those of a pinhole fitted to each annotation; repeat for"
            " several.  [default: every tag of --tags]",
        ),
    ] = None
    intervals: Annotated[
        bool,
        typer.Option(
            "--intervals",
            help="Also 95 % intervals of all figures and, of several sources, their differences on"
            " the frames both have, with a permutation test, and ranks.",
        ),
    ] = False
    chance: inference_options.IntervalOptions
    seed: inference_options.Seed = inference_options.USUAL_SEED
    submission: Annotated[
        Path | None,
        typer.Option(
            "--submission",
            metavar="ZIP",
            help="A submission of polylines in place of CAMERAS; one that was made for another"
            " protocol, field, size or other frames is refused.",
        ),
    ] = None
    output: options.FigureFiles = None
    manifest: ManifestFile = None
    steady: inference_options.OverTime = False
    shots: inference_options.Shots = None
    pictures: Annotated[
        Path | None,
        typer.Option(
            "--pictures",
            metavar="PATH",
            help="Folder of the pictures or video of the set: cuts are found in it, and cameras"
            " held against what moves in it.",
        ),
    ] = None
    over_time_output: Annotated[
        list[Path] | None,
        typer.Option(
            "--over-time-output",
            metavar="FILE",
            help="Write the figures over time: a .json of all, or a .csv with a row a frame; repeat"
            " for both.",
        ),
    ] = None
    workers: options.Workers = None
    dask: options.Dask = None


def evaluate(context: typer.Context, given: EvaluateOptions) -> None:
    # Everything is examined before any work.
    written_to = outputs.output_files(given.output)
    manifest = ManifestOfRun.of(context, given.manifest)
    plan = _plan(given)
    fields = plan.fields()
    field = next(iter(fields.values()))
    terms = given.protocol, given.off_plane, given.mirrored, given.planar_only
    sizes = dict.fromkeys(given.size or [options.DEFAULT_SIZE])
    setups = [options.setup_for(field, size, *terms) for size in sizes]
    if given.submission is not None:
        require_submitted_for(given.submission, setups[0], plan.frames(fields))
    thresholds = options.thresholds_or_default(given.threshold)
    tags = None if given.tags is None else Tags.read(given.tags)
    by, settings = _inference(given, plan, tags)
    noise = inference_options.noise_file(given.chance.click_noise)
    outputs.check_not_inputs(written_to, filter(None, (given.tags, noise, given.shots)))
    over_time = inference_options.temporal_request(
        given.steady, given.shots, given.pictures, given.over_time_output
    )
    unwritten: dict[Path, ProccError] = {}  # a file that cannot be written loses no metrics
    with ExitStack() as files:
        requests = plan.open(
            files, fields, setups, by, tags, camera_size=options.shown_size(given.camera_size)
        )
        _check_inputs(requests, plan, given, [*written_to, *(over_time.written_to if over_time
                      else ()), *([manifest.path] if manifest else ())])  # fmt: skip
        evaluations = Evaluations(
            requests, thresholds, [*written_to, *([manifest.metrics] if manifest else [])],
            named=plan.named or len(setups) > 1, settings=settings,
        )  # fmt: skip
        with make_executor(given.workers, given.dask, frames=evaluations.frames) as executor:
            steady = over_time.run(requests, thresholds[0], executor) if over_time else []
            scored = evaluations.score(executor, with_progress, unwritten)
        if manifest is not None:
            manifest.write(requests, over_time.entries(steady) if over_time and steady else None)
    if over_time is not None:  # before the tables: a reader may stop after the first (`| head`)
        over_time.write(steady, unwritten)
    print_all(scored)
    print_inference(evaluations.results)
    for path in (*written_to, *([manifest.path] if manifest else [])):
        if path not in unwritten:
            echo(f"written: {path}")
    if tags is not None:
        report_remarks(_tags_of_no_frame(tags, plan.frames(fields)))
    report_remarks(plan.remarks(fields, [setup.size for setup in setups]))
    code = report_problems(scored)
    if over_time is not None:
        over_time.show(steady, unwritten)
        known = {error for one in scored for error in one.errors}
        errors = dict.fromkeys(error for one in steady for error in one.errors)
        code = max(code, report_unreadable([line for line in errors if line not in known]))
    for failure in unwritten.values():
        echo(f"procc-annotator: {failure}", err=True)
    raise typer.Exit(2 if unwritten else code)


def _plan(given: EvaluateOptions) -> Plan:
    cameras, sources = given.cameras, given.sources or []
    if given.submission is not None:
        cameras, sources = None, [*sources, submitted_source(given.submission)]
    return Plan.of(
        given.annotations, cameras, given.sets or [], sources, given.camera_format,
        given.field_options,
    )  # fmt: skip


def _inference(
    given: EvaluateOptions, plan: Plan, tags: Tags | None
) -> tuple[tuple[str, ...], InferenceSettings | None]:
    """The keys to group frames by, and the settings of intervals, if anything needs them."""
    chance = given.chance
    by, derived = inference_options.groups_asked(given.by, tags, chance.cluster)
    needed = derived or chance.click_noise is not None or chance.cluster is not None
    if needed or given.intervals or chance.power:
        parts = [name for name in (*by, *derived) if name != MODEL]
        return by, chance.terms(tags, dict(plan.sets), parts, given.seed, given.shots)
    if (chance.interval_method, chance.draws, given.seed) != inference_options.USUAL:
        raise UsageError("--interval-method, --resamples and --seed need --intervals or the like")
    return by, None


def _check_inputs(
    requests: Sequence[EvaluationRequest],
    plan: Plan,
    given: EvaluateOptions,
    written_to: Sequence[Path],
) -> None:
    """Report doubtful annotations; refuse outputs that are among the inputs."""
    for one in {one.set_name: one for one in requests}.values():
        of = f"{one.set_name}: " if len(plan.sets) > 1 else ""
        report_set(one.annotations, one.setup.field, of)
    inputs: list[outputs.Input] = [s for one in requests for s in (one.annotations, one.cameras)]
    outputs.check_not_inputs(written_to, [*inputs, *([given.tags] if given.tags else [])])


def _tags_of_no_frame(tags: Tags, frames: Mapping[str, tuple[str, ...]]) -> list[str]:
    """Return the remark on rows of the file of tags whose frame is annotated in none of the
    sets."""
    there: dict[str | None, FrameTable[str]]
    there = {of_set: _table(names) for of_set, names in frames.items()}
    there[None] = _table(chain.from_iterable(frames.values()))
    strange = [frame for of_set, frame in tags.rows if frame not in there.get(of_set, ())]
    if not strange:
        return []
    rows = pluralize(len(strange), "row")
    return [f"{tags.path}: {rows} of no annotated frame ({first_names(strange)})"]


def _table(names: Iterable[str]) -> FrameTable[str]:
    return FrameTable((name, name) for name in names)
