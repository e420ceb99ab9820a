"""The table of scores as Parquet, for pandas, Polars, DuckDB and the like; needs pyarrow."""

from __future__ import annotations

import importlib
import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from procc_annotator.errors import InputError, ProccError
from procc_annotator.report.scores.score_columns import COLUMNS, NAMES, Row

_ADVICE = "choose another file, or move this one away"


def read_rows(path: Path) -> list[Row]:
    """The rows of a table; none if there is no file.

    Raises:
        InputError: it cannot be read or is no such table.
        ProccError: pyarrow is not installed.
    """
    arrow, parquet = _libraries()
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        return []
    except OSError as error:
        raise InputError(path, f"cannot be read: {error.strerror or error}") from error
    try:
        table = parquet.read_table(io.BytesIO(data))
    except (arrow.ArrowException, OSError) as error:
        problem = f"is no readable Parquet file: {error}"
        raise InputError(path, problem, advice=_ADVICE) from error
    expected = _schema(arrow)
    if not table.schema.equals(expected):
        different = [f.name for f in expected if f not in table.schema] or list(NAMES)
        raise InputError(
            path,
            "is no table of scores, or one of another version: expected the columns"
            f" {', '.join(NAMES)}; differs in {', '.join(different[:3])}",
            advice=_ADVICE,
        )
    return list(zip(*(column.to_pylist() for column in table.columns), strict=True))


def encode_rows(rows: Sequence[Row]) -> bytes:
    """A whole table."""
    arrow, parquet = _libraries()
    schema = _schema(arrow)
    arrays = [
        arrow.array([row[i] for row in rows], type=field.type) for i, field in enumerate(schema)
    ]
    stream = io.BytesIO()
    parquet.write_table(arrow.Table.from_arrays(arrays, schema=schema), stream)
    return stream.getvalue()


def _schema(arrow: Any) -> Any:
    types = {
        "text": arrow.string(),
        "whole": arrow.int64(),
        "number": arrow.float64(),
        "yes_no": arrow.bool_(),
    }
    return arrow.schema(
        [arrow.field(c.name, types[c.kind], nullable=c.may_be_empty) for c in COLUMNS]
    )


def _libraries() -> tuple[Any, Any]:
    try:
        arrow = importlib.import_module("pyarrow")
        parquet = importlib.import_module("pyarrow.parquet")
    except ModuleNotFoundError as error:
        raise ProccError(
            "a Parquet table needs the library pyarrow, which is not installed"
            " (install it with: pip install 'procc-annotator[parquet]'; or write a .csv table)"
        ) from error
    return arrow, parquet
