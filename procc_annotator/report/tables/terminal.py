"""Tables on the terminal and as plain text, fitted to its width."""

from __future__ import annotations

from typing import TYPE_CHECKING

from procc_annotator.report.tables.table import MetricTable, display_table

if TYPE_CHECKING:
    from rich.table import Table


def terminal_table(sheet: MetricTable) -> Table:
    """Title and what the figures rest on, headings, rows, notes."""
    from rich.table import Table
    from rich.text import Text

    heading = Text(sheet.title, "bold")
    if sheet.described:
        heading = Text.assemble((sheet.title, "bold"), "  ", (f"({sheet.described})", "dim"))
    table = Table(
        title=heading,
        title_justify="left",
        title_style="",
        header_style="bold",
        caption="\n".join(sheet.notes) or None,
        caption_justify="left",
    )
    content = display_table(sheet)
    for column in content.columns:
        named = f"{column.group}\n{column.heading}" if column.group else column.heading
        table.add_column(named, justify="right" if column.numeric else "left")
    for at, row in enumerate(content.rows):
        if at in content.parts:
            table.add_section()
        table.add_row(*(Text(cell.text, "bold" if cell.bold else "") for cell in row))
    return table
