"""Decoded pictures kept in memory, so that going back and forth does not decode again."""

from __future__ import annotations

import threading
from collections import OrderedDict, deque
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from procc_annotator.errors import ImageError
from procc_annotator.image.decode import PixelArray, decode_bgra

_MIN_KEPT = 3  # the frame on screen and the two that may come next


_FileStamp = tuple[int, int]  # of a file: when it was written, in ns, and its bytes


class FrameCache:
    """The pictures used last, up to a number of bytes; safe to use from any thread.

    The newest few are kept even if they exceed the limit: with large pictures, the neighbours of
    the frame on screen must not push each other out. Failures are not remembered: a picture that
    was repaired meanwhile is read again; so is one whose file was replaced, by `get`.
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

        Raises:
            ImageError: it is not a readable picture.
        """
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

        Raises:
            ImageError: it is not a readable picture.
        """
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
