"""The pictures of a shot for who follows it: one that cannot be used stops nobody."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from procc_annotator.errors import ImageError
from procc_annotator.fit.through_shot.track import TrackedFrame
from procc_annotator.image.pixels import PixelArray

_ANY_SHAPE = (90, 160, 4)  # nothing of it will be seen


class UsablePictures:
    """Those that cannot be used are black, and remembered; for one thread at a time.

    Attributes:
        damaged: number -> why its picture cannot be used, of those that were asked for.
    """

    def __init__(
        self,
        read: Callable[[int], PixelArray],
        numbers: range,
        name: Callable[[int], str],
    ) -> None:
        """Nothing is read yet.

        Args:
            read: number -> (H, W, 4) BGRA; may raise `ImageError`.
            numbers: all there are.
            name: what a picture is called where its size is told.
        """
        self.damaged: dict[int, str] = {}
        self._read, self._numbers, self._name = read, numbers, name
        self._shape: tuple[int, ...] | None = None
        self._last: PixelArray | None = None  # of `or_last`

    def or_last(self, number: int) -> PixelArray:
        """(H, W, 4) BGRA; the usable one asked for before instead of a black one, for who looks
        for cuts: black is none."""
        picture = self(number)
        if number in self.damaged:
            return picture if self._last is None else self._last
        self._last = picture
        return picture

    def __call__(self, number: int) -> PixelArray:
        """(H, W, 4) BGRA."""
        try:
            picture = self._read(number)
        except ImageError as error:
            self.damaged[number] = str(error)
            return self._black()
        if self._shape is None:
            self._shape = picture.shape
        if picture.shape != self._shape:
            height, width = self._shape[:2]
            self.damaged[number] = (
                f"{self._name(number)}: is not {width}x{height} px as the first of its shot"
            )
            return self._black()
        return picture

    def _black(self) -> PixelArray:
        if self._shape is None:
            self._shape = self._first_readable()
        black = np.zeros(self._shape, dtype=np.uint8)
        black[..., 3] = 255
        return black

    def _first_readable(self) -> tuple[int, ...]:
        for number in self._numbers:
            try:
                return self._read(number).shape
            except ImageError:
                continue
        return _ANY_SHAPE


def lost_frame(one: TrackedFrame, why: str) -> TrackedFrame:
    """A frame whose picture could not be used: it has no camera, whatever the picture gave."""
    return replace(
        one, state="lost", reason=why, fit=None, coverage=0.0, residual_px=None,
        anchor_distance=None,
    )  # fmt: skip
