"""Tables exported by the window: set overview, triage verdicts, plot data."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import pairwise
from statistics import median
from typing import Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.batch.audit import PlotData
from procc_annotator.batch.triage import JudgedVerdict
from procc_annotator.dataset.filter_query import STATUSES
from procc_annotator.field.model import Field
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.tables.data_files import CRLF, csv_bytes
from procc_annotator.report.tables.table import Column, MetricTable, Value

FINISHED = frozenset({"done", "approved"})
TABLE_COLUMNS = (
    "name", "status", "elements", "points", "seconds", "comments", "open_comments", "jac", "blind",
)  # fmt: skip
# Seconds; a bar of the histogram of times is one of these wide.
_STEPS = (1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600)
_BARS = 20


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


@dataclass(frozen=True, slots=True)
class Times:
    """Time of the frames a person worked on (more than 0 s), in seconds; median None if none."""

    frames: int
    total: float
    median: float | None


@dataclass(frozen=True, slots=True)
class StatusFigures:
    """The frames of one status; ``share`` of all frames, 0 to 1."""

    status: str
    frames: int
    share: float
    times: Times


@dataclass(frozen=True, slots=True)
class ClassFigures:
    """One class in the set: frames in which it is annotated and the points there."""

    name: str
    title: str
    frames: int
    points: int


@dataclass(frozen=True, slots=True)
class TimeHistogram:
    """Histogram of times a frame: bar i counts times in (i step, (i + 1) step], in seconds.

    The last bar also counts what took longer, if ``open_ended``: a frame left open over lunch would
    squeeze all others into one bar.
    """

    step: int
    counts: tuple[int, ...]
    open_ended: bool


@dataclass(frozen=True, slots=True)
class SetOverview:
    """The figures of a set.

    Attributes:
        progress: share of frames that are done or approved; None without frames.
        statuses: every status in its order, also those without frames; unknown ones at the end.
        classes: every element of the field in its order, then other classes that occur.
        elements_per_frame: entry n counts the frames with n annotated elements.
        median_jac: of the ``scored`` frames that have a score; None without any.
        frames_with_open_comments: frames with at least one.
        origins: (origin, points), most points first.
    """

    frames: int
    progress: float | None
    statuses: tuple[StatusFigures, ...]
    classes: tuple[ClassFigures, ...]
    points: int
    elements_per_frame: tuple[int, ...]
    median_elements: float | None
    times: Times
    time_histogram: TimeHistogram
    scored: int
    median_jac: float | None
    comments: int
    open_comments: int
    frames_with_open_comments: int
    origins: tuple[tuple[str, int], ...]


def summarise(rows: Iterable[OverviewRow], field: Field) -> SetOverview:
    """The overview of a set; classes are named and ordered by the field."""
    rows = list(rows)
    elements = [row.elements for row in rows]
    counted = Counter(elements)
    jacs = [row.jac for row in rows if row.jac is not None]
    origins: Counter[str] = Counter()
    for row in rows:
        origins.update(row.origins)
    statuses = _statuses(rows)
    finished = sum(s.frames for s in statuses if s.status in FINISHED)
    return SetOverview(
        frames=len(rows),
        progress=finished / len(rows) if rows else None,
        statuses=statuses,
        classes=_classes(rows, field),
        points=sum(row.points for row in rows),
        elements_per_frame=tuple(counted[n] for n in range(max(elements) + 1)) if rows else (),
        median_elements=median(elements) if rows else None,
        times=_times(rows),
        time_histogram=_time_histogram(sorted(row.seconds for row in rows if row.seconds > 0)),
        scored=len(jacs),
        median_jac=median(jacs) if jacs else None,
        comments=sum(row.comments for row in rows),
        open_comments=sum(row.open_comments for row in rows),
        frames_with_open_comments=sum(row.open_comments > 0 for row in rows),
        origins=tuple(sorted(origins.items(), key=lambda item: (-item[1], item[0]))),
    )


def _statuses(rows: list[OverviewRow]) -> tuple[StatusFigures, ...]:
    by_status: dict[str, list[OverviewRow]] = {status: [] for status in STATUSES}
    for row in rows:
        by_status.setdefault(row.status.replace("_", " "), []).append(row)
    return tuple(
        StatusFigures(status, len(those), len(those) / len(rows) if rows else 0.0, _times(those))
        for status, those in by_status.items()
    )


def _classes(rows: list[OverviewRow], field: Field) -> tuple[ClassFigures, ...]:
    frames: Counter[str] = Counter()
    points: Counter[str] = Counter()
    for row in rows:
        for name, count in row.classes.items():
            if count > 0:
                name = field.canonical_name(name)
                frames[name] += 1
                points[name] += count
    others = sorted(frames.keys() - field.index.keys())
    titles = {e.name: e.title for e in field.elements}
    return tuple(
        ClassFigures(name, titles.get(name, name), frames[name], points[name])
        for name in (*titles, *others)
    )


def _times(rows: list[OverviewRow]) -> Times:
    seconds = [row.seconds for row in rows if row.seconds > 0]
    return Times(len(seconds), sum(seconds), median(seconds) if seconds else None)


def _time_histogram(seconds: list[float]) -> TimeHistogram:
    """Bars for sorted times; all but the longest twentieth decide how wide they are."""
    if not seconds:
        return TimeHistogram(_STEPS[0], (), False)
    usual = seconds[-(-19 * len(seconds) // 20) - 1]
    step = next((s for s in _STEPS if usual <= s * _BARS), _STEPS[-1])
    bars = max(1, min(_BARS, int(-(-seconds[-1] // step))))
    upto = [bisect_right(seconds, i * step) for i in range(bars)] + [len(seconds)]
    counts = tuple(b - a for a, b in pairwise(upto))
    return TimeHistogram(step, counts, seconds[-1] > bars * step)


# -------------------------------------------------------------------------------- table


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
