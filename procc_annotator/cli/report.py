"""``procc-annotator report``: camera sources side by side, as one page, figures and tables."""

from __future__ import annotations

import datetime
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.batch.grouping import Tags
from procc_annotator.cli import inference_options, input_files, options, outputs
from procc_annotator.cli.console import with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.manifest import ManifestFile, ManifestOfRun
from procc_annotator.cli.method_arguments import parse_sources
from procc_annotator.cli.painters import overlay_painter
from procc_annotator.cli.remarks import (
    report_mismatch,
    report_notices,
    report_remarks,
    report_unreadable,
)
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.layout import annotations_of, annotations_or_path
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import UsageError, require_existing
from procc_annotator.field.model import Field
from procc_annotator.figures.disagreement import DisagreementPainter
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_listing import ANNOTATIONS_FOLDER, list_annotations
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.interaction.palette import SOURCE_COLOURS
from procc_annotator.report.overlay_scene import OverlayLook
from procc_annotator.report.page.report import (
    ReportInputs,
    ReportPainters,
    ReportRequest,
    check_request,
    is_foreign_file,
    report_kind,
    write_report,
)
from procc_annotator.report.page.report_data import AuditReport, ReportWork, gather_report
from procc_annotator.report.scores.scoring import EvaluationRequest

HELP = """\
DATASET is a folder of pictures and annotations, or a folder or zip of annotations alone (overlays
are then drawn on plain ground).

The page (.html) is one file that loads nothing: tables, curves, histograms, worst and random
frames, with definitions. .csv and .json hold the metrics, .tex the tables for a paper. Repeat
--output for several files.

Exit code: 0; 1 if some files were unreadable (listed, one line each); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator report sample_data --cameras bad=sample_data/cameras/bad --output report.html
  procc-annotator report sample_data --cameras a=sample_data/cameras/pinhole \\
      --cameras b=sample_data/cameras/bad --disagreement a,b --output table.tex
"""

DEFAULT_THRESHOLDS = (5.0, 2.0, 10.0)
_USUAL = Path("report.html")
_NARROWEST, _WIDEST = 160, 4096
_COMPARED_FRAME = 20  # scored frames that take as long


@dataclass(frozen=True, kw_only=True)
class ReportOptions:
    """Options of `report`."""

    dataset: Annotated[
        Path,
        typer.Argument(
            help="Folder of pictures and annotations, season, or folder or zip of annotations."
        ),
    ]
    cameras: options.Sources = None
    output: Annotated[
        list[Path] | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="A .html, .csv, .json or .tex file; repeat for several.  [default: report.html in"
            " the current folder, unless a file there is another's]",
        ),
    ] = None
    annotations: input_files.Annotations = None
    threshold: Annotated[
        list[float] | None,
        typer.Option(
            "--threshold",
            "-t",
            metavar="PX",
            help="Thresholds, the leading one first: it decides colours, the worst frames and the"
            " final score.  [default: 5, 2, 10]",
        ),
    ] = None
    scoring: options.ScoringOptions
    planar_only: options.PlanarOnly = False
    tags: inference_options.TagsFile = None
    by: Annotated[
        list[str] | None,
        typer.Option(
            metavar="TAG|model|zoom|elements|spread|side|shot",
            help="Break everything down by this tag, by the model of the cameras, zoom, number of"
            " elements, how much of the picture they enclose, the camera's side or shot; zoom and"
            " side are those of a pinhole fitted to each annotation; repeat."
            "  [default: every tag of --tags]",
        ),
    ] = None
    chance: inference_options.IntervalOptions
    title: Annotated[str | None, typer.Option(help="At the head of the page.")] = None
    date: Annotated[
        str | None, typer.Option(metavar="TEXT", help="Printed on the page.  [default: today]")
    ] = None
    worst: Annotated[
        int, typer.Option(min=0, max=1000, metavar="N", help="Worst frames to draw, a source.")
    ] = 4
    random: Annotated[
        int, typer.Option(min=0, max=1000, metavar="N", help="Number of random frames.")
    ] = 3
    seed: Annotated[
        int, typer.Option(min=0, metavar="N", help="Of the lot, and of sets drawn.")
    ] = 1
    disagreement: Annotated[
        list[str] | None,
        typer.Option(
            metavar="A,B",
            help="Show where these two sources disagree, in metres on the ground; repeat.",
        ),
    ] = None
    reference: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="The source that the metrics of earlier papers (IoU and the like) take as true.",
        ),
    ] = None
    picture_width: Annotated[
        int,
        typer.Option(
            min=_NARROWEST,
            max=_WIDEST,
            metavar="PX",
            help="Larger pictures are made as small as this.",
        ),
    ] = 640
    manifest: ManifestFile = None
    steady: inference_options.OverTime = False
    shots: inference_options.Shots = None
    workers: options.Workers = None
    dask: options.Dask = None


