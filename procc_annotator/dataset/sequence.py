"""Pictures in order: picture source of a command, consecutive frames, shots between cuts,
videos as datasets.
"""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import groupby, pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.dataset.annotation_source import FrameAnnotations
from procc_annotator.dataset.diagnostics import found_instead_of_pictures
from procc_annotator.dataset.frames import Frame, list_frames, video_frame
from procc_annotator.dataset.layout import frames_folder
from procc_annotator.dataset.remote_files import local_path
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ImageError, SaveError, UsageError, require_existing
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import LabelMap
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.image.archive import is_archive_file, pictures_in_archive
from procc_annotator.image.decoding import decode_bgra, decode_thumbnail
from procc_annotator.image.headers import VIDEO_SUFFIXES
from procc_annotator.image.motion import (
    CUT_MARGIN,
    FrameSignature,
    cut_indices,
    estimate_motion,
    frame_differences,
    frame_signature,
    is_same_scene,
)
from procc_annotator.image.pixels import PixelArray, encode_png
from procc_annotator.image.video import Video, open_shared_video, scene_cuts, video_frame_of_path

_SAMPLED_BYTES = 2**16


@dataclass(frozen=True)
class PictureSource:
    """Pictures in their order.

    Attributes:
        folder: the dataset's own, which need not exist yet for a video.
        frames: their names, pictures and annotation files; pictures by absolute paths, so that any
            worker finds them.
        is_video: whether they are the frames of one.
        notices: what the user should know of it.
        problems: of the whole source, so that results of it are incomplete, one line each.
    """

    path: Path
    folder: Path
    frames: tuple[Frame, ...]
    is_video: bool = False
    notices: tuple[str, ...] = ()
    problems: tuple[str, ...] = ()

    def annotated(
        self, annotations: Path | None, field: Field, names: LabelMap | None = None
    ) -> FrameAnnotations:
        """Return what is annotated in them; see `FrameAnnotations.of`."""
        return FrameAnnotations.of(self.path, annotations, field, names)

    def stamp(self) -> str:
        """Return what another content would change, and a copy would not: a digest of the size of
        the files, and of both ends of a video or archive."""
        digest = hashlib.sha256()
        for path in [self.path] if self.path.is_file() else [f.image_path for f in self.frames]:
            size = path.stat().st_size
            digest.update(f"{path.name} {size} ".encode("utf-8", "surrogatepass"))
            if path == self.path:
                with path.open("rb") as file:
                    digest.update(file.read(_SAMPLED_BYTES))
                    file.seek(max(size - _SAMPLED_BYTES, 0))
                    digest.update(file.read(_SAMPLED_BYTES))
        return digest.hexdigest()[:16]

    def times_s(self, numbers: range) -> FloatArray:
        """Seconds from the first frame; NaN for pictures, which have no clock."""
        if not self.is_video:
            return np.full(len(numbers), np.nan)
        return open_shared_video(self.path).times_s[numbers.start : numbers.stop]


def open_pictures(path: Path, annotations: Path | None = None) -> PictureSource:
    """The pictures of a folder or archive in natural order, one picture, or all frames of a video.

    Nothing is made on the disk, and of a video only the timestamps are read.

    Args:
        path: folder, archive, picture or video; or a URL of one of the last three.
        annotations: folder of the annotation files, if it is not where it would be looked for.

    Raises:
        UsageError: nothing there, a file of another kind, or a folder without pictures.
        ImageError: a video that cannot be opened.
        InputError: a folder that cannot be listed, a URL that cannot be read.
    """
    path = local_path(path)
    whole = Path(os.path.abspath(path))
    require_existing(path)
    if path.is_file() and path.suffix.lower() in VIDEO_SUFFIXES:
        video = open_shared_video(path)
        frames = tuple(video_frame(whole, number) for number in range(video.frame_count))
        if annotations is not None:
            frames = tuple(replace(frame, annotation_folder=annotations) for frame in frames)
        words = (video.squeezed, video.cut_off)
        known, missing = (tuple(f"{path}: {word}" for word in [one] if word) for one in words)
        return PictureSource(path, frames_folder(path), frames, True, known, missing)
    root, frames, notices = list_frames(path, annotations)
    if not frames:
        raise UsageError(f"nothing to do: no picture in {path}{found_instead_of_pictures(path)}")
    found = tuple(
        replace(frame, image_folder=Path(os.path.abspath(frame.image_folder))) for frame in frames
    )
    lacks = pictures_in_archive(path)[1] if is_archive_file(path) else ""
    problems = (f"{path}: {lacks}",) if lacks else ()
    return PictureSource(path, root, found, notices=notices, problems=problems)


