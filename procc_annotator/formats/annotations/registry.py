"""Table of annotation formats (detection, reader, writer) and reading a set in any of them."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from dataclasses import field as attribute
from functools import partial
from pathlib import PurePosixPath
from typing import Any, Literal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import AnnotationError, InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations import (
    coco,
    cvat,
    labelme,
    masks,
    soccernet_gsr,
    soccernet_set,
    soccernet_v3,
    yolo_pose,
)
from procc_annotator.formats.annotations.exchange import (
    ExchangedFrame,
    ReadContext,
    Size,
    WriteContext,
    read_files,
)
from procc_annotator.formats.annotations.label_map import LabelMap
from procc_annotator.formats.annotations.labelling_tools import TOOLS, decode_lines, is_via_table
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.annotations.soccernet_set import require_soccernet
from procc_annotator.formats.file_listing import (
    files_of,
    is_other_json,
    list_annotations,
    list_frame_files,
    may_be_annotation,
)
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.strict_json import printable

Reader = Callable[[FileSource, Sequence[str], ReadContext], Iterator[ExchangedFrame]]
Writer = Callable[[Iterable[ExchangedFrame], WriteContext], None]
Classes = Literal["any", "leaning", "soccernet"]
# Of a folder of thousands of files so many are looked into.
_LOOKED_INTO = 20
LINE_SUFFIXES = (".ndjson", ".jsonl")  # of files with one JSON value a line


@dataclass(frozen=True)
class AnnotationFormat:
    """One way annotations are kept in files.

    Attributes:
        name: on the command line.
        one_file: name of the only file of a set; empty where every frame has its own.
        in_pixels: whether the size of the pictures is needed.
        holds: what survives, in words (points always survive to the last digit).
        loses: what does not.
        read: reads a set; None for formats that are only written.
        sniff_json: whether decoded JSON is of this format.
        sniff: whether bytes are.
        decode_existing: reads a file that keeps its other content; None where that is not possible.
        classes: the field it is for: ``any`` field's, ``soccernet`` for SoccerNet's alone, or
            ``leaning`` where optional elements next to SoccerNet's classes are left out unless they
            are asked for.
        pictures: the folder of the output that pictures go to when they are asked for, with the
            split's place in it; None for formats that go without.
        split: what is written when no one names a split.
        by_game: whether its one file is that of a game, so that a tree has one in each folder.
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
    by_game: bool = False


def _only_read(frames: Iterable[ExchangedFrame], writing: WriteContext) -> None:
    raise UsageError("this format can only be read, not written")


LABELME = "labelme"
PLAIN = "soccernet"  # what this program works on

