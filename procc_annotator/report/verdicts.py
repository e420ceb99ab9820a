"""The verdicts on frames as a table for a spreadsheet."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from datetime import UTC, datetime

from procc_annotator.field.model import Field
from procc_annotator.io.csv_text import no_formula
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.runs.triage import JudgedVerdict


def verdicts_csv(
    rows: Iterable[JudgedVerdict], field: Field, setup: EvaluationSetup, tau: float
) -> str:
    """One row a verdict, with the figures at tau and the terms they were computed on.

    RFC 4180 with its CRLF line ends (write it with ``newline=""``). Figures that are undefined are
    empty; ``problem`` says why. Text that a spreadsheet would run as a formula gets a leading
    apostrophe. Times are UTC.
    """
    text = io.StringIO(newline="")
    table = csv.writer(text)
    figure = f"jac@{tau:g}px"
    head = ["frame", "source", "verdict", figure, "largest_error_px", "worst_element", "author"]
    table.writerow([*head, "time", "comment", "problem", "terms"])
    terms = setup.describe()
    for row in rows:
        verdict = row.verdict
        words = (verdict.frame, verdict.source, verdict.fault.value)
        figures = (_figure(row.jac), _figure(row.largest_px))
        element = field.title_of(row.worst_element) if row.worst_element else ""
        table.writerow(
            [
                *map(no_formula, words),
                *figures,
                no_formula(element),
                no_formula(verdict.author),
                _utc(verdict.time),
                no_formula(verdict.comment),
                no_formula(row.problem),
                terms,
            ]
        )
    return text.getvalue()


def _figure(value: float | None) -> str:
    return "" if value is None else f"{value:.6g}"


def _utc(seconds: float) -> str:
    try:
        return f"{datetime.fromtimestamp(seconds, UTC):%Y-%m-%dT%H:%M:%SZ}"
    except (OverflowError, ValueError, OSError):  # a clock that nobody has
        return ""
