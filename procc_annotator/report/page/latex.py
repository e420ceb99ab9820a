"""Tables of a report as LaTeX, ready to paste: plain tabular with rules, no package needed."""

from __future__ import annotations

import re
from collections.abc import Iterable

from procc_annotator.report.page.report_tables import Cell, ReportTable

_SPECIAL = {
    "\\": r"\textbackslash{}",
    "&": r"\&",
    "%": r"\%",
    "$": r"\$",
    "#": r"\#",
    "_": r"\_",
    "{": r"\{",
    "}": r"\}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    '"': r"\textquotedbl{}",
    "–": "--",
    "²": r"\textsuperscript{2}",
}


def escape_latex(text: str) -> str:
    """Text that LaTeX shows as it is; line breaks and control characters become spaces."""
    plain = re.sub(r"[\x00-\x1f\x7f]+", " ", text)
    # Straight double quotes, < and > come out as other characters in LaTeX's old encoding.
    return "".join(_SPECIAL.get(character, character) for character in plain)


def latex_tables(tables: Iterable[ReportTable], remarks: Iterable[str] = ()) -> str:
    """Several tables as one file; remarks go into comments at its head."""
    head = ["% " + " ".join(remark.split()) for remark in remarks]
    return "\n".join([*head, *(f"\n{latex_table(table)}" for table in tables)]) + "\n"


def latex_table(table: ReportTable) -> str:
    """One table; best values are bold, dashes stand for what is undefined."""
    layout = "".join("r" if column.numeric else "l" for column in table.columns)
    lines = [r"\begin{table}", r"\centering", rf"\begin{{tabular}}{{{layout}}}", r"\hline"]
    if table.groups:
        lines.append(" & ".join(_span(name, width) for name, width in table.groups) + r" \\")
    lines.append(" & ".join(_heading(c.heading, c.better) for c in table.columns) + r" \\")
    lines.append(r"\hline")
    lines += [" & ".join(_cell(cell) for cell in row) + r" \\" for row in table.rows]
    lines += [
        r"\hline",
        r"\end{tabular}",
        rf"\caption{{{escape_latex(table.caption)}.}}",
        r"\end{table}",
    ]
    return "\n".join(lines)


def _heading(text: str, better: int) -> str:
    arrow = {1: r" ($\uparrow$)", -1: r" ($\downarrow$)"}.get(better, "")
    return escape_latex(text) + arrow


def _span(name: str, width: int) -> str:
    return rf"\multicolumn{{{width}}}{{c}}{{{escape_latex(name)}}}" if name else "& " * (width - 1)


def _cell(cell: Cell) -> str:
    text = escape_latex(cell.text)
    return rf"\textbf{{{text}}}" if cell.best else text
