"""What pulls cameras where they belong: lines to the paint beside them, paint to the lines."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.from_picture.field_lines import FieldLines
from procc_annotator.fit.from_picture.seen_paint import (
    HALF_WIDTH,
    LIKE_RAD,
    SeenPaint,
    cells_of,
    directions_of,
)
from procc_annotator.fit.solving.jacobian import Lens, project
from procc_annotator.fit.solving.models import FREE
from procc_annotator.fit.solving.observations import FloatArray, IntArray

_NEAREST_M, _INSIDE_PX = 1.0, 2.0
_BESIDE_PX = 20.0  # along the line, from paint to the place that is nearest to it


@dataclass(frozen=True, eq=False)
class Pulls:
    """K pulls on each of B cameras.

    Attributes:
        off: (B, K) solver px across the line, from where the camera shows it to the paint.
        by: (B, free, K) how the place moves across with the camera's parameters.
        known: (B, K) whether there is a pull at all.
        in_view: (B, K) whether the place is in the picture.
        away: (B, K) solver px to the paint in any direction.
    """

    off: FloatArray
    by: FloatArray
    known: NDArray[np.bool_]
    in_view: NDArray[np.bool_]
    away: NDArray[np.floating]


def lines_to_paint(
    vectors: FloatArray,
    places: IntArray,
    lines: FieldLines,
    paint: SeenPaint,
    free: int,
) -> Pulls:
    """Places of lines (B, K), pulled to the nearest paint of their direction."""
    lens, near = Lens.of(vectors, paint.frame.half_diagonal), paint.near
    world, along = (one[:, places].transpose(1, 0, 2) for one in (lines.world, lines.along))
    depth = (lens.linear[:, 2:, :3] @ world)[:, 0] + lens.linear[:, 2, 3:]
    ahead = depth > _NEAREST_M
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        points, moved, derivatives = _shown(lens, world, along, free)
        points = np.where(ahead[:, None], points, 1e6)
        in_view = ahead & (np.abs(points[:, 0]) < HALF_WIDTH - _INSIDE_PX)
        in_view &= np.abs(points[:, 1]) < paint.half_height - _INSIDE_PX
        normal = _normal(moved)
        direction = directions_of(np.arctan2(-normal[:, 0], normal[:, 1]))
    column, row = cells_of(points, paint.half_height, near.cell)
    found = near.place[direction, row, column]
    apart = paint.points[:, found].transpose(1, 0, 2) - points
    off = (normal * apart).sum(axis=1)
    by = np.einsum("bkn,bpkn->bpn", normal, derivatives)
    known = in_view & (found >= 0)
    return Pulls(off, by, known, in_view, near.away[direction, row, column])


def paint_to_lines(
    vectors: FloatArray, some: IntArray, lines: FieldLines, paint: SeenPaint, free: int
) -> Pulls:
    """Paint on the ground (n,), pulled to the nearest line; unknown where that runs another way."""
    lens = Lens.of(vectors, paint.frame.half_diagonal)
    points, direction = paint.points[:, some], paint.along[some]
    place = _nearest(lens, points, lines)
    world, along = (
        one[:, np.maximum(place, 0)].transpose(1, 0, 2) for one in (lines.world, lines.along)
    )
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        shown, moved, derivatives = _shown(lens, world, along, free)
        normal = _normal(moved)
        apart = points - shown
        off = (normal * apart).sum(axis=1)
        beside = np.abs(normal[:, 1] * apart[:, 0] - normal[:, 0] * apart[:, 1])
        like = np.abs(normal[:, 1] * np.cos(direction) - normal[:, 0] * np.sin(direction))
        known = (place >= 0) & (like > np.cos(LIKE_RAD)) & (beside < _BESIDE_PX)
        by = np.einsum("bkn,bpkn->bpn", normal, derivatives)
    return Pulls(off, by, known, np.ones_like(known), np.abs(off))


def _nearest(lens: Lens, points: FloatArray, lines: FieldLines) -> IntArray:
    """(B, n) the place on a line nearest to where cameras see points (2, n) on the ground."""
    on_ground = np.linalg.inv(lens.linear[:, :, [0, 1, 3]])
    rays = on_ground[:, :, :2] @ lens.undistorted(points) + on_ground[:, :, 2:]
    below = rays[:, 2] > 1e-9
    place = lines.nearest.at(rays[:, :2] / np.where(below, rays[:, 2], 1.0)[:, None])
    return np.asarray(np.where(below, place, -1))


def _shown(
    lens: Lens, world: FloatArray, along: FloatArray, free: int
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """As `project`, but of cameras with P's and R's parameters, and quicker without derivatives."""
    if free >= FREE["P"]:
        return project(lens, world, along, free)
    place = lens.linear[:, :, :3] @ world + lens.linear[:, :, 3:]
    toward = lens.linear[:, :, :3] @ along
    v = place[:, :2] / place[:, 2:]
    v_along = (toward[:, :2] - v * toward[:, 2:]) / place[:, 2:]
    grown = 1 + lens.bend * (v * v).sum(axis=1)
    moved = v_along * grown[:, None] + 2 * lens.bend[:, None] * v * (v_along * v).sum(
        axis=1, keepdims=True
    )
    return v * grown[:, None], moved, np.zeros((len(v), 0, 2, v.shape[2]))


def _normal(moved: FloatArray) -> FloatArray:
    """(B, 2, n) unit vectors across those directions."""
    length = np.hypot(moved[:, 0], moved[:, 1]) + 1e-9
    return np.stack([-moved[:, 1] / length, moved[:, 0] / length], axis=1)
