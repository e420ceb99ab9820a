"""Table of camera formats including plug-ins; read a camera at the evaluated size."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, TypeVar

import numpy as np

from procc_annotator.camera.base import (
    Camera,
    CameraOrProjections,
    ElementProjections,
    scaled_camera,
)
from procc_annotator.camera.models import FisheyeCamera, PinholeCamera
from procc_annotator.errors import CameraError, ProccError, UsageError
from procc_annotator.formats.cameras.homography import (
    CONVENTIONS,
    matrix_records,
    read_homography,
    read_matrix_file,
)
from procc_annotator.formats.cameras.json_detection import (
    ARRAY_SUFFIXES,
    JSON_FORMATS,
    json_records,
    read_json,
)
from procc_annotator.formats.cameras.loaded_camera import CameraRecords, LoadedCamera
from procc_annotator.formats.cameras.opencv import read_opencv
from procc_annotator.formats.cameras.paired_files import PAIRED_FORMATS, raise_half_of_pair
from procc_annotator.translation import word

GROUP = "procc_annotator.cameras"
_PROBES = np.array([(0.0, 0.0, 0.0), (30.0, -20.0, 0.0), (-52.5, 3.66, -2.44)])

F = TypeVar("F")


def discover(
    kind: type[F], group: str = GROUP, what: str = "camera plug-in"
) -> tuple[list[tuple[str, F]], list[str]]:
    """Return what the entry points of a group give, with their names, and what is wrong with the
    others.

    Args:
        kind: what each should give, by itself or as the result of a call: one or several.
        group: of entry points.
        what: to call one of them.
    """
    import importlib.metadata  # takes long; the window needs no plug-ins to start

    found: list[tuple[str, F]] = []
    problems: list[str] = []
    for point in importlib.metadata.entry_points(group=group):
        try:
            found += [(point.name, given) for given in _given(point.load(), kind)]
        # Whatever somebody else's module raises on import must not end this program.
        except Exception as error:  # noqa: BLE001
            why = str(error) or "no reason given"
            problems.append(
                f"the {what} {point.name!r} ({point.value}) cannot be used:"
                f" {type(error).__name__}: {' '.join(why.split())[:300]}"
            )
    return found, problems


def _given(loaded: object, kind: type[F]) -> list[F]:
    if not isinstance(loaded, kind) and callable(loaded):
        loaded = loaded()
    several = [loaded] if isinstance(loaded, kind) else loaded
    if not isinstance(several, Iterable) or isinstance(several, str | bytes):
        raise TypeError(f"gives {type(loaded).__name__}, expected {kind.__name__}")
    formats = list(several)
    for given in formats:
        if not isinstance(given, kind):
            raise TypeError(f"gives {type(given).__name__}, expected {kind.__name__}")
    return formats


@dataclass(frozen=True)
class PluginReader:
    """Turns whatever goes wrong in a plug-in's reader into a camera error of this program."""

    plugin: str
    format_name: str

    def checked(self, loaded: object, path: str) -> LoadedCamera:
        """Return what a reader gave, if it is a camera that projects."""
        if not isinstance(loaded, LoadedCamera):
            raise self.error(path, f"it gives {type(loaded).__name__}, expected a LoadedCamera")
        camera = loaded.camera
        if isinstance(camera, ElementProjections):
            return loaded
        if not isinstance(camera, Camera):
            raise self.error(path, f"a {type(camera).__name__} has no method project")
        given: object = self.run(path, lambda: camera.project(_PROBES.copy()))
        px, valid = given if isinstance(given, tuple) and len(given) == 2 else (None, None)
        right = (
            isinstance(px, np.ndarray)
            and isinstance(valid, np.ndarray)
            and px.shape == (len(_PROBES), 2)
            and px.dtype == np.float64
            and valid.shape == (len(_PROBES),)
            and valid.dtype == np.bool_
        )
        if not right:
            raise self.error(path, "project gives something else than (N, 2) float64, (N,) bool")
        return loaded

    def run(self, path: str, work: Callable[[], Any]) -> Any:
        """The result of somebody else's code."""
        try:
            return work()
        except ProccError:
            raise
        # Any mistake in it is one more way a file cannot be read.
        except Exception as error:
            raise self.error(path, f"{type(error).__name__}: {error}") from error

    def error(self, path: str, why: str) -> CameraError:
        """That the plug-in cannot read a file."""
        return CameraError(
            path,
            f"cannot be read by the plug-in {self.plugin!r} (camera format {self.format_name}):"
            f" {why}",
        )