def report(context: typer.Context, given: ReportOptions) -> None:
    # Everything is examined before any work.
    written_to = _outputs(given.cameras, given.output)
    manifest = ManifestOfRun.of(context, given.manifest)
    scoring = given.scoring
    setup = scoring.setup(given.dataset, planar_only=given.planar_only)
    field = setup.field
    thresholds = options.thresholds_or_default(given.threshold or list(DEFAULT_THRESHOLDS))
    specs = parse_sources(given.cameras or (), scoring.camera_format)
    name = dataset_name(given.dataset)
    request = _request(given, name, manifest)
    check_request(request, [spec.name for spec in specs])
    folder, pictures = annotation_place(given.dataset, field, given.annotations)
    tags = None if given.tags is None else Tags.read(given.tags)
    groups, derived = inference_options.groups_asked(given.by, tags, given.chance.cluster)
    settings = given.chance.terms(
        tags, {name: folder}, (*groups, *derived), given.seed, given.shots
    )
    over_time = inference_options.temporal_request(given.steady, given.shots)
    camera_size = scoring.own_size
    with ExitStack() as opened:
        source = opened.enter_context(open_annotations(folder, field, scoring.names(field)))
        cameras = {
            spec.name: opened.enter_context(
                CameraCollection.open(spec.path, spec.format, field=field)
            )
            for spec in specs
        }
        report_mismatch(source, field)
        own = [] if manifest is None else [manifest.path]
        outputs.check_not_inputs((*written_to, *own), [source, *cameras.values()])
        work_ahead = len(list_annotations(source)) * _frame_cost(request, len(specs))
        executor = opened.enter_context(make_executor(given.workers, given.dask, frames=work_ahead))
        work = ReportWork(executor, with_progress)
        requests = [
            EvaluationRequest(name, called, source, one, setup, camera_size=camera_size)
            for called, one in cameras.items()
        ]
        steady = over_time.run(requests, thresholds[0], executor) if over_time else []
        measured = {one.source for one in steady}
        if over_time and (without := [name for name in cameras if name not in measured]):
            why = "no metrics over time, the frames do not follow each other"
            request = replace(request, notes=(f"{', '.join(without)}: {why}.",))
        gathered = gather_report(requests, thresholds, work, settings)
        sets = [CameraSet(one, called, camera_size) for called, one in cameras.items()]
        material = ReportInputs(source, sets, pictures, tuple(steady))
        files = (*written_to, *([] if manifest is None else [manifest.metrics]))
        painters = _painters(written_to, given.picture_width, with_pairs=bool(given.disagreement))
        problems = write_report(gathered, material, request, painters, files, work)
        if manifest is not None:
            manifest.write(requests)
    for path in (*written_to, *own):
        echo(f"written: {path}")
    raise typer.Exit(_report_problems(gathered, problems))


def _report_problems(gathered: AuditReport, problems: Sequence[str]) -> int:
    """Say on stderr what could not be used; returns the exit code."""
    report_remarks(dict.fromkeys(note for s in gathered.sources for note in s.annotation_notes))
    for s in gathered.sources:
        report_notices({f"{s.name}: {notice}": count for notice, count in s.notices.items()})
    failures = list(dict.fromkeys(gathered.failures()))
    # Drawing a frame meets what scoring it has met, without knowing the source's name.
    failures += [p for p in problems if not any(said.endswith(p) for said in failures)]
    return report_unreadable(failures)


def _request(given: ReportOptions, name: str, manifest: ManifestOfRun | None) -> ReportRequest:
    return ReportRequest(
        given.title or f"Cameras of {name}", given.date or datetime.date.today().isoformat(),
        given.worst, given.random, given.seed,
        tuple(_pair(text) for text in given.disagreement or ()), reference=given.reference or "",
        manifest="" if manifest is None else manifest.path.name,
    )  # fmt: skip


def _outputs(cameras: list[str] | None, output: list[Path] | None) -> list[Path]:
    if not cameras:
        raise UsageError("a report needs sources of cameras: --cameras NAME=PATH")
    if output is None and is_foreign_file(_USUAL):
        raise UsageError(
            f"{_USUAL}: is there already, and no report wrote it; name a file with --output"
        )
    return outputs.output_files(output or [_USUAL], report_kind)


def _frame_cost(request: ReportRequest, sources: int) -> int:
    """Cost of a frame, in scored frames: comparing two cameras is slow."""
    legacy = sources - 1 if request.reference else 0
    return sources + _COMPARED_FRAME * (len(set(request.disagreement)) + legacy)


def dataset_name(dataset: Path) -> str:
    """Return what people call it: its folder, or the one around ``annotations``; an archive's
    stem."""
    whole = dataset.absolute()
    if whole.name in ("", "..") or whole.is_symlink():
        whole = dataset.resolve()
    if whole.is_file():
        return whole.stem
    return (whole.parent.name if whole.name == ANNOTATIONS_FOLDER else whole.name) or str(dataset)


def annotation_place(
    dataset: Path, field: Field, annotations: Path | None
) -> tuple[Path, dict[str, Path]]:
    """Return where the annotations of a dataset are, and its pictures by frame name; UsageError for
    no such dataset or folder, InputError for a folder that cannot be listed."""
    require_existing(dataset, annotations)
    dataset = annotations_or_path(dataset) if dataset.is_file() else dataset  # a video's frames
    if not dataset.is_dir():
        return annotations or dataset, {}
    workspace = Workspace.open(dataset, field, annotations)
    for notice in workspace.notices:
        echo(f"note: {notice}", err=True)
    if workspace.frames:
        pictures = FrameTable((frame.name, frame.image_path) for frame in workspace.frames)
        return annotations or workspace.annotations, pictures
    return annotations or annotations_of(dataset), {}


def _pair(text: str) -> tuple[str, str]:
    names = [name.strip() for name in text.split(",")]
    if len(names) != 2 or not all(names):
        raise UsageError(f"{text!r} is no pair of sources: expected NAME,NAME")
    return names[0], names[1]


def _painters(
    written_to: Sequence[Path], picture_width: int, *, with_pairs: bool
) -> ReportPainters | None:
    if "html" not in map(report_kind, written_to):
        return None
    # matplotlib comes first: Qt reads the source of every module imported after it.
    import matplotlib.backends.backend_svg  # noqa: F401

    # Two pictures share the width of the page.
    look = OverlayLook(widest=picture_width, caption=False, emphasis=1.7)
    pairs = DisagreementPainter(".jpg") if with_pairs else None
    return ReportPainters(overlay_painter(".jpg", look), pairs, SOURCE_COLOURS)
