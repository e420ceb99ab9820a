"""The comparison of two camera sources: tables, intervals, files and pictures."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, astuple, dataclass, field, fields
from pathlib import Path
from typing import Any

from procc_annotator.batch.comparison import (
    KEYS,
    SHARES,
    CameraPair,
    ComparedFrame,
    ComparisonRun,
    ComparisonSummary,
    MetricWithInterval,
    closer_source,
    medians_with_intervals,
    metrics_with_intervals,
    worst_frames,
)
from procc_annotator.batch.execution.executor import Progress
from procc_annotator.batch.grouping import Clusters
from procc_annotator.errors import ImageError, InputError, UsageError
from procc_annotator.field.load import field_for_frame
from procc_annotator.field.model import Field
from procc_annotator.formats.atomic import make_folder, write_atomic
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts, name_with_mark
from procc_annotator.formats.frame_names import file_of_frame
from procc_annotator.messages import pluralize
from procc_annotator.metrics.error_maps import OFFSIDE_ACCURACY_M, Disagreement
from procc_annotator.metrics.legacy import LegacyMetrics, MetricAverage
from procc_annotator.metrics.statistics.intervals import BootstrapSettings
from procc_annotator.metrics.statistics.significance import PairedDifference
from procc_annotator.report.agreement import intervals_described
from procc_annotator.report.scores.inference_tables import interval_ends
from procc_annotator.report.scores.score_files import field_terms, score_format
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes, table_entry
from procc_annotator.report.tables.table import (
    Column,
    Metric,
    MetricTable,
    Row,
    count_column,
    metric_column,
    metric_values,
)

WORST = 10

_LEGACY = tuple(one.name for one in fields(LegacyMetrics))
_COLUMNS = (
    Column("name"), Column("field"), count_column("width"), count_column("height"),
    *(Column(f"{unit}_{end}", kind="number")
      for unit in ("metres", "pixels") for end in ("min", "median", "max")),
    metric_column(metrics.WITHIN), Column("compared_share", kind="number"),
    *(Column(name, kind="number") for name in _LEGACY), Column("error"),
)  # fmt: skip


@dataclass(frozen=True)
class ComparisonScene:
    """Everything a disagreement picture shows.

    ``image_path`` is None where the dataset has no picture of the frame.
    """

    compared: ComparedFrame
    image_path: Path | None
    names: tuple[str, str]
    cameras: CameraPair
    disagreement: Disagreement
    field: Field


"""Turns a scene into an encoded picture; raises ImageError for one that cannot be decoded."""


@dataclass
class ComparisonReport:
    """A comparison, what has to be said about it, and what was written."""

    names: tuple[str, str]
    described: str
    summary: ComparisonSummary
    frames: list[ComparedFrame]
    errors: list[str] = field(default_factory=list)
    notices: Counter[str] = field(default_factory=Counter)
    pictures: list[Path] = field(default_factory=list)
    fitted: tuple[FitCounts, FitCounts] = (NOT_FITTED, NOT_FITTED)
    chance: tuple[MetricTable, ...] = ()  # intervals, where they were asked for

    @property
    def marked_names(self) -> tuple[str, str]:
        """The names as tables give them, with the mark of one that was fitted to the dataset's
        annotations."""
        (a, b), (of_a, of_b) = self.names, self.fitted
        return name_with_mark(a, of_a), name_with_mark(b, of_b)


def compare_sources(
    comparison: ComparisonRun,
    progress: Progress[ComparedFrame] = lambda items, _total, _what: iter(items),
) -> ComparisonReport:
    """Compare every frame. `UsageError` for a source without ground, or no frame whose cameras can
    be read."""
    frames = list(progress(comparison, comparison.total, "comparing"))
    errors = [error for frame in frames for error in frame.errors]
    if all(frame.statistics is None for frame in frames):
        raise UsageError(
            f"of none of the {len(frames)} frames both cameras can be read; the first: {errors[0]}"
        )
    return ComparisonReport(
        (comparison.a.name, comparison.b.name),
        comparison.describe(),
        comparison.summary(),
        frames,
        errors,
        Counter(notice for frame in frames for notice in frame.notices),
    )


# -------------------------------------------------------------------------------------- pictures


def comparison_scene(
    comparison: ComparisonRun,
    frame: ComparedFrame,
    names: tuple[str, str],
    pictures: Mapping[str, Path],
) -> ComparisonScene:
    """The scene of a compared frame. `InputError` if a camera cannot be read."""
    cameras = comparison.cameras(frame.name)
    return ComparisonScene(
        frame, pictures.get(frame.name), names, cameras,
        comparison.map_for_picture(frame.name, cameras),
        field_for_frame(comparison.field, frame.name),
    )  # fmt: skip


def paint_frames(
    compared: ComparisonReport,
    comparison: ComparisonRun,
    out: Path,
    paint: Callable[[ComparisonScene], bytes],
    *,
    pictures: dict[str, Path],
    count: int | None,
    suffix: str = ".png",
) -> Iterator[Path]:
    """Write the pictures of the frames that disagree most, yielding each file when it is there.

    Args:
        out: folder of the pictures, made if needed.
        pictures: frame name -> picture, of those frames that have one.
        count: how many; None for all.

    Raises:
        SaveError: a picture cannot be written.
        UsageError: the pictures would replace those of the dataset.
    """
    if any(path.parent.resolve() == out.resolve() for path in pictures.values()):
        raise UsageError(f"{out}: this is the dataset itself, choose another folder")
    make_folder(out)
    for frame in worst_frames(compared.frames, count):
        try:
            scene = comparison_scene(comparison, frame, compared.names, pictures)
            data = paint(scene)
        except (ImageError, InputError) as error:
            compared.errors.append(str(error))
            continue
        target = out / file_of_frame(frame.name, suffix)
        make_folder(target.parent)
        write_atomic(target, data)
        compared.pictures.append(target)
        yield target


# ---------------------------------------------------------------------------------------- tables


def disagreement_table(compared: ComparisonReport) -> MetricTable:
    """Metres and pixels over the set."""
    summary = compared.summary
    a, b = compared.marked_names
    headings = ("min", "median of frames", "max")
    columns = (
        Column("where"),
        *(Column(h, h, "number") for h in headings),
        metric_column(metrics.WITHIN),
    )
    rows = (
        ("on the ground, m", *metric_values(metrics.METRES, summary.metres), summary.within),
        ("in the picture, px", *metric_values(metrics.PIXELS, summary.pixels), None),
    )
    title = f"Disagreement of {a} and {b} in {pluralize(summary.frames, 'frame')}"
    of_rows = (metrics.METRES[0], metrics.PIXELS[0])
    return MetricTable("disagreement", title, columns, rows, compared.described, of_rows=of_rows)


def legacy_table(compared: ComparisonReport) -> MetricTable:
    """The metrics of earlier papers over the set."""
    a, b = compared.marked_names
    columns = (
        Column("metric", "metric"), Column("mean", "mean", "number"),
        Column("median", "median", "number"), count_column("frames"),
    )  # fmt: skip
    rows = []
    for figure in metrics.LEGACY:
        found = compared.summary.legacy.get(figure.key, MetricAverage(None, None, 0))
        words = f"{figure.title}, {figure.unit}"
        rows.append((words, found.mean, found.median, found.frames))
    title = f"{b} against {a} as reference"
    return MetricTable(
        "legacy", title, columns, tuple(rows), compared.described, of_rows=metrics.LEGACY
    )


def worst_comparison_table(compared: ComparisonReport, count: int = WORST) -> MetricTable:
    """The frames to look at first: largest median disagreement."""
    worst = worst_frames(compared.frames, count)
    legacy = metrics.LEGACY[:3]
    columns = (
        Column("frame", "frame"),
        *map(metric_column, metrics.METRES),
        metric_column(metrics.WITHIN),
        *map(metric_column, metrics.PIXELS[1:]),
        *map(metric_column, legacy),
    )
    rows = tuple(
        (
            frame.name, *metric_values(metrics.METRES, frame.statistics.metres), frame.within,
            *metric_values(metrics.PIXELS[1:], frame.statistics.pixels),
            *metric_values(legacy, frame.legacy),
        )
        for frame in worst
        if frame.statistics is not None and frame.legacy is not None
    )  # fmt: skip
    title = f"Largest disagreement, {pluralize(len(worst), 'frame')}"
    return MetricTable("worst_frames", title, columns, rows, compared.described)


# ----------------------------------------------------------------------------------------- files


def write_comparison(compared: ComparisonReport, comparison: ComparisonRun, path: Path) -> None:
    """Write every figure as JSON or CSV; the file appears when it is complete.

    Raises:
        UsageError: another suffix.
        SaveError: it cannot be written.
    """
    if score_format(path) == "json":
        write_atomic(path, _json(compared, comparison))
    else:
        write_atomic(path, _csv(compared, comparison))


def _json(compared: ComparisonReport, comparison: ComparisonRun) -> bytes:
    summary = compared.summary
    content = {
        **field_terms(comparison.field),
        "size": list(comparison.size),
        "a": _source_entry(compared, 0, comparison.a.path),
        "b": _source_entry(compared, 1, comparison.b.path),
        "offside_accuracy_m": OFFSIDE_ACCURACY_M,
        "images": [_entry(frame) for frame in compared.frames],
        "only_a": list(comparison.only_a),
        "only_b": list(comparison.only_b),
        "neither": list(comparison.neither),
        "summary": {
            "frames": summary.frames,
            "blank": list(summary.blank),
            "metres": asdict(summary.metres),
            "pixels": asdict(summary.pixels),
            "within_offside_accuracy": summary.within,
            "legacy": {name: asdict(average) for name, average in summary.legacy.items()},
        },
    }
    if compared.chance:
        content["chance"] = {sheet.name: table_entry(sheet) for sheet in compared.chance}
    return json_bytes(content)


def _source_entry(compared: ComparisonReport, which: int, path: Path) -> dict[str, Any]:
    mark = dict.fromkeys(compared.fitted[which].entry(), True)
    return {"name": compared.names[which], "path": str(path), **mark}


def _entry(frame: ComparedFrame) -> dict[str, Any]:
    entry: dict[str, Any] = {"name": frame.name, "errors": list(frame.errors)}
    if frame.statistics is not None and frame.legacy is not None:
        entry |= {
            "metres": asdict(frame.statistics.metres),
            "pixels": asdict(frame.statistics.pixels),
            "within_offside_accuracy": frame.within,
            "compared_share": frame.compared_share,
            "legacy": asdict(frame.legacy),
        }
    return entry


def _csv(compared: ComparisonReport, comparison: ComparisonRun) -> bytes:
    terms = (comparison.field.described, *comparison.size)
    rows = tuple(
        (frame.name, *terms, *_values(frame), "; ".join(frame.errors))
        for frame in compared.frames
    )  # fmt: skip
    return csv_bytes(MetricTable("comparison", "", _COLUMNS, rows))


def _values(frame: ComparedFrame) -> Row:
    if frame.statistics is None or frame.legacy is None:
        return (None,) * (8 + len(_LEGACY))
    distances = (*astuple(frame.statistics.metres), *astuple(frame.statistics.pixels))
    return (*distances, frame.within, frame.compared_share, *astuple(frame.legacy))


# By the keys of `KEYS`; of the distances the median of a frame is meant.
_FIGURES: dict[str, Metric] = {
    "metres": metrics.METRES[1],
    "pixels": metrics.PIXELS[1],
    "within": metrics.WITHIN,
    **{figure.key: figure for figure in metrics.LEGACY},
}
_WORDS = {
    "metres": "frames' medians on the ground, m",
    "pixels": "frames' medians in the picture, px",
}
_ENDS = (
    Column("low", "low", "number", joined=" [{}, "),
    Column("high", "high", "number", joined="{}]"),
)


def comparison_intervals_table(
    frames: Sequence[ComparedFrame],
    clusters: Clusters,
    draws: BootstrapSettings,
    names: tuple[str, str],
    described: str,
    name: str = "intervals",
) -> MetricTable:
    """Every figure of a comparison with its interval, of compared frames and their clusters."""
    known, medians = (
        metrics_with_intervals(frames, clusters, draws),
        medians_with_intervals(frames, clusters, draws),
    )
    rows: list[Row] = []
    figures: list[Metric] = []

    def add(over: str, key: str, found: MetricWithInterval) -> None:
        figures.append(_FIGURES[key])
        rows.append((_words(key), over, found.value, *interval_ends(found.interval), found.frames))

    for key in KEYS:
        add("share of all area" if key == "within" else "mean", key, known[key])
        if key in medians:
            add("median", key, medians[key])
    columns = (
        Column("figure", "figure"), Column("over", "over frames"),
        Column("value", "value", "number"), *_ENDS, count_column("frames"),
    )  # fmt: skip
    note = f"In brackets {intervals_described(draws, clusters)}."
    return MetricTable(
        name, f"{names[1]} against {names[0]}, intervals", columns, tuple(rows), described,
        (note,), of_rows=tuple(figures),
    )  # fmt: skip


def closer_method_table(
    pair: tuple[Sequence[ComparedFrame], Sequence[ComparedFrame]],
    clusters: Clusters,
    draws: BootstrapSettings,
    names: tuple[str, str, str],
    described: str,
) -> MetricTable:
    """Which of two sources is nearer to a third, figure by figure; ``pair`` has the comparisons of
    each with the third (the first of the names), of the same frames."""
    found = closer_source(pair[0], pair[1], clusters, draws)
    columns = (
        Column("figure", "figure"),
        Column("difference", f"{names[1]} − {names[2]}", "number"),
        *_ENDS,
        count_column("frames", "frames of all"),
        metric_column(metrics.P_VALUE),
        metric_column(metrics.P_CORRECTED),
        Column("nearer", f"nearer to {names[0]}"),
    )
    rows = tuple(
        (_words(key), one.value, *interval_ends(one.interval), one.frames, one.p, one.corrected,
         _nearer(key, one, names[1:]))
        for key, one in found.items()
    )  # fmt: skip
    notes = (
        f"Means over the frames that all three have. In brackets"
        f" {intervals_described(draws, clusters)}; p corrected for {len(found)} figures,"
        f" {draws.count:,} exchanges, seed {draws.seed}.",
    )
    title = f"Is {names[1]} or {names[2]} nearer to {names[0]}"
    figures = tuple(_FIGURES[key] for key in found)
    return MetricTable("nearer", title, columns, rows, described, notes, of_rows=figures)


def _words(key: str) -> str:
    figure = _FIGURES[key]
    return _WORDS.get(key) or f"{figure.title}, {figure.unit}"


def _nearer(key: str, found: PairedDifference, names: Sequence[str]) -> str:
    if found.value is None or not found.beyond_chance:
        return "undecided"
    second = (found.value > 0) != (key in SHARES)
    return names[second]
