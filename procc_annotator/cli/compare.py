"""``procc-annotator compare``: where two camera sources disagree, in metres on the ground."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.comparison import ComparisonRun
from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.batch.grouping import Clusters
from procc_annotator.batch.set_run import WORTH_WORKERS, ambiguous_folders
from procc_annotator.cli import inference_options, options, outputs
from procc_annotator.cli.console import stdout_console, with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.method_arguments import parse_sources
from procc_annotator.cli.options import chosen_field
from procc_annotator.cli.remarks import (
    report_notices,
    report_remarks,
    report_set,
    report_unreadable,
)
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.diagnostics import classes_of_source, mismatch_of
from procc_annotator.dataset.layout import annotations_or_path, has_pictures_below, pictures_in
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError, UsageError, require_existing
from procc_annotator.field.model import Field
from procc_annotator.figures.disagreement import DisagreementPainter
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts
from procc_annotator.formats.file_listing import ANNOTATIONS_FOLDER, list_annotations
from procc_annotator.formats.file_source import open_source
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.messages import list_names, pluralize
from procc_annotator.metrics.statistics.intervals import BootstrapSettings
from procc_annotator.report import comparison
from procc_annotator.report.comparison import (
    ComparisonReport,
    closer_method_table,
    compare_sources,
    comparison_intervals_table,
    paint_frames,
    write_comparison,
)
from procc_annotator.report.tables.table import MetricTable

HELP = """\
A and B are PATH, NAME=PATH or NAME:FORMAT=PATH: folders, zip archives or files of cameras, paired
by frame name. A is the reference for IoU and the other metrics of earlier papers.

A pixel counts if both cameras see the ground there and at least one of the two ground points is on
the field. Distances are metres on the ground, and px of B's picture.

