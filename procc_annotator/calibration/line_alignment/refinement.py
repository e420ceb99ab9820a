"""Align a nearly correct camera with the line markings in the image; displaced elements."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.line_alignment.expected_lines import (
    ExpectedLinePoints,
    MarkingPoints,
    expected_line_points,
    marking_points,
)
from procc_annotator.calibration.line_alignment.gaussian_state import (
    MIN_WEIGHT,
    EdgePoints,
    GaussianState,
    StateUpdate,
    default_state,
    estimate_edge_noise,
    fit_from_edge_points,
    geman_mcclure_weights,
    update_state,
)
from procc_annotator.calibration.line_alignment.line_search import (
    LineOffsets,
    line_offsets,
    nearest_line_offsets,
)
from procc_annotator.calibration.optimization.camera_parameters import vector_from_camera
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.projection import Lens, project_visible
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import translatable

POINT_SPACING_PX = 5.0


@dataclass(frozen=True, eq=False)
class LineMeasurement:
    """Paint next to n expected places, and the marks of those next to which some was found."""

    expected: ExpectedLinePoints
    offsets: LineOffsets
    marks: EdgePoints


def measure_lines(
    picture: PixelArray,
    vector: FloatArray,
    painted: MarkingPoints,
    frame: ImageFrame,
    reach_px: float,
) -> LineMeasurement:
    """Look for paint next to where a camera (11,) shows it, so many solver px to either side."""
    expected = expected_line_points(vector, painted, frame, POINT_SPACING_PX)
    return measure_at(picture, expected, painted, frame, reach_px)


def measure_at(
    picture: PixelArray,
    expected: ExpectedLinePoints,
    painted: MarkingPoints,
    frame: ImageFrame,
    reach_px: float,
) -> LineMeasurement:
    """Look for paint next to expected places, so many solver px to either side."""
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
    """The share of what should be in sight that was found where the camera has it, by length; what
    is hidden, or not required, counts as far as it is found.

    Args:
        weights: of the marks, 0 for those that the camera does not explain.

    Returns:
        Of everything, 0 to 1; and of each element in the picture, hidden or not.
    """
    own = painted.element[seen.expected.rows]
    length = seen.expected.length_px
    found, hidden = _found_and_hidden(seen, weights, painted)
    total = np.bincount(own, length, minlength=len(painted.names))
    part = np.bincount(own, length * found, minlength=len(painted.names))
    whole = float(length[found | (painted.required[own] & ~hidden)].sum())
    shares = {
        name: float(part[i] / total[i]) for i, name in enumerate(painted.names) if total[i] > 0
    }
    return (float(part.sum()) / whole if whole else 0.0), shares


def _found_and_hidden(
    seen: LineMeasurement, weights: FloatArray, painted: MarkingPoints
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Return which of the expected places were found where a camera has them, and which of the
    others people, boards, banners or a crowd hide."""
    found = seen.offsets.found.copy()
    found[found] = weights > MIN_WEIGHT
    required = painted.required[painted.element[seen.expected.rows]]
    return found, ~found & seen.offsets.is_hidden(found & required)


# All in solver px.
_NEAR_RADIUS_PX, _FAR_RADIUS_PX = 5.0, 12.0
_DISPLACED_PX = 2.5  # nearer, it is where it should be
_MIN_DISPLACED_LENGTH_PX, _MIN_DISPLACED_SHARE = (
    100.0,
    0.5,
)  # of what was found of an element lies to one side
_MAX_FOUND_SHARE = 0.7  # of an element: it is where the camera has it
MIN_RELATIVE_CONTRAST = 0.4  # of the usual contrast: the edge of a board is no paint
_NEIGHBOUR_TOLERANCE_PX = 1.0  # between neighbours: other paint, and what is none, jumps
_SUBSAMPLING = 3  # of places that were averaged with their neighbours every third tells it all
# An element on the ground that is so long in sight, solver px, is missed if less of it has line
# pixels: where players hide a line some of it is left.
_LONG_PX, _MISSED = 150.0, 0.2


@dataclass(frozen=True, eq=False)
class NearbyEdgePoints:
    """Paint on and next to elements: n edge points, and (n,) solver px of the element that each
    stands for."""

    marks: EdgePoints
    length_px: FloatArray


def displaced_elements_in_image(
    picture: PixelArray, vector: FloatArray, painted: MarkingPoints, frame: ImageFrame
) -> str:
    """Which elements a camera (11,) shows next to the paint of its picture (H, W, 4), in words; ""
    for none."""
    seen = measure_lines(picture, vector, painted, frame, _NEAR_RADIUS_PX)
    if not len(seen.marks):
        return ""
    weights = geman_mcclure_weights(edge_point_residuals(vector, seen.marks, frame))
    around = search_nearby(picture, vector, painted, frame, seen, weights)
    marks = seen.marks.chosen(np.flatnonzero(weights > MIN_WEIGHT))
    length = np.full(len(marks), POINT_SPACING_PX)
    return displaced_elements_text(
        displaced_elements(vector, marks, length, around, frame), painted, frame
    )


