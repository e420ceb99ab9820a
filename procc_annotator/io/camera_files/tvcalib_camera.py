"""TVCalib's ``per_sample_output.json``: one JSON record a line, named by its picture."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from procc_annotator.errors import CameraError
from procc_annotator.io.camera_files.camera_records import (
    CameraRecord,
    CameraRecords,
    frame_of_image,
)
from procc_annotator.io.camera_files.homography_file import camera_from_homography
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera, with_notices
from procc_annotator.io.camera_files.soccernet_camera import camera_from, is_soccernet
from procc_annotator.io.json_text import decode_fast, json_kind, printable, strip_bom
from procc_annotator.io.json_values import JsonValues

TVCALIB_KIND = "a TVCalib record"
_NAME_KEYS = ("image_ids", "image_id")
_SHOWN_PROBLEMS = 3
_ASSUMED = (960, 540)


def is_tvcalib(content: object) -> bool:
    """Whether a decoded value is such a record."""
    return type(content) is dict and _NAME_KEYS[0] in content


def tvcalib_records(data: bytes, *, path: str) -> CameraRecords:
    """The records of a file: one a line, or all in one JSON list.

    A line that is no record belongs to no frame anybody knows; it is passed over with a notice.

    Raises:
        CameraError: no line is a record.
    """
    found: list[tuple[str, CameraRecord]] = []
    problems: list[CameraError] = []
    for place, read in _parts(data, path):
        try:
            content = read()
            found.append((_picture(content, path, place), CameraRecord(place, content)))
        except CameraError as error:
            problems.append(error)
    if not found:
        if problems:
            raise problems[0]
        raise CameraError(path, "is empty, expected one JSON record a line")
    return CameraRecords.of(path, found, tvcalib_from, _notices(problems))


def tvcalib_from(content: object, path: str, inside: str = "") -> LoadedCamera:
    """Read a decoded record: camera parameters, or else the homography picture -> world metres.

    Raises:
        CameraError: names the place and what was expected.
    """
    values = JsonValues.of(content, path, inside, TVCALIB_KIND, nested=True)
    if is_soccernet(values.content):
        loaded = camera_from(content, path=path, inside=inside, nested=True)
        return replace(loaded, extra={}, content={})
    if "homography" not in values:
        raise values.missing("a homography or the keys of a SoccerNet camera", "homography")
    size = values.size()
    matrix = JsonValues({"homography": _unnested(values)}, path, inside).matrix("homography", 3, 3)
    loaded = camera_from_homography(matrix, np.eye(3), size or _ASSUMED, path=path, place=inside)
    if size is None:
        unsized = "names no picture size: taken for pixels of the evaluation size"
        loaded = with_notices(replace(loaded, size=None), (unsized,))
    return with_notices(replace(loaded, size_is_usual=False), values.unused("homography"))


def _unnested(values: JsonValues) -> Any:
    value = values.content["homography"]
    while type(value) is list and len(value) == 1:
        value = value[0]
    return value


def _parts(data: bytes, path: str) -> list[tuple[str, Any]]:
    """(place, decoder) of each record."""
    data = strip_bom(data)
    if data.lstrip()[:1] == b"[":
        records = decode_fast(data, path=path, error=CameraError)
        return [(f"[{i}]", lambda r=record: r) for i, record in enumerate(records)]
    return [
        (f"line {number}", lambda text=line, at=number: _decoded(text, path, at))
        for number, line in enumerate(data.split(b"\n"), 1)
        if line.strip()
    ]


def _decoded(line: bytes, path: str, number: int) -> object:
    try:
        return decode_fast(line, path=path, error=CameraError)
    except CameraError as error:
        # The place within the line is of no use where a line has thousands of characters.
        raise CameraError(
            path, error.problem, place=f"line {number}", advice=error.advice
        ) from error


def _picture(content: object, path: str, place: str) -> str:
    values = JsonValues.of(content, path, place, TVCALIB_KIND)
    name = values.content[values.need("the name of a picture", *_NAME_KEYS)]
    while type(name) is list and len(name) == 1:
        name = name[0]
    if type(name) is not str or not frame_of_image(name):
        raise values.error(f"expected the name of a picture, found {json_kind(name)}", _NAME_KEYS[0])
    return name


def _notices(problems: list[CameraError]) -> tuple[str, ...]:
    more = len(problems) - _SHOWN_PROBLEMS
    said = [f"passed over: {printable(str(p), 300)}" for p in problems[:_SHOWN_PROBLEMS]]
    return (*said, f"passed over: {more} more records") if more > 0 else tuple(said)
