"""How far clicks on landmarks are off: by the residuals of one place, or of many together.

A place clicked in two views leaves one residual more than it has unknowns, which tells next to
nothing of the noise; those of twenty places do.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

_PRIOR_WEIGHT = 4.0  # how many residuals the usual error of a click is worth
# A place whose residuals say more than so many times the usual error, beyond three standard
# deviations of what chance makes of it, has a mistake among its clicks.
_MAX_NOISE, _MAX_QUANTILE = 2.0, 3.0


def noise_factor(squares: float, spare: int) -> float:
    """How many times as far off as expected clicks are, drawn towards 1 where little tells.

    Args:
        squares: sum of the squares of residuals, in standard deviations of a click.
        spare: how many more residuals than unknowns there are.
    """
    return math.sqrt((_PRIOR_WEIGHT + squares) / (_PRIOR_WEIGHT + spare))


def pooled_noise_factor(places: Sequence[tuple[float, int]]) -> float:
    """The same from places that were clicked by the same hand: of each one its squares and how many
    it has to spare, which of one that was not found are none."""
    squares = sum(min(squares, _max_squares(spare)) for squares, spare in places)
    return noise_factor(squares, sum(spare for _, spare in places))


def _max_squares(spare: int) -> float:
    # The sum of so many squares has this mean and standard deviation (chi-squared distribution).
    return _MAX_NOISE**2 * (spare + _MAX_QUANTILE * math.sqrt(2 * spare))
