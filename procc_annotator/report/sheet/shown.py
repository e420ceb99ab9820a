"""A sheet as people see it: headings and texts, the same on the terminal, a page and in LaTeX."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import takewhile

from procc_annotator.errors import printable
from procc_annotator.report.sheet.figure import Better
from procc_annotator.report.sheet.sheet import MetricTable


@dataclass(frozen=True, slots=True)
class DisplayColumn:
    """A heading, with what is better, where it stands and what it means."""

    heading: str
    better: Better | None
    numeric: bool
    group: str
    definition: str = ""


@dataclass(frozen=True, slots=True)
class Cell:
    """What is shown, and whether it stands out."""

    text: str
    bold: bool = False


@dataclass(frozen=True)
class DisplayTable:
    """Texts of a sheet; columns that are joined share a cell.

    Attributes:
        naming: how many of the first columns it takes to tell its rows apart, at least one.
    """

    caption: str
    columns: tuple[DisplayColumn, ...]
    rows: tuple[tuple[Cell, ...], ...]
    notes: tuple[str, ...]
    parts: tuple[int, ...]
    naming: int

    @property
    def groups(self) -> tuple[tuple[str, int], ...]:
        """Groups of columns with their widths; empty where no column has one."""
        spans: list[tuple[str, int]] = []
        for column in self.columns:
            if spans and spans[-1][0] == column.group:
                spans[-1] = column.group, spans[-1][1] + 1
            else:
                spans.append((column.group, 1))
        return tuple(spans) if any(name for name, _ in spans) else ()


def display_table(sheet: MetricTable) -> DisplayTable:
    """A sheet as texts."""
    columns = tuple(
        DisplayColumn(
            column.heading, column.figure.better if column.figure else None,
            column.numeric, column.group, column.figure.definition if column.figure else "",
        )
        for column in sheet.columns
        if not column.joined
    )  # fmt: skip
    rows = tuple(_cells(sheet, at) for at in range(len(sheet.rows)))
    return DisplayTable(sheet.caption, columns, rows, sheet.notes, sheet.parts, _naming(sheet))


def _naming(sheet: MetricTable) -> int:
    """Of the columns before the first figure: as many as make the rows differ, or all of them."""
    plain = list(takewhile(lambda c: c.figure is None and not c.joined, sheet.columns))
    for count in range(1, len(plain)):
        if len({row[:count] for row in sheet.rows}) == len(sheet.rows):
            return count
    return max(1, len(plain))


def _cells(sheet: MetricTable, at: int) -> tuple[Cell, ...]:
    cells: list[Cell] = []
    figure = sheet.of_rows[at] if sheet.of_rows else None
    for place, (column, value) in enumerate(zip(sheet.columns, sheet.rows[at], strict=True)):
        text = printable(column.text(value, figure), keep="\n")
        if not column.joined:
            cells.append(Cell(text, (at, place) in sheet.bold))
        elif value is not None:
            before = cells[-1]
            cells[-1] = Cell(before.text + column.joined.format(text), before.bold)
    return tuple(cells)
