"""CVAT for images 1.1: one XML file with the pictures of a task and their shapes in pixels.

Facts: https://docs.cvat.ai/docs/other/xml_format (``image`` with ``id``, ``name``, ``width``,
``height``; ``polyline`` and ``points`` with ``label`` and ``points="x,y;x,y"``), and the raw label
definitions of a task (a JSON list of {name, color, type, attributes}). A server exports points with
two decimals and strips white space from the names of labels.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from procc_annotator.annotation import Point, Polyline
from procc_annotator.errors import AnnotationError
from procc_annotator.io.annotation_files.exchange import (
    ExchangedFrame,
    Reading,
    Size,
    Writing,
    picture_name,
    point_of,
    points_to_px,
    size_told,
)
from procc_annotator.io.annotation_files.pieces import Pieces, labels_for
from procc_annotator.io.annotation_files.px_numbers import json_text, number_text, parse_number
from procc_annotator.io.json_text import printable
from procc_annotator.io.source import FileSource

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

FILE_NAME = "annotations.xml"
LABELS_NAME = "labels.json"
_TITLE = "CVAT"
_GREY = "#808080"
_COURSES = frozenset({"polyline", "points", "polygon"})
_NUMBER = re.compile(r"\s*[-+]?(\d{1,64}(\.\d{0,64})?|\.\d{1,64})([eE][-+]?\d{1,4})?\s*")
_WHOLE = re.compile(r"\s*\d{1,9}\s*")
# XML 1.0 has no way to spell these.
_UNSPELLABLE = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def sniff(data: bytes) -> bool:
    """Whether a file's bytes look like it."""
    return b"<annotations" in data[:4096]


def read_many(
    source: FileSource, files: Sequence[str], reading: Reading
) -> Iterator[ExchangedFrame]:
    """Every picture that has shapes."""
    for name in files:
        with reading.going_on():
            path = source.display(name)
            reading.begin(name)
            images = _parse(source.read(name), path).findall("image")
            reading.begin(name, (image.get("name") for image in images))
            reading.total = (reading.total or 0) + len(images)
            for i, image in enumerate(images):
                with reading.going_on():
                    frame = _read(image, i, path, reading)
                    if frame is not None:
                        yield frame


def _parse(data: bytes, path: str) -> Element:
    from xml.etree.ElementTree import ParseError

    from defusedxml import ElementTree  # type: ignore[import-untyped]
    from defusedxml.common import DefusedXmlException  # type: ignore[import-untyped]

    try:
        root: Element = ElementTree.fromstring(data, forbid_dtd=True)
    except DefusedXmlException as error:
        raise AnnotationError(
            path,
            "declares entities or a document type, which no file of CVAT does",
            advice="it is not read; export it again from CVAT",
        ) from error
    except ParseError as error:
        line, column = error.position
        raise AnnotationError(
            path,
            f"is not valid XML: {str(error).partition(':')[0]}",
            place=f"line {line} column {column + 1}",
            advice="the file may be cut off: export it again",
        ) from error
    except (ValueError, LookupError) as error:  # an encoding nobody knows
        raise AnnotationError(
            path, f"is not readable XML: {printable(str(error), 120)}", advice="save it as UTF-8"
        ) from error
    if root.tag != "annotations":
        raise AnnotationError(
            path,
            f"expected <annotations>, found <{printable(root.tag)}>",
            place="top level",
            advice="is this a file of CVAT?",
        )
    if root.find("track") is not None:
        raise AnnotationError(
            path,
            "holds tracks of a video",
            place="<track>",
            advice="export the task from CVAT as “CVAT for images 1.1”",
        )
    return root


def _read(image: Element, index: int, path: str, reading: Reading) -> ExchangedFrame | None:
    place = f"image {index + 1}"
    picture = image.get("name")
    frame = reading.frame_of_picture(picture, path, f"{place}.name")
    place = f"{place} ({printable(frame)})"
    if not len(image):
        # A task lists all its pictures: those without shapes were not annotated.
        return None
    size = size_told(
        _whole(image.get("width")), _whole(image.get("height")), path, f"{place}.width, height"
    ) or reading.size_of(frame)
    if size is None:
        raise AnnotationError(
            path,
            "does not tell the size of the picture",
            place=place,
            advice="put the picture beside it, or give the size",
        )
    pieces = Pieces(path, place, reading, size)
    taken = False
    for i, shape in enumerate(image):
        taken |= _add_shape(pieces, shape, size, path, f"{place}, shape {i + 1}", frame, reading)
    if not taken:
        return None
    return ExchangedFrame(frame, pieces.annotation(frame), size, picture_name(str(picture)))


def _add_shape(
    pieces: Pieces, shape: Element, size: Size, path: str, place: str, frame: str, reading: Reading
) -> bool:
    kind = str(shape.tag)
    if kind not in _COURSES:
        reading.remarks.add(f"shapes of the type {printable(kind)} are left out", frame)
        return False
    if kind == "polygon":
        reading.remarks.add("polygons are taken for open lines through their points", frame)
    if len(shape) or shape.get("occluded", "0") != "0" or shape.get("group_id") is not None:
        reading.remarks.add("attributes, groups and occlusion of shapes are left out", frame)
    text = shape.get("points", "")
    pairs = text.split(";") if text.strip() else []
    points = tuple([_point(p, size, path, f"{place}, point {i + 1}") for i, p in enumerate(pairs)])
    pieces.add(shape.get("label"), points, f"{place}.label")
    return True


