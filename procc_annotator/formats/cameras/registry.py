"""The table of camera formats: how each is recognised and read."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import PurePath
from typing import Any

from procc_annotator.errors import CameraError, UsageError
from procc_annotator.formats.cameras.arrays import array_content, is_array_file
from procc_annotator.formats.cameras.homography import (
    CONVENTIONS,
    matrix_records,
    read_homography,
    read_matrix_file,
)
from procc_annotator.formats.cameras.krt import (
    is_krt,
    is_nested,
    is_projection,
    is_stack,
    krt_from,
    nested_records,
    projection_from,
    stack_records,
)
from procc_annotator.formats.cameras.loaded_camera import (
    CameraFormat,
    CameraRecord,
    CameraRecords,
    LoadedCamera,
)
from procc_annotator.formats.cameras.opencv import is_storage, read_opencv
from procc_annotator.formats.cameras.paired_files import PAIRED_FORMATS, raise_half_of_pair
from procc_annotator.formats.cameras.plugins import load_plugin_formats
from procc_annotator.formats.cameras.polylines import (
    is_whole,
    looks_like_points,
    polylines_from,
    polylines_records,
)
from procc_annotator.formats.cameras.published_sets import (
    annotation_records,
    deepsportradar_records,
    is_annotation_set,
    is_deepsportradar,
    is_transforms,
    read_ptz,
    read_set_homography,
    transforms_records,
)
from procc_annotator.formats.cameras.soccernet import (
    broadtrack_records,
    camera_from,
    is_broadtrack,
    is_soccernet,
    is_tvcalib,
    tvcalib_records,
)
from procc_annotator.formats.strict_json import decode_fast, json_kind, printable, strip_bom
from procc_annotator.translation import word

__all__ = ["CAMERA_FORMATS", "CameraFormat", "LoadedCamera", "read_camera_file"]

_ANNOTATION_ADVICE = (
    "annotations are no cameras; projected polylines are read with the camera format polylines"
)


ARRAY_SUFFIXES = (".npz", ".mat")
SOCCERNET_PREFIX = "camera_"  # of its files' names


class PointsError(CameraError):
    """A file of points of classes where cameras were expected."""


# Decoded content, the file, the place in it -> the camera.
FromContent = Callable[[object, str, str], LoadedCamera]


@dataclass(frozen=True)
class JsonFormat:
    """A camera format of JSON.

    Attributes:
        name, title: for the table of formats.
        one: reads a file that holds one camera; None for a format of files with many.
        many: the cameras of a decoded file that holds several; None where it holds one.
        recognises: whether decoded content is of this format, for content no one named.
        keys: by which content is recognised, for messages; empty for a format that is never
            recognised by what is in it.
    """

    name: str
    title: str
    one: FromContent | None
    many: Callable[[object, str], CameraRecords | None]
    recognises: Callable[[object], bool]
    keys: str = ""


def _soccernet(content: object, path: str, inside: str = "") -> LoadedCamera:
    return camera_from(content, path=path, inside=inside)


def _is_soccernet(content: object) -> bool:
    return type(content) is dict and is_soccernet(content)


def _by_frame(
    is_one: Callable[[object], bool], read: FromContent, content: object, path: str
) -> CameraRecords | None:
    if type(content) is not dict or is_one(content) or not any(map(is_one, content.values())):
        return None
    found = [(name, CameraRecord(name, v)) for name, v in content.items()]
    return CameraRecords.of(path, found, read)


def _krt_records(content: object, path: str) -> CameraRecords | None:
    if is_nested(content):
        return nested_records(content, path)
    if is_stack(content):
        return stack_records(content, path)
    return _by_frame(is_krt, krt_from, content, path)


def _is_krt(content: object) -> bool:
    return is_krt(content) or is_nested(content) or (is_stack(content) and not is_storage(content))


SOCCERNET = JsonFormat(
    "soccernet", "SoccerNet camera JSON", _soccernet,
    partial(_by_frame, _is_soccernet, _soccernet), _is_soccernet, "pan_degrees, x_focal_length",
)  # fmt: skip
TVCALIB = JsonFormat(
    "tvcalib", "TVCalib per_sample_output.json", None, tvcalib_records, is_tvcalib, "image_ids"
)
STORAGE = JsonFormat("opencv", "OpenCV FileStorage", None, lambda *_: None, is_storage)
JSON_FORMATS = (
    SOCCERNET,
    TVCALIB,
    JsonFormat(
        "broadtrack", "BroadTrack JSON", None,
        broadtrack_records, is_broadtrack, "cp of each picture",
    ),
    JsonFormat(
        "deepsportradar", "DeepSportRadar K, R, T list", None,
        deepsportradar_records, is_deepsportradar, "a list of K, R, T",
    ),
    JsonFormat("krt", "K, R, t and distortion", krt_from, _krt_records, _is_krt, "K, R"),
    JsonFormat(
        "polylines", "projected polylines, JSON", polylines_from, polylines_records, is_whole,
    ),
    JsonFormat(
        "projection", "3 x 4 projection matrix", projection_from,
        partial(_by_frame, is_projection, projection_from), is_projection, "P of 3 x 4",
    ),
    JsonFormat(
        "transforms", "transforms.json of radiance fields", None,
        transforms_records, is_transforms, "frames of transform_matrix",
    ),
    JsonFormat(
        "sccvsd", "World Cup 2014 homographies, MATLAB", None,
        partial(annotation_records, read_set_homography),
        partial(is_annotation_set, "homography"), "annotation of image_name, homography",
    ),
    JsonFormat(
        "ptz-slam", "frames of one tripod, MATLAB", None, partial(annotation_records, read_ptz),
        partial(is_annotation_set, "camera"), "annotation of image_name, camera",
    ),
)  # fmt: skip
_SOCCERNET_KEYS = ("pan_degrees", "tilt_degrees", "position_meters", "x_focal_length")
_HOMOGRAPHY_KEYS = ("H", "homography", "homography_matrix")
_SHOWN_KEYS = 4
_BY_NAME = {known.name: known for known in JSON_FORMATS}


def read_json(data: bytes, *, path: str, name: str | None = None) -> LoadedCamera:
    """The one camera of a JSON file.

    Args:
        data: the file's bytes. path: for messages.
        name: one of `JSON_FORMATS`; None goes by the content.

    Raises:
        CameraError: damaged, no camera, or several.
    """
    known, content = _recognised(data, path, name)
    if known is STORAGE:
        return read_opencv(data, path=path)
    records = known.many(content, path)
    if records is not None:
        return only_record(records)
    assert known.one is not None  # formats without it have records or raise
    return known.one(content, path, "")


def json_records(data: bytes, *, path: str, name: str | None = None) -> CameraRecords | None:
    """The cameras of a JSON file that holds several, or None where it holds one.

    Raises:
        CameraError: damaged, or no camera.
    """
    known, content = _recognised(data, path, name)
    return known.many(content, path)


def detected_title(data: bytes, path: str) -> str:
    """Title of the format that a file of cameras has by its content, as of `read_json`; empty for
    any other file, damaged ones too."""
    try:
        return _recognised(data, path, None)[0].title
    except CameraError:
        return ""


def _recognised(data: bytes, path: str, name: str | None) -> tuple[JsonFormat, Any]:
    """The format of a file, by its name or by the content, and what was decoded; of TVCalib's lines
    the bytes."""
    if name == TVCALIB.name or (name is None and _is_lines(data)):
        return TVCALIB, data
    if is_array_file(data) or path.lower().endswith(ARRAY_SUFFIXES):
        content: Any = array_content(data, path)
    else:
        content = decode_fast(data, path=path, error=CameraError)
    if name is not None:
        return _BY_NAME[name], content
    return STORAGE if is_storage(content) else _detected(content, path), content


def only_record(records: CameraRecords) -> LoadedCamera:
    """The camera of a file of many that happens to hold one.

    Raises:
        CameraError: it holds several, or its camera is damaged.
    """
    if len(records.entries) != 1:
        raise CameraError(
            records.path,
            f"holds the cameras of {len(records.entries)} frames, expected one",
            advice="give the file itself as the source of cameras",
        )
    return records.read(next(iter(records.entries)))


def _detected(content: object, path: str) -> JsonFormat:
    if type(content) is dict and is_soccernet(content) and not is_tvcalib(content):
        return SOCCERNET
    values = list(content.values()) if type(content) is dict else []
    if looks_like_points(content) or (
        values and any(looks_like_points(v) for v in values) and not any(map(_is_camera, values))
    ):
        raise PointsError(path, "holds points of classes, not a camera", advice=_ANNOTATION_ADVICE)
    if type(content) is list and any(map(is_tvcalib, content)):
        return TVCALIB
    for known in JSON_FORMATS[1:]:
        if known.recognises(content):
            return known
    for known in JSON_FORMATS:
        if known.one is not None and any(map(known.recognises, values)):
            return known
    named = PurePath(path).name.startswith(SOCCERNET_PREFIX)
    if named or (type(content) is dict and any(key in content for key in _SOCCERNET_KEYS)):
        return SOCCERNET  # which says what else is missing
    raise _unknown(content, path)


def _unknown(content: object, path: str) -> CameraError:
    if type(content) is dict and any(key in content for key in _HOMOGRAPHY_KEYS):
        return CameraError(
            path,
            "holds a homography, and nothing tells which ground and which units it is of",
            advice="save it as .npy, and choose a camera format: wc14, carwc or world",
        )
    found = json_kind(content)
    if type(content) is dict and content:
        keys = ", ".join(printable(str(key), 30) for key in list(content)[:_SHOWN_KEYS])
        more = ", ..." if len(content) > _SHOWN_KEYS else ""
        found = f"an object with {keys}{more}"
    formats = "; ".join(f"{known.keys} ({known.name})" for known in JSON_FORMATS if known.keys)
    return CameraError(
        path,
        f"holds no camera of a known format: found {found}, expected {formats}",
        advice="is this a camera? if so, choose its camera format",
    )


def _is_camera(content: object) -> bool:
    return any(known.recognises(content) for known in JSON_FORMATS)


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


_HOMOGRAPHY_SUFFIXES = (".homographymatrix", ".txt", ".npy")
_STORAGE_SUFFIXES = (".yml", ".yaml", ".xml")
_JSON = (".json", ".jsonl", *ARRAY_SUFFIXES)

FORMATS: tuple[CameraFormat, ...] = (
    *(
        CameraFormat(
            known.name,
            known.title,
            _JSON,
            (),
            partial(read_json, name=known.name),
            partial(json_records, name=known.name),
            known.one is None,
        )
        for known in JSON_FORMATS
    ),
    CameraFormat(
        "opencv", "OpenCV FileStorage, YAML, XML or JSON", (*_STORAGE_SUFFIXES, ".json"),
        _STORAGE_SUFFIXES, read_opencv,
    ),
    *(
        CameraFormat(
            name,
            f"homography, {rule.title}",
            _HOMOGRAPHY_SUFFIXES,
            (),
            partial(read_homography, convention=name),
        )
        for name, rule in CONVENTIONS.items()
    ),
    *(
        CameraFormat(
            known.name,
            known.title,
            (os.path.splitext(known.poses)[1],),
            (),
            partial(raise_half_of_pair, known=known),
        )
        for known in PAIRED_FORMATS
    ),
)  # fmt: skip
# What is distinguished by what is in it.
_ANY_JSON = CameraFormat("auto", "by what is in it", _JSON, _JSON, read_json, json_records)
_ANY_MATRIX = CameraFormat(
    "auto", "by its shape", _HOMOGRAPHY_SUFFIXES, _HOMOGRAPHY_SUFFIXES, read_matrix_file,
    matrix_records,
)  # fmt: skip
_TOLD = (_ANY_JSON, _ANY_MATRIX)
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
    for known in (*_TOLD, *FORMATS):
        if suffix in known.default_for:
            return known
    for known in all_formats():
        if suffix in known.default_for:
            return known
    raise CameraError(
        path,
        f"unknown kind of camera file {suffix!r}",
        advice=f"choose a camera format: {', '.join(f.name for f in all_formats())}",
    )


def suffixes_of(fmt: str = "auto") -> frozenset[str]:
    """Lower-case suffixes of the files that may hold cameras of a format."""
    if fmt == "auto":
        return frozenset(s for known in (*_TOLD, *all_formats()) for s in known.default_for)
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

    Args:
        data: the file's bytes.
        path: its name; ``auto`` goes by the suffix.
        fmt: one of `CAMERA_FORMATS`.

    Raises:
        CameraError: the file is damaged or of an unknown kind.
        UsageError: no such format.
    """
    return format_of(path, fmt).read(data, path=path)
