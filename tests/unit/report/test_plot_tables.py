"""What a plot shows, as a table for a spreadsheet."""

from __future__ import annotations

import csv
import io

import numpy as np

from procc_annotator.batch.audit import PlotData
from procc_annotator.report.tables.data_files import CRLF, csv_bytes
from procc_annotator.report.window_tables import plot_table


def test_a_table_leaves_out_what_is_undefined_and_runs_no_formula() -> None:
    table = PlotData(
        ("number", "name", "=jac"),
        (np.arange(1, 4), ["=cmd()", "b, c", "d"], np.array([0.5, np.nan, 1 / 3])),
    )
    written = csv_bytes(plot_table(table), line_end=CRLF).decode()
    assert written.count(CRLF) == 4
    assert list(csv.reader(io.StringIO(written))) == [
        ["number", "name", "'=jac"],
        ["1", "'=cmd()", "0.5"],
        ["2", "b, c", ""],
        ["3", "d", "0.333333"],
    ]
    empty = PlotData(("number", "jac"), (np.arange(0), np.zeros(0)))
    assert csv_bytes(plot_table(empty)) == b"number,jac\n"
