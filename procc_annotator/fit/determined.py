"""Whether the points determine a camera well enough to rely on it."""

from __future__ import annotations

import math

import numpy as np

from procc_annotator.fit.result import FitResult, PosedCamera
from procc_annotator.fit.solving.models import PAN, ROLL, TILT

# Standard deviations beyond which a camera is hardly determined: about twice what the worst of the
# 186 frames of World Cup 2014 have (model R: 0.4 degrees, 5.3 m of some 70 m, 5.5 % of the focal
# length).
MOST_ANGLE_DEGREES = 1.0
MOST_POSITION = 0.15  # of the way to the centre of the field
MOST_FOCAL = 0.1
_LOOKING_DOWN = 0.35  # sine of the tilt
LIMITS = (
    f"pan, tilt or roll ± more than {MOST_ANGLE_DEGREES:g}°, position ± more than"
    f" {100 * MOST_POSITION:g} % of the way to the field's centre, or focal"
    f" length ± more than {100 * MOST_FOCAL:g} %, or clicks that are the same from the other end"
)


def hardly_determined(fit: FitResult) -> str:
    """What the points leave open beyond the limits, in words: ``pan ± 1.4°, position ± 12 m``.

    Empty where they determine the camera, and for fits that tell no pose: homographies, and those
    that failed.
    """
    known, camera = fit.deviations, fit.camera
    if known is None or not isinstance(camera, PosedCamera):
        return ""
    pan, roll = _pan_and_roll(fit)
    angles = {"pan": pan, "tilt": known.tilt_rad, "roll": roll}
    words = [
        f"{name} ± {math.degrees(sd):.1f}°"
        for name, sd in angles.items()
        if not math.degrees(sd) <= MOST_ANGLE_DEGREES
    ]
    away = math.hypot(*known.position_m)
    if not away <= MOST_POSITION * math.hypot(*camera.position_world):
        words.append(f"position ± {away:.0f} m")
    share = known.focal_px / camera.focal_px[0]
    if not share <= MOST_FOCAL:
        words.append(f"focal length ± {100 * share:.0f} %")
    if fit.other_end:
        words.append("the same from the other end")
    return ", ".join(words)


def _pan_and_roll(fit: FitResult) -> tuple[float, float]:
    """Standard deviations, rad. A camera that looks down turns about the vertical by either: what
    counts is their sum, and of their difference what it tilts the camera by."""
    known, covariance, vector = fit.deviations, fit.covariance, fit.vector
    assert known is not None  # asked for pinholes only
    if covariance is None or vector is None or abs(math.sin(vector[TILT])) > _LOOKING_DOWN:
        return known.pan_rad, known.roll_rad
    both = np.zeros(len(covariance))
    both[PAN], both[ROLL] = 1.0, math.cos(vector[TILT])
    together = math.sqrt(max(float(both @ covariance @ both), 0.0))
    return together, abs(math.sin(vector[TILT])) * known.pan_rad
