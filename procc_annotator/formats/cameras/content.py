"""Decode files of cameras, of any kind, to lists, objects, numbers, tables and XML elements."""

from __future__ import annotations

import csv
import io
import re
import tomllib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.arrays import array_content, is_array_file
from procc_annotator.formats.strict_json import (
    decode_fast,
    finite_number,
    printable,
    strip_bom,
    utf8_text,
)

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

ARRAY_SUFFIXES = (".npz", ".mat")
TABLE_SUFFIXES = (".csv", ".dlt2d", ".dlt3d")
TOML_SUFFIX = ".toml"
_LINES = (".jsonl", ".ndjson")
_KITTI = re.compile(rb"\s*[A-Za-z]\w*:\s*[-+0-9.]")
_PROJECTION = re.compile(r"P(_?rect)?_?[0-9]+")


@dataclass(frozen=True)
class Table:
    """A CSV file: columns, and line number and cells of each row."""

    columns: tuple[str, ...]
    rows: tuple[tuple[int, dict[str, str]], ...]


def decoded_content(data: bytes, path: str) -> Any:
    """The content of a file, by its first bytes and its suffix.

    Args:
        data: the file. path: for messages.

    Returns:
        Arrays of ``.npz`` and MATLAB files by name, JSON, JSON lines as a list, TOML, a `Table` of
        CSV, the root of XML, KITTI's matrices by name.

    Raises:
        CameraError: damaged.
    """
    suffix = path.lower()
    if is_array_file(data) or suffix.endswith(ARRAY_SUFFIXES):
        return array_content(data, path)
    if suffix.endswith(TOML_SUFFIX):
        return _toml(data, path)
    if suffix.endswith(TABLE_SUFFIXES):
        return _table(data, path)
    if is_xml(data):
        return _xml(data, path)
    if is_kitti(data):
        return _kitti(data, path)
    if suffix.endswith(_LINES):
        lines = enumerate(data.split(b"\n"), 1)
        return [decode_fast(x, path=f"{path}: line {n}", error=CameraError) for n, x in lines if x]
    return decode_fast(data, path=path, error=CameraError)


def is_xml(data: bytes) -> bool:
    """Return whether bytes are XML, of any program."""
    return strip_bom(data[:4096]).lstrip().startswith(b"<")


def is_kitti(data: bytes) -> bool:
    """Return whether text is a calibration of KITTI: ``P0: 7.2e+02 0.0 ...`` on its lines."""
    return bool(_KITTI.match(data[:4096]))


def _kitti(data: bytes, path: str) -> dict[str, Any]:
    """Projection matrices by their names; other lines are left out."""
    found: dict[str, Any] = {}
    for number, line in enumerate(utf8_text(data, path).splitlines(), 1):
        name, _, rest = line.partition(":")
        if not _PROJECTION.fullmatch(name.strip()):
            continue
        numbers = [finite_number(word) for word in rest.split()]
        if len(numbers) != 12 or None in numbers:
            raise CameraError(path, "expected 12 finite numbers", place=f"line {number}")
        found[name.strip()] = [numbers[i : i + 4] for i in (0, 4, 8)]
    if not found:
        raise CameraError(path, "holds no projection matrix, expected lines like P0: 12 numbers")
    return found


def _toml(data: bytes, path: str) -> Any:
    try:
        return tomllib.loads(utf8_text(data, path))
    except (ValueError, RecursionError) as error:  # tomllib's own error is a ValueError
        why = printable(str(error), 120)
        raise CameraError(path, f"is no TOML: {why}", advice="correct it") from error


def _table(data: bytes, path: str) -> Table:
    text = utf8_text(data, path)
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    try:
        lines = [(reader.line_num, row) for row in reader if any(cell.strip() for cell in row)]
    except csv.Error as error:
        place = f"line {reader.line_num}"
        raise CameraError(path, f"is no CSV: {error}", place=place) from error
    (_, header), *rows = lines or [(0, [])]
    names = tuple(cell.strip() for cell in header)
    for line, row in rows:
        if len(row) != len(names):
            problem = f"has {len(row)} cells, expected {len(names)} as in the header"
            raise CameraError(path, problem, place=f"line {line}")
    cells = ((n, dict(zip(names, map(str.strip, row), strict=True))) for n, row in rows)
    return Table(names, tuple(cells))


def _xml(data: bytes, path: str) -> Element:
    from xml.etree.ElementTree import ParseError

    from defusedxml import ElementTree  # type: ignore[import-untyped]
    from defusedxml.common import DefusedXmlException  # type: ignore[import-untyped]

    try:
        root: Element = ElementTree.fromstring(data, forbid_dtd=True)
    except (ParseError, DefusedXmlException, ValueError, LookupError) as error:
        why = printable(str(error), 120)
        raise CameraError(
            path, f"is not readable XML: {why}", advice="the file may be cut off"
        ) from error
    return root