FEWEST = 10  # pictures of a folder that are called consecutive: a few are compared by eye
_MOST_GAPS = 0.1  # share of the pictures before which some are missing
_MOST_STEP = 12  # of names that count by more than one: half a second
_LOOKED_AT = 8  # pairs of neighbours
_AT_LEAST_ALIKE = 0.5  # of them; the others may be cuts
FOLDER_FPS = 25.0
_LOOKED_AT_PX = 320
_NUMBERED = re.compile(r"(.*?)([0-9]+)")


@dataclass(frozen=True, eq=False)
class FrameSequence:
    """Frames of a dataset that follow one another in a video or a folder.

    Attributes:
        numbers: (n,) of the dataset's frames in their source, ascending; of pictures with names
            that count by more than one, how often that was.
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
        """Return how many frames the source has, from the first number to the last."""
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
    """Pictures by number; of a video through a reader of its own, so that no one else waits."""

    def __init__(self, sequence: FrameSequence) -> None:
        self._paths = sequence.paths
        self._video = None if sequence.video is None else Video.open(sequence.video)

    def __enter__(self) -> SequencePictures:
        return self

    def __exit__(self, *failure: object) -> None:
        if self._video is not None:
            self._video.close()

    def __call__(self, number: int) -> PixelArray:
        """(H, W, 4) BGRA; `ImageError` if there is no such picture, or it cannot be decoded."""
        if self._video is not None:
            return self._video.frame(number)
        if number not in self._paths:
            raise ImageError(Path(str(number)), "no picture has this number")
        return decode_bgra(self._paths[number])


def sequence_of(
    frames: Sequence[Frame], go_on: Callable[[], None] = lambda: None
) -> FrameSequence | None:
    """Return what the frames of a dataset follow one another in; None for unrelated pictures.

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
    return FrameSequence(numbers, first, last, FOLDER_FPS / step, None, paths, step)


def _of_video(frames: Sequence[Frame]) -> FrameSequence | None:
    path = frames[0].image_folder
    numbers = np.array([int(frame.image_file) for frame in frames], dtype=np.int64)
    if (np.diff(numbers) <= 0).any():
        return None
    video = open_shared_video(path)
    last = max(int(numbers[-1]), video.frame_count - 1)
    return FrameSequence(numbers, 0, last, video.fps, path, {})


def _numbered_names(names: Sequence[str]) -> tuple[NDArray[np.int64], int] | None:
    """Return how far names have counted, and by what, if they end with numbers that count on."""
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
    """Return whether neighbours look alike, by some of them all over the set."""
    pairs = np.flatnonzero(np.diff(numbers) == 1)
    chosen = pairs[np.unique(np.linspace(0, len(pairs) - 1, _LOOKED_AT).round().astype(int))]
    alike = []
    for index in chosen.tolist():
        go_on()
        try:
            looks = [
                frame_signature(decode_thumbnail(frames[i].image_path, _LOOKED_AT_PX)[..., :3])
                for i in (index, index + 1)
            ]
        except ImageError:
            continue
        alike.append(is_same_scene(*looks))
    return bool(alike) and float(np.mean(alike)) >= _AT_LEAST_ALIKE


