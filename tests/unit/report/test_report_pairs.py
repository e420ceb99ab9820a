"""Pairs of sources as sheets of a report."""

from __future__ import annotations

from procc_annotator.batch.comparison import ComparisonSummary
from procc_annotator.metrics.error_maps import MapSummary
from procc_annotator.metrics.legacy import MetricAverage
from procc_annotator.report.page.pairs import ReportedPair, legacy_section
from procc_annotator.report.tables.metrics import LEGACY


def pair(name: str, frames: int, **fewer: int) -> ReportedPair:
    """A source of which some figures could be found in fewer frames than were compared."""
    spread = MapSummary(0.25, 0.5, 1.0)
    legacy = {
        figure.key: MetricAverage(0.75, 0.5, fewer.get(figure.key, frames)) for figure in LEGACY
    }
    return ReportedPair("true", name, ComparisonSummary(frames, (), spread, spread, 0.5, legacy))


def test_frames_are_told_of_each_figure_that_is_not_of_all_of_them() -> None:
    failed = ReportedPair("true", "none", None, failure="no camera can be read")
    sheet = legacy_section("true", [pair("a", 6), pair("b", 4, iou_whole=3), failed])
    keys = [column.key for column in sheet.columns]
    assert [key for key in keys if key.endswith("frames")] == ["frames", "iou_whole_frames"]
    place = keys.index("iou_whole_frames")
    assert sheet.columns[place].group == sheet.columns[place - 1].group
    rows = [dict(zip(keys, row, strict=True)) for row in sheet.rows]
    assert [(row["frames"], row["iou_whole_frames"]) for row in rows] == [(6, 6), (4, 3), (None, 0)]
    assert rows[1]["iou_whole_mean"] == rows[1]["iou_part_mean"] == 0.75


def test_frames_stand_once_where_they_are_the_same_for_every_figure() -> None:
    sheet = legacy_section("true", [pair("a", 6), pair("b", 4)])
    assert len(sheet.columns) == 2 + 2 * len(LEGACY)
