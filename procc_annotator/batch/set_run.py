"""Base of a pass over the frames of a set in chunks; reopenable sources for workers.

A task is sent to anyone who does the work; results come in the order of the frames.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import partial
from itertools import compress
from pathlib import Path
from typing import Any, Generic, NamedTuple, Protocol, TypeVar

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.execution.executor import Executor, InProcess, Work
from procc_annotator.batch.unit_store import UnitStore, hex_digest, stamp_of_file
from procc_annotator.dataset.diagnostics import found_instead_of_annotations, refuse_cameras
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.registry import read_plain
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_listing import AnnotationFiles, list_annotations, require_lists
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.frame_names import ByFrame

# Frames a worker takes at once where each gets a fit: about half a second's work.
CHUNK = 16
# Below this many fits starting processes costs more than it saves.
WORTH_WORKERS = 200


class NamedFrame(Protocol):
    """A worker's input for a frame, with its name."""

    @property
    def name(self) -> str: ...


class FrameFile(NamedTuple):
    """A frame's name, and its annotation file in the source."""

    name: str
    file: str


T = TypeVar("T")
F = TypeVar("F", bound=NamedFrame | str)
R = TypeVar("R")
S = TypeVar("S")


class SetRun(Generic[F, R, S]):
    """One pass over a set; iterate it once. What a frame fails with is among its results.

    Attributes:
        frames: what a worker is called for each frame.
        task: what it does with a chunk of them: their results in order, and what they sum up to.
        executor: who does the work; this process unless another one is put here.
        chunk: frames a worker takes at once. It belongs to the task, not to the machine: sums of
            other chunks may differ in their last digit.
    """

    chunk: int = CHUNK

    def __init__(
        self,
        frames: Sequence[F],
        task: Callable[[Sequence[F]], tuple[list[R], S]],
        executor: Executor | None = None,
    ) -> None:
        self.frames = frames
        self.task = task
        self.executor = executor or InProcess()

    @property
    def total(self) -> int:
        """Number of frames, i.e. of results to come."""
        return len(self.frames)

    @property
    def names(self) -> tuple[str, ...]:
        """The frames, in the order they come."""
        return tuple(map(_name_of, self.frames))

    def __iter__(self) -> Iterator[R]:
        chunks = [self.frames[i : i + self.chunk] for i in range(0, self.total, self.chunk)]
        for results, sums in self._pieces(chunks):
            self._take(results, sums)
            yield from results

    def _pieces(self, chunks: list[Sequence[F]]) -> Iterator[tuple[list[R], S]]:
        """Results and sums of the chunks, in their order."""
        yield from self.executor.map(Work(self.task, chunks, frames_in_words))

    def _take(self, results: Sequence[R], sums: S) -> None:
        """Add what a chunk brought, in the order of the chunks."""


class CheckpointedRun(SetRun[F, R, S], ABC):
    """A pass that can keep the results of its chunks and take those of an earlier run.

    Attributes:
        kept: what was done before, and where what is done now is kept; None keeps nothing.
    """

    kept: UnitStore | None = None

    def _pieces(self, chunks: list[Sequence[F]]) -> Iterator[tuple[list[R], S]]:
        if self.kept is None:
            yield from super()._pieces(chunks)
            return
        keys = [self._digest(chunk) for chunk in chunks]
        missing = [key not in self.kept for key in keys]  # once: results come in this order
        made = super()._pieces(list(compress(chunks, missing)))
        for chunk, key, is_missing in zip(chunks, keys, missing, strict=True):
            if is_missing:
                results, sums = next(made)
                self.kept.add(key, results)
                yield results, sums
            elif (found := self.kept.result(key)) is not None:
                yield found, self._sums_of(found)
            else:  # damaged on the disk
                yield self.task(chunk)

    @abstractmethod
    def _digest(self, chunk: Sequence[F]) -> str:
        """Return a digest of the frames of a chunk and of the contents of their files."""

    @abstractmethod
    def _sums_of(self, results: Sequence[R]) -> S:
        """Return what the results of a chunk sum up to."""


def frames_in_words(chunk: Sequence[NamedFrame | str]) -> str:
    """Return how a chunk of frames is called where something happens to its worker."""
    first, last = _name_of(chunk[0]), _name_of(chunk[-1])
    return f"frame {first}" if len(chunk) == 1 else f"frames {first} to {last}"


def _name_of(frame: NamedFrame | str) -> str:
    return frame if isinstance(frame, str) else frame.name


