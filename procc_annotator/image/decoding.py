"""Decode images and video frames to BGRA arrays, with a cache of decoded frames."""

from __future__ import annotations

import threading
from collections import OrderedDict, deque
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from procc_annotator.errors import ImageError
from procc_annotator.image.archive import archive_of_path, read_member
from procc_annotator.image.headers import (
    count_gif_frames,
    count_tiff_pages,
    header_size,
    is_truncated_png,
    require_valid_size,
)
from procc_annotator.image.pixels import PixelArray, bgra_from_bgr, require_decodable_size
from procc_annotator.image.video import open_shared_video, video_frame_of_path
from procc_annotator.regular_file import open_regular

# What is wrong with a picture is raised; nothing is printed beside it.
cv2.utils.logging.setLogLevel(cv2.utils.logging.LOG_LEVEL_SILENT)
# Decoding at a fraction is 3-6 times faster for JPEG, where it skips most of the inverse DCT.
_REDUCED_FLAGS = {
    8: cv2.IMREAD_REDUCED_COLOR_8,
    4: cv2.IMREAD_REDUCED_COLOR_4,
    2: cv2.IMREAD_REDUCED_COLOR_2,
    1: cv2.IMREAD_COLOR,
}


_JPEG = frozenset({".jpg", ".jpeg"})
_HALF_SIZE_MIN_PIXELS = 1_000_000  # of what takes a hand's time to decode


def decode_bgra(path: Path) -> PixelArray:
    """The picture as (H, W, 4) uint8, C-contiguous, opaque and read-only. `ImageError` if it is not
    a readable picture, or has more than 100 megapixels."""
    video_frame = video_frame_of_path(path)
    if video_frame is not None:
        video, number = video_frame
        return open_shared_video(video).frame(number)
    return bgra_from_bgr(_decode(path, _read(path), cv2.IMREAD_COLOR))


def decode_for_camera(path: Path) -> PixelArray:
    """As `decode_bgra`, for a picture that a camera is looked for in.

    Raises:
        ImageError: as there, or it has no shape for that.
    """
    picture = decode_bgra(path)
    require_valid_size(path, picture.shape[1], picture.shape[0])
    return picture


@dataclass(frozen=True, eq=False, slots=True)
class HalfSizeImage:
    """A picture at half its size, to be examined until the whole one is there.

    Attributes:
        pixels: (h, w, 4) uint8 like `decode_bgra`.
        size: (width, height) px of the whole picture.
    """

    pixels: PixelArray
    size: tuple[int, int]