def search_nearby(
    picture: PixelArray,
    vector: FloatArray,
    painted: MarkingPoints,
    frame: ImageFrame,
    seen: LineMeasurement,
    weights: FloatArray,
    *,
    on_ground: bool = False,
) -> NearbyEdgePoints | None:
    """Look farther out for the elements of which a camera (11,) finds little.

    Args:
        picture: (H, W, 4) BGRA.
        seen: what was found near it.
        weights: of the marks, 0 for those that the camera does not explain.
        on_ground: take only what has the colours of the field's ground on both sides, as the edges
            of boards have not.

    Returns:
        None where none of length has to be looked for.
    """
    _, shares = found_shares(seen, weights, painted)
    # Paint next to what is not required may be that of something else.
    poor = np.array([shares.get(name, 1.0) < _MAX_FOUND_SHARE for name in painted.names])
    poor &= painted.required
    if not poor.any():
        return None
    explained, hidden = _found_and_hidden(seen, weights, painted)
    own, px = painted.element[seen.expected.rows], seen.expected.length_px
    length, open_ = (np.bincount(own, some, minlength=len(poor)) for some in (px, px * ~hidden))
    # Of what is mostly hidden, the rest is hardly to be told from what hides it.
    poor &= (open_ >= _MIN_DISPLACED_LENGTH_PX) & (2 * open_ > length)
    expected = expected_line_points(vector, painted, frame, POINT_SPACING_PX)
    sought = poor[painted.element[expected.rows]]
    sought &= ~np.isin(expected.rows, seen.expected.rows[hidden])
    if not sought.any():
        return None
    expected = expected.chosen(np.flatnonzero(sought))
    usual = float(np.median(seen.offsets.contrast[seen.offsets.found]))
    offsets, near = nearest_line_offsets(
        picture, expected, painted, frame, _DISPLACED_PX, _FAR_RADIUS_PX
    )
    found = offsets.found & (near | (offsets.contrast >= MIN_RELATIVE_CONTRAST * usual))
    if on_ground:
        found &= ~offsets.is_hidden(explained & painted.required[own], seen.offsets)
    return _consistent_with_neighbours(expected, offsets.px, found, painted)


def _consistent_with_neighbours(
    expected: ExpectedLinePoints, px: FloatArray, found: NDArray[np.bool_], painted: MarkingPoints
) -> NearbyEdgePoints | None:
    """Return what was found so far off (n,), where it goes on as its neighbour does."""
    goes_on = found[1:] & found[:-1] & (np.abs(np.diff(px)) < _NEIGHBOUR_TOLERANCE_PX)
    goes_on &= np.diff(expected.run) == 0
    rows = np.flatnonzero(np.append(goes_on, False) | np.append(False, goes_on))[::_SUBSAMPLING]
    if not len(rows):
        return None
    normal, own = expected.normal[:, rows], expected.rows[rows]
    across = (expected.px[:, rows] * normal).sum(axis=0) + px[rows]
    marks = EdgePoints(
        painted.world[:, own], across, normal, painted.element[own], expected.run[rows]
    )
    return NearbyEdgePoints(marks.small(), _SUBSAMPLING * expected.length_px[rows])


