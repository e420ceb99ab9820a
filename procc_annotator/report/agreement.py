"""Inter-annotator agreement of two annotators: tables and files; columns shared with consensus."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from string import ascii_uppercase
from typing import Any

import numpy as np

from procc_annotator.batch.agreement import (
    AgreementInference,
    ConsensusResult,
    ConsensusRun,
    agreement_inference,
)
from procc_annotator.batch.execution.executor import Progress
from procc_annotator.batch.grouping import Clusters, clusters_of
from procc_annotator.errors import UsageError
from procc_annotator.messages import pluralize
from procc_annotator.metrics.agreement import AgreementSummary, FrameAgreement, sorted_quantile
from procc_annotator.metrics.statistics.intervals import BootstrapSettings, Interval
from procc_annotator.report.scores.inference_tables import columns_with_intervals, interval_ends
from procc_annotator.report.scores.score_files import field_terms
from procc_annotator.report.scores.score_tables import pixels, worst_words
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.data_files import encoded, metric_entry
from procc_annotator.report.tables.table import (
    TAU,
    Column,
    Metric,
    MetricTable,
    Row,
    count_column,
    metric_column,
    metric_values,
    shortest_number,
)

WORST = 10  # frames that tables of the worst show
ELEMENT_COLUMNS = (
    Column("class"),
    Column("status"),
    count_column("points"),
    count_column("left_out"),
    *map(metric_column, metrics.DISTANCES),
    Column("mirrored_hint", kind="yes_no"),
    Column("error"),
)
_POINTS = (0.01, 0.02, 0.05)  # of JaC
_SHARES = (0.05, 0.1, 0.2)  # of a distance


def element_rows(frame: FrameAgreement, lone: tuple[str, str]) -> list[Row]:
    """One row of `ELEMENT_COLUMNS` an element; ``lone``: the status of elements of the first
    annotation alone, and of the second alone."""
    hint = frame.mirrored_hint
    rows: list[Row] = [
        (own.class_name, "apart" if own.apart else "common", len(own.distances), own.left_out,
         *metric_values(metrics.DISTANCES, own), hint, None)
        for own in frame.by_class.values()
    ]  # fmt: skip
    for status, names in zip(lone, (frame.only_a, frame.only_b), strict=True):
        rows += [status_row(status, name, hint=hint) for name in names]
    return rows


def status_row(
    status: str, name: str | None = None, *, hint: bool | None = None, error: str | None = None
) -> Row:
    """A row of `ELEMENT_COLUMNS` without distances."""
    return (name, status, *(None,) * (2 + len(metrics.DISTANCES)), hint, error)


def frame_entry(
    frame: FrameAgreement, thresholds: Sequence[float], lone: tuple[str, str]
) -> dict[str, Any]:
    """The agreement of two annotations of one frame in files; ``lone`` as of `element_rows`."""
    return {
        "jac": {shortest_number(tau): frame.jac(tau) for tau in thresholds},
        lone[0]: list(frame.only_a),
        lone[1]: list(frame.only_b),
        "mirrored_hint": frame.mirrored_hint,
        "elements": {
            name: metric_entry(metrics.DISTANCES, own)
            | {"left_out": own.left_out, "distances": own.distances.tolist()}
            for name, own in frame.by_class.items()
        },
    }


def farthest(frame: FrameAgreement) -> tuple[float | None, str]:
    """The largest distance, px, and the class of its element."""
    by_size = [(c.largest, n) for n, c in frame.by_class.items() if c.largest is not None]
    largest, name = max(by_size, default=(None, ""))
    return largest, name.strip()


def figure_counts(figures: Iterable[Metric]) -> list[Column]:
    """Counts as columns."""
    return [count_column(figure.key, figure.title) for figure in figures]


def agreement_columns(counts: Iterable[Metric]) -> tuple[Column, ...]:
    """The columns of an agreement with intervals, and of counts."""
    shown = columns_with_intervals((metrics.JAC, metrics.MEDIAN_PX, metrics.P95_PX))
    ends = metric_column(metrics.LARGEST_PX), *figure_counts(counts)
    return (TAU, count_column("frames"), *shown, *ends)


def agreement_row(found: AgreementInference, tau: float, counts: Iterable[Metric]) -> Row:
    """The values of `agreement_columns` at a threshold, px."""
    overall, known = found.summary.overall, found.known
    low, high = interval_ends(known.jac[tau])
    ends = (None if low is None else max(0.0, low), None if high is None else min(1.0, high))
    return (
        tau, found.summary.frames, found.summary.mean_jac[tau], *ends,
        overall.median, *interval_ends(known.median), overall.p95, *interval_ends(known.p95),
        overall.largest, *metric_values(counts, overall),
    )  # fmt: skip


def intervals_described(draws: BootstrapSettings, clusters: Clusters) -> str:
    """Return what the intervals of an agreement rest on, in words."""
    said = f"{100 * draws.level:g} % intervals (t, jackknife of clusters); {clusters.described}"
    return f"{said}. {clusters.caution.rstrip('.')}" if clusters.caution else said


def inter_annotator_words(floor: AgreementInference) -> str:
    """The noise floor with its intervals, in words."""
    found, known = floor.summary.overall, floor.known

    def worded(value: float | None, interval: Interval | None) -> str:
        around = ""
        if interval is not None:
            around = f" [{pixels(interval.low)}, {pixels(interval.high)}]"
        return f"{pixels(value)} px{around}"

    return f"median {worded(found.median, known.median)}, 95 % {worded(found.p95, known.p95)}"


def inter_annotator_entry(floor: AgreementInference, described: str) -> dict[str, Any]:
    """The noise floor in files: the figures, and the intervals of median and 95 %, ``described`` in
    words."""
    known = floor.known
    ends = {
        f"{figure.key}_interval": None if found is None else [found.low, found.high]
        for figure, found in ((metrics.MEDIAN_PX, known.median), (metrics.P95_PX, known.p95))
    }
    return (
        metric_entry(metrics.OF_AGREEMENT, floor.summary.overall) | ends | {"intervals": described}
    )


def sample_size_table(found: AgreementInference, described: str, known: str) -> MetricTable:
    """Return how many frames such a study needs, by a pilot, before JaC is known to 1, 2 and 5
    points and distances to 5, 10 and 20 %; ``known``: what intervals rest on, in words."""
    columns = (
        Column("figure", "figure"),
        TAU,
        count_column("frames", "frames now"),
        Column("known_to", "known to ±", "number", written=".3g"),
        Column("wanted", "wanted ±", "number", written=".3g"),
        count_column("needed", "frames needed"),
    )
    rows: list[Row] = []
    overall = found.summary.overall
    for tau, interval in found.known.jac.items():
        rows += [
            ("JaC, points", tau, found.frames, _half(interval, 100.0), 100 * points,
             found.frames_for(interval, points))
            for points in _POINTS
        ]  # fmt: skip
    for title, value, interval in (
        ("median, px", overall.median, found.known.median),
        ("95 %, px", overall.p95, found.known.p95),
    ):
        if not value:
            continue
        if interval is not None and interval.high >= (overall.largest or 0.0):
            interval = None  # it ends because the distances do
        rows += [
            (title, None, found.frames, _half(interval, 1.0), share * value,
             found.frames_for(interval, share * value))
            for share in _SHARES
        ]  # fmt: skip
    note = (
        "Frames of the same kind, in clusters like these. No answer where an interval ends with the"
        f" largest distance: how far it would reach is not known. {known}."
    )
    return MetricTable("power", "Frames needed", columns, tuple(rows), described, (note,))


def _half(interval: Interval | None, times: float) -> float | None:
    return None if interval is None else times * (interval.high - interval.low) / 2


LONE = (("added", "missed"), ("only_a", "only_b"))  # of several annotators, of two


@dataclass(frozen=True)
class AgreementReport:
    """The agreement of two or more annotators over a set.

    Attributes:
        floor: of every two annotators together.
        pairs: every two that share frames, by their places.
        others: of three or more, each against the consensus of the others; a place is missing where
            no one shares a frame with that annotator.
        known: what intervals rest on.
    """

    run: ConsensusRun
    results: tuple[ConsensusResult, ...]
    floor: AgreementInference
    pairs: dict[tuple[int, int], AgreementInference]
    others: dict[int, AgreementInference]
    known: str

    @property
    def described(self) -> str:
        """Field and size, in words."""
        return self.run.describe()

    @property
    def errors(self) -> list[str]:
        """Files that could not be read, one line each."""
        return [error for result in self.results for error in result.errors]

    @property
    def summary(self) -> AgreementSummary:
        """Metrics of two annotators."""
        only_a, only_b = self.run.alone
        return replace(self.floor.summary, frames_only_a=only_a, frames_only_b=only_b)


def compare_annotators(
    run: ConsensusRun,
    clusters: Callable[[Sequence[str]], Clusters] = lambda frames: clusters_of(frames, None, {}),
    progress: Progress[ConsensusResult] = lambda items, _total, _what: iter(items),
) -> AgreementReport:
    """Compare annotators' files.

    Args:
        run: not yet iterated.
        clusters: which of some frames, by name, are alike.

    Raises:
        UsageError: no frame of which two files can be read; frames that cannot be clustered.
    """
    results = tuple(progress(run, run.total, "comparing"))
    there = [result for result in results if result.pairs]
    if not there:
        which = "both" if len(run.sources) == 2 else "two"
        first = next(error for result in results for error in result.errors)
        raise UsageError(
            f"of none of the {run.total} frames {which} annotations can be read; the first: {first}"
        )
    frames = [result.name for result in there]
    alike, draws = clusters(frames), BootstrapSettings()

    def inference(found: list[tuple[str, FrameAgreement]]) -> AgreementInference:
        return agreement_inference(frames, found, run.thresholds, alike, draws)

    pairs: dict[tuple[int, int], list[tuple[str, FrameAgreement]]] = {}
    others: dict[int, list[tuple[str, FrameAgreement]]] = {}
    for result in there:
        for pair, found in result.pairs.items():
            pairs.setdefault(pair, []).append((result.name, found))
        for at, found in result.against_others.items():
            others.setdefault(at, []).append((result.name, found))
    return AgreementReport(
        run,
        results,
        inference([(r.name, found) for r in there for found in r.pairs.values()]),
        {pair: inference(pairs[pair]) for pair in sorted(pairs)},
        {at: inference(others[at]) for at in sorted(others)},
        intervals_described(draws, alike),
    )


# ---------------------------------------------------------------------------------------- tables


def inter_annotator_line(agreed: AgreementReport) -> str:
    """The one line a paper would quote."""
    found = agreed.summary.overall
    return (
        f"Noise floor: median {pixels(found.median)} px, 95 % {pixels(found.p95)} px,"
        f" max {pixels(found.largest)} px, over {pluralize(found.points, 'distance')}"
        f" of {pluralize(found.common, 'element')} ({agreed.described})"
    )


def agreement_tables(agreed: AgreementReport) -> list[MetricTable]:
    """All tables of two annotators, in the order they are read."""
    worst = _worst_table(agreed)
    return [_jac_table(agreed), *([worst] if worst.rows else []), _classes_table(agreed)]


def _jac_table(agreed: AgreementReport) -> MetricTable:
    """One row a threshold: the JaC one annotator would score if the other were a camera."""
    summary = agreed.summary
    counts = (metrics.COMMON, metrics.ONLY_A, metrics.ONLY_B)
    columns = (
        TAU,
        metric_column(metrics.JAC),
        *figure_counts(counts),
    )
    found = metric_values(counts, summary.overall)
    rows = tuple((tau, jac, *found) for tau, jac in summary.mean_jac.items())
    title = f"Agreement of {pluralize(summary.frames, 'frame')} both annotated"
    return MetricTable("agreement", title, columns, rows, agreed.described)


def _classes_table(agreed: AgreementReport) -> MetricTable:
    """Per class and, last, all classes together."""
    per_class, overall = agreed.summary.per_class, agreed.summary.overall
    shown = (
        metrics.POINTS,
        metrics.LEFT_OUT,
        metrics.COMMON,
        metrics.APART,
        metrics.ONLY_A,
        metrics.ONLY_B,
    )
    columns = (
        Column("class", "class"), *figure_counts(shown),
        *map(metric_column, metrics.DISTANCES),
    )  # fmt: skip
    rows = tuple(
        (name, *metric_values((*shown, *metrics.DISTANCES), figures))
        for name, figures in [*((n.strip(), f) for n, f in per_class.items()), ("all", overall)]
    )
    title, parts = "Distances between A and B", (len(per_class),)
    return MetricTable("classes", title, columns, rows, agreed.described, parts=parts)


def _worst_table(agreed: AgreementReport) -> MetricTable:
    """The frames to look at first: lowest JaC, then largest distance."""
    tau = next(iter(agreed.summary.mean_jac))
    found = [
        (result.name, result.agreement, *farthest(result.agreement))
        for result in agreed.results
        if result.agreement is not None and result.agreement.element_count
    ]
    found.sort(key=lambda one: (one[1].jac(tau), -(one[2] or 0.0)))
    columns = (
        Column("frame", "frame"),
        metric_column(metrics.JAC),
        count_column("common", "in common"),
        count_column("only_a", "only A"),
        count_column("only_b", "only B"),
        metric_column(metrics.MEDIAN_PX),
        metric_column(metrics.LARGEST_PX),
        Column("farthest", "farthest element"),
        Column("labels", "labels"),
    )
    rows = tuple(
        (
            name, frame.jac(tau), len(frame.by_class), len(frame.only_a), len(frame.only_b),
            sorted_quantile(np.sort(frame.distances), 0.5), largest, element,
            "mirrored?" if frame.mirrored_hint else None,
        )
        for name, frame, largest, element in found[:WORST]
    )  # fmt: skip
    title = f"{worst_words(len(rows))} at {tau:g} px"
    return MetricTable("worst_frames", title, columns, rows, agreed.described)


# ----------------------------------------------------------------------------------------- files


def agreement_json(agreed: AgreementReport) -> bytes:
    """A line a frame: the terms of the field, then ``"size", "thresholds", "a", "b", "images",
    "summary"``."""
    run = agreed.run
    a, b = (str(source.path) for source in run.sources)
    terms = {"size": list(run.size), "thresholds": list(run.thresholds), "a": a, "b": b}
    images = b",\n".join(encoded(_frame_entry(one, run.thresholds)) for one in agreed.results)
    floor = {"noise_floor": inter_annotator_entry(agreed.floor, agreed.known)}
    summary = encoded(_summary_entry(agreed.summary) | floor)
    head = encoded({**field_terms(run.field), **terms})[:-1]
    return head + b',"images":[\n' + images + b'\n],"summary":' + summary + b"}\n"


def _frame_entry(result: ConsensusResult, thresholds: Sequence[float]) -> dict[str, Any]:
    entry: dict[str, Any] = {"name": result.name, "errors": list(result.errors)}
    found = result.agreement
    return entry if found is None else entry | frame_entry(found, thresholds, LONE[True])


def _summary_entry(summary: AgreementSummary) -> dict[str, Any]:
    return {
        "frames": summary.frames,
        "frames_only_a": list(summary.frames_only_a),
        "frames_only_b": list(summary.frames_only_b),
        "mirrored_hint": list(summary.mirrored),
        "mean_jac": {shortest_number(tau): jac for tau, jac in summary.mean_jac.items()},
        "per_class": {
            n: metric_entry(metrics.OF_AGREEMENT, f) for n, f in summary.per_class.items()
        },
    }


def frames_table(agreed: AgreementReport) -> MetricTable:
    """One row a frame and class; of three annotators or more one a frame, annotator and class,
    against the consensus of the others. A frame with nothing to show has a row without class.

    The status of a class is ``common``, ``apart``, ``only_a`` or ``only_b``, with the others
    ``added`` or ``missed``; that of a row without class ``empty``, ``unreadable``, ``frame_only_a``
    or ``frame_only_b``, with the others ``alone``.
    """
    run = agreed.run
    of_two = len(run.sources) == 2
    head = ("name", "field", "width", "height", *(() if of_two else ("annotator",)))
    columns = [count_column(k) if k in ("width", "height") else Column(k) for k in head]
    terms = (run.field.described, *run.size)
    letters = ((),) * 2 if of_two else tuple((letter,) for letter in ascii_uppercase)
    rows: list[Row] = []
    for one in agreed.results:
        pair = {} if one.agreement is None else {0: one.agreement}
        for at, frame in (pair if of_two else one.against_others).items():
            empty = status_row("empty", hint=None if of_two else frame.mirrored_hint)
            own = element_rows(frame, LONE[of_two]) or [empty]
            rows += [(one.name, *terms, *letters[at], *row) for row in own]
        if one.errors:
            unread = status_row("unreadable", error="; ".join(one.errors))
            rows.append((one.name, *terms, *(() if of_two else (None,)), *unread))
    alone = ("frame_only_a", "frame_only_b") if of_two else ("alone",) * len(run.alone)
    for letter, status, names in zip(letters, alone, run.alone, strict=False):
        rows += [(name, *terms, *letter, *status_row(status)) for name in names]
    return MetricTable("frames", "Frames", (*columns, *ELEMENT_COLUMNS), tuple(rows))
