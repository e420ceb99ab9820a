"""Score tables for the terminal, and the leave-one-element-out table of fits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import Any, Protocol

from procc_annotator.batch.scoring import LeftOutMetrics
from procc_annotator.formats.cameras.fit_record import LEFT_OUT_FILE, FitCounts
from procc_annotator.messages import pluralize
from procc_annotator.metrics.measurement import Labelling
from procc_annotator.metrics.score import FrameScore
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.scores.score_files import COUNTS
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.table import (
    TAU,
    Column,
    MetricTable,
    Row,
    count_column,
    defined_count_column,
    metric_column,
    metric_values,
    shortest_number,
)


@dataclass(frozen=True, slots=True)
class FrameRow:
    """Row of the table of worst frames: one frame at one threshold."""

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
        labels that errors are reported of."""
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
    _found: list[FrameRow] = field(default_factory=list)

    def add(self, row: FrameRow) -> None:
        """Consider one more frame."""
        self._found.append(row)
        self._found.sort(key=lambda r: (r.jac, -(r.mean_error or 0.0)))
        del self._found[self.count :]

    def rows(self) -> list[FrameRow]:
        """The worst frames, the worst first."""
        return list(self._found)


def tie_notes(several: Mapping[str, Mapping[float, SetSummary]]) -> tuple[str, ...]:
    """A sentence on frames in which mirrored labels count on a tie; nothing without any."""
    ties = [
        " ".join(filter(None, (name, f"{summary.tied} at {tau:g} px")))
        for name, summaries in several.items()
        for tau, summary in summaries.items()
        if summary.tied
    ]
    if not ties:
        return ()
    return (
        "Mirrored labels that score as high as those annotated count, as in the official"
        f" evaluation: frames {', '.join(ties)}. JaC is the same; precision, recall, counts and the"
        " official error are those of the mirrored labels, the mean error those annotated.",
    )


def summary_table(
    summaries: Mapping[float, SetSummary], described: str, *, title: str = "Summary"
) -> MetricTable:
    """One row a threshold; below it the official error, where that is another one."""
    figures = [figure for figure in metrics.OF_SET if figure is not metrics.ERROR_COUNTED]
    rows = tuple((tau, *metric_values(figures, s)) for tau, s in summaries.items())
    others = [
        f"{pixels(s.mean_reprojection_error)} px at tau {tau:g}"
        for tau, s in summaries.items()
        if s.mean_reprojection_error != s.mean_error
    ]
    notes = tie_notes({"": summaries})
    if others:
        notes += (f"official error, of mirrored labels on a tie: {', '.join(others)}",)
    return MetricTable(
        "summary", title, (TAU, *map(metric_column, figures)), rows, described, notes
    )


def worst_frames_table(rows: Sequence[FrameRow], threshold: float, described: str) -> MetricTable:
    """The frames to look at first."""
    columns = (
        Column("frame", "frame"),
        metric_column(metrics.JAC),
        *map(metric_column, COUNTS),
        metric_column(metrics.FRAME_ERROR),
        Column("element", "farthest element"),
        metric_column(metrics.LARGEST_PX, heading="px"),
        Column("labels", "labels"),
    )
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
    others = (metrics.PRECISION, metrics.RECALL, *COUNTS)
    columns = (
        Column("class", "class"),
        *(metric_column(metrics.JAC, f"@{tau:g}") for tau in summaries),
        *map(metric_column, others),
    )
    rows = []
    for name in sorted({name for s in summaries.values() for name in s.per_class}):
        found = [s.per_class.get(name) for s in summaries.values()]
        jacs = (None if one is None else one.jac for one in found)
        rows.append((name.strip(), *jacs, *metric_values(others, found[0])))
    title = f"Classes, counted in points (tp, fp, fn at {first:g} px)"
    ties = tie_notes({"": summaries})
    return MetricTable("classes", title, columns, tuple(rows), described, ties)


@dataclass(frozen=True)
class EvaluationRow:
    """One evaluation, or a part of its frames, in a table of several: the names that distinguish
    it, one a heading, and what its figures were computed with."""

    names: tuple[str, ...]
    described: str
    summaries: Mapping[float, SetSummary]


