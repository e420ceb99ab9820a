"""Context shared by readers and writers of annotation formats: frames, options, remarks, pixel
numbers.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from dataclasses import field as attribute
from decimal import Context, Decimal
from fractions import Fraction
from functools import cached_property, partial
from typing import Any, Literal

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.errors import AnnotationError, InputError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import LabelMap, Rule, Shape
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.frame_names import (
    PICTURE_SUFFIX,
    FrameTable,
    PictureFrames,
    frame_of_file,
)
from procc_annotator.formats.strict_json import (
    LARGEST_EXACT,
    SMALLEST_EXACT,
    WrittenNumber,
    is_finite_number,
    is_unicode,
    json_kind,
    json_repr,
    printable,
)
from procc_annotator.messages import pluralize

# Three more, and the quotient of what is written can only round to the coordinate it came from.
_EXACT = Context(prec=20)
_PX_DECIMALS = 10  # as many as people and programs write


def normalised(px: float, extent: int) -> float:
    """The coordinate of a pixel position, ``px / extent``, rounded once.

    Args:
        px: int, float, or the number `parse_number` made.
        extent: width - 1 or height - 1, px.

    Returns:
        An int where an int divides without rest, so that a 0 stays a 0.
    """
    if type(px) is int:
        whole, rest = divmod(px, extent)
        return px / extent if rest else whole
    if isinstance(px, WrittenNumber):
        return float(Fraction(px.text) / extent)
    return px / extent


def to_px(coordinate: float, extent: int) -> float:
    """The pixel position of a coordinate, which `normalised` takes back to exactly that coordinate.

    Where no float does, the number has three digits more than a float has.
    """
    if type(coordinate) is int:
        return coordinate * extent
    px = coordinate * extent
    if (short := round(px, _PX_DECIMALS)) / extent == coordinate:
        return short  # 500.0, not 500.00000000000006
    if px / extent == coordinate or not SMALLEST_EXACT < abs(px) < LARGEST_EXACT:
        return px
    return WrittenNumber(str(_EXACT.multiply(Decimal(coordinate), Decimal(extent))))


Size = tuple[int, int]
# Under this key formats with room for foreign content keep what the annotation file held next to
# its classes. Other programs leave it alone.
EXTRA_KEY = "procc_extra"
SIZE_UNKNOWN = "the size of its picture is not known"  # why a frame is not written
_SHOWN_FRAMES = 3


@dataclass(frozen=True, slots=True)
class ExchangedFrame:
    """A frame on its way from one format to another.

    Attributes:
        name: the frame's name: the stem of its own file, or of its picture in formats that keep
            many frames in one file.
        size: (width, height) of the picture in px; None if no one knows.
        picture: file name of the picture; None if no one knows.
    """

    name: str
    annotation: FrameAnnotation
    size: Size | None = None
    picture: str | None = None


class Remarks:
    """Labels left out, joined or renamed, and in which frames."""

    def __init__(self) -> None:
        self._frames: dict[str, dict[str, None]] = {}

    def add(self, what: str, frame: str = "") -> None:
        """Note something for a frame, or for the whole set."""
        self._frames.setdefault(what, {})[frame] = None

    def take(self, others: Remarks, called: Callable[[str], str]) -> None:
        """Note the remarks of others under the names that their frames have here."""
        for what, frames in others._frames.items():
            for frame in frames:
                self.add(what, called(frame))

    def lines(self) -> list[str]:
        """One line a remark, naming the first few frames it holds for."""
        return [self._line(what, [f for f in frames if f]) for what, frames in self._frames.items()]

    def _line(self, what: str, frames: list[str]) -> str:
        if not frames:
            return what
        count = pluralize(len(frames), "frame")
        names = ", ".join(printable(name) for name in frames[:_SHOWN_FRAMES])
        more = ", …" if len(frames) > _SHOWN_FRAMES else ""
        return f"{what} ({count}: {names}{more})"


@dataclass
class ReadContext:
    """Input of a reader, and its list of problems.

    Attributes:
        field: knows the official names.
        size_of: the size in px of a frame's picture, for files that do not say it.
        names: which classes the labels of the files stand for; None: they are classes.
        in_tree: whether the files lie in a tree of folders, so that frames are called by their
            paths.
        pictures: file names of the pictures around the files in the order of their names, for files
            that count them.
        problems: one line for each frame or file that could not be used.
        unread: the same by the name of the frame, or of the file where no frame is known yet.
        remarks: what was left out or changed.
        labels: how many shapes have each label.
        unknown: the same of labels that stand for no class of the field.
        total: how many frames there are in all, as soon as it is known.
        at: the frame that is read, or the file where no frame is known yet.
        on_problem: called with what is wrong with a frame or file; what it raises ends the reading.
    """

    field: Field
    size_of: Callable[[str], Size | None] = lambda _: None
    names: LabelMap | None = None
    in_tree: bool = False
    pictures: Sequence[str] = ()
    problems: list[str] = attribute(default_factory=list)
    unread: dict[str, InputError] = attribute(default_factory=dict)
    remarks: Remarks = attribute(default_factory=Remarks)
    labels: Counter[str] = attribute(default_factory=Counter)
    unknown: Counter[str] = attribute(default_factory=Counter)
    total: int | None = None
    on_problem: Callable[[InputError], None] | None = None
    at: str = ""
    _pictures: PictureFrames | None = None

    @contextmanager
    def going_on(self) -> Iterator[None]:
        """Note what is wrong with a frame or file, and go on with the next."""
        try:
            yield
        except InputError as error:
            self.note(error)

    def note(self, error: InputError) -> None:
        """Take down what is wrong with the frame or file that is being read."""
        if self.on_problem is not None:
            self.on_problem(error)
        self.problems.append(str(error))
        self.unread.setdefault(self.at, error)

    def frame_of_file(self, file: str) -> str:
        """The frame of a file of its own; the next problem is reported of it."""
        self.at = frame_of_file(file if self.in_tree else file.rpartition("/")[2])
        return self.at

    def begin(self, file: str, pictures: Iterable[Any] = ()) -> None:
        """Go on with a file of many frames."""
        self.frame_of_file(file)
        folder = file.rpartition("/")[0] if self.in_tree else ""
        self._pictures = PictureFrames(pictures, folder, self._there)

    def frame_of_picture(self, picture: Any, path: str, place: str) -> str:
        """The frame that a picture's name in the file belongs to; whatever goes wrong next is
        reported of it. `AnnotationError` if it is no text, or cannot be the name of a frame."""
        names = self._pictures or PictureFrames(())
        self.at = names.frame(picture, path, place)
        return self.at

    def size_in_file(self, width: Any, height: Any, path: str, place: str) -> Size:
        """The size of the picture of the frame that is read: as the file says, else the picture's.

        Raises:
            AnnotationError: no picture size, or no one knows it.
        """
        size, shown = size_from_file(width, height, path, place), self.size_of(self.at)
        if size is not None and size[0] != size[1] and size[::-1] == shown:
            self.remarks.add("points of pictures as stored: EXIF data turn these pictures", self.at)
        size = size or shown
        if size is None:
            advice = "put the picture next to it, or give the size"
            problem = "does not state the size of the picture"
            raise AnnotationError(path, problem, place=place, advice=advice)
        return size

    @cached_property
    def _there(self) -> FrameTable[str]:
        return FrameTable((PICTURE_SUFFIX.sub("", name), name) for name in self.pictures)

    def rule_of(self, label: str) -> Rule | Literal[False]:
        """Return what a label stands for: its class, or what the map says (False: to be left out);
        None where nothing is said of it."""
        if self.names is not None and label.strip() in self.names.rules:
            rule = self.names.rules[label.strip()]
            return False if rule is None else rule
        name = self.field.canonical_name(label)
        return name if self.field.knows(name) else None

    def classed(self, shapes: Sequence[Shape], frame: str) -> list[Shape]:
        """The shapes of a frame with the official names of the classes that their labels stand for;
        those that are left out are missing."""
        found: list[str | None] = [label for label, _ in shapes]
        if self.names is not None:
            found, remarks = self.names.classes(shapes)
            for remark in remarks:
                self.remarks.add(remark, frame)
        classed = []
        for (label, points), name in zip(shapes, found, strict=True):
            self.labels[label.strip()] += 1
            if name is None:
                continue
            name = self.field.canonical_name(name)
            if not self.field.knows(name):
                self.unknown[label.strip()] += 1
            classed.append((name, points))
        return classed


@dataclass
class WriteContext:
    """Input of a writer, and its list of problems.

    Attributes:
        field: names, order and colours of the elements.
        put: writes one file of the output by its name; False if it may not (and says so).
        file_name: the name of the only file, when the output is a file; else None.
        line_width: of masks, px.
        folder: the split that is written: a folder inside the output that files of single frames
            go to, or part of a file's name; may be empty.
        into: content of an existing file that keeps its other entries; None without.
        problems: one line for each frame that could not be written.
        remarks: what the format cannot hold.
        frames, elements, points: how many were written.
    """

    field: Field
    put: Callable[[str, bytes], bool]
    file_name: str | None = None
    line_width: float = 4.0
    folder: str = ""
    into: Any = None
    problems: list[str] = attribute(default_factory=list)
    remarks: Remarks = attribute(default_factory=Remarks)
    frames: int = 0
    elements: int = 0
    points: int = 0

    def put_frame_file(self, name: str, data: bytes, polylines: tuple[Polyline, ...]) -> None:
        """Write the file of one frame, and count what is in it."""
        if self.put(f"{self.folder}/{name}" if self.folder else name, data):
            self.count(polylines)

    def put_only_file(self, name: str, data: bytes) -> None:
        """Write the file of the whole set, unless no frame is left for it."""
        if self.frames and not self.put(self.file_name or name, data):
            self.frames = self.elements = self.points = 0

    def count(self, polylines: tuple[Polyline, ...]) -> None:
        """One more frame was written."""
        self.frames += 1
        self.elements += sum(bool(p.points) for p in polylines)
        self.points += sum(len(p.points) for p in polylines)

    def size(self, frame: ExchangedFrame) -> Size | None:
        """The size of a frame's picture; without it the frame is a problem and None."""
        if frame.size is not None and min(frame.size) >= 2:
            return frame.size
        self.problems.append(
            f"{printable(frame.name)}: not written: {SIZE_UNKNOWN}"
            " (put the pictures next to the annotations, or give the size)"
        )
        return None

    def sized(self, frames: Iterable[ExchangedFrame]) -> Iterator[tuple[ExchangedFrame, Size]]:
        """Frames with their sizes, for a format with the frame's name in its text, which must be
        able to spell it; the others are problems."""
        for frame in frames:
            if not is_unicode(frame.name):
                why = "its name is no valid Unicode (rename the file)"
                self.problems.append(f"{printable(frame.name)}: not written: {why}")
            elif (size := self.size(frame)) is not None:
                yield frame, size

    def only_one(self, frame: ExchangedFrame, pictures: Sequence[str]) -> bool:
        """Return whether an existing file has one picture of a frame's name at most.

        With several no one knows which one is meant: the frame is a problem then.
        """
        if len(pictures) < 2:
            return True
        self.problems.append(
            f"{printable(frame.name)}: not written: the file that is written into has"
            f" {len(pictures)} pictures of this name: {', '.join(map(printable, pictures))}"
            " (rename one of them there)"
        )
        return False

    def picture(self, frame: ExchangedFrame) -> str:
        """The file name of a frame's picture, with the path of its frame; the usual one where it is
        not known."""
        if frame.picture is not None:
            folder, slash, _ = frame.name.rpartition("/")
            return frame.picture if "/" in frame.picture else folder + slash + frame.picture
        self.remarks.add("pictures were not found: their names are taken to end in .jpg")
        return f"{frame.name}.jpg"

    def picture_of_frame(self, frame: ExchangedFrame) -> str:
        """As `picture`, for formats that name frames by their pictures: the frame keeps its name.

        A labelme file may name a picture that is called otherwise, or the picture of another one.
        """
        name = self.picture(frame)
        stem = PICTURE_SUFFIX.sub("", name)
        if stem == frame.name:
            return name
        self.remarks.add("pictures that are called otherwise are named after the frame", frame.name)
        return f"{frame.name}{name[len(stem) :] or '.jpg'}"

    def lose_point_keys(self, frame: ExchangedFrame, title: str) -> None:
        """Note keys of points that the format has no place for."""
        if any(q.extra for p in frame.annotation.polylines for q in p.points):
            self.remarks.add(f"{title} has no place for further keys of points", frame.name)

    def without_empty(
        self, frame: ExchangedFrame, title: str, *, keeps_extra: bool = False
    ) -> tuple[Polyline, ...]:
        """The polylines that have points; noted as lost are the others, further keys of points, and
        further entries of the annotation file unless the format keeps these."""
        self.lose_point_keys(frame, title)
        if frame.annotation.extra and not keeps_extra:
            self.remarks.add(f"{title} has no place for further entries of a frame", frame.name)
        kept = tuple(p for p in frame.annotation.polylines if p.points)
        if len(kept) < len(frame.annotation.polylines):
            self.remarks.add(f"{title} has no place for classes without a point", frame.name)
        return kept


