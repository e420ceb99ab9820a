"""Whether the points determine a camera well enough to rely on it."""

from __future__ import annotations

import math

import numpy as np

from procc_annotator.fit.result import FitResult, PosedCamera
from procc_annotator.fit.solving.models import PAN, ROLL, TILT
from procc_annotator.language import translatable, translatable_joined, word

# Standard deviations beyond which a camera is hardly determined: about twice what the worst of the
# 186 frames of World Cup 2014 have (model R: 0.4 degrees, 5.3 m of some 70 m, 5.5 % of the focal
# length).
MAX_ANGLE_SD_DEGREES = 1.0
MAX_POSITION_SD_SHARE = 0.15  # of the way to the centre of the field
MAX_FOCAL_SD_SHARE = 0.1
_LOOKING_DOWN_COSINE = 0.35  # sine of the tilt
ILL_CONDITIONED_LIMITS = translatable(
    "pan, tilt or roll ± more than {degrees:g}°, position ± more than {way:g} % of the way to the"
    " field's centre, or focal length ± more than {focal:g} %, or clicks that are the same from the"
    " other end",
    degrees=MAX_ANGLE_SD_DEGREES,
    way=100 * MAX_POSITION_SD_SHARE,
    focal=100 * MAX_FOCAL_SD_SHARE,
)


def ill_conditioned_reason(fit: FitResult) -> str:
    """What the points leave open beyond the limits, in words: ``pan ± 1.4°, position ± 12 m``.

    Empty where they determine the camera, and for fits that tell no pose: homographies, and those
    that failed.
    """
    known, camera = fit.deviations, fit.camera
    if known is None or not isinstance(camera, PosedCamera):
        return ""
    pan, roll = _pan_roll_deviations(fit)
    angles = (
        (word("pan ± {degrees:.1f}°"), pan),
        (word("tilt ± {degrees:.1f}°"), known.tilt_rad),
        (word("roll ± {degrees:.1f}°"), roll),
    )
    words = [
        translatable(text, degrees=math.degrees(sd))
        for text, sd in angles
        if not math.degrees(sd) <= MAX_ANGLE_SD_DEGREES
    ]
    away = math.hypot(*known.position_m)
    if not away <= MAX_POSITION_SD_SHARE * math.hypot(*camera.position_world):
        words.append(translatable("position ± {metres:.0f} m", metres=away))
    share = known.focal_px / camera.focal_px[0]
    if not share <= MAX_FOCAL_SD_SHARE:
        words.append(translatable("focal length ± {percent:.0f} %", percent=100 * share))
    if fit.other_end:
        words.append(translatable("the same from the other end"))
    return translatable_joined(", ", words) if words else ""


def _pan_roll_deviations(fit: FitResult) -> tuple[float, float]:
    """Standard deviations, rad. A camera that looks down turns about the vertical by either: what
    counts is their sum, and of their difference what it tilts the camera by."""
    known, covariance, vector = fit.deviations, fit.covariance, fit.vector
    assert known is not None  # asked for pinholes only
    if covariance is None or vector is None or abs(math.sin(vector[TILT])) > _LOOKING_DOWN_COSINE:
        return known.pan_rad, known.roll_rad
    both = np.zeros(len(covariance))
    both[PAN], both[ROLL] = 1.0, math.cos(vector[TILT])
    together = math.sqrt(max(float(both @ covariance @ both), 0.0))
    return together, abs(math.sin(vector[TILT])) * known.pan_rad
