"""The figures of a report as JSON and CSV, undefined ones as null or empty."""

from __future__ import annotations

import csv
import io
from typing import Any

import msgspec

from procc_annotator.io.csv_text import no_formula
from procc_annotator.metric.sets import ClassSummary
from procc_annotator.report.field_terms import field_terms
from procc_annotator.report.page.audit_report import AuditReport, FrameFigures, ReportedSource
from procc_annotator.report.page.report_pairs import ReportedPair
from procc_annotator.report.scores.score_files import summary_entry
from procc_annotator.report.sheet.figure import shortest

CSV_COLUMNS = (
    "source", "model", "protocol", "options", "width", "height", "threshold", "class",
    "images", "evaluated", "mean_jac", "sd_jac", "median_jac", "completeness", "final_score",
    "mean_precision", "mean_recall", "mean_reprojection_error", "tp", "fp", "fn",
)  # fmt: skip


def report_json(report: AuditReport, pairs: tuple[ReportedPair, ...] = ()) -> bytes:
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
    }
    return msgspec.json.format(msgspec.json.encode(content), indent=1) + b"\n"


def _source_entry(source: ReportedSource) -> dict[str, Any]:
    return {
        "name": source.name,
        "folder": source.folder,
        "model": source.model or None,
        "described": source.described,
        "failure": source.failure or None,
        "summary": {shortest(t): summary_entry(s) for t, s in source.summaries.items()},
        "unmatched_cameras": list(source.unmatched),
        "images": [
            {
                "name": frame.name,
                "error": frame.error,
                "results": {shortest(t): _frame_entry(f) for t, f in frame.figures.items()},
            }
            for frame in source.frames
        ],
    }


def _frame_entry(figures: FrameFigures) -> dict[str, Any]:
    return {
        "tp": figures.tp,
        "fp": figures.fp,
        "fn": figures.fn,
        "jac": figures.jac,
        "mirrored": figures.mirrored,
        "precision": figures.precision,
        "recall": figures.recall,
        "mean_reprojection_error": figures.mean_error,
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
    text = io.StringIO()
    rows = csv.DictWriter(text, CSV_COLUMNS, lineterminator="\n", restval="")
    rows.writeheader()
    for source in report.evaluated:
        for tau, summary in source.summaries.items():
            terms = _terms(report, source) | {"threshold": shortest(tau)}
            figures = {name: getattr(summary, name) for name in CSV_COLUMNS[8:18]}
            rows.writerow(terms | figures)
            for name, found in summary.per_class.items():
                rows.writerow(terms | {"class": no_formula(name)} | _class_figures(found))
    return text.getvalue().encode()


def _terms(report: AuditReport, source: ReportedSource) -> dict[str, Any]:
    width, height = report.setup.size
    said = source.described.split(", ", 2)
    return {
        "source": no_formula(source.name),
        "model": no_formula(source.model),
        "protocol": report.setup.protocol,
        "options": said[2] if len(said) > 2 else "",
        "width": width,
        "height": height,
    }


def _class_figures(found: ClassSummary) -> dict[str, Any]:
    return {
        "mean_jac": found.jac,
        "mean_precision": found.precision,
        "mean_recall": found.recall,
        "tp": found.tp,
        "fp": found.fp,
        "fn": found.fn,
    }
