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
from procc_annotator.cli import inference_options, options, outputs, temporal_options
from procc_annotator.cli.console import with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.evaluation_plan import (
    Plan,
    Submission,
    print_all,
    print_inference,
    report_problems,
    require_submitted_for,
    submitted_source,
)
from procc_annotator.cli.manifest_option import ManifestFile, ManifestOfRun
from procc_annotator.cli.remarks import (
    report_camera_names,
    report_mismatch,
    report_remarks,
    report_unreadable,
)
from procc_annotator.errors import ProccError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.messages import first_names, pluralize
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.scores.inference import InferenceSettings, StatisticalResult
from procc_annotator.report.scores.scoring import Evaluations, RequestedOutputs, Scored
from procc_annotator.report.temporal import TemporalMetrics

HELP = """\
ANNOTATIONS and CAMERAS are folders or zip archives: 00037.json and camera_00037.json (or a
homography), directly or inside one split folder. ANNOTATIONS may also be a dataset folder, with
its annotations beside the pictures or in annotations/.

Several methods on one set: ANNOTATIONS --cameras A=PATH --cameras B=PATH. Several sets: --set
S=ANNOTATIONS --set T=ANNOTATIONS instead of ANNOTATIONS; every method is scored on every set, and
{set} in the PATH of its cameras stands for the name of the set. Several --size and --threshold are
all evaluated; cameras whose files name no picture size belong to the first --size, unless
--camera-size says otherwise, and are scaled to the others.

Exit code: 0; 1 if some files were unreadable (listed, one line each); 2 if there was nothing to do.

An unreadable annotation is listed and left out of every figure. A missing or unreadable camera
lowers the completeness. A camera without annotation is reported and not counted.
"""

EXAMPLE = """
Example:

\b
  procc-annotator evaluate annotations/ cameras.zip -t 5 -t 2 --output scores.json
  procc-annotator evaluate --set wc14=wc14/annotations --set ts=ts/annotations \\
      --cameras 'pnl={set}/pnlcalib' --cameras 'nbjw:wc14={set}/nbjw.zip' \\
      --size 960x540 --size 1280x720 --output scores.csv
  procc-annotator evaluate annotations/ cameras/ --tags stadiums.csv --by stadium --by model
"""


Annotations = Annotated[
    Path | None,
    typer.Argument(
        show_default=False, help="Dataset folder, or folder or zip of annotation files."
    ),
]
Cameras = Annotated[
    Path | None, typer.Argument(show_default=False, help="Folder or zip of camera files.")
]
Sets = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="NAME=ANNOTATIONS",
        show_default=False,
        help="A set of annotations; repeat for several.",
    ),
]
By = Annotated[
    list[str] | None,
    typer.Option(
        metavar="TAG|model|zoom|elements|spread|side|shot",
        show_default=False,
        help="Also the figures by this tag, or by the model of the camera; with intervals by zoom,"
        " number of elements, how much of the picture they enclose, the camera's side and shot;"
        " zoom and side are medians of the methods compared; repeat for several."
        "  [default: every tag of --tags]",
    ),
]


@dataclass(frozen=True)
class _EvaluateRequest:
    """A call as it was read.

    Attributes:
        fields: of each set.
        setups: one a picture size.
        by: what to group frames by.
        written_to: files of figures.
        manifest: of this run, if it is to be written.
        over_time: what is asked over the shots of the sets, if anything.
    """

    plan: Plan
    fields: Mapping[str, Field]
    setups: Sequence[EvaluationSetup]
    thresholds: tuple[float, ...]
    tags: Tags | None
    by: tuple[str, ...]
    camera_size: tuple[int, int] | None
    written_to: Sequence[Path]
    manifest: ManifestOfRun | None
    over_time: temporal_options.TemporalRequest | None
    chance: InferenceSettings | None


@dataclass(frozen=True, kw_only=True)
class EvaluateOptions:
    """Options of `evaluate`."""

    annotations: Annotations = None
    cameras: Cameras = None
    sets: Sets = None
    sources: options.Sources = None
    threshold: options.Thresholds = None
    protocol: options.Protocol = "soccernet"
    size: options.Sizes = None
    field: options.FieldName = None
    lines: options.Lines = None
    labels: options.LabelsFile = None
    camera_format: options.CameraFormat = "auto"
    camera_size: options.CameraSize = None
    off_plane: options.OffPlane = "missed"
    planar_only: options.PlanarOnly = False
    mirrored: options.Mirrored = False
    tags: inference_options.TagsFile = None
    by: By = None
    intervals: inference_options.Intervals = False
    chance: inference_options.IntervalOptions
    seed: inference_options.Seed = inference_options.USUAL_SEED
    submission: Submission = None
    output: options.FigureFiles = None
    manifest: ManifestFile = None
    steady: temporal_options.OverTime = False
    shots: temporal_options.Shots = None
    pictures: temporal_options.Pictures = None
    over_time_output: temporal_options.Output = None
    workers: options.Workers = None
    dask: options.Dask = None


def evaluate(context: typer.Context, given: EvaluateOptions) -> None:
    call = _request_of(context, given)
    # The figures took long to make: a file that cannot be written must not take them along.
    unwritten: dict[Path, ProccError] = {}
    scored, told, steadiness = _score(call, given.workers, given.dask, unwritten)
    if call.over_time is not None:  # before the tables: whoever reads them may stop after the first
        call.over_time.write(steadiness, unwritten)
    code = _print_results(call, scored, told, unwritten)
    if call.over_time is not None:
        call.over_time.tell(steadiness, unwritten)
        known = {error for one in scored for error in one.errors}
        code = max(code, report_unreadable(temporal_options.errors(steadiness, known)))
    for failure in unwritten.values():
        echo(f"procc-annotator: {failure}", err=True)
    raise typer.Exit(2 if unwritten else code)


