"""What the clicks leave open, as sheets: of every source, and of every two."""

from __future__ import annotations

import numpy as np

from procc_annotator.metric.chance.clicks import ClickSpread
from procc_annotator.report.sheet.figures import (
    CLICK_DEVIATION,
    CLICK_SHARE,
    CLICKED_JAC,
    JAC_DIFFERENCE,
    MEAN_JAC,
    TOLD_APART_FROM,
)
from procc_annotator.report.sheet.sheet import TAU, Column, Sheet, Value, of
from procc_annotator.session.runs.certainty import Certainty
from procc_annotator.session.runs.click_spreads import pairs_under_clicks, spread_of
from procc_annotator.session.runs.moved_clicks import ClickNoise


def clicks_sheets(certainty: Certainty, noise: ClickNoise, described: str) -> list[Sheet]:
    """What the clicks leave open: of every source, and of every two."""
    columns = [Column("source", "source"), TAU, of(MEAN_JAC), of(CLICKED_JAC)]
    columns += [of(CLICK_DEVIATION), of(CLICK_SHARE)]
    rows: list[tuple[Value, ...]] = []
    for place, source in enumerate(certainty.sources):
        spread, own = spread_of(certainty, place), source.ratios("mean_jac")
        for at, tau in enumerate(certainty.thresholds):
            whole = float(own.wholes[:, at].sum())
            jac = _known(float(own.parts[:, at].sum()) / whole) if whole else None
            rows.append((source.marked_name, tau, jac, *_of_clicks(spread, at)))
    note = f"{noise.described} {CLICK_SHARE.definition}"
    sheets = [
        Sheet(
            "clicks", "What the clicks leave open", tuple(columns), tuple(rows), described, (note,)
        )
    ]
    if certainty.pairs:
        sheets.append(_clicked_pairs_sheet(certainty, note, described))
    return sheets


def _clicked_pairs_sheet(certainty: Certainty, note: str, described: str) -> Sheet:
    columns = (
        TAU, Column("a", "A"), Column("b", "B"),
        of(JAC_DIFFERENCE, heading="A less B, points"),
        of(JAC_DIFFERENCE, key="moved_difference", heading="points moved"),
        of(CLICK_DEVIATION), of(CLICK_SHARE), of(TOLD_APART_FROM),
    )  # fmt: skip
    rows: list[tuple[Value, ...]] = []
    every = pairs_under_clicks(certainty)
    for at, tau in enumerate(certainty.thresholds):
        for pair, clicked in zip(certainty.pairs, every, strict=True):
            names = certainty.sources[pair.a].marked_name, certainty.sources[pair.b].marked_name
            value = pair.differences["mean_jac", tau].value
            rows.append(
                (tau, *names, value, *_of_clicks(clicked.spread, at), clicked.told_apart_from)
            )
    notes = (note, TOLD_APART_FROM.definition)
    title = "Differences under other clicks"
    return Sheet("clicked_differences", title, columns, tuple(rows), described, notes)


def _of_clicks(spread: ClickSpread, at: int) -> tuple[Value, ...]:
    return tuple(_known(v[at]) for v in (spread.means, spread.deviations, spread.shares))


def _known(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
