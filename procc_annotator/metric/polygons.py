"""Convex polygons on a plane: clipping, area, and what a homography makes of them."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from procc_annotator.metric.polylines import BoolArray, FloatArray


def polygon_area(polygon: FloatArray) -> float:
    """The area of a polygon (n, 2), whichever way around; 0 for fewer than three points."""
    if len(polygon) < 3:
        return 0.0
    x, y = (polygon - polygon[0]).T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def clip_by_half_planes(polygon: FloatArray, half_planes: Iterable[FloatArray]) -> FloatArray:
    """The part of a convex polygon where all ``a x + b y + c >= 0`` (Sutherland and Hodgman 1974).

    Args:
        polygon: (n, 2).
        half_planes: (a, b, c) each.

    Returns:
        (m, 2); (0, 2) if nothing is left.
    """
    for half_plane in half_planes:
        if not len(polygon):
            break
        side = polygon @ half_plane[:2] + half_plane[2]
        following, side_after = np.roll(polygon, -1, axis=0), np.roll(side, -1)
        kept: list[FloatArray] = []
        for i, point in enumerate(polygon):
            if side[i] >= 0:
                kept.append(point)
            if (side[i] >= 0) != (side_after[i] >= 0):
                k = side[i] / (side[i] - side_after[i])
                kept.append(point + k * (following[i] - point))
        polygon = np.array(kept).reshape(-1, 2)
    return polygon


def convex_intersection(polygon: FloatArray, other: FloatArray) -> FloatArray:
    """The intersection of two convex polygons, (n, 2) and (m, 2), whichever way around."""
    if len(other) < 3:
        return np.empty((0, 2))
    start, along = other, np.roll(other, -1, axis=0) - other
    inward = np.column_stack((-along[:, 1], along[:, 0]))
    x, y = (other - other[0]).T
    if x @ np.roll(y, -1) < y @ np.roll(x, -1):
        inward = -inward
    return clip_by_half_planes(polygon, np.column_stack((inward, -(inward * start).sum(axis=1))))


def transform_points(matrix: FloatArray, points: FloatArray) -> tuple[FloatArray, BoolArray]:
    """What a homography (3, 3) makes of points (n, 2), and (n,) whether they stay in front."""
    homogeneous = points @ matrix[:, :2].T + matrix[:, 2]
    in_front = homogeneous[:, 2] > 0
    return homogeneous[:, :2] / np.where(in_front, homogeneous[:, 2], 1.0)[:, None], in_front
