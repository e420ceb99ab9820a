"""Scores as CSV: one row an image and threshold."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import IO, Any

from procc_annotator.metric.sets import SetSummary
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.report.scores.score_columns import FITTED_COLUMNS, FRAME_COLUMNS, frame_values
from procc_annotator.report.sheet.as_csv import csv_header, csv_rows
from procc_annotator.report.sheet.figure import metric_values
from procc_annotator.report.sheet.figures import OF_ANNOTATION
from procc_annotator.report.sheet.sheet import TAU, Column, Row, metric_column, count_column
from procc_annotator.session.runs.evaluation_run import FrameResult, GroupSummary

_COLUMNS = (
    Column("name"), Column("protocol"), Column("options"), count_column("width"), count_column("height"), TAU,
    *FRAME_COLUMNS, Column("camera"), Column("error"), *FITTED_COLUMNS, Column("model"),
    *map(metric_column, OF_ANNOTATION),
)  # fmt: skip


def csv_columns(names: Iterable[str] = (), by: Iterable[str] = ()) -> tuple[Column, ...]:
    """The columns of a file of scores.

    Args:
        names: columns that come first, e.g. set and method.
        by: what the set is grouped by; columns that come last.
    """
    return (*map(Column, names), *_COLUMNS, *(Column(f"by_{name}") for name in by))


def csv_fragment(
    result: FrameResult,
    setup: EvaluationSetup,
    thresholds: tuple[float, ...],
    names: Sequence[str] = (),
) -> bytes:
    """One row a threshold; figures of a frame without scores are empty.

    Args:
        names: of set and method, where several evaluations share a file; they come first.
    """
    columns = csv_columns(names, map(str, range(len(result.groups))))
    return csv_rows(
        columns, ((*names, *_row(result, setup, tau), *result.groups) for tau in thresholds)
    )


def _row(result: FrameResult, setup: EvaluationSetup, threshold: float) -> Row:
    chosen = [f"off-plane {setup.off_plane}"] if result.ground_only else []
    if setup.planar_only:
        chosen = ["planar elements only"]
    if setup.protocol == "procc" and setup.allow_mirrored:
        chosen.append("mirrored labels allowed")
    score = result.scores.get(threshold)
    camera, error = result.camera, result.error
    if score is None:
        camera, error = None, error or "no camera"
    terms = (setup.protocol, "; ".join(chosen), *setup.size)
    more = (*result.fitted.values, result.model or None, *metric_values(OF_ANNOTATION, result.clicked))
    return (result.name, *terms, threshold, *frame_values(score), camera, error, *more)


class CsvScores:
    """A header, then one row an image and threshold.

    Args:
        names, by: as of `csv_columns`.
        headless: without the header, after another evaluation.
    """

    def __init__(
        self,
        stream: IO[bytes],
        names: Iterable[str] = (),
        by: Iterable[str] = (),
        *,
        headless: bool = False,
    ) -> None:
        self._stream = stream
        self._header = b"" if headless else csv_header(csv_columns(names, by))

    def begin(self) -> None:
        self._stream.write(self._header)

    def add(self, fragment: bytes) -> None:
        self._stream.write(fragment)

    def end(
        self,
        summary: Mapping[float, SetSummary] | None,
        *,
        ground_only: bool,
        groups: Sequence[GroupSummary] = (),
        more: Mapping[str, Any] | None = None,
    ) -> None:
        """Nothing: a set's figures have no row of their own."""
