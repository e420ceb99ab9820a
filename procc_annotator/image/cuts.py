"""Cuts across a direction: the colours around a position, sampled in its own frame."""

from __future__ import annotations

import math
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.image.pixels import PixelArray

FloatArray = NDArray[np.float64]

Values = NDArray[np.float32]

STEP_PX = 0.5  # between the samples of a cut


@dataclass(frozen=True, eq=False)
class Patch:
    """The surroundings of a position.

    Attributes:
        pixels: (h, w, 3) or (h, w) uint8, a part of the picture.
        centre: of the position, px of the part.
    """

    pixels: PixelArray
    centre: tuple[float, float]

    @classmethod
    def around(
        cls, picture: PixelArray, point: tuple[float, float], reach_px: float, shrink: int = 1
    ) -> Patch:
        """What lies within a distance, at the picture's border less; so many times smaller."""
        x, y = point
        reach = math.ceil(reach_px) + 2
        left, top = max(0, round(x) - reach), max(0, round(y) - reach)
        part = picture[top : round(y) + reach + 1, left : round(x) + reach + 1, :3]
        x, y = x - left, y - top
        if shrink == 1:
            return cls(np.ascontiguousarray(part), (x, y))
        height, width = (max(1, side // shrink) for side in part.shape[:2])
        whole = np.ascontiguousarray(part[: height * shrink, : width * shrink])
        small = cv2.resize(whole, (width, height), interpolation=cv2.INTER_AREA)
        inwards = (shrink - 1) / 2
        return cls(np.asarray(small), ((x - inwards) / shrink, (y - inwards) / shrink))

    def palest(self) -> Patch:
        """The smallest of the three channels, which shows white paint on saturated ground best."""
        blue, green, red = cv2.split(self.pixels)
        return Patch(np.asarray(cv2.min(cv2.min(blue, green), red), dtype=np.uint8), self.centre)

    def cuts(self, angles: FloatArray, along: FloatArray, across: FloatArray) -> Values:
        """Sample lines across directions through the position.

        Args:
            angles: (A,) of the directions, radians.
            along: (..., S) how far along the direction each cut is, px.
            across: (T,) how far across it its samples are, px.

        Returns:
            (A, ..., S, T, channels) colours; what lies beyond the part mirrors it.
        """
        shape = (len(angles), *along.shape, len(across))
        cos, sin = np.cos(angles), np.sin(angles)
        s, t = along.reshape(-1)[None, :, None], across[None, None, :]
        x = self.centre[0] + s * cos[:, None, None] - t * sin[:, None, None]
        y = self.centre[1] + s * sin[:, None, None] + t * cos[:, None, None]
        flat = (-1, len(across))
        found = cv2.remap(
            self.pixels.astype(np.float32),
            x.reshape(flat).astype(np.float32),
            y.reshape(flat).astype(np.float32),
            cv2.INTER_LINEAR,
            borderMode=cv2.BORDER_REFLECT,
        )
        return np.asarray(found, dtype=np.float32).reshape(*shape, -1)
