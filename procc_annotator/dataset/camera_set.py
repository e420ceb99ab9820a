"""Cameras of one method by frame name, from files."""

from __future__ import annotations

import os
import time
from collections import OrderedDict
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path, PurePosixPath
from threading import Lock
from typing import Protocol

from procc_annotator.camera.base import CameraOrProjections
from procc_annotator.camera.models import model_name
from procc_annotator.dataset.saving import FileStamps, Stamp, stamp_of
from procc_annotator.errors import CameraError
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.loaded_camera import fit_to_size
from procc_annotator.formats.file_source import from_base

_KEPT = 64
_COARSEST_NS = 2_000_000_000  # between two times that a file system tells apart


@dataclass(frozen=True, eq=False)
class CameraForFrame:
    """A frame's camera in pixels of the evaluation size, its model, a remark for the user, and what
    it was fitted to and is taken to show (see `LoadedCamera`)."""

    camera: CameraOrProjections
    model: str
    notice: str | None
    fitted_on: str | None = None
    assumed_field: str = ""


class FrameCameras(Protocol):
    """Cameras by frame name, wherever they come from; safe to read from several threads.

    What is known of them is kept by the object: where a camera changes, another object takes its
    place.
    """

    @property
    def name(self) -> str:
        """Shown to the user."""

    @property
    def origin(self) -> str:
        """Return where the cameras come from, for people."""

    @property
    def frames(self) -> Mapping[str, object]:
        """The frames that have a camera."""

    def camera(self, frame_name: str, size: tuple[int, int]) -> CameraForFrame | None:
        """A frame's camera for an evaluation size, or None if absent. `CameraError` if it cannot be
        read."""

    def why_none(self, frame_name: str) -> str:
        """Why a frame has no camera, for people."""


