"""How surely figures are known, as sheets: intervals, differences, ranks, curves, frames needed."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from procc_annotator.metric.chance.intervals import Interval
from procc_annotator.metric.chance.paired import PairedDifference, min_clusters_for_significance
from procc_annotator.metric.chance.power import required_frames, minimum_detectable_difference
from procc_annotator.metric.sets import SetSummary
from procc_annotator.report.sheet.counts import FRAMES, FRAMES_FOR, FRAMES_ONLY_A, FRAMES_ONLY_B, RANK, SHARED
from procc_annotator.report.sheet.figure import Metric
from procc_annotator.report.sheet.figures import (
    BEST_IN,
    COMPLETENESS,
    ERROR_DIFFERENCE,
    FINAL_SCORE,
    JAC_DIFFERENCE,
    MINIMUM_DETECTABLE_DIFFERENCE,
    MEAN_ERROR,
    MEAN_JAC,
    P_CORRECTED,
    P_VALUE,
    SCORE_DIFFERENCE,
)
from procc_annotator.report.sheet.sheet import TAU, Column, MetricTable, Value, defined_count_column, metric_column
from procc_annotator.session.runs.audit import TAU_GRID
from procc_annotator.session.runs.certainty import Inference

WITH_INTERVAL = (MEAN_JAC, COMPLETENESS, FINAL_SCORE, MEAN_ERROR)
DIFFERENCES = (
    (JAC_DIFFERENCE, "mean_jac"),
    (SCORE_DIFFERENCE, "final_score"),
    (ERROR_DIFFERENCE, "mean_error"),
)
POINTS = (0.01, 0.02, 0.05)  # differences that a set should tell, as shares
_POWER = 0.8
_CURVE_STEP = 5  # of `TAU_GRID`, in a file


def inference_tables(
    certainty: Inference,
    summaries: Sequence[Mapping[float, SetSummary]],
    described: str,
    *,
    power: bool = False,
) -> list[MetricTable]:
    """Everything that can be told of some sources; of a single one there is nothing to compare.

    Args:
        summaries: the figures of each source, by threshold.
        described: protocol, size and options.
        power: whether to say how many frames are needed.
    """
    sheets = [intervals_table(certainty, summaries, described)]
    if certainty.pairs:
        sheets += [differences_table(certainty, described), ranks_table(certainty, described)]
    if power:
        sheets.append(power_table(certainty, described))
    return sheets


def intervals_table(
    certainty: Inference, summaries: Sequence[Mapping[float, SetSummary]], described: str
) -> MetricTable:
    """Every mean of every source with its interval."""
    columns = [Column("source", "source"), TAU]
    for figure in WITH_INTERVAL:
        columns += [metric_column(figure), *interval_columns(figure)]
    rows = []
    for source, found, summary in zip(
        certainty.sources, certainty.intervals, summaries, strict=True
    ):
        for tau in certainty.thresholds:
            row: list[Value] = [source.marked_name, tau]
            for figure in WITH_INTERVAL:
                row += [figure.of(summary[tau]), *interval_ends(found[figure.key, tau])]
            rows.append(tuple(row))
    notes = (f"In brackets {certainty.described}.", *certainty.cautions)
    return MetricTable("intervals", "Intervals", tuple(columns), tuple(rows), described, notes)


def interval_columns(figure: Metric) -> tuple[Column, Column]:
    """The ends of a figure's interval, in brackets behind it."""
    return (
        metric_column(figure, key=f"{figure.key}_low", heading="low", joined=" [{}, "),
        metric_column(figure, key=f"{figure.key}_high", heading="high", joined="{}]"),
    )


def differences_table(certainty: Inference, described: str) -> MetricTable:
    """Every two sources on the frames both have, at every threshold. The verdict stands before the
    figures, where a narrow page shows it."""
    columns = [TAU, Column("a", "A"), Column("b", "B"), Column("verdict", "JaC")]
    for figure, _ in DIFFERENCES:
        points = figure.unit.replace("%", "points")
        heading = f"{figure.title}, {points}"
        columns += [metric_column(figure, heading=heading), *interval_columns(figure)]
    columns += [metric_column(P_VALUE), metric_column(P_CORRECTED), *map(defined_count_column, (SHARED, FRAMES_ONLY_A, FRAMES_ONLY_B))]
    rows: list[tuple[Value, ...]] = []
    bold: set[tuple[int, int]] = set()
    for tau in certainty.thresholds:
        for pair in certainty.pairs:
            names = (certainty.sources[k].marked_name for k in (pair.a, pair.b))
            jac = pair.differences["mean_jac", tau]
            row: list[Value] = [tau, *names, verdict(jac)]
            for _, key in DIFFERENCES:
                found = pair.differences[key, tau]
                if found.beyond_chance and certainty.can_be_bold(pair.a, pair.b, key):
                    bold.add((len(rows), len(row)))
                row += [found.value, *interval_ends(found.interval)]
            frames = (pair.shared, len(pair.only_a), len(pair.only_b))
            rows.append((*row, jac.p, jac.corrected, *frames))
    notes = (
        f"In brackets {certainty.described}.",
        "JaC and mean error are compared on the frames both sources have; frames that only one has"
        " count for completeness and the final score. Bold: beyond chance, between methods"
        " whose errors are of the same points.",
        *certainty.cautions,
    )
    return MetricTable(
        "differences", "Is the difference real", tuple(columns), tuple(rows), described, notes,
        frozenset(bold),
    )  # fmt: skip


