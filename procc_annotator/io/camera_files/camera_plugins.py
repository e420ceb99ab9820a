"""Camera formats from plug-ins: found through entry points, and kept from stopping the program."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy as np

from procc_annotator.camera.base import Camera
from procc_annotator.camera.projections import ElementProjections
from procc_annotator.errors import CameraError, ProccError
from procc_annotator.io.camera_files.camera_records import CameraRecords
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera

GROUP = "procc_annotator.cameras"
_PROBES = np.array([(0.0, 0.0, 0.0), (30.0, -20.0, 0.0), (-52.5, 3.66, -2.44)])

F = TypeVar("F")


def discover(
    kind: type[F], group: str = GROUP, what: str = "camera plug-in"
) -> tuple[list[tuple[str, F]], list[str]]:
    """What the entry points of a group give, with their names, and what is wrong with the others.

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
        """What a reader gave, if it is a camera that projects."""
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
