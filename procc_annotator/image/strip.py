"""The picture along a curve, straightened: how a line and the ground beside it look all along."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.image.decode import PixelArray

FloatArray = NDArray[np.float64]
Values = NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class StraightenedCurve:
    """A curve's surroundings.

    Attributes:
        colours: (n, m, 3) BGR, one row a place along the curve, one column an offset across it.
        offsets_px: (m,) evenly spaced, symmetric about 0.
    """

    colours: Values
    offsets_px: FloatArray

    def columns(self, first_px: float, last_px: float) -> slice:
        """The columns between two offsets, both included; at least one."""
        step = self.offsets_px[1] - self.offsets_px[0]
        begin = round((first_px - self.offsets_px[0]) / step)
        end = round((last_px - self.offsets_px[0]) / step)
        begin = min(max(begin, 0), len(self.offsets_px) - 1)
        return slice(begin, min(max(end, begin), len(self.offsets_px) - 1) + 1)


def straighten_curve(
    picture: PixelArray,
    course_px: FloatArray,
    across: FloatArray,
    reach_px: float,
    step_px: float = 0.5,
) -> StraightenedCurve:
    """Cut a curve's surroundings out of a picture.

    Args:
        picture: (H, W, 4) BGRA.
        course_px: (n, 2) places along the curve, picture px.
        across: (n, 2) unit vectors across it.
        reach_px: how far to go to both sides.
        step_px: between offsets.

    Returns:
        Bilinearly interpolated and rounded; beyond the picture its last row or column is repeated.
    """
    half = round(reach_px / step_px)
    offsets = np.arange(-half, half + 1, dtype=np.float64) * step_px
    places = course_px[:, None] + across[:, None] * offsets[None, :, None]
    low = np.floor(places.min(axis=(0, 1))).astype(int) - 1
    high = np.ceil(places.max(axis=(0, 1))).astype(int) + 2
    low = np.maximum(low, 0)
    high = np.minimum(np.maximum(high, low + 1), (picture.shape[1], picture.shape[0]))
    low = np.minimum(low, high - 1)
    # Only the part that is needed: remapping wants three channels of its own.
    part = np.ascontiguousarray(picture[low[1] : high[1], low[0] : high[0], :3])
    places = (places - low).astype(np.float32)
    values = cv2.remap(
        part,
        np.ascontiguousarray(places[..., 0]),
        np.ascontiguousarray(places[..., 1]),
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )
    return StraightenedCurve(np.asarray(values, dtype=np.float32), offsets)