def size_from_file(width: Any, height: Any, path: str, place: str) -> Size | None:
    """A size from a file; None where both values are missing.

    Raises:
        AnnotationError: not two whole numbers of at least 2 px.
    """
    if width is None and height is None:
        return None
    for value in (width, height):
        if not is_finite_number(value) or value != int(value) or not 2 <= value <= 1_000_000:
            raise AnnotationError(
                path,
                f"expected width and height of the picture in px, found {json_repr(value)}",
                place=place,
                advice="correct the size",
            )
    return int(width), int(height)


def require_objects(content: Any, keys: Sequence[str], path: str, kind: str) -> dict[str, Any]:
    """A decoded file with lists of objects under some keys. `AnnotationError` if they are not."""
    for key in keys:
        entries = content.get(key) if type(content) is dict else None
        if type(entries) is not list:
            problem = f"expected a list of {key}, found {json_kind(entries)}"
            raise AnnotationError(path, problem, place=key, advice=f"is this a {kind}?")
        for i, entry in enumerate(entries):
            if type(entry) is not dict:
                problem = f"expected an object, found {json_kind(entry)}"
                advice = "correct or remove it"
                raise AnnotationError(path, problem, place=f"{key}[{i}]", advice=advice)
    return dict(content)


FrameReader = Callable[[], ExchangedFrame | None]
# Bytes, name for messages, context -> the names of all pictures of a file, what reads each frame.
FramesOf = Callable[[bytes, str, ReadContext], tuple[Sequence[Any], Sequence[FrameReader]]]


