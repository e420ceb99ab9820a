"""The cameras of one folder, archive or file, by frame name; whatever the format."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from types import TracebackType
from typing import Self

from procc_annotator.errors import CameraError, InputError
from procc_annotator.io.cameras import read_camera_file
from procc_annotator.io.collections import list_cameras
from procc_annotator.io.loaded_camera import LoadedCamera
from procc_annotator.io.source import FileSource, open_source


class CameraCollection:
    """Frames that have a camera, in natural order; a camera is read when asked for.

    Attributes:
        path: where they are.
        format: one of `CAMERA_FORMATS`.
        frames: frame name -> the file its camera is in.
        notices: remarks about the collection that a person should see.
    """

    def __init__(self, source: FileSource, fmt: str = "auto") -> None:
        """List the cameras of a source, which the collection closes when it is closed.

        Raises:
            UsageError: no such format.
            InputError: two files for one frame, or a source that cannot be listed.
        """
        self.path: Path = source.path
        self.format = fmt
        self._source = source
        files = list_cameras(source, fmt)
        self.frames: dict[str, str] = files
        self.notices = files.notices

    @classmethod
    def open(cls, path: Path, fmt: str = "auto") -> CameraCollection:
        """As above, for what is at a path.

        Raises:
            UsageError: nothing at the path, or no such format.
            InputError: see above.
        """
        return cls(open_source(path), fmt)

    def read(self, frame: str) -> LoadedCamera:
        """The camera of a frame of `frames`.

        Raises:
            CameraError: the file is damaged or gone.
        """
        file = self.frames[frame]
        try:
            data = self._source.read(file)
        except CameraError:
            raise
        except InputError as error:
            raise CameraError(
                error.path, error.problem, place=error.place, advice=error.advice
            ) from error
        return read_camera_file(data, path=self.display(frame), fmt=self.format)

    def display(self, frame: str) -> str:
        """How to name the camera of a frame to a person: its file, and the place in it."""
        return self._source.display(self.frames[frame])

    def folders(self) -> list[str]:
        """Names of the folders at the top, for advice on what to choose."""
        return self._source.folders()

    def files(self) -> Iterable[str]:
        """Every file that is read, as shown to a person."""
        return (self._source.display(name) for name in dict.fromkeys(self.frames.values()))

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._source.__exit__(kind, error, trace)
