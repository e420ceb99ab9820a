"""What the terminal shows."""

import csv
import io
from dataclasses import dataclass, field, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console

from procc_annotator.batch.agreement import AgreementInference, AgreementIntervals
from procc_annotator.batch.audit import PlotData
from procc_annotator.batch.comparison import ComparisonSummary
from procc_annotator.batch.grouping import NONE, clusters_of
from procc_annotator.batch.scoring import LeftOutMetrics
from procc_annotator.calibration.label_check.finding import (
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
)
from procc_annotator.cli.console import terminal_table
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.fit_record import FitCounts
from procc_annotator.metrics.agreement import AgreementMetrics, AgreementSummary
from procc_annotator.metrics.error_maps import MapSummary
from procc_annotator.metrics.legacy import MetricAverage
from procc_annotator.metrics.sets import ClassSummary, SetSummary
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.metrics.statistics.intervals import BootstrapSettings, Interval
from procc_annotator.report.agreement import intervals_described, sample_size_table
from procc_annotator.report.label_check import CheckReport, ReportedFinding, findings_csv
from procc_annotator.report.page.pairs import ReportedPair, legacy_section
from procc_annotator.report.scores.score_tables import (
    FrameRow,
    WorstFrames,
    classes_table,
    left_out_table,
    percent_text,
    pixels,
    summary_table,
)
from procc_annotator.report.tables.data_files import CRLF, csv_bytes
from procc_annotator.report.tables.metrics import LEGACY
from procc_annotator.report.tables.table import MetricTable, records
from procc_annotator.report.window_tables import (
    TABLE_COLUMNS,
    OverviewRow,
    overview_csv,
    plot_table,
)


def row(name: str, jac: float, error: float | None = 1.0) -> FrameRow:
    return FrameRow(name, jac, 1, 2, 3, False, error, "Middle line", 4.0)


def shown(sheet: MetricTable) -> str:
    stream = io.StringIO()
    Console(file=stream, width=140).print(terminal_table(sheet))
    return stream.getvalue()


def summary(**changes: object) -> SetSummary:
    figures = {
        "threshold": 5.0,
        "images": 4,
        "evaluated": 3,
        "mean_jac": 0.84938,
        "sd_jac": 0.1,
        "median_jac": 0.9,
        "completeness": 0.75,
        "final_score": 0.637,
        "mean_precision": None,
        "mean_recall": 0.5,
        "mean_reprojection_error": 1.234,
        "mean_error": 1.234,
        "per_class": {
            "Goal left post left ": ClassSummary(3, 1, 0),
            "Ghost": ClassSummary(0, 0, 2),
        },
    } | changes
    return SetSummary(**figures)


def test_summary_shows_what_it_was_computed_with_and_a_dash_for_the_undefined():
    text = shown(summary_table({5.0: summary()}, "procc, 1280x720"))
    assert "procc, 1280x720" in text
    assert "84.94" in text
    assert "75.00" in text
    assert "–" in text


def test_the_official_error_is_told_where_it_is_another_one():
    tied = summary(mean_reprojection_error=7.123)
    sheet = summary_table({2.0: tied, 5.0: summary()}, "soccernet")
    at = [column.key for column in sheet.columns].index("mean_error")
    assert [row[at] for row in sheet.rows] == [1.234, 1.234]
    assert sheet.notes == ("official error, of mirrored labels on a tie: 7.12 px at tau 2",)
    assert summary_table({5.0: summary()}, "soccernet").notes == ()


def test_a_class_without_prediction_has_no_precision():
    lines = shown(classes_table({5.0: summary(), 2.5: summary()}, "soccernet")).splitlines()
    (ghost,) = [line for line in lines if "Ghost" in line]
    assert "–" in ghost
    (post,) = [line for line in lines if "Goal left post left" in line]
    assert "75.00" in post
    assert any("JaC@2.5 %" in line for line in lines)


