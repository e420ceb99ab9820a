"""Picture sizes of a set and the size each frame is fitted at."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Generic, NamedTuple, TypeVar

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.frames import video_frame
from procc_annotator.dataset.layout import (
    find_pictures,
    frames_folder,
    has_pictures_below,
    is_known_dataset,
    json_stems,
)
from procc_annotator.dataset.season import annotated_matches
from procc_annotator.errors import ImageError
from procc_annotator.formats.annotations.exchange import Size
from procc_annotator.formats.file_listing import ANNOTATIONS_FOLDER
from procc_annotator.formats.frame_names import PICTURE_FOLDERS, ByFrame, FrameTable
from procc_annotator.image.headers import (
    PICTURE_SUFFIXES,
    VIDEO_SUFFIXES,
    displayed_size,
    is_valid_size,
    require_valid_size,
)
from procc_annotator.messages import pluralize
from procc_annotator.regular_file import open_regular

T = TypeVar("T")


class PicturesByName(Generic[T]):
    """Names of the frames that have a picture, to find those that files say otherwise: they leave
    out the folder that only keeps pictures (``game/img1/000001`` is game/000001 to game state), or
    all folders."""

    def __init__(self, pictures: FrameTable[T]) -> None:
        """Look at nothing yet."""
        self._pictures = pictures
        self._of_stem: ByFrame[str | None] | None = None

    def called(self, frame: str) -> str:
        """The name that a frame has by its picture; its own where no picture can be meant."""
        for path in (frame, *(f"{inner}/{frame}" for inner in PICTURE_FOLDERS)):
            if (there := self._pictures.name_there(path)) is not None:
                return there
        return (None if "/" in frame else self._by_stem().get(frame)) or frame

    def _by_stem(self) -> dict[str, str | None]:
        """Frames of a tree by the last part of their name; None where several have it."""
        if self._of_stem is None:
            self._of_stem = ByFrame()
            for frame in self._pictures:
                stem = frame.rpartition("/")[2]
                self._of_stem[stem] = None if dict.__contains__(self._of_stem, stem) else frame
        return self._of_stem


class PictureSizes:
    """Pictures by frame name, in the folders around a set of annotations."""

    def __init__(
        self, folders: Iterable[Path], otherwise: Size | None = None, tree: Path | None = None
    ) -> None:
        """List the pictures.

        Args:
            folders: where they may be; earlier ones count first.
            otherwise: the size of those that are not there.
            tree: a folder that is looked through, however deep, where neither pictures nor
                annotations lie at its top.
        """
        self._paths = FrameTable[Path]()
        self._names = PicturesByName(self._paths)
        self._otherwise = otherwise
        for folder in folders:
            for inner in ("", *PICTURE_FOLDERS):
                self._list(folder / inner)
        if tree is not None and has_pictures_below(tree):
            found = find_pictures(tree)
            if found.in_tree:
                self._paths.clear()
            for frame, picture in found.frames():
                self._paths.setdefault(frame, tree / picture)

    @classmethod
    def around(
        cls, dataset: Path, annotations: Path, otherwise: Size | None = None
    ) -> PictureSizes:
        """The pictures of a dataset: of a folder those in it, next to its annotations or next to
        its ``annotations/``, or however deep below it; of an archive or a file those next to it.

        Args:
            dataset: as the user named it: a folder, archive or file.
            annotations: what its annotations are read from: the same, or a folder in it.
            otherwise: the size of those that are not there.
        """
        found = [annotations, dataset] if dataset.is_dir() else []
        whole = dataset.resolve()
        if found and whole.name != ANNOTATIONS_FOLDER:
            return cls(found, otherwise, dataset)
        tree = whole.parent if found and is_known_dataset(whole.parent) else None
        return cls([*found, whole.parent], otherwise, tree)

    def size(self, frame: str) -> Size | None:
        """(width, height) px of a frame's picture as it is shown; None if no one knows."""
        path = self._paths.get(self.called(frame))
        try:
            return picture_size(path) if path is not None else self._otherwise
        except ImageError:
            return self._otherwise

    def path(self, frame: str) -> Path | None:
        """A frame's picture, if there is one."""
        return self._paths.get(self.called(frame))

    def name(self, frame: str) -> str | None:
        """The file name of a frame's picture, with the path of the frame, if there is one."""
        path = self.path(frame)
        folder, slash, _ = frame.rpartition("/")
        return folder + slash + path.name if path is not None else None

    def called(self, frame: str) -> str:
        """As `PictureNames.called`."""
        return self._names.called(frame)

    def names(self) -> list[str]:
        """The names of the pictures, in a tree with their paths, in plain order."""
        return sorted(frame + path.suffix for frame, path in self._paths.items())

    def frames(self) -> list[str]:
        """The frames that have a picture."""
        return list(self._paths)

    def files(self) -> list[Path]:
        """The pictures that were found."""
        return list(self._paths.values())

    def _list(self, folder: Path) -> None:
        try:
            names = sorted(os.listdir(folder))
        except OSError:  # usually: no such folder
            return
        for name in names:
            stem, suffix = os.path.splitext(name)
            if suffix.lower() in PICTURE_SUFFIXES and not name.startswith("."):
                self._paths.setdefault(stem, folder / name)


