"""Places known exactly on the field and in the picture: where two lines meet, and spots."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.observations import FloatArray, IntArray, Observations

# Two lines of the field meet if they come this close, metres, about as paint is wide, at most this
# share beyond their ends.
_SAME_POINT_M, _EXTENSION_SHARE = 0.15, 0.02
# Where two lines of the picture cross at less than this sine of an angle, or farther out than this
# from its centre (solver px), clicks do not tell well.
_MIN_CROSSING_SINE, _MAX_CROSSING_PX = 0.05, 1000.0
_TINY = 1e-9


def nearest_control_point(seen: Observations) -> tuple[FloatArray, FloatArray] | None:
    """Of the places where two annotated straight elements meet, and of the annotated spots, the one
    nearest to the picture's centre.

    Both lines are prolonged in the picture, so the place need not be visible.

    Args:
        seen: the annotated points.

    Returns:
        The place (3,), metres, and where the picture shows it (2,), solver px; None if there is
        none.
    """
    places, shown = _line_crossings(seen)
    spots = [row for row, element in enumerate(seen.elements) if element.is_spot]
    if spots:
        known = seen.parts.spots[:, : len(spots)]
        places = np.concatenate([places, known], axis=1)
        shown = np.concatenate([shown, seen.points[:, seen.starts[spots]]], axis=1)
    far = np.hypot(shown[0], shown[1])
    if not far.size or far.min() > _MAX_CROSSING_PX:
        return None
    best = int(np.argmin(far))
    return places[:, best], shown[:, best]


def _line_crossings(seen: Observations) -> tuple[FloatArray, FloatArray]:
    """(3, K) metres and (2, K) solver px: where annotated straight elements meet clearly."""
    lines = _straight_count(seen)
    enough = np.flatnonzero(seen.counts[:lines] >= 2)
    first, second = np.triu_indices(len(enough), 1)
    one, other = enough[first], enough[second]
    places, meet = _crossings_on_field(seen, one, other)
    shown, clear = _crossings_in_image(seen, one, other)
    known = meet & clear
    return places[:, known], shown[:, known]


def _straight_count(seen: Observations) -> int:
    """Number of straight elements, which come first, as do their lines."""
    return sum(element.is_straight for element in seen.elements)


def _crossings_on_field(
    seen: Observations, one: IntArray, other: IntArray
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """(3, K) places on lines ``one`` nearest to lines ``other`` (K,), and whether they meet."""
    begin, end = np.split(seen.parts.line_ends, 2, axis=1)
    span_a, span_b = (end - begin)[:, one], (end - begin)[:, other]
    between = begin[:, other] - begin[:, one]
    normal = np.cross(span_a, span_b, axis=0)
    square = (normal * normal).sum(axis=0)
    crossed = square > _TINY
    square = np.where(crossed, square, 1.0)
    along_a = (np.cross(between, span_b, axis=0) * normal).sum(axis=0) / square
    along_b = (np.cross(between, span_a, axis=0) * normal).sum(axis=0) / square
    apart = np.abs((between * normal).sum(axis=0)) / np.sqrt(square)
    within = (np.abs(np.stack([along_a, along_b]) - 0.5) <= 0.5 + _EXTENSION_SHARE).all(axis=0)
    return begin[:, one] + along_a * span_a, crossed & within & (apart < _SAME_POINT_M)


def _crossings_in_image(
    seen: Observations, one: IntArray, other: IntArray
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """(2, K) solver px where the lines of the picture cross, and whether they do so clearly."""
    lines = _straight_count(seen)
    counts = seen.counts[:lines]
    points = seen.points[:, : counts.sum()]
    of_point = seen.element_of_point[: points.shape[1]]
    middle = np.stack([np.bincount(of_point, row, lines) for row in points]) / counts
    x, y = points - middle[:, of_point]
    spread = [np.bincount(of_point, product, lines) for product in (x * x, y * y, x * y)]
    angle = np.arctan2(2 * spread[2], spread[0] - spread[1]) / 2
    cosine, sine = np.cos(angle), np.sin(angle)
    turn = cosine[one] * sine[other] - sine[one] * cosine[other]
    clear = np.abs(turn) > _MIN_CROSSING_SINE
    between = middle[:, other] - middle[:, one]
    along = between[0] * sine[other] - between[1] * cosine[other]
    along = along / np.where(clear, turn, 1.0)
    return middle[:, one] + along * np.stack([cosine[one], sine[one]]), clear
