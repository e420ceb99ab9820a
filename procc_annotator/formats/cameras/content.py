"""Decode files of cameras, of any kind, to lists, objects, numbers, tables and XML elements."""

from __future__ import annotations

import re
import tomllib
from typing import Any, NamedTuple

from procc_annotator.errors import CameraError, InputError
from procc_annotator.formats.cameras.arrays import array_content, is_array_file
from procc_annotator.formats.cameras.packed import is_packed, read_packed
from procc_annotator.formats.csv_tables import read_table
from procc_annotator.formats.strict_json import (
    decode_fast,
    finite_number,
    printable,
    strip_bom,
    utf8_text,
)
from procc_annotator.formats.xml_text import parse_xml

ARRAY_SUFFIXES = (".npz", ".mat")
TABLE_SUFFIXES = (".csv", ".dlt2d", ".dlt3d")
TOML_SUFFIX = ".toml"
_LINES = (".jsonl", ".ndjson")
_KITTI = re.compile(rb"\s*[A-Za-z]\w*:\s*[-+0-9.]")
_PROJECTION = re.compile(r"P(_?rect)?_?[0-9]+")


class Table(NamedTuple):
    """A CSV file: columns, and line number and cells of each row."""

    columns: list[str]
    rows: list[tuple[int, dict[str, str]]]


def decoded_content(data: bytes, path: str) -> Any:
    """The content of a file, by its first bytes and its suffix.

    Returns:
        `PackedCameras`, arrays of ``.npz`` and MATLAB files by name, JSON, JSON lines as a list,
        TOML, a `Table` of CSV, the root of XML, KITTI's matrices by name.

    Raises:
        CameraError: damaged.
    """
    suffix = path.lower()
    if is_packed(data):
        return read_packed(data, path)
    if is_array_file(data) or suffix.endswith(ARRAY_SUFFIXES):
        return array_content(data, path)
    if suffix.endswith(TOML_SUFFIX):
        return _toml(data, path)
    if suffix.endswith(TABLE_SUFFIXES):
        return _table(data, path)
    if is_xml(data):
        return parse_xml(data, path, CameraError, "write it again")
    if is_kitti(data):
        return _kitti(data, path)
    if suffix.endswith(_LINES):
        lines = [(n, x) for n, x in enumerate(data.split(b"\n"), 1) if x.strip()]
        return [decode_fast(x, path=f"{path}: line {n}", error=CameraError) for n, x in lines]
    return decode_fast(data, path=path, error=CameraError)


def is_xml(data: bytes) -> bool:
    """Return whether bytes are XML, of any program."""
    return strip_bom(data[:4096]).lstrip().startswith(b"<")


def is_kitti(data: bytes) -> bool:
    """Return whether text is a calibration of KITTI: ``P0: 7.2e+02 0.0 ...`` on its lines."""
    return bool(_KITTI.match(strip_bom(data[:4096])))


def _kitti(data: bytes, path: str) -> dict[str, Any]:
    """Projection matrices by their names; other lines are left out."""
    lines = (line.partition(":") for line in utf8_text(data, path).splitlines())
    found = {n.strip(): [finite_number(word) for word in rest.split()] for n, _, rest in lines}
    named = {name: v for name, v in found.items() if _PROJECTION.fullmatch(name)}
    return {name: [v[i : i + 4] for i in (0, 4, 8)] for name, v in named.items()}


def _toml(data: bytes, path: str) -> Any:
    try:
        return tomllib.loads(utf8_text(data, path))
    except (ValueError, RecursionError) as error:  # tomllib's own error is a ValueError
        why = printable(str(error), 120)
        raise CameraError(path, f"is no TOML: {why}", advice="correct it") from error


def _table(data: bytes, path: str) -> Table:
    try:
        return Table(*read_table(path, (), "a header and a row for each frame", data))
    except InputError as error:
        raise CameraError(
            error.path, error.problem, place=error.place, advice=error.advice
        ) from error
