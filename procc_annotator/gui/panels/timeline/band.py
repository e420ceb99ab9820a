"""The band of a strip as pixels: how surely each frame's camera is known, at a glance.

A column of pixels shows the worst of its frames. Its height is the share of the lines found on
paint, its colour goes with the distance from them; doubtful frames are dotted, lost ones low, so
that colour is never the only sign.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.gui.panels.timeline.axis import Axis
from procc_annotator.interaction import palette as tones

Pixels = NDArray[np.uint32]

_LOST_HEIGHT = 0.12
_LEAST_HEIGHT = 0.25  # of a frame that has a camera
_DOT = 2  # px of the screen


@dataclass(frozen=True, eq=False)
class Band:
    """What is known of the frames of a sequence, by number from the first.

    Attributes:
        coverage: (n,) share of the lines on paint, 0 to 1; 0 for a lost frame, NaN where no one
            looked.
        distance: (n,) of the paint from the lines as a share of what is still sure, 0 to 1.
        doubtful: (n,) whether a person should look.
        lost: (n,) whether there is no camera.
    """

    coverage: FloatArray
    distance: FloatArray
    doubtful: NDArray[np.bool_]
    lost: NDArray[np.bool_]

    @classmethod
    def unknown(cls, count: int) -> Band:
        """No one examined any frame."""
        off = np.zeros(count, dtype=bool)
        return cls(np.full(count, np.nan), np.zeros(count), off, off.copy())


def band_pixels(band: Band, axis: Axis, size: tuple[int, int]) -> Pixels:
    """The band as (height, width) 0xAARRGGBB, transparent where nothing is known.

    Args:
        band: of the whole sequence.
        axis: in whatever px; its frames are spread over the width.
        size: (width, height) px of the screen.
    """
    width, height = size
    edges = axis.begin + (axis.end - axis.begin) * np.arange(width + 1) / width
    begin = np.clip(np.floor(edges[:-1]).astype(np.intp) - axis.first, 0, len(band.lost) - 1)
    past = np.clip(np.ceil(edges[1:]).astype(np.intp) - axis.first, begin + 1, len(band.lost))
    known = ~np.isnan(band.coverage)
    coverage = _least(np.where(known, band.coverage, np.inf), begin, past)
    doubtful = -_least(-(band.doubtful & known).astype(np.float64), begin, past) > 0
    lost = -_least(-(band.lost & known).astype(np.float64), begin, past) > 0
    distance = -_least(-np.where(known, band.distance, 0.0), begin, past)
    tops = np.where(lost, _LOST_HEIGHT, np.maximum(coverage, _LEAST_HEIGHT))
    rows = np.where(np.isfinite(coverage), np.ceil(np.minimum(tops, 1.0) * height), 0)
    filled = np.arange(height)[::-1, None] < rows[None, :]
    dots = (np.arange(height)[:, None] // _DOT + np.arange(width)[None, :] // _DOT) % 2 == 0
    filled &= ~(doubtful & ~lost)[None, :] | dots
    return np.where(filled, _colours(distance, doubtful, lost)[None, :], np.uint32(0))


def _least(values: FloatArray, begin: NDArray[np.intp], past: NDArray[np.intp]) -> FloatArray:
    """(width,) the least of the values from each begin to before each end."""
    pairs = np.column_stack((begin, past)).ravel()
    padded = np.append(values, np.inf)  # an end may be that of all
    return np.asarray(np.minimum.reduceat(padded, pairs)[::2])


def _colours(
    distance: FloatArray, doubtful: NDArray[np.bool_], lost: NDArray[np.bool_]
) -> NDArray[np.uint32]:
    good, far, gone = (_rgb(tone) for tone in (tones.PASSES, tones.NOT_ANNOTATED, tones.TOO_FAR))
    share = np.clip(distance, 0.0, 1.0)[:, None] * 0.7
    mixed = good * (1 - share) + far * share
    mixed = np.where(doubtful[:, None], far, mixed)
    red, green, blue = np.where(lost[:, None], gone, mixed).round().astype(np.uint32).T
    packed = (red << 16) | (green << 8) | blue
    return np.asarray(packed | np.uint32(0xFF000000), dtype=np.uint32)


def _rgb(tone: str) -> FloatArray:
    return np.array([int(tone[i : i + 2], 16) for i in (1, 3, 5)], dtype=np.float64)
