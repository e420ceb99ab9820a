"""Long lines that a camera misses: no line pixels along them, but an unexplained line next to them.

Neither alone suffices: worn and hidden lines have no line pixels either, and pictures show lines
that
are none of the field's.
"""

from __future__ import annotations

import numpy as np

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.line_alignment.expected_lines import (
    ExpectedLinePoints,
    MarkingPoints,
    expected_line_points,
)
from procc_annotator.calibration.line_alignment.refinement import POINT_SPACING_PX
from procc_annotator.calibration.optimization.camera_parameters import camera_from_vector
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.single_image.icp_refinement import (
    SAME_DIRECTION_RAD,
    ImageLinePixels,
)
from procc_annotator.camera.backprojection import ground_from_px

_FARTHEST_PX = 100.0  # solver px: a tenth of the picture's width
_EXPLAINED_PX = 8.0  # solver px: line pixels so near to an element of like direction are its own
_LEAST_SHARE = 0.5  # of the missed element's length: shorter strokes are parts of something else
# A camera that is off by some degrees turns a line by as much; how wide a line is when it is not
# quite straight there, solver px.
_SLOPES, _BAND_PX = np.linspace(-0.3, 0.3, 31), 4.0


def unexplained_beside(
    seen: ImageLinePixels,
    vector: FloatArray,
    missed: IntArray,
    painted: MarkingPoints,
    frame: ImageFrame,
) -> dict[int, float]:
    """Return the missed elements next to which the field shows a line that no element explains.

    Args:
        seen: the line pixels of the whole picture.
        vector: (11,) of the camera.
        missed: numbers in `Painted.names` of elements without line pixels.
        painted: the field's paint.
        frame: the picture.

    Returns:
        Number of the element -> distance of that line, solver px.
    """
    expected = expected_line_points(vector, painted, frame, POINT_SPACING_PX)
    points, along = seen.points[:, seen.on_ground], seen.along[seen.on_ground]
    # Boards stand outside the field.
    ground = ground_from_px(
        camera_from_vector(vector, frame), (points / frame.scale).T + np.array(frame.centre_px)
    )
    size = np.abs(painted.world[:2]).max(axis=1)
    inside = np.flatnonzero((np.abs(ground) < size).all(axis=1))
    points, along = points[:, inside], along[inside]
    away = np.hypot(*(points[:, :, None] - expected.px[:, None]))
    like = _are_like(along[:, None], expected)
    free = ~((away < _EXPLAINED_PX) & like).any(axis=1)
    own = painted.element[expected.rows]
    found = {}
    for number in missed.tolist():
        rows = np.flatnonzero(own == number)
        nearest = away[:, rows].argmin(axis=1)
        across = ((points - expected.px[:, rows[nearest]]) * expected.normal[:, rows[nearest]]).sum(
            axis=0
        )
        beside = free & like[np.arange(len(along)), rows[nearest]] & (np.abs(across) < _FARTHEST_PX)
        length, px = _longest(nearest[beside] * POINT_SPACING_PX, across[beside])
        if length >= _LEAST_SHARE * expected.length_px[rows].sum():
            found[number] = px
    return found


def _are_like(angles: FloatArray, expected: ExpectedLinePoints) -> np.ndarray:
    """Return whether directions (rad) are those of the places (n,), nearly."""
    turn = angles - np.arctan2(expected.normal[1], expected.normal[0])  # 90 degrees if alike
    return np.asarray(np.abs(np.mod(turn, np.pi) - np.pi / 2) < SAME_DIRECTION_RAD)


def _longest(along: FloatArray, across: FloatArray) -> tuple[float, float]:
    """Length of the longest stroke of points, px along and across an element, and its distance."""
    best = 0.0, 0.0
    if not len(along):
        return best
    cells = np.round(along / POINT_SPACING_PX).astype(np.intp)
    for slope in _SLOPES:
        level = across - slope * (along - along.mean())
        for shift in (0.0, 0.5):
            band = np.floor(level / _BAND_PX + shift)
            filled = np.unique(np.column_stack([band, cells]), axis=0)[:, 0]
            bands, counts = np.unique(filled, return_counts=True)
            length = float(counts.max()) * POINT_SPACING_PX
            if length > best[0]:
                own = band == bands[counts.argmax()]
                best = length, float(np.abs(np.median(across[own])))
    return best
