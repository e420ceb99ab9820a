"""The agreement of several annotators: every two, and each with the consensus of the others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path, PurePath
from string import ascii_uppercase
from typing import Any

import numpy as np

from procc_annotator.batch.agreement import AgreementInference, ConsensusResult
from procc_annotator.formats.annotations.soccernet import write_annotation
from procc_annotator.formats.atomic import open_replacing
from procc_annotator.messages import pluralize
from procc_annotator.metrics.agreement import ClassAgreement
from procc_annotator.report.agreement import (
    LONE,
    WORST,
    AgreementReport,
    agreement_columns,
    agreement_json,
    agreement_row,
    farthest,
    figure_counts,
    frame_entry,
    frames_table,
    inter_annotator_entry,
    inter_annotator_words,
)
from procc_annotator.report.outputs import open_target
from procc_annotator.report.scores.score_files import field_terms, score_format
from procc_annotator.report.scores.score_tables import worst_words
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes, table_entry
from procc_annotator.report.tables.table import (
    Column,
    Metric,
    MetricTable,
    metric_column,
    metric_values,
)

_COUNTS = (metrics.COMMON, metrics.APART, metrics.ADDED, metrics.MISSED, metrics.LEFT_OUT)


def short_names(paths: Sequence[PurePath]) -> tuple[str, ...]:
    """Return what distinguishes paths: the last part in which all differ, or else the whole of
    each."""
    for part in range(1, min(len(path.parts) for path in paths) + 1):
        found = tuple(path.parts[-part] for path in paths)
        if len(set(found)) == len(found):
            return found
    return tuple(map(str, paths))


def write_consensus(agreed: AgreementReport, out: Path) -> None:
    """Write the consensus of each frame to a folder or archive. `SaveError` if it cannot be
    written."""
    with open_target(out) as target:
        for result in agreed.results:
            if result.consensus is not None:
                target.write(f"{result.name}.json", write_annotation(result.consensus.annotation))


# ---------------------------------------------------------------------------------------- tables


def consensus_line(agreed: AgreementReport) -> str:
    """The one line a paper would quote."""
    points = pluralize(agreed.floor.summary.overall.points, "distance")
    return (
        f"Noise floor: {inter_annotator_words(agreed.floor)}, over {points} of every two annotators"
        f" ({agreed.described})"
    )


def consensus_tables(agreed: AgreementReport) -> tuple[MetricTable, ...]:
    """All tables, in the order they are read."""
    return (
        others_table(agreed),
        pairs_table(agreed),
        worst_consensus_table(agreed),
        consensus_classes_table(agreed),
    )


def others_table(agreed: AgreementReport) -> MetricTable:
    """Each annotator against the consensus of the others, with intervals."""
    names = short_names([source.path for source in agreed.run.sources])
    found = {(ascii_uppercase[at], names[at]): own for at, own in agreed.others.items()}
    notes = [f"In brackets {agreed.known}."]
    if of_one_other := sum(len(result.pairs) == 1 for result in agreed.results):
        alone = pluralize(of_one_other, "frame")
        notes.append(f"Of {alone} with two annotators each is compared with the other one.")
    sheet = _agreements_table(agreed, found, ("annotator", "name"), _COUNTS)
    title = "Each annotator against the consensus of the others"
    return replace(sheet, name="annotators", title=title, notes=tuple(notes))


def pairs_table(agreed: AgreementReport) -> MetricTable:
    """Every two annotators."""
    found = {(ascii_uppercase[a], ascii_uppercase[b]): own for (a, b), own in agreed.pairs.items()}
    counts = (metrics.COMMON, metrics.APART, metrics.ONLY_A, metrics.ONLY_B)
    sheet = _agreements_table(agreed, found, ("A", "B"), counts)
    return replace(sheet, name="pairs", title="Every two annotators")


def _agreements_table(
    agreed: AgreementReport,
    found: Mapping[tuple[str, str], AgreementInference],
    headings: tuple[str, str],
    counts: tuple[Metric, ...],
) -> MetricTable:
    """A row an agreement and threshold, by what the agreements are of."""
    columns = (*(Column(h.lower(), h) for h in headings), *agreement_columns(counts))
    rows = tuple(
        (*who, *agreement_row(own, tau, counts))
        for who, own in found.items()
        for tau in agreed.run.thresholds
    )
    return MetricTable("", "", columns, rows, agreed.described)


def consensus_classes_table(agreed: AgreementReport) -> MetricTable:
    """Per class, all annotators against the consensus of the others."""
    found: dict[str, list[tuple[int, ClassAgreement]]] = {}
    lone: dict[tuple[str, str], int] = {}
    for result in agreed.results:
        for at, frame in result.against_others.items():
            for name, own in frame.by_class.items():
                found.setdefault(name, []).append((at, own))
            for key, names in (("added", frame.only_a), ("missed", frame.only_b)):
                for name in names:
                    found.setdefault(name, [])
                    lone[name, key] = lone.get((name, key), 0) + 1
    columns = (
        Column("class", "class"), *figure_counts((metrics.POINTS, *_COUNTS)),
        *map(metric_column, metrics.DISTANCES),
    )  # fmt: skip
    rows = []
    for name in sorted(found):
        pooled = ClassAgreement(
            name,
            np.concatenate([np.empty(0), *(own.distances for _, own in found[name])]),
            sum(own.left_out for _, own in found[name]),
        )
        apart = sum(own.apart for _, own in found[name])
        counts = (
            len(pooled.distances), len(found[name]), apart, lone.get((name, "added"), 0),
            lone.get((name, "missed"), 0), pooled.left_out,
        )  # fmt: skip
        rows.append((name.strip(), *counts, *metric_values(metrics.DISTANCES, pooled)))
    title = "Classes, all annotators against the others"
    return MetricTable("classes", title, columns, tuple(rows), agreed.described)


def worst_consensus_table(agreed: AgreementReport) -> MetricTable:
    """The frames and annotators to look at first: lowest JaC against the others, then farthest."""
    tau = agreed.run.thresholds[0]
    rows = []
    for result in agreed.results:
        for at, frame in result.against_others.items():
            if not frame.element_count:
                continue
            rows.append(
                (result.name, ascii_uppercase[at], frame.jac(tau), len(frame.only_a),
                 len(frame.only_b), *farthest(frame), "mirrored?" if frame.mirrored_hint else None)
            )  # fmt: skip
    rows.sort(key=lambda row: (row[2], -(row[5] or 0.0)))
    columns = (
        Column("frame", "frame"),
        Column("annotator", "annotator"),
        metric_column(metrics.JAC),
        *figure_counts((metrics.ADDED, metrics.MISSED)),
        metric_column(metrics.LARGEST_PX),
        Column("farthest", "farthest element"),
        Column("labels", "labels"),
    )
    shown = tuple(rows[:WORST])
    title = f"{worst_words(len(shown))} and annotators at {tau:g} px"
    return MetricTable("worst_frames", title, columns, shown, agreed.described)


# ----------------------------------------------------------------------------------------- files


def write_agreement(agreed: AgreementReport, output: Path) -> None:
    """Write every metric to a ``.json``; to a ``.csv`` one row a frame and class, of three
    annotators or more one a frame, annotator and class.

    Raises:
        UsageError: an output of another kind.
        SaveError: it cannot be written.
    """
    is_json, of_two = score_format(output) == "json", len(agreed.run.sources) == 2
    if is_json:
        data = agreement_json(agreed) if of_two else json_bytes(_content(agreed), indent=0)
    else:
        data = csv_bytes(frames_table(agreed))
    with open_replacing(output) as stream:
        stream.write(data)


def _content(agreed: AgreementReport) -> dict[str, Any]:
    run = agreed.run
    return {
        **field_terms(run.field),
        "size": list(run.size),
        "thresholds": list(run.thresholds),
        "annotators": [
            {
                "annotator": ascii_uppercase[at],
                "path": str(source.path),
                "alone": list(run.alone[at]),
            }
            for at, source in enumerate(run.sources)
        ],
        "images": [_frame_entry(result, run.thresholds) for result in agreed.results],
        "summary": {
            "frames": agreed.floor.summary.frames,
            "noise_floor": inter_annotator_entry(agreed.floor, agreed.known),
            **{sheet.name: table_entry(sheet) for sheet in consensus_tables(agreed)},
        },
    }


def _frame_entry(result: ConsensusResult, thresholds: Sequence[float]) -> dict[str, Any]:
    undecided = () if result.consensus is None else result.consensus.undecided
    return {
        "name": result.name,
        "errors": list(result.errors),
        "undecided": list(undecided),
        "annotators": {
            ascii_uppercase[at]: frame_entry(frame, thresholds, LONE[False])
            for at, frame in result.against_others.items()
        },
    }
