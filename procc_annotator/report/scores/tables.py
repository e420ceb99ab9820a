"""Scores as tables on the terminal; protocol and size stand beside every number."""

from __future__ import annotations

import heapq
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from procc_annotator.metric.measure import Labelling
from procc_annotator.metric.score import FrameScore
from procc_annotator.metric.sets import SetSummary
from procc_annotator.report.scores.score_columns import COUNTS
from procc_annotator.report.sheet.figure import metric_values
from procc_annotator.report.sheet.figures import (
    COMPLETENESS,
    ERROR_COUNTED,
    FRAME_ERROR,
    JAC,
    LARGEST_PX,
    MEAN_ERROR,
    MEAN_JAC,
    OF_SET,
    PRECISION,
    RECALL,
)
from procc_annotator.report.sheet.sheet import TAU, Column, MetricTable, metric_column, count_column


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
        """The row of a scored frame; its worst element is the one with the farthest point, by the
        labels that errors are told of."""
        element, distance = _farthest(score.read)
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
) -> MetricTable:
    """One row a threshold; below it the official error, where that is another one."""
    figures = [figure for figure in OF_SET if figure is not ERROR_COUNTED]
    rows = tuple((tau, *metric_values(figures, s)) for tau, s in summaries.items())
    others = [
        f"{pixels(s.mean_reprojection_error)} px at tau {tau:g}"
        for tau, s in summaries.items()
        if s.mean_reprojection_error != s.mean_error
    ]
    notes = (f"official error, of mirrored labels on a tie: {', '.join(others)}",) if others else ()
    return MetricTable("summary", title, (TAU, *map(metric_column, figures)), rows, described, notes)


def worst_frames_table(rows: Sequence[FrameRow], threshold: float, described: str) -> MetricTable:
    """The frames to look at first."""
    columns = (
        Column("frame", "frame"), metric_column(JAC), *map(metric_column, COUNTS), metric_column(FRAME_ERROR),
        Column("element", "farthest element"), metric_column(LARGEST_PX, heading="px"),
        Column("labels", "labels"),
    )  # fmt: skip
    values = tuple(
        (
            row.name, row.jac, row.tp, row.fp, row.fn, row.mean_error, row.worst_element,
            row.worst_distance, "mirrored" if row.mirrored else None,
        )
        for row in rows
    )  # fmt: skip
    title = f"{worst_words(len(rows))} at {threshold:g} px"
    return MetricTable("worst_frames", title, columns, values, described)


def classes_table(summaries: Mapping[float, SetSummary], described: str) -> MetricTable:
    """Per-class figures, counted in points; JaC at every threshold, the rest at the first one."""
    first = next(iter(summaries))
    others = (PRECISION, RECALL, *COUNTS)
    columns = (
        Column("class", "class"), *(metric_column(JAC, f"@{tau:g}") for tau in summaries), *map(metric_column, others)
    )  # fmt: skip
    rows = []
    for name in sorted({name for s in summaries.values() for name in s.per_class}):
        found = [s.per_class.get(name) for s in summaries.values()]
        jacs = (None if one is None else one.jac for one in found)
        rows.append((name.strip(), *jacs, *metric_values(others, found[0])))
    title = f"Classes, counted in points (tp, fp, fn at {first:g} px)"
    return MetricTable("classes", title, columns, tuple(rows), described)


def _set_columns(thresholds: Sequence[float]) -> tuple[Column, ...]:
    # At the largest threshold it is rarest that mirrored labels score higher by chance.
    error = metric_column(MEAN_ERROR, f"@{max(thresholds):g}" if thresholds else "")
    return (metric_column(COMPLETENESS), *(metric_column(MEAN_JAC, f"@{tau:g}") for tau in thresholds), error)


def _set_values(
    summaries: Mapping[float, SetSummary], thresholds: Sequence[float]
) -> tuple[float | None, ...]:
    """A value for each of `_set_columns`."""
    return (
        summaries[thresholds[0]].completeness,
        *(summaries[tau].mean_jac for tau in thresholds),
        summaries[max(thresholds)].mean_error,
    )


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


def evaluations_table(title: str, headings: tuple[str, ...], rows: list[EvaluationRow]) -> MetricTable:
    """Evaluations of the same thresholds below each other."""
    described = {row.described for row in rows}
    common = next(iter(described)) if len(described) == 1 else ""
    thresholds = list(rows[0].summaries) if rows else []
    if not common:
        headings = (*headings, "protocol, size")
    columns = (
        *(Column(heading, heading) for heading in headings), count_column("frames"),
        *_set_columns(thresholds),
    )  # fmt: skip
    values = tuple(
        (
            *row.names,
            *(() if common else (row.described,)),
            row.summaries[thresholds[0]].images,
            *_set_values(row.summaries, thresholds),
        )
        for row in rows
    )
    return MetricTable("evaluations", title, columns, values, common)


def worst_words(count: int) -> str:
    """``Worst frame``, ``Worst 2 frames``."""
    return "Worst frame" if count == 1 else f"Worst {count} frames"


def percent_text(value: float | None) -> str:
    """A share as a percentage with two decimals; a dash where it is undefined."""
    return JAC.text(value)


def pixels(value: float | None) -> str:
    """A distance with two decimals; a dash where it is undefined."""
    return MEAN_ERROR.text(value)
