"""A sheet as Parquet, for pandas, Polars, DuckDB and the like; needs pyarrow."""

from __future__ import annotations

import importlib
import io
from collections.abc import Sequence
from typing import Any

from procc_annotator.errors import ProccError
from procc_annotator.extras import install_hint
from procc_annotator.report.sheet.sheet import Column, Row


def parquet_bytes(columns: Sequence[Column], rows: Sequence[Row]) -> bytes:
    """A whole table.

    Raises:
        ProccError: pyarrow is not installed.
    """
    arrow, parquet = parquet_libraries()
    schema = parquet_schema(columns)
    arrays = [
        arrow.array([row[i] for row in rows], type=field.type) for i, field in enumerate(schema)
    ]
    stream = io.BytesIO()
    parquet.write_table(arrow.Table.from_arrays(arrays, schema=schema), stream)
    return stream.getvalue()


def parquet_schema(columns: Sequence[Column]) -> Any:
    """The types of the columns.

    Raises:
        ProccError: pyarrow is not installed.
    """
    arrow, _ = parquet_libraries()
    types = {
        "text": arrow.string(),
        "whole": arrow.int64(),
        "number": arrow.float64(),
        "yes_no": arrow.bool_(),
    }
    return arrow.schema(
        [arrow.field(c.key, types[c.kind], nullable=not c.required) for c in columns]
    )


def parquet_libraries() -> tuple[Any, Any]:
    """pyarrow and its Parquet module.

    Raises:
        ProccError: pyarrow is not installed.
    """
    try:
        return importlib.import_module("pyarrow"), importlib.import_module("pyarrow.parquet")
    except ModuleNotFoundError as error:
        raise ProccError(
            "a Parquet table needs the library pyarrow, which is not installed"
            f" ({install_hint('parquet')}; or write a .csv table)"
        ) from error
