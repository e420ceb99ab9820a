"""The numbers behind a plot as a sheet, to be written like every other table."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.report.sheet.sheet import Column, MetricTable, Value
from procc_annotator.session.runs.audit_figures import PlotData

_DIGITS = ".6g"


def plot_table(table: PlotData) -> MetricTable:
    """The sheet of a plot's numbers: undefined ones are None, the others have six digits."""
    columns = tuple(map(_plot_column, table.header, table.columns))
    return MetricTable("plot", "", columns, tuple(zip(*map(_values, table.columns), strict=True)))


def _plot_column(key: str, values: Sequence[Any] | NDArray[Any]) -> Column:
    if isinstance(values, np.ndarray) and np.issubdtype(values.dtype, np.floating):
        return Column(key, kind="number")
    first = next(iter(values), None)
    return Column(key, kind="text" if isinstance(first, str) else "whole")


def _values(column: Sequence[Any] | NDArray[Any]) -> list[Value]:
    values = column.tolist() if isinstance(column, np.ndarray) else list(column)
    return [_rounded(v) if isinstance(v, float) else v for v in values]


def _rounded(value: float) -> float | None:
    return None if math.isnan(value) else float(f"{value:{_DIGITS}}")
