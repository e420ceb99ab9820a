"""Whether a shot stands where cameras of other shots were found to."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from procc_annotator.fit.from_picture.proposal import KnownPosition
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.models import CENTRE

# Shots of one match tell of the same tripod to about a metre; standard deviation of each axis.
_APART_M = 0.7
_MOST_IN_SD, _MOST_M = 3.5, 5.0
_LEAST_COVERAGE = 0.65  # below it a frame is doubtful


def stands_at_one(
    fit: FitResult | None, coverages: Sequence[float], places: Sequence[KnownPosition]
) -> bool:
    """Whether what all frames of a shot tell of their camera is a place that is known, and its
    lines are on their paint.

    Args:
        fit: of one of its frames, solved with all the others.
        coverages: of its frames, 0 to 1.
        places: that are known.
    """
    if fit is None or fit.vector is None or fit.covariance is None:
        return False
    if np.mean(coverages) < _LEAST_COVERAGE:
        return False
    for place in places:
        away = fit.vector[CENTRE] - place.position_m
        spread = fit.covariance[CENTRE, CENTRE] + place.covariance + np.eye(3) * _APART_M**2
        in_sd = float(np.sqrt(away @ np.linalg.solve(spread, away)))
        if in_sd <= _MOST_IN_SD and np.linalg.norm(away) <= _MOST_M:
            return True
    return False
