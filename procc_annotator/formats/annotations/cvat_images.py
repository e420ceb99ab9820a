"""CVAT for images 1.1: one XML file with the shapes of each picture.

Facts: https://docs.cvat.ai/docs/other/xml_format (``image`` with ``id``, ``name``, ``width``,
``height`` and its shapes, each with a ``label``). A file of tracks is read as well.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from procc_annotator.annotation import Polyline
from procc_annotator.errors import AnnotationError
from procc_annotator.formats.annotations.cvat_video import read_tracks
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
    ReadContext,
    Size,
    WriteContext,
    json_text,
    size_from_file,
)
from procc_annotator.formats.annotations.shape_joining import ShapeCollector, labels_for
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.frame_names import picture_name
from procc_annotator.formats.strict_json import printable

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

FILE_NAME = "annotations.xml"
_TITLE = "CVAT"


def sniff(data: bytes) -> bool:
    """Return whether a file's bytes look like it."""
    return b"<annotations" in data[:4096]


def read_many(
    source: FileSource, files: Sequence[str], reading: ReadContext
) -> Iterator[ExchangedFrame]:
    """Every picture that has shapes, and every frame of tracks."""
    for name in files:
        with reading.going_on():
            path = source.display(name)
            reading.begin(name, () if reading.in_tree else reading.pictures)
            root = parse(source.read(name), path)
            yield from read_tracks(root, path, reading)
            images = root.findall("image")
            reading.begin(name, (image.get("name") for image in images))
            reading.total = (reading.total or 0) + len(images)
            for i, image in enumerate(images):
                with reading.going_on():
                    frame = _read(image, i, path, reading)
                    if frame is not None:
                        yield frame


def _read(image: Element, index: int, path: str, reading: ReadContext) -> ExchangedFrame | None:
    place = f"image {index + 1}"
    picture = image.get("name")
    frame = reading.frame_of_picture(picture, path, f"{place}.name")
    place = f"{place} ({printable(frame)})"
    if not len(image):
        # A task lists all its pictures: those without shapes were not annotated.
        return None
    size = size_from_file(
        whole_number(image.get("width")),
        whole_number(image.get("height")),
        path,
        f"{place}.width, height",
    ) or reading.size_of(frame)
    if size is None:
        raise AnnotationError(
            path,
            "does not tell the size of the picture",
            place=place,
            advice="put the picture beside it, or give the size",
        )
    pieces = ShapeCollector(path, place, reading, size)
    taken = False
    for i, shape in enumerate(image):
        where = f"{place}, shape {i + 1}"
        taken |= add_shape(pieces, shape, shape.get("label"), size, path, where, frame, reading)
    if not taken:
        return None
    return ExchangedFrame(frame, pieces.annotation(frame), size, picture_name(str(picture)))


def write_many(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    """``annotations.xml`` for the server, and ``labels.json`` for the labels of a new task."""
    images: list[str] = []
    kinds: dict[str, str] = {}
    for frame in frames:
        size = writing.named_size(frame)
        if size is None:
            continue
        writing.lose_point_keys(frame, _TITLE)
        writing.lose_extra(frame, _TITLE)
        polylines = tuple(
            p for p in writing.without_empty(frame, _TITLE) if is_xml_spellable(p, frame, writing)
        )
        if not polylines:
            writing.remarks.add(
                f"{_TITLE} cannot tell annotated frames without any element from others", frame.name
            )
        images.append(_image(frame, polylines, size, len(images), kinds, writing))
        writing.count(polylines)
    labels = labels_of_task(kinds, writing)
    task = ["<mode>annotation</mode>", "<overlap>0</overlap>"]
    writing.put_only_file(FILE_NAME, document(labels, images, writing, task))
    if writing.frames and writing.file_name is None:
        writing.put(LABELS_NAME, f"{json_text(labels, 1)}\n".encode())


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
