"""Tables of a report, and its metrics as JSON and CSV."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import msgspec
import numpy as np

from procc_annotator.batch.audit import bias, gather
from procc_annotator.field.landmarks import element_titles
from procc_annotator.formats.cameras.fit_record import FITTED_KEYS
from procc_annotator.report.page.pairs import ReportedPair
from procc_annotator.report.page.report_data import AuditReport, ReportedSource
from procc_annotator.report.scores.inference import inference_entries
from procc_annotator.report.scores.inference_tables import interval_columns, interval_ends
from procc_annotator.report.scores.score_files import (
    COUNTS,
    field_terms,
    frame_entry,
    summary_entry,
)
from procc_annotator.report.scores.score_tables import left_out_entry, left_out_table, tie_notes
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes, metric_entry
from procc_annotator.report.tables.table import (
    TAU,
    Column,
    Metric,
    MetricTable,
    Value,
    count_column,
    defined_count_column,
    metric_column,
    shortest_number,
)
from procc_annotator.report.temporal import TemporalMetrics, over_time_entries

SOURCE = Column("source", "Method")


def comparison_table(report: AuditReport) -> MetricTable:
    """The methods side by side, with intervals and ranks."""
    shown = _compared_metrics(report)
    several = [metric for metric, _, _ in shown]
    columns = [SOURCE]
    for metric, _, at in shown:
        key = f"{metric.key}{at}" if several.count(metric) > 1 else metric.key
        columns += [metric_column(metric, at, key=key)]
        columns += [replace(end, key=f"{key}{end.key[-4:]}") for end in interval_columns(metric)]
        if metric is metrics.MEAN_JAC:
            columns.append(defined_count_column(metrics.RANK, at, key=f"rank{at}"))
    rows = []
    places = {source.name: place for place, source in enumerate(report.evaluated)}
    ranks = {tau: report.certainty.ranks(metrics.MEAN_JAC.key, tau) for tau in report.thresholds}
    for source in report.sources:
        row: list[Value] = [source.marked_name]
        for metric, tau, _ in shown:
            place = places.get(source.name)
            if place is None:
                row += [None] * (4 if metric is metrics.MEAN_JAC else 3)
                continue
            ends = report.certainty.intervals[place][metric.key, tau]
            row += [metric.of(source.summaries[tau]), *interval_ends(ends)]
            row += [ranks[tau][place]] if metric is metrics.MEAN_JAC else []
        rows.append((*row, source.model or None))
    columns.append(Column("model", "Camera model"))
    summaries = {source.name: source.summaries for source in report.evaluated}
    brackets = f"In brackets {report.certainty.described}."
    notes = (_rests_on(report), *tie_notes(summaries), brackets)
    return MetricTable(
        "comparison", "Comparison of methods", tuple(columns), tuple(rows), terms(report), notes,
        _significantly_best(report, columns, shown),
    )  # fmt: skip


def without_intervals(sheet: MetricTable) -> MetricTable:
    """The comparison without intervals and ranks."""
    kept = [
        at for at, c in enumerate(sheet.columns) if not c.joined and c.figure is not metrics.RANK
    ]
    return replace(
        sheet,
        columns=tuple(sheet.columns[at] for at in kept),
        rows=tuple(tuple(row[at] for at in kept) for row in sheet.rows),
        notes=sheet.notes[:-1],
        bold=frozenset((row, kept.index(at)) for row, at in sheet.bold),
    )


def _compared_metrics(report: AuditReport) -> list[tuple[Metric, float, str]]:
    """The metrics of the comparison, each with its threshold (px) and what its heading adds."""
    taus = report.thresholds
    at = {"every": taus, "largest": [max(taus)], "leading": [report.tau], "none": [report.tau]}
    return [
        (metric, tau, "" if where == "none" else f"@{shortest_number(tau)}")
        for metric, where in metrics.COMPARED_ON_PAGE
        for tau in at[where]
    ]


def _significantly_best(
    report: AuditReport,
    columns: Sequence[Column],
    shown: Sequence[tuple[Metric, float, str]],
) -> frozenset[tuple[int, int]]:
    """Places of the values that are significantly better than those of every other source."""
    rows = [at for at, source in enumerate(report.sources) if source.summaries]
    on_ground = [source.ground_only for source in report.evaluated]
    found = set()
    values = [at for at, c in enumerate(columns) if c.kind == "number" and not c.joined]
    for column, (metric, tau, _) in zip(values, shown, strict=True):
        best = report.certainty.best(metric.key, tau)
        # The error of a homography is that of fewer points.
        fewer = metric is metrics.MEAN_ERROR and best is not None and on_ground[best]
        if best is not None and not (fewer and not all(on_ground)):
            found.add((rows[best], column))
    return frozenset(found)


def _rests_on(report: AuditReport) -> str:
    first = report.evaluated[0].summaries[report.tau]
    counts = {s.name: s.summaries[report.tau].evaluated for s in report.evaluated}
    if len(set(counts.values())) == 1:
        own = f"{next(iter(counts.values()))}"
    else:
        own = ", ".join(f"{name} {count}" for name, count in counts.items())
    rests = (
        f"JaC is the mean over the frames with a camera ({own} of {first.images}); the mean error"
        " is over all their points, with the labels as annotated, or mirrored where these score"
        f" higher at {max(report.thresholds):g} px, the largest threshold."
    )
    if len(counts) < 2:
        return rests
    return (
        f"{rests} Bold: significantly better than every other method (95 % interval of the"
        " difference excludes 0, Holm-corrected p < 0.05), on the frames both have; completeness"
        " and final score over all frames."
    )


def fits_table(report: AuditReport) -> MetricTable | None:
    """The fits among the sources by elements left out; None without fits."""
    sources = [(source.name, source) for source in report.evaluated]
    return left_out_table(sources, report.thresholds, report.setup)


def frames_table(report: AuditReport) -> MetricTable:
    """Return how many frames each source was evaluated on."""
    columns = (
        SOURCE,
        Column("folder", "Folder"),
        *map(defined_count_column, (metrics.IMAGES, metrics.EVALUATED, metrics.WITHOUT)),
        defined_count_column(metrics.MIRRORED, f"@{report.tau:g}"),
        defined_count_column(metrics.UNMATCHED),
    )
    rows = []
    for source in report.sources:
        counts: tuple[int | None, ...] = (None,) * 4
        if source.summaries:
            figures = source.summaries[report.tau]
            mirrored = sum(
                frame.figures[report.tau].mirrored for frame in source.frames if frame.figures
            )
            missing = figures.images - figures.evaluated
            counts = (figures.images, figures.evaluated, missing, mirrored)
        rows.append((source.marked_name, source.folder, *counts, len(source.unmatched)))
    return MetricTable("frames", "Frames behind the figures", columns, tuple(rows))


def classes_section(report: AuditReport) -> MetricTable:
    """Per class and source: JaC counted in points, and the median error."""
    sources = report.evaluated
    columns = [Column("class", "Class")]
    for source in sources:
        jac = metric_column(
            metrics.JAC, f"@{report.tau:g}", key=f"jac:{source.name}", group=source.marked_name
        )
        columns += [
            jac,
            metric_column(metrics.MEDIAN_PX, key=f"median:{source.name}", group=source.marked_name),
        ]
    titles = element_titles(report.setup.field)
    medians = [_class_medians(source) for source in sources]
    figures = [source.summaries[report.tau].per_class for source in sources]
    known = list(titles)
    found = {name for per_class in figures for name in per_class}
    rows = []
    for name in [n for n in known if n in found] + sorted(found - set(known)):
        row: list[str | float | None] = [name.strip()]
        index = known.index(name) if name in known else -1
        for per_class, median in zip(figures, medians, strict=True):
            found_here = per_class.get(name)
            row += [None if found_here is None else found_here.jac, median.get(index)]
        rows.append(tuple(row))
    title = "Classes, counted in points"
    notes = tie_notes({source.name: source.summaries for source in sources})
    return MetricTable("classes", title, tuple(columns), tuple(rows), terms(report), notes)


def _class_medians(source: ReportedSource) -> dict[int, float]:
    points = gather(list(source.audits.values()))
    rows = points.counted_rows
    return {r: float(np.median(points.errors_px[rows == r])) for r in np.unique(rows).tolist()}


def errors_table(report: AuditReport) -> MetricTable:
    """Return how the distances of points are spread, and whether they lean to one side."""
    columns = (
        SOURCE,
        *map(defined_count_column, (metrics.ERROR_POINTS, metrics.UNDEFINED)),
        *map(
            metric_column,
            (
                metrics.MEDIAN_PX,
                metrics.P95_PX,
                metrics.LARGEST_PX,
                metrics.BIAS_RIGHT,
                metrics.BIAS_DOWN,
            ),
        ),
    )
    rows = []
    for source in report.evaluated:
        points = gather(list(source.audits.values()))
        errors, lean = points.errors_px, bias(points)
        spread: tuple[float | None, ...] = (None,) * 3
        if len(errors):
            spread = (*np.percentile(errors, (50, 95)).tolist(), float(errors.max()))
        row = (source.marked_name, len(errors), points.undefined, *spread, *(lean or (None, None)))
        rows.append(row)
    return MetricTable("errors", "Reprojection errors", columns, tuple(rows), terms(report))


def every_frame_table(report: AuditReport) -> MetricTable:
    """JaC of every frame under every source."""
    sources = report.evaluated
    columns = (
        Column("frame", "Frame"),
        *(
            metric_column(metrics.JAC, key=f"jac:{source.name}", heading=source.marked_name)
            for source in sources
        ),
    )
    rows = []
    for name in report.frames:
        found = [source.figures(name, report.tau) for source in sources]
        rows.append((name, *(None if f is None else f.jac for f in found)))
    title = f"JaC@{report.tau:g} of every frame, %"
    return MetricTable("every_frame", title, columns, tuple(rows), terms(report))


def terms(report: AuditReport) -> str:
    """Protocol, size and options behind the figures; by source where they differ."""
    common = report.setup.describe()
    special: dict[str, list[str]] = {}
    for source in report.evaluated:
        own = report.setup.describe(source.ground_only).removeprefix(common).lstrip(", ")
        special.setdefault(own, []).append(source.name)
    if len(special) == 1:
        return ", ".join([common, *filter(None, special)])
    return "; ".join(
        [common, *(f"{', '.join(names)}: {own}" for own, names in special.items() if own)]
    )


_COLUMNS = (
    Column("source"),
    Column("model"),
    Column("protocol"),
    Column("options"),
    count_column("width"),
    count_column("height"),
    TAU,
    Column("class"),
    count_column("images"),
    count_column("evaluated"),
    *map(metric_column, metrics.OF_SET),
    *(count_column(count.key) for count in COUNTS),
    Column("field"),
    *(end for figure in metrics.WITH_INTERVAL for end in interval_columns(figure)),
    count_column("rank"),
    Column("clusters"),
    *map(count_column, FITTED_KEYS),  # of the cameras: so many
    count_column("held_out_elements"),
    metric_column(metrics.LEFT_OUT_SCORE),
    metric_column(metrics.IN_SAMPLE),
)


def report_json(
    report: AuditReport,
    pairs: tuple[ReportedPair, ...] = (),
    over_time: Sequence[TemporalMetrics] = (),
) -> bytes:
    """Everything that is a number, in the words of `evaluate`'s score files."""
    setup = report.setup
    content = {
        "dataset": report.dataset,
        "protocol": setup.protocol,
        **field_terms(setup.field),
        "size": list(setup.size),
        "thresholds": list(report.thresholds),
        "sources": [_source_entry(source) for source in report.sources],
        "pairs": [_pair_entry(pair) for pair in pairs],
        "failures": report.failures(),
        **inference_entries([report.statistics]),
        **(over_time_entries(over_time) if over_time else {}),
    }
    return json_bytes(content)


