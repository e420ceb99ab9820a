"""Tables of points and boxes by frame: CSV, MOT, JSON and Parquet, read and written."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.errors import InputError, UsageError
from procc_annotator.formats.csv_tables import csv_cells, encode_rows, escape_formula, read_table
from procc_annotator.formats.file_source import read_file
from procc_annotator.formats.frame_names import PICTURE_SUFFIX
from procc_annotator.formats.strict_json import decode_fast, json_repr

SUFFIXES = (".csv", ".txt", ".json", ".parquet")
_FRAMES = ("frame", "frame_id", "frame_number", "frame_name", "file_name", "image", "image_id")
_MOT = ("frame", "id", "left", "top", "width", "height", "conf", "col8", "col9", "col10")
# Columns, and what their numbers are multiplied by for a place: of a box by its corner and size, or
# by two corners, the middle of the lower edge.
_POINT = np.eye(2)
_SIZED = np.array([(1, 0, 0.5, 0), (0, 1, 0, 1)])
_CORNERS = np.array([(0.5, 0, 0.5, 0), (0, 0, 0, 1)])
_BOXES: tuple[tuple[str, FloatArray], ...] = (
    ("bbox", _SIZED), ("bbox_xyxy", _CORNERS), ("left top width height", _SIZED),
    ("bb_left bb_top bb_width bb_height", _SIZED), ("x1 y1 x2 y2", _CORNERS),
    ("xmin ymin xmax ymax", _CORNERS), ("left top right bottom", _CORNERS),
    ("x y w h", _SIZED), ("x y width height", _SIZED),
)  # fmt: skip
_PIXELS = (*_BOXES, ("x y", _POINT), ("x_px y_px", _POINT), ("u v", _POINT))
_METRES = (("X Y", _POINT), ("x_m y_m", _POINT), ("x y", _POINT))
_EXPECTED = "expected frame and {} (docs/reference/files.md)"
# Decimals as most of Europe writes them; with three digits they may be thousands.
_COMMA, _THOUSANDS = re.compile(r"-?\d+,\d+", re.ASCII), re.compile(r"-?\d{1,3},\d{3}", re.ASCII)
Row = dict[str, Any]


@dataclass(frozen=True, eq=False)
class PointTable:
    """Rows as they were read; the (N,) frame and (N, 2) place of each, px or metres, NaN for empty
    cells; and the columns that places were taken from."""

    rows: Sequence[Row]
    frames: tuple[str, ...]
    places: FloatArray
    columns: tuple[str, ...]
    size: tuple[int, int] | None = None  # of the pictures, px, if the file states one for all

    @classmethod
    def read(cls, path: Path, *, metres: bool = False) -> PointTable:
        """Read a file; see `read_rows` and `of`."""
        rows, size = read_rows(path)
        return replace(cls.of(rows, path, metres=metres), size=size)

    @classmethod
    def of(cls, rows: Sequence[Row], path: str | Path, *, metres: bool = False) -> PointTable:
        """Find frames and places in rows, in px or on the ground; path: for messages.

        Raises:
            InputError: no such columns, or a cell that is no number; names the row.
        """
        names = dict.fromkeys(name for row in rows for name in row)
        frame = next((name for name in _FRAMES if name in names), None)
        kinds = _METRES if metres else _PIXELS
        found = next(((s.split(), m) for s, m in kinds if names.keys() >= set(s.split())), None)
        if frame is None or found is None:
            has = f"has the columns {', '.join(map(str, names))}" if names else "has no row"
            where = "X, Y" if metres else "x, y or a box (x, y, w, h; x1, y1, x2, y2; bbox)"
            raise InputError(path, has, advice=_EXPECTED.format(where))
        columns, matrix = found
        places = _numbers(rows, columns, matrix, path) @ matrix.T
        return cls(rows, tuple(_frame_name(r.get(frame)) for r in rows), places, tuple(columns))


def _numbers(
    rows: Sequence[Row], columns: Sequence[str], matrix: FloatArray, path: str | Path
) -> FloatArray:
    """(N, n) numbers of columns, NaN for empty cells; InputError: see `PointTable.of`."""
    values = np.full((len(rows), matrix.shape[1]), np.nan)
    for n, row in enumerate(rows):
        given = [row.get(name) for name in columns]
        try:
            if len(columns) == 1:  # a list, or its text in a cell
                box = json.loads(given[0]) if isinstance(given[0], str) else given[0]
                given = box or [None] * 4
            values[n] = [np.nan if v in (None, "") else float(v) for v in given]
        except (TypeError, ValueError):
            problem = f"expected numbers under {', '.join(columns)}, found {json_repr(given)}"
            advice = "decimals have a point, lists are [x, y, w, h]"
            raise InputError(path, problem, place=f"row {n + 1}", advice=advice) from None
    values[~np.isfinite(values)] = np.nan
    return values


def move_boxes(rows: Sequence[Row], digits: int) -> None:
    """Move the boxes of rows so that `PointTable.of` finds the points ``x``, ``y`` again; empty
    cells for rows without a point. Boxes ``x, y, w, h`` move if there are no others."""
    names, moved = {name for row in rows for name in row}, set[str]()
    points = _numbers(rows, ("x", "y"), _POINT, "points")
    for columns, matrix in ((spelling.split(), matrix) for spelling, matrix in _BOXES):
        if not names >= set(columns) or moved & set(columns):
            continue
        moved |= {*columns, "x", "y"}
        values = _numbers(rows, columns, matrix, "points")
        steps = points - values @ matrix.T
        values += np.hstack((steps, steps if matrix is _CORNERS else np.zeros_like(steps)))
        for row, box in zip(rows, values.round(digits).tolist(), strict=True):
            cells = [value if value == value else None for value in box]
            row.update(zip(columns, [cells] if len(columns) == 1 else cells, strict=True))


def _frame_name(value: object) -> str:
    whole = int(value) if isinstance(value, float) and value.is_integer() else value
    return "" if whole is None else PICTURE_SUFFIX.sub("", str(whole).strip())


def read_rows(path: Path) -> tuple[list[Row], tuple[int, int] | None]:
    """The rows of a file, by its suffix; a CSV file without a header is one of MOT. And the size,
    (width, height) px, that all images of a COCO file state; else None.

    Raises:
        UsageError: another suffix, or Parquet without pyarrow.
        InputError: it cannot be read, or is no table.
    """
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise UsageError(f"{path}: expected a name that ends in {', '.join(SUFFIXES)}")
    advice = _EXPECTED.format("x, y or a box")
    if suffix == ".parquet":
        try:
            return list(_parquet().read_table(BytesIO(read_file(path))).to_pylist()), None
        except (OSError, ValueError) as error:  # of which the library's own errors are
            raise InputError(path, f"is no Parquet file: {error}", advice=advice) from error
    if suffix == ".json":
        content = decode_fast(read_file(path), path=str(path), error=InputError)
        files: dict[object, object] = {}
        sizes: set[tuple[object, object]] = set()
        if isinstance(content, dict):  # its longest list; COCO names pictures in another one
            for image in content.pop("images", []):
                files[image.get("id")] = image.get("file_name")
                sizes.add((image.get("width"), image.get("height")))
            content = max((v for v in content.values() if type(v) is list), key=len, default=None)
        if not isinstance(content, list) or not all(isinstance(row, dict) for row in content):
            raise InputError(path, "holds no list of objects", advice=advice)
        if files:
            content = [{**row, "frame": files[row.get("image_id")]} for row in content]
        match list(sizes):
            case [(int(width), int(height))]:
                return content, (width, height)
        return content, None
    data = read_file(path)
    if not re.search(rb"[,;\t]", data.lstrip().partition(b"\n")[0]):  # separated by blanks
        data = b"\n".join(b",".join(line.split()) for line in data.splitlines())
    cells = [row for _, row in csv_cells(path, data)]
    if cells and len(cells[0]) > 5 and all(map(is_number, cells[0])):
        return [dict(zip(_MOT, map(str.strip, row), strict=False)) for row in cells], None
    rows = [row for _, row in read_table(path, (), advice, data)[1]]
    commas = {cell for row in rows for cell in row.values() if _COMMA.fullmatch(cell)}
    if all(map(_THOUSANDS.fullmatch, commas)):  # either may be meant, or there is none
        return rows, None
    decimal = [{k: v.replace(",", ".") if v in commas else v for k, v in r.items()} for r in rows]
    return decimal, None


def is_number(text: str) -> bool:
    """Return whether a text spells a number."""
    try:
        float(text)
    except ValueError:
        return False
    return True


def encode_table(rows: Sequence[Row], suffix: str) -> bytes:
    """The content of a file of rows; None is an empty cell.

    Raises:
        UsageError: Parquet without pyarrow.
    """
    typed = [{name: _number(value) for name, value in row.items()} for row in rows]
    if suffix == ".json":
        return (json.dumps(typed, ensure_ascii=False, indent=1) + "\n").encode()
    if suffix == ".parquet":
        buffer, parquet = BytesIO(), _parquet()
        parquet.write_table(import_module("pyarrow").Table.from_pylist(typed), buffer)
        return buffer.getvalue()
    names = list(dict.fromkeys(name for row in rows for name in row))
    cells = ([_written(row.get(name)) for name in names] for row in rows)
    return encode_rows([list(map(escape_formula, names)), *cells])


def _number(value: Any) -> Any:
    """The number that a cell of text spells; others, such as 0012, stay as they are."""
    if not isinstance(value, str) or not re.fullmatch(r"-?(0|[1-9]\d{0,14})(\.\d+)?", value):
        return None if value == "" else value
    return float(value) if "." in value else int(value)


def _written(value: Any) -> Any:
    if value is None or value != value:
        return ""
    if isinstance(value, bool | list | dict):
        return json.dumps(value)
    return value if not isinstance(value, str) or is_number(value) else escape_formula(value)


def _parquet() -> Any:
    try:
        return import_module("pyarrow.parquet")
    except ImportError:
        raise UsageError(
            "Parquet needs pyarrow (pip install pyarrow): install it, or use CSV"
        ) from None
