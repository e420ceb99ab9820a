"""The table of annotation formats: names, what they can hold, how they are told, read, written."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import Any, Literal

from procc_annotator.errors import InputError, UsageError
from procc_annotator.io.annotation_files import (
    coco,
    cvat,
    cvat_tracks,
    labelme,
    masks,
    soccernet_files,
    soccernet_gsr,
    soccernet_v3,
    yolo_pose,
)
from procc_annotator.io.annotation_files.exchange import ExchangedFrame, Reading, Writing
from procc_annotator.io.collections import (
    CAMERA_PREFIX,
    OWN_FILES,
    list_annotations,
    list_frame_files,
)
from procc_annotator.io.source import FileSource

Reader = Callable[[FileSource, Sequence[str], Reading], Iterator[ExchangedFrame]]
Writer = Callable[[Iterable[ExchangedFrame], Writing], None]
Classes = Literal["any", "leaning", "soccernet"]
# Of a folder of thousands of files so many are looked into.
_LOOKED_INTO = 20


@dataclass(frozen=True)
class AnnotationFormat:
    """One way annotations are kept in files.

    Attributes:
        name: on the command line.
        title: shown to people.
        one_file: name of the only file of a set; empty where every frame has its own.
        in_pixels: whether the size of the pictures is needed.
        holds: what survives, in words (points always survive to the last digit).
        loses: what does not.
        write: writes a set.
        read: reads a set; None for formats that are only written.
        sniff_json: whether decoded JSON is of this format.
        sniff: whether bytes are.
        decode_existing: reads a file whose other content is to be kept; None where that is
            not possible.
        classes: whose classes it is for: ``any`` field's, ``soccernet`` for SoccerNet's alone, or
            ``leaning`` where optional elements beside SoccerNet's classes are left out unless they
            are asked for.
        pictures: the folder of the output that pictures go to when they are asked for, with the
            split's place in it; None for formats that go without.
        split: what is written when nobody names a split.
    """

    name: str
    title: str
    one_file: str
    in_pixels: bool
    holds: str
    loses: str
    write: Writer
    read: Reader | None = None
    sniff_json: Callable[[Any], bool] | None = None
    sniff: Callable[[bytes], bool] | None = None
    decode_existing: Callable[[bytes, str], Any] | None = None
    classes: Classes = "any"
    pictures: str | None = "{split}"
    split: str = ""


LABELME = "labelme"
PLAIN = "soccernet"  # what this program works on

FORMATS: tuple[AnnotationFormat, ...] = (
    AnnotationFormat(
        "soccernet", "SoccerNet-calibration JSON", "", False,
        "everything", "optional elements, unless they are asked for",
        soccernet_files.write_many, soccernet_files.read_many,
        sniff_json=lambda content: type(content) is dict, classes="leaning",
    ),
    AnnotationFormat(
        "soccernet-v3", "SoccerNet-v3 (Labels-v3.json)", soccernet_v3.FILE_NAME, True,
        "order, unknown and repeated classes, classes without a point",
        "further keys of points; optional elements, unless they are asked for",
        soccernet_v3.write_many, soccernet_v3.read_many,
        sniff_json=soccernet_v3.sniff, decode_existing=soccernet_v3.decode_existing,
        classes="soccernet", pictures="v3_frames",
    ),
    AnnotationFormat(
        "soccernet-gsr", "SoccerNet game state (Labels-GameState.json)",
        soccernet_gsr.FILE_NAME, False,
        "everything", "optional elements, unless they are asked for",
        soccernet_gsr.write_many, soccernet_gsr.read_many,
        sniff_json=soccernet_gsr.sniff, decode_existing=soccernet_gsr.decode_existing,
        classes="soccernet", pictures="img1",
    ),
    AnnotationFormat(
        LABELME, "labelme JSON", "", True,
        "order, unknown and repeated classes",
        "classes without a point, further keys of points",
        labelme.write_many, labelme.read_many, sniff_json=labelme.sniff,
    ),
    AnnotationFormat(
        "cvat", "CVAT for images 1.1 XML", cvat.FILE_NAME, True,
        "order, unknown and repeated classes",
        "classes without a point, further keys of points and frames, frames without an element",
        cvat.write_many, cvat.read_many, sniff=cvat.sniff, pictures="images",
    ),
    AnnotationFormat(
        "cvat-video", "CVAT for video 1.1 XML (tracks)", cvat_tracks.FILE_NAME, True,
        "unknown and repeated classes; the order of those of a first frame",
        "classes without a point, further keys of points and frames, frames without an element",
        cvat_tracks.write_many, cvat.read_many, pictures="images",
    ),
    AnnotationFormat(
        "coco", "COCO keypoints JSON", coco.FILE_NAME, True,
        "order, unknown and repeated classes, classes without a point",
        "further keys of points, frames without an element",
        coco.write_many, coco.read_many, sniff_json=coco.sniff,
        pictures="images/{split}", split=coco.DEFAULT_SPLIT,
    ),
    AnnotationFormat(
        "yolo-pose", "YOLO pose (text files)", "", True,
        "the order of points inside the picture", "the rest: the files are not read back",
        yolo_pose.write_many, pictures="images/{split}", split=yolo_pose.DEFAULT_SPLIT,
    ),
    AnnotationFormat(
        "masks", "segmentation masks (PNG)", "", True,
        "pictures of the lines", "the clicks: masks are not read back",
        masks.write_many, pictures=None,
    ),
)  # fmt: skip


NAMES: tuple[str, ...] = tuple(f.name for f in FORMATS)
READABLE: tuple[str, ...] = tuple(f.name for f in FORMATS if f.read is not None)


def format_named(name: str) -> AnnotationFormat:
    """A format by its name.

    Raises:
        UsageError: there is none.
    """
    for known in FORMATS:
        if known.name == name:
            return known
    raise UsageError(f"no annotation format {name!r}; there are {', '.join(NAMES)}")


def find_annotations(source: FileSource, fmt: str = "auto") -> tuple[AnnotationFormat, list[str]]:
    """The format of a source and the files to be read, in natural order.

    Args:
        source: a folder, an archive or a file.
        fmt: a name of `READABLE`, or ``auto`` to look into the files.

    Raises:
        UsageError: no annotation, annotations of several formats, or a format that is only written.
        InputError: two files for one frame, or a source that cannot be listed.
    """
    known = _told_format(source) if fmt == "auto" else format_named(fmt)
    if known.read is None:
        raise UsageError(f"{known.title} can only be written, not read")
    if known.name == PLAIN:
        files = list(list_annotations(source).values())
    elif not known.one_file:
        files = list(list_frame_files(source).values())
    elif PurePosixPath(known.one_file).suffix == ".xml":
        files = _xml_files(source)
    else:
        files = [
            name for name in _json_files(source)
            if fmt != "auto" or _sniffed(source, name) in (known, None)
        ]  # fmt: skip
    if not files:
        raise UsageError(f"nothing to do: no annotation ({known.title}) in {source.path}")
    return known, files


def _told_format(source: FileSource) -> AnnotationFormat:
    files = _json_files(source)[:_LOOKED_INTO] + _xml_files(source)[:_LOOKED_INTO]
    told = {known.name: known for known in (_sniffed(source, n) for n in files) if known}
    if len(told) > 1:
        raise UsageError(
            f"{source.path}: holds annotations of several formats ({', '.join(told)}):"
            " choose the one to be read"
        )
    if told:
        return next(iter(told.values()))
    if not files:
        raise UsageError(f"nothing to do: no annotation in {source.path}")
    # All of them are damaged: the reader says how.
    return format_named("cvat" if files[0].lower().endswith(".xml") else "soccernet")


def _sniffed(source: FileSource, name: str) -> AnnotationFormat | None:
    """The format of one file; None where it cannot be told."""
    try:
        data = source.read(name)
    except InputError:
        return None
    if name.lower().endswith(".xml"):
        return next((f for f in FORMATS if f.sniff is not None and f.sniff(data)), None)
    try:
        content = json.loads(data.decode("utf-8-sig"))
    except (ValueError, RecursionError):
        return None
    # The plainest format takes any object, so it is asked last.
    return next((f for f in reversed(FORMATS) if f.sniff_json and f.sniff_json(content)), None)


def _json_files(source: FileSource) -> list[str]:
    return [
        name for name in source.files()
        if name.lower().endswith(".json")
        and PurePosixPath(name).name not in OWN_FILES
        and not PurePosixPath(name).name.startswith(CAMERA_PREFIX)
    ]  # fmt: skip


def _xml_files(source: FileSource) -> list[str]:
    return [name for name in source.files() if name.lower().endswith(".xml")]
