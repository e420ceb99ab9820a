"""A score table that grows from call to call, as CSV or Parquet."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from procc_annotator.batch.scoring import FrameResult
from procc_annotator.errors import InputError, UsageError
from procc_annotator.formats.atomic import exclusive_lock, write_atomic
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.regular_file import open_regular
from procc_annotator.report.scores.score_files import COLUMNS, KEYS, NAMES, ScoreRow, frame_values
from procc_annotator.report.tables.data_files import (
    csv_header,
    csv_rows,
    parquet_bytes,
    parquet_libraries,
    parquet_schema,
    value_of,
    writable,
)
from procc_annotator.report.tables.metrics import OF_ANNOTATION
from procc_annotator.report.tables.table import metric_values
from procc_annotator.version import __version__

_ADVICE = "choose another file, or move this one away"


def read_csv_rows(path: Path) -> list[ScoreRow]:
    """The rows of a table; none if there is no file.

    Raises:
        InputError: it cannot be read or is no such table.
    """
    try:
        with io.TextIOWrapper(open_regular(path), encoding="utf-8", newline="") as file:
            reader = csv.reader(file, strict=True)
            return _rows(path, reader)
    except FileNotFoundError:
        return []
    except OSError as error:
        raise InputError(path, f"cannot be read: {error.strerror or error}") from error
    except UnicodeDecodeError as error:
        raise InputError(path, "is not UTF-8 text", advice=_ADVICE) from error


def _rows(path: Path, reader: Any) -> list[ScoreRow]:
    rows: list[ScoreRow] = []
    try:
        header = next(reader, None) or []
        places = _places(path, header, "line 1")
        for cells in reader:
            if len(cells) != len(header):
                problem = f"has {len(cells)} cells, expected {len(header)}"
                raise _damaged(path, reader.line_num, problem)
            found = ("" if place is None else cells[place] for place in places)
            try:
                rows.append(tuple(map(value_of, COLUMNS, found)))
            except ValueError as error:
                raise _damaged(path, reader.line_num, str(error)) from error
    except csv.Error as error:
        raise _damaged(path, reader.line_num, f"is no CSV: {error}") from error
    return rows


def _places(path: Path, header: Sequence[str], line: str = "") -> list[int | None]:
    """Where the columns are; None for one that an earlier version did not have."""
    lacking = [c.key for c in COLUMNS if c.required and c.key not in header]
    strange = [name for name in header if name not in NAMES]
    if lacking or strange or len(set(header)) < len(header):
        problem = "is no table of scores, or one of another version: expected the columns"
        differs = f"; differs in {', '.join((lacking + strange)[:3])}" if lacking + strange else ""
        raise InputError(path, f"{problem} {', '.join(NAMES)}{differs}", place=line, advice=_ADVICE)
    at = {name: place for place, name in enumerate(header)}
    return [at.get(name) for name in NAMES]


def _damaged(path: Path, line: int, problem: str) -> InputError:
    return InputError(path, problem, place=f"line {line}", advice="mend the line, or remove it")


def read_parquet_rows(path: Path) -> list[ScoreRow]:
    """The rows of a table; none if there is no file.

    Raises:
        InputError: it cannot be read or is no such table.
        ProccError: pyarrow is not installed.
    """
    arrow, parquet = parquet_libraries()
    try:
        with open_regular(path) as file:
            data = file.read()
    except FileNotFoundError:
        return []
    except OSError as error:
        raise InputError(path, f"cannot be read: {error.strerror or error}") from error
    try:
        table = parquet.read_table(io.BytesIO(data))
    except (arrow.ArrowException, OSError) as error:
        problem = f"is no readable Parquet file: {error}"
        raise InputError(path, problem, advice=_ADVICE) from error
    places = _places(path, table.column_names)
    known = [column for column in COLUMNS if column.key in table.column_names]
    if not table.select([column.key for column in known]).schema.equals(parquet_schema(known)):
        raise InputError(path, "holds other types than a table of scores", advice=_ADVICE)
    nothing = [None] * table.num_rows
    columns = [nothing if place is None else table.column(place).to_pylist() for place in places]
    return list(zip(*columns, strict=True))


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
