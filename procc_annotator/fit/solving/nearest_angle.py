"""The place of a circle or arc that is nearest to a point of the picture, looked for all along it.

Gauss-Newton steps find it where the curve is seen well and the point is near it. Of a curve seen
edge-on, or for a point far off, they may end anywhere: there the whole curve is looked at.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.solving.parts import BoolArray, FloatArray

# Places looked at all along the curve, then in turn about the nearest one of the chords between.
_ALONG, _ABOUT, _TIMES = 17, 9, 3
_CORNER_PX = 1.0
_TINY = 1e-12


@dataclass(frozen=True, eq=False)
class Nearest:
    """Where K curves are nearest to K points.

    Attributes:
        angles: (K,) rad from the middle of the arc; says nothing where the curve is not seen.
        seen: (K,) whether any of it is.
        corner: (K,) whether the way there is not across the curve: it ends there, or bends as
            sharply as a circle does that is seen edge-on.
    """

    angles: FloatArray
    seen: BoolArray
    corner: BoolArray


def nearest_angles(
    curves: FloatArray, half_rad: FloatArray, points: FloatArray, nearest_m: float
) -> Nearest:
    """The angles at which K curves are nearest to K points of the picture.

    Args:
        curves: (K, 3, 3) of each curve its centre, its radius to the middle of the arc and the one
            a quarter turn further, each as (u z, v z, z).
        half_rad: (K,) half of each arc's angle; infinite for a circle.
        points: (K, 2) px.
        nearest_m: what is nearer to the camera's plane is not seen.
    """
    half = half_rad[:, None]
    reach = np.minimum(half, np.pi)
    angles = reach * np.linspace(-1.0, 1.0, _ALONG)
    found = _on_chords(curves, angles, points, nearest_m)
    spacing = reach * 2 / (_ALONG - 1)
    about = np.linspace(-1.0, 1.0, _ABOUT)
    for _ in range(_TIMES):
        angles = np.minimum(np.maximum(found.angles[:, None] + spacing * about, -half), half)
        closer = _on_chords(curves, angles, points, nearest_m)
        # Next to where a curve is lost from sight nothing closer may be seen.
        both = np.where(closer.seen, closer.angles, found.angles)
        found = Nearest(both, found.seen, closer.corner)
        spacing = spacing * 2 / (_ABOUT - 1)
    return found


def _on_chords(
    curves: FloatArray, angles: FloatArray, points: FloatArray, nearest_m: float
) -> Nearest:
    """Where the chords between (K, S) angles of the curves are nearest to the points."""
    turn = np.stack([np.ones_like(angles), np.cos(angles), np.sin(angles)], axis=1)
    place = curves.transpose(0, 2, 1) @ turn
    seen = place[:, 2] >= nearest_m
    shown = place[:, :2] / np.where(seen, place[:, 2], 1.0)[:, None]
    first, chord = shown[:, :, :-1], shown[:, :, 1:] - shown[:, :, :-1]
    off = points[:, :, None] - first
    length = (chord * chord).sum(axis=1) + _TINY
    free = (off * chord).sum(axis=1) / length
    share = np.minimum(np.maximum(free, 0.0), 1.0)
    away = off - share[:, None] * chord
    squares = np.where(seen[:, :-1] & seen[:, 1:], (away * away).sum(axis=1), np.inf)
    rows = np.arange(len(squares))
    best = rows, np.argmin(squares, axis=1)
    step = angles[rows, best[1] + 1] - angles[best]
    past = (free[best] - share[best]) ** 2 * length[best]
    return Nearest(
        angles[best] + share[best] * step, np.isfinite(squares[best]), past > _CORNER_PX**2
    )
