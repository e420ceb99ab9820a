"""Confidence intervals of a comparison, and which of two methods is closer to a third."""

from __future__ import annotations

from collections.abc import Sequence

from procc_annotator.batch.comparison import (
    KEYS,
    SHARES,
    ComparedFrame,
    MetricWithInterval,
    closer_source,
    medians_with_intervals,
    metrics_with_intervals,
)
from procc_annotator.batch.grouping import Clusters
from procc_annotator.metrics.statistics.intervals import BootstrapSettings
from procc_annotator.metrics.statistics.significance import PairedDifference
from procc_annotator.report.agreement import intervals_described
from procc_annotator.report.scores.inference_tables import interval_ends
from procc_annotator.report.tables.metrics import (
    LEGACY,
    METRES,
    P_CORRECTED,
    P_VALUE,
    PIXELS,
    WITHIN,
)
from procc_annotator.report.tables.table import (
    Column,
    Metric,
    MetricTable,
    Row,
    count_column,
    metric_column,
)

# By the keys of `KEYS`; of the distances the median of a frame is meant.
_FIGURES: dict[str, Metric] = {
    "metres": METRES[1],
    "pixels": PIXELS[1],
    "within": WITHIN,
    **{figure.key: figure for figure in LEGACY},
}
_WORDS = {
    "metres": "frames' medians on the ground, m",
    "pixels": "frames' medians in the picture, px",
}
_ENDS = (
    Column("low", "low", "number", joined=" [{}, "),
    Column("high", "high", "number", joined="{}]"),
)


def comparison_intervals_table(
    frames: Sequence[ComparedFrame],
    clusters: Clusters,
    draws: BootstrapSettings,
    names: tuple[str, str],
    described: str,
    name: str = "intervals",
) -> MetricTable:
    """Every figure of a comparison with its interval.

    Args:
        frames: those compared. clusters: of them. draws: says the level.
        names: of the two sources. described: field and size.
        name: of the sheet.
    """
    known, medians = (
        metrics_with_intervals(frames, clusters, draws),
        medians_with_intervals(frames, clusters, draws),
    )
    rows: list[Row] = []
    figures: list[Metric] = []

    def add(over: str, key: str, found: MetricWithInterval) -> None:
        figures.append(_FIGURES[key])
        rows.append((_words(key), over, found.value, *interval_ends(found.interval), found.frames))

    for key in KEYS:
        add("share of all area" if key == "within" else "mean", key, known[key])
        if key in medians:
            add("median", key, medians[key])
    columns = (
        Column("figure", "figure"), Column("over", "over frames"),
        Column("value", "value", "number"), *_ENDS, count_column("frames"),
    )  # fmt: skip
    note = f"In brackets {intervals_described(draws, clusters)}."
    return MetricTable(
        name, f"{names[1]} against {names[0]}, intervals", columns, tuple(rows), described,
        (note,), of_rows=tuple(figures),
    )  # fmt: skip


def closer_method_table(
    pair: tuple[Sequence[ComparedFrame], Sequence[ComparedFrame]],
    clusters: Clusters,
    draws: BootstrapSettings,
    names: tuple[str, str, str],
    described: str,
) -> MetricTable:
    """Which of two sources is nearer to a third, figure by figure.

    Args:
        pair: the comparisons of each with the third, of the same frames. clusters: of these.
        names: of the third, and of the two.
        described: field and size.
    """
    found = closer_source(pair[0], pair[1], clusters, draws)
    columns = (
        Column("figure", "figure"),
        Column("difference", f"{names[1]} less {names[2]}", "number"),
        *_ENDS,
        count_column("frames", "frames of all"),
        metric_column(P_VALUE),
        metric_column(P_CORRECTED),
        Column("nearer", f"nearer to {names[0]}"),
    )
    rows = tuple(
        (_words(key), one.value, *interval_ends(one.interval), one.frames, one.p, one.corrected,
         _nearer(key, one, names[1:]))
        for key, one in found.items()
    )  # fmt: skip
    notes = (
        f"Means over the frames that all three have. In brackets"
        f" {intervals_described(draws, clusters)}; p corrected for {len(found)} figures,"
        f" {draws.count:,} exchanges, seed {draws.seed}.",
    )
    title = f"Is {names[1]} or {names[2]} nearer to {names[0]}"
    figures = tuple(_FIGURES[key] for key in found)
    return MetricTable("nearer", title, columns, rows, described, notes, of_rows=figures)


def _words(key: str) -> str:
    figure = _FIGURES[key]
    return _WORDS.get(key) or f"{figure.title}, {figure.unit}"


def _nearer(key: str, found: PairedDifference, names: Sequence[str]) -> str:
    if found.value is None or not found.beyond_chance:
        return "undecided"
    second = (found.value > 0) != (key in SHARES)
    return names[second]
