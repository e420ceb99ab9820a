"""Tables as CSV, JSON and LaTeX."""

from __future__ import annotations

import math
import re
import textwrap
import unicodedata
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from itertools import groupby
from typing import Any

import msgspec

from procc_annotator.formats.csv_tables import encode_rows, escape_formula
from procc_annotator.report.tables.table import (
    Cell,
    Column,
    DisplayTable,
    Metric,
    MetricTable,
    Row,
    Value,
    display_table,
    records,
    shortest_number,
    spans,
)

CRLF = "\r\n"  # what RFC 4180 asks for


def csv_bytes(sheet: MetricTable, *, line_end: str = "\n") -> bytes:
    """Header and rows, UTF-8."""
    rows = csv_rows(sheet.columns, sheet.rows, line_end=line_end)
    return csv_header(sheet.columns, line_end=line_end) + rows


def csv_header(columns: Sequence[Column], *, line_end: str = "\n") -> bytes:
    """The first line, of a file that is written row by row."""
    return encode_rows([[escape_formula(column.key) for column in columns]], line_end)


def csv_rows(columns: Sequence[Column], rows: Iterable[Row], *, line_end: str = "\n") -> bytes:
    """More lines of such a file."""
    forms = [column.written for column in columns]
    return encode_rows(([*map(_written, row, forms)] for row in rows), line_end)


def _written(value: Value, form: str) -> str | int | float:
    if value is None:
        return ""
    if isinstance(value, str):
        return escape_formula(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if not math.isfinite(value):
        return ""
    if form == "shortest":
        return shortest_number(value)
    return f"{value:{form}}" if form else value


def metric_entry(figures: Iterable[Metric], values: object) -> dict[str, Any]:
    """Figures by their keys, taken from values that have them as attributes."""
    return {figure.key: figure.of(values) for figure in figures}


def table_entry(sheet: MetricTable) -> dict[str, Any]:
    """A whole sheet: what it shows, and its rows by the keys of the columns."""
    return {
        "title": sheet.title,
        "described": sheet.described,
        "notes": list(sheet.notes),
        "rows": list(records(sheet)),
    }


def json_bytes(content: Any, *, indent: int = 1) -> bytes:
    """A file for people and programs."""
    return msgspec.json.format(encoded(content), indent=indent) + b"\n"


def encoded(content: Any) -> bytes:
    """As short as it can be; of a file's name that is no valid Unicode the bytes are spelled."""
    try:
        return msgspec.json.encode(content, enc_hook=_as_plain)
    except UnicodeEncodeError:
        plain = msgspec.to_builtins(content, enc_hook=_as_plain, str_keys=True)
        return msgspec.json.encode(_all_writable(plain))


def writable(text: str) -> str:
    """Text that any file can hold: names of files need not be valid Unicode."""
    return text.encode("utf-8", "backslashreplace").decode("utf-8")


def _all_writable(content: Any) -> Any:
    if isinstance(content, dict):
        return {writable(key): _all_writable(value) for key, value in content.items()}
    if isinstance(content, list | tuple):
        return [_all_writable(value) for value in content]
    return writable(content) if isinstance(content, str) else content


def _as_plain(value: object) -> str:
    """Words that know how they are said in other languages: files keep the English ones. msgspec
    expects a `NotImplementedError` for what cannot be written."""
    if isinstance(value, str):
        return str(value)
    raise NotImplementedError(f"{type(value).__name__} cannot be written as JSON")


# The column of usual two-column styles is 229 pt wide: every tabular fits into it.
_COLUMN_PT = 218.0  # estimated widths are up to 5 % too small
_SMALLER = 0.95  # width of \scriptsize to \footnotesize
_MOST_LINES = 44  # of a page in \scriptsize
_GAP_PT = 6.0
_WRAPPED_PT = 120.0  # of a column of sentences
_CHARACTER_PT = 4.4  # of \footnotesize: a digit has 4.25
_THIN_PT, _BROAD_PT = 2.6, 6.6
_THIN, _BROAD = frozenset(" .,:;!|'()[]ijlt-"), frozenset("ABCDEFGHKMNOPQRUVWXYZmw+±×%@−<>&")

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
    "\ufeff": "{}",
    "−": "$-$",
    "²": r"\textsuperscript{2}",
    "°": r"\textdegree{}",
    "†": r"\textdagger{}",
    "‡": r"\textdaggerdbl{}",
    "§": r"\S{}",
}
_MATH = """alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma
tau upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega leq geq"""
_SIGNS = "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΥΦΨΩ≤≥"
_SPECIAL |= zip(_SIGNS, (rf"$\{name}$" for name in _MATH.split()), strict=True)
# pdfLaTeX sets these without further packages (measured).
_SET = re.compile(r"[ -~\xa0-\u017f‐-―‘’“”•…‰€™←-↓](?<![«»ÐÞðþĄąĐđĘęĦħĮįĸĿŀŉŊŋŦŧŲųſ])")
_BETTER = {"higher": "(↑)", "lower": "(↓)"}
_ARROWS = {"higher": r"($\uparrow$)", "lower": r"($\downarrow$)"}
_HEADING = 5  # characters
_HEADING_LINES = 4


