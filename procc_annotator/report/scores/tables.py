"""Scores as tables on the terminal; protocol and size stand beside every number."""

from __future__ import annotations

import heapq
import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from rich.table import Table
from rich.text import Text

from procc_annotator.metric.measure import Labelling
from procc_annotator.metric.score import FrameScore
from procc_annotator.metric.sets import ClassSummary, SetSummary

DASH = "–"


@dataclass(frozen=True, slots=True)
class FrameRow:
    """What the table of worst frames says about one frame at one threshold."""

    name: str
    jac: float
    tp: int
    fp: int
    fn: int
    mirrored: bool
    mean_error: float | None
    worst_element: str
    worst_distance: float | None

    @classmethod
    def of(cls, name: str, score: FrameScore) -> FrameRow:
        """The row of a scored frame; its worst element is the one with the farthest point."""
        element, distance = _farthest(score.labelling)
        return cls(
            name,
            score.jac,
            score.tp,
            score.fp,
            score.fn,
            score.mirrored,
            score.mean_error,
            element.strip(),
            distance,
        )


def _farthest(labelling: Labelling) -> tuple[str, float | None]:
    if not len(labelling.all_distances):
        return "", None
    point = int(labelling.all_distances.argmax())
    row = int(labelling.starts.searchsorted(point, "right")) - 1
    names = [n for n, hit in zip(labelling.names, labelling.projected, strict=True) if hit]
    return names[row], float(labelling.all_distances[point])


@dataclass
class WorstFrames:
    """Keeps the frames with the lowest JaC (larger errors first among equals), and only those."""

    count: int = 10
    _heap: list[tuple[float, float, int, FrameRow]] = field(default_factory=list)
    _seen: int = 0

    def add(self, row: FrameRow) -> None:
        """Consider one more frame."""
        self._seen += 1
        error = 0.0 if row.mean_error is None else row.mean_error
        entry = (-row.jac, error, -self._seen, row)
        if len(self._heap) < self.count:
            heapq.heappush(self._heap, entry)
        else:
            heapq.heappushpop(self._heap, entry)

    def rows(self) -> list[FrameRow]:
        """The worst frames, the worst first."""
        return [entry[-1] for entry in sorted(self._heap, reverse=True)]


def summary_table(
    summaries: Mapping[float, SetSummary], described: str, *, title: str = "Summary"
) -> Table:
    """One row a threshold."""
    table = _table(title, described)
    for heading in ("tau px", "JaC %", "sd", "median", "completeness %", "final score %"):
        table.add_column(heading, justify="right")
    for heading in ("precision %", "recall %", "mean error px"):
        table.add_column(heading, justify="right")
    for threshold, s in summaries.items():
        table.add_row(
            f"{threshold:g}",
            percent_text(s.mean_jac),
            percent_text(s.sd_jac),
            percent_text(s.median_jac),
            percent_text(s.completeness),
            percent_text(s.final_score),
            percent_text(s.mean_precision),
            percent_text(s.mean_recall),
            pixels(s.mean_reprojection_error),
        )
    return table


def worst_frames_table(rows: list[FrameRow], threshold: float, described: str) -> Table:
    """The frames to look at first."""
    table = _table(f"{worst_words(len(rows))} at {threshold:g} px", described)
    table.add_column("frame")
    for heading in ("JaC %", "tp", "fp", "fn", "mean error px"):
        table.add_column(heading, justify="right")
    table.add_column("farthest element")
    table.add_column("px", justify="right")
    table.add_column("labels")
    for row in rows:
        table.add_row(
            row.name,
            percent_text(row.jac),
            str(row.tp),
            str(row.fp),
            str(row.fn),
            pixels(row.mean_error),
            row.worst_element or DASH,
            pixels(row.worst_distance),
            "mirrored" if row.mirrored else "",
        )
    return table


