"""The overview table of a set: a row per frame, in CSV that is safe."""

from __future__ import annotations

import csv
import io
from dataclasses import replace

import pytest

from procc_annotator.report.window_tables import TABLE_COLUMNS, OverviewRow, overview_csv

EMPTY = OverviewRow("a", "untouched", {}, 0.0, 0, 0, None, {})
ROWS = (
    EMPTY,
    OverviewRow(
        "b", "in_progress", {"Circle left": 9, "Middle line": 0}, 30.0, 2, 1, None, {"hand": 9}
    ),
    OverviewRow(
        "c",
        "approved",
        {"Circle left": 7, "Goal left post left": 2, "Corner flag": 1},
        90.0,
        1,
        0,
        0.5,
        {"hand": 4, "line fit": 6},
        "blind",
    ),
    OverviewRow("d", "done", {"Middle line": 2}, 60.0, 1, 1, 1.0, {"hand": 2}),
)


def test_an_empty_set_has_a_header_only() -> None:
    assert overview_csv([]).decode() == ",".join(TABLE_COLUMNS) + "\r\n"


def _table(rows: tuple[OverviewRow, ...]) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(overview_csv(rows).decode(), newline="")))


def test_the_table_has_a_row_a_frame_and_a_column_a_class() -> None:
    table = _table(ROWS)
    assert list(table[0]) == [
        *TABLE_COLUMNS, "points_hand", "points_line_fit",
        "Circle left", "Corner flag", "Goal left post left", "Middle line",
    ]  # fmt: skip
    assert table[2] == {
        "name": "c", "status": "approved", "elements": "3", "points": "10", "seconds": "90.0",
        "comments": "1", "open_comments": "0", "jac": "0.5", "blind": "blind",
        "points_hand": "4",
        "points_line_fit": "6", "Circle left": "7", "Corner flag": "1",
        "Goal left post left": "2", "Middle line": "0",
    }  # fmt: skip
    assert table[1]["elements"] == "1"  # a class without points counts as absent
    assert table[0]["jac"] == ""


def test_the_table_is_rfc_4180() -> None:
    row = replace(EMPTY, name='a,"b"\nc')
    head, rest = overview_csv([row]).decode().split("\r\n", 1)
    assert head == ",".join(TABLE_COLUMNS)
    assert rest == '"a,""b""\nc",untouched,0,0,0.0,0,0,,\r\n'
    assert _table((row,))[0]["name"] == row.name


@pytest.mark.parametrize("start", ["=", "+", "-", "@", "\t", "\r"])
def test_nothing_in_the_table_is_a_formula(start: str) -> None:
    text = start + "SUM(A1:A9)"
    row = replace(EMPTY, name=text, status=text, classes={text: 3}, origins={text: 3})
    for lines in csv.reader(io.StringIO(overview_csv([row]).decode(), newline="")):
        assert not any(cell.startswith(start) for cell in lines)
    assert _table((row,))[0]["name"] == "'" + text


def test_a_class_called_like_a_column_gets_its_own() -> None:
    table = _table((replace(EMPTY, name="a", classes={"name": 4}),))
    assert (table[0]["name"], table[0]["name (class)"]) == ("a", "4")
