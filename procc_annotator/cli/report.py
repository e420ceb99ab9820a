"""``procc-annotator report``: camera sources side by side, as one page, figures and tables."""

from __future__ import annotations

import datetime
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.batch.grouping import Tags
from procc_annotator.cli import (
    inference_options,
    input_files,
    options,
    outputs,
    remarks,
    temporal_options,
)
from procc_annotator.cli.console import with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.manifest_option import ManifestFile, ManifestOfRun
from procc_annotator.cli.method_arguments import SourceSpec, parse_sources
from procc_annotator.cli.painters import overlay_painter, pair_painter
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.layout import annotations_of, annotations_or_path
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import LabelMap
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_listing import ANNOTATIONS_FOLDER, list_annotations
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.interaction.palette import SOURCE_COLOURS
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.overlay_scene import OverlayLook
from procc_annotator.report.page.html import is_foreign_file
from procc_annotator.report.page.overlays import Painters
from procc_annotator.report.page.pairs import PairPainters
from procc_annotator.report.page.report import (
    ReportInputs,
    ReportPainters,
    ReportRequest,
    check_request,
    report_kind,
    write_report,
)
from procc_annotator.report.page.report_data import (
    AuditReport,
    NamedCameras,
    ReportWork,
    gather_report,
)
from procc_annotator.report.scores.inference import InferenceSettings
from procc_annotator.report.scores.scoring import EvaluationRequest

HELP = """\
DATASET is a folder of pictures and annotations, or a folder or zip of annotations alone: overlay
pictures are then drawn on plain ground.

The page (.html) is one file that loads nothing: tables, curves, histograms, the worst frames and
some drawn by lot, with explanations and definitions. Figures go to .csv and .json, tables for a
paper to .tex. Repeat --output for several files.

Exit code: 0; 1 if some files were unreadable (listed, one line each); 2 if there was nothing to do.
"""

EXAMPLE = """
Example:

\b
  procc-annotator report match/ --cameras ours=run1/ --cameras carwc:carwc=homographies/ \\
      --disagreement ours,carwc --output report.html --output table.tex
"""

DEFAULT_THRESHOLDS = (5.0, 2.0, 10.0)
_USUAL = Path("report.html")
_NARROWEST, _WIDEST = 160, 4096
_COMPARED_FRAME = 20  # scored frames that take as long


Dataset = Annotated[
    Path,
    typer.Argument(help="Folder of pictures and annotations; or folder or zip of annotations."),
]
Output = Annotated[
    list[Path] | None,
    typer.Option(
        "--output",
        "-o",
        metavar="FILE",
        help="A .html, .csv, .json or .tex file; repeat for several.  [default: report.html in the"
        " current folder, unless a file there is another's]",
    ),
]
Thresholds = Annotated[
    list[float] | None,
    typer.Option(
        "--threshold",
        "-t",
        metavar="PX",
        help="Thresholds, the leading one first: it decides colours, the worst frames and the"
        " final score.  [default: 5, 2, 10]",
    ),
]
Title = Annotated[str | None, typer.Option(help="At the head of the page.", show_default=False)]
Date = Annotated[
    str | None, typer.Option(metavar="TEXT", help="Printed on the page.  [default: today]")
]
Worst = Annotated[
    int, typer.Option(min=0, max=1000, metavar="N", help="Worst frames to draw, a source.")
]
Random = Annotated[int, typer.Option(min=0, max=1000, metavar="N", help="Frames to draw by lot.")]
Seed = Annotated[int, typer.Option(min=0, metavar="N", help="Of the lot, and of sets drawn.")]
By = Annotated[
    list[str] | None,
    typer.Option(
        metavar="TAG|model|zoom|elements|spread|side|shot",
        show_default=False,
        help="Break everything down by this tag, by the model of the cameras, zoom, number of"
        " elements, how much of the picture they enclose, the camera's side or shot; zoom and"
        " side are medians of the methods compared; repeat."
        "  [default: every tag of --tags]",
    ),
]
Disagreement = Annotated[
    list[str] | None,
    typer.Option(
        metavar="A,B",
        help="Show where these two sources disagree, in metres on the ground; repeat.",
        show_default=False,
    ),
]
Reference = Annotated[
    str | None,
    typer.Option(
        metavar="NAME",
        help="The source that the metrics of earlier papers (IoU and the like) take as true.",
        show_default=False,
    ),
]
PictureWidth = Annotated[
    int,
    typer.Option(
        min=_NARROWEST, max=_WIDEST, metavar="PX", help="Larger pictures are made as small as this."
    ),
]