def _point(pair: str, size: Size, path: str, place: str) -> Point:
    numbers = pair.split(",")
    if len(numbers) != 2 or not all(_NUMBER.fullmatch(number) for number in numbers):
        raise AnnotationError(
            path,
            f"expected a point x,y, found {printable(pair, 40)!r}",
            place=place,
            advice="correct or remove the point",
        )
    x, y = (_number(number.strip()) for number in numbers)
    return point_of(x, y, size, path, place)


def _number(text: str) -> float:
    return int(text) if text.lstrip("+-").isdigit() and text != "-0" else parse_number(text)


def _whole(text: str | None) -> int | str | None:
    if text is None or not _WHOLE.fullmatch(text):
        return text
    return int(text)


def write_many(frames: Iterable[ExchangedFrame], writing: Writing) -> None:
    """``annotations.xml`` for the server, and ``labels.json`` for the labels of a new task."""
    images: list[str] = []
    kinds: dict[str, str] = {}
    for frame in frames:
        size = writing.size(frame)
        if size is None:
            continue
        writing.lose_point_keys(frame, _TITLE)
        writing.lose_extra(frame, _TITLE)
        polylines = tuple(
            p for p in writing.without_empty(frame, _TITLE) if _spellable(p, frame, writing)
        )
        if not polylines:
            writing.remarks.add(
                f"{_TITLE} cannot tell annotated frames without any element from others", frame.name
            )
        images.append(_image(frame, polylines, size, len(images), kinds, writing))
        writing.count(polylines)
    labels = _labels(kinds, writing)
    head = [
        '<?xml version="1.0" encoding="utf-8"?>',
        "<annotations>",
        "  <version>1.1</version>",
        *_meta(labels, len(images)),
    ]
    text = "\n".join([*head, *images, "</annotations>", ""])
    writing.put_only_file(FILE_NAME, text.encode())
    if writing.frames and writing.file_name is None:
        writing.put(LABELS_NAME, f"{json_text(labels, 1)}\n".encode())


def _spellable(polyline: Polyline, frame: ExchangedFrame, writing: Writing) -> bool:
    if _UNSPELLABLE.search(polyline.class_name) is None:
        return True
    writing.remarks.add("XML cannot spell the names of some classes: left out", frame.name)
    return False


def _image(
    frame: ExchangedFrame,
    polylines: tuple[Polyline, ...],
    size: Size,
    index: int,
    kinds: dict[str, str],
    writing: Writing,
) -> str:
    from xml.sax.saxutils import quoteattr

    name = quoteattr(writing.picture_of_frame(frame))
    lines = [f'  <image id="{index}" name={name} width="{size[0]}" height="{size[1]}">']
    for polyline, label in zip(polylines, labels_for(polylines, writing.field), strict=True):
        # The server's labels have no white space at their ends; reading puts it back.
        known = writing.field.knows(polyline.class_name)
        label = label.strip() if known else label
        kind = "points" if len(polyline.points) == 1 else "polyline"
        # A label of the type polyline takes no single point.
        kinds[label] = "any" if kinds.get(label, kind) != kind or kind == "points" else kind
        points = ";".join(
            f"{number_text(x)},{number_text(y)}" for x, y in points_to_px(polyline, size)
        )
        lines.append(
            f'    <{kind} label={quoteattr(label)} source="manual" occluded="0"'
            f' points="{points}" z_order="0">\n    </{kind}>'
        )
    return "\n".join([*lines, "  </image>"])


def _labels(kinds: dict[str, str], writing: Writing) -> list[dict[str, Any]]:
    """Every class of the field with its colour, and whatever else occurred."""
    colours = {e.name.strip(): e.colour for e in writing.field.elements}
    colours |= {name.strip(): _GREY for name in writing.field.classes_without_geometry}
    names = dict.fromkeys([*colours, *kinds])
    return [
        {
            "name": name,
            "color": colours.get(name, _GREY),
            "type": kinds.get(name, "polyline"),
            "attributes": [],
        }
        for name in names
    ]


def _meta(labels: list[dict[str, Any]], count: int) -> Iterator[str]:
    from xml.sax.saxutils import escape  # brings urllib along: not at the program's start

    yield "  <meta>"
    yield "    <task>"
    yield f"      <size>{count}</size>"
    yield "      <mode>annotation</mode>"
    yield "      <overlap>0</overlap>"
    yield "      <labels>"
    for label in labels:
        yield "        <label>"
        yield f"          <name>{escape(label['name'])}</name>"
        yield f"          <color>{label['color']}</color>"
        yield f"          <type>{label['type']}</type>"
        yield "          <attributes>"
        yield "          </attributes>"
        yield "        </label>"
    yield "      </labels>"
    yield "    </task>"
    yield "  </meta>"
