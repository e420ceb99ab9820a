"""Tables on a narrow terminal: headings break between words, figures stay whole."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rich.cells import cell_len
from rich.table import Column, Table
from rich.text import Text

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
    """Heading and cells."""
    cells = [column.header, *column.cells]
    return [cell.plain if isinstance(cell, Text) else str(cell) for cell in cells]
