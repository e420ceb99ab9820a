"""Tables and their metrics (columns): values, display texts and definitions."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Literal

from procc_annotator.errors import printable
from procc_annotator.formats.cameras.fit_record import MARKS

DASH = "–"  # for what is undefined

Better = Literal["higher", "lower"]


@dataclass(frozen=True, slots=True)
class Metric:
    """One figure, wherever it is reported.

    Attributes:
        key: in files.
        title: for people.
        unit: ``%`` for a share, which is kept as 0 to 1 and shown times 100; else what follows the
            title: px, m, °. Empty for a count or a plain number.
        better: whether a higher or a lower value is the better one; None where neither is.
        digits: decimals it is shown with; ``significant`` ones where that is said.
        definition: a sentence or two for who has not met it.
        signed: whether values above 0 are shown with a plus.
        most: what is beyond says no more than this; shown as ``> 1000``.
        attribute: of the values it is taken from, where that is not called like the key.
    """

    key: str
    title: str
    unit: str = ""
    better: Better | None = None
    digits: int = 2
    definition: str = ""
    significant: bool = False
    signed: bool = False
    most: float = math.inf
    attribute: str = ""

    def of(self, values: object) -> float | None:
        """The figure, taken from values that have it as an attribute."""
        found: float | None = getattr(values, self.attribute or self.key)
        return found

    def text(self, value: float | None) -> str:
        """The value as it is shown, without its unit; a dash where it is undefined."""
        if value is None or math.isnan(value):
            return DASH
        number = 100 * value if self.unit == "%" else value
        if number > self.most:
            return f"> {self.most:.0f}"
        kind = "g" if self.significant else "f"
        shown = f"{number:{'+' if self.signed else ''}.{self.digits}{kind}}"
        return shown if float(shown) else shown.lstrip("+-")  # no sign before 0.00


def metric_values(figures: Iterable[Metric], values: object) -> tuple[float | None, ...]:
    """Figures taken from values that have them as attributes; all are None where there are none."""
    return tuple(None if values is None else figure.of(values) for figure in figures)


def shortest_number(value: float) -> str:
    """A number as short as it is exact: ``5``, ``2.5``."""
    short = f"{value:g}"
    return short if float(short) == value and "e" not in short else repr(value)


Value = str | int | float | bool | None
Row = tuple[Value, ...]
Kind = Literal["text", "whole", "number", "yes_no"]


@dataclass(frozen=True, slots=True)
class Column:
    """A figure seen in a place, or plain text.

    Attributes:
        key: in files.
        heading: for people.
        kind: of its values, all of which may be None.
        figure: None for text and for numbers of no further meaning.
        group: a heading above several columns, e.g. a source.
        joined: how its text follows that of the column before it in one cell, ``{}`` being the
            text: `` ± {}``; empty for a cell of its own. Files keep both columns.
        written: how its numbers are written in CSV, e.g. ``.2f``, or ``shortest`` for 5 instead of
            5.0; otherwise with as many digits as it takes to read back the same value. People see
            them so, too, where it is no figure that has digits of its own.
    """

    key: str
    heading: str = ""
    kind: Kind = "text"
    figure: Metric | None = None
    group: str = ""
    joined: str = ""
    written: str = ""

    @property
    def numeric(self) -> bool:
        """Return whether it stands at the right edge."""
        return self.kind in ("whole", "number")

    @property
    def better(self) -> Better | None:
        """Return which of two values is the better one, if either is."""
        return self.figure.better if self.figure else None

    @property
    def definition(self) -> str:
        """Return the definition of its figure."""
        return self.figure.definition if self.figure else ""

    def text(self, value: Value, of_row: Metric | None = None) -> str:
        """A value as it is shown: figures by their digits (those of the row where the column is
        about none), True as ``yes``, None as a dash; of text None is empty."""
        figure = self.figure or of_row
        if isinstance(value, bool):
            return "yes" if value else ""
        if value is None:
            return DASH if self.numeric else ""
        if isinstance(value, str):
            return value
        if figure is None or self.kind == "whole":
            return f"{value:{'.15g' if self.written in ('', 'shortest') else self.written}}"
        return figure.text(value)


def metric_column(
    figure: Metric, at: str = "", *, key: str = "", heading: str = "", group: str = "",
    joined: str = "",
) -> Column:  # fmt: skip
    """A figure as a column.

    Args:
        at: where it is seen, e.g. ``@5``; it follows the title, before the unit.
        key: in files, unless it is the figure's own. heading: unless it is title, ``at`` and unit.
        group, joined: as of `Column`.
    """
    said = " ".join(part for part in (f"{figure.title}{at}", figure.unit) if part)
    return Column(key or figure.key, heading or said, "number", figure, group, joined)


TAU = Column("threshold", "tau px", "number", written="shortest")


def count_column(key: str, heading: str = "", *, group: str = "", joined: str = "") -> Column:
    """A count as a column."""
    return Column(key, heading or key, "whole", group=group, joined=joined)


def defined_count_column(
    figure: Metric, at: str = "", *, key: str = "", heading: str = "", group: str = ""
) -> Column:
    """A count that has a definition as a column; arguments as of `metric_column`."""
    return Column(key or figure.key, heading or f"{figure.title}{at}", "whole", figure, group)


@dataclass(frozen=True)
class MetricTable:
    """Columns and rows, to be written as CSV, JSON, Parquet, HTML, LaTeX, or on the terminal.

    Attributes:
        name: in files, and as an anchor on a page.
        title: above it, for people.
        columns: what each place of a row is.
        rows: values, never made into text before: numbers, text, yes or no, None for undefined.
        described: what every figure rests on: protocol, size, options.
        notes: below it, for people.
        bold: places (row, column) of values that stand out.
        parts: rows that a line is drawn above.
        of_rows: the figures that the rows are about, where the columns are not: mean, median, ...
    """

    name: str
    title: str
    columns: tuple[Column, ...]
    rows: tuple[Row, ...]
    described: str = ""
    notes: tuple[str, ...] = ()
    bold: frozenset[tuple[int, int]] = frozenset()
    parts: tuple[int, ...] = ()
    of_rows: tuple[Metric, ...] = ()

    def __post_init__(self) -> None:
        for row in self.rows:
            if len(row) != len(self.columns):
                raise ValueError(f"{self.name}: {len(row)} values, {len(self.columns)} columns")

    @property
    def caption(self) -> str:
        """The title, and in brackets what the figures rest on."""
        return f"{self.title} ({self.described})" if self.described else self.title


def shortened(sheet: MetricTable, most: int, where: str = "") -> MetricTable:
    """The first rows of a table; a note says how many more there are, and where."""
    more = len(sheet.rows) - most
    if more <= 0:
        return sheet
    notes = (*sheet.notes, f"{more} more {where}".rstrip())
    return replace(sheet, rows=sheet.rows[:most], notes=notes)


def records(sheet: MetricTable) -> Iterator[dict[str, Value]]:
    """Its rows by the keys of the columns."""
    keys = [column.key for column in sheet.columns]
    return (dict(zip(keys, row, strict=True)) for row in sheet.rows)


@dataclass(frozen=True, slots=True)
class Cell:
    """Text of a cell, and whether it is bold."""

    text: str
    bold: bool = False


@dataclass(frozen=True)
class DisplayTable:
    """Texts of a sheet; columns that are joined share a cell."""

    caption: str
    columns: tuple[Column, ...]
    rows: tuple[tuple[Cell, ...], ...]
    notes: tuple[str, ...]
    parts: tuple[int, ...]

    @property
    def groups(self) -> tuple[tuple[str, int], ...]:
        """See `spans`."""
        return spans(self.columns)


def spans(columns: Iterable[Column]) -> tuple[tuple[str, int], ...]:
    """Groups of columns with their widths; empty where no column has one."""
    found = tuple((name, len([*own])) for name, own in groupby(columns, lambda c: c.group))
    return found if any(name for name, _ in found) else ()


def display_table(sheet: MetricTable) -> DisplayTable:
    """A sheet as texts."""
    columns = tuple(column for column in sheet.columns if not column.joined)
    rows = tuple(_cells(sheet, at) for at in range(len(sheet.rows)))
    texts = [sheet.caption, *(c.heading + c.group for c in columns)]
    texts += [cell.text for row in rows for cell in row if not cell.text.isascii()]
    signs = {sign for sign in MARKS if any(sign in text for text in texts)}
    marks = [f"{s} {why}: not ranked, bold or tested." for s, why in MARKS.items() if s in signs]
    return DisplayTable(sheet.caption, columns, rows, (*sheet.notes, *marks), sheet.parts)


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


Definition = tuple[str, tuple[str, ...]]


def definitions(
    sheets: Iterable[MetricTable], also: Iterable[Metric] = ()
) -> tuple[Definition, ...]:
    """Each title of further figures and of the columns of tables, in this order, with its unit, and
    what it means: several things where several are called so."""
    found: dict[str, dict[str, None]] = {}
    columns = [column.figure for sheet in sheets for column in sheet.columns]
    rows = [figure for sheet in sheets for figure in sheet.of_rows]
    for figure in (*also, *columns, *rows):
        if figure is not None and figure.definition:
            title = f"{figure.title}, {figure.unit}" if figure.unit else figure.title
            found.setdefault(title, {})[figure.definition] = None
    return tuple((title, tuple(meanings)) for title, meanings in found.items())
