"""How many frames a study of annotators needs, where that can be told."""

from __future__ import annotations

from procc_annotator.batch.agreement import AgreementInference, AgreementIntervals
from procc_annotator.batch.grouping import NONE, clusters_of
from procc_annotator.metrics.agreement import AgreementMetrics, AgreementSummary
from procc_annotator.metrics.statistics.intervals import BootstrapSettings, Interval
from procc_annotator.report.agreement import intervals_described, sample_size_table
from procc_annotator.report.tables.table import records


def test_an_interval_that_ends_with_the_distances_tells_no_number_of_frames() -> None:
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


def test_intervals_of_few_frames_are_told_to_be_unreliable() -> None:
    few, enough = (clusters_of([str(n) for n in range(count)], NONE, {}) for count in (4, 5))
    assert "fewer than 5 frames no interval is to be relied on" in intervals_described(
        BootstrapSettings(), few
    )
    assert "relied on" not in intervals_described(BootstrapSettings(), enough)
