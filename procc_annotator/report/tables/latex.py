"""Tables as LaTeX tabulars.

A table is made to fit the width it may have: headings break into lines, the type gets smaller, long
texts wrap; what is too wide even then goes on in a second part below the first, where the columns
that tell its rows apart stand again.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from procc_annotator.report.tables.table import Cell, DisplayTable, MetricTable, display_table

_GROUPS = {
    2.8: "ijl.,:;'`![]|",
    3.7: " f-I",
    4.0: "rst()",
    4.8: "cez?",
    5.3: "agovxyqk0123456789*/–$_",
    5.7: 'bdhnpuSJ"',
    7.3: "FELPBTw",
    7.9: "ACDGHKNOQRUVXYZ+<>=@&~",
    8.4: "%m#",
    10.3: "WM",
}
_WIDTHS = {character: width for width, group in _GROUPS.items() for character in group}
_UNKNOWN = 10.3
_BOLD = 1.16  # of the upright type's width


def text_width(text: str, *, bold: bool = False) -> float:
    """Width of a line of text, pt."""
    width = sum(_WIDTHS.get(character, _UNKNOWN) for character in text)
    return _BOLD * width if bold else width


COLUMN_PT = 229.0  # the narrowest in use: LaTeX's article with two columns
_WIDEST_COLUMN_PT = 260.0  # a wider table spans both columns, where a page has two

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
_ARROW_PT = 16.2
_LONGEST_TEXT = 0.3  # of the width, for a column of words in a table that is too wide
_LONGEST_NAMES = 0.45  # of the width, for all columns that are repeated


@dataclass(frozen=True, slots=True)
class _TableLayout:
    """How tightly a table is set: size of type, its width against the usual, space between
    columns in pt, whether headings break into lines and long texts wrap."""

    size: str
    scale: float
    apart_pt: float
    breaks: bool


_LAYOUTS = (
    _TableLayout("", 1.0, 12, breaks=False),
    _TableLayout("", 1.0, 12, breaks=True),
    _TableLayout(r"\small", 0.925, 10, breaks=True),
    _TableLayout(r"\footnotesize", 0.85, 6, breaks=True),
)


def escape_latex(text: str) -> str:
    """Text that LaTeX shows as it is; line breaks and control characters become spaces."""
    plain = re.sub(r"[\x00-\x1f\x7f]+", " ", text)
    # < and > come out as other characters in LaTeX's old encoding, which has no straight quotes.
    return "".join(_SPECIAL.get(character, character) for character in plain)


def latex_tables(
    sheets: Iterable[MetricTable], remarks: Iterable[str] = (), width_pt: float = COLUMN_PT
) -> str:
    """Several tables as one file; remarks go into comments at its head."""
    head = ["% " + " ".join(remark.split()) for remark in remarks]
    return "\n".join([*head, *(f"\n{latex_table(sheet, width_pt)}" for sheet in sheets)]) + "\n"


def latex_table(sheet: MetricTable, width_pt: float = COLUMN_PT) -> str:
    """One table; best values are bold, dashes stand for what is undefined.

    Args:
        width_pt: it may have; beyond that of a column it spans both columns of a page.
    """
    content = display_table(sheet)
    every = range(len(content.columns))
    look = next(
        (k for k in _LAYOUTS if _LaidOutTable(content, k, width_pt).fits(every)), _LAYOUTS[-1]
    )
    setting = _LaidOutTable(content, look, width_pt)
    kind = "table*" if width_pt > _WIDEST_COLUMN_PT else "table"
    lines = [rf"\begin{{{kind}}}", r"\centering", *([look.size] if look.size else [])]
    if look.apart_pt != _LAYOUTS[0].apart_pt:
        lines.append(rf"\setlength{{\tabcolsep}}{{{look.apart_pt / 2:g}pt}}")
    for number, part in enumerate(setting.parts()):
        lines += [*([r"\par\medskip"] if number else []), *setting.tabular(part)]
    notes = [f"{escape_latex(note)}" for note in content.notes]
    caption = " ".join([f"{escape_latex(content.caption)}.", *notes])
    return "\n".join([*lines, rf"\caption{{{caption}}}", rf"\end{{{kind}}}"])


class _LaidOutTable:
    """A table set in one look."""

    def __init__(self, content: DisplayTable, look: _TableLayout, width_pt: float) -> None:
        self._content, self._look, self._width_pt = content, look, width_pt
        self._widths = [self._column_width(at) for at in range(len(content.columns))]

    def fits(self, columns: Sequence[int]) -> bool:
        """Whether these columns side by side are no wider than they may be."""
        return self._width(columns) <= self._width_pt

    def parts(self) -> list[list[int]]:
        """The columns of each part; those that tell the rows apart are repeated, and a group stays
        together where it can."""
        parts: list[list[int]] = []
        at = self._content.naming
        named = range(at)
        while at < len(self._content.columns):
            end = self._end_of_group(at)
            if not self.fits([*named, *range(at, end)]):
                end = at + 1
            together = list(range(at, end))
            if parts and self.fits([*parts[-1], *together]):
                parts[-1] += together
            else:
                parts.append([*named, *together])
            at = end
        return parts or [[*named]]

    def tabular(self, columns: Sequence[int]) -> list[str]:
        """Some of its columns as a tabular."""
        layout = "".join("r" if self._content.columns[at].numeric else "l" for at in columns)
        lines = [rf"\begin{{tabular}}{{{layout}}}", r"\hline"]
        spans = self._spans(columns)
        if any(name for name, _ in spans):
            lines.append(" & ".join(self._span(name, own) for name, own in spans) + r" \\")
        lines.append(" & ".join(map(self._heading, columns)) + r" \\")
        lines.append(r"\hline")
        for at, row in enumerate(self._content.rows):
            if at and at in self._content.parts:
                lines.append(r"\hline")
            lines.append(" & ".join(self._cell(row[i], i) for i in columns) + r" \\")
        return [*lines, r"\hline", r"\end{tabular}"]

    def _end_of_group(self, at: int) -> int:
        group, end = self._content.columns[at].group, at + 1
        while group and end < len(self._widths) and self._content.columns[end].group == group:
            end += 1
        return end

    def _spans(self, columns: Sequence[int]) -> list[tuple[str, list[int]]]:
        """Groups with their columns."""
        spans: list[tuple[str, list[int]]] = []
        for at in columns:
            group = self._content.columns[at].group
            if group and spans and spans[-1][0] == group:
                spans[-1][1].append(at)
            else:
                spans.append((group, [at]))
        return spans

    def _width(self, columns: Sequence[int]) -> float:
        total = 0.0
        for name, own in self._spans(columns):
            below = sum(self._widths[at] for at in own) + (len(own) - 1) * self._look.apart_pt
            total += max(below, self._words_width([name])) if name else below
            total += self._look.apart_pt
        return total

    def _words_width(self, texts: Iterable[str], *, bold: bool = False) -> float:
        """Of the widest text, or of its widest word where headings break."""
        parts = [w for text in texts for w in (text.split() if self._look.breaks else [text])]
        return self._look.scale * max((text_width(part, bold=bold) for part in parts), default=0.0)

    def _column_width(self, at: int) -> float:
        column = self._content.columns[at]
        arrow = _ARROW_PT * self._look.scale if column.better else 0.0
        heading = self._words_width([column.heading])
        heading = max(heading, arrow) if self._look.breaks else heading + arrow
        cells = [row[at] for row in self._content.rows]
        widest = max(map(self._cell_width, cells), default=0.0)
        if self._look.breaks and not column.numeric:
            word = self._words_width(re.sub("([/.,;_-])", r"\1 ", cell.text) for cell in cells)
            widest = min(widest, max(self._wraps(at), word))
        return max(heading, widest)

    def _wraps(self, at: int) -> float:
        """How wide a column of words is at most where its words allow it."""
        naming = self._content.naming
        share = min(_LONGEST_TEXT, _LONGEST_NAMES / naming) if at < naming else _LONGEST_TEXT
        return share * self._width_pt

    def _cell_width(self, cell: Cell) -> float:
        return self._look.scale * text_width(cell.text, bold=cell.bold)

    def _heading(self, at: int) -> str:
        column = self._content.columns[at]
        words = column.heading.split()
        lines = self._lines([*words, *([column.better] if column.better else [])], [at])
        return self._stacked(lines, "r" if column.numeric else "l")

    def _span(self, name: str, own: Sequence[int]) -> str:
        if not name:
            return ""
        stacked = self._stacked(self._lines(name.split(), own), "c")
        return rf"\multicolumn{{{len(own)}}}{{c}}{{{stacked}}}"

    def _lines(self, words: Sequence[str], own: Sequence[int]) -> list[str]:
        """Words in as many lines as it takes to be no wider than their columns; one that says what
        is better is an arrow."""
        room = sum(self._widths[at] for at in own) + (len(own) - 1) * self._look.apart_pt
        lines: list[tuple[str, float]] = []
        for word in words:
            text = _ARROWS.get(word) or escape_latex(word)
            width = self._look.scale * (_ARROW_PT if word in _ARROWS else text_width(word))
            longer = lines[-1][1] + self._look.scale * text_width(" ") + width if lines else 0.0
            if lines and (longer <= room or not self._look.breaks):
                lines[-1] = f"{lines[-1][0]} {text}", longer
            else:
                lines.append((text, width))
        return [text for text, _ in lines]

    def _stacked(self, lines: Sequence[str], side: str) -> str:
        if len(lines) < 2:
            return "".join(lines)
        stack = r"\\".join(lines)
        return rf"\begin{{tabular}}[b]{{@{{}}{side}@{{}}}}{stack}\end{{tabular}}"

    def _cell(self, cell: Cell, at: int) -> str:
        text = escape_latex(cell.text)
        if cell.bold:
            text = rf"\textbf{{{text}}}"
        if self._cell_width(cell) <= self._widths[at] or self._content.columns[at].numeric:
            return text
        text = re.sub(r"(\\_|[/.,;-])(?=\w)", r"\1\\allowbreak{}", text)
        return rf"\parbox[t]{{{self._widths[at]:.1f}pt}}{{\raggedright {text}\strut}}"
