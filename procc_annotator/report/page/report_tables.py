"""Tables of a report, and its metrics as JSON and CSV."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import msgspec
import numpy as np

from procc_annotator.batch.audit import bias, gather
from procc_annotator.field.landmarks import element_titles
from procc_annotator.formats.cameras.fit_record import FITTED_KEYS, SOME_OTHER_VERSION
from procc_annotator.metrics.sets import ClassSummary, SetSummary
from procc_annotator.report.page.pairs import ReportedPair
from procc_annotator.report.page.report_data import AuditReport, ReportedSource
from procc_annotator.report.scores.inference import inference_entries
from procc_annotator.report.scores.inference_tables import (
    WITH_INTERVAL,
    interval_columns,
    interval_ends,
)
from procc_annotator.report.scores.score_files import (
    COUNTS,
    field_terms,
    frame_entry,
    summary_entry,
)
from procc_annotator.report.scores.score_tables import left_out_entry, left_out_table
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes
from procc_annotator.report.tables.metrics import (
    BIAS_DOWN,
    BIAS_RIGHT,
    COMPLETENESS,
    ERROR_POINTS,
    EVALUATED,
    FINAL_SCORE,
    IMAGES,
    IN_SAMPLE,
    JAC,
    LARGEST_PX,
    LEFT_OUT_SCORE,
    MEAN_ERROR,
    MEAN_JAC,
    MEAN_PRECISION,
    MEAN_RECALL,
    MEDIAN_PX,
    MIRRORED,
    OF_SET,
    P95_PX,
    UNDEFINED,
    UNMATCHED,
    WITHOUT,
)
from procc_annotator.report.tables.table import (
    TAU,
    Column,
    MetricTable,
    Row,
    count_column,
    defined_count_column,
    metric_column,
    metric_values,
    shortest_number,
)
from procc_annotator.report.temporal import TemporalMetrics, over_time_entries

SOURCE = Column("source", "Source")


def comparison_table(report: AuditReport) -> MetricTable:
    """The sources side by side, as the paper compares camera models."""
    taus = sorted(report.thresholds)
    columns = (
        SOURCE,
        Column("model", "Camera model"),
        *(
            metric_column(MEAN_JAC, f"@{tau:g}", key=f"mean_jac@{shortest_number(tau)}")
            for tau in taus
        ),
        metric_column(MEAN_ERROR, f"@{taus[-1]:g}"),
        metric_column(COMPLETENESS),
        metric_column(FINAL_SCORE, f"@{report.tau:g}"),
    )
    rows = tuple(
        (s.marked_name, s.model or None, *_figures(s, taus, report.tau)) for s in report.sources
    )
    return MetricTable(
        "comparison", "Comparison of camera sources", columns, rows, terms(report),
        (_rests_on(report),), _significantly_best(report, taus),
    )  # fmt: skip


def _figures(source: ReportedSource, taus: list[float], leading: float) -> list[float | None]:
    if not source.summaries:
        return [None] * (len(taus) + 3)
    first = source.summaries[leading]
    return [
        *(source.summaries[tau].mean_jac for tau in taus),
        source.summaries[taus[-1]].mean_error,
        first.completeness,
        first.final_score,
    ]


def _significantly_best(report: AuditReport, taus: list[float]) -> frozenset[tuple[int, int]]:
    """Places of the values that are better than those of every other source beyond chance."""
    keys = [(MEAN_JAC.key, tau) for tau in taus]
    keys += [(MEAN_ERROR.key, taus[-1]), (COMPLETENESS.key, report.tau)]
    keys.append((FINAL_SCORE.key, report.tau))
    rows = [at for at, source in enumerate(report.sources) if source.summaries]
    best = [report.certainty.best(*key) for key in keys]
    on_ground = [source.ground_only for source in report.evaluated]
    error = best[len(taus)]
    if error is not None and on_ground[error] and not all(on_ground):
        best[len(taus)] = None  # of a homography it is the error of fewer points
    return frozenset((rows[b], 2 + at) for at, b in enumerate(best) if b is not None)


def _rests_on(report: AuditReport) -> str:
    """Which frames the figures rest on, and what is bold."""
    first = report.evaluated[0].summaries[report.tau]
    counts = {s.name: s.summaries[report.tau].evaluated for s in report.evaluated}
    if len(set(counts.values())) == 1:
        own = f"{next(iter(counts.values()))}"
    else:
        own = ", ".join(f"{name} {count}" for name, count in counts.items())
    rests = (
        f"JaC is the mean over the frames with a camera ({own} of {first.images}), mean error that"
        f" over all their points, with the labels that count at {max(report.thresholds):g} px."
    )
    if len(counts) < 2:
        return rests
    if any(source.fitted for source in report.evaluated):
        rests += f" Cameras {SOME_OTHER_VERSION} explain them and are no method: never bold."
    return (
        f"{rests} Bold is what is better than every other source beyond chance, on the frames both"
        " have; completeness and final score over all frames."
    )


def fits_table(report: AuditReport) -> MetricTable | None:
    """The fits among the sources by elements left out; None without fits."""
    sources = [(source.name, source) for source in report.evaluated]
    return left_out_table(sources, sorted(report.thresholds), report.setup)


def frames_table(report: AuditReport) -> MetricTable:
    """Return how many frames each source was evaluated on."""
    columns = (
        SOURCE,
        Column("folder", "Folder"),
        *map(defined_count_column, (IMAGES, EVALUATED, WITHOUT)),
        defined_count_column(MIRRORED, f"@{report.tau:g}"),
        defined_count_column(UNMATCHED),
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
            JAC, f"@{report.tau:g}", key=f"jac:{source.name}", group=source.marked_name
        )
        columns += [
            jac,
            metric_column(MEDIAN_PX, key=f"median:{source.name}", group=source.marked_name),
        ]
    titles = element_titles(report.setup.field)
    medians = [_class_medians(source) for source in sources]
    figures = [source.summaries[report.tau].per_class for source in sources]
    known = list(titles)
    found = {name for per_class in figures for name in per_class}
    rows = []
    for name in [n for n in known if n in found] + sorted(found - set(known)):
        row: list[str | float | None] = [titles.get(name, name.strip())]
        index = known.index(name) if name in known else -1
        for per_class, median in zip(figures, medians, strict=True):
            found_here = per_class.get(name)
            row += [None if found_here is None else found_here.jac, median.get(index)]
        rows.append(tuple(row))
    title = "Classes, counted in points"
    return MetricTable("classes", title, tuple(columns), tuple(rows), terms(report))


def _class_medians(source: ReportedSource) -> dict[int, float]:
    points = gather(list(source.audits.values()))
    rows = points.counted_rows
    return {r: float(np.median(points.errors_px[rows == r])) for r in np.unique(rows).tolist()}


def errors_table(report: AuditReport) -> MetricTable:
    """Return how the distances of points are spread, and whether they lean to one side."""
    columns = (
        SOURCE,
        *map(defined_count_column, (ERROR_POINTS, UNDEFINED)),
        *map(metric_column, (MEDIAN_PX, P95_PX, LARGEST_PX, BIAS_RIGHT, BIAS_DOWN)),
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
            metric_column(JAC, key=f"jac:{source.name}", heading=source.marked_name)
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
    sources = report.evaluated
    said = dict.fromkeys(source.described for source in sources)
    if len(said) < 2:
        return next(iter(said), report.setup.describe())
    common = report.setup.describe()
    special = [
        f"{s.name}: {s.described.removeprefix(common).lstrip(', ')}"
        for s in sources
        if s.described != common
    ]
    return "; ".join([common, *special])


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
    *map(metric_column, OF_SET),
    *(count_column(count.key) for count in COUNTS),
    Column("field"),
    *(end for figure in WITH_INTERVAL for end in interval_columns(figure)),
    count_column("rank"),
    Column("clusters"),
    *map(count_column, FITTED_KEYS),  # of the cameras: so many
    count_column("held_out_elements"),
    metric_column(LEFT_OUT_SCORE),
    metric_column(IN_SAMPLE),
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
        **inference_entries([report.told]),
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
    rows: list[Row] = []
    unknown = (None,) * (2 * len(WITH_INTERVAL) + 2)
    ranks = {tau: report.certainty.ranks(MEAN_JAC.key, tau) for tau in report.thresholds}
    for place, source in enumerate(report.evaluated):
        ends = report.certainty.intervals[place]
        fits = source.fitted.these, source.fitted.another
        for tau, summary in source.summaries.items():
            within = [end for f in WITH_INTERVAL for end in interval_ends(ends[f.key, tau])]
            clusters = report.certainty.clusters.described
            shares = source.held_out.shares(tau) or (None, None)
            known = (*within, ranks[tau][place], clusters, *fits)
            known += (len(source.held_out.elements) or None, *shares)
            rows.append((*_row(report, source, tau, summary), *known))
            for name, found in summary.per_class.items():
                rows.append(
                    (
                        *_row(report, source, tau, found, name),
                        *unknown,
                        *fits,
                        None,
                        None,
                        None,
                    )
                )
    return csv_bytes(MetricTable("report", "", _COLUMNS, tuple(rows)))


def _row(
    report: AuditReport,
    source: ReportedSource,
    tau: float,
    found: SetSummary | ClassSummary,
    class_name: str | None = None,
) -> Row:
    setup = report.setup
    options = ", ".join(setup.options(source.ground_only))
    terms = (source.name, source.model, setup.protocol, options, *setup.size, tau, class_name)
    if isinstance(found, SetSummary):
        images = (found.images, found.evaluated)
        figures = (*images, *metric_values(OF_SET, found), None, None, None)
    else:
        of_class = {MEAN_JAC: found.jac, MEAN_PRECISION: found.precision, MEAN_RECALL: found.recall}
        shared = (of_class.get(figure) for figure in OF_SET)
        figures = (None, None, *shared, *metric_values(COUNTS, found))
    return (*terms, *figures, setup.field.described)
