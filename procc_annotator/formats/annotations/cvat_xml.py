"""XML shared by CVAT image and video files: parsing, shapes, labels, header.

Facts: https://docs.cvat.ai/docs/other/xml_format (``polyline`` and ``points`` with
``points="x,y;x,y"``), and the raw label definitions of a task (a JSON list of {name, color, type,
attributes}). A server exports points with two decimals and strips white space from the names of
labels.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from procc_annotator.annotation import Polyline
from procc_annotator.errors import AnnotationError
from procc_annotator.formats.annotations.exchange import (
    ExchangedFrame,
    Size,
    WriteContext,
    points_to_px,
)
from procc_annotator.formats.annotations.shape_joining import ShapeCollector
from procc_annotator.formats.strict_json import number_text, parse_number, printable
from procc_annotator.formats.xml_text import parse_xml

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

LABELS_NAME = "labels.json"
_GREY = "#808080"
_COURSES = frozenset({"polyline", "points"})
# Python's \d and int() take digits of every script; no other program does.
_NUMBER = re.compile(r"\s*[-+]?(\d{1,64}(\.\d{0,64})?|\.\d{1,64})([eE][-+]?\d{1,4})?\s*", re.ASCII)
_WHOLE = re.compile(r"\s*\d{1,9}\s*", re.ASCII)
# XML 1.0 has no way to spell these.
_UNSPELLABLE = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def parse(data: bytes, path: str) -> Element:
    """The root of a file, entities and document types refused. `AnnotationError` if it is no file
    of CVAT."""
    root = parse_xml(data, path, AnnotationError, "export it again from CVAT")
    if root.tag != "annotations":
        raise AnnotationError(
            path,
            f"expected <annotations>, found <{printable(root.tag)}>",
            place="top level",
            advice="is this a file of CVAT?",
        )
    return root


def add_shape(pieces: ShapeCollector, shape: Element, label: str | None, place: str) -> bool:
    """Add a shape if it is a course of points, and note what is left out of it.

    Raises:
        AnnotationError: its points or its label cannot be read.
    """
    if not pieces.takes(str(shape.tag), _COURSES):
        return False
    if len(shape) or shape.get("occluded", "0") != "0" or shape.get("group_id") is not None:
        pieces.remark("attributes, groups and occlusion of shapes are left out")
    text = shape.get("points", "")
    points = []
    for i, pair in enumerate(text.split(";") if text.strip() else []):
        numbers, at = pair.split(","), f"{place}, point {i + 1}"
        if len(numbers) != 2 or not all(_NUMBER.fullmatch(number) for number in numbers):
            raise pieces.error(f"expected a point x,y, found {printable(pair, 40)!r}", at)
        x, y = (_number(number.strip()) for number in numbers)
        points.append(pieces.point(x, y, at))
    pieces.add(label, tuple(points), f"{place}.label")
    return True


def _number(text: str) -> float:
    return int(text) if text.lstrip("+-").isdigit() and text != "-0" else parse_number(text)


def whole_number(text: str | None) -> int | str | None:
    """A whole number of a file; any other text unchanged."""
    if text is None or not _WHOLE.fullmatch(text):
        return text
    return int(text)


def is_xml_spellable(polyline: Polyline, frame: ExchangedFrame, writing: WriteContext) -> bool:
    """Return whether XML has a way to spell a class; if not, it is noted."""
    if _UNSPELLABLE.search(polyline.class_name) is None:
        return True
    writing.remarks.add("XML cannot spell the names of some classes: left out", frame.name)
    return False


def kind_of_shape(polyline: Polyline) -> str:
    """Return what a polyline is to CVAT."""
    return "points" if len(polyline.points) == 1 else "polyline"


def server_label(
    polyline: Polyline, label: str, writing: WriteContext, kinds: dict[str, str]
) -> str:
    """A label as the server keeps it; its kind of shapes is noted for `labels_of_task`."""
    # The server's labels have no white space at their ends; reading puts it back.
    label = label.strip() if writing.field.knows(polyline.class_name) else label
    kind = kind_of_shape(polyline)
    # A label of the type polyline takes no single point.
    kinds[label] = "any" if kinds.get(label, kind) != kind or kind == "points" else kind
    return label


def points_text(polyline: Polyline, size: Size) -> str:
    """The points of a shape."""
    return ";".join(f"{number_text(x)},{number_text(y)}" for x, y in points_to_px(polyline, size))


def labels_of_task(kinds: dict[str, str], writing: WriteContext) -> list[dict[str, Any]]:
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


def document(
    labels: list[dict[str, Any]], entries: list[str], writing: WriteContext, task: Sequence[str]
) -> bytes:
    """The whole file."""
    meta = _meta(labels, writing.frames, task)
    head = ['<?xml version="1.0" encoding="utf-8"?>', "<annotations>", "  <version>1.1</version>"]
    return "\n".join([*head, *meta, *entries, "</annotations>", ""]).encode()


def _meta(labels: list[dict[str, Any]], count: int, task: Sequence[str]) -> Iterator[str]:
    from xml.sax.saxutils import escape  # brings urllib along: not at the program's start

    yield "  <meta>"
    yield "    <task>"
    yield f"      <size>{count}</size>"
    yield from (f"      {line}" for line in task)
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
