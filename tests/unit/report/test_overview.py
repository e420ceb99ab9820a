"""The overview of a set: counts that add up, medians of what exists, and a table that is safe."""

from __future__ import annotations

import csv
import io
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.dataset.filter_query import STATUSES
from procc_annotator.field.load import load_field
from procc_annotator.report.window_tables import (
    TABLE_COLUMNS,
    OverviewRow,
    StatusFigures,
    Times,
    overview_csv,
    summarise,
)

FIELD = load_field("soccer")
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


def test_the_figures_of_a_set() -> None:
    overview = summarise(iter(ROWS), FIELD)
    assert overview.frames == 4
    assert overview.progress == 0.5
    assert overview.points == 21
    assert overview.elements_per_frame == (1, 2, 0, 1)
    assert overview.median_elements == 1
    assert overview.times == Times(3, 180.0, 60.0)  # a frame nobody opened has no time
    assert (overview.scored, overview.median_jac) == (2, 0.75)
    assert (overview.comments, overview.open_comments) == (4, 2)
    assert overview.frames_with_open_comments == 2
    assert overview.origins == (("hand", 15), ("line fit", 6))


def test_statuses_are_all_there_in_their_order() -> None:
    odd = replace(EMPTY, status="second look", seconds=4.0)
    statuses = summarise([*ROWS, odd], FIELD).statuses
    assert tuple(s.status for s in statuses) == (*STATUSES, "second look")
    assert tuple(s.frames for s in statuses) == (1, 1, 1, 1, 0, 1)
    assert statuses[0] == StatusFigures("untouched", 1, 0.2, Times(0, 0.0, None))
    assert statuses[1].times == Times(1, 30.0, 30.0)
    assert statuses[-1].times == Times(1, 4.0, 4.0)


def test_classes_are_those_of_the_field_and_then_the_others() -> None:
    classes = summarise(ROWS, FIELD).classes
    assert [c.name for c in classes] == [*(e.name for e in FIELD.elements), "Corner flag"]
    by_name = {c.name: (c.title, c.frames, c.points) for c in classes}
    assert by_name["Circle left"] == ("Left penalty arc", 2, 16)
    assert by_name["Middle line"] == ("Halfway line", 1, 2)
    assert by_name["Goal left post left "] == ("Left goal left post", 1, 2)  # either spelling
    assert by_name["Corner flag"] == ("Corner flag", 1, 1)
    assert by_name["Circle right"] == ("Right penalty arc", 0, 0)


def test_an_empty_set_has_no_figures_and_no_errors() -> None:
    overview = summarise([], FIELD)
    assert overview.frames == 0
    assert (overview.progress, overview.median_jac, overview.median_elements) == (None,) * 3
    assert overview.elements_per_frame == ()
    assert overview.times == Times(0, 0.0, None)
    assert overview.time_histogram.counts == ()
    assert [s.share for s in overview.statuses] == [0.0] * 5
    assert overview_csv([]).decode() == ",".join(TABLE_COLUMNS) + "\r\n"


def _histogram(*seconds: float) -> tuple[float, tuple[int, ...], bool]:
    found = summarise([replace(EMPTY, seconds=s) for s in seconds], FIELD).time_histogram
    return found.step, found.counts, found.open_ended


def test_times_fall_into_round_bars() -> None:
    assert _histogram(0.0, 1.0, 1.5, 2.0, 5.0) == (1, (1, 2, 0, 0, 1), False)
    assert _histogram(100.0) == (5, (*[0] * 19, 1), False)
    assert _histogram(101.0) == (10, (*[0] * 10, 1), False)


def test_a_frame_left_open_over_lunch_does_not_squeeze_the_others() -> None:
    step, counts, open_ended = _histogram(*range(1, 41), 3600.0)
    assert (step, len(counts), open_ended) == (2, 20, True)
    assert counts == (*[2] * 19, 3)


@given(st.lists(st.floats(0, 1e6), max_size=60))
def test_every_time_is_counted_once(seconds) -> None:
    step, counts, _ = _histogram(*seconds)
    worked = [s for s in seconds if s > 0]
    assert sum(counts) == len(worked)
    assert len(counts) <= 20
    for i, count in enumerate(counts[:-1]):
        assert count == sum(i * step < s <= (i + 1) * step for s in worked)


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
def test_nothing_in_the_table_is_a_formula(start) -> None:
    text = start + "SUM(A1:A9)"
    row = replace(EMPTY, name=text, status=text, classes={text: 3}, origins={text: 3})
    for lines in csv.reader(io.StringIO(overview_csv([row]).decode(), newline="")):
        assert not any(cell.startswith(start) for cell in lines)
    assert _table((row,))[0]["name"] == "'" + text


def test_a_class_called_like_a_column_gets_its_own() -> None:
    table = _table((replace(EMPTY, name="a", classes={"name": 4}),))
    assert (table[0]["name"], table[0]["name (class)"]) == ("a", "4")