def picture_size(path: Path) -> Size:
    """(width, height) px of a picture as it is shown. `ImageError` if it is not a readable picture,
    or has the shape of none."""
    size = None
    if path.is_file():
        try:
            with open_regular(path, buffering=0) as file:
                size = displayed_size(file)
        except OSError as error:
            raise ImageError(path, f"cannot be read: {error.strerror or error}") from error
    if size is None:
        from procc_annotator.image.decoding import read_size  # OpenCV: most headers tell

        size = read_size(path)
    require_valid_size(path, *size)
    return size


DEFAULT_SIZE = (960, 540)
_SIZE_KEYS = (("image_width", "image_height"), ("imageWidth", "imageHeight"), ("width", "height"))
# 1920x1088 is a picture of 1920x1080 as some encoders pad it; 4:3 and 16:10 are another shape.
_SAME_SHAPE = 0.01
_LOOKED_AT = 100
_MAX_REPORTED = 4


class FrameSize(NamedTuple):
    """Both (width, height) px.

    Attributes:
        fitted: what the frame's camera is for.
        picture: the size of its picture; None if no one knows.
    """

    fitted: Size
    picture: Size | None = None


@dataclass(frozen=True)
class FitSizes:
    """Sizes to fit at, by frame; survives the trip to a worker, which lists the pictures itself.

    Attributes:
        asked: one size for all frames; None for 960 px in the shape of each picture.
        dataset, annotations: absolute, as of `PictureSizes.around`; without them there is no
            picture.
        otherwise: the size of pictures that are not there.
    """

    asked: Size | None = None
    dataset: Path | None = None
    annotations: Path | None = None
    otherwise: Size | None = None

    @classmethod
    def of(
        cls, asked: Size | None, dataset: Path, annotations: Path, frames: Iterable[str]
    ) -> FitSizes:
        """Sizes for the frames of a set.

        Args:
            asked: one size for all frames, if any was given.
            dataset: as the user named it.
            annotations: what the annotations are read from.
            frames: their names; one without a picture is taken to have the size of the first
                picture that there is.
        """
        dataset, annotations = dataset.absolute(), annotations.absolute()
        sizes = map(_with_videos(dataset, annotations).size, frames)
        first = next((s for s in sizes if s is not None), None)
        return cls(asked, dataset, annotations, first)

    @cached_property
    def _pictures(self) -> PictureSizes:
        if self.dataset is None or self.annotations is None:
            return PictureSizes([])
        return _with_videos(self.dataset, self.annotations)

    def picture_of(self, name: str) -> Path | None:
        """The picture of a frame, if there is one."""
        return self._pictures.path(name)

    def of_frame(self, name: str, annotation: FrameAnnotation) -> FrameSize:
        """The size to fit a frame at; its picture says, or else its annotation's further
        entries."""
        told = size_in_annotation(annotation)
        if told is not None and not is_valid_size(*told):
            told = None
        picture = self._pictures.size(name) or told or self.otherwise
        if self.asked is not None:
            return FrameSize(self.asked, picture)
        return FrameSize(DEFAULT_SIZE if picture is None else fit_size_for(picture), picture)


