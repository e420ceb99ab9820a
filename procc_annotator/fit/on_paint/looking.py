"""Look for the paint that a camera expects, and tell how much of it is there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.on_paint.belief import MIN_WEIGHT
from procc_annotator.fit.on_paint.expected import ExpectedLinePoints, expected_line_points
from procc_annotator.fit.on_paint.marks import EdgePoints
from procc_annotator.fit.on_paint.offsets import LineOffsets, line_offsets
from procc_annotator.fit.on_paint.painted import MarkingPoints
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame
from procc_annotator.image.pixels import PixelArray

POINT_SPACING_PX = 5.0


@dataclass(frozen=True, eq=False)
class LineMeasurement:
    """Paint beside n expected places.

    Attributes:
        expected: the places.
        offsets: what was found beside them.
        marks: of those beside which something was.
    """

    expected: ExpectedLinePoints
    offsets: LineOffsets
    marks: EdgePoints


def measure_lines(
    picture: PixelArray,
    vector: FloatArray,
    painted: MarkingPoints,
    frame: ImageFrame,
    reach_px: float,
    spacing_px: float = POINT_SPACING_PX,
) -> LineMeasurement:
    """Look for paint beside where a camera (11,) shows it, so many solver px to either side."""
    return measure_at(picture, expected_line_points(vector, painted, frame, spacing_px), painted, frame, reach_px)


def measure_at(
    picture: PixelArray,
    expected: ExpectedLinePoints,
    painted: MarkingPoints,
    frame: ImageFrame,
    reach_px: float,
) -> LineMeasurement:
    """Look for paint beside expected places, so many solver px to either side."""
    offsets = line_offsets(picture, expected, painted, frame, reach_px)
    found = np.flatnonzero(offsets.found)
    normal = expected.normal[:, found]
    across = (expected.px[:, found] * normal).sum(axis=0) + offsets.px[found]
    rows = expected.rows[found]
    marks = EdgePoints(
        painted.world[:, rows], across, normal, painted.element[rows], expected.run[found]
    )
    return LineMeasurement(expected, offsets, marks)


def found_shares(
    seen: LineMeasurement, weights: FloatArray, painted: MarkingPoints
) -> tuple[float, Mapping[str, float]]:
    """The share of what should be in sight that was found where the camera has it, by length.

    Args:
        seen: what was found.
        weights: of the marks, 0 for those that the camera does not explain.
        painted: the field's paint.

    Returns:
        Of everything, 0 to 1; and of each element in sight.
    """
    own = painted.element[seen.expected.rows]
    length = seen.expected.length_px
    found = np.zeros(len(length))
    found[seen.offsets.found] = weights > MIN_WEIGHT
    total = np.bincount(own, length, minlength=len(painted.names))
    part = np.bincount(own, length * found, minlength=len(painted.names))
    whole = float(total.sum())
    shares = {
        name: float(part[i] / total[i]) for i, name in enumerate(painted.names) if total[i] > 0
    }
    return (float(part.sum()) / whole if whole else 0.0), shares