FORMATS: tuple[AnnotationFormat, ...] = (
    AnnotationFormat(
        "soccernet", "SoccerNet-calibration JSON", "", False,
        "everything", "optional elements, unless they are asked for",
        soccernet_set.write_many, soccernet_set.read_many,
        sniff_json=lambda content: type(content) is dict, classes="leaning",
    ),
    AnnotationFormat(
        "soccernet-v3", "SoccerNet-v3 (Labels-v3.json)", soccernet_v3.FILE_NAME, True,
        "order, unknown and repeated classes, classes without a point",
        "further keys of points; optional elements, unless they are asked for",
        soccernet_v3.write_many, partial(read_files, frames_of=soccernet_v3.frames_of),
        sniff_json=soccernet_v3.sniff, decode_existing=soccernet_v3.decode_existing,
        classes="soccernet", pictures="v3_frames", by_game=True,
    ),
    AnnotationFormat(
        "soccernet-gsr", "SoccerNet game state (Labels-GameState.json)",
        soccernet_gsr.FILE_NAME, False,
        "everything", "optional elements, unless they are asked for",
        soccernet_gsr.write_many, partial(read_files, frames_of=soccernet_gsr.frames_of),
        sniff_json=soccernet_gsr.sniff, decode_existing=soccernet_gsr.decode_existing,
        classes="soccernet", pictures="img1", by_game=True,
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
        cvat.write_images, partial(read_files, frames_of=cvat.frames_of), sniff=cvat.sniff,
        pictures="images",
    ),
    AnnotationFormat(
        "cvat-video", "CVAT for video 1.1 XML (tracks)", cvat.FILE_NAME, True,
        "unknown and repeated classes; the order of those of a first frame",
        "classes without a point, further keys of points and frames, frames without an element",
        cvat.write_tracks, partial(read_files, frames_of=cvat.frames_of), pictures="images",
    ),
    AnnotationFormat(
        "coco", "COCO keypoints JSON", coco.FILE_NAME, True,
        "order, unknown and repeated classes, classes without a point",
        "further keys of points, frames without an element",
        coco.write_many, partial(read_files, frames_of=coco.frames_of), sniff_json=coco.sniff,
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
    *(
        AnnotationFormat(
            tool.name, tool.title, tool.example, True, "nothing: it is not written", "all",
            _only_read, partial(read_files, frames_of=tool.frames_of), sniff_json=tool.sniff,
        )
        for tool in TOOLS
    ),
)  # fmt: skip
WRITTEN = tuple(known for known in FORMATS if known.write is not _only_read)
NAMES: tuple[str, ...] = tuple(f.name for f in FORMATS)


def format_named(name: str) -> AnnotationFormat:
    """A format by its name. `UsageError` if there is none."""
    for known in FORMATS:
        if known.name == name:
            return known
    raise UsageError(f"no annotation format {name!r}; there are {', '.join(NAMES)}")


def find_annotations(source: FileSource, fmt: str = "auto") -> tuple[AnnotationFormat, list[str]]:
    """The format of a source and the files to be read, in natural order.

    Raises:
        UsageError: no annotation, annotations of several formats, or a format that is only written.
        InputError: two files for one frame, or a source that cannot be listed.
    """
    known = _one_format(source) if fmt == "auto" else format_named(fmt)
    if known.read is None:
        raise UsageError(f"{known.title} can only be written, not read")
    if known.name == PLAIN:
        files = list(list_annotations(source).values())
    elif not known.one_file:
        files = list(list_frame_files(source).values())
    elif PurePosixPath(known.one_file).suffix == ".xml":
        files = [name for name in _files(source) if _is_xml(name)]
    else:
        files = [
            name for name in _files(source)
            if not _is_xml(name)
            and (fmt != "auto" or _detect_file(source, name) is known or _is_damaged(source, name))
        ]  # fmt: skip
    if not files:
        raise UsageError(f"nothing to do: no annotation ({known.title}) in {source.path}")
    return known, files


def read_plain(data: bytes, path: str, field: Field) -> FrameAnnotation:
    """A frame's annotation of this program, as of `read_annotation`; what is one of another format
    is reported so. `AnnotationError` if it cannot be used."""
    try:
        return read_annotation(data, path=path, field=field)
    except AnnotationError as error:
        told = detect_json_format(data)
        if told is None or told.name == PLAIN:
            raise
        raise AnnotationError(
            path,
            f"is {told.title}, expected {format_named(PLAIN).title}",
            advice="procc-annotator convert IN OUT --to soccernet writes it so; the window takes it"
            " in with File > Import annotations",
        ) from error


def detect_formats(source: FileSource) -> list[AnnotationFormat]:
    """The formats of the first files of a source; none where there is no file that holds any."""
    told = _detected(source, _files(source))
    return list({known.name: known for known in told if known}.values())


def _detected(source: FileSource, files: Sequence[str]) -> list[AnnotationFormat | None]:
    json_files = [name for name in files if not _is_xml(name)][:_LOOKED_INTO]
    xml_files = [name for name in files if _is_xml(name)][:_LOOKED_INTO]
    return [_detect_file(source, name) for name in (*json_files, *xml_files)]


def _one_format(source: FileSource) -> AnnotationFormat:
    told = detect_formats(source)
    # What was taken in from a file of a whole set, frame by frame, stands for it from then on.
    if any(known.name == PLAIN for known in told):
        told = [known for known in told if not known.one_file]
    if len(told) > 1:
        raise UsageError(
            f"{source.path}: holds annotations of several formats"
            f" ({', '.join(known.name for known in told)}): choose the one to be read"
        )
    if told:
        return told[0]
    files = sorted(_files(source), key=_is_xml)
    if not files:
        raise UsageError(f"nothing to do: no annotation in {source.path}")
    # All of them are damaged: the reader says how.
    lines = files[0].lower().endswith(LINE_SUFFIXES)
    return format_named("cvat" if _is_xml(files[0]) else "labelbox" if lines else "soccernet")


def _detect_file(source: FileSource, name: str) -> AnnotationFormat | None:
    try:
        data = source.read(name)
    except InputError:
        return None
    if _is_xml(name):
        return next((f for f in FORMATS if f.sniff is not None and f.sniff(data)), None)
    return detect_json_format(data)


def detect_json_format(data: bytes) -> AnnotationFormat | None:
    """The format of JSON, or of VIA's table; None if undetermined."""
    if is_via_table(data):
        return format_named("via")
    content = _decoded(data)
    if is_other_json(content):
        return next(
            (f for f in FORMATS if f.one_file and f.sniff_json and f.sniff_json(content)), None
        )
    # The plainest format takes any object, so it is asked last.
    return next((f for f in reversed(FORMATS) if f.sniff_json and f.sniff_json(content)), None)


def _decoded(data: bytes) -> Any:
    try:
        return json.loads(data.decode("utf-8-sig"))
    except (ValueError, RecursionError):
        pass
    try:  # one value a line, or a table
        return decode_lines(data, "", lambda _: None)
    except InputError:
        return None


def _is_damaged(source: FileSource, name: str) -> bool:
    try:
        return _decoded(source.read(name)) is None
    except InputError:
        return True


def _files(source: FileSource) -> list[str]:
    """The JSON and XML files that may be annotations; those of a tree where all files at its top
    are of another kind."""
    if source.path.suffix.lower() == ".csv" and source.files():
        return list(source.files())  # beside annotations a table is of something else
    names, in_tree = files_of(source, _may_be_annotations)
    if in_tree or not names or any(_detected(source, names)):
        return names
    if any(_is_damaged(source, name) for name in names[:_LOOKED_INTO]):
        return names
    deeper = [n for n in source.tree() if "/" in n and _may_be_annotations(n.rpartition("/")[2])]
    return deeper or names


def _may_be_annotations(name: str) -> bool:
    is_json = name.lower().endswith((".json", *LINE_SUFFIXES))
    return _is_xml(name) or (is_json and may_be_annotation(name))


def _is_xml(name: str) -> bool:
    return name.lower().endswith(".xml")


Progress = Callable[[int, int], None]


@dataclass
class ReadSet:
    """Content that was read.

    Attributes:
        frames: name -> what is annotated in it, with the size of its picture if anyone knows it.
        problems: one line for each frame or file that could not be used.
        unread: of those problems the ones of a frame or file, by its name.
        losses: what was left out or changed, one line each.
        unknown: labels that stand for no class of the field, and how many shapes have them.
        files: what it was read from, by their names in the source.
    """

    title: str
    frames: dict[str, ExchangedFrame] = attribute(default_factory=dict)
    problems: list[str] = attribute(default_factory=list)
    unread: dict[str, InputError] = attribute(default_factory=dict)
    losses: list[str] = attribute(default_factory=list)
    unknown: Mapping[str, int] = attribute(default_factory=dict)
    files: tuple[str, ...] = ()


class SetReader:
    """One pass over a source of annotations; what went wrong is known when it is over.

    Attributes:
        reading: what was noted on the way.
    """

    def __init__(
        self,
        source: FileSource,
        field: Field,
        names: LabelMap | None = None,
        *,
        fmt: str = "auto",
        size_of: Callable[[str], Size | None] = lambda _: None,
        pictures: Sequence[str] = (),
        called: Callable[[str], str] = lambda frame: frame,
    ) -> None:
        """Look what there is to read.

        Args:
            pictures: names of the pictures around the files, as of `ReadContext`.
            called: the name that a frame of the files has in the dataset.

        Raises:
            UsageError: no annotation, annotations of several formats, or of another sport.
            InputError: the source cannot be listed.
        """
        self._called = called
        self.format: AnnotationFormat
        self.format, self.files = find_annotations(source, fmt)
        if self.format.classes == "soccernet":
            require_soccernet(field, self.format.title)
        self._source = source
        in_tree = not set(self.files) <= set(source.files())
        self.reading = ReadContext(field, size_of, names, in_tree, pictures)
        self._strays = list_annotations(source).notices if self.format.name == PLAIN else ()

    def frames(self, progress: Progress | None = None) -> Iterator[ExchangedFrame]:
        """The frames as they come, each name once: the first one stays; progress is called with
        frames done and frames in all."""
        assert self.format.read is not None  # `find_annotations` sees to that
        reading = self.reading
        seen: dict[str, str | None] = {}
        frames = self.format.read(self._source, self.files, reading)
        for done, frame in enumerate(frames, start=1):
            if progress is not None:
                progress(done, max(done, reading.total or 0))
            if (name := self._called(frame.name)) != frame.name:
                frame = replace(frame, name=name)
            if frame.name in seen:
                both = (frame.picture, seen[frame.name])
                pictures = " beside ".join(map(printable, filter(None, both)))
                of = f", of {pictures}" if all(both) else ""
                reading.note(
                    AnnotationError(
                        printable(frame.name),
                        f"a second annotation of this frame{of}",
                        advice="rename one of the pictures",
                    )
                )
                continue
            seen[frame.name] = frame.picture
            yield frame

    @property
    def losses(self) -> list[str]:
        """Return what was left out or changed, one line each."""
        reading = self.reading
        names = reading.names
        unmet = names.unmet(reading.labels, reading.unknown) if names is not None else ()
        return [*self._strays, *unmet, *reading.remarks.lines()]

    def read_all(self, progress: Progress | None = None) -> ReadSet:
        """All frames at once; progress as of `frames`."""
        found = ReadSet(self.format.title, files=tuple(self.files))
        for frame in self.frames(progress):
            found.frames[frame.name] = frame
        found.problems = self.reading.problems
        found.unread = {self._called(name): e for name, e in self.reading.unread.items()}
        found.losses, found.unknown = self.losses, dict(self.reading.unknown.most_common())
        return found