@dataclass(frozen=True)
class GuardedRead:
    """A plug-in's `CameraFormat.read` under guard."""

    reader: PluginReader
    read: Callable[..., LoadedCamera]

    def __call__(self, data: bytes, *, path: str) -> LoadedCamera:
        loaded = self.reader.run(path, lambda: self.read(data, path=path))
        return self.reader.checked(loaded, path)


@dataclass(frozen=True)
class GuardedRecords:
    """A plug-in's `CameraFormat.records` under guard."""

    reader: PluginReader
    records: Callable[..., CameraRecords | None]

    def __call__(self, data: bytes, *, path: str) -> CameraRecords | None:
        found = self.reader.run(path, lambda: self.records(data, path=path))
        if found is None:
            return None
        if not isinstance(found, CameraRecords):
            raise self.reader.error(path, f"it gives {type(found).__name__}, not CameraRecords")
        own = found

        def read(content: object, where: str, place: str) -> LoadedCamera:
            loaded = self.reader.run(where, lambda: own.read_record(content, where, place))
            return self.reader.checked(loaded, where)

        return replace(own, read_record=read)


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


_FAR = 0.2  # of the picture's size
_EXACT = 1e-6  # px

__all__ = ["CAMERA_FORMATS", "LoadedCamera", "fit_to_size", "read_camera_file"]


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


def fit_to_size(
    loaded: LoadedCamera,
    size: tuple[int, int],
    camera_size: tuple[int, int] | None = None,
    unsized: tuple[int, int] | None = None,
) -> tuple[CameraOrProjections, str | None]:
    """The camera in pixels of the evaluation size, and a remark when it had to be scaled.

    Args:
        loaded: as read.
        size: (width, height) of the evaluation, px.
        camera_size: what the user says the camera's pixels belong to, where its file does not say.
        unsized: what they belong to where nothing says it; None for ``size``.
    """
    camera = loaded.camera
    if isinstance(camera, ElementProjections):
        # Shares of the picture, which belong to any size: nothing to remark.
        return scaled_camera(camera, loaded.size or size, size), None
    told = loaded.size_where(camera_size)
    own = told or unsized or size
    said = f"{own[0]}x{own[1]}"
    if loaded.size not in (None, own):
        said += f" (usual: {loaded.size[0]}x{loaded.size[1]})"
    if own != size:
        return scaled_camera(camera, own, size), f"scaled from {said} to {size[0]}x{size[1]}"
    if told is None:
        return camera, _doubt(camera, size)
    return camera, None if loaded.size in (None, own) else f"taken for {said}"


def _doubt(camera: CameraOrProjections, size: tuple[int, int]) -> str | None:
    """A remark when a camera that names no picture size hardly belongs to this one.

    It is still taken as it is, as the official evaluation does: guessing would fail silently.
    """
    if not isinstance(camera, PinholeCamera | FisheyeCamera):
        return None
    x, y = camera.principal_point_px
    width, height = size
    off_x, off_y = abs(x - width / 2), abs(y - height / 2)
    if off_x > _FAR * width or off_y > _FAR * height:
        place = f"far from the middle of {width}x{height}"
    elif (own := _exact_middle_of(x, y)) is not None and max(off_x, off_y) > 1:
        place = f"in the exact middle of {own[0]}x{own[1]}, not of {width}x{height}"
    else:
        return None
    return (
        f"principal point {place}: if the camera belongs to another picture size, name it"
        " (camera size)"
    )


def _exact_middle_of(x: float, y: float) -> tuple[int, int] | None:
    """The (width, height) px a principal point was put in the middle of, be that (width - 1) / 2 or
    width / 2; None for one that was fitted."""
    twice = round(2 * x), round(2 * y)
    if min(twice) < 2 or any(abs(2 * v - t) > _EXACT for v, t in zip((x, y), twice, strict=True)):
        return None
    return twice[0] + twice[0] % 2, twice[1] + twice[1] % 2