@given(st.lists(st.tuples(st.sampled_from([0.0, 0.25, 0.5, 1.0]), st.floats(0, 50)), max_size=40))
def test_worst_frames_are_those_of_a_full_sort(frames):
    worst = WorstFrames()
    rows = [row(f"{i}", jac, error) for i, (jac, error) in enumerate(frames)]
    for each in rows:
        worst.add(each)
    expected = sorted(rows, key=lambda r: (r.jac, -(r.mean_error or 0.0), int(r.name)))[:10]
    assert [r.name for r in worst.rows()] == [r.name for r in expected]


def test_undefined_figures_are_dashes():
    assert percent_text(None) == pixels(None) == percent_text(float("nan")) == pixels(np.nan) == "–"
    assert percent_text(0.5) == "50.00"
    assert pixels(1.005) in ("1.00", "1.01")


# How many frames a study of annotators needs, where that can be told.


def test_an_interval_that_ends_with_the_distances_tells_no_number_of_frames():
    overall = AgreementMetrics(9, 0, 0, 0, 99, 0, 2.0, 8.0, 9.0)
    summary = AgreementSummary(9, (), (), (), overall, {}, {})
    known = AgreementIntervals(
        {}, Interval(1.5, 2.5, 0.95, "t"), Interval(3.0, 9.0, 0.95, "t"), 9.0
    )
    rows = list(records(sample_size_table(AgreementInference(summary, known, 9), "", "")))
    needed = {title: [r["needed"] for r in rows if r["figure"] == title] for title in
              ("median, px", "95 %, px")}  # fmt: skip
    assert all(count is not None for count in needed["median, px"])
    assert needed["95 %, px"] == [None] * 3


def test_intervals_of_few_frames_are_told_to_be_unreliable():
    few, enough = (clusters_of([str(n) for n in range(count)], NONE, {}) for count in (4, 5))
    assert "fewer than 5 frames no interval is to be relied on" in intervals_described(
        BootstrapSettings(), few
    )
    assert "relied on" not in intervals_described(BootstrapSettings(), enough)


# Fits beside each other, and what goes for which of them.

ONE = FitCounts(1)


@dataclass
class Fits:
    ground_only: bool
    fitted: FitCounts = ONE
    held_out: LeftOutMetrics = field(default_factory=LeftOutMetrics)


def test_elements_off_the_ground_that_are_left_out_are_told():
    setup = EvaluationSetup(load_field("soccer"), (960, 540), off_plane="left_out")
    words = "off-plane elements left out"
    ground, pinholes = ("H", Fits(ground_only=True)), ("R", Fits(ground_only=False))
    method = ("theirs", Fits(ground_only=True, fitted=FitCounts()))
    alone = left_out_table([ground, method], [5.0], setup)
    assert words in alone.described
    both = left_out_table([ground, pinholes], [5.0], setup)
    assert words not in both.described
    assert [note for note in both.notes if words in note] == [f"H: soccernet, 960x540, {words}"]
    assert words not in " ".join(left_out_table([pinholes, method], [5.0], setup).notes)


# What a plot shows, as a table for a spreadsheet.


def test_a_table_leaves_out_what_is_undefined_and_runs_no_formula():
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


# Pairs of sources as sheets of a report.


def pair(name: str, frames: int, **fewer: int) -> ReportedPair:
    """A source of which some figures could be found in fewer frames than were compared."""
    spread = MapSummary(0.25, 0.5, 1.0)
    legacy = {
        figure.key: MetricAverage(0.75, 0.5, fewer.get(figure.key, frames)) for figure in LEGACY
    }
    return ReportedPair("true", name, ComparisonSummary(frames, (), spread, spread, 0.5, legacy))


