"""Whether a step of colour, from the ground to the paint, is one that the sought paint makes."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.appearance import (
    ANY,
    BAR,
    BLACK,
    BLUE,
    DARKER,
    LIGHTER,
    ORANGE,
    RED,
    WHITE,
    YELLOW,
    Appearance,
)
from procc_annotator.image.cuts import Values
from procc_annotator.image.sought import LineTarget

# Weights of blue, green and red in what must grow from the ground to the paint.
_COLOUR_DIRECTIONS = {
    RED: (-0.5, -0.5, 1.0),
    ORANGE: (-1.0, 0.0, 1.0),
    YELLOW: (-1.0, 0.5, 0.5),
    BLUE: (1.0, -0.3, -0.7),
}
_CHANNELS = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
_LIGHTNESS_SIGN = {LIGHTER: 1.0, DARKER: -1.0, WHITE: 1.0, BLACK: -1.0}
# Of the step's length. Video halves the resolution of colour: a thin line differs from its flanks
# in brightness alone, and only what has another colour than the paint can be told.
_MIN_GROWTH = -0.2
_MAX_LOSS = 0.15  # of white paint in any channel


def matches_colour_step(steps: Values, sought: LineTarget) -> NDArray[np.bool_]:
    """Which steps of colour the sought paint could make.

    Args:
        steps: (n, 4) BGRA, paint minus ground, of any length; alpha is left out.
        sought: its tone and colour decide.

    Returns:
        (n,).
    """
    weights, least = _colour_conditions(sought.looks)
    bgr = steps[:, :3]
    lengths = np.sqrt(np.einsum("nk,nk->n", bgr, bgr)) + 1e-6
    good: NDArray[np.bool_] = (weights @ bgr.T > least * lengths).all(axis=0)
    return good


@lru_cache(maxsize=64)
def _colour_conditions(looks: Appearance) -> tuple[Values, Values]:
    """(m, 3) weights of blue, green and red in what must be more than (m, 1) shares of a step's
    length."""
    tone, colour = looks.tone, looks.colour
    if looks.kind == BAR and tone == ANY and colour in _LIGHTNESS_SIGN:
        colour = ANY  # before anything: white in the shade is darker than what is lit behind it
    rows = [((_LIGHTNESS_SIGN[word],) * 3, 0.0) for word in {tone, colour} & _LIGHTNESS_SIGN.keys()]
    rows += [(_COLOUR_DIRECTIONS[word], _MIN_GROWTH) for word in {tone, colour} & _COLOUR_DIRECTIONS.keys()]
    if colour == WHITE:
        rows += [(channel, -_MAX_LOSS) for channel in _CHANNELS]
    weights, least = [row[0] for row in rows], [row[1] for row in rows]
    return (
        np.array(weights, dtype=np.float32).reshape(-1, 3),
        np.array(least, dtype=np.float32).reshape(-1, 1),
    )
