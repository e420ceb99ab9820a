"""A sheet: columns and rows of values, whatever it is then written as."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from procc_annotator.report.sheet.figure import DASH, Metric

Value = str | int | float | bool | None
Row = tuple[Value, ...]
Kind = Literal["text", "whole", "number", "yes_no"]


@dataclass(frozen=True, slots=True)
class Column:
    """A figure seen in a place, or plain text.

    Attributes:
        key: in files.
        heading: for people.
        kind: of its values, all of which may be None unless ``required``.
        figure: None for text and for numbers of no further meaning.
        group: a heading above several columns, e.g. a source.
        joined: how its text follows that of the column before it in one cell, ``{}`` being the
            text: `` ± {}``; empty for a cell of its own. Files keep both columns.
        written: how its numbers are written in CSV, e.g. ``.2f``, or ``shortest`` for 5 instead of
            5.0; otherwise with as many digits as it takes to read back the same value. People see
            them so, too, where it is no figure that has digits of its own.
        required: never None; Parquet says so.
    """

    key: str
    heading: str = ""
    kind: Kind = "text"
    figure: Metric | None = None
    group: str = ""
    joined: str = ""
    written: str = ""
    required: bool = False

    @property
    def numeric(self) -> bool:
        """Whether it stands at the right edge."""
        return self.kind in ("whole", "number")

    def text(self, value: Value, of_row: Metric | None = None) -> str:
        """A value as it is shown: figures by their digits, True as ``yes``, None as a dash; of text
        None is empty.

        Args:
            of_row: the figure that the row is about, where the column is not.
        """
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
    """A count that has a definition as a column.

    Args:
        at, key, heading, group: as of `of`.
    """
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


def records(sheet: MetricTable) -> Iterator[dict[str, Value]]:
    """Its rows by the keys of the columns."""
    keys = [column.key for column in sheet.columns]
    return (dict(zip(keys, row, strict=True)) for row in sheet.rows)
