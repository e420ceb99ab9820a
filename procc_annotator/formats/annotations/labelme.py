"""labelme JSON files: shapes with labels and pixel coordinates.

Facts: https://github.com/wkentaro/labelme (``labelme/_label_file.py``). labelme keeps top-level
keys it does not know, refuses shapes without points, and reads the picture that ``imagePath``
names next to the file when ``imageData`` is null.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from procc_annotator.errors import AnnotationError
from procc_annotator.formats.annotations.exchange import (
    EXTRA_KEY,
    ExchangedFrame,
    ReadContext,
    WriteContext,
    points_to_px,
)
from procc_annotator.formats.annotations.shape_joining import ShapeCollector, extra_of, labels_for
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.frame_names import picture_name
from procc_annotator.formats.strict_json import decode_strict, json_kind, json_text, parse_number

_TITLE = "labelme"
_VERSION = "5.5.0"  # the release whose layout is written; labelme asks for the key
_COURSES = frozenset({"linestrip", "line", "point"})
_KNOWN_KEYS = frozenset({
    "version", "flags", "shapes", "imagePath", "imageData", "imageHeight", "imageWidth", EXTRA_KEY,
})  # fmt: skip


def sniff(content: Any) -> bool:
    """Return whether decoded JSON is a labelme file."""
    return type(content) is dict and type(content.get("shapes")) is list


def read_many(
    source: FileSource, files: Sequence[str], reading: ReadContext
) -> Iterator[ExchangedFrame]:
    """Every readable file; its name is the frame's."""
    reading.total = len(files)
    for name in files:
        with reading.going_on():
            frame = reading.frame_of_file(name)
            yield _read(source.read(name), source.display(name), frame, reading)


def _read(data: bytes, path: str, frame: str, reading: ReadContext) -> ExchangedFrame:
    content = decode_strict(data, path=path, error=AnnotationError, parse_float=parse_number)
    if type(content) is not dict or type(content.get("shapes")) is not list:
        raise AnnotationError(
            path,
            "expected an object with a list of shapes",
            place="shapes",
            advice="is this a file of labelme?",
        )
    width, height = content.get("imageWidth"), content.get("imageHeight")
    size = reading.size_in_file(width, height, path, "imageWidth, imageHeight")
    pieces = ShapeCollector(path, "shapes", reading, size, frame)
    for i, shape in enumerate(content["shapes"]):
        _add_shape(pieces, shape, f"shapes[{i}]")
    if content.keys() - _KNOWN_KEYS or content.get("flags"):
        pieces.remark("flags and other entries of the files are left out")
    extra = extra_of(content.get(EXTRA_KEY), path, EXTRA_KEY, reading.field)
    picture = content.get("imagePath")
    picture = picture_name(picture) if type(picture) is str and picture else None
    return ExchangedFrame(frame, pieces.annotation(extra), size, picture)


def _add_shape(pieces: ShapeCollector, shape: Any, place: str) -> None:
    if type(shape) is not dict or type(shape.get("points")) is not list:
        problem = f"expected a shape with label and points, found {json_kind(shape)}"
        raise pieces.error(problem, place, "correct or remove the shape")
    if not pieces.takes(shape.get("shape_type") or "polygon", _COURSES):  # as the oldest files
        return
    if shape.get("group_id") is not None or shape.get("description") or shape.get("flags"):
        pieces.remark("groups, descriptions and flags of shapes are left out")
    points = pieces.course(shape["points"], f"{place}.points")
    pieces.add(shape.get("label"), points, f"{place}.label")


def write_many(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    """One file a frame, to be put next to the pictures."""
    for frame, size in writing.sized(frames):
        polylines = writing.without_empty(frame, _TITLE, keeps_extra=True)
        shapes: list[dict[str, Any]] = [
            {
                "label": label,
                "points": [list(xy) for xy in points_to_px(polyline, size)],
                "group_id": None,
                "description": "",
                "shape_type": "point" if len(polyline.points) == 1 else "linestrip",
                "flags": {},
                "mask": None,
            }
            for label, polyline in zip(labels_for(polylines, writing.field), polylines, strict=True)
        ]
        content: dict[str, Any] = {
            "version": _VERSION,
            "flags": {},
            "shapes": shapes,
            "imagePath": picture_name(writing.picture(frame)),
            "imageData": None,
            "imageHeight": size[1],
            "imageWidth": size[0],
        }
        if frame.annotation.extra:
            content[EXTRA_KEY] = dict(frame.annotation.extra)
        text = f"{json_text(content)}\n"
        writing.put_frame_file(f"{frame.name}.json", text.encode(), polylines)
