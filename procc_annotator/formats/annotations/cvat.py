"""CVAT 1.1 XML: shapes of each picture, or a track per element of a video.

Facts: https://docs.cvat.ai/docs/other/xml_format. ``image`` has ``id``, ``name``, ``width``,
``height`` and its shapes, each with a ``label``; ``track`` has ``label``, its shapes ``frame``,
``keyframe`` and ``outside``. A shape of a track holds until its next one; between key frames CVAT
interpolates, and exports what it interpolated with ``keyframe="0"``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import partial
from itertools import count
from pathlib import PurePosixPath
from typing import TYPE_CHECKING, Any

from procc_annotator.annotation import Polyline
from procc_annotator.errors import AnnotationError
from procc_annotator.formats.annotations.cvat_xml import (
    LABELS_NAME,
    add_shape,
    document,
    is_xml_spellable,
    kind_of_shape,
    labels_of_task,
    parse,
    points_text,
    server_label,
    whole_number,
)
from procc_annotator.formats.annotations.exchange import (
    ExchangedFrame,
    FrameReader,
    ReadContext,
    Size,
    WriteContext,
    size_from_file,
)
from procc_annotator.formats.annotations.shape_joining import ShapeCollector, labels_for
from procc_annotator.formats.frame_names import picture_name
from procc_annotator.formats.strict_json import json_text, printable

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    Shapes = list[tuple[Element, str | None, str]]  # with their label and place

FILE_NAME = "annotations.xml"
_TITLE = "CVAT"
_OF_VIDEO = re.compile(r"(.+)_(\d{6,8})")  # as frames of a video are called


def sniff(data: bytes) -> bool:
    """Return whether a file's bytes look like it."""
    return b"<annotations" in data[:4096]


def frames_of(
    data: bytes, path: str, reading: ReadContext
) -> tuple[Sequence[Any], Sequence[FrameReader]]:
    """Every picture that has shapes, and every frame of tracks; see `FramesOf`."""
    root = parse(data, path)
    images = root.findall("image")
    readers = _readers_of_tracks(root, path, reading)
    readers += (partial(_read_image, image, i, path, reading) for i, image in enumerate(images))
    pictures = () if reading.in_tree else reading.pictures
    return [image.get("name") for image in images] or pictures, readers


def _read_image(
    image: Element, index: int, path: str, reading: ReadContext
) -> ExchangedFrame | None:
    place = f"image {index + 1}"
    picture = image.get("name")
    frame = reading.frame_of_picture(picture, path, f"{place}.name")
    place = f"{place} ({printable(frame)})"
    if not len(image):
        # A task lists all its pictures: those without shapes were not annotated.
        return None
    size = reading.size_in_file(
        whole_number(image.get("width")),
        whole_number(image.get("height")),
        path,
        f"{place}.width, height",
    )
    pieces = ShapeCollector(path, place, reading, size, frame)
    taken = False
    for i, shape in enumerate(image):
        where = f"{place}, shape {i + 1}"
        taken |= add_shape(pieces, shape, shape.get("label"), where)
    if not taken:
        return None
    return ExchangedFrame(frame, pieces.annotation(), size, picture_name(str(picture)))


