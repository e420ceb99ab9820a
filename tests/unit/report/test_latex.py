"""LaTeX tables show names as they are and can be pasted without any package."""

from __future__ import annotations

from procc_annotator.metric.spread import Spread
from procc_annotator.report.page.latex import escape_latex, latex_table, latex_tables
from procc_annotator.report.page.report_pairs import ReportedPair, disagreement_section
from procc_annotator.report.page.report_tables import Cell, ReportColumn, ReportTable
from procc_annotator.session.runs.comparison_run import ComparisonSummary


def test_every_special_character_is_escaped() -> None:
    assert escape_latex(r"\a{b}") == r"\textbackslash{}a\{b\}"
    assert escape_latex("50 % of $x_1$ & #2 ~ ^") == (
        r"50 \% of \$x\_1\$ \& \#2 \textasciitilde{} \textasciicircum{}"
    )
    assert escape_latex("a\nb\x00c") == "a b c"
    assert escape_latex("–") == "--"


def test_a_table_has_as_many_cells_in_every_line() -> None:
    columns = (
        ReportColumn("Source", numeric=False),
        ReportColumn("a", +1, "one & only"),
        ReportColumn("b", -1, "one & only"),
        ReportColumn("c"),
    )
    rows = ((Cell("x_y"), Cell("1.00", best=True), Cell("–"), Cell("2")),)
    text = latex_table(ReportTable("Caption 5 %", columns, rows))
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
    spread = Spread(0.25, 0.5, 2444644.06)
    summary = ComparisonSummary(1, (), spread, spread, 0.5, {})
    text = latex_table(disagreement_section([ReportedPair("a", "b", summary)]))
    assert "2444644" not in text
    assert text.count(r"0.25 & 0.50 & \textgreater{} 1000") == 2
