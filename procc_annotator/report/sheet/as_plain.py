"""A sheet as plain text: in a file or a pipe nothing of a table has a colour."""

from __future__ import annotations

from collections.abc import Sequence

from procc_annotator.report.sheet.sheet import Sheet
from procc_annotator.report.sheet.shown import as_texts

Lines = list[str]


def plain_table(sheet: Sheet, width: int) -> str | None:
    """What `terminal_table` shows, without colours, where nothing of it has to be broken.

    Args:
        sheet: title, headings, rows, notes.
        width: columns there are.

    Returns:
        Its lines; None if it does not fit, or has characters that show nothing.
    """
    content = as_texts(sheet)
    columns = content.columns
    headings = [_lines(f"{c.group}\n{c.heading}" if c.group else c.heading) for c in columns]
    rows = [[_lines(cell.text) for cell in row] for row in content.rows]
    about = _lines(f"{sheet.title}  ({sheet.described})" if sheet.described else sheet.title)
    notes = _lines("\n".join(sheet.notes)) if sheet.notes else []
    if not headings or not _are_plain([about, notes, *headings, *(c for row in rows for c in row)]):
        return None
    widths = [max(map(_widest, column)) for column in zip(headings, *rows, strict=True)]
    whole = sum(widths) + 3 * len(widths) + 1
    if whole > width:
        return None
    right = [column.numeric for column in columns]
    high = max(map(len, headings))
    raised = [[""] * (high - len(lines)) + lines for lines in headings]
    text = [*_broken(about, whole), _rule("┏━┳┓", widths), *_row(raised, widths, right, "┃")]
    text.append(_rule("┡━╇┩", widths))
    for at, row in enumerate(rows):
        if at and at in content.parts:
            text.append(_rule("├─┼┤", widths))
        text += _row(row, widths, right, "│")
    text += [_rule("└─┴┘", widths), *_broken(notes, whole)]
    return "".join(f"{line.rstrip()}\n" for line in text)


def _lines(text: str) -> Lines:
    return text.split("\n")


def _are_plain(cells: Sequence[Lines]) -> bool:
    return all(line.isprintable() and line == line.strip() for lines in cells for line in lines)


def _widest(lines: Lines) -> int:
    from rich.cells import cell_len

    return max(map(cell_len, lines))


def _row(cells: Sequence[Lines], widths: Sequence[int], right: Sequence[bool], edge: str) -> Lines:
    found = []
    for at in range(max(map(len, cells))):
        padded = []
        for lines, width, to_the_right in zip(cells, widths, right, strict=True):
            line = lines[at] if at < len(lines) else ""
            blank = " " * (width - _widest([line]))
            padded.append(blank + line if to_the_right else line + blank)
        found.append(f"{edge} " + f" {edge} ".join(padded) + f" {edge}")
    return found


def _rule(drawn: str, widths: Sequence[int]) -> str:
    """Drawn with the left edge, the line, what is between columns, and the right edge."""
    left, line, between, right = tuple(drawn)
    return left + between.join(line * (width + 2) for width in widths) + right


def _broken(lines: Lines, width: int) -> Lines:
    """Between words, where they are longer than the table is wide."""
    if not lines or _widest(lines) <= width:
        return lines
    from rich.console import Console
    from rich.text import Text

    found = Text("\n".join(lines)).wrap(Console(), width, justify="left")
    return [line.plain for line in found]