def classes_table(summaries: Mapping[float, SetSummary], described: str) -> Table:
    """Per-class figures, counted in points; JaC at every threshold, the rest at the first one."""
    thresholds = list(summaries)
    first = thresholds[0]
    table = _table(f"Classes, counted in points (tp, fp, fn at {first:g} px)", described)
    table.add_column("class")
    for threshold in thresholds:
        table.add_column(f"JaC@{threshold:g} %", justify="right")
    for heading in ("precision %", "recall %", "tp", "fp", "fn"):
        table.add_column(heading, justify="right")
    for name in sorted({name for s in summaries.values() for name in s.per_class}):
        per_threshold = [summaries[t].per_class.get(name) for t in thresholds]
        jacs = [percent_text(None if c is None else c.jac) for c in per_threshold]
        table.add_row(name.strip(), *jacs, *_counts(per_threshold[0]))
    return table


def _counts(figures: ClassSummary | None) -> tuple[str, ...]:
    if figures is None:
        return (DASH,) * 5
    counts = (figures.tp, figures.fp, figures.fn)
    return (
        percent_text(figures.precision),
        percent_text(figures.recall),
        *(f"{count:g}" for count in counts),
    )


def sets_table(sets: Mapping[str, tuple[Mapping[float, SetSummary], str]]) -> Table:
    """Camera sets side by side: name -> (figures by threshold, what they were computed with)."""
    table = Table(title=Text("Camera sets", "bold"), title_justify="left", title_style="")
    table.add_column("cameras")
    table.add_column("protocol, size")
    table.add_column("completeness %", justify="right")
    thresholds = sorted(next(iter(sets.values()))[0]) if sets else []
    for threshold in thresholds:
        table.add_column(f"JaC@{threshold:g} %", justify="right")
    table.add_column(_error_heading(thresholds), justify="right")
    for name, (summaries, described) in sets.items():
        first = summaries[thresholds[0]]
        table.add_row(
            name,
            described,
            percent_text(first.completeness),
            *(percent_text(summaries[t].mean_jac) for t in thresholds),
            pixels(summaries[max(thresholds)].mean_reprojection_error),
        )
    return table


def _error_heading(thresholds: list[float]) -> str:
    # Where both labellings fail alike the official evaluation takes the mirrored one, whose errors
    # are half a field; that is rarest at the largest threshold.
    return f"mean error px@{max(thresholds):g}" if thresholds else "mean error px"


@dataclass(frozen=True)
class EvaluationRow:
    """One evaluation, or a part of its frames, in a table of several.

    Attributes:
        names: what tells it from the others, one a heading.
        described: what its figures were computed with.
    """

    names: tuple[str, ...]
    described: str
    summaries: Mapping[float, SetSummary]


def evaluations_table(title: str, headings: tuple[str, ...], rows: list[EvaluationRow]) -> Table:
    """Evaluations of the same thresholds below each other."""
    described = {row.described for row in rows}
    if len(described) == 1:
        table = _table(title, *described)
    else:
        table = _table(title)
        headings = (*headings, "protocol, size")
    for heading in headings:
        table.add_column(heading)
    for heading in ("frames", "completeness %"):
        table.add_column(heading, justify="right")
    thresholds = list(rows[0].summaries) if rows else []
    for threshold in thresholds:
        table.add_column(f"JaC@{threshold:g} %", justify="right")
    table.add_column(_error_heading(thresholds), justify="right")
    for row in rows:
        first = row.summaries[thresholds[0]]
        table.add_row(
            *row.names,
            *([row.described] if len(described) > 1 else []),
            str(first.images),
            percent_text(first.completeness),
            *(percent_text(row.summaries[t].mean_jac) for t in thresholds),
            pixels(row.summaries[max(thresholds)].mean_reprojection_error),
        )
    return table


def worst_words(count: int) -> str:
    """``Worst frame``, ``Worst 2 frames``."""
    return "Worst frame" if count == 1 else f"Worst {count} frames"


def percent_text(value: float | None) -> str:
    """A share as a percentage with two decimals; a dash where it is undefined."""
    return DASH if value is None or math.isnan(value) else f"{100 * value:.2f}"


def pixels(value: float | None) -> str:
    """A distance with two decimals; a dash where it is undefined."""
    return DASH if value is None or math.isnan(value) else f"{value:.2f}"


def _table(title: str, described: str = "") -> Table:
    heading = Text(title, "bold")
    if described:
        heading = Text.assemble((title, "bold"), "  ", (f"({described})", "dim"))
    return Table(title=heading, title_justify="left", title_style="", header_style="bold")
