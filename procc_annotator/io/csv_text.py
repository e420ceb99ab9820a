"""Text in tables for spreadsheets."""

from __future__ import annotations

import csv
import io
from pathlib import Path

from procc_annotator.errors import InputError
from procc_annotator.io.source import read_file

_FORMULA_STARTS = ("=", "+", "-", "@", "\t", "\r")


def no_formula(text: str) -> str:
    """Text that a spreadsheet would run as a formula gets a leading apostrophe.

    So does text that looks as if it had got one, or `formula_text` could not tell them apart.
    """
    return f"'{text}" if text.lstrip("'").startswith(_FORMULA_STARTS) else text


def formula_text(cell: str) -> str:
    """The text that `no_formula` made a cell of."""
    return cell[1:] if cell[:1] == "'" and no_formula(cell) != cell else cell


def csv_cells(path: Path) -> list[tuple[int, list[str]]]:
    """Line number and cells of every row that is not empty.

    Args:
        path: of a CSV file, separated by commas, semicolons or tabs as its first line is.

    Raises:
        InputError: it cannot be read, or is no CSV in UTF-8.
    """
    try:
        text = read_file(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(path, "is not UTF-8 text", advice="save it as CSV in UTF-8") from error
    first = text.partition("\n")[0]
    separator = max(",;\t", key=first.count)
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator, strict=True)
    try:
        return [(reader.line_num, row) for row in reader if any(cell.strip() for cell in row)]
    except csv.Error as error:
        raise InputError(path, f"is no CSV: {error}", place=f"line {reader.line_num}") from error