class ReopenableHandle(Generic[T]):
    """Source that a task reads: open here, and opened once more where the task is sent to.

    Args:
        opening: opens it; survives the trip to a worker.
        here: what is open in this process; anyone who opened it closes it.
    """

    def __init__(self, opening: Callable[[], T], here: T | None = None) -> None:
        self._opening = opening
        self._here = here

    @property
    def opened(self) -> T:
        """Return what is open in this process, from the first time it is asked for."""
        if self._here is None:
            self._here = self._opening()
        return self._here

    def close(self) -> None:
        """Close what is open, as a worker does that needs it no more."""
        here, self._here = self._here, None
        if isinstance(here, AbstractContextManager):
            here.__exit__(None, None, None)

    def __reduce__(self) -> tuple[Any, ...]:
        return ReopenableHandle, (self._opening,)


def reopenable_source(source: FileSource) -> ReopenableHandle[FileSource]:
    """A source of files, for a task; paths are relative to the folder this process works in."""
    return ReopenableHandle(source.opener(Path.cwd()), source)


def reopenable_cameras(cameras: CameraCollection) -> ReopenableHandle[CameraCollection]:
    """The same of cameras."""
    opening = partial(CameraCollection.open, cameras.path, cameras.format, Path.cwd())
    return ReopenableHandle(opening, cameras)


@dataclass(frozen=True)
class AnnotationTask:
    """Base of tasks on chunks of annotation files.

    Attributes:
        annotations: folder or archive.
    """

    annotations: ReopenableHandle[FileSource]

    def read(self, file: str, field: Field) -> FrameAnnotation:
        """The annotation in a file of the source.

        Raises:
            InputError: it cannot be used.
        """
        source = self.annotations.opened
        data, shown = source.read(file), source.display(file)
        annotation = read_plain(data, shown, field)
        require_lists(annotation, shown)
        return annotation

    def input_digest(
        self, chunk: Sequence[FrameFile], pictures: Callable[[str], Path | None]
    ) -> str:
        """Return what distinguishes the work on a chunk from any other, for `SetRun`.

        Args:
            chunk: frames and their files.
            pictures: where a frame's picture is, which may give its size.
        """
        parts: list[object] = []
        for name, file in chunk:
            picture = pictures(name)
            try:
                data: object = self.annotations.opened.read(file)
            except InputError as error:
                data = f"unreadable: {error}"
            parts += [name, data, "" if picture is None else stamp_of_file(picture)]
        return hex_digest(*parts)

    def close(self) -> None:
        """Close what a worker opened."""
        self.annotations.close()


def annotation_files(source: FileSource) -> list[FrameFile]:
    """The frames of a set with their files.

    Raises:
        UsageError: there are none.
    """
    return [FrameFile(name, file) for name, file in require_annotations(source).items()]


def annotations_for(cameras: ByFrame[str], source: FileSource) -> AnnotationFiles:
    """As `require_annotations`; frames of an only folder are called by their paths where cameras
    of a whole tree are."""
    files = require_annotations(source)
    return files.by_path() if files.is_part_of(cameras) else files


def frames_of_all(names: Iterable[str], methods: Iterable[ByFrame[str]]) -> dict[str, None]:
    """The names of frames, and of those that only some methods have, each once."""
    found = dict.fromkeys(names)
    for frames in methods:  # which may call the same frames otherwise
        known = {frames.name_there(name) for name in found}
        found |= dict.fromkeys(name for name in frames if name not in known)
    return found


def require_annotations(source: FileSource) -> AnnotationFiles:
    """The same, by name."""
    files = list_annotations(source)
    if not files:
        raise UsageError(
            f"nothing to do: no annotation in {source.path}"
            f"{found_instead_of_annotations(source) or choice_of(source)}"
        )
    refuse_cameras(source, list(files.values()))
    return files


def ambiguous_folders(sources: Iterable[tuple[Path, ByFrame[str]]]) -> tuple[str, ...]:
    """Return what is to say where the only folders that frames of several sources lie in are called
    differently: they may be of several annotators, or of several matches.

    Args:
        sources: where each is, and its frames. One whose only folder is called like itself
            (``alice/`` in ``alice.zip``) says nothing of a match.
    """
    folders = {
        files.only_folder: path
        for path, files in sources
        if files.only_folder and files.only_folder.rstrip("/") not in (path.stem, path.name)
    }
    if len(folders) < 2:
        return ()
    places = " and ".join(f"{path}/{folder}" for folder, path in folders.items())
    return (
        f"files in {places} are taken as the same frames: no pictures show whether they are"
        " several matches",
    )


def choice_of(source: FileSource | CameraCollection) -> str:
    """Return what to choose from where several splits lie in one place."""
    folders = source.folders()
    if len(folders) < 2:
        return ""
    return f"; it holds {len(folders)} folders ({', '.join(folders[:5])}), choose one"
