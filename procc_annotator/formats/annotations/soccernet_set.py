"""Sets of SoccerNet annotation files and the classes SoccerNet allows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.exchange import (
    ExchangedFrame,
    ReadContext,
    Remarks,
    WriteContext,
)
from procc_annotator.formats.annotations.shape_joining import ShapeCollector
from procc_annotator.formats.annotations.soccernet import read_annotation, write_annotation
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.strict_json import printable


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
                pieces = ShapeCollector(path, "top level", reading, size, frame)
                for polyline in annotation.polylines:
                    pieces.add(polyline.class_name, polyline.points, polyline.class_name)
                annotation = pieces.annotation(annotation.extra)
            yield ExchangedFrame(frame, annotation, size)


def write_many(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    """One file a frame; nothing is lost."""
    for frame in frames:
        data = write_annotation(frame.annotation)
        writing.put_frame_file(f"{frame.name}.json", data, frame.annotation.polylines)


_ENDS, _RECTANGLE = ("left", "right"), ("main", "top", "bottom")
CLASSES = frozenset(
    [
        *(f"{size} rect. {end} {side}"
          for size in ("Big", "Small") for end in _ENDS for side in _RECTANGLE),
        *(f"Side line {side}" for side in (*_ENDS, "top", "bottom")),
        *(f"Circle {where}" for where in (*_ENDS, "central")),
        *(f"Goal {end} {part}" for end in _ENDS for part in ("crossbar", "post right")),
        "Goal left post left ",  # with its space
        "Goal right post left",
        "Middle line",
    ]
)  # fmt: skip


WITHOUT_GEOMETRY = frozenset(["Goal unknown", "Line unknown"])


def has_soccernet_classes(field: Field) -> bool:
    """Return whether a field's elements are SoccerNet's, but for optional ones."""
    own = [e.name for e in field.elements if not e.optional]
    return bool(own) and all(name in CLASSES for name in own)


def require_soccernet(field: Field, title: str) -> None:
    """Refuse a field that a format of SoccerNet's own has no words for. `UsageError` if it is
    another sport's."""
    if not has_soccernet_classes(field):
        raise UsageError(
            f"{title} is for the classes of SoccerNet, the field is {field.title};"
            " choose soccernet, labelme, cvat or coco, which hold any class"
        )


def official_only(annotation: FrameAnnotation, field: Field) -> tuple[FrameAnnotation, list[str]]:
    """An annotation without the optional elements of a field that has SoccerNet's classes.

    Landmarks are left out wherever they are, also those without a known place.

    Args:
        field: the sports field; of another sport nothing is left out, for no official evaluation
            would mind.

    Returns:
        The annotation, and the classes with points that were left out.
    """
    if not has_soccernet_classes(field):
        return annotation, []
    optional = {e.name for e in field.elements if e.optional} | field.unplaced_landmarks
    kept = tuple(p for p in annotation.polylines if p.class_name not in optional)
    if len(kept) == len(annotation.polylines):
        return annotation, []
    out = [p.class_name for p in annotation.polylines if p.class_name in optional and p.points]
    return replace(annotation, polylines=kept), out


def without_unknown_to_official(annotation: FrameAnnotation) -> tuple[FrameAnnotation, list[str]]:
    """An annotation without what the official evaluation stops at: a class it does not know, and
    entries next to the classes.

    Returns:
        The annotation, and what was left out, in words.
    """
    known = CLASSES | WITHOUT_GEOMETRY
    kept = tuple(p for p in annotation.polylines if p.class_name in known)
    names = [p.class_name for p in annotation.polylines if p.class_name not in known]
    out = [f"{printable(n)} is left out: the official evaluation stops at it" for n in names]
    for key, _ in annotation.extra:
        out.append(f"the entry {printable(key)} is left out: the official evaluation stops at it")
    return replace(annotation, polylines=kept, extra=()), out


def official_frames(
    frames: Iterable[ExchangedFrame], field: Field, remarks: Remarks
) -> Iterator[ExchangedFrame]:
    """Frames without optional elements; what is left out is noted."""
    for frame in frames:
        annotation, out = official_only(frame.annotation, field)
        for name in out:
            remarks.add(left_out_words(field, name), frame.name)
        yield replace(frame, annotation=annotation)


def left_out_words(field: Field, class_name: str) -> str:
    """Return the remark on an element that is left out."""
    return f"{field.title_of(class_name)} is left out: SoccerNet has no such class"
