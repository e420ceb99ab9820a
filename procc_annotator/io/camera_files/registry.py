"""The table of camera formats: name, suffixes, reader; those of plug-ins are added when asked for.

A plug-in is an entry point of the group ``procc_annotator.cameras`` that gives a `CameraFormat`, or
a function that returns one or several. See docs/examples/camera_plugin/.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

from procc_annotator.errors import CameraError, UsageError
from procc_annotator.io.camera_files.camera_plugins import (
    GuardedRead,
    GuardedRecords,
    PluginReader,
    discover,
)
from procc_annotator.io.camera_files.camera_records import CameraRecords
from procc_annotator.io.camera_files.homography_file import CONVENTIONS, read_homography
from procc_annotator.io.camera_files.json_cameras import (
    ARRAY_SUFFIXES,
    JSON_FORMATS,
    json_records,
    read_json,
)
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.camera_files.matrix_file import matrix_records, read_matrix_file
from procc_annotator.io.camera_files.opencv_camera import read_opencv
from procc_annotator.io.camera_files.paired_files import PAIRED_FORMATS, raise_half_of_pair
from procc_annotator.language import word


@dataclass(frozen=True)
class CameraFormat:
    """One way cameras are kept in files.

    Attributes:
        name: what is typed after ``--camera-format``.
        title: what people read.
        suffixes: of the files that may hold it, lower case.
        default_for: the suffixes ``auto`` gives to it.
        read: ``read(data, path=...)``, the camera of a file that holds one.
        records: ``records(data, path=...)``, the cameras of a file that holds several, or None for
            a file that holds one; None for a format whose files never do.
        always_many: whether its files always hold several.
    """

    name: str
    title: str
    suffixes: tuple[str, ...]
    default_for: tuple[str, ...]
    read: Callable[..., LoadedCamera]
    records: Callable[..., CameraRecords | None] | None = None
    always_many: bool = False


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
# What is told apart by what is in it.
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
    """What people read for each name that can be asked for, ``auto`` first."""
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
    # Plug-ins are looked for only where the name is none of ours.
    own = next((known for known in FORMATS if known.name == fmt), None)
    return own or next((known for known in _plugins()[0] if known.name == fmt), None)


_found: list[tuple[tuple[CameraFormat, ...], tuple[str, ...]]] = []


def _plugins() -> tuple[tuple[CameraFormat, ...], tuple[str, ...]]:
    if not _found:
        _found.append(_load_plugins())
    return _found[0]


def _load_plugins() -> tuple[tuple[CameraFormat, ...], tuple[str, ...]]:
    formats: list[CameraFormat] = []
    found, problems = discover(CameraFormat)
    taken = {"auto", *(known.name for known in FORMATS)}
    for plugin, fmt in found:
        if fmt.name in taken:
            problems.append(
                f"the camera plug-in {plugin!r} gives a format {fmt.name!r}, which there is"
                " already; it is not used"
            )
            continue
        try:
            formats.append(_guarded(fmt, plugin))
        except (TypeError, AttributeError) as error:
            problems.append(f"the camera plug-in {plugin!r} cannot be used: {error}")
            continue
        taken.add(fmt.name)
    return tuple(formats), tuple(problems)


def _guarded(fmt: CameraFormat, plugin: str) -> CameraFormat:
    """A plug-in's format with its readers under guard."""
    if not isinstance(fmt.name, str) or not callable(fmt.read):
        raise TypeError("a CameraFormat needs a name and a function to read with")
    reader, records = PluginReader(plugin, fmt.name), fmt.records
    return replace(
        fmt,
        suffixes=tuple(s.lower() for s in fmt.suffixes),
        default_for=tuple(s.lower() for s in fmt.default_for),
        read=GuardedRead(reader, fmt.read),
        records=None if records is None else GuardedRecords(reader, records),
    )
