"""Annotations of any format, read as one set: the one way in for the window and the commands."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from dataclasses import field as attribute

from procc_annotator.errors import AnnotationError, InputError
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.annotation_formats import (
    PLAIN,
    AnnotationFormat,
    find_annotations,
)
from procc_annotator.io.annotation_files.exchange import (
    ExchangedFrame,
    ReadContext,
    Size,
)
from procc_annotator.io.annotation_files.label_map import LabelMap
from procc_annotator.io.annotation_files.soccernet_classes import require_soccernet
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.json_text import printable
from procc_annotator.io.source import FileSource

Progress = Callable[[int, int], None]


def _unknown_size(_: str) -> None:
    return None


def _name_in_file(frame: str) -> str:
    return frame


@dataclass
class ReadSet:
    """What was read.

    Attributes:
        title: of the format.
        frames: name -> what is annotated in it, with the size of its picture if anybody knows it.
        problems: one line for each frame or file that could not be used.
        unread: of those problems the ones of a frame or file, by its name.
        losses: what was left out or changed, one line each.
        unknown: labels that stand for no class of the field, and how many shapes have them.
        files: what it was read from, by their names in the source.
    """

    title: str
    frames: dict[str, ExchangedFrame] = attribute(default_factory=dict)
    problems: list[str] = attribute(default_factory=list)
    unread: dict[str, InputError] = attribute(default_factory=dict)
    losses: list[str] = attribute(default_factory=list)
    unknown: Mapping[str, int] = attribute(default_factory=dict)
    files: tuple[str, ...] = ()


class SetReader:
    """One pass over a source of annotations; what went wrong is known when it is over.

    Attributes:
        format: what the files are.
        files: their names in the source.
        reading: what was noted on the way.
    """

    def __init__(
        self,
        source: FileSource,
        field: Field,
        names: LabelMap | None = None,
        *,
        fmt: str = "auto",
        size_of: Callable[[str], Size | None] = _unknown_size,
        pictures: Sequence[str] = (),
        called: Callable[[str], str] = _name_in_file,
    ) -> None:
        """Look what there is to read.

        Args:
            source: a folder, an archive or a file.
            field: knows the official names.
            names: which classes the labels of the files stand for.
            fmt: a name of `FORMATS` that can be read, or ``auto`` to look into the files.
            size_of: the size in px of a frame's picture, for files that do not say it.
            pictures: names of the pictures around the files, as of `ReadContext`.
            called: the name that a frame of the files has in the dataset.

        Raises:
            UsageError: no annotation, annotations of several formats, or of another sport.
            InputError: the source cannot be listed.
        """
        self._called = called
        self.format: AnnotationFormat
        self.format, self.files = find_annotations(source, fmt)
        if self.format.classes == "soccernet":
            require_soccernet(field, self.format.title)
        self._source = source
        in_tree = not set(self.files) <= set(source.files())
        self.reading = ReadContext(field, size_of, names, in_tree, pictures)
        self._strays = list_annotations(source).notices if self.format.name == PLAIN else ()

    def frames(self, progress: Progress | None = None) -> Iterator[ExchangedFrame]:
        """The frames as they come, each name once: the first one stays.

        Args:
            progress: called with frames done and frames in all.
        """
        assert self.format.read is not None  # `find_annotations` sees to that
        reading = self.reading
        seen: dict[str, str | None] = {}
        frames = self.format.read(self._source, self.files, reading)
        for done, frame in enumerate(frames, start=1):
            if progress is not None:
                progress(done, max(done, reading.total or 0))
            if (name := self._called(frame.name)) != frame.name:
                frame = replace(frame, name=name)
            if frame.name in seen:
                both = (frame.picture, seen[frame.name])
                pictures = " beside ".join(map(printable, filter(None, both)))
                of = f", of {pictures}" if all(both) else ""
                reading.note(
                    AnnotationError(
                        printable(frame.name),
                        f"a second annotation of this frame{of}",
                        advice="rename one of the pictures",
                    )
                )
                continue
            seen[frame.name] = frame.picture
            yield frame

    @property
    def losses(self) -> list[str]:
        """What was left out or changed, one line each."""
        reading = self.reading
        names = reading.names
        unmet = names.unmet(reading.labels, reading.unknown) if names is not None else ()
        return [*self._strays, *unmet, *reading.remarks.lines()]


def read_set(
    source: FileSource,
    field: Field,
    names: LabelMap | None = None,
    *,
    fmt: str = "auto",
    size_of: Callable[[str], Size | None] = _unknown_size,
    pictures: Sequence[str] = (),
    called: Callable[[str], str] = _name_in_file,
    progress: Progress | None = None,
) -> ReadSet:
    """All annotations of a source, of any format.

    Args: as of `SetReader`; progress as of `SetReader.frames`.

    Raises:
        UsageError: no annotation, annotations of several formats, or of another sport.
        InputError: the source cannot be listed.
    """
    reader = SetReader(
        source, field, names, fmt=fmt, size_of=size_of, pictures=pictures, called=called
    )
    found = ReadSet(reader.format.title, files=tuple(reader.files))
    for frame in reader.frames(progress):
        found.frames[frame.name] = frame
    found.problems = reader.reading.problems
    found.unread = {called(name): error for name, error in reader.reading.unread.items()}
    found.losses, found.unknown = reader.losses, dict(reader.reading.unknown.most_common())
    return found
