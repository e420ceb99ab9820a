"""A video: its frames by number, their times, and the cuts between its scenes."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from functools import lru_cache
from pathlib import Path

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.errors import ImageError
from procc_annotator.image.headers import VIDEO_SUFFIXES
from procc_annotator.image.motion import (
    FrameSignature,
    cut_indices,
    frame_differences,
    frame_signature,
)
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.video_stream import (
    FrameReader,
    PacketIndex,
    probe_stream,
    read_packet_index,
    require_video_file,
)

_SQUARE_PIXEL_TOLERANCE = 0.01  # as far as encoders round


class Video:
    """A video file; safe to use from any thread, one frame is decoded at a time.

    Create it with `Video.open`. The index of its packets is read when it is first needed: that
    reads through the file once, without decoding it.
    """

    def __init__(self, path: Path) -> None:
        """Decode the first frames, as `open` does."""
        self.path = path
        self._first = probe_stream(path)
        self._lock = threading.RLock()
        self._index: PacketIndex | None = None
        self._reader: FrameReader | None = None
        self._closed = False

    @classmethod
    def open(cls, path: Path) -> Video:
        """Open a video.

        Raises:
            ImageError: not a video, none of its frames decodes, or frames over 100 megapixels.
        """
        require_video_file(path)
        return cls(path)

    def __enter__(self) -> Video:
        return self

    def __exit__(self, *failure: object) -> None:
        self.close()

    @property
    def size(self) -> tuple[int, int]:
        """(width, height) px of the frames as shown, a rotation in the metadata applied."""
        return self._first.size

    @property
    def frame_count(self) -> int:
        """Number of frames.

        Exact, except for a video without usable timestamps, where it is the number of packets
        until decoding has met the end.
        """
        return len(self.read_index().places)

    @property
    def fps(self) -> float:
        """Frames per second, the mean if the rate varies."""
        if 0 < self._first.rate < 1000:
            return self._first.rate
        times = self.read_index().times_s
        return 25.0 if times is None or len(times) < 2 else float((len(times) - 1) / times[-1])

    @property
    def times_s(self) -> FloatArray:
        """(frame_count,) seconds from the first frame to each frame."""
        times = self.read_index().times_s
        return np.arange(self.frame_count) / self.fps if times is None else times

    @property
    def cut_off(self) -> str:
        """Return what is missing at the end of the file; empty if nothing is known to be."""
        return self.read_index().cut_off

    @property
    def pixel_aspect(self) -> float:
        """The width of its pixels over their height, as its metadata say; 1 for square ones."""
        aspect = self._first.pixel_aspect
        return 1.0 if abs(aspect - 1) < _SQUARE_PIXEL_TOLERANCE else aspect

    @property
    def squeezed(self) -> str:
        """That its pixels are not square, if its metadata say so; empty if not."""
        if self.pixel_aspect == 1:
            return ""
        return (
            f"its pixels are {self.pixel_aspect:.3f} times as wide as high: cameras are in px of"
            " its pictures as they are stored, with focal lengths in that ratio"
        )

    def frame(self, number: int) -> PixelArray:
        """A frame, counted from 0, as (H, W, 4) uint8 BGRA, C-contiguous, opaque and read-only.
        `ImageError` if there is no such frame, or it is damaged."""
        with self._lock:
            if self._closed:
                raise self._error(number, "the video was closed")
            index = self.read_index()
            if self._reader is None:
                self._reader = FrameReader(self.path, index)
            pixels = self._reader.frame(number) if 0 <= number < len(index.places) else None
            count = len(index.places)
        if not 0 <= number < count:
            problem = f"there is no such frame, the video has {count} (0 is the first)"
            raise self._error(number, problem)
        if pixels is None:
            raise self._error(number, "damaged, or predicted from a damaged frame")
        if (pixels.shape[1], pixels.shape[0]) != self.size:
            raise self._error(number, f"its size changes to {pixels.shape[1]} x {pixels.shape[0]}")
        return pixels

    def read_index(self) -> PacketIndex:
        """Read the packets of the video now, so that nothing that needs them waits later."""
        with self._lock:
            if self._index is None:
                self._index = read_packet_index(self.path, self._first.times)
            return self._index

    def release(self) -> None:
        """Give back decoded frames and the decoder; the next frame opens another one."""
        with self._lock:
            if self._reader is not None:
                self._reader.close()
                self._reader = None

    def close(self) -> None:
        """Close the file; requesting a frame is an error from now on."""
        with self._lock:
            self._closed = True
            self.release()

    def _error(self, number: int, problem: str) -> ImageError:
        return ImageError(self.path, problem, place=f"frame {number}")


def open_shared_video(path: Path) -> Video:
    """The video, opened once for all who ask while the file stays the same.

    Do not close it: the two used last stay open.

    Raises:
        ImageError: it cannot be opened.
    """
    try:
        changed = path.stat()
    except OSError as error:
        raise ImageError(path, f"cannot be read: {error.strerror or error}") from error
    return _open_cached(path, changed.st_mtime_ns, changed.st_size)


@lru_cache(maxsize=2)
def _open_cached(path: Path, changed_ns: int, size: int) -> Video:
    del changed_ns, size  # part of the key: a file that was replaced is opened anew
    return Video.open(path)


def video_frame_of_path(path: Path) -> tuple[Path, int] | None:
    """The video and the frame number that a path like ``match.mp4/00000123`` means.

    None for any other path: what is above it must be a file with the name of a video.

    Raises:
        ImageError: below a video, but not a frame number.
    """
    video = path.parent
    if video.suffix.lower() not in VIDEO_SUFFIXES or not video.is_file():
        return None
    if not (path.name.isascii() and path.name.isdigit()):
        raise ImageError(path, "expected a frame number below the video, like 00000123")
    return video, int(path.name)


def frames_at_interval(video: Video, seconds: float) -> list[int]:
    """The first frame and then one every ``seconds``, each the first at or after its time.
    `ValueError` if ``seconds`` is not above zero."""
    if not seconds > 0:
        raise ValueError(f"expected a time above zero, got {seconds}")
    times = video.times_s
    wanted = np.arange(0.0, times[-1] + 1e-6, seconds)
    # A hundredth of a frame of slack: timestamps are rounded to the file's time base.
    numbers = np.searchsorted(times, wanted - 0.01 / video.fps)
    return sorted({int(n) for n in numbers if n < len(times)})


def scene_cuts(
    video: Video,
    *,
    progress: Callable[[int, int], None] | None,
    cancelled: Callable[[], bool],
    numbers: range | None = None,
) -> list[int]:
    """The number of the first frame of each scene, 0 included; of a cancelled search those so far.

    Hard cuts only: a dissolve or a wipe is not one. Reads the frames with a reader of its own, so
    that others can be had meanwhile; progress is called with frames done and their count.

    Args:
        numbers: consecutive frames to look at; None for all. The first one begins a scene.

    Raises:
        ImageError: the file cannot be opened any more.
    """
    wanted = range(video.frame_count) if numbers is None else numbers
    seen: list[int] = []

    def looks(reader: FrameReader) -> Iterator[FrameSignature]:
        for done, number in enumerate(wanted):
            if done % 25 == 0:
                if cancelled():
                    return
                if progress is not None:
                    progress(done, len(wanted))
            pixels = reader.frame(number)
            if pixels is not None:
                seen.append(number)
                yield frame_signature(pixels[..., :3])

    reader = FrameReader(video.path, video.read_index())
    steps, lasting = frame_differences(looks(reader))
    reader.close()
    if progress is not None and not cancelled():
        progress(len(wanted), len(wanted))
    return [seen[i] for i in cut_indices(steps, lasting)] if seen else [wanted.start]
