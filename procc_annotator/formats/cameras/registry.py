"""Camera formats by name, suffix and content, and reading a camera file."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import chain
from pathlib import PurePath
from typing import Any, TypeVar

from procc_annotator.errors import CameraError, UsageError
from procc_annotator.formats.cameras.content import (
    TABLE_SUFFIXES,
    TOML_SUFFIX,
    decoded_content,
    is_kitti,
    is_xml,
)
from procc_annotator.formats.cameras.homography import matrix_records, read_matrix_file
from procc_annotator.formats.cameras.krt import KRT_KEYS, flat_entry
from procc_annotator.formats.cameras.loaded_camera import (
    CameraFormat,
    CameraRecords,
    LoadedCamera,
)
from procc_annotator.formats.cameras.opencv import is_storage, read_opencv
from procc_annotator.formats.cameras.plugins import load_plugin_formats
from procc_annotator.formats.cameras.polylines import looks_like_points
from procc_annotator.formats.cameras.soccernet import is_soccernet, is_tvcalib
from procc_annotator.formats.cameras.table import (
    HOMOGRAPHY_SUFFIXES,
    JSON,
    ROWS,
    SOCCERNET,
    STORAGE,
    TVCALIB,
)
from procc_annotator.formats.strict_json import json_kind, printable, strip_bom
from procc_annotator.formats.unread_formats import unread_format
from procc_annotator.translation import word

__all__ = ["CAMERA_FORMATS", "CameraFormat", "LoadedCamera", "read_camera_file"]

_ANNOTATION_ADVICE = (
    "annotations are no cameras; projected polylines are read with the camera format polylines"
)
SOCCERNET_PREFIX = "camera_"  # of its files' names


T = TypeVar("T")


class PointsError(CameraError):
    """A file of points of classes where cameras were expected."""


_SOCCERNET_KEYS = ("pan_degrees", "tilt_degrees", "position_meters", "x_focal_length")
_HOMOGRAPHY_KEYS = ("H", "homography", "homography_matrix")
_SHOWN_KEYS = 4
_BY_NAME = {row.name: row for row in ROWS}


def read_json(data: bytes, *, path: str, name: str | None = None) -> LoadedCamera:
    """The one camera of a file that is read by its content.

    Raises:
        CameraError: damaged, no camera, or several.
    """
    known, content = _recognised(data, path, name)
    if known is STORAGE:
        return read_opencv(data, path=path)
    if (records := _many(known, content, path)) is not None:
        return only_record(records)
    assert known.one is not None  # formats without it have records or raise
    return known.one(content, path, "")


def json_records(data: bytes, *, path: str, name: str | None = None) -> CameraRecords | None:
    """The same of a file that holds several; None where it holds one."""
    return _many(*_recognised(data, path, name), path)


def _many(known: CameraFormat, content: Any, path: str) -> CameraRecords | None:
    return known.many(content, path) if known.many is not None else None


def detected_title(data: bytes, path: str) -> str:
    """Title of the format that a file of cameras has by its content, as of `read_json`; empty for
    any other file, damaged ones too."""
    try:
        return _recognised(data, path, None)[0].title
    except CameraError:
        return ""


def _recognised(data: bytes, path: str, name: str | None) -> tuple[CameraFormat, Any]:
    """The format of a file, by its name or by the content, and what was decoded; of TVCalib's lines
    the bytes."""
    if name == TVCALIB.name or (name is None and _is_lines(data)):
        return TVCALIB, data
    content = decoded_content(data, path)
    if name is not None:
        return _BY_NAME[name], content
    return STORAGE if is_storage(content) else _detected(content, path), content


def only_record(records: CameraRecords) -> LoadedCamera:
    """The camera of a file of many that happens to hold one. `CameraError` if it holds several, or
    its camera is damaged."""
    if len(records.entries) != 1:
        raise CameraError(
            records.path,
            f"holds the cameras of {len(records.entries)} frames, expected one",
            advice="give the file itself as the source of cameras",
        )
    return records.read(next(iter(records.entries)))


def _detected(content: object, path: str) -> CameraFormat:
    if type(content) is dict and is_soccernet(content) and not is_tvcalib(content):
        # Keys of its lens may stand beside K and R.
        posed = _SOCCERNET_KEYS[0] in content or not KRT_KEYS.are_in(content)
        return SOCCERNET if posed else _BY_NAME["krt"]
    values = list(content.values()) if type(content) is dict else []
    told = [(row, row.recognises) for row in ROWS if row.recognises is not None]
    if looks_like_points(content) or (
        any(map(looks_like_points, values))
        and not any(is_of(value) for value in values for _, is_of in told)
    ):
        raise PointsError(path, "holds points of classes, not a camera", advice=_ANNOTATION_ADVICE)
    if type(content) is list and any(map(is_tvcalib, content)):
        return TVCALIB
    whole = (row for row, is_of in told[1:] if is_of(content))
    entries = list(map(flat_entry, values))
    parts = (row for row, is_of in told if row.one is not None and any(map(is_of, entries)))
    if (found := next(chain(whole, parts), None)) is not None:
        return found
    named = PurePath(path).name.startswith(SOCCERNET_PREFIX)
    if named or (type(content) is dict and any(key in content for key in _SOCCERNET_KEYS)):
        return SOCCERNET  # which says what else is missing
    raise _unknown(content, path)


def _unknown(content: object, path: str) -> CameraError:
    own = content if isinstance(content, dict) else {}
    if own.keys() & {*KRT_KEYS.k} and not own.keys() & {*KRT_KEYS.placed}:
        what = "holds a lens without a place, expected R and t, w2c or c2w with it"
        return CameraError(
            path, what, advice="add them; docs/reference/camera-formats.md has the spellings"
        )
    values = content if isinstance(content, list) else own.values()
    inner = [v for v in values if type(v) in (dict, list)]
    inner += [v for one in inner if type(one) is list for v in one[:1]]  # {"frames": [...]}
    if any(map(_is_homography, (content, *inner))):
        return CameraError(
            path,
            "holds a homography, and nothing states its ground and units",
            advice="save it as .npy, and choose a camera format: wc14, carwc or world; of many"
            " frames make CSV: frame, h11 ... h33, picture to metres from the centre",
        )
    tag = getattr(content, "tag", None)
    found = json_kind(content) if tag is None else f"<{printable(str(tag), 30)}>"
    if type(content) is dict and content:
        keys = ", ".join(printable(str(key), 30) for key in list(content)[:_SHOWN_KEYS])
        more = ", ..." if len(content) > _SHOWN_KEYS else ""
        found = f"an object with {keys}{more}"
    suffix = os.path.splitext(path)[1].lower()
    rows = [row for row in ROWS if row.keys and suffix in row.suffixes and row is not STORAGE]
    formats = "; ".join(f"{row.keys} ({row.name})" for row in rows or ROWS if row.keys)
    return CameraError(
        path,
        f"holds no camera of a known format: found {found}, expected {formats}",
        advice="is this a camera? if so, choose its camera format",
    )


def _is_homography(value: object) -> bool:
    if type(value) is dict:
        return any(key in value for key in _HOMOGRAPHY_KEYS)
    rows = value if type(value) is list and len(value) == 3 else [[]]
    return all(type(row) is list and len(row) == 3 for row in rows)


def _is_lines(data: bytes) -> bool:
    """Return whether a file holds one TVCalib record a line, judged by its first."""
    data = strip_bom(data)
    first, _, rest = data.lstrip().partition(b"\n")
    if not rest.strip() or not first.lstrip().startswith(b"{") or b'"image_ids"' not in first:
        return False
    try:
        return is_tvcalib(json.loads(first))
    except (ValueError, RecursionError):
        return False


def _read_any(data: bytes, *, path: str) -> LoadedCamera:
    """The camera of a file that no one named the format of."""
    if _is_matrix(data, path):
        return _read_or_name(read_matrix_file, data, path)
    _refuse_unread(path, data)
    if _is_storage_xml(data, path):
        return read_opencv(data, path=path)
    return read_json(data, path=path)


def _any_records(data: bytes, *, path: str) -> CameraRecords | None:
    if _is_matrix(data, path):
        return _read_or_name(matrix_records, data, path)
    _refuse_unread(path, data)
    return None if _is_storage_xml(data, path) else json_records(data, path=path)


def _read_or_name(read: Callable[..., T], data: bytes, path: str) -> T:
    """What is read; of a file of a program whose files are not read, the way out."""
    try:
        return read(data, path=path)
    except CameraError:
        if data[:1].isalpha():  # numbers are damaged ones
            _refuse_unread(path, data)
        raise


def _refuse_unread(path: str, data: bytes = b"") -> None:
    if (unread := unread_format(path, data)) is not None:
        raise CameraError(path, unread.problem, advice=unread.advice)


def _is_matrix(data: bytes, path: str) -> bool:
    is_text = path.lower().endswith(HOMOGRAPHY_SUFFIXES)
    return is_text and not is_xml(data) and not is_kitti(data)


def _is_storage_xml(data: bytes, path: str) -> bool:
    """Return whether it is XML of a FileStorage, or of no known kind: its reader says what."""
    other = b"<cameras" in data[:4096] and b"<opencv_storage" not in data[:4096]
    return path.lower().endswith(".xml") and not other


FORMATS: tuple[CameraFormat, ...] = tuple(
    replace(
        row, read=partial(read_json, name=row.name), records=partial(json_records, name=row.name)
    )
    if row.read is None
    else row
    for row in ROWS
)
# What is distinguished by what is in it.
_ANY_SUFFIXES = (*JSON, *TABLE_SUFFIXES, TOML_SUFFIX, ".xml", *HOMOGRAPHY_SUFFIXES)
_ANY = CameraFormat(
    "auto", "by what is in it", _ANY_SUFFIXES, _ANY_SUFFIXES, _read_any, _any_records
)
# Of tables and settings as well, which lie beside cameras: read where it is the only such file.
ALONE_SUFFIXES = frozenset({".csv", TOML_SUFFIX})
PAIRED_FORMATS: tuple[CameraFormat, ...] = tuple(row for row in FORMATS if row.pairs)
PAIR_NAMES = frozenset(name for row in PAIRED_FORMATS for pair in row.pairs for name in pair)
CAMERA_FORMATS: tuple[str, ...] = ("auto", *(f.name for f in FORMATS))


def all_formats() -> tuple[CameraFormat, ...]:
    """The formats of this program and those of plug-ins, which are looked for once."""
    return (*FORMATS, *_plugins()[0])


def plugin_problems() -> tuple[str, ...]:
    """One line for each plug-in that cannot be used."""
    return _plugins()[1]


def format_titles() -> dict[str, str]:
    """Return what people read for each name that can be asked for, ``auto`` first."""
    return {"auto": word("by file type and content"), **{f.name: f.title for f in all_formats()}}


def format_of(path: str, fmt: str = "auto") -> CameraFormat:
    """The format to read a file with.

    Raises:
        UsageError: no such format.
        CameraError: ``auto`` does not know the suffix.
    """
    if fmt != "auto":
        known = _named(fmt)
        if known is None:
            names = ", ".join(("auto", *(f.name for f in all_formats())))
            raise UsageError(f"no camera format {fmt!r}; there are {names}")
        return known
    suffix = os.path.splitext(path)[1].lower()
    for known in (_ANY, *FORMATS):
        if suffix in known.default_for:
            return known
    for known in all_formats():
        if suffix in known.default_for:
            return known
    _refuse_unread(path)
    raise CameraError(
        path,
        f"unknown kind of camera file {suffix!r}",
        advice=f"choose a camera format: {', '.join(f.name for f in all_formats())}",
    )


def suffixes_of(fmt: str = "auto") -> frozenset[str]:
    """Lower-case suffixes of the files that may hold cameras of a format; of ``auto`` without
    those of `ALONE_SUFFIXES`."""
    if fmt == "auto":
        found = frozenset(s for known in (_ANY, *all_formats()) for s in known.default_for)
        return found - ALONE_SUFFIXES
    return frozenset(format_of("", fmt).suffixes)


def _named(fmt: str) -> CameraFormat | None:
    # Plug-ins are searched only for names that are not ours.
    own = next((known for known in FORMATS if known.name == fmt), None)
    return own or next((known for known in _plugins()[0] if known.name == fmt), None)


_found: list[tuple[tuple[CameraFormat, ...], tuple[str, ...]]] = []


def _plugins() -> tuple[tuple[CameraFormat, ...], tuple[str, ...]]:
    if not _found:
        _found.append(load_plugin_formats({"auto", *(known.name for known in FORMATS)}))
    return _found[0]


def read_camera_file(data: bytes, *, path: str, fmt: str = "auto") -> LoadedCamera:
    """Read a camera.

    Raises:
        CameraError: the file is damaged or of an unknown kind.
        UsageError: no such format.
    """
    read = format_of(path, fmt).read
    assert read is not None  # `FORMATS` has one for every row
    return read(data, path=path)
