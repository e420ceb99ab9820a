"""What the terminal shows."""

from __future__ import annotations

import io

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console

from procc_annotator.cli.console import terminal_table
from procc_annotator.metrics.sets import ClassSummary, SetSummary
from procc_annotator.report.scores.score_tables import (
    FrameRow,
    WorstFrames,
    classes_table,
    percent_text,
    pixels,
    summary_table,
)
from procc_annotator.report.tables.table import MetricTable


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


def test_summary_shows_what_it_was_computed_with_and_a_dash_for_the_undefined() -> None:
    text = shown(summary_table({5.0: summary()}, "procc, 1280x720"))
    assert "procc, 1280x720" in text
    assert "84.94" in text
    assert "75.00" in text
    assert "–" in text


def test_the_official_error_is_told_where_it_is_another_one() -> None:
    tied = summary(mean_reprojection_error=7.123)
    sheet = summary_table({2.0: tied, 5.0: summary()}, "soccernet")
    at = [column.key for column in sheet.columns].index("mean_error")
    assert [row[at] for row in sheet.rows] == [1.234, 1.234]
    assert sheet.notes == ("official error, of mirrored labels on a tie: 7.12 px at tau 2",)
    assert summary_table({5.0: summary()}, "soccernet").notes == ()


def test_a_class_without_prediction_has_no_precision() -> None:
    lines = shown(classes_table({5.0: summary(), 2.5: summary()}, "soccernet")).splitlines()
    (ghost,) = [line for line in lines if "Ghost" in line]
    assert "–" in ghost
    (post,) = [line for line in lines if "Goal left post left" in line]
    assert "75.00" in post
    assert any("JaC@2.5 %" in line for line in lines)


@given(st.lists(st.tuples(st.sampled_from([0.0, 0.25, 0.5, 1.0]), st.floats(0, 50)), max_size=40))
def test_worst_frames_are_those_of_a_full_sort(frames) -> None:
    worst = WorstFrames()
    rows = [row(f"{i}", jac, error) for i, (jac, error) in enumerate(frames)]
    for each in rows:
        worst.add(each)
    expected = sorted(rows, key=lambda r: (r.jac, -(r.mean_error or 0.0), int(r.name)))[:10]
    assert [r.name for r in worst.rows()] == [r.name for r in expected]


def test_undefined_figures_are_dashes() -> None:
    assert percent_text(None) == pixels(None) == percent_text(float("nan")) == pixels(np.nan) == "–"
    assert percent_text(0.5) == "50.00"
    assert pixels(1.005) in ("1.00", "1.01")
