"""A sheet as a table of a page; every text is escaped."""

from __future__ import annotations

from html import escape

from procc_annotator.report.sheet.sheet import MetricTable
from procc_annotator.report.sheet.shown import Cell, DisplayColumn, display_table

_ARROWS = {"higher": ("more is better", "↑"), "lower": ("less is better", "↓")}


_SHORT = 6  # rows that stay on one printed page


def html_table(sheet: MetricTable, *, sortable: bool = False) -> str:
    """The table within a box that scrolls where it is too wide; the keyboard can scroll it, too.

    Args:
        sortable: says what it can be sorted by, for the page's own script.
    """
    content = display_table(sheet)
    caption = escape(content.caption)
    classes = f"wide{' short' if len(content.rows) <= _SHORT else ''}"
    lines = [
        f'<div class="{classes}" tabindex="0" role="region" aria-label="{caption}">',
        '<table class="sortable">' if sortable else "<table>",
        f"<caption><span>{caption}</span></caption>",
        "<thead>",
        *_groups(content.groups),
        "<tr>",
        *(_heading(column) for column in content.columns),
        "</tr>",
        "</thead>",
        "<tbody>",
    ]
    for row in content.rows:
        cells = (_cell(c, cell) for c, cell in zip(content.columns[1:], row[1:], strict=True))
        head = f'<th scope="row"{_side(content.columns[0])}>{escape(row[0].text)}</th>'
        lines += ["<tr>", head, *cells, "</tr>"]
    lines += ["</tbody>", "</table>", *(f"<p>{escape(note)}</p>" for note in content.notes)]
    return "\n".join([*lines, "</div>\n"])


def _groups(groups: tuple[tuple[str, int], ...]) -> list[str]:
    if not groups:
        return []
    cells = [
        f'<th scope="colgroup" colspan="{width}">{escape(name)}</th>'
        if name
        else f'<td colspan="{width}"></td>'
        for name, width in groups
    ]
    return ["<tr>", *cells, "</tr>"]


def _heading(column: DisplayColumn) -> str:
    arrow = ""
    if column.better is not None:
        meaning, sign = _ARROWS[column.better]
        arrow = f'&nbsp;<span role="img" aria-label="{meaning}">{sign}</span>'
    means = f' title="{escape(column.definition)}"' if column.definition else ""
    return f'<th scope="col"{_side(column)}{means}>{escape(column.heading)}{arrow}</th>'


def _cell(column: DisplayColumn, cell: Cell) -> str:
    text = escape(cell.text).replace(", ", ",&nbsp;") if column.numeric else escape(cell.text)
    return f"<td{_side(column)}>{f'<strong>{text}</strong>' if cell.bold else text}</td>"


def _side(column: DisplayColumn) -> str:
    return ' class="number"' if column.numeric else ""