def escape_latex(text: str) -> str:
    """Text that LaTeX shows as it is; line breaks and control characters become spaces. Letters
    that pdfLaTeX lacks lose their accents, other such characters become U+XXXX."""
    plain = unicodedata.normalize("NFC", re.sub(r"[\x00-\x1f\x7f]+", " ", text))
    plain = plain.replace("--", "-\ufeff-")  # two hyphens of an option are no dash
    # < and > come out as other characters in LaTeX's old encoding, which has no straight quotes.
    return "".join(_SPECIAL.get(c) or (c if _SET.match(c) else _replacement(c)) for c in plain)


def _replacement(character: str) -> str:
    letters = unicodedata.normalize("NFKD", character).encode("ascii", "ignore").decode()
    return letters if letters.isalnum() else f"U+{ord(character):04X}"


def latex_tables(sheets: Iterable[MetricTable], remarks: Iterable[str] = ()) -> str:
    """Several tables as one file; remarks go into comments at its head. A table without rows only
    adds its notes to the one before it."""
    remarks = (*remarks, r"needs \usepackage{booktabs, adjustbox}; U+XXXX: no glyph")
    head = ["% " + " ".join(remark.split()) for remark in remarks]
    shown: list[MetricTable] = []
    for sheet in sheets:
        if sheet.rows or not shown:
            shown.append(sheet)
        else:
            shown[-1] = replace(shown[-1], notes=(*shown[-1].notes, *sheet.notes))
    return "\n".join([*head, *(f"\n{latex_table(sheet)}" for sheet in shown)]) + "\n"


