"""How much of a whole picture its tracked camera explains."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.single_image.field_points import FieldLinePoints
from procc_annotator.calibration.single_image.icp_refinement import (
    ImageLinePixels,
    match_pixels_to_lines,
)

_AGREEMENT_PX, _AGREEMENT_POINTS = 3.0, 800  # as for proposals


def thinned_line_pixels(seen: ImageLinePixels) -> ImageLinePixels:
    """Return the line pixels that `explained_share` takes, in 20 kB."""
    some = seen.some(_AGREEMENT_POINTS)
    return replace(
        seen,
        points=seen.points[:, some],
        along=seen.along[some],
        on_ground=np.arange(len(some)),
        ground=np.zeros((1, 1), np.uint8),
    )


def explained_share(seen: ImageLinePixels, vector: FloatArray, lines: FieldLinePoints) -> float:
    """Return the share of the line pixels on the field that are on lines of a camera (11,)."""
    pulls = match_pixels_to_lines(vector[None], seen.on_ground, lines, seen, 0)
    on_line = pulls.known & (np.abs(pulls.off) < _AGREEMENT_PX)
    return float(on_line.sum() / max(int((on_line | pulls.in_view).sum()), 1))