@dataclass(frozen=True, kw_only=True)
class ReportOptions:
    """Options of `report`."""

    dataset: Dataset
    cameras: options.Sources = None
    output: Output = None
    annotations: input_files.Annotations = None
    threshold: Thresholds = None
    protocol: options.Protocol = "soccernet"
    size: options.Size = "960x540"
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
    chance: inference_options.IntervalOptions
    title: Title = None
    date: Date = None
    worst: Worst = 4
    random: Random = 3
    seed: Seed = 1
    disagreement: Disagreement = None
    reference: Reference = None
    picture_width: PictureWidth = 960
    manifest: ManifestFile = None
    steady: temporal_options.OverTime = False
    shots: temporal_options.Shots = None
    workers: options.Workers = None
    dask: options.Dask = None


def report(context: typer.Context, given: ReportOptions) -> None:
    written = _written(given.cameras, given.output)
    manifest = ManifestOfRun.of(context, given.manifest)
    setup = options.make_setup(
        given.field,
        given.size,
        given.protocol,
        given.off_plane,
        given.mirrored,
        given.planar_only,
        datasets=[given.dataset],
        lines=given.lines,
    )
    thresholds = options.thresholds_or_default(given.threshold or list(DEFAULT_THRESHOLDS))
    specs = parse_sources(given.cameras or (), given.camera_format)
    name = dataset_name(given.dataset)
    request = ReportRequest(
        given.title or f"Cameras of {name}", given.date or datetime.date.today().isoformat(),
        given.worst, given.random, given.seed,
        tuple(_pair(text) for text in given.disagreement or ()), reference=given.reference or "",
        manifest="" if manifest is None else manifest.path.name,
    )  # fmt: skip
    check_request(request, [spec.name for spec in specs])
    place = annotation_place(given.dataset, setup.field, given.annotations)
    read_tags = None if given.tags is None else Tags.read(given.tags)
    groups, derived = inference_options.groups_asked(given.by, read_tags, given.chance.cluster)
    parts = (*groups, *derived)
    chance = given.chance.terms(read_tags, {name: place[0]}, parts, given.seed, given.shots)
    call = _ReportRequest(
        name, specs, setup, thresholds, request, written, given.picture_width, chance,
        options.label_map(given.labels, setup.field), manifest,
        temporal_options.TemporalRequest.of(given.steady, given.shots, None, None),
    )  # fmt: skip
    gathered, problems = _make(
        call, *place, options.shown_size(given.camera_size), given.workers, given.dask
    )
    raise typer.Exit(_print_summary(call, gathered, problems))


@dataclass(frozen=True)
class _ReportRequest:
    """A call as it was read; specs: the sources; picture_width: px, of the widest picture; labels:
    what names of another program stand for."""

    name: str
    specs: Sequence[SourceSpec]
    setup: EvaluationSetup
    thresholds: tuple[float, ...]
    request: ReportRequest
    written: Sequence[Path]
    picture_width: int
    chance: InferenceSettings
    labels: LabelMap | None
    manifest: ManifestOfRun | None
    over_time: temporal_options.TemporalRequest | None


def _written(cameras: list[str] | None, output: list[Path] | None) -> list[Path]:
    """The files to write."""
    if not cameras:
        raise UsageError("a report needs sources of cameras: --cameras NAME=PATH")
    if output is None and is_foreign_file(_USUAL):
        raise UsageError(
            f"{_USUAL}: is there already, and no report wrote it; name a file with --output"
        )
    written = output or [_USUAL]
    for path in written:
        report_kind(path)
        outputs.check_output_folder(path)
    return written


