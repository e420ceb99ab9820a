"""A table of scores that grows from call to call: a group's leaderboard, as CSV or Parquet.

One row a set, method, frame, threshold and way of evaluating; that is its key. Scoring the same
again replaces the row, every other row stays.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from procc_annotator.errors import UsageError
from procc_annotator.io.atomic import write_atomic
from procc_annotator.io.exclusive import exclusive_lock
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.report.scores.score_columns import COLUMNS, KEYS, ScoreRow, frame_values
from procc_annotator.report.scores.score_table_reading import read_csv_rows, read_parquet_rows
from procc_annotator.report.sheet.as_csv import csv_header, csv_rows
from procc_annotator.report.sheet.as_json import writable
from procc_annotator.report.sheet.as_parquet import parquet_bytes
from procc_annotator.report.sheet.figure import metric_values
from procc_annotator.report.sheet.figures import OF_ANNOTATION
from procc_annotator.session.runs.evaluation_run import FrameResult
from procc_annotator.version import __version__

Figures = tuple[Any, ...]  # what of a row depends on frame and threshold


def figures_of(result: FrameResult, thresholds: Sequence[float]) -> tuple[Figures, ...]:
    """A frame's part of its rows, one a threshold."""
    camera, error, name = _text(result.camera), _text(result.error), _text(result.name)
    model = result.model or None
    annotated = metric_values(OF_ANNOTATION, result.clicked)
    rows: list[Figures] = []
    for threshold in thresholds:
        score = result.scores.get(threshold)
        figures = [None if v != v else v for v in frame_values(score)]  # NaN is undefined
        said = error or "no camera" if score is None else error
        points = None if score is None else len(score.labelling.all_distances)
        scored = name, threshold, result.counted, model, *figures, points, camera, said
        rows.append((*scored, *result.fitted.values, *annotated))
    return tuple(rows)


def whole_rows(
    set_name: str, method: str, setup: EvaluationSetup, figures: Iterable[Figures]
) -> list[ScoreRow]:
    """Whole rows, from what `figures_of` made of frames of that set and method."""
    width, height = setup.size
    off_plane = "no part" if setup.planar_only else setup.off_plane
    terms = (
        setup.field.described, setup.protocol, width, height, off_plane, setup.considers_mirrored,
    )  # fmt: skip
    names = _text(set_name), _text(method)
    return [
        (*names, frame, threshold, *terms, *rest[:-4], __version__, *rest[-4:])
        for frame, threshold, *rest in figures
    ]


def check_table(path: Path) -> None:
    """Fail before the work, not after it.

    Raises:
        UsageError: neither .csv nor .parquet.
        ProccError: Parquet cannot be written here.
        InputError: there is something at the path that is no such table.
    """
    _format_of(path)[0](path)


def append_rows(path: Path, rows: Sequence[ScoreRow]) -> None:
    """Put rows into a table, which is made if there is none.

    Other processes that do the same wait; the table is replaced in one step.

    Raises:
        InputError: what is there is no such table; it is untouched.
        SaveError: it cannot be written, and is as it was.
    """
    read, encode = _format_of(path)
    with exclusive_lock(path):
        new = {row[:KEYS]: row for row in rows}
        merged = [new.pop(row[:KEYS], row) for row in read(path)]
        write_atomic(path, encode([*merged, *new.values()]))


Read = Callable[[Path], Sequence[ScoreRow]]
Encode = Callable[[Sequence[ScoreRow]], bytes]


def _format_of(path: Path) -> tuple[Read, Encode]:
    suffix = path.suffix.lower()
    if suffix == ".csv":
        return read_csv_rows, table_csv
    if suffix == ".parquet":
        return read_parquet_rows, partial(parquet_bytes, COLUMNS)
    raise UsageError(f"{path}: a table of scores is a .csv or .parquet file, end the name so")


def table_csv(rows: Sequence[ScoreRow]) -> bytes:
    """A whole table as CSV."""
    return csv_header(COLUMNS) + csv_rows(COLUMNS, rows)


def _text(text: str | None) -> str | None:
    return text if text is None or text.isascii() else writable(text)
