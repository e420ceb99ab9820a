"""Sets of SoccerNet annotations: one ``{frame}.json`` a frame, in a folder or archive."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from procc_annotator.io.annotation_files.exchange import ExchangedFrame, ReadContext, WriteContext
from procc_annotator.io.annotation_files.pieces import ShapeCollector
from procc_annotator.io.annotation_files.soccernet_annotation import (
    read_annotation,
    write_annotation,
)
from procc_annotator.io.source import FileSource


def read_many(
    source: FileSource, files: Sequence[str], reading: ReadContext
) -> Iterator[ExchangedFrame]:
    """Every readable annotation; sizes are those of the pictures."""
    reading.total = len(files)
    for name in files:
        with reading.going_on():
            frame = reading.frame_of_file(name)
            data = source.read(name)
            path, size = source.display(name), reading.size_of(frame)
            annotation = read_annotation(data, path=path, field=reading.field)
            if reading.names is not None:
                pieces = ShapeCollector(path, "top level", reading, size)
                for polyline in annotation.polylines:
                    pieces.add(polyline.class_name, polyline.points, polyline.class_name)
                annotation = pieces.annotation(frame, annotation.extra)
            yield ExchangedFrame(frame, annotation, size)


def write_many(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    """One file a frame; nothing is lost."""
    for frame in frames:
        data = write_annotation(frame.annotation)
        writing.put_frame_file(f"{frame.name}.json", data, frame.annotation.polylines)
