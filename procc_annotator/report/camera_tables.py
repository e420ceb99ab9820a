"""What tables of cameras found by the program share: how surely a camera is known."""

from __future__ import annotations

import math

from procc_annotator.fit.result import PoseStandardDeviations
from procc_annotator.report.sheet.figures import DEVIATIONS
from procc_annotator.report.sheet.sheet import metric_column

DEVIATION_COLUMNS = tuple(map(metric_column, DEVIATIONS))


def deviation_values(deviations: PoseStandardDeviations | None) -> tuple[float | None, ...]:
    """Standard deviations in the order of `DEVIATION_COLUMNS`: degrees, px, metres."""
    if deviations is None:
        return (None,) * len(DEVIATION_COLUMNS)
    angles = (deviations.pan_rad, deviations.tilt_rad, deviations.roll_rad)
    return (*map(math.degrees, angles), deviations.focal_px, *deviations.position_m)
