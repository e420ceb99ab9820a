"""LaTeX tables show names as they are and can be pasted without any package."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from procc_annotator.batch.comparison import ComparisonSummary
from procc_annotator.metrics.error_maps import MapSummary
from procc_annotator.report.page.pairs import ReportedPair, disagreement_section
from procc_annotator.report.tables.latex import escape_latex, latex_table, latex_tables
from procc_annotator.report.tables.table import TAU, Column, Metric, MetricTable, metric_column


def test_every_special_character_is_escaped() -> None:
    assert escape_latex(r"\a{b}") == r"\textbackslash{}a\{b\}"
    assert escape_latex("50 % of $x_1$ & #2 ~ ^") == (
        r"50 \% of \$x\_1\$ \& \#2 \textasciitilde{} \textasciicircum{}"
    )
    assert escape_latex("a\nb\x00c") == "a b c"
    assert escape_latex("–") == "--"


def test_a_table_has_as_many_cells_in_every_line() -> None:
    columns = (
        Column("source", "Source"),
        metric_column(Metric("a", "a", better="higher"), group="one & only"),
        metric_column(Metric("b", "b", better="lower"), group="one & only"),
        metric_column(Metric("c", "c", digits=0)),
    )
    rows = (("x_y", 1.0, None, 2.0),)
    text = latex_table(MetricTable("s", "Caption 5 %", columns, rows, bold=frozenset({(0, 1)})))
    lines = [line for line in text.splitlines() if line.endswith(r"\\")]
    assert r"\begin{tabular}{lrrr}" in text
    assert [line.replace(r"\&", "").count("&") for line in lines] == [2, 3, 3]  # two are spanned
    assert r"\multicolumn{2}{c}{one \& only}" in lines[0]
    assert lines[1] == r"Source & a ($\uparrow$) & b ($\downarrow$) & c \\"
    assert lines[2] == r"x\_y & \textbf{1.00} & -- & 2 \\"
    assert r"\caption{Caption 5 \%.}" in text


def test_remarks_cannot_leave_their_comment() -> None:
    text = latex_tables([], ["one\n\\input{secret}"])
    assert text.splitlines() == [r"% one \input{secret}"]


def test_distances_next_to_a_horizon_are_told_as_on_the_terminal() -> None:
    spread = MapSummary(0.25, 0.5, 2444644.06)
    summary = ComparisonSummary(1, (), spread, spread, 0.5, {})
    text = latex_table(disagreement_section([ReportedPair("a", "b", summary)]))
    assert "2444644" not in text
    assert text.count(r"0.25 & 0.50 & \textgreater{} 1000") == 2


def _wide(columns: int) -> MetricTable:
    error = Metric("error", "reprojection error of everything", "px", "lower")
    named = Column("source", "Source"), Column("words", "Words")
    row = ("a_source_with_a_name_that_is_rather_long", "many words " * 9, *[1234.5] * columns)
    return MetricTable(
        "wide", "Wide", (*named, *[metric_column(error, f"@{i}") for i in range(columns)]), (row,)
    )


def test_a_table_that_is_too_wide_is_set_smaller_and_goes_on_below() -> None:
    for columns in (2, 5, 9):
        text = latex_table(_wide(columns))
        parts = re.findall(r"\\begin\{tabular\}\{(.*)\}", text)
        assert sum(part.count("r") for part in parts) == columns
        assert text.count(r"\begin{tabular}") == text.count(r"\end{tabular}")
        assert r"\parbox[t]" in text  # long words wrap
    assert len(parts) > 1
    assert text.count("rather") == len(parts)  # the source stands before each part


def _of_several_taus() -> MetricTable:
    """As tables of intervals are: source and tau tell the rows apart."""
    error = Metric("error", "mean error", "px", "lower", digits=2)
    columns = [Column("part", "Part"), Column("source", "Source"), TAU]
    for name in ("jac", "score", "error"):
        columns.append(metric_column(error, key=name, heading=name))
        columns.append(metric_column(error, key=f"{name}_low", joined=" [{}, "))
        columns.append(metric_column(error, key=f"{name}_high", joined="{}]"))
    rows = tuple(
        (f"focal 1260 to {focal} px of the_same", source, tau, *[100.0] * 9)
        for focal in (1877, 2460)
        for source in ("PnLCalib", "Another")
        for tau in (2.0, 5.0)
    )
    return MetricTable("taus", "Taus", tuple(columns), rows)


def test_every_part_of_a_table_tells_its_rows_apart() -> None:
    text = latex_table(_of_several_taus(), 229.0)
    parts = text.split(r"\par\medskip")
    assert len(parts) > 1
    for part in parts:
        lines = [line for line in part.splitlines() if "100.00" in line]
        assert len(set(lines)) == len(lines) == 8


def test_what_has_room_enough_is_set_as_it_is() -> None:
    sheet = MetricTable(
        "small", "Small", (Column("a", "Two words"), metric_column(Metric("b", "b"))), (("x", 1.0),)
    )
    assert latex_table(sheet).splitlines()[2:5] == [
        r"\begin{tabular}{lr}",
        r"\hline",
        r"Two words & b \\",
    ]


def test_a_wide_table_is_for_both_columns_of_a_page() -> None:
    text = latex_table(_wide(5), 500.0)
    assert text.startswith(r"\begin{table*}")
    assert text.endswith(r"\end{table*}")


def test_latex_sets_every_table_within_the_text(tmp_path: Path) -> None:
    """With no package beside the article: what it draws is asked of LaTeX itself."""
    pdflatex = shutil.which("pdflatex")
    if pdflatex is None:
        pytest.skip("pdflatex is not here")
    strange = MetricTable(
        "s",
        'a\\b_&%$#{}~^<>|"–²°',
        (Column("x", "<|x|>"), metric_column(Metric("y", "y"))),
        (('100 % \\input{x} ~^ "quoted" a|b {–} 3² 4°', 1.0),),
    )
    tables = latex_tables([*(_wide(columns) for columns in (2, 5, 9)), strange])
    tables += latex_table(_of_several_taus())
    setup = (
        "\\documentclass{article}\\setlength{\\textwidth}{229pt}\\setlength{\\columnwidth}{229pt}"
    )
    document = setup + "\\begin{document}\n" + tables + "\\end{document}\n"
    (tmp_path / "a.tex").write_text(document, encoding="utf-8")
    done = subprocess.run(
        [pdflatex, "-interaction=nonstopmode", "-halt-on-error", "a.tex"],
        cwd=tmp_path, capture_output=True, text=True, errors="replace", timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-2000:]
    assert "Overfull" not in done.stdout
