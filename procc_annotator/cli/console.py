"""The terminal: tables on stdout, progress on stderr."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeVar

from rich.cells import cell_len
from rich.console import Console, ConsoleOptions
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.segment import Segment
from rich.table import Column, Table
from rich.text import Text

from procc_annotator.errors import printable
from procc_annotator.report.tables.table import MetricTable, display_table


def terminal_table(sheet: MetricTable) -> Table:
    """Title and what the figures rest on, headings, rows, notes."""
    from rich.table import Table
    from rich.text import Text

    heading = Text(sheet.title, "bold")
    if sheet.described:
        heading = Text.assemble((sheet.title, "bold"), "  ", (f"({sheet.described})", "dim"))
    content = display_table(sheet)
    table = Table(
        title=heading,
        title_justify="left",
        title_style="",
        header_style="bold",
        show_header=bool(content.rows),
        caption="\n".join(content.notes) or None,
        caption_justify="left",
    )
    if not content.rows:
        table.box = None
    for column in content.columns:
        named = f"{column.group}\n{column.heading}" if column.group else column.heading
        table.add_column(named, justify="right" if column.numeric else "left")
    for at, row in enumerate(content.rows):
        if at in content.parts:
            table.add_section()
        table.add_row(*(Text(cell.text, "bold" if cell.bold else "") for cell in row))
    return table


# A longer word (a path, a frame's name) may be cut.
_LONGEST_WORD = 24


def fit_columns(table: Table, width: int) -> int:
    """Give the columns of a table widths with which it fits, if it does not anyway.

    Words are broken only where nothing else helps; figures of several words ("74.1 ± 0.1") keep to
    one line while that is possible.

    Args:
        table: one line a row or more; changed in place.
        width: columns of the terminal.

    Returns:
        Columns that the table takes: more than there are where its figures would be cut else.
    """
    columns = table.columns
    widest = [_longest(column, str.splitlines) for column in columns]
    borders = len(columns) + 1
    if sum(widest) + 2 * len(columns) + borders <= width:
        return width
    table.collapse_padding = True
    room = width - borders - len(columns) - 1  # one blank between columns, one at each edge
    by_words = [_longest(column, str.split) for column in columns]
    unbroken = [_unbroken(column) for column in columns]
    least = unbroken if sum(unbroken) <= room else by_words
    room = max(room, sum(least))
    for column, wide in zip(columns, _shrunk(widest, least, room), strict=True):
        column.width = wide
    columns[0].width = (columns[0].width or 0) + 1  # rich forgets its left blank
    return room + borders + len(columns) + 1


def _shrunk(widest: Sequence[int], least: Sequence[int], room: int) -> list[int]:
    """The widest give way first, none below its least."""
    widths = [max(pair) for pair in zip(widest, least, strict=True)]
    while sum(widths) > room:
        slack = [i for i, wide in enumerate(widths) if wide > least[i]]
        widths[max(slack, key=widths.__getitem__)] -= 1
    return widths


def _unbroken(column: Column) -> int:
    """Width of the longest word, and of the longest figure where a column holds figures."""
    words = _longest(column, str.split)
    if column.justify != "right":
        return words
    figures = [cell_len(text) for text in _texts(column)[1:] if any(map(str.isdigit, text))]
    return max(words, *figures, 0)


def _longest(column: Column, parts: Callable[[str], list[str]]) -> int:
    whole = column.no_wrap or parts is str.splitlines
    cut = str.splitlines if whole else parts
    longest = max((cell_len(part) for text in _texts(column) for part in cut(text)), default=1)
    return longest if whole else min(longest, _LONGEST_WORD)


def _texts(column: Column) -> list[str]:
    cells = [column.header, *column.cells]
    return [cell.plain if isinstance(cell, Text) else str(cell) for cell in cells]


T = TypeVar("T")

# Wide enough for every table of ours: in a file or a pipe there is no width to respect.
PIPE_WIDTH = 132


class _Console(Console):
    def print(self, *objects: Any, **options: Any) -> None:
        """Sheets become tables, which fit the width if their figures can be kept whole; in a file
        or a pipe no line ends in blanks."""
        objects = tuple(terminal_table(o) if isinstance(o, MetricTable) else o for o in objects)
        wide = max((fit_columns(o, self.width) for o in objects if isinstance(o, Table)), default=0)
        room = self.width
        self.width = max(room, wide)  # a terminal breaks long lines; figures cut off would be wrong
        try:
            self._print_fitting(objects, options)
        finally:
            self.width = room

    def _print_fitting(self, objects: tuple[Any, ...], options: dict[str, Any]) -> None:
        if self.is_terminal:
            super().print(*map(_Printable, objects), **options)
            return
        with self.capture() as captured:
            super().print(*objects, **options)
        self._write("\n".join(line.rstrip() for line in captured.get().split("\n")))

    def _write(self, text: str) -> None:
        try:
            self.file.write(printable(text, keep="\n"))
            self.file.flush()
        except BrokenPipeError:
            self.on_broken_pipe()

    def on_broken_pipe(self) -> None:
        """Leave it to the command, which is quiet about it; see `cli.main`."""
        raise BrokenPipeError


class _Printable:
    """Printed text without what a terminal would obey."""

    def __init__(self, content: Any) -> None:
        self._content = content

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> Iterator[Segment]:
        for segment in console.render(self._content, options):
            text = segment.text if segment.control else printable(segment.text, keep="\n")
            yield segment._replace(text=text)


def stdout_console() -> Console:
    """Return where tables go; names are shown as they are, brackets and colons too.

    As wide as the terminal, or as ``COLUMNS`` says; else wide enough for every table.
    """
    console = _Console(markup=False, emoji=False, highlight=False)
    if not console.is_terminal and not os.environ.get("COLUMNS", "").isdigit():
        console.width = PIPE_WIDTH
    return console


def with_progress(items: Iterable[T], total: int, what: str) -> Iterator[T]:
    """The items, with a bar on stderr while they come, if anyone watches."""
    step = max(1, total // 200)
    with progress_bar(what) as progress:
        for done, item in enumerate(items, start=1):
            yield item
            if done % step == 0 or done == total:
                progress(done, total)


@contextmanager
def progress_bar(what: str) -> Iterator[Callable[[int, int], None]]:
    """A function that takes what is done and the total, and shows both if anyone watches."""
    if not sys.stderr.isatty():
        yield lambda done, total: None
        return
    with Progress(
        TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(),
        console=Console(stderr=True), transient=True,
    ) as bar:  # fmt: skip
        task = bar.add_task(what, total=None)
        yield lambda done, total: bar.update(task, completed=done, total=total)
