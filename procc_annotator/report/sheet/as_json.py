"""Figures and sheets as JSON; what is undefined is null, NaN never reaches a file."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import msgspec

from procc_annotator.report.sheet.figure import Metric
from procc_annotator.report.sheet.sheet import MetricTable, records


def metric_entry(figures: Iterable[Metric], values: object) -> dict[str, Any]:
    """Figures by their keys, taken from values that have them as attributes."""
    return {figure.key: figure.of(values) for figure in figures}


def table_entry(sheet: MetricTable) -> dict[str, Any]:
    """A whole sheet: what it shows, and its rows by the keys of the columns."""
    return {
        "title": sheet.title,
        "described": sheet.described,
        "notes": list(sheet.notes),
        "rows": list(records(sheet)),
    }


def json_bytes(content: Any, *, indent: int = 1) -> bytes:
    """A file for people and programs."""
    return msgspec.json.format(encoded(content), indent=indent) + b"\n"


def encoded(content: Any) -> bytes:
    """As short as it can be; of a file's name that is no valid Unicode the bytes are spelled."""
    try:
        return msgspec.json.encode(content, enc_hook=_as_plain)
    except UnicodeEncodeError:
        plain = msgspec.to_builtins(content, enc_hook=_as_plain, str_keys=True)
        return msgspec.json.encode(_all_writable(plain))


def writable(text: str) -> str:
    """Text that any file can hold: names of files need not be valid Unicode."""
    return text.encode("utf-8", "backslashreplace").decode("utf-8")


def _all_writable(content: Any) -> Any:
    if isinstance(content, dict):
        return {writable(key): _all_writable(value) for key, value in content.items()}
    if isinstance(content, list | tuple):
        return [_all_writable(value) for value in content]
    return writable(content) if isinstance(content, str) else content


def _as_plain(value: object) -> str:
    """Words that know how they are said in other languages: files keep the English ones."""
    if isinstance(value, str):
        return str(value)
    raise NotImplementedError(f"{type(value).__name__} cannot be written as JSON")