def _source_entry(source: ReportedSource) -> dict[str, Any]:
    return {
        "name": source.name,
        "folder": source.folder,
        "model": source.model or None,
        "described": source.described,
        **source.fitted.entry(),
        **left_out_entry(source, list(source.summaries)),
        "failure": source.failure or None,
        "summary": {shortest_number(t): summary_entry(s) for t, s in source.summaries.items()},
        "unmatched_cameras": list(source.unmatched),
        "images": [
            {
                "name": frame.name,
                "error": frame.error,
                "results": {shortest_number(t): frame_entry(f) for t, f in frame.figures.items()},
            }
            for frame in source.frames
        ],
    }


def _pair_entry(pair: ReportedPair) -> dict[str, Any]:
    return {
        "a": pair.a,
        "b": pair.b,
        "failure": pair.failure or None,
        "summary": None if pair.summary is None else msgspec.to_builtins(pair.summary),
    }


def report_csv(report: AuditReport) -> bytes:
    """One row a source and threshold, then one for each of its classes (counted in points)."""
    setup, certainty = report.setup, report.certainty
    found: list[dict[str, Value]] = []
    ranks = {tau: certainty.ranks(metrics.MEAN_JAC.key, tau) for tau in report.thresholds}
    for place, source in enumerate(report.evaluated):
        ends = certainty.intervals[place]
        for tau, summary in source.summaries.items():
            terms: dict[str, Value] = {
                "source": source.name,
                "model": source.model,
                "protocol": setup.protocol,
                "options": ", ".join(setup.options(source.ground_only)),
                "width": setup.size[0],
                "height": setup.size[1],
                TAU.key: tau,
                "field": setup.field.described,
                **dict(zip(FITTED_KEYS, source.fitted.values, strict=True)),
            }
            of_set: dict[str, Value] = {
                "images": summary.images,
                "evaluated": summary.evaluated,
                "rank": ranks[tau][place],
                "clusters": certainty.clusters.described,
                "held_out_elements": len(source.held_out.elements) or None,
            }
            shares = source.held_out.shares(tau) or (None, None)
            of_set |= zip((metrics.LEFT_OUT_SCORE.key, metrics.IN_SAMPLE.key), shares, strict=True)
            for metric in metrics.WITH_INTERVAL:
                keys = (column.key for column in interval_columns(metric))
                of_set |= zip(keys, interval_ends(ends[metric.key, tau]), strict=True)
            found.append(terms | of_set | metric_entry(metrics.OF_SET, summary))
            for name, of_class in summary.per_class.items():
                own = {metric.key: one.of(of_class) for metric, one in _OF_CLASS.items()}
                found.append(terms | {"class": name} | own | metric_entry(COUNTS, of_class))
    rows = tuple(tuple(row.get(column.key) for column in _COLUMNS) for row in found)
    return csv_bytes(MetricTable("report", "", _COLUMNS, rows))


_OF_CLASS = {
    metrics.MEAN_JAC: metrics.JAC,
    metrics.MEAN_PRECISION: metrics.PRECISION,
    metrics.MEAN_RECALL: metrics.RECALL,
}
