"""What the clicks leave open, as sheets: of every source, and of every two."""

from __future__ import annotations

import numpy as np

from procc_annotator.metric.chance.clicks import AnnotationNoiseSensitivity
from procc_annotator.report.sheet.figures import (
    CLICK_DEVIATION,
    CLICK_SHARE,
    CLICKED_JAC,
    JAC_DIFFERENCE,
    MEAN_JAC,
    DISTINGUISHABLE_FROM,
)
from procc_annotator.report.sheet.sheet import TAU, Column, MetricTable, Value, metric_column
from procc_annotator.session.runs.certainty import Inference
from procc_annotator.session.runs.click_spreads import pairs_under_click_noise, click_noise_spread
from procc_annotator.session.runs.moved_clicks import ClickNoise


def annotation_noise_tables(certainty: Inference, noise: ClickNoise, described: str) -> list[MetricTable]:
    """What the clicks leave open: of every source, and of every two."""
    columns = [Column("source", "source"), TAU, metric_column(MEAN_JAC), metric_column(CLICKED_JAC)]
    columns += [metric_column(CLICK_DEVIATION), metric_column(CLICK_SHARE)]
    rows: list[tuple[Value, ...]] = []
    for place, source in enumerate(certainty.sources):
        spread, own = click_noise_spread(certainty, place), source.ratios("mean_jac")
        for at, tau in enumerate(certainty.thresholds):
            whole = float(own.denominators[:, at].sum())
            jac = _known(float(own.parts[:, at].sum()) / whole) if whole else None
            rows.append((source.marked_name, tau, jac, *_of_clicks(spread, at)))
    note = f"{noise.described} {CLICK_SHARE.definition}"
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
        TAU, Column("a", "A"), Column("b", "B"),
        metric_column(JAC_DIFFERENCE, heading="A less B, points"),
        metric_column(JAC_DIFFERENCE, key="moved_difference", heading="points moved"),
        metric_column(CLICK_DEVIATION), metric_column(CLICK_SHARE), metric_column(DISTINGUISHABLE_FROM),
    )  # fmt: skip
    rows: list[tuple[Value, ...]] = []
    every = pairs_under_click_noise(certainty)
    for at, tau in enumerate(certainty.thresholds):
        for pair, clicked in zip(certainty.pairs, every, strict=True):
            names = certainty.sources[pair.a].marked_name, certainty.sources[pair.b].marked_name
            value = pair.differences["mean_jac", tau].value
            rows.append(
                (tau, *names, value, *_of_clicks(clicked.spread, at), clicked.distinguishable_from)
            )
    notes = (note, DISTINGUISHABLE_FROM.definition)
    title = "Differences under other clicks"
    return MetricTable("clicked_differences", title, columns, tuple(rows), described, notes)


def _of_clicks(spread: AnnotationNoiseSensitivity, at: int) -> tuple[Value, ...]:
    return tuple(_known(v[at]) for v in (spread.means, spread.deviations, spread.shares))


def _known(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
