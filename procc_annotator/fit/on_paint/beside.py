"""Elements whose paint lies beside where a camera shows them.

What is found close to a camera's lines says nothing of a line that is not where it should be: it
only makes the share that was found a little smaller. So elements of which little was found are
looked for once more, farther out. A whole stretch of one that lies to one side tells that the
camera, or the field's file, is not right there.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.on_paint.belief import MIN_WEIGHT, geman_mcclure_weights
from procc_annotator.fit.on_paint.expected import ExpectedLinePoints, expected_line_points, project_points
from procc_annotator.fit.on_paint.looking import (
    POINT_SPACING_PX,
    LineMeasurement,
    measure_lines,
    found_shares,
)
from procc_annotator.fit.on_paint.marks import EdgePoints
from procc_annotator.fit.on_paint.offsets import nearest_line_offsets
from procc_annotator.fit.on_paint.painted import MarkingPoints
from procc_annotator.fit.solving.jacobian import Lens
from procc_annotator.fit.solving.observations import FloatArray, IntArray, ImageFrame
from procc_annotator.image.pixels import PixelArray
from procc_annotator.language import translatable

# All in solver px.
_NEAR_RADIUS_PX, _FAR_RADIUS_PX = 5.0, 12.0
_DISPLACED_PX = 2.5  # nearer, it is where it should be
_MIN_DISPLACED_LENGTH_PX, _MIN_DISPLACED_SHARE = 100.0, 0.5  # of what was found of an element lies to one side
_MAX_FOUND_SHARE = 0.7  # of an element: it is where the camera has it
_MIN_RELATIVE_CONTRAST = 0.4  # of the usual contrast: the edge of a board is no paint
_NEIGHBOUR_TOLERANCE_PX = 1.0  # between neighbours: other paint, and what is none, jumps
_SUBSAMPLING = 3  # of places that were averaged with their neighbours every third tells it all
# An element on the ground that is so long in sight, solver px, is missed if less of it has line
# pixels: where players hide a line some of it is left.
_LONG_PX, _MISSED = 150.0, 0.2


@dataclass(frozen=True, eq=False)
class NearbyEdgePoints:
    """Paint on and beside elements.

    Attributes:
        marks: n places.
        length_px: (n,) solver px of the element that each stands for.
    """

    marks: EdgePoints
    length_px: FloatArray


def displaced_elements_in_image(
    picture: PixelArray, vector: FloatArray, painted: MarkingPoints, frame: ImageFrame
) -> str:
    """Which elements a camera (11,) shows beside the paint of its picture (H, W, 4), in words; ""
    for none."""
    seen = measure_lines(picture, vector, painted, frame, _NEAR_RADIUS_PX)
    if not len(seen.marks):
        return ""
    weights = geman_mcclure_weights(edge_point_residuals(vector, seen.marks, frame))
    around = search_nearby(picture, vector, painted, frame, seen, weights)
    marks = seen.marks.chosen(np.flatnonzero(weights > MIN_WEIGHT))
    length = np.full(len(marks), POINT_SPACING_PX)
    return displaced_elements_text(displaced_elements(vector, marks, length, around, frame), painted, frame)


def search_nearby(
    picture: PixelArray,
    vector: FloatArray,
    painted: MarkingPoints,
    frame: ImageFrame,
    seen: LineMeasurement,
    weights: FloatArray,
) -> NearbyEdgePoints | None:
    """Look farther out for the elements of which a camera (11,) finds little.

    Args:
        picture: (H, W, 4) BGRA.
        vector: the camera.
        painted: the field's paint.
        frame: the picture.
        seen: what was found near it.
        weights: of the marks, 0 for those that the camera does not explain.

    Returns:
        None where none of length has to be looked for.
    """
    _, shares = found_shares(seen, weights, painted)
    poor = np.array([shares.get(name, 1.0) < _MAX_FOUND_SHARE for name in painted.names])
    if not poor.any():
        return None
    expected = expected_line_points(vector, painted, frame, POINT_SPACING_PX)
    own = painted.element[expected.rows]
    length = np.bincount(own, expected.length_px, minlength=len(painted.names))
    sought = (poor & (length >= _MIN_DISPLACED_LENGTH_PX))[own]
    if not sought.any():
        return None
    expected = expected.chosen(np.flatnonzero(sought))
    usual = float(np.median(seen.offsets.contrast[seen.offsets.found]))
    offsets, near = nearest_line_offsets(picture, expected, painted, frame, _DISPLACED_PX, _FAR_RADIUS_PX)
    found = offsets.found & (near | (offsets.contrast >= _MIN_RELATIVE_CONTRAST * usual))
    return _consistent_with_neighbours(expected, offsets.px, found, painted)


def _consistent_with_neighbours(
    expected: ExpectedLinePoints, px: FloatArray, found: NDArray[np.bool_], painted: MarkingPoints
) -> NearbyEdgePoints | None:
    """What was found so far off (n,), where it goes on as its neighbour does."""
    goes_on = found[1:] & found[:-1] & (np.abs(np.diff(px)) < _NEIGHBOUR_TOLERANCE_PX)
    goes_on &= np.diff(expected.run) == 0
    rows = np.flatnonzero(np.append(goes_on, False) | np.append(False, goes_on))[::_SUBSAMPLING]
    if not len(rows):
        return None
    normal, own = expected.normal[:, rows], expected.rows[rows]
    across = (expected.px[:, rows] * normal).sum(axis=0) + px[rows]
    marks = EdgePoints(painted.world[:, own], across, normal, painted.element[own], expected.run[rows])
    return NearbyEdgePoints(marks.small(), _SUBSAMPLING * expected.length_px[rows])


def displaced_elements(
    vector: FloatArray,
    marks: EdgePoints,
    length_px: FloatArray,
    around: NearbyEdgePoints | None,
    frame: ImageFrame,
) -> dict[int, float]:
    """Elements that a camera (11,) shows beside their paint, by number in `Painted.names`: how far
    the paint lies off, solver px.

    Args:
        vector: the camera.
        marks: paint the camera goes by.
        length_px: (n,) what each of them stands for.
        around: what was looked for farther out; these elements are judged by it alone.
        frame: the picture.
    """
    if around is not None:
        others = np.flatnonzero(~np.isin(marks.element, around.marks.element))
        marks, length_px = marks.chosen(others), length_px[others]
    found = {}
    for some, length in [
        (marks, length_px),
        *([(around.marks, around.length_px)] if around else []),
    ]:
        off = edge_point_residuals(vector, some, frame)
        for number in np.unique(some.element[np.abs(off) >= _DISPLACED_PX]).tolist():
            own = some.element == number
            away = _one_sided_offset(off[own], length[own])
            if away is not None:
                found[number] = away
    return found


def elements_missed(
    vector: FloatArray,
    marks: EdgePoints,
    length_px: FloatArray,
    painted: MarkingPoints,
    frame: ImageFrame,
) -> IntArray:
    """Return numbers in `Painted.names` of elements of which a camera (11,) shows a long stretch
    that has no line pixels; worn lines among them. See `displaced_elements`."""
    expected = expected_line_points(vector, painted, frame, POINT_SPACING_PX)
    rows = np.flatnonzero(painted.across[:, expected.rows].any(axis=0))
    own, count = painted.element[expected.rows[rows]], len(painted.names)
    shown = np.bincount(own, expected.length_px[rows], minlength=count)
    on = np.abs(edge_point_residuals(vector, marks, frame)) < _DISPLACED_PX
    found = np.bincount(marks.element[on], length_px[on], minlength=count)
    return np.flatnonzero((shown >= _LONG_PX) & (found < _MISSED * shown))


def _one_sided_offset(off: FloatArray, length: FloatArray) -> float | None:
    """How far off the paint of one element lies, if a stretch of it does, all to one side."""
    on = length[np.abs(off) < _DISPLACED_PX].sum()
    sides = [np.flatnonzero(side * off >= _DISPLACED_PX) for side in (1, -1)]
    side = max(sides, key=lambda rows: float(length[rows].sum()))
    beside = float(length[side].sum())
    if beside < _MIN_DISPLACED_LENGTH_PX or beside < _MIN_DISPLACED_SHARE * (on + beside):
        return None
    return float(np.abs(np.median(off[side])))


def edge_point_residuals(vector: FloatArray, marks: EdgePoints, frame: ImageFrame) -> FloatArray:
    """(n,) solver px that marks are off from where a camera (11,) shows them."""
    px, _ = project_points(Lens.of(vector[None], frame.half_diagonal), marks.world.astype(np.float64))
    return np.asarray(marks.across - (px * marks.normal).sum(axis=0))


def displaced_elements_text(beside: dict[int, float], painted: MarkingPoints, frame: ImageFrame) -> str:
    """That elements lie beside their paint, the farthest first; "" of none."""
    if not beside:
        return ""
    number = max(beside, key=lambda own: beside[own])
    name, px, more = painted.names[number], beside[number] / frame.scale, len(beside) - 1
    if not more:
        return translatable("{name} lies {px:.0f} px beside its paint", name=name, px=px)
    return translatable(
        "{name} lies {px:.0f} px beside its paint, as {more} more do theirs",
        name=name,
        px=px,
        more=more,
    )
