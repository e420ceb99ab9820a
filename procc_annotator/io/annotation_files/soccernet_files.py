"""Sets of SoccerNet annotations: one ``{frame}.json`` a frame, in a folder or archive."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from procc_annotator.io.annotation_files.exchange import ExchangedFrame, Reading, Writing
from procc_annotator.io.annotation_files.soccernet_annotation import (
    read_annotation,
    write_annotation,
)
from procc_annotator.io.source import FileSource


def read_many(
    source: FileSource, files: Sequence[str], reading: Reading
) -> Iterator[ExchangedFrame]:
    """Every readable annotation; sizes are those of the pictures."""
    reading.total = len(files)
    for name in files:
        with reading.going_on():
            frame = reading.frame_of_file(name)
            data = source.read(name)
            annotation = read_annotation(data, path=source.display(name), field=reading.field)
            if reading.names is not None:
                annotation = annotation.renamed(reading.class_of)
            yield ExchangedFrame(frame, annotation, reading.size_of(frame))


def write_many(frames: Iterable[ExchangedFrame], writing: Writing) -> None:
    """One file a frame; nothing is lost."""
    for frame in frames:
        data = write_annotation(frame.annotation)
        writing.put_frame_file(f"{frame.name}.json", data, frame.annotation.polylines)
