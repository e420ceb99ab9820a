"""How far a season is, as a page, CSV or JSON."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from procc_annotator.errors import UsageError
from procc_annotator.report.page.report import page_template
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes, table_entry
from procc_annotator.report.tables.table import MetricTable

_KINDS = (".html", ".csv", ".json")


def status_kind(path: Path) -> str:
    """The suffix of a file that can be written; UsageError for another one."""
    if (suffix := path.suffix.lower()) not in _KINDS:
        raise UsageError(f"{path}: expected the suffix {', '.join(_KINDS)}")
    return suffix


def status_bytes(
    path: Path,
    title: str,
    sheet: MetricTable,
    progress: tuple[str, dict[str, float | None]],
    failed: Sequence[str],
) -> bytes:
    """The content of a file of this suffix: the table, what is said of it, and failed units."""
    kind, (words, numbers) = status_kind(path), progress
    if kind == ".csv":
        return csv_bytes(sheet)
    if kind == ".json":
        about = {"status": words, **numbers, "set_aside": list(failed)}
        return json_bytes({**about, **table_entry(sheet)})
    page = page_template("status.html").render(title=title, sheet=sheet, words=words, failed=failed)
    return page.encode("utf-8", "replace")