def displaced_elements(
    vector: FloatArray,
    marks: EdgePoints,
    length_px: FloatArray,
    around: NearbyEdgePoints | None,
    frame: ImageFrame,
) -> dict[int, float]:
    """Elements that a camera (11,) shows next to their paint, by number in `MarkingPoints.names`:
    how far the paint lies off, solver px.

    Args:
        marks: n places of paint the camera goes by.
        length_px: (n,) what each of them stands for.
        around: what was looked for farther out; these elements are judged by it alone.
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
    return np.flatnonzero(painted.required & (shown >= _LONG_PX) & (found < _MISSED * shown))


def _one_sided_offset(off: FloatArray, length: FloatArray) -> float | None:
    """Return how far off the paint of one element lies, if a stretch of it does, all to one
    side."""
    on = length[np.abs(off) < _DISPLACED_PX].sum()
    sides = [np.flatnonzero(side * off >= _DISPLACED_PX) for side in (1, -1)]
    side = max(sides, key=lambda rows: float(length[rows].sum()))
    beside = float(length[side].sum())
    if beside < _MIN_DISPLACED_LENGTH_PX or beside < _MIN_DISPLACED_SHARE * (on + beside):
        return None
    return float(np.abs(np.median(off[side])))


def edge_point_residuals(vector: FloatArray, marks: EdgePoints, frame: ImageFrame) -> FloatArray:
    """(n,) solver px that marks are off from where a camera (11,) shows them."""
    lens = Lens.of(vector[None], frame.half_diagonal)
    px, _ = project_visible(lens, marks.world.astype(np.float64))
    return np.asarray(marks.across - (px[0] * marks.normal).sum(axis=0))


def displaced_elements_text(
    beside: dict[int, float], painted: MarkingPoints, frame: ImageFrame
) -> str:
    """That required elements lie next to their paint, the farthest first; "" of none."""
    beside = {own: px for own, px in beside.items() if painted.required[own]}
    if not beside:
        return ""
    number = max(beside, key=lambda own: beside[own])
    name, px = translatable(painted.titles[number]), beside[number] / frame.scale
    more = len(beside) - 1
    if not more:
        return translatable("{name} is {px:.0f} px off its line", name=name, px=px)
    return translatable(
        "{name} is {px:.0f} px off its line, and {more} more are off theirs",
        name=name,
        px=px,
        more=more,
    )


SEARCH_RADII_PX = (20.0, 10.0, 5.0, 5.0)
_LOSS_SCALE_SHARE = 0.5  # of the reach: farther off, marks count less and less
_MIN_EDGE_POINTS = 12  # marks, for a camera to go by


@dataclass(frozen=True, eq=False)
class LineAlignment:
    """A camera on the paint of a picture.

    Attributes:
        fit: the camera with its standard deviations, or why there is none.
        coverage: share of the visible model that was found on paint, 0 to 1.
        residual_px: median distance of that paint, px of the picture; None if there was too little.
        shares: class in sight -> share of it that was found.
        marks: how many places of paint it goes by.
    """

    fit: FitResult
    coverage: float
    residual_px: float | None
    shares: Mapping[str, float]
    marks: int


def align_with_lines(
    picture: PixelArray,
    field: Field,
    camera: PinholeCamera | FloatArray,
    *,
    belief: GaussianState | None = None,
    reaches_px: Sequence[float] = SEARCH_RADII_PX,
) -> LineAlignment:
    """Make a camera right on the paint that its picture shows near where it expects some.

    Args:
        picture: (H, W, 4) BGRA.
        field: the elements, taken for the middle of their paint, see `marking_points`.
        camera: nearly right: in px of the picture, or (11,) parameters of
            `calibration.optimization.camera_parameters`.
        belief: what is known of the camera besides; None for what is known of any.
        reaches_px: how far off to look for paint, solver px (960 across the picture), one after
            the other.
    """
    frame = ImageFrame((picture.shape[1], picture.shape[0]))
    vector = (
        vector_from_camera(camera, frame) if isinstance(camera, PinholeCamera) else camera.copy()
    )
    painted = marking_points(field)
    belief = default_state(vector, field) if belief is None else belief
    for reach in reaches_px:
        seen = measure_lines(picture, vector, painted, frame, reach)
        if len(seen.marks) < _MIN_EDGE_POINTS:
            return _no_alignment(frame, painted, seen)
        solved = update_from_measurement(seen, belief, vector, frame, reach)
        vector = solved.vector
    return alignment_result(solved, seen, belief, painted, frame)


def update_from_measurement(
    seen: LineMeasurement,
    belief: GaussianState,
    start: FloatArray,
    frame: ImageFrame,
    reach_px: float,
) -> StateUpdate:
    """The camera for what was found within a reach, from (11,) parameters."""
    scale = _LOSS_SCALE_SHARE * reach_px
    return update_state(
        seen.marks, belief, start, frame.half_diagonal, error_px=1.0, scale_px=scale
    )


def alignment_result(
    solved: StateUpdate,
    seen: LineMeasurement,
    belief: GaussianState,
    painted: MarkingPoints,
    frame: ImageFrame,
) -> LineAlignment:
    """Return what a refinement hands back."""
    worth = estimate_edge_noise(solved, seen.marks)
    coverage, shares = found_shares(seen, solved.weights, painted)
    fit = fit_from_edge_points(solved, seen.marks, belief, worth, painted, frame)
    counted = solved.weights > MIN_WEIGHT
    residual = (
        float(np.median(np.abs(solved.off[counted]))) / frame.scale if counted.any() else None
    )
    return LineAlignment(fit, coverage, residual, shares, int(counted.sum()))


def _no_alignment(
    frame: ImageFrame, painted: MarkingPoints, seen: LineMeasurement
) -> LineAlignment:
    fit = FitResult(
        "R", frame.size, None, "there is too little paint where the camera expects some"
    )
    coverage, shares = found_shares(seen, np.zeros(len(seen.marks)), painted)
    return LineAlignment(fit, coverage, None, shares, 0)
