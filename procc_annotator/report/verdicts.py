"""The verdicts on frames as a table for a spreadsheet."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import UTC, datetime

from procc_annotator.field.model import Field
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.report.sheet.as_csv import CRLF, csv_bytes
from procc_annotator.report.sheet.sheet import Column, MetricTable
from procc_annotator.session.runs.triage import JudgedVerdict


def verdicts_csv(
    rows: Iterable[JudgedVerdict], field: Field, setup: EvaluationSetup, tau: float
) -> bytes:
    """One row a verdict, with the figures at tau and the terms they were computed on.

    RFC 4180 with its CRLF line ends. Figures that are undefined are empty; ``problem`` says why.
    Times are UTC.
    """
    columns = (
        Column("frame"), Column("source"), Column("verdict"), _figure(f"jac@{tau:g}px"),
        _figure("largest_error_px"), Column("worst_element"), Column("author"), Column("time"),
        Column("comment"), Column("problem"), Column("terms"),
    )  # fmt: skip
    terms = setup.describe()
    values = tuple(
        (
            row.verdict.frame, row.verdict.source, row.verdict.fault.value, row.jac, row.largest_px,
            field.title_of(row.worst_element) if row.worst_element else None, row.verdict.author,
            _utc(row.verdict.time), row.verdict.comment, row.problem, terms,
        )
        for row in rows
    )  # fmt: skip
    return csv_bytes(MetricTable("verdicts", "Verdicts", columns, values), line_end=CRLF)


def _figure(key: str) -> Column:
    return Column(key, kind="number", written=".6g")


def _utc(seconds: float) -> str:
    try:
        return f"{datetime.fromtimestamp(seconds, UTC):%Y-%m-%dT%H:%M:%SZ}"
    except (OverflowError, ValueError, OSError):  # a clock that nobody has
        return ""
