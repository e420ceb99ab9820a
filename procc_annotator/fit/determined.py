"""Whether the points determine a camera well enough to rely on it."""

from __future__ import annotations

import math

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.fit.result import FitResult

# Standard deviations beyond which a camera is hardly determined: about twice what the worst of the
# 186 frames of World Cup 2014 have (model R: 0.4 degrees, 5.3 m, 5.5 % of the focal length).
MOST_ANGLE_DEGREES = 1.0
MOST_POSITION_M = 10.0
MOST_FOCAL = 0.1
LIMITS = (
    f"pan, tilt or roll ± more than {MOST_ANGLE_DEGREES:g}°, position ± more than"
    f" {MOST_POSITION_M:g} m, or focal length ± more than {100 * MOST_FOCAL:g} %"
)


def hardly_determined(fit: FitResult) -> str:
    """What the points leave open beyond the limits, in words: ``pan ± 1.4°, position ± 12 m``.

    Empty where they determine the camera, and for fits that tell no pose: homographies, and those
    that failed.
    """
    known, camera = fit.deviations, fit.camera
    if known is None or not isinstance(camera, PinholeCamera):
        return ""
    angles = {"pan": known.pan_rad, "tilt": known.tilt_rad, "roll": known.roll_rad}
    words = [
        f"{name} ± {math.degrees(sd):.1f}°"
        for name, sd in angles.items()
        if not math.degrees(sd) <= MOST_ANGLE_DEGREES
    ]
    away = math.hypot(*known.position_m)
    if not away <= MOST_POSITION_M:
        words.append(f"position ± {away:.0f} m")
    share = known.focal_px / camera.focal_px[0]
    if not share <= MOST_FOCAL:
        words.append(f"focal length ± {100 * share:.0f} %")
    return ", ".join(words)