def write_images(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    """``annotations.xml`` for the server, and ``labels.json`` for the labels of a new task."""
    images: list[str] = []
    kinds: dict[str, str] = {}
    for frame, size in writing.sized(frames):
        polylines = _spellable(frame, writing)
        images.append(_image(frame, polylines, size, len(images), kinds, writing))
        writing.count(polylines)
    labels = labels_of_task(kinds, writing)
    task = ["<mode>annotation</mode>", "<overlap>0</overlap>"]
    _put_document(images, labels, writing, task)


def _put_document(
    entries: list[str], labels: list[dict[str, Any]], writing: WriteContext, task: list[str]
) -> None:
    writing.put_only_file(FILE_NAME, document(labels, entries, writing, task))
    if writing.frames and writing.file_name is None:
        writing.put(LABELS_NAME, f"{json_text(labels, 1)}\n".encode())


def _spellable(frame: ExchangedFrame, writing: WriteContext) -> tuple[Polyline, ...]:
    """The polylines of a frame that the files can hold; what is lost is noted."""
    polylines = tuple(
        p for p in writing.without_empty(frame, _TITLE) if is_xml_spellable(p, frame, writing)
    )
    if not polylines:
        writing.remarks.add(
            f"{_TITLE} cannot distinguish annotated frames without any element from others",
            frame.name,
        )
    return polylines


def _image(
    frame: ExchangedFrame,
    polylines: tuple[Polyline, ...],
    size: Size,
    index: int,
    kinds: dict[str, str],
    writing: WriteContext,
) -> str:
    from xml.sax.saxutils import quoteattr

    name = quoteattr(writing.picture_of_frame(frame))
    lines = [f'  <image id="{index}" name={name} width="{size[0]}" height="{size[1]}">']
    for polyline, label in zip(polylines, labels_for(polylines, writing.field), strict=True):
        label, kind = server_label(polyline, label, writing, kinds), kind_of_shape(polyline)
        lines.append(
            f'    <{kind} label={quoteattr(label)} source="manual" occluded="0"'
            f' points="{points_text(polyline, size)}" z_order="0">\n    </{kind}>'
        )
    return "\n".join([*lines, "  </image>"])


def _readers_of_tracks(root: Element, path: str, reading: ReadContext) -> list[FrameReader]:
    """Of every frame in which any track has a key frame, with all that is seen there."""
    shapes: dict[int, Shapes] = {}
    keys: set[int] = set()
    for i, track in enumerate(root.findall("track")):
        for j, shape in enumerate(track):
            place = f"track {i + 1}, shape {j + 1}"
            number = _number(shape.get("frame"), path, f"{place}.frame")
            if shape.get("outside") != "1":
                shapes.setdefault(number, []).append((shape, track.get("label"), place))
                keys |= {number} if shape.get("keyframe", "1") == "1" else set()
    if len(keys) < len(shapes):
        reading.remarks.add("frames that CVAT interpolated from end to end are left out")
    size = _size(root, path) if shapes else None
    return [partial(_frame, n, shapes[n], size, root, path, reading) for n in sorted(keys)]


def _number(text: str | None, path: str, place: str) -> int:
    number = whole_number(text)
    if type(number) is not int:
        raise AnnotationError(
            path,
            f"expected the number of a frame, found {printable(str(text), 40)!r}",
            place=place,
            advice="correct it, or export the task again",
        )
    return number


def _size(root: Element, path: str) -> Size | None:
    told = root.find("meta//original_size")
    if told is None:
        return None
    width, height = told.findtext("width"), told.findtext("height")
    return size_from_file(whole_number(width), whole_number(height), path, "original_size")


def _frame(
    number: int, shapes: Shapes, size: Size | None, root: Element, path: str, reading: ReadContext
) -> ExchangedFrame:
    picture = _picture(number, root, path, reading)
    frame = reading.frame_of_picture(picture, path, f"frame {number}")
    size = size or reading.size_in_file(None, None, path, "meta.original_size")
    pieces = ShapeCollector(path, f"frame {number}", reading, size, frame)
    for shape, label, place in shapes:
        if shape.get("keyframe", "1") != "1":
            pieces.remark("points that CVAT interpolated are taken as they are")
        add_shape(pieces, shape, label, place)
    return ExchangedFrame(frame, pieces.annotation(), size, picture)


def _picture(number: int, root: Element, path: str, reading: ReadContext) -> str:
    """The picture of a frame: of a video, of the pictures around the file, or as CVAT calls it."""
    video = root.findtext("meta//source")
    if video:
        return f"{PurePosixPath(picture_name(video)).stem}_{number:06d}.png"
    if not reading.pictures:
        return f"frame_{number:06d}.png"
    if number >= len(reading.pictures):
        raise AnnotationError(
            path,
            f"there are {len(reading.pictures)} pictures, the first of them has the number 0",
            place=f"frame {number}",
            advice="put all pictures of the task next to it",
        )
    return reading.pictures[number]


def write_tracks(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    """``annotations.xml`` for the server, and ``labels.json`` for the labels of a new task."""
    kept = [frame for frame, _ in writing.sized(frames)]
    video, numbers = _numbered(kept, writing)
    size = kept[0].size if kept else None
    tracks: dict[tuple[str, str], dict[int, Polyline]] = {}
    labels: dict[tuple[str, str], str] = {}
    kinds: dict[str, str] = {}
    for number, frame in sorted(zip(numbers, kept, strict=True), key=lambda pair: pair[0]):
        if frame.size != size:
            writing.problems.append(
                f"{printable(frame.name)}: not written: a video has pictures of one size"
            )
            continue
        polylines = _spellable(frame, writing)
        for polyline, label in zip(polylines, labels_for(polylines, writing.field), strict=True):
            track = polyline.class_name, kind_of_shape(polyline)
            labels[track] = server_label(polyline, label, writing, kinds)
            tracks.setdefault(track, {})[number] = polyline
        writing.count(polylines)
    if size is None or not writing.frames:
        return
    last = max(numbers) if video is None else None
    entries = [
        _track(i, labels[track], track[1], shapes, size, last)
        for i, (track, shapes) in enumerate(tracks.items())
    ]
    _put(entries, labels_of_task(kinds, writing), (video, numbers, size), writing)


def _put(
    entries: list[str],
    labels: list[dict[str, object]],
    of: tuple[str | None, list[int], Size],
    writing: WriteContext,
) -> None:
    from xml.sax.saxutils import escape

    video, numbers, size = of
    task = [
        "<mode>interpolation</mode>",
        "<overlap>0</overlap>",
        "<start_frame>0</start_frame>",
        f"<stop_frame>{max(numbers)}</stop_frame>",
        f"<original_size><width>{size[0]}</width><height>{size[1]}</height></original_size>",
        *([f"<source>{escape(video)}</source>"] if video else []),
    ]
    _put_document(entries, labels, writing, task)


def _numbered(frames: list[ExchangedFrame], writing: WriteContext) -> tuple[str | None, list[int]]:
    """The video that frames are of, and their numbers in it; those of pictures are their places in
    the order of a task, which is that of their names."""
    found = [_OF_VIDEO.fullmatch(frame.name) for frame in frames]
    videos = {match[1] for match in found if match}
    if len(videos) == 1 and all(found):
        return f"{videos.pop()}.mp4", [int(match[2]) for match in found if match]
    writing.remarks.add(
        "pictures are numbered in the order of their names: the task must have just these pictures"
    )
    places = dict(zip(sorted(map(writing.picture_of_frame, frames)), count(), strict=False))
    return None, [places[writing.picture_of_frame(frame)] for frame in frames]


def _track(
    number: int,
    label: str,
    kind: str,
    shapes: dict[int, Polyline],
    size: Size,
    last: int | None,
) -> str:
    """A track with a key frame wherever it is annotated, and nowhere else anything to be seen.

    After the last picture of a task there is no frame; how long a video is no one knows.
    """
    from xml.sax.saxutils import quoteattr

    lines = [f'  <track id="{number}" label={quoteattr(label)} source="manual">']
    for frame, polyline in shapes.items():
        points = points_text(polyline, size)
        lines.append(_shape(kind, frame, points, outside=False))
        if frame + 1 not in shapes and frame != last:  # or CVAT would go on with it
            lines.append(_shape(kind, frame + 1, points, outside=True))
    return "\n".join([*lines, "  </track>"])


def _shape(kind: str, frame: int, points: str, *, outside: bool) -> str:
    return (
        f'    <{kind} frame="{frame}" keyframe="1" outside="{int(outside)}" occluded="0"'
        f' points="{points}" z_order="0">\n    </{kind}>'
    )
