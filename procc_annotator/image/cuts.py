"""Cuts across a direction: the colours around a position, sampled in its own frame."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.image.pixels import PixelArray

Values = NDArray[np.float32]

STEP_PX = 0.5  # between the samples of a cut
_REMAP_FLAGS = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP


@dataclass(frozen=True, eq=False)
class ImagePatch:
    """A position and its surroundings.

    Attributes:
        pixels: (h, w, 4) BGRA, a part of the picture.
        centre: of the position, px of the part.
    """

    pixels: PixelArray
    centre: tuple[float, float]

    @classmethod
    def around(
        cls, picture: PixelArray, point: tuple[float, float], reach_px: float, shrink: int = 1
    ) -> ImagePatch:
        """What lies within a distance, at the picture's border less; so many times smaller."""
        x, y = point
        reach = math.ceil(reach_px) + 2
        left, top = max(0, round(x) - reach), max(0, round(y) - reach)
        part = picture[top : round(y) + reach + 1, left : round(x) + reach + 1]
        x, y = x - left, y - top
        if shrink == 1:
            return cls(part, (x, y))
        height, width = (max(1, side // shrink) for side in part.shape[:2])
        whole = part[: height * shrink, : width * shrink]
        small = cv2.resize(whole, (width, height), interpolation=cv2.INTER_AREA)
        inwards = (shrink - 1) / 2
        centre = (x - inwards) / shrink, (y - inwards) / shrink
        return cls(np.asarray(small, dtype=np.uint8), centre)

    def across(self, angle: float, offset_px: float) -> ImagePatch:
        """The same pixels around a place across a direction from the position."""
        x, y = self.centre
        return ImagePatch(
            self.pixels, (x - offset_px * math.sin(angle), y + offset_px * math.cos(angle))
        )

    def cuts(
        self, angles: Sequence[float], along_px: float, every_px: float, samples: int
    ) -> PixelArray:
        """Sample lines across directions through the position.

        Args:
            angles: (A,) of the directions, radians.
            along_px: how far along each the last cut is; the first one is as far back.
            every_px: between cuts.
            samples: of each cut to either side, `STEP_PX` apart.

        Returns:
            (cuts, A, 2 samples + 1, 4) BGRA; what lies beyond the part mirrors it.
        """
        count, width = round(2 * along_px / every_px) + 1, 2 * samples + 1
        found = np.empty((count, len(angles), width, 4), dtype=np.uint8)
        (x, y), aside = self.centre, samples * STEP_PX
        for i, angle in enumerate(angles):
            cos, sin = math.cos(angle), math.sin(angle)
            from_x, from_y = x - along_px * cos + aside * sin, y - along_px * sin - aside * cos
            turned = np.array(
                [
                    [-STEP_PX * sin, every_px * cos, from_x],
                    [STEP_PX * cos, every_px * sin, from_y],
                ]
            )
            cv2.warpAffine(
                self.pixels,
                turned,
                (width, count),
                dst=found[:, i],
                flags=_REMAP_FLAGS,
                borderMode=cv2.BORDER_REFLECT,
            )
        return found
