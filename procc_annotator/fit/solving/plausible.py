"""What speaks against a fit: too little to fit to, or a pose that no camera at a field has."""

from __future__ import annotations

import math

import numpy as np

from procc_annotator.fit.solving.models import LOG_FOCAL, ROLL, TILT, X, Y, Z
from procc_annotator.fit.solving.observations import FloatArray, Observations
from procc_annotator.fit.solving.surroundings import CameraPlacementPrior
from procc_annotator.language import translatable, translatable_count

# How often an element ties a camera down: a line twice, a curve up to five times, once a point;
# the only point of a spot twice.
_LINE_CONSTRAINTS, _CURVE_CONSTRAINTS, _SPOT_CONSTRAINTS = 2, 5, 2
_MIN_EXTENT_PX = 3.0  # solver px, root mean square across the points' main direction
_MIN_HEIGHT_M = 0.3
_GROUND_TOLERANCE_M = 0.05  # told as 0.0 m, above or below
_MAX_ROLL = math.radians(30)
# A camera under a ceiling that looks down more steeply may be turned any way.
_LOOKING_DOWN_RAD = math.radians(35)
_FOCAL_RANGE_PX = (150.0, 60000.0)  # solver px


def insufficient_reason(seen: Observations | None, *, needed: int, planar: bool) -> str | None:
    """Why there is too little to fit a camera to, in words; None when there is enough.

    Args:
        seen: the points that could be used.
        needed: elements that the model needs.
        planar: whether only elements on the ground count.
    """
    count = 0 if seen is None else len(seen.elements)
    if seen is None or count < needed:
        return too_few_elements_text(count, needed, planar=planar)
    if _constraint_count(seen) < 2 * needed:
        return translatable_count(
            count,
            "{points} points on {n} element, two different ones on each of {needed} needed",
            "{points} points on {n} elements, two different ones on each of {needed} needed",
            points=seen.points.shape[1],
            needed=needed,
        )
    return _is_degenerate(seen.points)


def too_few_elements_text(count: int, needed: int, *, planar: bool = False) -> str:
    """That so many elements are not enough."""
    if planar:
        return translatable_count(
            count,
            "{n} element on the ground, {needed} needed",
            "{n} elements on the ground, {needed} needed",
            needed=needed,
        )
    return translatable_count(
        count, "{n} element, {needed} needed", "{n} elements, {needed} needed", needed=needed
    )


def _constraint_count(seen: Observations) -> int:
    ties = 0
    for element, count in zip(seen.elements, seen.counts.tolist(), strict=True):
        if element.is_spot:
            ties += _SPOT_CONSTRAINTS
        else:
            ties += min(count, _LINE_CONSTRAINTS if element.is_straight else _CURVE_CONSTRAINTS)
    return ties


def _is_degenerate(points: FloatArray) -> str | None:
    centred = points - points.mean(axis=1, keepdims=True)
    rms = np.linalg.svd(centred, compute_uv=False) / math.sqrt(points.shape[1])
    if rms[0] < _MIN_EXTENT_PX:
        return translatable("all points lie in one place of the picture")
    if rms[1] < _MIN_EXTENT_PX:
        return translatable("all points lie on one line of the picture")
    return None


def implausible_reason(vector: FloatArray, around: CameraPlacementPrior) -> str | None:
    """What makes a pose implausible, in words; None when nothing does.

    Args:
        vector: (11,) pinhole parameters.
        around: where cameras stand.
    """
    if not np.isfinite(vector).all():
        return translatable("not a plausible pose: the fit did not settle")
    height = -float(vector[Z])
    if abs(height) < _GROUND_TOLERANCE_M:
        return translatable("not a plausible pose: on the ground")
    if height < 0:
        return translatable("not a plausible pose: {metres:.1f} m below the ground", metres=-height)
    if height < _MIN_HEIGHT_M:
        return translatable("not a plausible pose: only {metres:.1f} m above the ground", metres=height)
    away = math.hypot(vector[X], vector[Y], vector[Z])
    if away > around.farthest:
        return translatable("not a plausible pose: {metres:.0f} m from the field's centre", metres=away)
    upright = not around.ceiling or abs(vector[TILT]) > _LOOKING_DOWN_RAD
    if upright and abs(math.remainder(vector[ROLL], 2 * math.pi)) > _MAX_ROLL:
        degrees = math.degrees(vector[ROLL])
        return translatable("not a plausible pose: rolled by {degrees:.0f} degrees", degrees=degrees)
    focal = math.exp(vector[LOG_FOCAL])
    if not _FOCAL_RANGE_PX[0] <= focal <= _FOCAL_RANGE_PX[1]:
        return translatable("not a plausible pose: focal length {px:.0f} px at 960 px width", px=focal)
    return None
