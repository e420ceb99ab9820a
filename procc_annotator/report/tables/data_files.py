"""Tables as CSV, JSON and LaTeX, and reading CSV cells back."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from typing import Any

import msgspec

from procc_annotator.formats.csv_tables import encode_rows, escape_formula, unescape_formula
from procc_annotator.report.tables.table import (
    Cell,
    Column,
    DisplayColumn,
    Metric,
    MetricTable,
    Row,
    Value,
    display_table,
    records,
    shortest_number,
)

CRLF = "\r\n"  # what RFC 4180 asks for


def csv_bytes(sheet: MetricTable, *, line_end: str = "\n") -> bytes:
    """Header and rows, UTF-8."""
    rows = csv_rows(sheet.columns, sheet.rows, line_end=line_end)
    return csv_header(sheet.columns, line_end=line_end) + rows


def csv_header(columns: Sequence[Column], *, line_end: str = "\n") -> bytes:
    """The first line, of a file that is written row by row."""
    return encode_rows([[escape_formula(column.key) for column in columns]], line_end)


def csv_rows(columns: Sequence[Column], rows: Iterable[Row], *, line_end: str = "\n") -> bytes:
    """More lines of such a file."""
    forms = [column.written for column in columns]
    return encode_rows(([*map(_written, row, forms)] for row in rows), line_end)


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


_YES_NO = {"true": True, "false": False}
_EXPECTED = {
    "whole": "a whole number",
    "number": "a number",
    "yes_no": "true or false",
    "text": "some text",
}


def value_of(column: Column, cell: str) -> Value:
    """The value of a cell; None for an empty one.

    Raises:
        ValueError: the column holds no such values; says what was expected.
    """
    if not cell and not column.required:
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
            return unescape_formula(cell)
    except (ValueError, KeyError):
        pass
    raise ValueError(f"{column.key} is {cell[:40]!r}, expected {_EXPECTED[column.kind]}")


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


_MOST_COLUMNS = 8  # of figures in one column of a page: more would be shrunk below half their size

_SPECIAL = {
    "\\": r"\textbackslash{}",
    "&": r"\&",
    "%": r"\%",
    "$": r"\$",
    "#": r"\#",
    "_": r"\_",
    "{": r"\{",
    "}": r"\}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    '"': "''",
    "–": "--",
    "²": r"\textsuperscript{2}",
    "°": r"\textdegree{}",
}
_ARROWS = {"higher": r"($\uparrow$)", "lower": r"($\downarrow$)"}


def escape_latex(text: str) -> str:
    """Text that LaTeX shows as it is; line breaks and control characters become spaces."""
    plain = re.sub(r"[\x00-\x1f\x7f]+", " ", text)
    # < and > come out as other characters in LaTeX's old encoding, which has no straight quotes.
    return "".join(_SPECIAL.get(character, character) for character in plain)


def latex_tables(sheets: Iterable[MetricTable], remarks: Iterable[str] = ()) -> str:
    """Several tables as one file; remarks go into comments at its head."""
    remarks = (*remarks, r"needs \usepackage{booktabs, adjustbox}")
    head = ["% " + " ".join(remark.split()) for remark in remarks]
    return "\n".join([*head, *(f"\n{latex_table(sheet)}" for sheet in sheets)]) + "\n"


def latex_table(sheet: MetricTable) -> str:
    """One table; best values are bold, dashes stand for what is undefined.

    One of many columns spans both columns of a page that has two.
    """
    content = display_table(sheet)
    kind = "table*" if len(content.columns) > _MOST_COLUMNS else "table"
    layout = "".join("r" if column.numeric else "l" for column in content.columns)
    lines = [
        rf"\begin{{{kind}}}", r"\centering", r"\begin{adjustbox}{max width=\linewidth}",
        rf"\begin{{tabular}}{{{layout}}}", r"\toprule",
    ]  # fmt: skip
    if content.groups:
        lines.append(" & ".join(map(_span, content.groups)) + r" \\")
    lines += [" & ".join(map(_heading, content.columns)) + r" \\", r"\midrule"]
    for at, row in enumerate(content.rows):
        if at and at in content.parts:
            lines.append(r"\midrule")
        lines.append(" & ".join(map(_cell, row)) + r" \\")
    caption = " ".join([f"{escape_latex(content.caption)}.", *map(escape_latex, content.notes)])
    lines += [r"\bottomrule", r"\end{tabular}", r"\end{adjustbox}", rf"\caption{{{caption}}}"]
    return "\n".join([*lines, rf"\end{{{kind}}}"])


def _span(group: tuple[str, int]) -> str:
    name, columns = group
    if name:
        return rf"\multicolumn{{{columns}}}{{c}}{{{escape_latex(name)}}}"
    return " & " * (columns - 1)


def _heading(column: DisplayColumn) -> str:
    text = escape_latex(column.heading)
    return f"{text} {_ARROWS[column.better]}" if column.better else text


def _cell(cell: Cell) -> str:
    text = escape_latex(cell.text)
    return rf"\textbf{{{text}}}" if cell.bold else text
