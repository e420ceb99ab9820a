"""A sheet holds values; every kind of file writes the same ones."""

import csv
import io
import json
import math

import pytest
from rich.console import Console

from procc_annotator.cli.console import terminal_table
from procc_annotator.formats.csv_tables import unescape_formula
from procc_annotator.report.page.report import page_template
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes, table_entry
from procc_annotator.report.tables.table import (
    TAU,
    Column,
    Metric,
    MetricTable,
    Value,
    count_column,
    defined_count_column,
    definitions,
    display_table,
    metric_column,
)

LOW = Metric("low", "low", "%")
HIGH = Metric("high", "high", "%")


def sheet(*rows: tuple[Value, ...]) -> MetricTable:
    columns = (
        Column("source", "Source"),
        metric_column(metrics.MEAN_JAC, "@5", key="jac@5"),
        metric_column(LOW, joined=" [{}"),
        metric_column(HIGH, joined=", {}]"),
        metric_column(metrics.MEAN_ERROR),
        count_column("frames"),
        Column("fitted", "", "yes_no"),
    )
    return MetricTable("sources", "Sources", columns, rows, "soccernet, 960x540", ("A note.",))


def test_a_figure_is_shown_by_its_unit_and_digits():
    assert metrics.MEAN_JAC.text(0.38914) == "38.91"
    assert metrics.MEAN_ERROR.text(None) == metrics.MEAN_ERROR.text(math.nan) == "–"
    assert metrics.BIAS_DOWN.text(0.257) == "+0.26"
    assert metrics.BIAS_DOWN.text(-0.001) == "0.00"
    assert metrics.METRES[2].text(2444644.06) == "> 1000"
    assert metrics.DEVIATIONS[0].text(0.012345) == "0.0123"


def test_keys_of_figures_that_stand_together_differ():
    for together in (metrics.OF_SET, metrics.OF_CLASS, metrics.LEGACY, metrics.DEVIATIONS):
        assert len({figure.key for figure in together}) == len(together)


def test_columns_that_are_joined_share_a_cell_on_a_page():
    content = display_table(
        sheet(("a", 0.38, 0.36, 0.41, 2.0, 3, True), ("b", 0.4, None, None, 2.0, 3, False))
    )
    assert [column.heading for column in content.columns] == [
        "Source", "JaC@5 %", "mean error px", "frames", "",
    ]  # fmt: skip
    assert [cell.text for cell in content.rows[0]] == [
        "a",
        "38.00 [36.00, 41.00]",
        "2.00",
        "3",
        "yes",
    ]
    assert content.rows[1][1].text == "40.00"


def test_csv_holds_exact_values_and_no_formula():
    text = csv_bytes(sheet(("=1+1", 0.1 + 0.2, None, math.nan, 2.0, 3, True))).decode()
    head, row = csv.reader(io.StringIO(text))
    assert head == ["source", "jac@5", "low", "high", "mean_error", "frames", "fitted"]
    assert row == ["'=1+1", repr(0.1 + 0.2), "", "", "2.0", "3", "true"]


def test_a_number_below_zero_is_no_formula():
    columns = (
        Column("bias", kind="number", written=".2f"),
        Column("threshold", kind="number", written="shortest"),
    )
    assert csv_bytes(MetricTable("", "", columns, ((-1.0, 5.0), (-2.0, 2.5)))) == (
        b"bias,threshold\n-1.00,5\n-2.00,2.5\n"
    )


@pytest.mark.parametrize("text", ["=1", "+1", "-1", "@a", "\ta", "'=1", "''=1", "'a", "a", ""])
def test_a_cell_that_was_defused_reads_back_as_it_was(text):
    cells = csv_bytes(
        MetricTable("", "", (Column("text"), count_column("n")), ((text, 1),))
    ).decode()
    cell = list(csv.reader(io.StringIO(cells, newline="")))[1][0]
    assert not cell.startswith(("=", "+", "-", "@", "\t"))
    assert unescape_formula(cell) == text


def test_json_holds_the_same_values_and_null_for_what_is_undefined():
    entry = json.loads(json_bytes(table_entry(sheet(("=1", 0.25, None, math.nan, 2.0, 3, True)))))
    assert entry["rows"] == [
        {
            "source": "=1", "jac@5": 0.25, "low": None, "high": None,
            "mean_error": 2.0, "frames": 3, "fitted": True,
        }
    ]  # fmt: skip
    assert entry["described"] == "soccernet, 960x540"


def test_the_terminal_shows_title_terms_and_notes():
    console = Console(width=100, record=True, file=io.StringIO())
    console.print(terminal_table(sheet(("[red]", 0.25, 0.2, 0.3, None, 3, False))))
    text = console.export_text()
    for said in ("Sources  (soccernet, 960x540)", "[red]", "25.00 [20.00, 30.00]", "–", "A note."):
        assert said in text


def test_a_row_of_another_length_is_refused():
    with pytest.raises(ValueError, match="2 values, 1 columns"):
        MetricTable("odd", "", (Column("a"),), ((1, 2),))


def test_every_figure_and_count_says_what_it_means():
    """What a page's columns mean is told in one place, where they are listed."""
    found: list[Metric] = []
    for value in (*vars(metrics).values(), *vars(metrics).values()):
        found += [f for f in (value if isinstance(value, tuple) else [value]) if type(f) is Metric]
    assert len(found) > 60
    assert [f.key for f in found if not f.definition.endswith((".", ")"))] == []


def test_a_page_explains_its_columns_once():
    first = MetricTable(
        "a",
        "A",
        (Column("source"), metric_column(metrics.MEAN_JAC), defined_count_column(metrics.FRAMES)),
        (),
    )
    second = MetricTable(
        "b", "B", (metric_column(metrics.MEAN_JAC, "@5"), metric_column(metrics.JAC)), ()
    )
    told = definitions([first, second], also=[metrics.TP])
    assert [title for title, _ in told] == ["tp", "JaC, %", "frames"]
    assert told[1][1] == (metrics.MEAN_JAC.definition, metrics.JAC.definition)
    rows = MetricTable(
        "c", "C", (Column("figure"), TAU), (("median", 1.0),), of_rows=(metrics.MEDIAN_PX,)
    )
    assert definitions([rows]) == (("median, px", (metrics.MEDIAN_PX.definition,)),)
    assert f'title="{metrics.TP.definition}"' in page_template("table.html").module.table(
        MetricTable("d", "D", (Column("source"), defined_count_column(metrics.TP)), (("a", 1),))
    )