def find_shots(source: PictureSource, progress: Callable[[int, int], None]) -> list[range]:
    """Return the stretches between cuts: the numbers of the frames of each shot.

    Args:
        source: its frames, numbered from 0.
        progress: called now and then with frames done and their count.

    Raises:
        ImageError: a video that cannot be read.
    """
    count = len(source.frames)
    begins = find_cuts(source, range(count), progress)
    return [range(first, past) for first, past in pairwise([0, *begins, count])]


def find_cuts(
    source: PictureSource, numbers: range, progress: Callable[[int, int], None] = lambda *_: None
) -> list[int]:
    """Return those of some consecutive frames, but for the very first one, that begin a shot,
    whatever part of the source is looked at.

    What changes the picture at once without another camera (a banner, a flash) is no cut: the
    stadium moves on steadily behind it.

    Args:
        source, progress: as of `find_shots`.
        numbers: the frames.

    Raises:
        ImageError: a video that cannot be read.
    """
    around = range(
        max(numbers.start - CUT_MARGIN, 0), min(numbers.stop + CUT_MARGIN, len(source.frames))
    )
    if source.is_video:
        video = open_shared_video(source.frames[0].image_folder)
        begins = scene_cuts(video, progress=progress, cancelled=lambda: False, numbers=around)
    else:
        begins = _cuts_in_folder(source.frames, around, progress)
    told = set(begins) - {around.start}
    return [
        n
        for n in numbers
        if n and (_other_folder(source.frames, n) or (n in told and _is_cut(source.frames, n)))
    ]


def _other_folder(frames: Sequence[Frame], number: int) -> bool:
    return frames[number].image_folder != frames[number - 1].image_folder


def _cuts_in_folder(
    frames: Sequence[Frame], numbers: range, progress: Callable[[int, int], None]
) -> list[int]:
    seen: list[int] = []

    def looks() -> Iterator[FrameSignature]:
        for done, number in enumerate(numbers):
            progress(done, len(numbers))
            try:
                small = decode_thumbnail(frames[number].image_path, _LOOKED_AT_PX)
            except ImageError:  # told when its shot is followed
                continue
            seen.append(number)
            yield frame_signature(small[..., :3])

    steps, lasting = frame_differences(looks())
    progress(len(numbers), len(numbers))
    return [seen[i] for i in cut_indices(steps, lasting)] if seen else []


def _is_cut(frames: Sequence[Frame], number: int) -> bool:
    try:
        before, now = (decode_bgra(frames[n].image_path) for n in (number - 1, number))
    except ImageError:
        return True
    return estimate_motion(before, now) is None


def open_video(video: Path, numbers: Iterable[int], field: Field) -> Workspace:
    """The chosen frames (numbered from 0) of a video, and those worked on before, named
    ``match_000123``.

    Their pictures are decoded when asked for (paths like ``match.mp4/00000123``). Annotations lie
    in `frames_folder`, where `keep_frame` puts the pictures too, so that the folder is a dataset of
    its own.
    """
    folder = frames_folder(video)
    frames = tuple(
        video_frame(video, number) for number in sorted({*numbers, *_frames_with_work(video)})
    )
    notices: tuple[str, ...] = ()
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        notices = (f"{folder}: cannot be made, nothing can be saved: {error.strerror}",)
    return Workspace(folder, frames, field, notices)


def _frames_with_work(video: Path) -> list[int]:
    name = re.compile(re.escape(video.stem) + r"_([0-9]{6,8})\.(?:json|png)", re.IGNORECASE)
    try:
        files = os.listdir(frames_folder(video))
    except OSError:  # usually: not made yet
        return []
    return [int(found[1]) for found in map(name.fullmatch, files) if found]


def keep_frame(frame: Frame, picture: PixelArray) -> Path:
    """Write a frame's picture next to its annotation, without loss; the same file each time.
    `SaveError` if it could not be written."""
    path = frame.annotation_folder / f"{frame.name}.png"
    if not path.parent.is_dir():
        raise SaveError(f"{path.parent}: does not exist, the picture was not kept")
    write_atomic(path, encode_png(picture), inside=path.parent)
    return path
