"""The figures of a report as JSON and CSV, undefined ones as null or empty."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import msgspec

from procc_annotator.io.camera_files.fitted_on import FITTED_KEYS
from procc_annotator.metric.sets import ClassSummary, SetSummary
from procc_annotator.report.field_terms import field_terms
from procc_annotator.report.over_time import TemporalMetrics, over_time_entries
from procc_annotator.report.page.audit_report import AuditReport, ReportedSource
from procc_annotator.report.page.report_pairs import ReportedPair
from procc_annotator.report.scores.chance import inference_entries
from procc_annotator.report.scores.chance_sheets import (
    WITH_INTERVAL,
    interval_columns,
    interval_ends,
)
from procc_annotator.report.scores.held_out_sheet import left_out_entry
from procc_annotator.report.scores.score_columns import COUNTS
from procc_annotator.report.scores.score_files import frame_entry, summary_entry
from procc_annotator.report.sheet.as_csv import csv_bytes
from procc_annotator.report.sheet.as_json import json_bytes
from procc_annotator.report.sheet.figure import shortest_number, metric_values
from procc_annotator.report.sheet.figures import (
    LEFT_OUT_SCORE,
    IN_SAMPLE,
    MEAN_JAC,
    MEAN_PRECISION,
    MEAN_RECALL,
    OF_SET,
)
from procc_annotator.report.sheet.sheet import TAU, Column, Row, MetricTable, metric_column, count_column

_COLUMNS = (
    Column("source"), Column("model"), Column("protocol"), Column("options"), count_column("width"),
    count_column("height"), TAU, Column("class"), count_column("images"), count_column("evaluated"), *map(metric_column, OF_SET),
    *(count_column(count.key) for count in COUNTS), Column("field"),
    *(end for figure in WITH_INTERVAL for end in interval_columns(figure)), count_column("rank"),
    Column("clusters"),
    *map(count_column, FITTED_KEYS),  # of the cameras: so many
    count_column("held_out_elements"), metric_column(LEFT_OUT_SCORE), metric_column(IN_SAMPLE),
)  # fmt: skip


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
