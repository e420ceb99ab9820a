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
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.krt import projection_from
from procc_annotator.formats.cameras.krt_sets import BY_ORDER
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
    with_notices,
)
from procc_annotator.formats.strict_json import finite_number

_NAMES = ("frame", "image", "image_name", "file_name", "filename", "video", "name", "id")
_MATRICES = ("homography_matrix", "homography", "H", "h")
_NINE = re.compile(r"(?:[hH]_?)?([0-2][0-2]|[1-3][1-3])")
_DLT = "dlt_param_"
_COURT = {"upleft_x", "upright_x", "downleft_x", "downright_x"}
# 6.1 m across and 13.4 m along between outer edges; x here runs along, y towards x = 0 there.
_ACROSS_M, _ALONG_M = 6.1 / 300, 13.4 / 660
_SHUTTLESET = np.array([
    [0.0, _ALONG_M, -480 * _ALONG_M], [-_ACROSS_M, 0.0, 175 * _ACROSS_M], [0.0, 0.0, 1.0],
])  # fmt: skip
_METRES = "taken for metres from the field's centre, picture to field"


def is_matrix_table(content: object) -> bool:
    """Return whether decoded content is a table of homographies or of DLT parameters."""
    return isinstance(content, Table) and bool(_columns(content))


def _columns(table: Table) -> list[str]:
    """The column of whole matrices, the nine of their entries, or those of DLT parameters."""
    one = [c for c in table.columns if c in _MATRICES][:1]
    nine = sorted(c for c in table.columns if _NINE.fullmatch(c))
    dlt = [c for c in table.columns if c.startswith(_DLT)]
    return one or (nine if len(nine) == 9 else dlt if len(dlt) in (8, 11) else [])


def table_records(content: Any, path: str) -> CameraRecords:
    """The camera of every row. `CameraError` for no such table."""
    columns = _columns(content) if isinstance(content, Table) else []
    if not columns or not content.rows:
        raise CameraError(path, f"expected columns frame and {_MATRICES[0]}, or {_DLT}1 ...")
    name = next((n for n in _NAMES if n in content.columns), "")
    is_court, is_dlt = set(content.columns) >= _COURT, columns[0].startswith(_DLT)

    def camera(row: dict[str, str], path: str, inside: str) -> LoadedCamera:
        # A list as Python or JSON prints it, or a number a cell.
        words = re.sub(r"[\[\](),;]", " ", " ".join(row[c] for c in columns)).split()
        own = {columns[0]: [finite_number(word) for word in words]}
        numbers = [*JsonValues(own, path, inside).numbers(columns[0]), *[1.0] * is_dlt]
        if len(numbers) == 12:
            return projection_from(numbers, path, inside)
        if len(numbers) != 9:
            problem = f"expected 9 numbers of a homography, found {len(numbers)}"
            raise CameraError(path, problem, place=inside)
        matrix = np.array(numbers).reshape(3, 3)
        if is_dlt and np.linalg.matrix_rank(matrix) == 3:
            matrix = np.linalg.inv(matrix)
        world = _SHUTTLESET if is_court else np.eye(3)
        loaded = camera_from_homography(matrix, world, HOMOGRAPHY_SIZE, path=path, place=inside)
        remarks = () if is_court else (_METRES,)
        left = JsonValues(row, path).unused(*columns, *_COURT, *_NAMES)
        return with_notices(loaded, (*remarks, *left))

    found = [
        (row[name].removesuffix(".0") if name else str(i), CameraRecord(f"line {line}", row))
        for i, (line, row) in enumerate(content.rows)
    ]
    return CameraRecords.of(path, found, camera, () if name else (BY_ORDER,))