def read_files(
    source: FileSource, files: Sequence[str], reading: ReadContext, *, frames_of: FramesOf
) -> Iterator[ExchangedFrame]:
    """The frames of files that hold many each; what cannot be read is noted, frame by frame."""
    for name in files:
        with reading.going_on():
            reading.begin(name)
            pictures, readers = frames_of(source.read(name), source.display(name), reading)
            reading.begin(name, pictures)
            reading.total = (reading.total or 0) + len(readers)
            for read in readers:
                with reading.going_on():
                    if (frame := read()) is not None:
                        yield frame


def readers_by_image(
    images: Sequence[dict[str, Any]],
    found: dict[Any, list[tuple[int, dict[str, Any]]]],
    id_of: Callable[[dict[str, Any]], Any],
    read: Callable[..., ExchangedFrame | None],
    path: str,
    reading: ReadContext,
) -> tuple[list[Any], list[FrameReader]]:
    """As of `FramesOf`, for a file with a list of images and one of annotations.

    Args:
        found: id of an image -> places and content of its annotations.
    """
    readers: list[FrameReader] = []
    for i, image in enumerate(images):
        if (entries := found.pop(id_of(image), None)) is not None:
            readers.append(partial(read, image, f"images[{i}]", entries, path, reading))
    readers += (partial(_refuse_without_image, *entries[0], path) for entries in found.values())
    return [image.get("file_name") for image in images], readers


def _refuse_without_image(index: int, entry: dict[str, Any], path: str) -> None:
    raise AnnotationError(
        path,
        f"belongs to no image: {json_repr(entry.get('image_id'))}",
        place=f"annotations[{index}].image_id",
        advice="correct it, or add the image",
    )


def points_to_px(polyline: Polyline, size: Size) -> list[tuple[float, float]]:
    """Pixel positions of a polyline's points, to be written with all their digits."""
    width, height = size[0] - 1, size[1] - 1
    return [(to_px(p.u, width), to_px(p.v, height)) for p in polyline.points]
