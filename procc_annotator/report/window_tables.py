"""Tables exported by the window: set overview, triage verdicts, plot data."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.audit import PlotData
from procc_annotator.batch.triage import JudgedVerdict
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.records import Origin, PointKey, count_points_by_origin
from procc_annotator.dataset.review import BlindStatus, blind_status, setting_of
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError
from procc_annotator.field.model import Field
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.tables.data_files import CRLF, csv_bytes
from procc_annotator.report.tables.table import Column, MetricTable, Value

TABLE_COLUMNS = (
    "name", "status", "elements", "points", "seconds", "comments", "open_comments", "jac", "blind",
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class OverviewRow:
    """Figures of one frame.

    Attributes:
        classes: class -> number of points; a class without points counts as absent.
        seconds: time a person worked on the frame.
        jac: None when the frame has no score.
        origins: origin -> number of points that came from there.
        blind: what may be said of its clicks (`dataset.review.BlindWork`).
    """

    name: str
    status: str
    classes: Mapping[str, int]
    seconds: float
    comments: int
    open_comments: int
    jac: float | None
    origins: Mapping[str, int]
    blind: str = ""

    @property
    def elements(self) -> int:
        """Return how many classes have points."""
        return sum(points > 0 for points in self.classes.values())

    @property
    def points(self) -> int:
        """Points of all classes."""
        return sum(self.classes.values())


def overview_rows(
    workspace: Workspace,
    database: WorkspaceDatabase | None,
    scores: Mapping[str, float],
    progress: Callable[[int, int], None],
) -> list[OverviewRow]:
    """Return one row per frame, with its JaC of ``scores`` by frame name.

    Unreadable annotations count as not annotated. ``progress`` receives the
    number of finished frames and of all frames; it may raise to stop.

    Raises:
        InputError: the database cannot be read completely.
    """
    rows: list[OverviewRow] = []
    for index, frame in enumerate(workspace.frames):
        progress(index, len(workspace.frames))
        work = BlindStatus.UNKNOWN
        try:
            annotation = workspace.read(index)
        except InputError:  # reported when that frame is opened
            annotation = FrameAnnotation()
        else:
            if database is not None:
                work = blind_status(database.setting(setting_of(frame.name)), annotation)
        classes = {p.class_name: len(p.points) for p in annotation.polylines if p.points}
        origins: Mapping[PointKey, Origin] = {}
        if database is not None and classes:
            origins = database.read_origins(frame.name)
        record = database.record(frame.name) if database is not None else None
        rows.append(
            OverviewRow(
                name=frame.name,
                status=record.status.value if record is not None else "untouched",
                classes=classes,
                seconds=record.seconds if record is not None else 0.0,
                comments=record.comments if record is not None else 0,
                open_comments=record.open_comments if record is not None else 0,
                jac=scores.get(frame.name),
                origins={
                    k.value: n for k, n in count_points_by_origin(annotation, origins).items()
                },
                blind=work.value,
            )
        )
    return rows


def overview_csv(rows: Iterable[OverviewRow]) -> bytes:
    """One row a frame: `TABLE_COLUMNS`, points by origin (``points_<origin>``), points by class.

    RFC 4180 with its CRLF line ends. Figures that are undefined are empty.
    """
    rows = list(rows)
    origins = sorted({origin for row in rows for origin in row.origins})
    classes = sorted({name for row in rows for name in row.classes})
    head = [*TABLE_COLUMNS, *(f"points_{origin.replace(' ', '_')}" for origin in origins)]
    # a file may hold a class that is called like one of our columns
    head += [f"{name} (class)" if name in head else name for name in classes]
    columns = tuple(_column(key) for key in head)
    values = tuple(
        (
            row.name, row.status, row.elements, row.points, row.seconds, row.comments,
            row.open_comments, row.jac, row.blind,
            *(row.origins.get(origin, 0) for origin in origins),
            *(row.classes.get(name, 0) for name in classes),
        )
        for row in rows
    )  # fmt: skip
    return csv_bytes(MetricTable("overview", "Overview", columns, values), line_end=CRLF)


def _column(key: str) -> Column:
    if key in ("name", "status", "blind"):
        return Column(key)
    return Column(key, kind="number", written=".1f" if key == "seconds" else "")


def verdicts_csv(
    rows: Iterable[JudgedVerdict], field: Field, setup: EvaluationSetup, tau: float
) -> bytes:
    """One row a verdict, with the figures at tau and the terms they were computed on.

    RFC 4180 with its CRLF line ends. Figures that are undefined are empty; ``problem`` says why.
    Times are UTC.
    """
    columns = (
        Column("frame"), Column("source"), Column("verdict"), _figure(f"jac@{tau:g}px"),
        _figure("largest_error_px"), Column("worst_element"), Column("author"), Column("time"),
        Column("comment"), Column("problem"), Column("terms"),
    )  # fmt: skip
    terms = setup.describe()
    values = tuple(
        (
            row.verdict.frame, row.verdict.source, row.verdict.fault.value, row.jac, row.largest_px,
            field.title_of(row.worst_element) if row.worst_element else None, row.verdict.author,
            _utc(row.verdict.time), row.verdict.comment, row.problem, terms,
        )
        for row in rows
    )  # fmt: skip
    return csv_bytes(MetricTable("verdicts", "Verdicts", columns, values), line_end=CRLF)


def _figure(key: str) -> Column:
    return Column(key, kind="number", written=".6g")


def _utc(seconds: float) -> str:
    try:
        return f"{datetime.fromtimestamp(seconds, UTC):%Y-%m-%dT%H:%M:%SZ}"
    except (OverflowError, ValueError, OSError):  # a clock that nobody has
        return ""


_DIGITS = ".6g"


def plot_table(table: PlotData) -> MetricTable:
    """The sheet of a plot's numbers: undefined ones are None, the others have six digits."""
    columns = tuple(map(_plot_column, table.header, table.columns))
    return MetricTable("plot", "", columns, tuple(zip(*map(_values, table.columns), strict=True)))


def _plot_column(key: str, values: Sequence[Any] | NDArray[Any]) -> Column:
    if isinstance(values, np.ndarray) and np.issubdtype(values.dtype, np.floating):
        return Column(key, kind="number")
    first = next(iter(values), None)
    return Column(key, kind="text" if isinstance(first, str) else "whole")


def _values(column: Sequence[Any] | NDArray[Any]) -> list[Value]:
    values = column.tolist() if isinstance(column, np.ndarray) else list(column)
    return [_rounded(v) if isinstance(v, float) else v for v in values]


def _rounded(value: float) -> float | None:
    return None if math.isnan(value) else float(f"{value:{_DIGITS}}")
