"""Places of a field's lines that cameras show, evenly spread over what they show of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.from_picture.field_lines import FieldLinePoints
from procc_annotator.fit.from_picture.seen_paint import HALF_WIDTH_PX
from procc_annotator.fit.solving.jacobian import Lens
from procc_annotator.fit.solving.observations import FloatArray, IntArray

_MIN_DEPTH_M, _VIEW_BORDER_PX, _MAX_STEP_PX = 1.0, 6.0, 120.0
_VIEW_BATCH = 512  # cameras: more at once take more memory, fewer more calls
_COMPARED_POINTS = 40  # places


@dataclass(frozen=True, eq=False)
class VisiblePoints:
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


def visible_line_points(vectors: FloatArray, lines: FieldLinePoints, half_height: float, count: int) -> VisiblePoints:
    """So many places a camera, each standing for the same length in its picture.

    Args:
        vectors: (B, 11) cameras.
        lines: of the field.
        half_height: of the picture, solver px.
        count: K.
    """
    parts = [
        _visible_line_points(vectors[first : first + _VIEW_BATCH], lines, half_height, count)
        for first in range(0, max(len(vectors), 1), _VIEW_BATCH)
    ]
    return VisiblePoints(*(np.concatenate(one) for one in zip(*parts, strict=True)))


def _visible_line_points(
    vectors: FloatArray, lines: FieldLinePoints, half_height: float, count: int
) -> tuple[IntArray, FloatArray, FloatArray, FloatArray]:
    linear = Lens.of(vectors, 1.0).linear.astype(np.float32)
    # One product of two large matrices is many times as fast as many products of small ones.
    flat, total_places = linear.reshape(-1, 4), lines.world.shape[1]
    place = (flat @ lines.homogeneous).reshape(-1, 3, total_places)
    toward = (flat[:, :3] @ lines.along_float32).reshape(-1, 3, total_places)
    near = 1 / np.maximum(place[:, 2], _MIN_DEPTH_M)
    x, y = place[:, 0] * near, place[:, 1] * near
    inside = (np.abs(x) < HALF_WIDTH_PX - _VIEW_BORDER_PX) & (np.abs(y) < half_height - _VIEW_BORDER_PX)
    inside &= place[:, 2] > _MIN_DEPTH_M
    blind = ~inside.any(axis=1)
    inside[blind, -1] = True
    # S places that cameras see, a few of all: one camera's after the other's.
    seen = np.flatnonzero(inside)
    row = seen // total_places
    column = seen - row * total_places
    near, x, y = near.take(seen), x.take(seen), y.take(seen)
    at = seen + row * (2 * total_places)
    forth = toward.take(at + 2 * total_places)
    across = (toward.take(at) - x * forth) * near
    down = (toward.take(at + total_places) - y * forth) * near
    length = np.sqrt(across * across + down * down) * lines.step_float32[column]
    length = np.where(blind[row], 0, np.minimum(length, _MAX_STEP_PX))
    total, times = _evenly_along(length, row, np.count_nonzero(inside, axis=1), count)
    taken = np.repeat(np.arange(len(seen)), times)
    shape = (len(vectors), count)
    points = np.stack([x[taken].reshape(shape), y[taken].reshape(shape)], axis=1)
    angles = np.arctan2(down[taken], across[taken]).reshape(shape)
    return column[taken].reshape(shape), total, points, np.asarray(angles)


def _evenly_along(
    length: NDArray[np.float32], row: IntArray, seen: IntArray, count: int
) -> tuple[FloatArray, IntArray]:
    """Along what each of B cameras sees.

    Args:
        length: (S,) that places stand for, one camera's after the other's.
        row: (S,) the camera's.
        seen: (B,) how many places a camera sees, one at least.
        count: of the places it takes.

    Returns:
        (B,) the lengths together; (S,) how often a place is taken.
    """
    end = np.cumsum(seen)
    first = end - seen
    rank = np.arange(len(length)) - first[row]
    gone = np.zeros((int(seen.max()), len(seen)), dtype=np.float32)
    gone[rank, row] = length
    np.cumsum(gone, axis=0, out=gone)
    total = gone[-1].copy()
    # A place is taken as often as the length up to it passes another part of the whole.
    parts = (count / np.maximum(total, 1))[row]
    passed = np.floor(gone[rank, row] * parts + 1e-3).astype(np.int32)
    np.minimum(passed, count, out=passed)
    passed[end - 1] = count
    times = np.diff(passed, prepend=0)
    times[first] = passed[first]
    return np.asarray(total, dtype=gone.dtype), times


def view_distance_px(
    vector: FloatArray, others: FloatArray, lines: FieldLinePoints, half_height: float
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
    chosen = visible_line_points(vector[None], lines.coarsest, half_height, _COMPARED_POINTS).places[0]
    world = lines.coarsest.world[:, chosen]
    linear = Lens.of(np.concatenate([vector[None], others]), 1.0).linear
    place = linear[:, :, :3] @ world + linear[:, :, 3:]
    points = place[:, :2] / np.where(place[:, 2:] > _MIN_DEPTH_M, place[:, 2:], 1e-3)
    return np.asarray(np.median(np.hypot(*(points[1:] - points[0]).transpose(1, 0, 2)), axis=1))
