"""Places of a field's lines that cameras show, evenly spread over what they show of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.from_picture.field_lines import FieldLines
from procc_annotator.fit.from_picture.seen_paint import HALF_WIDTH
from procc_annotator.fit.solving.jacobian import Lens
from procc_annotator.fit.solving.observations import FloatArray, IntArray

_NEAREST_M, _BORDER_PX, _LONGEST_PX = 1.0, 6.0, 120.0
_AT_ONCE = 64  # cameras
_COMPARED = 40  # places


@dataclass(frozen=True, eq=False)
class InView:
    """K places for each of B cameras; those without a line in sight have any.

    Attributes:
        places: (B, K) of the lines.
        length_px: (B,) solver px of the lines in sight.
        points: (B, 2, K) where they appear, without distortion.
        angles: (B, K) rad, the direction they run there.
    """

    places: IntArray
    length_px: FloatArray
    points: FloatArray
    angles: FloatArray


def in_view(vectors: FloatArray, lines: FieldLines, half_height: float, count: int) -> InView:
    """So many places a camera, each standing for the same length in its picture.

    Args:
        vectors: (B, 11) cameras.
        lines: of the field.
        half_height: of the picture, solver px.
        count: K.
    """
    parts = [
        _in_view(vectors[first : first + _AT_ONCE], lines, half_height, count)
        for first in range(0, max(len(vectors), 1), _AT_ONCE)
    ]
    return InView(*(np.concatenate(one) for one in zip(*parts, strict=True)))


def _in_view(
    vectors: FloatArray, lines: FieldLines, half_height: float, count: int
) -> tuple[IntArray, FloatArray, FloatArray, FloatArray]:
    linear = Lens.of(vectors, 1.0).linear.astype(np.float32)
    # One product of two large matrices is many times as fast as many products of small ones.
    flat, total_places = linear.reshape(-1, 4), lines.world.shape[1]
    place = (flat @ lines.homogeneous).reshape(-1, 3, total_places)
    toward = (flat[:, :3] @ lines.along_float32).reshape(-1, 3, total_places)
    depth = place[:, 2]
    ahead = depth > _NEAREST_M
    near = np.where(ahead, 1 / np.where(ahead, depth, 1), 0)
    x, y = place[:, 0] * near, place[:, 1] * near
    inside = ahead & (np.abs(x) < HALF_WIDTH - _BORDER_PX) & (np.abs(y) < half_height - _BORDER_PX)
    across, down = (
        (toward[:, 0] - x * toward[:, 2]) * near,
        (toward[:, 1] - y * toward[:, 2]) * near,
    )
    length = np.sqrt(across * across + down * down) * lines.step.astype(np.float32)
    length = np.where(inside, np.minimum(length, _LONGEST_PX), 0)
    gone = np.cumsum(length, axis=1)
    total = gone[:, -1].copy()
    # A place is taken as often as the length up to it passes another K-th part of the whole.
    passed = np.floor(gone * (count / np.maximum(total, 1))[:, None] + 1e-3).astype(np.int32)
    np.minimum(passed, count, out=passed)
    passed[:, -1] = count
    times = np.diff(passed, axis=1, prepend=0)
    passing = np.nonzero(times)
    chosen = np.repeat(passing[1], times[passing]).reshape(len(vectors), count)
    row = np.arange(len(vectors))[:, None]
    points = np.stack([x[row, chosen], y[row, chosen]], axis=1)
    return chosen, total, points, np.arctan2(down[row, chosen], across[row, chosen])


def apart_px(
    vector: FloatArray, others: FloatArray, lines: FieldLines, half_height: float
) -> FloatArray:
    """How far apart cameras show the lines that one of them has in view.

    Args:
        vector: (11,) the one.
        others: (B, 11).
        lines: of the field.
        half_height: of the picture, solver px.

    Returns:
        (B,) median of the distances, solver px.
    """
    chosen = in_view(vector[None], lines.coarsest, half_height, _COMPARED).places[0]
    world = lines.coarsest.world[:, chosen]
    linear = Lens.of(np.concatenate([vector[None], others]), 1.0).linear
    place = linear[:, :, :3] @ world + linear[:, :, 3:]
    points = place[:, :2] / np.where(place[:, 2:] > _NEAREST_M, place[:, 2:], 1e-3)
    return np.asarray(np.median(np.hypot(*(points[1:] - points[0]).transpose(1, 0, 2)), axis=1))