def test_frames_are_told_of_each_figure_that_is_not_of_all_of_them():
    failed = ReportedPair("true", "none", None, failure="no camera can be read")
    sheet = legacy_section("true", [pair("a", 6), pair("b", 4, iou_whole=3), failed])
    keys = [column.key for column in sheet.columns]
    assert [key for key in keys if key.endswith("frames")] == ["frames", "iou_whole_frames"]
    place = keys.index("iou_whole_frames")
    assert sheet.columns[place].group == sheet.columns[place - 1].group
    rows = [dict(zip(keys, row, strict=True)) for row in sheet.rows]
    assert [(row["frames"], row["iou_whole_frames"]) for row in rows] == [(6, 6), (4, 3), (None, 0)]
    assert rows[1]["iou_whole_mean"] == rows[1]["iou_part_mean"] == 0.75


def test_frames_stand_once_where_they_are_the_same_for_every_figure():
    sheet = legacy_section("true", [pair("a", 6), pair("b", 4)])
    assert len(sheet.columns) == 2 + 2 * len(LEGACY)


# Findings as a table for a spreadsheet.

LOOK = Remedy(RemedyKind.LOOK, "look at it")


def rows(report: CheckReport) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(findings_csv(report).decode())))


def test_every_error_says_which_pixels_and_whose_camera():
    off = Finding(
        Rule.RESIDUAL, Severity.ERROR, ("Middle line",), "off", (LOOK,), 0, 20.0, model="R+"
    )
    bent = Finding(Rule.BENT, Severity.WARNING, ("Middle line",), "bent", (LOOK,))
    first, second = rows(
        CheckReport(
            found=[ReportedFinding("a", off, (960, 540)), ReportedFinding("b", bent, (1920, 1080))]
        )
    )
    assert (first["error_px"], first["model"]) == ("20.00", "R+")
    assert (first["width"], first["height"]) == ("960", "540")
    assert (second["error_px"], second["model"]) == ("", "")
    assert (second["width"], second["height"]) == ("1920", "1080")


def test_no_cell_is_run_as_a_formula():
    found = Finding(Rule.BENT, Severity.ERROR, ("=1+1",), "-bent", (LOOK,))
    report = CheckReport(
        found=[ReportedFinding("+a", found, (960, 540))], unreadable=[("@b", "=c.json: damaged")]
    )
    first, second = rows(report)
    assert (first["frame"], first["elements"], first["reason"]) == ("'+a", "'=1+1", "'-bent")
    assert (second["frame"], second["reason"]) == ("'@b", "'=c.json: damaged")


# The overview of a set: counts that add up, medians of what exists, and a table that is safe.

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


def test_an_empty_set_has_a_header_only():
    assert overview_csv([]).decode() == ",".join(TABLE_COLUMNS) + "\r\n"


def _table(rows: tuple[OverviewRow, ...]) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(overview_csv(rows).decode(), newline="")))


def test_the_table_has_a_row_a_frame_and_a_column_a_class():
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


def test_the_table_is_rfc_4180():
    row = replace(EMPTY, name='a,"b"\nc')
    head, rest = overview_csv([row]).decode().split("\r\n", 1)
    assert head == ",".join(TABLE_COLUMNS)
    assert rest == '"a,""b""\nc",untouched,0,0,0.0,0,0,,\r\n'
    assert _table((row,))[0]["name"] == row.name


@pytest.mark.parametrize("start", ["=", "+", "-", "@", "\t", "\r"])
def test_nothing_in_the_table_is_a_formula(start):
    text = start + "SUM(A1:A9)"
    row = replace(EMPTY, name=text, status=text, classes={text: 3}, origins={text: 3})
    for lines in csv.reader(io.StringIO(overview_csv([row]).decode(), newline="")):
        assert not any(cell.startswith(start) for cell in lines)
    assert _table((row,))[0]["name"] == "'" + text


def test_a_class_called_like_a_column_gets_its_own():
    table = _table((replace(EMPTY, name="a", classes={"name": 4}),))
    assert (table[0]["name"], table[0]["name (class)"]) == ("a", "4")