--intervals adds 95 % confidence intervals, over clusters of frames (--cluster). --versus C tests
whether B or C is nearer to A (permutation test with Holm's correction).

Exit code: 0; 1 if some files were unreadable (listed, one line each); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator compare true=sample_data/cameras/true bad=sample_data/cameras/bad sample_data
  procc-annotator compare true=sample_data/cameras/true bad=sample_data/cameras/bad sample_data \\
      --versus pinhole=sample_data/cameras/pinhole --pictures disagreement/ -n 3
"""

# dataset/cameras/method
_LEVELS_AROUND = 2
_THIRD = "intervals_versus"  # the sheet of the intervals of C


class FigureFormat(StrEnum):
    """Encodings of the pictures."""

    png = "png"
    jpg = "jpg"
    svg = "svg"
    pdf = "pdf"


@dataclass(frozen=True, kw_only=True)
class CompareOptions:
    """Options of `compare`."""

    a: Annotated[str, typer.Argument(metavar="A", help="The first source, [NAME[:FORMAT]=]PATH.")]
    b: Annotated[str, typer.Argument(metavar="B", help="The second source.")]
    dataset: Annotated[
        Path | None,
        typer.Argument(
            help="Folder of pictures or annotations (also a zip of annotations): only its frames"
            " are compared. Without it, all that A and B have in common."
        ),
    ] = None
    size: options.Size = "960x540"
    field: options.FieldName = None
    lines: options.Lines = None
    camera_size: options.CameraSize = None
    output: options.FigureFiles = None
    pictures: Annotated[
        Path | None,
        typer.Option(
            "--pictures", metavar="DIR", help="Draw the frames that disagree most into a folder."
        ),
    ] = None
    picture_format: Annotated[
        FigureFormat,
        typer.Option("--format", help="Encoding of the pictures; svg and pdf are sharp."),
    ] = FigureFormat.png
    worst: Annotated[
        int,
        typer.Option(
            "--worst",
            "-n",
            metavar="N",
            min=0,
            help="How many frames to draw and list, largest median disagreement first; 0 for all.",
        ),
    ] = 10
    intervals: Annotated[
        bool, typer.Option("--intervals", help="Also 95 % intervals of the figures of the set.")
    ] = False
    versus: Annotated[
        str | None,
        typer.Option(
            metavar="[NAME=]PATH",
            help="A third source: is it nearer to A than B is, beyond chance, on the frames all"
            " have?",
        ),
    ] = None
    alike: inference_options.ClusterOptions
    seed: inference_options.Seed = inference_options.USUAL_SEED
    workers: options.FitWorkers = None
    dask: options.Dask = None


def compare(given: CompareOptions) -> None:
    by_chance = given.intervals or given.versus is not None or given.alike.cluster is not None
    if not by_chance and (
        given.alike.tags is not None or given.seed != inference_options.USUAL_SEED
    ):
        raise UsageError("--tags and --seed need --intervals, --cluster or --versus")
    written_to = outputs.output_files(given.output)
    shown_field = chosen_field(given.field, given.dataset, lines=given.lines)
    texts = (given.a, given.b) if given.versus is None else (given.a, given.b, given.versus)
    own_size = options.shown_size(given.camera_size)
    sources = open_sources(texts, own_size, shown_field)
    source_a, source_b, *third = sources
    _check_outputs(written_to, given.pictures, sources, given.dataset)
    alike = given.alike.of([] if given.dataset is None else [given.dataset])
    names, images = frames_of(given.dataset, shown_field)
    if given.dataset is None:
        _report_field_around((source_a, source_b), shown_field)
        report_remarks(ambiguous_folders((s.path, s.frames) for s in sources))
    if given.pictures is not None and any(
        p.parent.resolve() == given.pictures.resolve() for p in images.values()
    ):
        raise UsageError(f"{given.pictures}: this is the dataset itself, choose another folder")
    terms = shown_field, options.parse_size(given.size), names
    comparison = ComparisonRun(source_a, source_b, *terms)
    others = [ComparisonRun(source_a, other, *terms) for other in third]
    count = comparison.total
    with make_executor(
        given.workers, given.dask, frames=count, worth_from=WORTH_WORKERS
    ) as executor:
        comparison.executor = executor
        compared = compare_sources(comparison, with_progress)
        for run in others:
            run.executor = executor
        versus_others = [compare_sources(run, with_progress) for run in others]
    for other in versus_others:
        compared.errors = list(dict.fromkeys((*compared.errors, *other.errors)))
        compared.notices |= other.notices
    of_a, *of_others = _fitted_on(sources, given.dataset, shown_field)
    for report, fitted in zip((compared, *versus_others), of_others, strict=True):
        report.fitted = of_a, fitted
    if by_chance:
        compared.chance = _inference_tables(
            compared, versus_others, alike, BootstrapSettings(seed=given.seed)
        )
    told = [f"written: {path}" for path in written_to]
    for path in written_to:  # before the tables: whoever reads them may stop after the first
        write_comparison(compared, comparison, path)
    if given.pictures is not None:
        suffix = f".{given.picture_format.value}"
        told += _draw(compared, comparison, given.pictures, images, given.worst or None, suffix)
    _print_comparison(compared, given.worst or count)
    for line in told:
        echo(line)
    _report_frames(comparison, compared)
    raise typer.Exit(report_unreadable(compared.errors))


def open_sources(
    texts: Sequence[str], camera_size: tuple[int, int] | None, field: Field
) -> list[CameraSet]:
    """The sources; UsageError for one that is none, or two of one name."""
    opened = []
    for spec in parse_sources(texts):
        require_existing(spec.path)
        source = CameraSet.open(spec.path, spec.format, spec.name, camera_size, field)
        for notice in source.notices:
            echo(f"note: {spec.name}: {notice}", err=True)
        opened.append(source)
    return opened


def _inference_tables(
    compared: ComparisonReport,
    others: Sequence[ComparisonReport],
    alike: Callable[[Sequence[str]], Clusters],
    draws: BootstrapSettings,
) -> tuple[MetricTable, ...]:
    """The intervals, and, of three sources, which of two is nearer to the first."""
    a, b = compared.marked_names
    clusters = alike([frame.name for frame in compared.frames])
    described = compared.described
    sheets = [comparison_intervals_table(compared.frames, clusters, draws, (a, b), described)]
    for other in others:
        names = a, other.marked_names[1]
        clusters = alike([frame.name for frame in other.frames])
        given = clusters, draws, names, described, _THIRD
        sheets.append(comparison_intervals_table(other.frames, *given))
        of_other = {frame.name: frame for frame in other.frames}
        own = [frame for frame in compared.frames if frame.name in of_other]
        if not own:
            raise UsageError(f"no frame has cameras of {a}, {b} and {names[1]}")
        pair = own, [of_other[frame.name] for frame in own]
        clusters = alike([frame.name for frame in own])
        sheets.append(closer_method_table(pair, clusters, draws, (a, b, names[1]), described))
    return tuple(sheets)


def frames_of(dataset: Path | None, field: Field) -> tuple[tuple[str, ...] | None, dict[str, Path]]:
    """Names of a dataset's frames, and the pictures of those that have one; a note on stderr if its
    classes are not the field's.

    The frames are those of the pictures; if absent, those of the annotations; None without a
    dataset. UsageError for no such dataset, or nothing in it."""
    if dataset is None:
        return None, {}
    require_existing(dataset)
    with open_annotations(annotations_or_path(dataset), field) as source:
        report_set(source, field)
        if dataset.is_dir() and (pictures_in(dataset) or has_pictures_below(dataset)):
            workspace = Workspace.open(dataset, field)
            if workspace.frames:
                images = FrameTable((f.name, f.image_path) for f in workspace.frames)
                return tuple(images), images
        annotated = tuple(list_annotations(source))
    if not annotated:
        raise UsageError(f"nothing to do: no picture and no annotation (*.json) in {dataset}")
    return annotated, {}


def _fitted_on(sources: Sequence[CameraSet], dataset: Path | None, field: Field) -> list[FitCounts]:
    """The cameras of each that were fitted to the dataset's annotation of their frame."""
    if dataset is None:
        return [NOT_FITTED] * len(sources)
    with open_annotations(annotations_or_path(dataset), field) as annotations:
        files = list_annotations(annotations)

        def of_these(source: CameraSet, frame: str) -> FitCounts:
            digest = source.fitted_on(frame)
            if digest is None:
                return NOT_FITTED
            try:
                data = annotations.read(files[frame])
                found = read_annotation(data, path=annotations.display(files[frame]), field=field)
            except InputError:  # nothing is told of what cannot be read
                return NOT_FITTED
            return FitCounts.of(digest, found)

        return [
            sum((of_these(s, frame) for frame in s.frames if frame in files), NOT_FITTED)
            for s in sources
        ]


def _report_field_around(sources: Sequence[CameraSet], field: Field) -> None:
    """A note on stderr where the cameras lie in a dataset whose classes are not the field's: no
    dataset was named that would have defined its field."""
    around = [p for source in sources for p in source.path.resolve().parents[:_LEVELS_AROUND]]
    for folder in dict.fromkeys(around):
        for place in (folder / ANNOTATIONS_FOLDER, folder):
            try:
                if not place.is_dir():
                    continue
                with open_source(place) as annotations:
                    classes = classes_of_source(annotations, field)
            except InputError:  # nobody asked for this folder
                continue
            mismatch = mismatch_of(classes, field) if classes else None
            if mismatch is not None and mismatch.is_worth_reporting:
                try_it = f"name the dataset after B ({folder}), or its field: --field NAME"
                echo(f"note: {mismatch.words()}; {try_it}", err=True)
            if classes:
                return


def _check_outputs(
    written_to: Sequence[Path],
    pictures: Path | None,
    cameras: Sequence[CameraSet],
    dataset: Path | None,
) -> None:
    with ExitStack() as files:
        inputs: list[outputs.Input] = list(cameras)
        if dataset is not None and dataset.exists():
            inputs.append(files.enter_context(open_source(annotations_or_path(dataset))))
        outputs.check_not_inputs(written_to, inputs)
        if pictures is not None:
            if pictures.exists() and not pictures.is_dir():
                raise UsageError(f"{pictures}: is a file, a folder is needed for the pictures")
            outputs.check_folder_apart(pictures, inputs)


def _print_comparison(compared: ComparisonReport, worst: int) -> None:
    console = stdout_console()
    console.print(comparison.disagreement_table(compared))
    console.print(comparison.legacy_table(compared))
    for sheet in compared.chance:
        console.print(sheet)
    console.print(comparison.worst_comparison_table(compared, worst))


def _draw(
    compared: ComparisonReport,
    comparison: ComparisonRun,
    out: Path,
    images: dict[str, Path],
    count: int | None,
    suffix: str,
) -> list[str]:
    painted = paint_frames(
        compared, comparison, out, DisagreementPainter(suffix), pictures=images, count=count,
        suffix=suffix,
    )  # fmt: skip
    total = min(count or compared.summary.frames, compared.summary.frames)
    drawn = sum(1 for _ in with_progress(painted, total, "drawing"))
    return [f"{pluralize(drawn, 'disagreement picture')} written to {out}"]


def _report_frames(comparison: ComparisonRun, compared: ComparisonReport) -> None:
    """Notes on stderr: frames that were not compared, remarks on cameras."""
    a, b = compared.names
    for where, names in (
        (f"only in {a}, not compared", comparison.only_a),
        (f"only in {b}, not compared", comparison.only_b),
        ("in none of the two", comparison.neither),
        ("nothing to compare, no common ground in the picture", compared.summary.blank),
    ):
        if names:
            echo(f"note: {where}: {list_names(names, 'frame')}", err=True)
    report_notices(compared.notices)
