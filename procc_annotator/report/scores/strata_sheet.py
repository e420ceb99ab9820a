"""Sources over the parts of a set, as a sheet; where two differ most comes first."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from procc_annotator.report.scores.chance_sheets import ends_of, interval_columns
from procc_annotator.report.sheet.counts import FRAMES
from procc_annotator.report.sheet.figure import Figure
from procc_annotator.report.sheet.figures import JAC_DIFFERENCE, MEAN_JAC, P_CORRECTED
from procc_annotator.report.sheet.sheet import Column, Sheet, Value, counted, of
from procc_annotator.session.runs.certainty import Certainty
from procc_annotator.session.runs.strata import Stratum


def strata_sheet(
    parts: Sequence[Stratum], certainty: Certainty, tau: float, described: str
) -> Sheet:
    """JaC of every source and the difference of every two, with intervals, for each part.

    Args:
        parts: at least one. certainty: of the whole set. tau: px, one of its thresholds.
    """
    by, ordered = parts[0].by, _most_different_first(parts)
    rows: list[tuple[Value, ...]] = []
    bold: set[tuple[int, int]] = set()
    for part in ordered:
        row: list[Value] = [part.value or "(none)", len(part.certainty.sources[0].frames)]
        at = certainty.thresholds.index(tau)
        for source, ends in zip(part.certainty.sources, part.certainty.intervals, strict=True):
            own = source.ratios("mean_jac")
            count = float(own.wholes[:, at].sum())
            row += [float(own.parts[:, at].sum()) / count if count else None]
            row += ends_of(ends["mean_jac", tau])
        for (a, b), found in part.differences.items():
            if found.beyond_chance and certainty.may_be_bold(a, b, "mean_jac"):
                bold.add((len(rows), len(row)))
            row += [found.value, *ends_of(found.interval), found.corrected]
        rows.append(tuple(row))
    notes = (
        f"In brackets {certainty.described}. The part where two sources differ most comes first; p"
        " is corrected for all parts and pairs. Bold: beyond chance.",
    )
    return Sheet(
        f"by_{by}", f"By {by}", _columns(certainty, by, tau), tuple(rows), described, notes,
        frozenset(bold),
    )  # fmt: skip


def _columns(certainty: Certainty, by: str, tau: float) -> tuple[Column, ...]:
    names = [source.marked_name for source in certainty.sources]
    columns = [Column("value", by), counted(FRAMES)]
    for name in names:
        columns += _with_interval(MEAN_JAC, f"JaC@{tau:g} %", name)
    for pair in certainty.pairs:
        less = f"{names[pair.a]} less {names[pair.b]}"
        columns += _with_interval(JAC_DIFFERENCE, "points", less)
        columns.append(of(P_CORRECTED, key=f"{P_CORRECTED.key} {less}", group=less))
    return tuple(columns)


def _with_interval(figure: Figure, heading: str, group: str) -> list[Column]:
    first = of(figure, key=f"{figure.key} {group}", heading=heading, group=group)
    ends = (replace(c, key=f"{c.key} {group}", group=group) for c in interval_columns(figure))
    return [first, *ends]


def _most_different_first(parts: Sequence[Stratum]) -> list[Stratum]:
    def most(part: Stratum) -> float:
        return max((abs(d.value or 0.0) for d in part.differences.values()), default=0.0)

    return sorted(parts, key=lambda part: -most(part))
