"""Whether a shot stands where cameras of other shots were found to."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from procc_annotator.fit.from_picture.proposal import KnownPosition
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.models import POSITION_SLICE

# Shots of one match tell of the same tripod to about a metre; standard deviation of each axis.
_MIN_SEPARATION_M = 0.7
_MAX_MAHALANOBIS, _MAX_DISTANCE_M = 3.5, 5.0
_MIN_COVERAGE = 0.65  # below it a frame is doubtful


def is_at_known_position(
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
    if np.mean(coverages) < _MIN_COVERAGE:
        return False
    for place in places:
        away = fit.vector[POSITION_SLICE] - place.position_m
        spread = fit.covariance[POSITION_SLICE, POSITION_SLICE] + place.covariance + np.eye(3) * _MIN_SEPARATION_M**2
        in_sd = float(np.sqrt(away @ np.linalg.solve(spread, away)))
        if in_sd <= _MAX_MAHALANOBIS and np.linalg.norm(away) <= _MAX_DISTANCE_M:
            return True
    return False
