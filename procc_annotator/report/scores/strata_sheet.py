"""Sources over the parts of a set, as a sheet; where two differ most comes first."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

from procc_annotator.report.scores.chance_sheets import (
    DIFFERENCES,
    WITH_INTERVAL,
    interval_columns,
    interval_ends,
)
from procc_annotator.report.sheet.counts import FRAMES
from procc_annotator.report.sheet.figure import Metric
from procc_annotator.report.sheet.figures import JAC_DIFFERENCE, MEAN_JAC, P_CORRECTED, P_VALUE
from procc_annotator.report.sheet.sheet import TAU, Column, MetricTable, Value, defined_count_column, metric_column
from procc_annotator.session.runs.certainty import Inference
from procc_annotator.session.runs.strata import Stratum


def strata_table(
    parts: Sequence[Stratum], certainty: Inference, tau: float, described: str
) -> MetricTable:
    """JaC of every source and the difference of every two, with intervals, for each part.

    Args:
        parts: at least one. certainty: of the whole set. tau: px, one of its thresholds.
    """
    by, ordered = parts[0].by, _most_different_first(parts, tau)
    rows: list[tuple[Value, ...]] = []
    bold: set[tuple[int, int]] = set()
    for part in ordered:
        row: list[Value] = [part.value or "(none)", len(part.certainty.sources[0].frames)]
        at = certainty.thresholds.index(tau)
        for source, ends in zip(part.certainty.sources, part.certainty.intervals, strict=True):
            own = source.ratios("mean_jac")
            count = float(own.denominators[:, at].sum())
            row += [float(own.parts[:, at].sum()) / count if count else None]
            row += interval_ends(ends["mean_jac", tau])
        for (a, b), found in part.differences.get(("mean_jac", tau), {}).items():
            if found.beyond_chance and certainty.can_be_bold(a, b, "mean_jac"):
                bold.add((len(rows), len(row)))
            row += [found.value, *interval_ends(found.interval), found.corrected]
        rows.append(tuple(row))
    notes = (
        f"In brackets {certainty.described}. The part where two sources differ most comes first; p"
        " is corrected for all parts and pairs. Bold: beyond chance.",
        *_cautions(parts),
    )
    return MetricTable(
        f"by_{by}", f"By {by}", _columns(certainty, by, tau), tuple(rows), described, notes,
        frozenset(bold),
    )  # fmt: skip


def strata_metrics_table(parts: Sequence[Stratum], certainty: Inference, described: str) -> MetricTable:
    """Every figure of every source in each part at every threshold, with intervals."""
    by = parts[0].by
    columns = [Column("value", by), Column("source", "source"), TAU, defined_count_column(FRAMES)]
    for figure in WITH_INTERVAL:
        columns += [metric_column(figure), *interval_columns(figure)]
    rows: list[tuple[Value, ...]] = []
    begins = []
    for part in parts:
        begins.append(len(rows))
        frames = len(part.certainty.sources[0].frames)
        for source, ends in zip(part.certainty.sources, part.certainty.intervals, strict=True):
            sums = {figure.key: source.ratios(figure.key) for figure in WITH_INTERVAL}
            for at, tau in enumerate(certainty.thresholds):
                row: list[Value] = [part.value or "(none)", source.marked_name, tau, frames]
                for key, ratios in sums.items():
                    whole = float(ratios.denominators[:, at].sum())
                    row.append(float(ratios.parts[:, at].sum()) / whole if whole else None)
                    row += interval_ends(ends[key, tau])
                rows.append(tuple(row))
    notes = (f"In brackets {certainty.described}.", *_cautions(parts))
    return MetricTable(
        f"by_{by}_figures", f"By {by}, every figure", tuple(columns), tuple(rows), described, notes,
        parts=tuple(begins[1:]),
    )  # fmt: skip


def strata_differences_table(
    parts: Sequence[Stratum], certainty: Inference, described: str
) -> MetricTable:
    """The differences of every two sources in each part, figure by figure; for files."""
    by = parts[0].by
    names = [source.marked_name for source in certainty.sources]
    columns = [Column("value", by), TAU, Column("a", "A"), Column("b", "B")]
    for figure, key in DIFFERENCES:
        columns += [metric_column(figure), *interval_columns(figure), defined_count_column(FRAMES, key=f"{key}_frames")]
        columns += [metric_column(f, key=f"{key}_{f.key}", group=figure.title) for f in (P_VALUE, P_CORRECTED)]
    rows: list[tuple[Value, ...]] = []
    for part, tau in product(parts, certainty.thresholds):
        for pair in part.differences["mean_jac", tau]:
            row: list[Value] = [part.value or "(none)", tau, names[pair[0]], names[pair[1]]]
            for _, key in DIFFERENCES:
                found = part.differences[key, tau][pair]
                row += [found.value, *interval_ends(found.interval), found.frames]
                row += [found.p, found.corrected]
            rows.append(tuple(row))
    note = (
        "p is corrected for all parts and pairs, of each figure at each tau;"
        f" {certainty.described}."
    )
    return MetricTable(
        f"by_{by}_differences", f"By {by}, differences", tuple(columns), tuple(rows), described,
        (note,),
    )  # fmt: skip


def _columns(certainty: Inference, by: str, tau: float) -> tuple[Column, ...]:
    names = [source.marked_name for source in certainty.sources]
    columns = [Column("value", by), defined_count_column(FRAMES)]
    for name in names:
        columns += _with_interval(MEAN_JAC, f"JaC@{tau:g} %", name)
    for pair in certainty.pairs:
        less = f"{names[pair.a]} less {names[pair.b]}"
        columns += _with_interval(JAC_DIFFERENCE, "points", less)
        columns.append(metric_column(P_CORRECTED, key=f"{P_CORRECTED.key} {less}", group=less))
    return tuple(columns)


def _cautions(parts: Sequence[Stratum]) -> tuple[str, ...]:
    """Of the part that has the fewest clusters."""
    fewest = min(parts, key=lambda part: part.certainty.clusters.count).certainty
    where = "" if len(parts) < 2 else "In the part with the fewest: "
    return tuple(
        f"{where}{said[0].lower()}{said[1:]}" if where else said for said in fewest.cautions
    )


def _with_interval(figure: Metric, heading: str, group: str) -> list[Column]:
    first = metric_column(figure, key=f"{figure.key} {group}", heading=heading, group=group)
    ends = (replace(c, key=f"{c.key} {group}", group=group) for c in interval_columns(figure))
    return [first, *ends]


def _most_different_first(parts: Sequence[Stratum], tau: float) -> list[Stratum]:
    def most(part: Stratum) -> float:
        own = part.differences.get(("mean_jac", tau), {})
        return max((abs(d.value or 0.0) for d in own.values()), default=0.0)

    return sorted(parts, key=lambda part: -most(part))
