"""SoccerNet-v3 ``Labels-v3.json``: actions and replays of one game, lines in pixels.

Facts: https://github.com/SoccerNet/SoccerNet-v3 (``dataloader.py``). Under ``actions`` and
``replays`` each picture's name has ``imageMetadata`` {width, height}, ``lines`` [{class, points:
[x1, y1, x2, y2, ...]}] and ``bboxes``; a line's class may be null.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from typing import Any

from procc_annotator.annotation import Polyline
from procc_annotator.errors import AnnotationError
from procc_annotator.formats.annotations.exchange import (
    EXTRA_KEY,
    ExchangedFrame,
    FrameReader,
    ReadContext,
    Size,
    WriteContext,
    points_to_px,
    size_from_file,
)
from procc_annotator.formats.annotations.shape_joining import ShapeCollector, extra_of, labels_for
from procc_annotator.formats.frame_names import frame_of_picture, picture_name
from procc_annotator.formats.strict_json import (
    decode_strict,
    json_kind,
    json_repr,
    json_text,
    parse_number,
    printable,
)

FILE_NAME = "Labels-v3.json"
_TITLE = "Labels-v3.json"
_GROUPS = ("actions", "replays")
_LINE_KEYS = frozenset({"class", "points"})
_ENTRY_KEYS = frozenset({"imageMetadata", "lines", EXTRA_KEY})


def sniff(content: Any) -> bool:
    """Return whether decoded JSON is such a file."""
    return (
        type(content) is dict
        and type(content.get("actions")) is dict
        and ("replays" in content or "GameMetadata" in content)
    )


def frames_of(
    data: bytes, path: str, reading: ReadContext
) -> tuple[Sequence[Any], Sequence[FrameReader]]:
    """Every picture with lines that can be read; see `FramesOf`."""
    entries = list(_entries(_decode(data, path), path))
    readers = [partial(_read, *entry, path, reading) for entry in entries]
    return [picture for picture, _, _ in entries], readers


def _decode(data: bytes, path: str) -> dict[str, Any]:
    content = decode_strict(data, path=path, error=AnnotationError, parse_float=parse_number)
    if type(content) is not dict or not any(type(content.get(g)) is dict for g in _GROUPS):
        raise AnnotationError(
            path,
            "expected an object with actions and replays",
            place="top level",
            advice="is this a Labels-v3.json?",
        )
    return content


def _entries(content: dict[str, Any], path: str) -> Iterator[tuple[str, Any, str]]:
    for group in _GROUPS:
        pictures = content.get(group)
        if pictures is None:
            continue
        if type(pictures) is not dict:
            raise AnnotationError(
                path,
                f"expected an object of pictures, found {json_kind(pictures)}",
                place=group,
                advice="correct it",
            )
        for picture, entry in pictures.items():
            yield picture, entry, f"{group}[{printable(picture)!r}]"


def _read(picture: str, entry: Any, place: str, path: str, reading: ReadContext) -> ExchangedFrame:
    frame = reading.frame_of_picture(picture, path, place)
    if type(entry) is not dict or type(entry.get("lines")) is not list:
        raise AnnotationError(
            path,
            "expected an object with a list of lines",
            place=f"{place}.lines",
            advice="correct it; a picture without lines has an empty list",
        )
    metadata = entry.get("imageMetadata")
    metadata = metadata if type(metadata) is dict else {}
    at = f"{place}.imageMetadata"
    size = reading.size_in_file(metadata.get("width"), metadata.get("height"), path, at)
    pieces = ShapeCollector(path, f"{place}.lines", reading, size, frame)
    if any(entry[key] for key in entry.keys() - _ENTRY_KEYS):
        pieces.remark("players, links and other entries of the pictures are left out")
    for i, line in enumerate(entry["lines"]):
        _add_line(pieces, line, f"{place}.lines[{i}]")
    extra = extra_of(entry.get(EXTRA_KEY), path, f"{place}.{EXTRA_KEY}", reading.field)
    return ExchangedFrame(frame, pieces.annotation(extra), size, picture_name(picture))


def _add_line(pieces: ShapeCollector, line: Any, place: str) -> None:
    values = line.get("points") if type(line) is dict else None
    if type(values) is not list or len(values) % 2:
        problem = f"expected points [x1, y1, x2, y2, ...], found {json_repr(values)}"
        raise pieces.error(problem, f"{place}.points", "correct or remove the line")
    points = tuple(
        [
            pieces.point(values[i], values[i + 1], f"{place}.points[{i}]")
            for i in range(0, len(values), 2)
        ]
    )
    if line.get("class") is None:
        pieces.remark("lines without a class are left out")
        return
    if line.keys() - _LINE_KEYS:
        pieces.remark("further keys of lines are left out")
    pieces.add(line["class"], points, f"{place}.class")


def write_many(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    """One file; every frame is an action of its own unless an existing file says otherwise."""
    content = _start(writing)
    known: dict[str, list[tuple[str, str]]] = {}
    for group in _GROUPS:
        for picture in content[group]:
            known.setdefault(frame_of_picture(picture, FILE_NAME, group), []).append(
                (group, picture)
            )
    for frame in frames:
        there = known.get(frame.name, [])
        if not writing.only_one(frame, [f"{picture} in {group}" for group, picture in there]):
            continue
        # The file's own size counts: its other entries refer to it.
        own = [_size_in(content[group][picture], picture) for group, picture in there]
        size = next(filter(None, own), None) or writing.size(frame)
        if size is None:
            continue
        writing.lose_point_keys(frame, _TITLE)
        group, picture = there[0] if there else ("actions", writing.picture_of_frame(frame))
        entry = content[group].setdefault(
            picture, {"imageMetadata": {}, "linked_replays": [], "lines": [], "bboxes": []}
        )
        if not there:
            entry["imageMetadata"] = {"width": size[0], "height": size[1]}
            content["GameMetadata"].setdefault("list_actions", []).append(picture)
        entry["lines"] = _lines(frame.annotation.polylines, size, writing)
        entry.pop(EXTRA_KEY, None)
        if frame.annotation.extra:
            entry[EXTRA_KEY] = dict(frame.annotation.extra)
        writing.count(frame.annotation.polylines)
    writing.put_only_file(FILE_NAME, f"{json_text(content, 3)}\n".encode())


def decode_existing(data: bytes, path: str) -> dict[str, Any]:
    """A file that keeps its other content. `AnnotationError` if it is of another kind."""
    content = _decode(data, path)
    for picture, entry, place in _entries(content, path):
        frame_of_picture(picture, path, place)
        if type(entry) is not dict:
            raise AnnotationError(
                path, f"expected an object, found {json_kind(entry)}", place=place, advice="mend it"
            )
    return content


def _start(writing: WriteContext) -> dict[str, Any]:
    content: dict[str, Any] = {"GameMetadata": {}, "actions": {}, "replays": {}}
    if writing.into is not None:
        content |= writing.into
    if type(content["GameMetadata"]) is not dict:
        content["GameMetadata"] = {}
    content["GameMetadata"].setdefault("list_actions", [])
    # SoccerNet's loader joins it to its folder and v3_frames/: pictures lie next to the file.
    content["GameMetadata"].setdefault("UrlLocal", "")
    return content


def _size_in(entry: dict[str, Any], place: str) -> Size | None:
    metadata = entry.get("imageMetadata")
    if type(metadata) is not dict:
        return None
    return size_from_file(metadata.get("width"), metadata.get("height"), FILE_NAME, place)


def _lines(
    polylines: tuple[Polyline, ...], size: Size, writing: WriteContext
) -> list[dict[str, Any]]:
    labels = labels_for(polylines, writing.field)
    return [
        {"class": label, "points": [value for xy in points_to_px(p, size) for value in xy]}
        for label, p in zip(labels, polylines, strict=True)
    ]
