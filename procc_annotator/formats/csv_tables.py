"""Read CSV tables keyed by frame; protect cells against spreadsheet formulas."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from pathlib import Path

from procc_annotator.errors import InputError
from procc_annotator.formats.file_source import read_file
from procc_annotator.messages import pluralize

_FORMULA_STARTS = ("=", "+", "-", "@", "\t", "\r")


def escape_formula(text: str) -> str:
    """Text that a spreadsheet would run as a formula gets a leading apostrophe.

    So does text that looks as if it had got one, or `unescape_formula` could not distinguish them.
    """
    return f"'{text}" if text.lstrip("'").startswith(_FORMULA_STARTS) else text


def unescape_formula(cell: str) -> str:
    """The text that `escape_formula` made a cell of."""
    return cell[1:] if cell[:1] == "'" and escape_formula(cell) != cell else cell


def encode_rows(rows: Iterable[Sequence[object]], line_end: str = "\n") -> bytes:
    """The content of a CSV file in UTF-8; cells are written as they are."""
    text = io.StringIO(newline="")
    csv.writer(text, lineterminator=line_end).writerows(rows)
    return text.getvalue().encode("utf-8", "backslashreplace")


def csv_cells(path: Path | str, data: bytes | None = None) -> list[tuple[int, list[str]]]:
    """Line number and cells of every row that is not empty.

    Args:
        path: of a CSV file, separated by commas, semicolons or tabs as its first line is.
        data: its content; None to read it.

    Raises:
        InputError: it cannot be read, or is no CSV in UTF-8.
    """
    try:
        text = (read_file(Path(path)) if data is None else data).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(path, "is not UTF-8 text", advice="save it as CSV in UTF-8") from error
    first = text.partition("\n")[0]
    separator = max(",;\t", key=first.count)
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator, strict=True)
    try:
        return [(reader.line_num, row) for row in reader if any(cell.strip() for cell in row)]
    except csv.Error as error:
        raise InputError(path, f"is no CSV: {error}", place=f"line {reader.line_num}") from error


def read_table(
    path: Path | str, required: Sequence[str], advice: str, data: bytes | None = None
) -> tuple[list[str], list[tuple[int, dict[str, str]]]]:
    """The columns of a table, and of every row its line number and cells by column.

    Args:
        required: columns that it must have.
        data: its content; None to read it.

    Raises:
        InputError: it cannot be read, or what is wrong and where.
    """
    (at, header), *rows = csv_cells(path, data) or [(0, [])]
    if not at:
        raise InputError(path, "is empty", advice=advice)
    names = [cell.strip() for cell in header]
    lacking = [f"has no column {name!r}" for name in required if name not in names]
    twice = [f"has two columns {name!r}" for name in names if name and names.count(name) > 1]
    if problems := lacking + twice:
        raise InputError(path, problems[0], place=f"line {at}", advice=advice)
    found = []
    for line, cells in rows:
        if len(cells) != len(names):
            has = f"has {pluralize(len(cells), 'cell')}, expected {len(names)} as in the header"
            raise InputError(path, has, place=f"line {line}")
        texts = (unescape_formula(cell.strip()) for cell in cells)
        found.append((line, dict(zip(names, texts, strict=True))))
    return names, found


def read_frame_table(
    path: Path, required: Sequence[str], advice: str, *, in_sets: bool = False
) -> tuple[list[str], list[tuple[int, dict[str, str]]]]:
    """As `read_table`, of a table about frames: its column ``frame`` names each of them once.

    Args:
        in_sets: whether a column ``set``, if there is one, distinguishes frames of one name.

    Raises:
        InputError: it cannot be read, or what is wrong and where.
    """
    names, rows = read_table(path, ["frame", *required], advice)
    lines = dict[tuple[str, str], int]()
    for line, row in rows:
        frame, place = row["frame"], f"line {line}"
        if not frame:
            raise InputError(path, "names no frame", place=place)
        first = lines.setdefault((row.get("set", "") if in_sets else "", frame), line)
        if first != line:
            problem = f"frame {frame!r} again, after line {first}"
            raise InputError(path, problem, place=place, advice="keep one of them")
    return names, rows