def _request_of(context: typer.Context, given: EvaluateOptions) -> _EvaluateRequest:
    """Return what is to be done; all that was given is examined before anything is."""
    written_to = outputs.figure_files(given.output)
    manifest = ManifestOfRun.of(context, given.manifest)
    plan = _plan(given)
    fields = plan.fields(given.field, given.lines)
    setups = _setups(given, next(iter(fields.values())))
    if given.submission is not None:
        require_submitted_for(given.submission, setups[0], plan.frames(fields))
    thresholds = options.thresholds_or_default(given.threshold)
    tags = None if given.tags is None else Tags.read(given.tags)
    groups, derived = inference_options.groups_asked(given.by, tags, given.chance.cluster)
    chance = _chance(given, plan, tags, (*groups, *derived), asked=bool(derived))
    noise = inference_options.noise_file(given.chance.click_noise)
    outputs.check_not_inputs(written_to, filter(None, (given.tags, noise, given.shots)))
    shown = options.shown_size(given.camera_size)
    steady = temporal_options.TemporalRequest.of(
        given.steady, given.shots, given.pictures, given.over_time_output
    )
    return _EvaluateRequest(
        plan, fields, setups, thresholds, tags, groups, shown, written_to, manifest, steady,
        chance,
    )  # fmt: skip


def _plan(given: EvaluateOptions) -> Plan:
    cameras, sources = given.cameras, given.sources or []
    if given.submission is not None:
        cameras, sources = None, [*sources, submitted_source(given.submission)]
    return Plan.of(
        given.annotations, cameras, given.sets or [], sources, given.camera_format, given.labels
    )


def _setups(given: EvaluateOptions, field: Field) -> list[EvaluationSetup]:
    terms = given.protocol, given.off_plane, given.mirrored, given.planar_only
    sizes = dict.fromkeys(given.size or [options.DEFAULT_SIZE])
    return [options.setup_for(field, size, *terms) for size in sizes]


def _chance(
    given: EvaluateOptions, plan: Plan, tags: Tags | None, by: Sequence[str], *, asked: bool
) -> InferenceSettings | None:
    """Return how intervals are found, if anything asks for them."""
    chance = given.chance
    told = chance.click_noise is not None or chance.cluster is not None
    if not (asked or told or given.intervals or chance.power):
        if (chance.interval_method, chance.draws, given.seed) != inference_options.USUAL:
            raise UsageError(
                "--interval-method, --resamples and --seed need --intervals or the like"
            )
        return None
    parts = [name for name in by if name != MODEL]
    return chance.terms(tags, dict(plan.sets), parts, given.seed, given.shots)


def _score(
    call: _EvaluateRequest, workers: int | None, dask: str | None, unwritten: dict[Path, ProccError]
) -> tuple[list[Scored], Sequence[StatisticalResult], list[TemporalMetrics]]:
    """Do the work; what could not be written goes to ``unwritten``."""
    named = call.plan.named or len(call.setups) > 1
    written_to = [*call.written_to, *([] if call.manifest is None else [call.manifest.metrics])]
    outcome = RequestedOutputs(written_to, named=named, chance=call.chance)
    with ExitStack() as files:
        asked = call.plan.open(
            files, call.fields, call.setups, call.by, call.tags, camera_size=call.camera_size
        )
        for one in {one.set_name: one for one in asked}.values():
            of = f"{one.set_name}: " if len(call.plan.sets) > 1 else ""
            report_mismatch(one.annotations, one.setup.field, of)
            report_camera_names(one.annotations, of)
        more = call.over_time.written_to if call.over_time else ()
        inputs: list[outputs.Input] = [s for one in asked for s in (one.annotations, one.cameras)]
        if call.tags is not None:
            inputs.append(call.tags.path)
        own = [] if call.manifest is None else [call.manifest.path]
        outputs.check_not_inputs((*call.written_to, *own, *more), inputs)
        evaluations = Evaluations.prepare(asked, call.thresholds, outcome)
        with make_executor(workers, dask, frames=evaluations.frames) as executor:
            steady = call.over_time
            found = [] if steady is None else steady.run(asked, call.thresholds[0], executor)
            scored = evaluations.score(executor, progress=with_progress, unwritten=unwritten)
        if call.manifest is not None:
            call.manifest.write(asked, found)
        return scored, evaluations.told, found


def _print_results(
    call: _EvaluateRequest,
    scored: list[Scored],
    told: Sequence[StatisticalResult],
    unwritten: dict[Path, ProccError],
) -> int:
    """Print everything; returns the exit code for what was read."""
    said = [f"written: {path}" for path in call.written_to if path not in unwritten]
    said += [] if call.manifest is None else [f"written: {call.manifest.path}"]
    print_all(scored)
    print_inference(told)
    for line in said:
        echo(line)
    if call.tags is not None:
        report_remarks(_tags_of_no_frame(call.tags, call.plan.frames(call.fields)))
    report_remarks(call.plan.remarks(call.fields, [setup.size for setup in call.setups]))
    return report_problems(scored)


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
