"""Frames of a video by number: frame n is always the n-th that decoding from the start gives."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from functools import lru_cache
from pathlib import Path

import cv2
import numpy as np

from procc_annotator.errors import ImageError
from procc_annotator.image.pixels import PixelArray, bgra
from procc_annotator.image.scenes import SceneLook, cuts_among, look_of, steps_of
from procc_annotator.image.stream import (
    FloatArray,
    check_decodes,
    check_file,
    frame_times,
    grab,
    number_at,
    open_capture,
    retrieve,
    time_ms,
)
from procc_annotator.image.suffixes import VIDEO_SUFFIXES

# Decoding forward costs 2 ms a frame (1920 x 1080), a seek as much as its group of frames.
_NEAR = 48
_STEPS_BACK_MS = (0.0, 1000.0, 4000.0, 16000.0)


class Video:
    """A video file; safe to use from any thread, one frame is decoded at a time.

    Create it with `Video.open`. The timestamps of its frames are read when they are first needed
    (anything but frame 0): that reads through the file once, without decoding it.
    """

    def __init__(self, path: Path, size: tuple[int, int]) -> None:
        self._path = path
        self._size = size
        self._lock = threading.RLock()
        self._capture: cv2.VideoCapture | None = open_capture(path)
        self._fps = float(self._capture.get(cv2.CAP_PROP_FPS))
        self._count = max(1, int(self._capture.get(cv2.CAP_PROP_FRAME_COUNT)))
        self._next = 0  # number of the frame that the next grab gives
        self._indexed = False
        self._times: FloatArray | None = None

    @classmethod
    def open(cls, path: Path) -> Video:
        """Open a video.

        Raises:
            ImageError: not a video, none of its frames decodes, or frames over 100 megapixels.
        """
        check_file(path)
        return cls(path, check_decodes(path))

    def __enter__(self) -> Video:
        return self

    def __exit__(self, *failure: object) -> None:
        self.close()

    @property
    def path(self) -> Path:
        """The file."""
        return self._path

    @property
    def size(self) -> tuple[int, int]:
        """(width, height) px of the frames as shown, a rotation in the metadata applied."""
        return self._size

    @property
    def frame_count(self) -> int:
        """How many frames there are.

        Exact, except for a video without usable timestamps, where it is what the file claims
        until decoding has met the end.
        """
        with self._lock:
            self._read_times()
            return self._count

    @property
    def fps(self) -> float:
        """Frames a second, the mean if the rate varies."""
        if 0 < self._fps < 1000:
            return self._fps
        with self._lock:
            times = self._read_times()
        if times is None or len(times) < 2:
            return 25.0
        return float(1000 * (len(times) - 1) / (times[-1] - times[0]))

    @property
    def times_s(self) -> FloatArray:
        """(frame_count,) seconds from the first frame to each frame."""
        with self._lock:
            times = self._read_times()
            if times is None:
                return np.arange(self._count) / self.fps
            return np.asarray((times - times[0]) / 1000, dtype=np.float64)

    def frame(self, number: int) -> PixelArray:
        """A frame as (H, W, 4) uint8 BGRA, C-contiguous, opaque and read-only.

        Args:
            number: 0 is the first.

        Raises:
            ImageError: there is no such frame, or it cannot be decoded.
        """
        with self._lock:
            self._check(number)
            pixels = self._decode(number)
        if (pixels.shape[1], pixels.shape[0]) != self._size:
            raise self._error(number, f"its size changes to {pixels.shape[1]} x {pixels.shape[0]}")
        return bgra(pixels)

    def read_index(self) -> None:
        """Read the timestamps of all frames now, so that nothing that needs them waits later."""
        with self._lock:
            self._read_times()

    def number_of(self, time_ms: float, otherwise: int) -> int:
        """The number of the frame with this timestamp, ``otherwise`` if timestamps do not tell."""
        with self._lock:
            times = self._read_times()
        found = None if times is None else number_at(times, time_ms)
        return otherwise if found is None else found

    def close(self) -> None:
        """Let go of the file; asking for a frame is an error from now on."""
        with self._lock:
            if self._capture is not None:
                self._capture.release()
            self._capture = None

    def _check(self, number: int) -> None:
        if self._capture is None:
            raise self._error(number, "the video was closed")
        if number and not 0 < number < self.frame_count:
            problem = f"there is no such frame, the video has {self._count} (0 is the first)"
            raise self._error(number, problem)

    def _decode(self, number: int) -> PixelArray:
        ahead = number - self._next
        if ahead != -1 and not 0 <= ahead <= _NEAR:  # -1: the frame that was grabbed last
            self._jump(number)
        while self._next <= number:
            if not self._grab():
                raise self._ended(number)
        pixels = retrieve(self._reader()) if self._next == number + 1 else None
        if pixels is None:
            raise self._error(number, "this frame cannot be decoded: the video is damaged here")
        return pixels

    def _grab(self) -> bool:
        """Go on by one frame, or more if the file lost some; timestamps tell."""
        reader = self._reader()
        if not grab(reader):
            self._rewind()
            return False
        found = None if self._times is None else number_at(self._times, time_ms(reader))
        self._next = self._next + 1 if found is None else found + 1
        return True

    def _jump(self, number: int) -> None:
        """Get at or before a frame, as near as can be had without losing count."""
        times = self._times
        if times is None:
            if number < self._next:
                self._rewind()
            return
        reader = self._reader()
        for back in _STEPS_BACK_MS:
            start = times[number] - back
            if start <= times[0]:
                break
            reader.set(cv2.CAP_PROP_POS_MSEC, start)
            # After a seek into open groups of frames the first ones are missing; then further back.
            found = number_at(times, time_ms(reader)) if grab(reader) else None
            if found is not None and found <= number:
                self._next = found + 1
                return
        self._rewind()

    def _rewind(self) -> None:
        self._reader().release()
        self._capture = open_capture(self._path)
        self._next = 0

    def _reader(self) -> cv2.VideoCapture:
        if self._capture is None:
            raise ImageError(self._path, "the video was closed")
        return self._capture

    def _read_times(self) -> FloatArray | None:
        if not self._indexed:
            self._times = frame_times(self._path)
            self._indexed = True
            if self._times is not None:
                self._count = len(self._times)
        return self._times

    def _ended(self, number: int) -> ImageError:
        """The error for a stream that is shorter than it says; the count becomes the true one."""
        if self._times is not None:
            return self._error(number, "cannot be decoded: the video is damaged here")
        while grab(self._reader()):
            self._next += 1
        self._count = self._next
        self._rewind()
        return self._error(number, f"the video ends after {self._count} frames")

    def _error(self, number: int, problem: str) -> ImageError:
        return ImageError(self._path, problem, place=f"frame {number}")


def open_shared(path: Path) -> Video:
    """The video, opened once for all who ask while the file stays the same.

    Do not close it: the two used last stay open.

    Raises:
        ImageError: it cannot be opened.
    """
    try:
        changed = path.stat()
    except OSError as error:
        raise ImageError(path, f"cannot be read: {error.strerror or error}") from error
    return _opened(path, changed.st_mtime_ns, changed.st_size)


@lru_cache(maxsize=2)
def _opened(path: Path, changed_ns: int, size: int) -> Video:
    del changed_ns, size  # part of the key: a file that was replaced is opened anew
    return Video.open(path)


def frame_of(path: Path) -> tuple[Path, int] | None:
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

    Raises:
        ValueError: ``seconds`` is not above zero.
    """
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
) -> list[int]:
    """The number of the first frame of each scene, 0 included; of a cancelled search those so far.

    Hard cuts only: a dissolve or a wipe is not one. Reads the whole video with a reader of its
    own, so that frames can be had meanwhile.

    Args:
        video: stays open and where it is.
        progress: called now and then with frames done and their count.
        cancelled: asked now and then.

    Raises:
        ImageError: the file cannot be opened any more.
    """
    count = video.frame_count
    capture = open_capture(video.path)
    numbers: list[int] = []

    def looks() -> Iterator[SceneLook]:
        number = 0
        while grab(capture):
            if number % 25 == 0:
                if cancelled():
                    return
                if progress is not None:
                    progress(min(number, count), count)
            pixels = retrieve(capture)
            number = video.number_of(time_ms(capture), number)
            if pixels is not None:
                numbers.append(number)
                yield look_of(pixels)
            number += 1

    steps, lasting = steps_of(looks())
    if progress is not None and not cancelled():
        progress(count, count)
    return [numbers[i] for i in cuts_among(steps, lasting)] if numbers else [0]
