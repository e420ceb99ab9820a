"""Homographies and parameters of the direct linear transformation (DLT) in CSV tables.

Facts: vailá's ``.dlt2d`` and ``.dlt3d`` have the columns frame, dlt_param_1, ... (8 or 11 of the
direct linear transformation, ground or world -> picture); ShuttleSet's ``homography.csv`` takes the
picture of 1280x720 to a badminton court whose corners are at (25, 150) and (325, 810).
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.content import Table
from procc_annotator.formats.cameras.homography import HOMOGRAPHY_SIZE, camera_from_homography
from procc_annotator.formats.cameras.krt import projection_from
from procc_annotator.formats.cameras.krt_sets import BY_ORDER
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
    with_notices,
)
from procc_annotator.formats.strict_json import finite_number, printable

_NAMES = ("frame", "image", "image_name", "file_name", "filename", "video", "name", "id")
_MATRICES = ("homography_matrix", "homography", "H", "h")
_NINE = re.compile(r"(?:[hH]_?)?([0-2][0-2]|[1-3][1-3])")
_DLT = "dlt_param_"
_COURT_CORNERS = {"upleft_x", "upright_x", "downleft_x", "downright_x"}
# 6.1 m across and 13.4 m along between outer edges; x here runs along, y towards x = 0 there.
_ACROSS_M, _ALONG_M = 6.1 / 300, 13.4 / 660
_SHUTTLESET = np.array([
    [0.0, _ALONG_M, -480 * _ALONG_M], [-_ACROSS_M, 0.0, 175 * _ACROSS_M], [0.0, 0.0, 1.0],
])  # fmt: skip
_METRES = "taken for metres from the field's centre, picture to field"


def is_matrix_table(content: object) -> bool:
    """Return whether decoded content is a table of homographies or of DLT parameters."""
    return isinstance(content, Table) and bool(
        _columns(content) or any(c.startswith(_DLT) for c in content.columns)
    )


def _columns(table: Table) -> list[str]:
    """The column of whole matrices, or the nine of their entries."""
    for name in _MATRICES:
        if name in table.columns:
            return [name]
    nine = sorted(c for c in table.columns if _NINE.fullmatch(c))
    return nine if len(nine) == 9 else []


def table_records(content: Any, path: str) -> CameraRecords:
    """The camera of every row.

    Raises:
        CameraError: no such table.
    """
    if not is_matrix_table(content):
        raise CameraError(path, f"expected columns frame and {_MATRICES[0]}, or {_DLT}1 ...")
    name = next((n for n in _NAMES if n in content.columns and n != "id"), "")
    # ShuttleSet names a match and not a picture.
    name = name or next((n for n in _NAMES if n in content.columns), "")
    dlt = [c for c in content.columns if c.startswith(_DLT)]
    is_court = set(content.columns) >= _COURT_CORNERS
    columns = dlt or _columns(content)

    def camera(row: dict[str, str], path: str, inside: str) -> LoadedCamera:
        numbers = _numbers(row, columns, path, inside)
        if len(numbers) == 11:
            return projection_from([*numbers, 1.0], path, inside)
        if len(numbers) not in (8, 9):
            problem = f"expected 9 numbers of a homography, found {len(numbers)}"
            raise CameraError(path, problem, place=inside)
        matrix = np.array([*numbers, 1.0][:9]).reshape(3, 3)
        if dlt:
            try:
                matrix = np.linalg.inv(matrix)
            except np.linalg.LinAlgError as error:
                raise CameraError(path, "cannot be inverted", place=inside) from error
        world = _SHUTTLESET if is_court else np.eye(3)
        loaded = camera_from_homography(matrix, world, HOMOGRAPHY_SIZE, path=path, place=inside)
        return loaded if is_court else with_notices(loaded, (_METRES,))

    found = [
        (_frame(row[name]) if name else str(i), CameraRecord(f"line {line}", row))
        for i, (line, row) in enumerate(content.rows)
    ]
    if not found:
        raise CameraError(path, "holds no row")
    return CameraRecords.of(path, found, camera, () if name else (BY_ORDER,))


def _frame(text: str) -> str:
    number = finite_number(text)
    return str(int(number)) if number is not None and number == int(number) else text


def _numbers(row: dict[str, str], columns: list[str], path: str, inside: str) -> list[float]:
    cells = [row[c] for c in columns]
    if len(columns) == 1:  # a list as Python or JSON prints it, or numbers with spaces
        cells = re.sub(r"[\[\](),;]", " ", cells[0]).split()
    numbers = []
    for cell in cells:
        number = finite_number(cell)
        if number is None:
            problem = f"expected a finite number, found {printable(cell, 40)!r}"
            raise CameraError(path, problem, place=inside)
        numbers.append(number)
    return numbers
