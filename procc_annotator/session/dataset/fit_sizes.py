"""The picture size that each frame of a set is fitted at: a fit in the wrong shape is wrong."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import ImageError
from procc_annotator.image.header import is_valid_size
from procc_annotator.image.suffixes import VIDEO_SUFFIXES
from procc_annotator.io.annotation_files.exchange import Size
from procc_annotator.session.dataset.dataset_folder import frames_folder
from procc_annotator.session.dataset.picture_sizes import (
    PictureSizes,
    picture_folders,
    picture_tree,
)
from procc_annotator.words import count_words

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
        picture: the size of its picture; None if nobody knows.
    """

    fitted: Size
    picture: Size | None = None


@dataclass(frozen=True)
class FitSizes:
    """Sizes to fit at, by frame; survives the trip to a worker, which lists the pictures itself.

    Attributes:
        asked: one size for all frames; None for 960 px in the shape of each picture.
        folders: where the pictures may be, absolute; earlier ones count first.
        otherwise: the size of pictures that are not there.
        tree: absolute; looked through where those folders hold no picture.
    """

    asked: Size | None = None
    folders: tuple[Path, ...] = ()
    otherwise: Size | None = None
    tree: Path | None = None

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
                picture that there is, or of the video that the frames are of.
        """
        folders = tuple(f.absolute() for f in picture_folders(dataset, annotations))
        tree = picture_tree(dataset)
        tree = None if tree is None else tree.absolute()
        pictures = PictureSizes(folders, tree=tree)
        sizes = (pictures.size(name) for name in frames)
        first = next((s for s in sizes if s is not None), None)
        return cls(asked, folders, first or _size_of_video(annotations.absolute()), tree)

    @cached_property
    def _pictures(self) -> PictureSizes:
        return PictureSizes(self.folders, tree=self.tree)

    def picture_of(self, name: str) -> Path | None:
        """The picture of a frame, if there is one."""
        return self._pictures.path(name)

    def of_frame(self, name: str, annotation: FrameAnnotation) -> FrameSize:
        """The size to fit a frame at; its picture tells, or else its annotation file.

        Args:
            name: of the frame.
            annotation: whose further entries may tell the picture's size.
        """
        told = size_in_annotation(annotation)
        if told is not None and not is_valid_size(*told):
            told = None
        picture = self._pictures.size(name) or told or self.otherwise
        if self.asked is not None:
            return FrameSize(self.asked, picture)
        return FrameSize(DEFAULT_SIZE if picture is None else fit_size_for(picture), picture)


def pictures_of_another_shape(
    annotations: Path, frames: Sequence[str], sizes: Iterable[Size]
) -> list[str]:
    """What to know where frames are compared at a fixed size and their pictures differ from it.

    Args:
        annotations: what they are read from; pictures are looked for around it.
        frames: names; of many some are looked at.
        sizes: (width, height) px that are compared at.
    """
    folders = picture_folders(annotations, annotations)
    pictures = PictureSizes(folders, tree=picture_tree(annotations))
    looked_at = frames[:: max(1, len(frames) // _LOOKED_AT)]
    found = dict.fromkeys(size for size in map(pictures.size, looked_at) if size is not None)
    return [
        f"pictures are {_words(picture)}, compared at {_words(size)}, which has another shape"
        for size in sizes
        for picture in list(found)[:_MAX_REPORTED]
        if not same_shape(picture, size)
    ]


def _size_of_video(annotations: Path) -> Size | None:
    """(width, height) px of the video beside its folder of annotations, if it is one."""
    from procc_annotator.image.video import Video  # OpenCV: most sets do without

    videos = (
        path
        for path in sorted(annotations.parent.iterdir())
        if path.suffix.lower() in VIDEO_SUFFIXES and frames_folder(path) == annotations
    )
    for video in videos:
        try:
            with Video.open(video) as opened:
                return opened.size
        except ImageError:  # not one that can be read: its shape stays unknown
            continue
    return None


def size_in_annotation(annotation: FrameAnnotation) -> Size | None:
    """(width, height) px of the picture, as further entries of an annotation file tell it."""
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
    """Whether two sizes have the same ratio of width to height, to a hundredth."""
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
        """In words, to stand beside figures in px: ``960x540``."""
        fitted = dict.fromkeys(size.fitted for size in self.counts)
        if not fitted:
            return _words(self.asked or DEFAULT_SIZE)
        return " and ".join(map(_words, fitted)) if len(fitted) < 3 else "960 px wide"

    def remarks(self) -> list[str]:
        """What to know about pictures that are not 16:9, or not of the shape that was asked for."""
        frames: Counter[FrameSize] = Counter()
        for size, count in self.counts.items():
            if size.picture is not None:
                frames[size] += count
        several = len({size.picture for size in frames}) > 1
        said = []
        for size, count in frames.most_common():
            assert size.picture is not None  # see above
            which = f" ({count_words(count, 'frame')})" if several else ""
            pictures = f"pictures are {_words(size.picture)}{which}"
            if self.asked is not None and not same_shape(size.picture, self.asked):
                said.append(
                    f"{pictures}, but fitted at {_words(self.asked)}, which has another shape:"
                    " cameras are wrong for them (leave --size out, and the pictures tell it)"
                )
            elif self.asked is None and size.fitted != DEFAULT_SIZE:
                said.append(f"{pictures}: fitted at {_words(size.fitted)}")
        if len(said) > _MAX_REPORTED:
            said[_MAX_REPORTED:] = [f"and {len(said) - _MAX_REPORTED} more sizes of pictures"]
        return said


def _words(size: Size) -> str:
    return f"{size[0]}x{size[1]}"
