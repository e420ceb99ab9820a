"""What speaks against a fit: too little to fit to, or a pose that no camera at a field has."""

from __future__ import annotations

import math

import numpy as np

from procc_annotator.fit.solving.models import LOG_FOCAL, ROLL, TILT, X, Y, Z
from procc_annotator.fit.solving.observations import FloatArray, Observations
from procc_annotator.fit.solving.surroundings import Surroundings
from procc_annotator.language import said, said_count

# How often an element ties a camera down: a line twice, a curve up to five times, once a point;
# the only point of a spot twice.
_TIES_OF_A_LINE, _TIES_OF_A_CURVE, _TIES_OF_A_SPOT = 2, 5, 2
_NARROWEST_PX = 3.0  # solver px, root mean square across the points' main direction
_LOWEST_M = 0.3
_ON_GROUND_M = 0.05  # told as 0.0 m, above or below
_MOST_ROLL = math.radians(30)
# A camera under a ceiling that looks down more steeply may be turned any way.
_LOOKING_DOWN = math.radians(35)
_FOCALS_PX = (150.0, 60000.0)  # solver px


def missing(seen: Observations | None, *, needed: int, planar: bool) -> str | None:
    """Why there is too little to fit a camera to, in words; None when there is enough.

    Args:
        seen: the points that could be used.
        needed: elements that the model needs.
        planar: whether only elements on the ground count.
    """
    count = 0 if seen is None else len(seen.elements)
    if seen is None or count < needed:
        return too_few(count, needed, planar=planar)
    if _ties(seen) < 2 * needed:
        return said_count(
            count,
            "{points} points on {n} element, two different ones on each of {needed} needed",
            "{points} points on {n} elements, two different ones on each of {needed} needed",
            points=seen.points.shape[1],
            needed=needed,
        )
    return _too_narrow(seen.points)


def too_few(count: int, needed: int, *, planar: bool = False) -> str:
    """That so many elements are not enough."""
    if planar:
        return said_count(
            count,
            "{n} element on the ground, {needed} needed",
            "{n} elements on the ground, {needed} needed",
            needed=needed,
        )
    return said_count(
        count, "{n} element, {needed} needed", "{n} elements, {needed} needed", needed=needed
    )


def _ties(seen: Observations) -> int:
    ties = 0
    for element, count in zip(seen.elements, seen.counts.tolist(), strict=True):
        if element.is_spot:
            ties += _TIES_OF_A_SPOT
        else:
            ties += min(count, _TIES_OF_A_LINE if element.is_straight else _TIES_OF_A_CURVE)
    return ties


def _too_narrow(points: FloatArray) -> str | None:
    centred = points - points.mean(axis=1, keepdims=True)
    rms = np.linalg.svd(centred, compute_uv=False) / math.sqrt(points.shape[1])
    if rms[0] < _NARROWEST_PX:
        return said("all points lie in one place of the picture")
    if rms[1] < _NARROWEST_PX:
        return said("all points lie on one line of the picture")
    return None


def objection(vector: FloatArray, around: Surroundings) -> str | None:
    """What makes a pose implausible, in words; None when nothing does.

    Args:
        vector: (11,) pinhole parameters.
        around: where cameras stand.
    """
    if not np.isfinite(vector).all():
        return said("not a plausible pose: the fit did not settle")
    height = -float(vector[Z])
    if abs(height) < _ON_GROUND_M:
        return said("not a plausible pose: on the ground")
    if height < 0:
        return said("not a plausible pose: {metres:.1f} m below the ground", metres=-height)
    if height < _LOWEST_M:
        return said("not a plausible pose: only {metres:.1f} m above the ground", metres=height)
    away = math.hypot(vector[X], vector[Y], vector[Z])
    if away > around.farthest:
        return said("not a plausible pose: {metres:.0f} m from the field's centre", metres=away)
    upright = not around.ceiling or abs(vector[TILT]) > _LOOKING_DOWN
    if upright and abs(math.remainder(vector[ROLL], 2 * math.pi)) > _MOST_ROLL:
        degrees = math.degrees(vector[ROLL])
        return said("not a plausible pose: rolled by {degrees:.0f} degrees", degrees=degrees)
    focal = math.exp(vector[LOG_FOCAL])
    if not _FOCALS_PX[0] <= focal <= _FOCALS_PX[1]:
        return said("not a plausible pose: focal length {px:.0f} px at 960 px width", px=focal)
    return None
