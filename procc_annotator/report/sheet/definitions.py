"""What the columns of sheets mean, for a page that explains itself."""

from __future__ import annotations

from collections.abc import Iterable

from procc_annotator.report.sheet.figure import Metric
from procc_annotator.report.sheet.sheet import MetricTable

Definition = tuple[str, tuple[str, ...]]


def definitions(sheets: Iterable[MetricTable], also: Iterable[Metric] = ()) -> tuple[Definition, ...]:
    """Each title with its unit, and what it means: several things where several are called so.

    Args:
        sheets: whose columns are explained, in their order.
        also: further figures, which come first.
    """
    found: dict[str, dict[str, None]] = {}
    columns = [column.figure for sheet in sheets for column in sheet.columns]
    rows = [figure for sheet in sheets for figure in sheet.of_rows]
    for figure in (*also, *columns, *rows):
        if figure is not None and figure.definition:
            title = f"{figure.title}, {figure.unit}" if figure.unit else figure.title
            found.setdefault(title, {})[figure.definition] = None
    return tuple((title, tuple(meanings)) for title, meanings in found.items())
