"""Reading a table of scores back, be it CSV or Parquet; one of an earlier version, too, as long as
it has all that may not be empty: columns it did not know yet are empty then."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from procc_annotator.errors import InputError
from procc_annotator.regular_file import open_regular
from procc_annotator.report.scores.score_columns import COLUMNS, NAMES, ScoreRow
from procc_annotator.report.sheet.as_parquet import parquet_libraries, parquet_schema
from procc_annotator.report.sheet.from_csv import value_of

_ADVICE = "choose another file, or move this one away"


def read_csv_rows(path: Path) -> list[ScoreRow]:
    """The rows of a table; none if there is no file.

    Raises:
        InputError: it cannot be read or is no such table.
    """
    try:
        with io.TextIOWrapper(open_regular(path), encoding="utf-8", newline="") as file:
            reader = csv.reader(file, strict=True)
            return _rows(path, reader)
    except FileNotFoundError:
        return []
    except OSError as error:
        raise InputError(path, f"cannot be read: {error.strerror or error}") from error
    except UnicodeDecodeError as error:
        raise InputError(path, "is not UTF-8 text", advice=_ADVICE) from error


def _rows(path: Path, reader: Any) -> list[ScoreRow]:
    rows: list[ScoreRow] = []
    try:
        header = next(reader, None) or []
        places = _places(path, header, "line 1")
        for cells in reader:
            if len(cells) != len(header):
                problem = f"has {len(cells)} cells, expected {len(header)}"
                raise _damaged(path, reader.line_num, problem)
            found = ("" if place is None else cells[place] for place in places)
            try:
                rows.append(tuple(map(value_of, COLUMNS, found)))
            except ValueError as error:
                raise _damaged(path, reader.line_num, str(error)) from error
    except csv.Error as error:
        raise _damaged(path, reader.line_num, f"is no CSV: {error}") from error
    return rows


def _places(path: Path, header: Sequence[str], line: str = "") -> list[int | None]:
    """Where the columns are; None for one that an earlier version did not have."""
    lacking = [c.key for c in COLUMNS if c.required and c.key not in header]
    strange = [name for name in header if name not in NAMES]
    if lacking or strange or len(set(header)) < len(header):
        problem = "is no table of scores, or one of another version: expected the columns"
        differs = f"; differs in {', '.join((lacking + strange)[:3])}" if lacking + strange else ""
        raise InputError(path, f"{problem} {', '.join(NAMES)}{differs}", place=line, advice=_ADVICE)
    at = {name: place for place, name in enumerate(header)}
    return [at.get(name) for name in NAMES]


def _damaged(path: Path, line: int, problem: str) -> InputError:
    return InputError(path, problem, place=f"line {line}", advice="mend the line, or remove it")


def read_parquet_rows(path: Path) -> list[ScoreRow]:
    """The rows of a table; none if there is no file.

    Raises:
        InputError: it cannot be read or is no such table.
        ProccError: pyarrow is not installed.
    """
    arrow, parquet = parquet_libraries()
    try:
        with open_regular(path) as file:
            data = file.read()
    except FileNotFoundError:
        return []
    except OSError as error:
        raise InputError(path, f"cannot be read: {error.strerror or error}") from error
    try:
        table = parquet.read_table(io.BytesIO(data))
    except (arrow.ArrowException, OSError) as error:
        problem = f"is no readable Parquet file: {error}"
        raise InputError(path, problem, advice=_ADVICE) from error
    places = _places(path, table.column_names)
    known = [column for column in COLUMNS if column.key in table.column_names]
    if not table.select([column.key for column in known]).schema.equals(parquet_schema(known)):
        raise InputError(path, "holds other types than a table of scores", advice=_ADVICE)
    nothing = [None] * table.num_rows
    columns = [nothing if place is None else table.column(place).to_pylist() for place in places]
    return list(zip(*columns, strict=True))
