"""Cameras of a folder, archive or file by frame name, in any format."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from os.path import splitext
from pathlib import Path, PurePosixPath
from typing import Self

from natsort import natsorted

from procc_annotator.errors import CameraError, InputError
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.fit_record import (
    LEFT_OUT_FILE,
    TABLE_FILE,
    FitDigests,
    LeftOutTables,
    folders_of,
)
from procc_annotator.formats.cameras.krt_sets import BY_ORDER
from procc_annotator.formats.cameras.loaded_camera import (
    NAME_THE_FORMAT,
    CameraRecords,
    LoadedCamera,
    field_mismatch,
    with_plausibility_remark,
)
from procc_annotator.formats.cameras.packed import PACKED_SUFFIX
from procc_annotator.formats.cameras.paired_files import paired_records
from procc_annotator.formats.cameras.registry import (
    PAIRED_FORMATS,
    PointsError,
    format_of,
    plugin_problems,
    read_camera_file,
)
from procc_annotator.formats.file_listing import CAMERA_PREFIX, camera_frame, list_cameras
from procc_annotator.formats.file_source import FileSource, open_source
from procc_annotator.formats.frame_names import PICTURE_FOLDERS, ByFrame
from procc_annotator.formats.strict_json import printable

# So many files are opened to see whether they hold one camera or several; where none of them holds
# several, nor does any other: of 20,000 files no more are opened when they are listed.
_LOOKED_INTO = 16
_SHOWN = 3  # of what was passed over
_ONE_OF_THEM = (
    "keep one of them, or choose a camera format; files of one match each belong in a folder of the"
    " match's name (game1/cameras.json)"
)


class CameraCollection:
    """Frames that have a camera, in natural order; a camera is read when asked for.

    A file of many cameras is decoded once, when it is listed.

    Attributes:
        format: one of `CAMERA_FORMATS`, or of a plug-in.
        frames: frame name -> the file its camera is in.
        remarks: about the collection, that a person should see.
        passed_over: errors of records whose frames are unknown.
        shots: frame -> its shot, in their order, where the files say so; also of frames without a
            camera.
        field: what the pictures show, where that is known: a camera that would be taken for one of
            another field cannot be read.
    """

    passed_over: Sequence[CameraError] = ()

    def __init__(
        self,
        source: FileSource,
        fmt: str = "auto",
        field: Field | None = None,
        about_to_read: Callable[[str], None] = lambda _: None,
    ) -> None:
        """List the cameras of a source, which the collection closes when it is closed.

        Args:
            about_to_read: called for each file of many cameras before it is read.

        Raises:
            UsageError: no such format.
            InputError: two files for one frame, a source that cannot be listed, or a single file
                of many cameras that cannot be read, or that holds points instead of cameras.
        """
        self.path: Path = source.path
        self.format = fmt
        self.field = field
        self._source = source
        self._about_to_read = about_to_read
        self._fitted_on = FitDigests(self._read_beside)
        self._held_out = LeftOutTables(self._read_beside)
        self.shots: dict[str, str] = {}
        self._records: dict[str, CameraRecords] = {}
        self._unreadable: list[str] = []
        files = list_cameras(source, fmt)
        self.frames: ByFrame[str] = files
        self.remarks = (*files.notices, *plugin_problems())
        if found := paired_records(PAIRED_FORMATS, source, files, fmt, about_to_read):
            self._take({own: file for own, file in files.items() if file in found}, found)
        else:
            self._look_into(files)
        self.frames.picture_folders = PICTURE_FOLDERS
        self.frames.only_folder = self._only_folder() or files.only_folder
        self.frames.unreadable = tuple(self._unreadable)

    @classmethod
    def open(
        cls,
        path: Path,
        fmt: str = "auto",
        base: Path | None = None,
        field: Field | None = None,
        about_to_read: Callable[[str], None] = lambda _: None,
    ) -> CameraCollection:
        """As above, for what is at a path (see `open_source` for what it is relative to).

        Raises:
            UsageError: nothing at the path, or no such format.
            InputError: see above.
        """
        return cls(open_source(path, base), fmt, field, about_to_read)

    @property
    def notices(self) -> tuple[str, ...]:
        """Remarks, and what was passed over."""
        said = [f"passed over: {printable(str(e), 300)}" for e in self.passed_over]
        more = [f"passed over: {len(said) - _SHOWN} more records"] if len(said) > _SHOWN else []
        return (*self.remarks, *said[:_SHOWN], *more)

    def read(self, frame: str, field: Field | None = None) -> LoadedCamera:
        """The camera of a frame of `frames`. `CameraError` if the file is damaged or gone, or would
        be taken for one of another field."""
        file = self.frames[frame]
        own = self.frames.name_there(frame) or frame
        if file in self._records:
            loaded = self._records[file].read(own)
            fitted_on = self._fitted_on.of(own, file, loaded.extra)
            return self._of_field(replace(loaded, fitted_on=fitted_on), frame, field)
        shown = self._source.display(file)
        data = self._read_file(file)
        loaded = read_camera_file(data, path=shown, fmt=self.format)
        held_out, remark = self._held_out.of(file, data)
        loaded = replace(
            loaded,
            fitted_on=self._fitted_on.of(own, file, loaded.extra, data),
            held_out=held_out,
            notices=(*loaded.notices, remark) if remark else loaded.notices,
        )
        return self._of_field(loaded, frame, field)

    def _of_field(self, loaded: LoadedCamera, frame: str, field: Field | None) -> LoadedCamera:
        field = field or self.field
        if field is not None and (problem := field_mismatch(loaded.assumed_field, field)):
            raise CameraError(self.display(frame), problem, advice=NAME_THE_FORMAT)
        return with_plausibility_remark(loaded)

    def display(self, frame: str) -> str:
        """Return how to name the camera of a frame to a person: its file, and the place in it."""
        file = self.frames[frame]
        shown = self._source.display(file)
        if file in self._records:
            own = self.frames.name_there(frame) or frame
            return f"{shown}: {printable(self._records[file].place(own))}"
        return shown

    def folders(self) -> list[str]:
        """Names of the folders at the top, for advice on what to choose."""
        return self._source.folders()

    def files(self) -> Iterable[str]:
        """Every file that is read, as shown to a person."""
        return (self._source.display(name) for name in dict.fromkeys(self.frames.values()))

    def beside(self) -> list[str]:
        """Files next to the cameras that give what they were fitted to, as names in the source."""
        folders = {folder for file in self.frames.values() for folder in folders_of(file)}
        names = {folder + name for folder in folders for name in (TABLE_FILE, LEFT_OUT_FILE)}
        return sorted(names & self._all_files)

    @cached_property
    def _all_files(self) -> frozenset[str]:
        """Those among which the cameras lie: at the top, or of the whole tree."""
        top = frozenset(self._source.files())
        return top if top.issuperset(self.frames.values()) else frozenset(self._source.tree())

    def _read_beside(self, file: str) -> bytes | None:
        try:
            return self._source.read(file) if file in self._all_files else None
        except InputError:  # gone, or damaged: it says nothing
            return None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *failure: object) -> None:
        self._source.__exit__(*failure)

    def _look_into(self, files: dict[str, str]) -> None:
        found: dict[str, CameraRecords] = {}
        left_out: set[str] = set()
        for at, (own, file) in enumerate(self._worth_a_look(files)):
            if at == _LOOKED_INTO and not found and not left_out:
                break
            try:
                records = self._many(file)
            except CameraError as error:
                # The file that was named may hold many frames, none of which is called like it.
                named = self.path.is_file() and self.path.suffix.lower() != ".zip"
                if len(files) == 1 and (isinstance(error, PointsError) or named):
                    raise
                if not format_of(file, self.format).always_many:
                    if file.endswith(PACKED_SUFFIX):
                        self._unreadable.append(own)
                    continue  # told when its frame is read
                if len(files) == 1:
                    raise
                left_out.add(file)
                self.remarks = (*self.remarks, f"passed over: {error}")
                continue
            if records is not None:
                folder = own if len(files) > 1 else ""
                # One file a match, whose frames are called by its path.
                found[file] = records.below(folder if records.shots else own.rpartition("/")[0])
        if not any("/" in own for own in files):
            found = _by_folders(found)
        if found or left_out:
            self._take({o: file for o, file in files.items() if file not in left_out}, found)

    def _worth_a_look(self, files: dict[str, str]) -> Iterator[tuple[str, str]]:
        for own, file in files.items():
            # A file called camera_* is one frame's.
            is_one = self.format == "auto" and PurePosixPath(file).name.startswith(CAMERA_PREFIX)
            has_many = format_of(file, self.format).records is not None
            if has_many and (len(files) == 1 or not is_one):
                yield own, file

    def _only_folder(self) -> str:
        """The folder, with a slash at its end, that the only file of many cameras gives all its
        pictures; empty if absent."""
        folders = [
            one.only_folder or (splitext(file)[0] if one.shots else "")  # one file a match
            for file, one in self._records.items()
        ]
        return f"{folders[0]}/" if len(folders) == 1 and folders[0] else ""

    def _many(self, file: str) -> CameraRecords | None:
        fmt = format_of(file, self.format)
        if fmt.records is None:
            return None
        self._about_to_read(file)
        return fmt.records(self._read_file(file), path=self._source.display(file))

    def _take(self, files: dict[str, str], found: dict[str, CameraRecords]) -> None:
        frames: dict[str, str] = {}
        for own, file in files.items():
            for frame in found[file].entries if file in found else (own,):
                if frame in frames:
                    raise InputError(
                        self._source.display(file),
                        f"is the second file for frame {printable(frame)!r}, after {frames[frame]}",
                        advice=_ONE_OF_THEM,
                    )
                frames[frame] = file
        self._records = found
        self.shots = {frame: s for records in found.values() for frame, s in records.shots.items()}
        in_order = found and all(records.shots for records in found.values())
        named = frames if in_order else natsorted(frames)
        self.frames = ByFrame((frame, frames[frame]) for frame in named)
        remarks = (remark for records in found.values() for remark in records.notices)
        self.remarks = (*self.remarks, *dict.fromkeys(remarks))
        self.passed_over = [e for records in found.values() for e in records.passed_over]

    def _read_file(self, file: str) -> bytes:
        try:
            return self._source.read(file)
        except CameraError:
            raise
        except InputError as error:
            raise CameraError(
                error.path, error.problem, place=error.place, advice=error.advice
            ) from error


def _by_folders(found: dict[str, CameraRecords]) -> dict[str, CameraRecords]:
    """Files of many cameras next to each other; frames are called by their paths where each file is
    of the pictures of another folder, and by the file where none names its frames."""
    if len(found) > 1 and all(BY_ORDER in records.notices for records in found.values()):
        return {f: records.below(camera_frame(f)) for f, records in found.items()}
    folders = [records.only_folder for records in found.values()]
    if len(folders) < 2 or "" in folders or len({*folders}) < len(folders):
        return found
    return {file: records.below(records.only_folder) for file, records in found.items()}
