"""Many cameras in one file: found by frame, each read when asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import PurePosixPath
from typing import Any

from procc_annotator.errors import CameraError
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.io.frame_names import PICTURE_FOLDERS, picture_folders_of, posix_path
from procc_annotator.io.json_text import printable

_PICTURE_SUFFIXES = frozenset(
    {".jpg", ".jpeg", ".png", ".bmp", ".tif", ".tiff", ".webp", ".jp2", ".ppm", ".pgm"}
)

# Decoded content of one camera, the file, the place in it -> the camera.
ReadRecord = Callable[[Any, str, str], LoadedCamera]


@dataclass(frozen=True)
class CameraRecord:
    """One camera of a file, decoded but not yet looked at; place is where it stands."""

    place: str
    content: Any


@dataclass(frozen=True, eq=False)
class CameraRecords:
    """The cameras of one file, by frame name; a damaged one fails when it is read.

    Attributes:
        path: the file, for messages.
        entries: frame name -> what the file holds for it; more than one entry cannot be read.
        read_record: reads one entry.
        notices: remarks on parts of the file that belong to no frame.
        only_folder: that all pictures lie in by their names, while frames are called without it.
    """

    path: str
    entries: Mapping[str, tuple[CameraRecord, ...]]
    read_record: ReadRecord
    notices: tuple[str, ...] = field(default=())
    only_folder: str = ""

    @classmethod
    def of(
        cls,
        path: str,
        found: Iterable[tuple[str, CameraRecord]],
        read_record: ReadRecord,
        notices: tuple[str, ...] = (),
    ) -> CameraRecords:
        """From (picture's name, record) pairs in file order; frames are called by the last parts of
        these names, or by their paths where they lie in several folders."""
        pairs = list(found)
        folders = picture_folders_of(posix_path(name) for name, _ in pairs)
        by_path = len(folders) > 1
        only = next(iter(folders - {*PICTURE_FOLDERS}), "") if len(folders) == 1 else ""
        entries: dict[str, tuple[CameraRecord, ...]] = {}
        for name, record in pairs:
            frame = frame_of_image(name, by_path)
            entries[frame] = (*entries.get(frame, ()), record)
        return cls(path, entries, read_record, notices, only)

    def below(self, folder: str) -> CameraRecords:
        """The same cameras of frames in a folder of a tree."""
        if not folder:
            return self
        entries = {f"{folder}/{name}": found for name, found in self.entries.items()}
        return replace(self, entries=entries, only_folder="")

    def read(self, frame: str) -> LoadedCamera:
        """The camera of a frame.

        Raises:
            CameraError: it is damaged, or the frame has two.
        """
        records = self.entries[frame]
        if len(records) > 1:
            places = " and ".join(record.place for record in records[:3])
            raise CameraError(
                self.path,
                f"holds {len(records)} cameras for frame {printable(frame)!r}",
                place=places,
                advice="keep one of them; pictures of several folders are told apart by paths below"
                " the dataset",
            )
        return self.read_record(records[0].content, self.path, records[0].place)

    def place(self, frame: str) -> str:
        """Where in the file a frame's camera stands."""
        return self.entries[frame][0].place


def frame_of_image(name: str, by_path: bool = False) -> str:
    """The frame a picture's name stands for: without the suffix of a picture, and without folders
    unless it is called by its path."""
    path = PurePosixPath(posix_path(name))
    frame = path.stem if path.suffix.lower() in _PICTURE_SUFFIXES else path.name
    return str(path.parent / frame) if by_path else frame
