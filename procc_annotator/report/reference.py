"""Annotators against reference annotations: tables for the terminal, JSON and CSV for the rest."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from procc_annotator.batch.agreement import AgreementRun, ConsensusResult, agreement_inference
from procc_annotator.batch.execution.executor import Progress
from procc_annotator.batch.grouping import Clusters
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.metrics.agreement import FrameAgreement, sorted_quantile
from procc_annotator.metrics.statistics.intervals import BootstrapSettings
from procc_annotator.report.agreement import agreement_columns, agreement_row, intervals_described
from procc_annotator.report.scores.score_files import field_terms, score_format
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes, table_entry
from procc_annotator.report.tables.table import (
    Column,
    MetricTable,
    Row,
    count_column,
    metric_column,
)

_COUNTS = (metrics.COMMON, metrics.APART, metrics.ADDED, metrics.MISSED, metrics.LEFT_OUT)


@dataclass
class AgainstReference:
    """Annotators against reference frames; a row of a table each, as they are added.

    Attributes:
        reference: where the answers are.
        known: what intervals rest on.
        errors: of files that could not be read, one line each.
    """

    reference: Path
    annotators: dict[str, Path] = field(default_factory=dict)
    rows: list[Row] = field(default_factory=list)
    frames: list[Row] = field(default_factory=list)
    known: dict[str, None] = field(default_factory=dict)
    errors: list[str] = field(default_factory=list)

    def add(
        self,
        name: str,
        place: Path,
        run: AgreementRun,
        clusters_of: Callable[[Sequence[str]], Clusters],
        progress: Progress[ConsensusResult],
    ) -> None:
        """Compare an annotator with the reference, which is the second of the run's sources."""
        results = list(progress(run, run.total, "comparing"))
        self.annotators[name] = place
        self.errors += [error for result in results for error in result.errors]
        found = [(r.name, r.agreement) for r in results if r.agreement is not None]
        if not found:
            return
        names, draws = [frame for frame, _ in found], BootstrapSettings()
        clusters = clusters_of(names)
        self.known[intervals_described(draws, clusters)] = None
        sure = agreement_inference(names, found, run.thresholds, clusters, draws)
        self.rows += [(name, *agreement_row(sure, tau, _COUNTS)) for tau in run.thresholds]
        self.frames += [(name, *_frame_row(one, own, run.thresholds)) for one, own in found]

    def sheet(self, described: str) -> MetricTable:
        """Return each annotator over all reference frames, a row a threshold."""
        columns = (Column("annotator", "annotator"), *agreement_columns(_COUNTS))
        notes = (f"In brackets {'; '.join(self.known)}.",)
        title = "Each annotator against the reference"
        return MetricTable("reference", title, columns, tuple(self.rows), described, notes)

    def write(self, run: AgreementRun, described: str, output: Path) -> None:
        """Write all tables to a ``.json``, or a row a frame and annotator to a ``.csv``.
        `SaveError` if it cannot be written."""
        jacs = (Column(f"jac_{t:g}", f"JaC @{t:g}", "number", metrics.JAC) for t in run.thresholds)
        columns = (
            Column("annotator", "annotator"),
            Column("frame", "frame"),
            *jacs,
            metric_column(metrics.MEDIAN_PX),
            metric_column(metrics.P95_PX),
            metric_column(metrics.LARGEST_PX),
            count_column("added"),
            count_column("missed"),
        )
        frames = MetricTable("frames", "Reference frames", columns, tuple(self.frames), described)
        if score_format(output) == "csv":
            write_atomic(output, csv_bytes(frames))
            return
        content: dict[str, Any] = {
            **field_terms(run.field),
            "size": list(run.size),
            "thresholds": list(run.thresholds),
            "reference_path": str(self.reference),
            "annotators": {name: str(path) for name, path in self.annotators.items()},
        }
        content |= {one.name: table_entry(one) for one in (self.sheet(described), frames)}
        write_atomic(output, json_bytes(content))


def _frame_row(name: str, frame: FrameAgreement, thresholds: Sequence[float]) -> Row:
    ascending = np.sort(frame.distances)
    return (
        name,
        *(frame.jac(tau) for tau in thresholds),
        *(sorted_quantile(ascending, share) for share in (0.5, 0.95, 1.0)),
        len(frame.only_a), len(frame.only_b),
    )  # fmt: skip
