"""How far apart the points of a regular polyline lie: evenly, denser where it bends."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

_SAGITTA_PX = 0.5  # how far chords may cut a bend
_LARGEST_SPACING = 1 / 16  # of the picture's width
_SMALLEST_SPACING = 1 / 80
_STEADY = 9  # so many steps tell how much a curve bends


def regular_parameters(
    parameters: FloatArray,
    places_px: FloatArray,
    directions: FloatArray,
    width_px: int,
    *,
    least: int = 3,
) -> FloatArray:
    """Where along a curve the points of a regular polyline belong.

    Args:
        parameters: (n,) ascending, of the places.
        places_px: (n, 2) dense places along the curve, n >= 2.
        directions: (n, 2) of the curve there.
        width_px: of the picture.
        least: chords at least.

    Returns:
        (m,) parameters, m > ``least``, the first and the last of the given ones among them.
    """
    steps = np.hypot(*np.diff(places_px, axis=0).T)
    turns = np.abs(np.diff(np.unwrap(np.arctan2(directions[:, 1], directions[:, 0]))))
    # A chord of length c cuts a bend of radius r by c * c / (8 r).
    around = min(_STEADY, len(turns))
    bend = np.convolve(turns / np.maximum(steps, 1e-9), np.ones(around) / around, mode="same")
    spacing = np.sqrt(8 * _SAGITTA_PX / np.maximum(bend, 1e-9))
    spacing = np.clip(spacing, _SMALLEST_SPACING * width_px, _LARGEST_SPACING * width_px)
    count = np.concatenate([[0.0], np.cumsum(steps / spacing)])
    wanted = max(least, math.ceil(count[-1]))
    return np.asarray(np.interp(np.linspace(0.0, count[-1], wanted + 1), count, parameters))