def latex_table(sheet: MetricTable) -> str:
    """One table; best values are bold, dashes stand for what is undefined.

    Widths are estimated from the characters. What is wider than a column is split into several
    tabulars, each with the columns that name its rows, in a ``table*``: LaTeX sets two next to each
    other if the text has room for them. What is longer than a page is continued.
    """
    content = display_table(sheet)
    every = [*range(len(content.columns))]
    narrow = _width_pt(content, every) <= _COLUMN_PT
    columns = [every] if narrow else _split_columns(content)
    kind, size = ("table", "footnotesize") if narrow else ("table*", "scriptsize")
    most = max(1, min(len(content.rows), _MOST_LINES - _HEADING_LINES))
    pieces = [
        _latex_tabular(content, some, slice(first, first + most))
        for first in range(0, len(content.rows) or 1, most)
        for some in columns
    ]
    two = 2.1 * max(_width_pt(content, some) for some in columns)  # next to each other
    stacked = max(1, _MOST_LINES // (most + _HEADING_LINES))
    notes = " ".join([f"{escape_latex(content.caption)}.", *map(escape_latex, content.notes)])
    begin = rf"\begin{{{kind}}}\centering\{size}\setlength{{\tabcolsep}}{{3pt}}\lineskip=6pt"
    title = f"{escape_latex(sheet.title)} (continued)."
    end, again = rf"\end{{{kind}}}", rf"\addtocounter{{table}}{{-1}}\caption{{{title}}}"
    lines = [begin, rf"\caption{{{notes}}}\label{{tab:{sheet.name}}}"]
    for at, piece in enumerate(pieces):
        if at and at % (2 * stacked) == 0:
            lines += [end, "", begin, again]
        elif at and at % stacked == 0:
            lines.append(rf"\ifdim\linewidth<{two:.0f}pt{end}{begin}{again}\else\quad\fi")
        elif at:
            lines.append(r"\quad")
        lines.append(piece)
    return "\n".join([*lines, end])


def _latex_tabular(content: DisplayTable, chosen: Sequence[int], rows: slice) -> str:
    columns = [content.columns[at] for at in chosen]
    wrapped = f"p{{{_WRAPPED_PT:g}pt}}"
    layout = "".join(
        "r" if content.columns[at].numeric else wrapped if _wraps(content, at) else "l"
        for at in chosen
    )
    lines = [
        r"\begin{adjustbox}{max width=\linewidth}",
        rf"\begin{{tabular}}[b]{{{layout}}}",
        r"\toprule",
    ]
    if groups := spans(columns):
        lines.append(" & ".join(map(_span, groups)) + r" \\")
    headings = (_heading(content.columns[at], _lines(content, at)) for at in chosen)
    lines += [" & ".join(headings) + r" \\", r"\midrule"]
    for at, row in enumerate(content.rows[rows], rows.start):
        if at > rows.start and at in content.parts:
            lines.append(r"\midrule")
        lines.append(" & ".join(_cell(row[place]) for place in chosen) + r" \\")
    return "\n".join([*lines, r"\bottomrule", r"\end{tabular}", r"\end{adjustbox}"])


def _split_columns(content: DisplayTable) -> list[list[int]]:
    """Places of the columns of each tabular: those that name rows, and as many others as fit;
    columns of a group stay together."""
    columns = content.columns
    named = next((at for at, c in enumerate(columns) if c.definition or c.better), len(columns))
    found = [[*range(named)]]
    for _, run in groupby(range(named, len(columns)), lambda at: columns[at].group or at):
        own = [*run]
        if _width_pt(content, found[-1] + own) > _COLUMN_PT / _SMALLER and found[-1][named:]:
            found.append([*range(named)])
        found[-1] += own
    return found


def _width_pt(content: DisplayTable, chosen: Sequence[int]) -> float:
    width = 0.0
    for group, run in groupby(chosen, lambda at: content.columns[at].group):
        own = 0.0
        for at in run:
            own += _GAP_PT + (_WRAPPED_PT if _wraps(content, at) else _column_pt(content, at))
        width += max(own, _GAP_PT + _text_pt(group))
    return width


def _column_pt(
    content: DisplayTable, at: int, parts: Callable[[str], list[str]] | None = None
) -> float:
    """The widest cell or heading; with ``parts`` the widest of their words."""
    texts = [*_lines(content, at), *(row[at].text for row in content.rows)]
    return max((_text_pt(w) for t in texts for w in (parts(t) if parts else [t])), default=0.0)


def _wraps(content: DisplayTable, at: int) -> bool:
    """Whether a column of text is set in several lines."""
    words = _column_pt(content, at, str.split)
    return not content.columns[at].numeric and words <= _WRAPPED_PT < _column_pt(content, at)


def _text_pt(text: str) -> float:
    thin, broad = (sum(map(kind.__contains__, text)) for kind in (_THIN, _BROAD))
    return thin * _THIN_PT + broad * _BROAD_PT + (len(text) - thin - broad) * _CHARACTER_PT


def _lines(content: DisplayTable, at: int) -> list[str]:
    """The lines of a heading, about as long as the cells below it."""
    column = content.columns[at]
    text = f"{column.heading} {_BETTER[column.better]}" if column.better else column.heading
    longest = max((len(row[at].text) for row in content.rows), default=0)
    return textwrap.wrap(text, max(longest, _HEADING), break_long_words=False) or [""]


def _span(group: tuple[str, int]) -> str:
    name, columns = group
    if name:
        return rf"\multicolumn{{{columns}}}{{c}}{{{escape_latex(name)}}}"
    return " & " * (columns - 1)


def _heading(column: Column, lines: Sequence[str]) -> str:
    texts = [escape_latex(line) for line in lines]
    if column.better:
        texts[-1] = texts[-1].replace(_BETTER[column.better], _ARROWS[column.better])
    if not texts[1:]:
        return texts[0]
    side, joined = "r" if column.numeric else "l", r"\\".join(texts)
    return rf"\shortstack[{side}]{{{joined}}}"


def _cell(cell: Cell) -> str:
    text = escape_latex(cell.text)
    return rf"\textbf{{{text}}}" if cell.bold else text
