"""Camera formats and other objects that installed packages provide as entry points."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any, TypeVar

import numpy as np

from procc_annotator.camera.base import Camera, ElementProjections
from procc_annotator.errors import CameraError, ProccError
from procc_annotator.formats.cameras.loaded_camera import CameraFormat, CameraRecords, LoadedCamera

GROUP = "procc_annotator.cameras"
_PROBES = np.array([(0.0, 0.0, 0.0), (30.0, -20.0, 0.0), (-52.5, 3.66, -2.44)])

F = TypeVar("F")


def discover(
    kind: type[F], group: str = GROUP, what: str = "camera plug-in"
) -> tuple[list[tuple[str, F]], list[str]]:
    """Return the named objects that the entry points of a group provide, and one line for each
    entry point that cannot be used. An entry point is an object of the kind, a list of them, or a
    function returning either.
    """
    import importlib.metadata  # takes long; the window needs no plug-ins to start

    found: list[tuple[str, F]] = []
    problems: list[str] = []
    for point in importlib.metadata.entry_points(group=group):
        try:
            found += [(point.name, given) for given in _objects(point.load(), kind)]
        # Whatever a foreign module raises on import must not end this program.
        except Exception as error:  # noqa: BLE001
            why = str(error) or "no reason given"
            problems.append(
                f"the {what} {point.name!r} ({point.value}) cannot be used:"
                f" {type(error).__name__}: {' '.join(why.split())[:300]}"
            )
    return found, problems


def _objects(loaded: object, kind: type[F]) -> list[F]:
    if not isinstance(loaded, kind) and callable(loaded):
        loaded = loaded()
    several = [loaded] if isinstance(loaded, kind) else loaded
    if not isinstance(several, Iterable) or isinstance(several, str | bytes):
        raise TypeError(f"gives {type(loaded).__name__}, expected {kind.__name__}")
    found = []
    for given in several:
        if not isinstance(given, kind):
            raise TypeError(f"gives {type(given).__name__}, expected {kind.__name__}")
        found.append(given)
    return found


def load_plugin_formats(taken: set[str]) -> tuple[tuple[CameraFormat, ...], tuple[str, ...]]:
    """Return the camera formats of plug-ins, and one line for each that cannot be used."""
    formats: list[CameraFormat] = []
    found, problems = discover(CameraFormat)
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
    """The same format; whatever goes wrong in its readers becomes a `CameraError`."""
    if not isinstance(fmt.name, str) or not callable(fmt.read):
        raise TypeError("a CameraFormat needs a name and a function to read with")
    own_read, own_records = fmt.read, fmt.records

    def refused(path: str, why: str) -> CameraError:
        return CameraError(
            path, f"cannot be read by the plug-in {plugin!r} (camera format {fmt.name}): {why}"
        )

    def run(path: str, work: Callable[[], Any]) -> Any:
        try:
            return work()
        except ProccError:
            raise
        except Exception as error:  # any mistake in it is one more way a file cannot be read
            raise refused(path, f"{type(error).__name__}: {error}") from error

    def checked(loaded: object, path: str) -> LoadedCamera:
        if not isinstance(loaded, LoadedCamera):
            raise refused(path, f"it gives {type(loaded).__name__}, expected a LoadedCamera")
        if isinstance(camera := loaded.camera, ElementProjections):
            return loaded
        if not isinstance(camera, Camera):
            raise refused(path, f"a {type(camera).__name__} has no method project")
        if not _is_projection(run(path, lambda: camera.project(_PROBES.copy()))):
            raise refused(path, "project gives something else than (N, 2) float64, (N,) bool")
        return loaded

    def read(data: bytes, *, path: str) -> LoadedCamera:
        return checked(run(path, lambda: own_read(data, path=path)), path)

    def records(data: bytes, *, path: str) -> CameraRecords | None:
        assert own_records is not None
        found = run(path, lambda: own_records(data, path=path))
        if found is None:
            return None
        if not isinstance(found, CameraRecords):
            raise refused(path, f"it gives {type(found).__name__}, not CameraRecords")
        one = found.read_record
        return replace(
            found,
            read_record=lambda c, where, at: checked(run(where, lambda: one(c, where, at)), where),
        )

    suffixes, default_for = (
        tuple(s.lower() for s in found) for found in (fmt.suffixes, fmt.default_for)
    )
    many = None if own_records is None else records
    return replace(fmt, suffixes=suffixes, default_for=default_for, read=read, records=many)


def _is_projection(given: object) -> bool:
    px, valid = given if isinstance(given, tuple) and len(given) == 2 else (None, None)
    return (
        isinstance(px, np.ndarray)
        and isinstance(valid, np.ndarray)
        and px.shape == (len(_PROBES), 2)
        and px.dtype == np.float64
        and valid.shape == (len(_PROBES),)
        and valid.dtype == np.bool_
    )
