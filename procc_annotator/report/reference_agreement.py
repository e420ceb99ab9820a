"""Errors of annotators against reference frames: tables and files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from procc_annotator.batch.agreement_statistics import THIRDS, ReferenceErrors, ReferenceFrame
from procc_annotator.field.model import Field
from procc_annotator.formats.atomic import open_replacing
from procc_annotator.messages import pluralize
from procc_annotator.metrics.agreement import sorted_quantile
from procc_annotator.report.agreement import agreement_columns, agreement_values
from procc_annotator.report.scores.score_files import field_terms, score_format
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes, table_entry
from procc_annotator.report.tables.metrics import (
    ADDED,
    APART,
    COMMON,
    JAC,
    LARGEST_PX,
    LEFT_OUT,
    MEDIAN_PX,
    MISSED,
    P95_PX,
    TREND,
    TREND_P,
)
from procc_annotator.report.tables.table import (
    TAU,
    Column,
    MetricTable,
    Row,
    count_column,
    metric_column,
    metric_values,
)

_COUNTS = (COMMON, APART, ADDED, MISSED, LEFT_OUT)
_TEN = 10


@dataclass(frozen=True)
class ReferenceComparison:
    """Annotators against gold frames.

    Attributes:
        answers: where the answers are. paths: of each annotator.
        names: what tells annotators apart.
        found: of each; None where none of the gold frames can be compared.
        gold: how many frames are gold.
        known: what intervals rest on.
        errors: of files that could not be read.
    """

    answers: Path
    paths: tuple[Path, ...]
    names: tuple[str, ...]
    found: tuple[ReferenceErrors | None, ...]
    gold: int
    thresholds: tuple[float, ...]
    field: Field
    size: tuple[int, int]
    known: str
    errors: tuple[str, ...]

    @property
    def described(self) -> str:
        """What the numbers depend on, in words."""
        return f"{self.field.described}, {self.size[0]}x{self.size[1]}"

    @property
    def there(self) -> list[tuple[str, ReferenceErrors]]:
        """The annotators with gold frames."""
        pairs = zip(self.names, self.found, strict=True)
        return [(name, found) for name, found in pairs if found is not None]


def reference_tables(against: ReferenceComparison) -> tuple[MetricTable, ...]:
    """All tables, in the order they are read; none over time where nobody's order is known."""
    timed = any(found.timed for _, found in against.there)
    return (errors_table(against), *((learning_trend_table(against),) if timed else ()))


def errors_table(against: ReferenceComparison) -> MetricTable:
    """Each annotator over all gold frames."""
    columns = (
        Column("annotator", "annotator"), TAU, count_column("frames"),
        *agreement_columns(),
        metric_column(LARGEST_PX), *(count_column(figure.key, figure.title) for figure in _COUNTS),
    )  # fmt: skip
    rows = [
        (name, tau, len(found.frames), *agreement_values(found.sure, tau),
         found.sure.summary.overall.largest,
         *metric_values(_COUNTS, found.sure.summary.overall))
        for name, found in against.there
        for tau in against.thresholds
    ]  # fmt: skip
    notes = [f"Gold: {pluralize(against.gold, 'frame')}. In brackets {against.known}."]
    if not any(found.timed for _, found in against.there):
        notes.append("Nothing tells when points were put: errors have no order of work.")
    title = "Each annotator against gold"
    return MetricTable("gold", title, columns, tuple(rows), against.described, tuple(notes))


def learning_trend_table(against: ReferenceComparison) -> MetricTable:
    """The thirds of each annotator's gold frames in the order of work, and the trend."""
    tau = against.thresholds[0]
    columns: list[Column] = [Column("annotator", "annotator")]
    for third in THIRDS:
        columns += [
            metric_column(MEDIAN_PX, key=f"{third}_median", group=f"{third} third"),
            metric_column(JAC, f" @{tau:g}", key=f"{third}_jac", group=f"{third} third"),
        ]
    columns += [metric_column(TREND), metric_column(TREND_P)]
    rows: list[Row] = []
    for name, found in against.there:
        row: list[float | None] = []
        for part in found.thirds:
            row += [part.summary.overall.median, part.summary.mean_jac[tau]]
        row += [None] * (2 * len(THIRDS) - len(row))
        slope = None if found.trend is None else found.trend.slope * _TEN
        rows.append((name, *row, slope, None if found.trend is None else found.trend.p))
    untold = [name for name, found in against.there if not found.timed]
    notes = ["The order is that of the times at which points were put."]
    if untold:
        notes.append(f"No times are known of all frames of {', '.join(untold)}.")
    title = "Over the order of work"
    return MetricTable(
        "over_time", title, tuple(columns), tuple(rows), against.described, tuple(notes)
    )


def reference_frames_table(against: ReferenceComparison) -> MetricTable:
    """One row a gold frame and annotator, in the order of work."""
    jacs = tuple(
        Column(f"jac_{tau:g}", f"JaC @{tau:g}", "number", JAC) for tau in against.thresholds
    )
    columns = (
        Column("annotator", "annotator"),
        count_column("place"),
        Column("frame", "frame"),
        Column("time", "time"),
        *jacs,
        metric_column(MEDIAN_PX),
        metric_column(P95_PX),
        metric_column(LARGEST_PX),
        count_column("added"),
        count_column("missed"),
    )
    rows = [
        (name, place, frame.name, _time_text(frame), *_figures(frame, against.thresholds))
        for name, found in against.there
        for place, frame in enumerate(found.frames, 1)
    ]
    return MetricTable("frames", "Gold frames", columns, tuple(rows), against.described)


def write_reference_comparison(against: ReferenceComparison, output: Path) -> None:
    """Write all tables to a ``.json``, or the frames to a ``.csv``.

    Raises:
        UsageError: an output of another kind.
        SaveError: it cannot be written.
    """
    frames = reference_frames_table(against)
    content: bytes
    if score_format(output) == "csv":
        content = csv_bytes(frames)
    else:
        entries: dict[str, Any] = {
            **field_terms(against.field),
            "size": list(against.size),
            "thresholds": list(against.thresholds),
            "answers": str(against.answers),
            "annotators": dict(zip(against.names, map(str, against.paths), strict=True)),
        }
        entries |= {
            sheet.name: table_entry(sheet) for sheet in (*reference_tables(against), frames)
        }
        content = json_bytes(entries)
    with open_replacing(output) as stream:
        stream.write(content)


def _figures(frame: ReferenceFrame, thresholds: Sequence[float]) -> tuple[float | None, ...]:
    ascending = np.sort(frame.agreement.distances)
    return (
        *(frame.agreement.jac(tau) for tau in thresholds),
        *(sorted_quantile(ascending, share) for share in (0.5, 0.95, 1.0)),
        len(frame.agreement.only_a), len(frame.agreement.only_b),
    )  # fmt: skip


def _time_text(frame: ReferenceFrame) -> str | None:
    if frame.time is None:
        return None
    return datetime.fromtimestamp(frame.time, UTC).isoformat(timespec="seconds")