def verdict(found: PairedDifference) -> str:
    """What can be said of a difference, in two words."""
    if found.interval is None:
        return "cannot tell"
    return "beyond chance" if found.beyond_chance else "undecided"


def ranks_table(certainty: Inference, described: str) -> MetricTable:
    """The place of each source at each threshold, shared where the data cannot tell."""
    columns = [Column("source", "source")]
    for tau in certainty.thresholds:
        group = f"at {tau:g} px"
        columns.append(defined_count_column(RANK, key=f"rank_{tau:g}", group=group))
        columns.append(metric_column(BEST_IN, key=f"best_in_{tau:g}", group=group))
    places = {tau: certainty.ranks("mean_jac", tau) for tau in certainty.thresholds}
    chances = certainty.chances_of_being_best
    rows = tuple(
        (
            source.marked_name,
            *(v for t in certainty.thresholds for v in (places[t][n], chances[t][n])),
        )
        for n, source in enumerate(certainty.sources)
    )
    note = f"By JaC. Rank: {RANK.definition[0].lower()}{RANK.definition[1:]} {BEST_IN.definition}"
    return MetricTable("ranks", "Ranks", tuple(columns), rows, described, (note,))


def power_table(certainty: Inference, described: str) -> MetricTable:
    """How many frames a set like this one needs to find differences of 1, 2 and 5 points of JaC; of
    a single source, to know it to 1, 2 and 5 points."""
    columns = [TAU, Column("a", "A"), Column("b", "B"), defined_count_column(FRAMES)]
    columns.append(metric_column(MINIMUM_DETECTABLE_DIFFERENCE, heading=f"{MINIMUM_DETECTABLE_DIFFERENCE.title}, points"))
    columns += [
        defined_count_column(
            FRAMES_FOR,
            key=f"frames_for_{100 * p:g}",
            heading=f"{100 * p:g}",
            group="frames for points",
        )
        for p in POINTS
    ]
    names = [source.marked_name for source in certainty.sources]
    rows: list[tuple[Value, ...]] = []
    for at, tau in enumerate(certainty.thresholds):
        for pair in certainty.pairs:
            found = pair.differences["mean_jac", tau]
            needed = _needed(certainty, found.deviation, found.frames, found.effective, _POWER,
                             found.clusters)  # fmt: skip
            rows.append((tau, names[pair.a], names[pair.b], pair.shared, *needed))
        if not certainty.pairs:
            sampled, frames = certainty.jac_alone(0)
            known = float(sampled.deviation[at]), frames, float(sampled.effective[at])
            # An interval as far as that: a true difference lies beyond it in half of the sets.
            rows.append((tau, names[0], None, frames, *_needed(certainty, *known, 0.5)))
    alike = f"if more come in clusters like these ({certainty.clusters.described})"
    note = (
        f"The frames in which a true difference is beyond chance in {100 * _POWER:g} of 100 sets,"
        f" {alike}."
        if certainty.pairs
        else f"The frames of which JaC is known to plus or minus so many points, {alike}."
    )
    return MetricTable("power", "Frames needed", tuple(columns), tuple(rows), described, (note,))


def _needed(
    certainty: Inference,
    deviation: float | None,
    frames: int,
    effective: float,
    power: float,
    tested: int | None = None,
) -> tuple[Value, ...]:
    """The least difference, and frames for each of `POINTS`; tested: of how many clusters, where
    a permutation test has to agree."""
    if not deviation or not np.isfinite(deviation):
        return (None,) * (1 + len(POINTS))
    level = certainty.draws.level
    fewest = 1 if tested is None else math.ceil(min_clusters_for_significance(level) * frames / tested)
    needed = (
        required_frames(p, deviation, frames, effective, level=level, power=power, fewest=fewest)
        for p in POINTS
    )
    least = minimum_detectable_difference(deviation, effective, level=level, power=power)
    return (least if fewest <= frames else None, *needed)


def curves_table(certainty: Inference, described: str) -> MetricTable:
    """The difference of every two sources over tau, with a band for all of tau at once."""
    columns = [Column("a", "A"), Column("b", "B"), TAU, metric_column(JAC_DIFFERENCE)]
    columns += interval_columns(JAC_DIFFERENCE)
    rows: list[tuple[Value, ...]] = []
    for pair in certainty.pairs:
        band = certainty.curve_of_difference(pair.a, pair.b)
        names = certainty.sources[pair.a].marked_name, certainty.sources[pair.b].marked_name
        for at in range(0, len(TAU_GRID), _CURVE_STEP):
            ends = (float(side[at]) for side in (band.values, band.low, band.high))
            known = (v if np.isfinite(v) else None for v in ends)
            rows.append((*names, float(TAU_GRID[at]), *known))
    note = f"The band holds the whole curve at once; {certainty.described}."
    return MetricTable(
        "difference_curves", "Difference over tau", tuple(columns), tuple(rows), described, (note,)
    )


def interval_ends(interval: Interval | None) -> tuple[float | None, float | None]:
    return (None, None) if interval is None else (interval.low, interval.high)
