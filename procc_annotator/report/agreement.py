"""The agreement of two annotators: tables for the terminal, JSON and CSV for the rest."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from procc_annotator.errors import UsageError
from procc_annotator.io.atomic import open_replacing
from procc_annotator.metric.agreement import AgreementSummary, sorted_quantile
from procc_annotator.metric.chance.sampling import BootstrapSettings
from procc_annotator.report.agreement_figures import (
    ELEMENT_COLUMNS,
    WORST,
    element_rows,
    farthest,
    inter_annotator_entry,
    frame_entry,
    intervals_described,
    status_row,
)
from procc_annotator.report.field_terms import field_terms
from procc_annotator.report.scores.score_files import score_format
from procc_annotator.report.scores.tables import pixels, worst_words
from procc_annotator.report.sheet.as_csv import csv_bytes
from procc_annotator.report.sheet.as_json import encoded, metric_entry
from procc_annotator.report.sheet.figure import shortest_number, metric_values
from procc_annotator.report.sheet.figures import (
    APART,
    COMMON,
    DISTANCES,
    JAC,
    LARGEST_PX,
    LEFT_OUT,
    MEDIAN_PX,
    OF_AGREEMENT,
    ONLY_A,
    ONLY_B,
    POINTS,
)  # fmt: skip
from procc_annotator.report.sheet.sheet import TAU, Column, Row, MetricTable, metric_column, count_column
from procc_annotator.session.runs.agreement_run import AgreementRun
from procc_annotator.session.runs.clusters import Clusters, clusters_of
from procc_annotator.session.runs.consensus_run import ConsensusResult
from procc_annotator.session.runs.sure_agreement import AgreementInference, agreement_inference
from procc_annotator.words import count_words

_LONE = ("only_a", "only_b")

ClustersOf = Callable[[Sequence[str]], Clusters]
Progress = Callable[[Iterable[ConsensusResult], int, str], Iterator[ConsensusResult]]


@dataclass(frozen=True)
class AgreementReport:
    """A set's agreement and what has to be said about it.

    Attributes:
        floor: the same with intervals; known: what these rest on.
        results: of all frames.
        errors: of files that could not be read.
    """

    summary: AgreementSummary
    described: str
    floor: AgreementInference
    known: str
    results: tuple[ConsensusResult, ...]
    errors: list[str]


def agree_sets(
    run: AgreementRun,
    *,
    outputs: Sequence[Path] = (),
    progress: Progress = lambda items, _total, _what: iter(items),
    clusters: ClustersOf = lambda frames: clusters_of(frames, None, {}),
) -> AgreementReport:
    """Compare two annotators' files and write what is found.

    Args:
        run: not yet iterated.
        outputs: ``.json`` or ``.csv`` files.
        progress: wraps the frames as they come, given their number and a word for the work.
        clusters: which of some frames are alike, for intervals.

    Raises:
        UsageError: frames that cannot be clustered; no frame of which both files can be
            read; an output of another kind.
        SaveError: an output cannot be written.
    """
    results = tuple(progress(run, run.total, "comparing"))
    errors = [error for result in results for error in result.errors]
    found = [(r.name, r.agreement) for r in results if r.agreement is not None]
    if not found:
        raise UsageError(
            f"of none of the {run.total} frames both annotations can be read;"
            f" the first: {errors[0]}"
        )
    names = [name for name, _ in found]
    alike, draws = clusters(names), BootstrapSettings()
    floor = agreement_inference(names, found, run.thresholds, alike, draws)
    known = intervals_described(draws, alike)
    agreed = AgreementReport(run.summary(), run.describe(), floor, known, results, errors)
    for output in outputs:
        is_json = score_format(output) == "json"
        with open_replacing(output) as stream:
            stream.write(_json(agreed, run) if is_json else csv_bytes(_frames_sheet(agreed, run)))
    return agreed


# ---------------------------------------------------------------------------------------- tables


def inter_annotator_line(agreed: AgreementReport) -> str:
    """The one line a paper would quote."""
    found = agreed.summary.overall
    return (
        f"Noise floor: median {pixels(found.median)} px, 95 % {pixels(found.p95)} px,"
        f" max {pixels(found.largest)} px, over {count_words(found.points, 'distance')}"
        f" of {count_words(found.common, 'element')} ({agreed.described})"
    )


def jac_table(agreed: AgreementReport) -> MetricTable:
    """One row a threshold: the JaC one annotator would score if the other were a camera."""
    summary = agreed.summary
    counts = (COMMON, ONLY_A, ONLY_B)
    columns = (TAU, metric_column(JAC), *(count_column(figure.key, figure.title) for figure in counts))
    found = metric_values(counts, summary.overall)
    rows = tuple((tau, jac, *found) for tau, jac in summary.mean_jac.items())
    title = f"Agreement of {count_words(summary.frames, 'frame')} both annotated"
    return MetricTable("agreement", title, columns, rows, agreed.described)


def agreement_classes_table(agreed: AgreementReport) -> MetricTable:
    """Per class and, last, all classes together."""
    per_class, overall = agreed.summary.per_class, agreed.summary.overall
    told = (POINTS, LEFT_OUT, COMMON, APART, ONLY_A, ONLY_B)
    columns = (
        Column("class", "class"), *(count_column(count.key, count.title) for count in told),
        *map(metric_column, DISTANCES),
    )  # fmt: skip
    rows = tuple(
        (name, *metric_values((*told, *DISTANCES), figures))
        for name, figures in [*((n.strip(), f) for n, f in per_class.items()), ("all", overall)]
    )
    title, parts = "Distances between A and B", (len(per_class),)
    return MetricTable("classes", title, columns, rows, agreed.described, parts=parts)


def worst_agreement_table(agreed: AgreementReport) -> MetricTable:
    """The frames to look at first: lowest JaC, then largest distance."""
    tau = next(iter(agreed.summary.mean_jac))
    found = [
        (result.name, result.agreement, *farthest(result.agreement))
        for result in agreed.results
        if result.agreement is not None and result.agreement.element_count
    ]
    found.sort(key=lambda one: (one[1].jac(tau), -(one[2] or 0.0)))
    columns = (
        Column("frame", "frame"), metric_column(JAC), count_column("common", "in common"), count_column("only_a", "only A"),
        count_column("only_b", "only B"), metric_column(MEDIAN_PX), metric_column(LARGEST_PX),
        Column("farthest", "farthest element"), Column("labels", "labels"),
    )  # fmt: skip
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


def _json(agreed: AgreementReport, run: AgreementRun) -> bytes:
    """A line a frame: the terms of the field, then ``"size", "thresholds", "a", "b", "images",
    "summary"``."""
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
    return entry if found is None else entry | frame_entry(found, thresholds, _LONE)


def _summary_entry(summary: AgreementSummary) -> dict[str, Any]:
    return {
        "frames": summary.frames,
        "frames_only_a": list(summary.frames_only_a),
        "frames_only_b": list(summary.frames_only_b),
        "mirrored_hint": list(summary.mirrored),
        "mean_jac": {shortest_number(tau): jac for tau, jac in summary.mean_jac.items()},
        "per_class": {n: metric_entry(OF_AGREEMENT, f) for n, f in summary.per_class.items()},
    }


def _frames_sheet(agreed: AgreementReport, run: AgreementRun) -> MetricTable:
    """One row a frame and class; a frame with nothing to show has a row without class.

    The status of a class is ``common``, ``apart``, ``only_a`` or ``only_b``; that of a row without
    class ``empty``, ``unreadable``, ``frame_only_a`` or ``frame_only_b``.
    """
    columns = (Column("name"), Column("field"), count_column("width"), count_column("height"), *ELEMENT_COLUMNS)
    terms = (run.field.described, *run.size)
    found: list[tuple[str, Row]] = []
    for one in agreed.results:
        if one.agreement is None:
            found.append((one.name, status_row("unreadable", error="; ".join(one.errors))))
            continue
        own = element_rows(one.agreement, _LONE) or [status_row("empty")]
        found += [(one.name, row) for row in own]
    for status, names in (("frame_only_a", run.only_a), ("frame_only_b", run.only_b)):
        found += [(name, status_row(status)) for name in names]
    return MetricTable("frames", "Frames", columns, tuple((name, *terms, *row) for name, row in found))
