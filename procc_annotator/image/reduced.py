"""Pictures made smaller to be looked at, before they are wanted."""

from __future__ import annotations

import threading
import weakref
from collections import deque

import cv2
import numpy as np

from procc_annotator.image.pixels import PixelArray, empty_bgra

Size = tuple[int, int]

_CACHED_IMAGES = 3  # the picture on screen and those that may come next


def downscaled(pixels: PixelArray, size: Size, made: PixelArray | None = None) -> PixelArray:
    """A picture made smaller, to (width, height), without losing thin lines; in memory of its own,
    or in ``made``, which is of that size.

    Below one half, sampling between four neighbours would skip pixels; averaging comes first. It
    is done by whole factors, where it takes a thirtieth of the time.
    """
    factor = 1
    while pixels.shape[1] >= 2 * factor * size[0] and pixels.shape[0] >= 2 * factor * size[1]:
        factor *= 2
    small = pixels
    if factor > 1:
        inner = pixels.shape[1] // factor, pixels.shape[0] // factor
        small = np.asarray(cv2.resize(pixels, inner, interpolation=cv2.INTER_AREA), dtype=np.uint8)
    made = empty_bgra(*size) if made is None else made
    cv2.resize(small, size, dst=made, interpolation=cv2.INTER_LINEAR)
    return made


class DownscaledImages:
    """The last few pictures made smaller; safe to use from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._kept: deque[tuple[weakref.ref[PixelArray], Size, PixelArray]] = deque(maxlen=_CACHED_IMAGES)
        self._scale: float | None = None
        self._lent: PixelArray | None = None  # what somebody looks at

    def of(self, pixels: PixelArray, scale: float, whole: Size | None = None) -> PixelArray:
        """A picture at a scale below 1, which those that are foreseen are made to from now on. It
        stays as it is until another one is asked for.

        Args:
            whole: (width, height) px that the scale is of, where ``pixels`` are but half as many a
                side; None: there are as many.
        """
        with self._lock:
            self._scale = scale
        self._lent = self._made(pixels, scale, whole)
        return self._lent

    def foresee(self, pixels: PixelArray) -> None:
        """Make a picture as small as the last one that was asked for."""
        with self._lock:
            scale = self._scale
        if scale is not None:
            self._made(pixels, scale, None)

    def _made(self, pixels: PixelArray, scale: float, whole: Size | None) -> PixelArray:
        width, height = whole or (pixels.shape[1], pixels.shape[0])
        size = max(1, round(width * scale)), max(1, round(height * scale))
        with self._lock:
            for kept, kept_size, small in self._kept:
                if kept() is pixels and kept_size == size:
                    return small
        small = downscaled(pixels, size, self._spare(size))
        with self._lock:
            self._kept.append((weakref.ref(pixels), size, small))
        return small

    def _spare(self, size: Size) -> PixelArray | None:
        """The memory of the picture that goes, if nobody looks at it: the system takes its time
        over new memory."""
        with self._lock:
            if len(self._kept) < _CACHED_IMAGES:
                return None
            oldest = self._kept.popleft()[2]
        return oldest if oldest is not self._lent and oldest.shape[1::-1] == size else None
