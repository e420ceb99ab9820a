"""LaTeX tables show names as they are and fit the text."""

import re
import shutil
import subprocess

import pytest

from procc_annotator.batch.comparison import ComparisonSummary
from procc_annotator.metrics.error_maps import MapSummary
from procc_annotator.report.page.pairs import ReportedPair, disagreement_section
from procc_annotator.report.tables.data_files import escape_latex, latex_table, latex_tables
from procc_annotator.report.tables.table import Column, Metric, MetricTable, metric_column


def test_every_special_character_is_escaped():
    assert escape_latex(r"\a{b}") == r"\textbackslash{}a\{b\}"
    assert escape_latex("50 % of $x_1$ & #2 ~ ^") == (
        r"50 \% of \$x\_1\$ \& \#2 \textasciitilde{} \textasciicircum{}"
    )
    assert escape_latex("a\nb\x00c") == "a b c"
    assert escape_latex("–") == "--"
    assert escape_latex("α≤ é e\u0301 ą ﬁ 日") == r"$\alpha$$\leq$ é é a fi U+65E5"
    assert escape_latex("calibrate --leave-one-out") == "calibrate -{}-leave-one-out"


def test_a_table_has_as_many_cells_in_every_line():
    columns = (
        Column("source", "Source"),
        metric_column(Metric("a", "a", better="higher"), group="one & only"),
        metric_column(Metric("b", "b", better="lower"), group="one & only"),
        metric_column(Metric("c", "c", digits=0)),
    )
    rows = (("x_y", 1.0, None, 2.0),)
    text = latex_table(MetricTable("s", "Caption 5 %", columns, rows, bold=frozenset({(0, 1)})))
    lines = [line for line in text.splitlines() if line.endswith(r"\\")]
    assert r"\begin{tabular}[b]{lrrr}" in text
    assert [line.replace(r"\&", "").count("&") for line in lines] == [2, 3, 3]  # two are spanned
    assert r"\multicolumn{2}{c}{one \& only}" in lines[0]
    assert lines[1] == r"Source & a ($\uparrow$) & b ($\downarrow$) & c \\"
    assert lines[2] == r"x\_y & \textbf{1.00} & -- & 2 \\"
    assert r"\caption{Caption 5 \%.}\label{tab:s}" in text


def test_remarks_cannot_leave_their_comment():
    text = latex_tables([], ["one\n\\input{secret}"])
    assert text.splitlines()[0] == r"% one \input{secret}"


def test_distances_next_to_a_horizon_are_told_as_on_the_terminal():
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


@pytest.mark.parametrize(("width_pt", "shrunk"), [(229, True), (345, True), (505, False)])
def test_latex_sets_every_table_within_the_text(tmp_path, width_pt, shrunk):
    """LaTeX itself says whether it can set them; the text of two columns holds them unshrunk."""
    pdflatex, find = shutil.which("pdflatex"), shutil.which("kpsewhich")
    if pdflatex is None or find is None or subprocess.run([find, "adjustbox.sty"]).returncode:
        pytest.skip("pdflatex with adjustbox is not here")
    strange = MetricTable(
        "s",
        'a\\b_&%$#{}~^<>|"–²°',
        (Column("x", "<|x|>"), metric_column(Metric("y", "y"))),
        (
            ('100 % \\input{x} ~^ "quoted" a|b {–} 3² 4°', 1.0),
            ("αΩ≤ 日本 Ж é ő Ą ﬁ ß € … 😀 «ʼ» ư\xa0Đ", 1.0),
        ),
    )
    tables = latex_tables([*(_wide(columns) for columns in (2, 5, 9)), strange])
    # All but the last are wider than a column: each tabular has as many figures as fit.
    parts = [len(re.findall(r"begin.tabular", part)) for part in tables.split(r"\label{tab:")[1:]]
    assert parts == [2, 5, 9, 1]
    if not shrunk:
        tables = re.sub(r"\\(begin|end)\{adjustbox\}(\{.*\})?", "", tables)
    setup = (
        "\\documentclass{article}\\usepackage{booktabs, adjustbox}"
        f"\\setlength{{\\textwidth}}{{{width_pt}pt}}"
    )
    document = setup + "\\begin{document}\n" + tables + "\\end{document}\n"
    (tmp_path / "a.tex").write_text(document, encoding="utf-8")
    done = subprocess.run(
        [pdflatex, "-interaction=nonstopmode", "-halt-on-error", "a.tex"],
        cwd=tmp_path, capture_output=True, text=True, errors="replace", timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-2000:]
    assert "Overfull" not in done.stdout
