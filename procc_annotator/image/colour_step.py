"""Whether a step of colour, from the ground to the paint, is one that the sought paint makes."""

from __future__ import annotations

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
)
from procc_annotator.image.cuts import Values
from procc_annotator.image.sought import Sought

# Weights of blue, green and red in what must grow from the ground to the paint.
_GROWS = {
    RED: (-0.5, -0.5, 1.0),
    ORANGE: (-1.0, 0.0, 1.0),
    YELLOW: (-1.0, 0.5, 0.5),
    BLUE: (1.0, -0.3, -0.7),
}
_LIGHT = {LIGHTER: 1.0, DARKER: -1.0, WHITE: 1.0, BLACK: -1.0}
# Of the step's length. Video halves the resolution of colour: a thin line differs from its flanks
# in brightness alone, and only what has another colour than the paint can be told.
_LEAST_GROWTH = -0.2
_MOST_LOSS = 0.15  # of white paint in any channel


def fits(steps: Values, sought: Sought) -> NDArray[np.bool_]:
    """Which steps of colour the sought paint could make.

    Args:
        steps: (..., 3 or 4) BGR, paint minus ground, of any length; alpha is left out.
        sought: its tone and colour decide.
    """
    tone, colour = sought.looks.tone, sought.looks.colour
    if sought.looks.kind == BAR and tone == ANY and colour in _LIGHT:
        colour = ANY  # before anything: white in the shade is darker than what is lit behind it
    blue, green, red = (steps[..., k] for k in range(3))
    lengths = np.sqrt(blue * blue + green * green + red * red) + 1e-6
    good = np.ones(steps.shape[:-1], dtype=bool)
    for word in {tone, colour} - {ANY}:
        if word in _LIGHT:
            good &= _LIGHT[word] * (blue + green + red) > 0
        if word in _GROWS:
            of_blue, of_green, of_red = _GROWS[word]
            growth = of_blue * blue + of_green * green + of_red * red
            good &= growth > _LEAST_GROWTH * lengths
    if colour == WHITE:
        good &= np.minimum(np.minimum(blue, green), red) > -_MOST_LOSS * lengths
    return good