def evaluations_table(
    title: str, headings: tuple[str, ...], rows: list[EvaluationRow]
) -> MetricTable:
    """Evaluations of the same thresholds below each other."""
    described = {row.described for row in rows}
    common = next(iter(described)) if len(described) == 1 else ""
    thresholds = list(rows[0].summaries) if rows else []
    if not common:
        headings = (*headings, "protocol, size")
    largest = max(thresholds, default=0.0)  # there it is rarest that mirrored labels score higher
    columns = (
        *(Column(heading, heading) for heading in headings), count_column("frames"),
        metric_column(metrics.COMPLETENESS),
        *(metric_column(metrics.MEAN_JAC, f"@{tau:g}") for tau in thresholds),
        metric_column(metrics.MEAN_ERROR, f"@{largest:g}"),
    )  # fmt: skip
    values = tuple(
        (
            *row.names, *(() if common else (row.described,)), row.summaries[thresholds[0]].images,
            row.summaries[thresholds[0]].completeness,
            *(row.summaries[tau].mean_jac for tau in thresholds),
            row.summaries[largest].mean_error,
        )
        for row in rows
    )  # fmt: skip
    ties = tie_notes({" ".join(row.names): row.summaries for row in rows})
    return MetricTable("evaluations", title, columns, values, common, ties)


def worst_words(count: int) -> str:
    """``Worst frame``, ``Worst 2 frames``."""
    return "Worst frame" if count == 1 else f"Worst {count} frames"


def percent_text(value: float | None) -> str:
    """A share as a percentage with two decimals; a dash where it is undefined."""
    return metrics.JAC.text(value)


def pixels(value: float | None) -> str:
    """A distance with two decimals; a dash where it is undefined."""
    return metrics.MEAN_ERROR.text(value)


LEFT_OUT_METHOD = "calibrate --leave-one-out"


class MethodWithLeftOut(Protocol):
    """A source some of whose cameras may have been fitted to the clicks they are judged by."""

    @property
    def held_out(self) -> LeftOutMetrics: ...
    @property
    def fitted(self) -> FitCounts: ...
    @property
    def ground_only(self) -> bool: ...


def left_out_table(
    sources: Sequence[tuple[str, MethodWithLeftOut]],
    thresholds: Sequence[float],
    setup: EvaluationSetup,
) -> MetricTable | None:
    """The fits among the sources, by name, each with the share of elements that are correct left
    out, and in sample, at thresholds (px); of fits without such figures only the notes say how to
    get them. None without fits."""
    fits = [(name, source) for name, source in sources if source.fitted.marked]
    if not fits:
        return None
    columns = [
        Column("source", "Method"),
        defined_count_column(metrics.HELD_OUT_ELEMENTS),
        defined_count_column(metrics.FRAMES),
    ]
    columns += [
        metric_column(figure, f"@{tau:g}", key=f"{figure.key}@{shortest_number(tau)}")
        for tau in thresholds
        for figure in (metrics.LEFT_OUT_SCORE, metrics.IN_SAMPLE)
    ]
    rows: list[Row] = []
    for name, source in fits:
        figures = source.held_out
        shares = [figures.shares(tau) or () for tau in thresholds]
        if figures.elements:
            rows.append((name, len(figures.elements), figures.frames, *chain(*shares)))
    notes = [
        "Held out, every element is judged by the camera of the frame's other elements; in sample,"
        " the same elements by the camera of all."
    ][: len(rows)]
    notes += [f"{name}: {why}" for name, source in fits if (why := _why_none(source))]
    all_on_ground = all(source.ground_only for _, source in fits)
    if not all_on_ground:
        notes += [f"{name}: {setup.describe(True)}" for name, source in fits if source.ground_only]
    title, described = "Fits, and elements left out in turn", setup.describe(all_on_ground)
    return MetricTable("held_out", title, tuple(columns), tuple(rows), described, tuple(notes))


def left_out_entry(source: MethodWithLeftOut, thresholds: Sequence[float]) -> dict[str, Any]:
    """As files of figures hold it; nothing of a source that is no fit."""
    if not source.fitted.marked:
        return {}
    figures = source.held_out
    shares = {shortest_number(tau): figures.shares(tau) for tau in thresholds}
    told = {
        "frames": figures.frames,
        "elements": len(figures.elements),
        "results": {
            tau: {metrics.LEFT_OUT_SCORE.key: found[0], metrics.IN_SAMPLE.key: found[1]}
            for tau, found in shares.items()
            if found is not None
        },
        "missing": _why_none(source) or None,
    }
    return {"held_out": told}


def _why_none(source: MethodWithLeftOut) -> str:
    """Reason for which some cameras have no such figures; empty where all have."""
    figures = source.held_out
    if figures.tried >= source.fitted.marked:
        return ""
    cameras = pluralize(source.fitted.marked, "camera")
    without = source.fitted.marked - figures.tried
    which = (
        f"{without} of its {cameras} have no such figures"
        if figures.tried
        else f"none of its {cameras} has such figures"
    )
    if figures.others:
        made = ", ".join(f"{protocol}, {w}x{h}" for protocol, (w, h) in figures.others)
        return (
            f"{which} for this protocol, size and field"
            f" (but for {made}); {LEFT_OUT_METHOD} makes them with --protocol and --size"
        )
    return f"{which}; {LEFT_OUT_METHOD} writes {LEFT_OUT_FILE} with the cameras it fits"
