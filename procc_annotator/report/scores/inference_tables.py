"""Tables of intervals, differences, ranks, strata, power and annotation-noise sensitivity."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from procc_annotator.batch.audit import TAU_GRID
from procc_annotator.batch.frame_sums import ClickNoise
from procc_annotator.batch.inference import Inference, click_noise_spread, pairs_under_click_noise
from procc_annotator.batch.strata import POSED, Stratum
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.metrics.statistics.intervals import AnnotationNoiseSensitivity, Interval
from procc_annotator.metrics.statistics.significance import (
    PairedDifference,
    min_clusters_for_significance,
    minimum_detectable_difference,
    required_frames,
)
from procc_annotator.report.scores.score_tables import tie_notes
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.table import (
    TAU,
    Column,
    Metric,
    MetricTable,
    Value,
    defined_count_column,
    metric_column,
)

SIGNIFICANT = "significant"
POINTS = (0.01, 0.02, 0.05)  # differences that a set should tell, as shares
_POWER = 0.8
_PAIR = (Column("a", "A"), Column("b", "B"))
_BY_FIT = (
    "Zoom and side are those of a pinhole (P) fitted to the annotation of each frame, whichever"
    " methods are compared; none: the annotation does not determine it."
)
_CURVE_STEP = 5  # of `TAU_GRID`, in a file


def inference_tables(
    certainty: Inference,
    summaries: Sequence[Mapping[float, SetSummary]],
    described: str,
    *,
    power: bool = False,
) -> list[MetricTable]:
    """Everything that can be reported of some sources, with the figures of each by threshold; of a
    single one there is nothing to compare. ``power``: whether to say how many frames are needed."""
    sheets = [intervals_table(certainty, summaries, described)]
    if certainty.pairs:
        sheets += [differences_table(certainty, described), ranks_table(certainty, described)]
    if certainty.held_out_pairs:
        sheets.append(held_out_pairs_table(certainty, described))
    if power:
        sheets.append(power_table(certainty, described))
    return sheets


def intervals_table(
    certainty: Inference, summaries: Sequence[Mapping[float, SetSummary]], described: str
) -> MetricTable:
    """Every mean of every source with its interval."""
    columns = (Column("source", "method"), TAU, *columns_with_intervals(metrics.WITH_INTERVAL))
    rows = []
    for source, found, summary in zip(
        certainty.sources, certainty.intervals, summaries, strict=True
    ):
        for tau in certainty.thresholds:
            row: list[Value] = [source.marked_name, tau]
            for figure in metrics.WITH_INTERVAL:
                row += [figure.of(summary[tau]), *interval_ends(found[figure.key, tau])]
            rows.append(tuple(row))
    ties = tie_notes({s.name: own for s, own in zip(certainty.sources, summaries, strict=True)})
    notes = (f"In brackets {certainty.described}.", *ties, *certainty.cautions)
    return MetricTable("intervals", "Intervals", columns, tuple(rows), described, notes)


def columns_with_intervals(figures: Iterable[Metric]) -> list[Column]:
    """Figures as columns, each with its interval."""
    return [c for figure in figures for c in (metric_column(figure), *interval_columns(figure))]


def interval_columns(figure: Metric) -> tuple[Column, Column]:
    """The ends of a figure's interval, in brackets behind it."""
    return (
        metric_column(figure, key=f"{figure.key}_low", heading="low", joined=" [{}, "),
        metric_column(figure, key=f"{figure.key}_high", heading="high", joined="{}]"),
    )