def _make(
    call: _ReportRequest,
    folder: Path,
    pictures: dict[str, Path],
    camera_size: tuple[int, int] | None,
    workers: int | None,
    dask: str | None,
) -> tuple[AuditReport, list[str]]:
    """Score, draw and write; returns the figures, and what went wrong while drawing."""
    with ExitStack() as opened:
        source = opened.enter_context(open_annotations(folder, call.setup.field, call.labels))
        collections = [opened.enter_context(_open(spec, call.setup.field)) for spec in call.specs]
        remarks.report_mismatch(source, call.setup.field)
        named = list(zip(call.specs, collections, strict=True))
        for spec, collection in named:
            remarks.report_remarks(f"{spec.name}: {notice}" for notice in collection.notices)
        files = (*call.written, *([call.manifest.path] if call.manifest else []))
        outputs.check_not_inputs(files, [source, *collections])
        work_ahead = len(list_annotations(source)) * _frame_cost(call.request, len(call.specs))
        executor = opened.enter_context(make_executor(workers, dask, frames=work_ahead))
        work = ReportWork(executor, camera_size, with_progress)
        asked = [
            EvaluationRequest(
                call.name, spec.name, source, cameras, call.setup, camera_size=camera_size
            )
            for spec, cameras in named
        ]
        steady = call.over_time
        found = () if steady is None else steady.run(asked, call.thresholds[0], executor)
        judged = [NamedCameras(spec.name, collection) for spec, collection in named]
        gathered = gather_report(
            call.name, source, judged, call.setup, call.thresholds, work, call.chance
        )
        sets = [CameraSet(collection, spec.name, camera_size) for spec, collection in named]
        material = ReportInputs(source, sets, pictures, tuple(found))
        written = (*call.written, *([call.manifest.metrics] if call.manifest else []))
        problems = write_report(gathered, material, call.request, _drawing(call), written, work)
        if call.manifest is not None:
            call.manifest.write(asked)
        return gathered, problems


def _print_summary(call: _ReportRequest, gathered: AuditReport, problems: list[str]) -> int:
    """Say what was written and what went wrong; returns the exit code."""
    for path in (*call.written, *([call.manifest.path] if call.manifest else [])):
        echo(f"written: {path}")
    notes = dict.fromkeys(note for s in gathered.sources for note in s.annotation_notes)
    remarks.report_remarks(notes)
    failures = list(dict.fromkeys(gathered.failures()))
    # Drawing a frame meets what scoring it has met, without knowing the source's name.
    failures += [p for p in problems if not any(said.endswith(p) for said in failures)]
    return remarks.report_unreadable(failures)


def _frame_cost(request: ReportRequest, sources: int) -> int:
    """Return what a frame of the set costs, in scored frames: comparing two cameras is dear."""
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
    """Return where the annotations of a dataset are, and its pictures by frame name.

    Raises:
        UsageError: no such dataset or folder.
        InputError: a folder that cannot be listed.
    """
    for given in (dataset, annotations):
        if given is not None and not given.exists():
            raise UsageError(f"{given}: does not exist")
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


def _open(spec: SourceSpec, field: Field) -> CameraCollection:
    return CameraCollection.open(spec.path, spec.format, field=field)


def _pair(text: str) -> tuple[str, str]:
    names = [name.strip() for name in text.split(",")]
    if len(names) != 2 or not all(names):
        raise UsageError(f"{text!r} is no pair of sources: expected NAME,NAME")
    return names[0], names[1]


def _drawing(call: _ReportRequest) -> ReportPainters | None:
    if "html" not in map(report_kind, call.written):
        return None
    # What charts need comes first: Qt reads the source of every module imported after it.
    import matplotlib.backends.backend_svg  # noqa: F401

    # Two pictures share the width of the page.
    look = OverlayLook(widest=call.picture_width, caption=False, emphasis=1.7)
    overlays = Painters(overlay_painter(".jpg", look), overlay_painter(".png", look))
    pairs = None
    if call.request.disagreement and (photograph := pair_painter(".jpg")):
        pairs = PairPainters(photograph, pair_painter(".png") or photograph)
    return ReportPainters(overlays, pairs, SOURCE_COLOURS)
