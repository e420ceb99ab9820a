"""Whether the pictures of a dataset follow one another, and which pictures lie between them."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from procc_annotator.errors import ImageError
from procc_annotator.image.decode import decode_bgra, decode_thumbnail
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.scenes import frame_signature, is_same_scene
from procc_annotator.image.video import Video, video_frame_of_path, open_shared_video
from procc_annotator.session.dataset.frames import Frame

FEWEST = 10  # pictures of a folder that are called consecutive: a few are compared by eye
_MOST_GAPS = 0.1  # share of the pictures before which some are missing
_MOST_STEP = 12  # of names that count by more than one: half a second
_LOOKED_AT = 8  # pairs of neighbours
_AT_LEAST_ALIKE = 0.5  # of them; the others may be cuts
_FOLDER_FPS = 25.0
_SIDE = 320
_NUMBERED = re.compile(r"(.*?)([0-9]+)")


@dataclass(frozen=True, eq=False)
class FrameSequence:
    """Frames of a dataset that follow one another in a video or a folder.

    Attributes:
        numbers: (n,) of the dataset's frames in their source, ascending; of pictures whose names
            count by more than one, how often that was.
        first, last: numbers of the source; in a video there are frames between the dataset's.
        fps: frames of the source a second.
        video: the file; None for a folder.
        paths: of the frames of a folder, by number; empty for a video.
        step: by what the names of a folder count.
    """

    numbers: NDArray[np.int64]
    first: int
    last: int
    fps: float
    video: Path | None
    paths: dict[int, Path]
    step: int = 1

    @cached_property
    def index_of(self) -> dict[int, int]:
        """Number in the source -> index in the dataset."""
        return {int(number): index for index, number in enumerate(self.numbers)}

    @property
    def count(self) -> int:
        """How many frames the source has, from the first number to the last."""
        return self.last - self.first + 1

    def nearest(self, number: float) -> int:
        """The index of the dataset's frame nearest to a number."""
        after = int(np.searchsorted(self.numbers, number))
        around = [i for i in (after - 1, after) if 0 <= i < len(self.numbers)]
        return min(around, key=lambda i: abs(float(self.numbers[i]) - number))

    def unbroken(self, number: int) -> range:
        """The frames around one of the dataset's up to where pictures are missing."""
        if self.video is not None:
            return range(self.first, self.last + 1)
        gaps = np.flatnonzero(np.diff(self.numbers) > 1) + 1
        runs = np.split(self.numbers, gaps)
        own = runs[int(np.searchsorted(gaps, self.index_of[number], side="right"))]
        return range(int(own[0]), int(own[-1]) + 1)

    def open_pictures(self) -> SequencePictures:
        """The pictures by number, for one thread to go through."""
        return SequencePictures(self)


class SequencePictures:
    """Pictures by number; of a video through a reader of its own, so that nobody else waits."""

    def __init__(self, sequence: FrameSequence) -> None:
        self._paths = sequence.paths
        self._video = None if sequence.video is None else Video.open(sequence.video)

    def __enter__(self) -> SequencePictures:
        return self

    def __exit__(self, *failure: object) -> None:
        if self._video is not None:
            self._video.close()

    def __call__(self, number: int) -> PixelArray:
        """(H, W, 4) BGRA.

        Raises:
            ImageError: there is no such picture, or it cannot be decoded.
        """
        if self._video is not None:
            return self._video.frame(number)
        if number not in self._paths:
            raise ImageError(Path(str(number)), "no picture has this number")
        return decode_bgra(self._paths[number])


def sequence_of(
    frames: Sequence[Frame], go_on: Callable[[], None] = lambda: None
) -> FrameSequence | None:
    """What the frames of a dataset follow one another in; None for unrelated pictures.

    Those of one video do. Those of a folder, and of each folder of a tree, do if their names end
    with numbers that count on, by one or by some frames of a video at a time, and if most of some
    neighbours show the same scene: sets of unrelated pictures are numbered, too.
    Reads and decodes; for any thread but the interface's.
    """
    if not frames:
        return None
    if frames[0].image_folder == frames[-1].image_folder:
        try:
            if video_frame_of_path(frames[0].image_path) is not None:
                return _of_video(frames)
        except ImageError:
            return None
        counted = _numbered_names([frame.name for frame in frames])
    else:
        counted = _counted_in_folders(frames)
    if counted is None:
        return None
    numbers, step = counted
    if not _neighbours_similar(frames, numbers, go_on):
        return None
    paths = {int(n): frame.image_path for n, frame in zip(numbers, frames, strict=True)}
    first, last = int(numbers[0]), int(numbers[-1])
    return FrameSequence(numbers, first, last, _FOLDER_FPS / step, None, paths, step)


def _of_video(frames: Sequence[Frame]) -> FrameSequence | None:
    path = frames[0].image_folder
    numbers = np.array([int(frame.image_file) for frame in frames], dtype=np.int64)
    if (np.diff(numbers) <= 0).any():
        return None
    video = open_shared_video(path)
    last = max(int(numbers[-1]), video.frame_count - 1)
    return FrameSequence(numbers, 0, last, video.fps, path, {})


def _numbered_names(names: Sequence[str]) -> tuple[NDArray[np.int64], int] | None:
    """How far names have counted, and by what, if they end with numbers that count on."""
    if len(names) < FEWEST:
        return None
    found = [_NUMBERED.fullmatch(name) for name in names]
    if len({match and match[1] for match in found}) != 1 or found[0] is None:
        return None
    numbers = np.array([int(match[2]) for match in found if match], dtype=np.int64)
    steps = np.diff(numbers)
    step = int(steps.min())
    if not 0 < step <= _MOST_STEP or (steps % step).any() or (steps > step).mean() > _MOST_GAPS:
        return None
    return numbers // step, step


def _counted_in_folders(frames: Sequence[Frame]) -> tuple[NDArray[np.int64], int] | None:
    """The same of a tree: folders come one after the other, as if a picture were missing between
    them, so that nothing is followed from one to the next. One that does not count is taken for
    pictures without a neighbour."""
    found, steps, begin = [], [], 0
    for _, group in groupby(frames, key=lambda frame: frame.image_folder):
        names = [frame.name for frame in group]
        counted = _numbered_names(names)
        numbers = 2 * np.arange(len(names), dtype=np.int64) if counted is None else counted[0]
        steps += [] if counted is None else [counted[1]]
        found.append(numbers - numbers[0] + begin)
        begin = int(found[-1][-1]) + 2
    return (np.concatenate(found), min(steps)) if steps else None


def _neighbours_similar(
    frames: Sequence[Frame], numbers: NDArray[np.int64], go_on: Callable[[], None]
) -> bool:
    """Whether neighbours look alike, by some of them all over the set."""
    pairs = np.flatnonzero(np.diff(numbers) == 1)
    chosen = pairs[np.unique(np.linspace(0, len(pairs) - 1, _LOOKED_AT).round().astype(int))]
    alike = []
    for index in chosen.tolist():
        go_on()
        try:
            looks = [
                frame_signature(decode_thumbnail(frames[i].image_path, _SIDE)[..., :3])
                for i in (index, index + 1)
            ]
        except ImageError:
            continue
        alike.append(is_same_scene(*looks))
    return bool(alike) and float(np.mean(alike)) >= _AT_LEAST_ALIKE