def decode_half_size(path: Path) -> HalfSizeImage | None:
    """A large JPEG at half its size, in a third of the time; None for any other picture, and for
    one that `decode_bgra` would refuse."""
    if path.suffix.lower() not in _JPEG or video_frame_of_path(path) is not None:
        return None
    try:
        data = _read(path)
        width, height = header_size(data.data) or (0, 0)
        if width * height < _HALF_SIZE_MIN_PIXELS:
            return None
        pixels = bgra_from_bgr(_decode(path, data, _REDUCED_FLAGS[2]))
    except ImageError:
        return None
    for size in ((width, height), (height, width)):  # it may be stored lying on its side
        if pixels.shape[:2] == ((size[1] + 1) // 2, (size[0] + 1) // 2):
            return HalfSizeImage(pixels, size)
    return None


def decode_thumbnail(path: Path, max_side: int = 160) -> PixelArray:
    """A small version, (h, w, 4) uint8 like `decode_bgra`, its longer side at most ``max_side`` px.
    `ImageError` if it is not a readable picture."""
    if video_frame_of_path(path) is not None:
        small = np.ascontiguousarray(downscale_to(decode_bgra(path), max_side))
        small.flags.writeable = False
        return small
    data = _read(path)
    short, long = sorted(header_size(data.data) or (0, 0))
    factor = next((f for f in (8, 4, 2) if long >= f * max_side and short >= f), 1)
    return bgra_from_bgr(downscale_to(_decode(path, data, _REDUCED_FLAGS[factor]), max_side))


def downscale_to(pixels: PixelArray, max_side: int) -> PixelArray:
    """(h, w, c) of a (H, W, c) picture, its longer side at most ``max_side`` px; never enlarged."""
    height, width = pixels.shape[:2]
    scale = max_side / max(height, width)
    if scale >= 1:
        return pixels
    target = max(1, round(width * scale)), max(1, round(height * scale))
    return np.asarray(cv2.resize(pixels, target, interpolation=cv2.INTER_AREA), dtype=np.uint8)


def read_size(path: Path) -> tuple[int, int]:
    """(width, height) in px; of a video's frame that of the video, without decoding the frame.
    `ImageError` if it is not a readable picture."""
    video_frame = video_frame_of_path(path)
    if video_frame is not None:
        return open_shared_video(video_frame[0]).size
    height, width = _decode(path, _read(path), cv2.IMREAD_GRAYSCALE).shape[:2]
    return width, height


def _read(path: Path) -> PixelArray:
    if (packed := archive_of_path(path)) is not None:
        return np.frombuffer(read_member(*packed), dtype=np.uint8)
    try:
        # cv2.imread cannot open every name on Windows; reading the bytes ourselves can.
        with open_regular(path) as file:
            data = np.fromfile(file, dtype=np.uint8)
    except OSError as error:
        raise ImageError(path, f"cannot be read: {error.strerror or error}") from error
    if not data.size:
        raise ImageError(path, "the file is empty, expected a picture")
    return data


def _decode(path: Path, data: PixelArray, flags: int) -> PixelArray:
    size = header_size(data.data)
    if size is None:  # OpenCV reads more kinds, some of which unpack without any limit
        raise _decode_error(path)
    require_decodable_size(path, *size)
    if (frames := count_gif_frames(data.data)) > 1:
        raise ImageError(
            path, f"is an animation of {frames} pictures, expected one",
            advice="make a video of it: ffmpeg -i FILE.gif -crf 12 FILE.mp4",
        )  # fmt: skip
    if (pages := count_tiff_pages(data.data)) > 1:
        advice = "write each to a file of its own"
        raise ImageError(path, f"holds {pages} pictures, expected one", advice=advice)
    if is_truncated_png(data.data):
        raise ImageError(path, "the picture cannot be decoded: a part of the file is missing")
    try:
        pixels = cv2.imdecode(data, flags)
    except cv2.error as error:
        raise ImageError(path, f"the picture cannot be decoded: {error.err}") from error
    if pixels is None:
        raise _decode_error(path)
    return np.asarray(pixels, dtype=np.uint8)


def _decode_error(path: Path) -> ImageError:
    kinds = "jpg, png, bmp, webp, tiff, jp2, avif, gif"
    return ImageError(
        path, f"the picture cannot be decoded: damaged, not {kinds}, or more than 16 bits a channel"
    )


_MIN_KEPT = 3  # the frame on screen and the two that may come next


_FileStamp = tuple[int, int]  # of a file: when it was written, in ns, and its bytes


class FrameCache:
    """The pictures used last, up to a number of bytes; safe to use from any thread.

    The newest few are kept even if they exceed the limit: with large pictures, the neighbours of
    the frame on screen must not push each other out. Failures are not remembered: a picture that
    was repaired meanwhile is read again; so is a replaced file, by `get`.
    """

    def __init__(self, max_bytes: int, kept_at_least: int = _MIN_KEPT) -> None:
        self._max_bytes = max_bytes
        self._kept_at_least = kept_at_least
        self._pictures: OrderedDict[Path, PixelArray] = OrderedDict()
        self._stamps: dict[Path, _FileStamp | None] = {}
        self._bytes = 0
        self._decoding: set[Path] = set()
        self._queue: deque[Path] = deque()
        self._changed = threading.Condition()
        self._closed = False
        self._prefetching = False
        # What is made of a picture before it is wanted; in the thread that decodes it.
        self.foresee: Callable[[PixelArray], object] = lambda picture: None
        # Not a daemon thread: one that is killed inside OpenCV at exit takes the process down.
        self._executor = ThreadPoolExecutor(1, thread_name_prefix="picture prefetch")

    def get(self, path: Path) -> PixelArray:
        """The picture, decoded now unless it is here already (or waited for, if on its way).
        `ImageError` if it is not a readable picture."""
        stamp = _file_stamp(path)
        with self._changed:
            self._changed.wait_for(lambda: path not in self._decoding)
            picture = self._touch(path)
            if picture is not None and stamp in (None, self._stamps[path]):
                return picture
            self._decoding.add(path)
        return self._decode(path)

    def get_ready(self, path: Path) -> PixelArray:
        """As `get`, with what is made of it before it is wanted; in any thread but the interface's.
        `ImageError` if it is not a readable picture."""
        picture = self.get(path)
        self.foresee(picture)
        return picture

    def peek(self, path: Path) -> PixelArray | None:
        """The picture if it is in memory; never decodes, and does not count as using it."""
        with self._changed:
            return self._pictures.get(path)

    def prefetch(self, paths: Iterable[Path]) -> None:
        """Decode these in the background, in this order, instead of what was still waiting."""
        with self._changed:
            if self._closed:
                return
            self._queue = deque(dict.fromkeys(paths))
            if self._queue and not self._prefetching:
                self._prefetching = True
                self._executor.submit(self._prefetch_queue)

    def close(self) -> None:
        """Stop the background thread and forget all pictures; `get` goes on working."""
        with self._changed:
            self._closed = True
            self._queue.clear()
            self._pictures.clear()
            self._stamps.clear()
            self._bytes = 0
        self._executor.shutdown()

    @property
    def used_bytes(self) -> int:
        """Memory held by the pictures."""
        with self._changed:
            return self._bytes

    def _touch(self, path: Path) -> PixelArray | None:
        picture = self._pictures.get(path)
        if picture is not None:
            self._pictures.move_to_end(path)
        return picture

    def _decode(self, path: Path) -> PixelArray:
        """Decode a path that the caller has put into `_decoding`."""
        picture: PixelArray | None = None
        stamp = _file_stamp(path)  # before it is read: what is written meanwhile is read again
        try:
            picture = decode_bgra(path)
        finally:
            with self._changed:
                self._decoding.discard(path)
                if picture is not None and not self._closed:
                    self._store(path, picture, stamp)
                self._changed.notify_all()
        return picture

    def _store(self, path: Path, picture: PixelArray, stamp: _FileStamp | None) -> None:
        if (older := self._pictures.pop(path, None)) is not None:
            self._bytes -= older.nbytes
        self._pictures[path] = picture
        self._stamps[path] = stamp
        self._bytes += picture.nbytes
        while self._bytes > self._max_bytes and len(self._pictures) > self._kept_at_least:
            name, oldest = self._pictures.popitem(last=False)
            del self._stamps[name]
            self._bytes -= oldest.nbytes

    def _prefetch_queue(self) -> None:
        while True:
            with self._changed:
                if not self._queue:
                    self._prefetching = False
                    return
                path = self._queue.popleft()
                if path in self._pictures or path in self._decoding:
                    continue
                self._decoding.add(path)
            try:
                self.foresee(self._decode(path))
            except ImageError:
                continue  # told when somebody asks for this picture


def _file_stamp(path: Path) -> _FileStamp | None:
    """None for what is out of reach, and for a frame of a video."""
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size
