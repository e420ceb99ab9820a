"""Where the ends of straight elements belong: at the corner or the picture's edge nearby."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from procc_annotator.annotation import FloatArray

ImageSize = tuple[int, int]

# Lines at less than about six degrees have no corner that two clicks could tell.
_MIN_CROSSING_SINE = 0.1


def expected_line_end(
    end: FloatArray,
    inner: FloatArray,
    lines: Sequence[FloatArray],
    size: ImageSize | None,
    reach_px: float,
) -> FloatArray | None:
    """Where the end of a straight element belongs.

    Args:
        end: (2,) px, its last point.
        inner: (2,) px, the point before.
        lines: (n, 2) px each: the clicks of annotated straight elements that it meets.
        size: (width, height) px of the picture; None for corners alone.
        reach_px: how far the end may be moved, along its own line.

    Returns:
        (2,) px: the nearest corner within reach, else the picture's edge; None where neither is.
    """
    along = end - inner
    length = float(np.hypot(*along))
    if length < 1e-6:
        return None
    along = along / length
    corners = [corner for line in lines if (corner := _segment_intersection(end, along, line)) is not None]
    near = [c for c in corners if np.hypot(*(c - end)) <= reach_px]
    if near:
        return min(near, key=lambda c: float(np.hypot(*(c - end))))
    edge = None if size is None else image_edge_point(end, along, size)
    return edge if edge is not None and np.hypot(*(edge - end)) <= reach_px else None


def _segment_intersection(end: FloatArray, along: FloatArray, line: FloatArray) -> FloatArray | None:
    """Where the ray's line meets the end segment of another polyline that is nearer, px."""
    first = np.hypot(*(line[0] - end)) <= np.hypot(*(line[-1] - end))
    begin, other = (line[0], line[1]) if first else (line[-1], line[-2])
    across = other - begin
    determinant = along[0] * -across[1] + along[1] * across[0]
    # Not "<": two clicks in one place have no direction.
    if abs(determinant) <= _MIN_CROSSING_SINE * float(np.hypot(*across)):
        return None
    offset = begin - end
    distance = (offset[0] * -across[1] + offset[1] * across[0]) / determinant
    found: FloatArray = end + distance * along
    return found


def image_edge_point(end: FloatArray, along: FloatArray, size: ImageSize) -> FloatArray | None:
    """Where the ray from a place in the picture leaves it; None from outside.

    Args:
        end: (2,) px.
        along: (2,) direction.
        size: (width, height) px of the picture.
    """
    limits = np.array(size, dtype=np.float64) - 1
    if (end < 0).any() or (end > limits).any():
        return None
    found: FloatArray = end + steps_to_image_edge(end, along, limits) * along
    return np.clip(found, 0.0, limits)


def steps_to_image_edge(place: FloatArray, step: FloatArray, limits: FloatArray) -> float:
    """How many steps lead from a place to the picture's edge.

    Args:
        place: (2,) px, inside.
        step: (2,) px.
        limits: (2,) px, the last column and row; the first ones are 0.

    Returns:
        Infinity for a step of no length.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        steps = np.where(
            step > 0, (limits - place) / step, np.where(step < 0, -place / step, np.inf)
        )
    return float(steps.min())