class CameraSet:
    """Cameras from files, by frame name; safe to read from several threads."""

    def __init__(
        self,
        cameras: CameraCollection,
        name: str,
        camera_size: tuple[int, int] | None = None,
        base: Path | None = None,
    ) -> None:
        self.path = cameras.path
        self._base = base
        self.camera_size = camera_size
        self.name = name
        self.format = cameras.format
        self.field = cameras.field
        self.frames = cameras.frames  # frame name -> file
        self.notices = cameras.notices
        self._cameras = cameras
        self._lock = Lock()
        self._stamps: FileStamps[str] = FileStamps()  # by file or folder; "" is all
        self._is_folder = self._file("").is_dir()
        self._recent: OrderedDict[tuple[str, tuple[int, int]], CameraForFrame] = OrderedDict()

    @classmethod
    def open(
        cls,
        path: Path,
        fmt: str = "auto",
        name: str | None = None,
        camera_size: tuple[int, int] | None = None,
        field: Field | None = None,
        base: Path | None = None,
    ) -> CameraSet:
        """List the cameras of a folder, a zip archive or a single file.

        Args:
            fmt: one of `CAMERA_FORMATS`.
            camera_size: (width, height) the cameras' pixels belong to, where their files do
                not say.
            field: as of `CameraCollection`; None where it may change while the cameras are open.
            name: shown to the user; by default that of the folder, or of the file without suffix.
            base: what a relative path starts from, see `open_source`.

        Raises:
            UsageError: nothing at the path, or no such format.
            InputError: two files for one frame, or an archive that cannot be opened.
        """
        # Before the look: what is written meanwhile is found by the next.
        place, begun = from_base(base, path), time.time_ns()
        stamps = FileStamps[str]()
        stamps.note("", place)

        def note(file: str) -> None:
            if place.is_dir():
                stamps.note(file, place / file)

        collection = CameraCollection.open(path, fmt, base, field, note)
        found = cls(collection, name or _name_of(path), camera_size, base)
        for folder in _folders_of(found.frames.values()) if found._is_folder else ():
            stamps.take(folder, _unless_since(begun, stamp_of(place / folder)))
        found._stamps.keep(stamps, without={})
        return found

    def written_since(self, frame_name: str) -> bool:
        """Return whether a frame's camera file is another one than was read; one look at the
        file."""
        file = self.frames.get(frame_name) if self._is_folder else ""
        return file is not None and bool(self._stamps.changed(self._file, only=(file,)))

    def look_again(
        self, asked: Iterable[str], stopped: Callable[[], bool] = lambda: False
    ) -> tuple[CameraSet, frozenset[str]] | None:
        """The cameras as they are on disk by now, in any thread; one look at every file read.

        Args:
            asked: names of the frames that cameras are asked for, which may be called otherwise
                here.
            stopped: whether to give up.

        Returns:
            The newer set, and the requested frames with cameras that changed, came or went; None
            when no frame's camera is another one.

        Raises:
            UsageError, InputError: as `open`; the next look tries again.
        """
        changed = self._stamps.changed(self._file, stopped)
        if not changed or stopped():
            return None
        newer = self.opener(self._base)()
        before, now = self.frames, newer.frames
        whole = not self._is_folder

        def is_another(name: str) -> bool:
            file, file_now = before.get(name), now.get(name)
            if file is None and file_now is None:
                return False
            return whole or file != file_now or file in changed

        if not any(map(is_another, {**before, **now})):  # something else was written there
            for file, stamp in changed.items():
                self._stamps.take(file, stamp)
            return None
        newer._stamps.keep(self._stamps, without=changed)
        return newer, frozenset(filter(is_another, asked))

    @property
    def origin(self) -> str:
        """The folder or file."""
        return str(self.path)

    def opener(self, base: Path | None) -> Callable[[], CameraSet]:
        """Return what opens the same set once more, as in another process, where a relative path
        may start from another folder."""
        return partial(
            CameraSet.open, self.path, self.format, self.name, self.camera_size, self.field, base
        )

    def files(self) -> Iterable[str]:
        """Every file that is read, as shown to a person."""
        return self._cameras.files()

    def camera(self, frame_name: str, size: tuple[int, int]) -> CameraForFrame | None:
        """A frame's camera for an evaluation size, or None when the set has none. `CameraError` if
        the file is damaged."""
        if frame_name not in self.frames:
            return None
        key = (frame_name, size)
        with self._lock:
            found = self._recent.get(key)
            if found is None:
                found = self._recent[key] = self._read(frame_name, size)
                while len(self._recent) > _KEPT:
                    self._recent.popitem(last=False)
            self._recent.move_to_end(key)
            return found

    def fitted_on(self, frame_name: str) -> str | None:
        """Return what a frame's camera was fitted to, see `LoadedCamera`; None of one that is
        damaged."""
        try:
            return self._cameras.read(frame_name).fitted_on
        except CameraError:
            return None

    def why_none(self, frame_name: str) -> str:
        """Why a frame has no camera, for people."""
        return f"{self.name} has no camera for {frame_name}"

    def _file(self, name: str) -> Path:
        path = from_base(self._base, self.path)
        return path / name if name and self._is_folder else path

    def _read(self, frame_name: str, size: tuple[int, int]) -> CameraForFrame:
        if self._is_folder:
            self._stamps.note(file := self.frames[frame_name], self._file(file))
        loaded = self._cameras.read(frame_name)
        camera, notice = fit_to_size(loaded, size, self.camera_size)
        remarks = [*loaded.notices, *([notice] if notice else [])]
        model = model_name(camera, loaded.model, size)
        said = "; ".join(remarks) or None
        return CameraForFrame(camera, model, said, loaded.fitted_on, loaded.assumed_field)


def _unless_since(begun: int, stamp: Stamp) -> Stamp:
    """A folder's stamp, taken after the look; None, so that the next look finds another, where
    something may have been written since the look began (ns)."""
    return stamp if stamp is not None and stamp[0] < begun - _COARSEST_NS else None


def _folders_of(files: Iterable[str]) -> set[str]:
    own = [PurePosixPath(folder) for folder in {file.rpartition("/")[0] for file in files}]
    return {str(path) for folder in own for path in (folder, *folder.parents)} - {"."}


def _name_of(path: Path) -> str:
    whole = Path(os.path.abspath(path))  # "." has no name of its own
    return whole.name if whole.is_dir() else whole.stem