def differences_table(certainty: Inference, described: str) -> MetricTable:
    """Every two sources on the frames both have, at every threshold. The verdict stands before the
    figures, where a narrow page shows it."""
    columns = [TAU, *_PAIR, Column("verdict", "verdict (JaC)", figure=metrics.VERDICT)]
    for figure, _ in metrics.DIFFERENCES:
        points = figure.unit.replace("%", "points")
        heading = f"{figure.title}, {points}"
        columns += [metric_column(figure, heading=heading), *interval_columns(figure)]
    columns += [
        metric_column(metrics.P_VALUE),
        metric_column(metrics.P_CORRECTED),
        *map(defined_count_column, (metrics.SHARED, metrics.FRAMES_ONLY_A, metrics.FRAMES_ONLY_B)),
    ]
    rows: list[tuple[Value, ...]] = []
    bold: set[tuple[int, int]] = set()
    for tau in certainty.thresholds:
        for pair in certainty.pairs:
            names = (certainty.sources[k].marked_name for k in (pair.a, pair.b))
            jac = pair.differences["mean_jac", tau]
            row: list[Value] = [tau, *names, verdict(jac)]
            for _, key in metrics.DIFFERENCES:
                found = pair.differences[key, tau]
                if found.beyond_chance and certainty.can_be_bold(pair.a, pair.b, key):
                    bold.add((len(rows), len(row)))
                row += [found.value, *interval_ends(found.interval)]
            frames = (pair.shared, len(pair.only_a), len(pair.only_b))
            rows.append((*row, jac.p, jac.corrected, *frames))
    notes = (
        f"In brackets {certainty.described}.",
        "JaC and mean error are compared on the frames both methods have; frames that only one has"
        " count for completeness and the final score. Bold: significant, between methods"
        " whose errors are of the same points. In-sample differences of fits are not tested.",
        *certainty.cautions,
    )
    return MetricTable(
        "differences", "Is the difference real", tuple(columns), tuple(rows), described, notes,
        frozenset(bold),
    )  # fmt: skip


def held_out_pairs_table(certainty: Inference, described: str) -> MetricTable:
    """Every two fits on the elements that both determine from the others, at every threshold."""
    columns = (
        TAU, *_PAIR, Column("verdict", "verdict", figure=metrics.VERDICT),
        metric_column(metrics.LEFT_OUT_SCORE, key="held_out_a", heading="A held out %"),
        metric_column(metrics.LEFT_OUT_SCORE, key="held_out_b", heading="B held out %"),
        metric_column(metrics.HELD_OUT_DIFFERENCE), *interval_columns(metrics.HELD_OUT_DIFFERENCE),
        metric_column(metrics.P_VALUE), metric_column(metrics.P_CORRECTED),
        defined_count_column(metrics.HELD_OUT_ELEMENTS), defined_count_column(metrics.FRAMES),
    )  # fmt: skip
    names = [source.name for source in certainty.sources]
    rows = tuple(
        (
            tau, names[pair.a], names[pair.b], verdict(found), *pair.held_out[tau], found.value,
            *interval_ends(found.interval), found.p, found.corrected, pair.shared, found.frames,
        )
        for tau in certainty.thresholds
        for pair in certainty.held_out_pairs
        for found in [pair.differences["held_out", tau]]
    )  # fmt: skip
    bold = {(at, 6) for at, row in enumerate(rows) if row[3] == SIGNIFICANT}
    notes = (
        "Every element is judged by the camera of the frame's other elements, on the elements that"
        " both fits determine so.",
        f"In brackets {certainty.described}.",
        *certainty.cautions,
    )
    return MetricTable(
        "held_out_differences", "Fits compared, leave-one-element-out", columns, rows, described,
        notes, frozenset(bold),
    )  # fmt: skip


def verdict(found: PairedDifference) -> str:
    """Return what can be said of a difference, in two words."""
    if found.interval is None:
        return "not tested"
    return SIGNIFICANT if found.beyond_chance else "undecided"


def ranks_table(certainty: Inference, described: str) -> MetricTable:
    """The place of each source at each threshold, shared where the data cannot say."""
    columns = [Column("source", "method")]
    for tau in certainty.thresholds:
        group = f"at {tau:g} px"
        columns.append(defined_count_column(metrics.RANK, key=f"rank_{tau:g}", group=group))
        columns.append(metric_column(metrics.BEST_IN, key=f"best_in_{tau:g}", group=group))
    places = {tau: certainty.ranks("mean_jac", tau) for tau in certainty.thresholds}
    chances = certainty.chances_of_being_best
    rows = tuple(
        (
            source.marked_name,
            *(v for t in certainty.thresholds for v in (places[t][n], chances[t][n])),
        )
        for n, source in enumerate(certainty.sources)
    )
    notes = (f"By JaC. {metrics.RANK.definition}", metrics.BEST_IN.definition)
    return MetricTable("ranks", "Ranks", tuple(columns), rows, described, notes)


