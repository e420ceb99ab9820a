"""How far annotators are from gold frames: tables for the terminal, JSON and CSV for the rest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from procc_annotator.field.model import Field
from procc_annotator.io.atomic import replacing
from procc_annotator.metric.agreement import quantile
from procc_annotator.report.agreement_figures import sure_columns, sure_values
from procc_annotator.report.field_terms import field_terms
from procc_annotator.report.scores.score_files import score_format
from procc_annotator.report.sheet.as_csv import csv_bytes
from procc_annotator.report.sheet.as_json import json_bytes, sheet_entry
from procc_annotator.report.sheet.figure import values_of
from procc_annotator.report.sheet.figures import (
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
from procc_annotator.report.sheet.sheet import TAU, Column, Row, Sheet, of, whole
from procc_annotator.session.runs.gold_run import THIRDS, GoldErrors, GoldFrame
from procc_annotator.words import count_of

_COUNTS = (COMMON, APART, ADDED, MISSED, LEFT_OUT)
_TEN = 10


@dataclass(frozen=True)
class AgainstGold:
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
    found: tuple[GoldErrors | None, ...]
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
    def there(self) -> list[tuple[str, GoldErrors]]:
        """The annotators with gold frames."""
        pairs = zip(self.names, self.found, strict=True)
        return [(name, found) for name, found in pairs if found is not None]


def gold_sheets(against: AgainstGold) -> tuple[Sheet, ...]:
    """All tables, in the order they are read; none over time where nobody's order is known."""
    timed = any(found.timed for _, found in against.there)
    return (errors_sheet(against), *((over_time_sheet(against),) if timed else ()))


def errors_sheet(against: AgainstGold) -> Sheet:
    """Each annotator over all gold frames."""
    columns = (
        Column("annotator", "annotator"), TAU, whole("frames"),
        *sure_columns(),
        of(LARGEST_PX), *(whole(figure.key, figure.title) for figure in _COUNTS),
    )  # fmt: skip
    rows = [
        (name, tau, len(found.frames), *sure_values(found.sure, tau),
         found.sure.summary.overall.largest,
         *values_of(_COUNTS, found.sure.summary.overall))
        for name, found in against.there
        for tau in against.thresholds
    ]  # fmt: skip
    notes = [f"Gold: {count_of(against.gold, 'frame')}. In brackets {against.known}."]
    if not any(found.timed for _, found in against.there):
        notes.append("Nothing tells when points were put: errors have no order of work.")
    title = "Each annotator against gold"
    return Sheet("gold", title, columns, tuple(rows), against.described, tuple(notes))


def over_time_sheet(against: AgainstGold) -> Sheet:
    """The thirds of each annotator's gold frames in the order of work, and the trend."""
    tau = against.thresholds[0]
    columns: list[Column] = [Column("annotator", "annotator")]
    for third in THIRDS:
        columns += [
            of(MEDIAN_PX, key=f"{third}_median", group=f"{third} third"),
            of(JAC, f" @{tau:g}", key=f"{third}_jac", group=f"{third} third"),
        ]
    columns += [of(TREND), of(TREND_P)]
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
    return Sheet("over_time", title, tuple(columns), tuple(rows), against.described, tuple(notes))


def gold_frames_sheet(against: AgainstGold) -> Sheet:
    """One row a gold frame and annotator, in the order of work."""
    jacs = tuple(
        Column(f"jac_{tau:g}", f"JaC @{tau:g}", "number", JAC) for tau in against.thresholds
    )
    columns = (
        Column("annotator", "annotator"), whole("place"), Column("frame", "frame"),
        Column("time", "time"), *jacs, of(MEDIAN_PX), of(P95_PX), of(LARGEST_PX),
        whole("added"), whole("missed"),
    )  # fmt: skip
    rows = [
        (name, place, frame.name, _time_text(frame), *_figures(frame, against.thresholds))
        for name, found in against.there
        for place, frame in enumerate(found.frames, 1)
    ]
    return Sheet("frames", "Gold frames", columns, tuple(rows), against.described)


def write_gold(against: AgainstGold, output: Path) -> None:
    """Write all tables to a ``.json``, or the frames to a ``.csv``.

    Raises:
        UsageError: an output of another kind.
        SaveError: it cannot be written.
    """
    frames = gold_frames_sheet(against)
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
        entries |= {sheet.name: sheet_entry(sheet) for sheet in (*gold_sheets(against), frames)}
        content = json_bytes(entries)
    with replacing(output) as stream:
        stream.write(content)


def _figures(frame: GoldFrame, thresholds: Sequence[float]) -> tuple[float | None, ...]:
    ascending = np.sort(frame.agreement.distances)
    return (
        *(frame.agreement.jac(tau) for tau in thresholds),
        *(quantile(ascending, share) for share in (0.5, 0.95, 1.0)),
        len(frame.agreement.only_a), len(frame.agreement.only_b),
    )  # fmt: skip


def _time_text(frame: GoldFrame) -> str | None:
    if frame.time is None:
        return None
    return datetime.fromtimestamp(frame.time, UTC).isoformat(timespec="seconds")
