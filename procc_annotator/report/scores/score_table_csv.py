"""The table of scores as CSV: the names of the columns, then a line a row; nothing for empty."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from procc_annotator.errors import InputError
from procc_annotator.report.scores.score_columns import COLUMNS, NAMES, Row, ScoreColumn

_ADVICE = "choose another file, or move this one away"
_YES_NO = {"true": True, "false": False}
_EXPECTED = {
    "whole": "a whole number",
    "number": "a number",
    "yes_no": "true or false",
    "text": "some text",
}


def read_rows(path: Path) -> list[Row]:
    """The rows of a table; none if there is no file.

    Raises:
        InputError: it cannot be read or is no such table.
    """
    try:
        with open(path, encoding="utf-8", newline="") as file:
            reader = csv.reader(file, strict=True)
            return _rows(path, reader)
    except FileNotFoundError:
        return []
    except OSError as error:
        raise InputError(path, f"cannot be read: {error.strerror or error}") from error
    except UnicodeDecodeError as error:
        raise InputError(path, "is not UTF-8 text", advice=_ADVICE) from error


def encode_rows(rows: Sequence[Row]) -> bytes:
    """A whole table."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(NAMES)
    writer.writerows([_written(value) for value in row] for row in rows)
    return text.getvalue().encode()


def _written(value: Any) -> Any:
    if isinstance(value, bool):
        return "true" if value else "false"
    return value


def _rows(path: Path, reader: Any) -> list[Row]:
    rows: list[Row] = []
    try:
        header = next(reader, None)
        if header != list(NAMES):
            problem = "is no table of scores, or one of another version"
            columns = f"expected the columns {', '.join(NAMES)}"
            raise InputError(path, f"{problem}: {columns}", place="line 1", advice=_ADVICE)
        for cells in reader:
            if len(cells) != len(COLUMNS):
                problem = f"has {len(cells)} cells, expected {len(COLUMNS)}"
                raise _damaged(path, reader.line_num, problem)
            try:
                rows.append(tuple(map(_value, COLUMNS, cells)))
            except ValueError as error:
                raise _damaged(path, reader.line_num, str(error)) from error
    except csv.Error as error:
        raise _damaged(path, reader.line_num, f"is no CSV: {error}") from error
    return rows


def _damaged(path: Path, line: int, problem: str) -> InputError:
    return InputError(path, problem, place=f"line {line}", advice="mend the line, or remove it")


def _value(column: ScoreColumn, cell: str) -> Any:
    """Raises ValueError with what is wrong."""
    if not cell and column.may_be_empty:
        return None
    try:
        if column.kind == "number":
            value = float(cell)
            if math.isfinite(value):
                return value
        elif column.kind == "whole":
            return int(cell)
        elif column.kind == "yes_no":
            return _YES_NO[cell]
        elif cell:
            return cell
    except (ValueError, KeyError):
        pass
    raise ValueError(f"{column.name} is {cell[:40]!r}, expected {_EXPECTED[column.kind]}")