def power_table(certainty: Inference, described: str) -> MetricTable:
    """Return how many frames a set like this one needs to find differences of 1, 2 and 5 points of
    JaC; of a single source, to know it to 1, 2 and 5 points."""
    least, needs = metrics.MINIMUM_DETECTABLE_DIFFERENCE, metrics.FRAMES_FOR
    columns = [TAU, *_PAIR, defined_count_column(metrics.FRAMES)]
    columns.append(metric_column(least, heading=f"{least.title}, points"))
    for points in (f"{100 * p:g}" for p in POINTS):
        key, group = f"frames_for_{points}", "frames for points"
        columns.append(defined_count_column(needs, key=key, heading=points, group=group))
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
        f"The frames in which a true difference is significant in {100 * _POWER:g} of 100 sets,"
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
    fewest = (
        1 if tested is None else math.ceil(min_clusters_for_significance(level) * frames / tested)
    )
    needed = (
        required_frames(p, deviation, frames, effective, level=level, power=power, fewest=fewest)
        for p in POINTS
    )
    least = minimum_detectable_difference(deviation, effective, level=level, power=power)
    return (least if fewest <= frames else None, *needed)


def curves_table(certainty: Inference, described: str) -> MetricTable:
    """The difference of every two sources over tau, with a band for all of tau at once."""
    columns = [*_PAIR, TAU, metric_column(metrics.JAC_DIFFERENCE)]
    columns += interval_columns(metrics.JAC_DIFFERENCE)
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


def strata_table(
    parts: Sequence[Stratum], certainty: Inference, tau: float, described: str
) -> MetricTable:
    """JaC of every source and the difference of every two, with intervals, for each part (one at
    least), at a threshold of the whole set, px."""
    by, ordered = parts[0].by, _most_different_first(parts, tau)
    rows: list[tuple[Value, ...]] = []
    bold: set[tuple[int, int]] = set()
    for part in ordered:
        row: list[Value] = [part.value or "(none)", len(part.certainty.sources[0].frames)]
        at = certainty.thresholds.index(tau)
        for source, ends in zip(part.certainty.sources, part.certainty.intervals, strict=True):
            row += [source.ratios("mean_jac").value(at), *interval_ends(ends["mean_jac", tau])]
        for (a, b), found in part.differences.get(("mean_jac", tau), {}).items():
            if found.beyond_chance and certainty.can_be_bold(a, b, "mean_jac"):
                bold.add((len(rows), len(row)))
            row += [found.value, *interval_ends(found.interval), found.corrected]
        rows.append(tuple(row))
    notes = (
        f"In brackets {certainty.described}.",
        "The part where two methods differ most comes first; p is corrected for all parts and"
        " pairs. Bold: significant.",
        *([_BY_FIT] if by in POSED else []),
        *_cautions(parts),
    )
    return MetricTable(
        f"by_{by}", f"By {by}", _columns(certainty, by, tau), tuple(rows), described, notes,
        frozenset(bold),
    )  # fmt: skip