def _with_videos(dataset: Path, annotations: Path) -> PictureSizes:
    """As `PictureSizes.around`, with the annotated frames of a video or of those of a season."""
    found = PictureSizes.around(dataset, annotations)
    videos = [(f"{match.name}/", match.pictures) for match, _ in annotated_matches(annotations)]
    beside = annotations.parent.iterdir()
    videos += [("", path) for path in beside if frames_folder(path) == annotations]
    for folder, path in videos:
        is_video = path.suffix.lower() in VIDEO_SUFFIXES
        for stem in json_stems(frames_folder(path)) if is_video else ():
            if (number := stem.removeprefix(f"{path.stem}_")).isdecimal():
                picture = video_frame(path, int(number)).image_path
                found._paths.setdefault(folder + stem, picture)
    return found


def pictures_of_another_shape(
    annotations: Path, frames: Sequence[str], sizes: Iterable[Size]
) -> list[str]:
    """Return what to know where frames are compared at fixed sizes (width, height) px and their
    pictures, looked for around their annotations, differ from it. Of many some are examined."""
    pictures = PictureSizes.around(annotations, annotations)
    looked_at = frames[:: max(1, len(frames) // _LOOKED_AT)]
    found = dict.fromkeys(size for size in map(pictures.size, looked_at) if size is not None)
    return [
        f"pictures are {_words(picture)}, compared at {_words(size)}, which has another shape"
        for size in sizes
        for picture in list(found)[:_MAX_REPORTED]
        if not same_shape(picture, size)
    ]


def size_in_annotation(annotation: FrameAnnotation) -> Size | None:
    """(width, height) px of the picture, as further entries of an annotation file give it."""
    extra = dict(annotation.extra)
    for keys in _SIZE_KEYS:
        width, height = (extra.get(key) for key in keys)
        if type(width) is int and type(height) is int and min(width, height) >= 2:
            return width, height
    return None


def fit_size_for(picture: Size) -> Size:
    """A size of the same shape that is 960 px wide."""
    width, height = picture
    return DEFAULT_SIZE[0], max(2, round(DEFAULT_SIZE[0] * height / width))


def same_shape(one: Size, other: Size) -> bool:
    """Return whether two sizes have the same ratio of width to height, to a hundredth."""
    ratio = one[0] * other[1] / (one[1] * other[0])
    return abs(ratio - 1) <= _SAME_SHAPE


@dataclass
class SizesUsed:
    """The sizes that the frames of a set were fitted at, counted."""

    asked: Size | None = None
    counts: Counter[FrameSize] = field(default_factory=Counter)

    def add(self, size: FrameSize) -> None:
        """One more frame."""
        self.counts[size] += 1

    def describe(self) -> str:
        """In words, to stand next to figures in px: ``960x540``."""
        fitted = dict.fromkeys(size.fitted for size in self.counts)
        if not fitted:
            return _words(self.asked or DEFAULT_SIZE)
        return " and ".join(map(_words, fitted)) if len(fitted) < 3 else "960 px wide"

    def remarks(self) -> list[str]:
        """Return remarks on pictures that are not 16:9, or not of the shape that was asked for."""
        frames: Counter[FrameSize] = Counter()
        for size, count in self.counts.items():
            if size.picture is not None:
                frames[size] += count
        several = len({size.picture for size in frames}) > 1
        said = []
        for size, count in frames.most_common():
            assert size.picture is not None  # see above
            which = f" ({pluralize(count, 'frame')})" if several else ""
            pictures = f"pictures are {_words(size.picture)}{which}"
            if self.asked is not None and not same_shape(size.picture, self.asked):
                said.append(
                    f"{pictures}, but fitted at {_words(self.asked)}, which has another shape:"
                    " cameras are wrong for them (leave --size out, and the pictures state it)"
                )
            elif self.asked is None and size.fitted != DEFAULT_SIZE:
                said.append(f"{pictures}: fitted at {_words(size.fitted)}")
        if len(said) > _MAX_REPORTED:
            said[_MAX_REPORTED:] = [f"and {len(said) - _MAX_REPORTED} more sizes of pictures"]
        return said


def _words(size: Size) -> str:
    return f"{size[0]}x{size[1]}"
