"""Tables as LaTeX tabulars."""

from __future__ import annotations

import re
from collections.abc import Iterable

from procc_annotator.report.tables.table import Cell, DisplayColumn, MetricTable, display_table

_MOST_COLUMNS = 8  # of figures in one column of a page: more would be shrunk below half their size

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
    '"': "''",
    "–": "--",
    "²": r"\textsuperscript{2}",
    "°": r"\textdegree{}",
}
_ARROWS = {"higher": r"($\uparrow$)", "lower": r"($\downarrow$)"}


def escape_latex(text: str) -> str:
    """Text that LaTeX shows as it is; line breaks and control characters become spaces."""
    plain = re.sub(r"[\x00-\x1f\x7f]+", " ", text)
    # < and > come out as other characters in LaTeX's old encoding, which has no straight quotes.
    return "".join(_SPECIAL.get(character, character) for character in plain)


def latex_tables(sheets: Iterable[MetricTable], remarks: Iterable[str] = ()) -> str:
    """Several tables as one file; remarks go into comments at its head."""
    remarks = (*remarks, r"needs \usepackage{booktabs, adjustbox}")
    head = ["% " + " ".join(remark.split()) for remark in remarks]
    return "\n".join([*head, *(f"\n{latex_table(sheet)}" for sheet in sheets)]) + "\n"


def latex_table(sheet: MetricTable) -> str:
    """One table; best values are bold, dashes stand for what is undefined.

    One of many columns spans both columns of a page that has two.
    """
    content = display_table(sheet)
    kind = "table*" if len(content.columns) > _MOST_COLUMNS else "table"
    layout = "".join("r" if column.numeric else "l" for column in content.columns)
    lines = [
        rf"\begin{{{kind}}}", r"\centering", r"\begin{adjustbox}{max width=\linewidth}",
        rf"\begin{{tabular}}{{{layout}}}", r"\toprule",
    ]  # fmt: skip
    if content.groups:
        lines.append(" & ".join(map(_span, content.groups)) + r" \\")
    lines += [" & ".join(map(_heading, content.columns)) + r" \\", r"\midrule"]
    for at, row in enumerate(content.rows):
        if at and at in content.parts:
            lines.append(r"\midrule")
        lines.append(" & ".join(map(_cell, row)) + r" \\")
    caption = " ".join([f"{escape_latex(content.caption)}.", *map(escape_latex, content.notes)])
    lines += [r"\bottomrule", r"\end{tabular}", r"\end{adjustbox}", rf"\caption{{{caption}}}"]
    return "\n".join([*lines, rf"\end{{{kind}}}"])


def _span(group: tuple[str, int]) -> str:
    name, columns = group
    if name:
        return rf"\multicolumn{{{columns}}}{{c}}{{{escape_latex(name)}}}"
    return " & " * (columns - 1)


def _heading(column: DisplayColumn) -> str:
    text = escape_latex(column.heading)
    return f"{text} {_ARROWS[column.better]}" if column.better else text


def _cell(cell: Cell) -> str:
    text = escape_latex(cell.text)
    return rf"\textbf{{{text}}}" if cell.bold else text