def strata_metrics_table(
    parts: Sequence[Stratum], certainty: Inference, described: str
) -> MetricTable:
    """Every figure of every source in each part at every threshold, with intervals."""
    by = parts[0].by
    columns = (
        Column("value", by), Column("source", "method"), TAU, defined_count_column(metrics.FRAMES),
        *columns_with_intervals(metrics.WITH_INTERVAL),
    )  # fmt: skip
    rows: list[tuple[Value, ...]] = []
    begins = []
    for part in parts:
        begins.append(len(rows))
        frames = len(part.certainty.sources[0].frames)
        for source, ends in zip(part.certainty.sources, part.certainty.intervals, strict=True):
            sums = {figure.key: source.ratios(figure.key) for figure in metrics.WITH_INTERVAL}
            for at, tau in enumerate(certainty.thresholds):
                row: list[Value] = [part.value or "(none)", source.marked_name, tau, frames]
                for key, ratios in sums.items():
                    row += [ratios.value(at), *interval_ends(ends[key, tau])]
                rows.append(tuple(row))
    by_fit = [_BY_FIT] if by in POSED else []
    notes = (f"In brackets {certainty.described}.", *by_fit, *_cautions(parts))
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
    columns = [Column("value", by), TAU, *_PAIR]
    for figure, key in metrics.DIFFERENCES:
        columns += [
            metric_column(figure),
            *interval_columns(figure),
            defined_count_column(metrics.FRAMES, key=f"{key}_frames"),
        ]
        columns += [
            metric_column(f, key=f"{key}_{f.key}", group=figure.title)
            for f in (metrics.P_VALUE, metrics.P_CORRECTED)
        ]
    rows: list[tuple[Value, ...]] = []
    for part, tau in product(parts, certainty.thresholds):
        for pair in part.differences["mean_jac", tau]:
            row: list[Value] = [part.value or "(none)", tau, names[pair[0]], names[pair[1]]]
            for _, key in metrics.DIFFERENCES:
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
    columns = [Column("value", by), defined_count_column(metrics.FRAMES)]
    for name in names:
        columns += _with_interval(metrics.MEAN_JAC, f"JaC@{tau:g} %", name)
    for pair in certainty.pairs:
        less = f"{names[pair.a]} − {names[pair.b]}"
        columns += _with_interval(metrics.JAC_DIFFERENCE, "points", less)
        columns.append(
            metric_column(metrics.P_CORRECTED, key=f"{metrics.P_CORRECTED.key} {less}", group=less)
        )
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


def annotation_noise_tables(
    certainty: Inference, noise: ClickNoise, described: str
) -> list[MetricTable]:
    """Return what the clicks leave open: of every source, and of every two."""
    columns = [
        Column("source", "method"),
        TAU,
        metric_column(metrics.MEAN_JAC),
        metric_column(metrics.CLICKED_JAC),
    ]
    columns += [metric_column(metrics.CLICK_DEVIATION), metric_column(metrics.CLICK_SHARE)]
    rows: list[tuple[Value, ...]] = []
    for place, source in enumerate(certainty.sources):
        spread, own = click_noise_spread(certainty, place), source.ratios("mean_jac")
        for at, tau in enumerate(certainty.thresholds):
            rows.append((source.marked_name, tau, own.value(at), *_of_clicks(spread, at)))
    note = f"{noise.described} {metrics.CLICK_SHARE.definition}"
    sheets = [
        MetricTable(
            "clicks", "What the clicks leave open", tuple(columns), tuple(rows), described, (note,)
        )
    ]
    if certainty.pairs:
        sheets.append(_pairs_table(certainty, note, described))
    return sheets


def _pairs_table(certainty: Inference, note: str, described: str) -> MetricTable:
    columns = (
        TAU,
        *_PAIR,
        metric_column(metrics.JAC_DIFFERENCE, heading="A − B, points"),
        metric_column(metrics.JAC_DIFFERENCE, key="moved_difference", heading="points moved"),
        metric_column(metrics.CLICK_DEVIATION),
        metric_column(metrics.CLICK_SHARE),
        metric_column(metrics.DISTINGUISHABLE_FROM),
    )
    rows: list[tuple[Value, ...]] = []
    every = pairs_under_click_noise(certainty)
    for at, tau in enumerate(certainty.thresholds):
        for pair, clicked in zip(certainty.pairs, every, strict=True):
            names = certainty.sources[pair.a].marked_name, certainty.sources[pair.b].marked_name
            value = pair.differences["mean_jac", tau].value
            rows.append(
                (tau, *names, value, *_of_clicks(clicked.spread, at), clicked.distinguishable_from)
            )
    notes = (note, metrics.DISTINGUISHABLE_FROM.definition)
    title = "Differences under other clicks"
    return MetricTable("clicked_differences", title, columns, tuple(rows), described, notes)


def _of_clicks(spread: AnnotationNoiseSensitivity, at: int) -> tuple[Value, ...]:
    return tuple(_known(v[at]) for v in (spread.means, spread.deviations, spread.shares))


def _known(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
