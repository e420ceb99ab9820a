"""A sheet as CSV: the keys of its columns, then a line a row; nothing for what is undefined.

Text that a spreadsheet would run as a formula gets a leading apostrophe, whoever wrote it.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Sequence

from procc_annotator.io.csv_text import escape_formula
from procc_annotator.report.sheet.figure import shortest_number
from procc_annotator.report.sheet.sheet import Column, Row, MetricTable, Value

CRLF = "\r\n"  # what RFC 4180 asks for


def csv_bytes(sheet: MetricTable, *, line_end: str = "\n") -> bytes:
    """Header and rows, UTF-8."""
    rows = csv_rows(sheet.columns, sheet.rows, line_end=line_end)
    return csv_header(sheet.columns, line_end=line_end) + rows


def csv_header(columns: Sequence[Column], *, line_end: str = "\n") -> bytes:
    """The first line, of a file that is written row by row."""
    return _lines([[escape_formula(column.key) for column in columns]], line_end)


def csv_rows(columns: Sequence[Column], rows: Iterable[Row], *, line_end: str = "\n") -> bytes:
    """More lines of such a file."""
    forms = [column.written for column in columns]
    return _lines(([*map(_written, row, forms)] for row in rows), line_end)


def _lines(rows: Iterable[Sequence[str | int | float]], line_end: str) -> bytes:
    text = io.StringIO(newline="")
    csv.writer(text, lineterminator=line_end).writerows(rows)
    return text.getvalue().encode("utf-8", "backslashreplace")


def _written(value: Value, form: str) -> str | int | float:
    if value is None:
        return ""
    if isinstance(value, str):
        return escape_formula(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if not math.isfinite(value):
        return ""
    if form == "shortest":
        return shortest_number(value)
    return f"{value:{form}}" if form else value
