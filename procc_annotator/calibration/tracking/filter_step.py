"""One filter step: predict the camera from the image motion, update it with the lines found;
lines it misses.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.line_alignment.expected_lines import (
    ExpectedLinePoints,
    MarkingPoints,
    expected_line_points,
)
from procc_annotator.calibration.line_alignment.gaussian_state import (
    MIN_WEIGHT,
    PARAMETERS_FREE,
    EdgeNoiseModel,
    EdgePoints,
    GaussianState,
    StateUpdate,
    default_state,
    edge_point_errors,
    estimate_edge_noise,
    geman_mcclure_weights,
    update_state,
)
from procc_annotator.calibration.line_alignment.refinement import (
    MIN_RELATIVE_CONTRAST,
    POINT_SPACING_PX,
    LineMeasurement,
    NearbyEdgePoints,
    displaced_elements,
    edge_point_residuals,
    elements_missed,
    found_shares,
    measure_at,
    measure_lines,
    search_nearby,
)
from procc_annotator.calibration.optimization.camera_parameters import (
    KAPPA,
    LOG_FOCAL,
    POSITION_SLICE,
    ROLL,
    X,
    Z,
    camera_from_vector,
    vector_from_camera,
)
from procc_annotator.calibration.optimization.covariance import (
    max_direction_sd,
    projected_covariance,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.projection import Lens, project_visible
from procc_annotator.calibration.prediction.visible_elements import visible_stretches
from procc_annotator.calibration.single_image.icp_refinement import (
    SAME_DIRECTION_RAD,
    ImageLinePixels,
)
from procc_annotator.calibration.tracking.motion_model import (
    MOTION_PARAMETERS,
    TRIPOD_NOISE,
    InterFrameMotion,
    ProcessNoise,
    kappa_change_sd,
)
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import Camera
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import translatable

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

    Neither alone suffices for a mistake: worn and hidden lines have no line pixels either, and
    images show lines that are none of the field's.

    Args:
        seen: the line pixels of the whole picture.
        vector: (11,) of the camera.
        missed: numbers in `Painted.names` of elements without line pixels.

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


_ROLL_DRIFT_RAD = 2e-5  # what a frame may add to what is believed, standard deviation: tripods lean
# Of a step that nothing foretells: pan, tilt, roll, logarithm of the focal length.
_UNKNOWN_MOTION_SD = np.array([np.deg2rad(0.25), np.deg2rad(0.15), np.deg2rad(0.03), 0.01])
_VELOCITY_DECAY = 0.7
_MIN_SEARCH_RADIUS_PX, _MAX_SEARCH_RADIUS_PX = 5.0, 20.0
_SEARCH_RADIUS_SD = 3.0
_CONFIDENT_RADIUS_PX = 8.0  # beyond it what was found is looked at once more, from nearer
_MIN_EDGE_POINTS = 15  # marks that may have a say
_MIN_COVERAGE, _MIN_COVERAGE_FAR = 0.3, 0.5
_MAX_MAHALANOBIS, _MAX_DISPLACED_PX = (
    4.0,
    4.0,
)  # how far paint may move the camera against the belief
_COMPARISON_SPACING_PX = 20.0
_FIRST_PASS_SUBSAMPLING = (
    3  # of marks that were averaged with their neighbours every third tells it all
)
_STORED_EDGE_POINTS = 64


@dataclass(frozen=True, eq=False)
class FilterStep:
    """Camera of a frame.

    Attributes:
        belief: after the frame.
        marks: paint that had a say, thinned; None if none had.
        worth: of a mark.
        standing_for: how many marks each that was kept stands for.
        turn: from the frame before; None at the first, or where nothing decides.
        coverage, residual_px: of what should be in sight; solver px.
        sd_px: how surely its wireframe is known, solver px, where it is least sure.
        reason: why paint had no say, in words; "" if it had.
        around: where the elements of which little was found were seen, farther out.
    """

    belief: GaussianState
    marks: EdgePoints | None
    worth: EdgeNoiseModel
    turn: InterFrameMotion | None
    coverage: float
    residual_px: float | None
    sd_px: float
    reason: str = ""
    represented_weight: float = 1.0
    around: NearbyEdgePoints | None = None

    def beside(self, vector: FloatArray, frame: ImageFrame) -> dict[int, float]:
        """Elements that a camera (11,) shows next to their paint in this frame, see
        `displaced_elements`."""
        if self.marks is None:
            return {}
        return displaced_elements(vector, self.marks, self.mark_lengths_px, self.around, frame)

    def missed(self, painted: MarkingPoints, frame: ImageFrame) -> IntArray:
        """Elements that its camera misses in this frame, see `elements_missed`."""
        if self.marks is None:
            return np.zeros(0, dtype=np.intp)
        return elements_missed(self.belief.vector, self.marks, self.mark_lengths_px, painted, frame)

    @property
    def mark_lengths_px(self) -> FloatArray:
        """(n,) solver px of the element that each mark stands for."""
        count = 0 if self.marks is None else len(self.marks)
        return np.full(count, self.represented_weight * _FIRST_PASS_SUBSAMPLING * POINT_SPACING_PX)


def predict_state(
    belief: GaussianState,
    turn: InterFrameMotion | None,
    last: FloatArray,
    stand: ProcessNoise = TRIPOD_NOISE,
) -> GaussianState:
    """Return what is believed of a camera one frame on.

    Args:
        belief: of the frame before.
        turn: how the picture says it moved.
        last: (4,) the step before, which goes on more slowly where nothing decides.
    """
    covariance = belief.covariance
    vector = belief.vector.copy()
    step = np.zeros((PARAMETERS_FREE, PARAMETERS_FREE))
    if turn is None:
        vector[MOTION_PARAMETERS] += _VELOCITY_DECAY * last
        step[MOTION_PARAMETERS, MOTION_PARAMETERS] = _UNKNOWN_MOTION_SD**2
    else:
        vector[MOTION_PARAMETERS] += turn.step
        step[np.ix_(MOTION_PARAMETERS, MOTION_PARAMETERS)] = turn.covariance + np.diag(
            stand.apparent**2
        )
    step[range(X, Z + 1), range(X, Z + 1)] += stand.position_m**2
    step[KAPPA, KAPPA] += kappa_change_sd(vector[LOG_FOCAL] - belief.vector[LOG_FOCAL]) ** 2
    step[ROLL, ROLL] += _ROLL_DRIFT_RAD**2
    return GaussianState(vector, np.asarray(np.linalg.inv(covariance + step)))


def projection_sd_px(belief: GaussianState, seen: FloatArray, frame: ImageFrame) -> float:
    """Return how surely places (3, n) metres in sight are known in the picture: that of nine in
    ten."""
    if not seen.shape[1]:
        return np.inf
    few = seen[:, :: max(1, seen.shape[1] // 60)]
    found = projected_covariance(belief.vector, None, frame.half_diagonal, belief.covariance, few.T)
    sd = max_direction_sd(found)
    sd = sd[np.isfinite(sd)]
    return _percentile_90(sd)


def filter_step(
    picture: PixelArray,
    believed: GaussianState,
    turn: InterFrameMotion | None,
    painted: MarkingPoints,
    frame: ImageFrame,
    worth: EdgeNoiseModel,
) -> FilterStep:
    """A frame's camera from what is believed of it and the paint near where that shows some.

    Args:
        picture: (H, W, 4) BGRA.
        believed: before the frame's paint, see `foretold`.
        turn: what went into that.
        worth: of a mark in the frame before.
    """
    expected = expected_line_points(believed.vector, painted, frame, POINT_SPACING_PX)
    sd_px = projection_sd_px(believed, painted.world[:, expected.rows], frame)
    reach = float(
        np.clip(_SEARCH_RADIUS_SD * sd_px + 2.0, _MIN_SEARCH_RADIUS_PX, _MAX_SEARCH_RADIUS_PX)
    )
    seen = measure_at(picture, expected, painted, frame, reach)
    none = FilterStep(believed, None, worth, turn, 0.0, None, sd_px)
    if len(seen.marks) < _MIN_EDGE_POINTS:
        return replace(none, reason=translatable("too little paint in sight"))
    solved, marks = _solve_update(seen, believed, believed.vector, frame, worth, reach)
    if reach > _CONFIDENT_RADIUS_PX:
        seen = measure_lines(picture, solved.vector, painted, frame, _MIN_SEARCH_RADIUS_PX)
        if len(seen.marks) < _MIN_EDGE_POINTS:
            return replace(none, reason=translatable("too little paint in sight"))
        solved, marks = _solve_update(
            seen, believed, solved.vector, frame, worth, _MIN_SEARCH_RADIUS_PX
        )
    off = edge_point_residuals(solved.vector, seen.marks, frame)
    weights = geman_mcclure_weights(off)
    coverage, _ = found_shares(seen, weights, painted)
    least = _MIN_COVERAGE_FAR if reach > _CONFIDENT_RADIUS_PX else _MIN_COVERAGE
    none = replace(none, coverage=coverage)
    if (
        solved.weights > MIN_WEIGHT
    ).sum() < _MIN_EDGE_POINTS / _FIRST_PASS_SUBSAMPLING or coverage < least:
        return replace(none, reason=translatable("too little of what should be in sight was found"))
    moved = _projection_difference(expected, solved.vector, painted, frame)
    if moved > _MAX_MAHALANOBIS * sd_px + _MAX_DISPLACED_PX:
        return replace(
            none, reason=translatable("the paint that was found would move the camera too far")
        )
    residual = float(np.median(np.abs(off[weights > MIN_WEIGHT])))
    around = search_nearby(picture, solved.vector, painted, frame, seen, weights, on_ground=True)
    none = replace(none, residual_px=residual, around=around)
    return _updated_step(none, solved, marks, painted.world[:, seen.expected.rows], frame)


_FREE_AGAIN = 1000.0  # times the smoothed covariance, within which a frame's own paint may move it


def remeasured_step(
    picture: PixelArray,
    step: FilterStep,
    painted: MarkingPoints,
    frame: ImageFrame,
    reach_px: float = _MIN_SEARCH_RADIUS_PX,
) -> FilterStep:
    """A frame with the edge points that are found around its smoothed camera.

    Args:
        picture: (H, W, 4) BGRA.
        step: of the frame, with its smoothed camera.
        reach_px: how far off they are looked for, solver px.
    """
    wide = step.belief.information / _FREE_AGAIN
    place = step.belief.covariance[POSITION_SLICE, POSITION_SLICE]
    wide[POSITION_SLICE, POSITION_SLICE] += np.linalg.inv(place)
    believed, vector = GaussianState(step.belief.vector, wide), step.belief.vector
    for reach in sorted({reach_px, _MIN_SEARCH_RADIUS_PX}, reverse=True):
        seen = measure_lines(picture, vector, painted, frame, reach)
        if len(seen.marks) < _MIN_EDGE_POINTS:
            return step
        solved, marks = _solve_update(_plain_far(seen), believed, vector, frame, step.worth, reach)
        vector = solved.vector
    off = edge_point_residuals(vector, seen.marks, frame)
    weights = geman_mcclure_weights(off)
    coverage, _ = found_shares(seen, weights, painted)
    least = _MIN_COVERAGE if step.marks is not None else _MIN_COVERAGE_FAR
    few = (solved.weights > MIN_WEIGHT).sum() < _MIN_EDGE_POINTS / _FIRST_PASS_SUBSAMPLING
    if few or coverage < least:
        return step
    around = search_nearby(picture, vector, painted, frame, seen, weights, on_ground=True)
    again = replace(
        step,
        coverage=coverage,
        residual_px=float(np.median(np.abs(off[weights > MIN_WEIGHT]))),
        around=around,
        reason="",
    )
    return _updated_step(again, solved, marks, painted.world[:, seen.expected.rows], frame)


def _plain_far(seen: LineMeasurement) -> LineMeasurement:
    """Return what was found, without what is far off and fainter than usual: edges of boards."""
    px, contrast = (of[seen.offsets.found] for of in (seen.offsets.px, seen.offsets.contrast))
    kept = (np.abs(px) <= _MIN_SEARCH_RADIUS_PX) | (
        contrast >= MIN_RELATIVE_CONTRAST * np.median(contrast)
    )
    return replace(seen, marks=seen.marks.chosen(np.flatnonzero(kept)))


def _updated_step(
    before: FilterStep, solved: StateUpdate, marks: EdgePoints, seen: FloatArray, frame: ImageFrame
) -> FilterStep:
    """A frame after its paint has had a say; ``seen``: (3, n) metres, what is in sight."""
    worth = estimate_edge_noise(solved, marks)
    information = solved.information / worth.independent_error_px**2 + before.belief.information
    belief = GaussianState(solved.vector, information)
    counted = solved.weights > MIN_WEIGHT
    kept = _stored_rows(counted)
    return replace(
        before,
        belief=belief,
        marks=marks.chosen(kept).small(),
        worth=worth,
        sd_px=projection_sd_px(belief, seen, frame),
        represented_weight=float(counted.sum()) / len(kept),
    )


def _solve_update(
    seen: LineMeasurement,
    believed: GaussianState,
    start: FloatArray,
    frame: ImageFrame,
    worth: EdgeNoiseModel,
    reach_px: float,
) -> tuple[StateUpdate, EdgePoints]:
    """The camera for every third of the marks, and those."""
    marks = seen.marks.chosen(np.arange(0, len(seen.marks), _FIRST_PASS_SUBSAMPLING))
    solved = update_state(
        marks,
        believed,
        start,
        frame.half_diagonal,
        error_px=worth.independent_error_px,
        scale_px=reach_px / 2,
    )
    return solved, marks


def projection_difference_px(
    one: FloatArray, other: FloatArray, painted: MarkingPoints, frame: ImageFrame
) -> float:
    """Solver px by which nine in ten places in sight of a camera (11,) are less off, across, in
    another one's picture."""
    return _projection_difference(
        expected_line_points(one, painted, frame, _COMPARISON_SPACING_PX), other, painted, frame
    )


def _projection_difference(
    expected: ExpectedLinePoints, other: FloatArray, painted: MarkingPoints, frame: ImageFrame
) -> float:
    if not len(expected.rows):
        return np.inf
    lens = Lens.of(other[None], frame.half_diagonal)
    there, _ = project_visible(lens, painted.world[:, expected.rows])
    across = ((there[0] - expected.px) * expected.normal).sum(axis=0)
    return _percentile_90(np.abs(across))


def _percentile_90(values: FloatArray) -> float:
    """Return what nine in ten of them are below; infinite without any."""
    return float(np.sort(values)[int(0.9 * (len(values) - 1))]) if len(values) else np.inf


def _stored_rows(counted: np.ndarray) -> np.ndarray:
    """Rows of the marks that are kept, evenly chosen."""
    rows = np.flatnonzero(counted)
    if len(rows) <= _STORED_EDGE_POINTS:
        return rows
    return np.asarray(
        rows[np.linspace(0, len(rows) - 1, _STORED_EDGE_POINTS).round().astype(np.intp)]
    )


# A given camera is trusted to show every line so well, solver px; the picture can correct it.
_GIVEN_CAMERA_SD_PX = 1.0
_SAMPLE_POINTS = 12


def nearest_pinhole_vector(camera: Camera, field: Field, frame: ImageFrame) -> FloatArray:
    """(11,) parameters of the pinhole camera that is nearest to any.

    Raises:
        UsageError: none is near it.
    """
    if isinstance(camera, PinholeCamera):
        return vector_from_camera(camera, frame)
    polylines = []
    for stretch in visible_stretches(field, camera, frame.size):
        rows = np.linspace(0, len(stretch.points_px) - 1, _SAMPLE_POINTS).round().astype(int)
        points = [point_from_px(x, y, frame.size) for x, y in stretch.points_px[rows].tolist()]
        polylines.append(Polyline(stretch.name, tuple(points)))
    found = fit_camera(FrameAnnotation(tuple(polylines)), field, model="R", size=frame.size)
    if found.vector is None:
        raise UsageError(
            f"a camera that is to be followed is no camera of this field: {found.failure}"
        )
    return found.vector


def state_from_camera(
    vector: FloatArray, field: Field, painted: MarkingPoints, frame: ImageFrame
) -> GaussianState:
    """Return what is believed of a frame whose camera (11,) was given: that it shows lines about
    right."""
    expected = expected_line_points(vector, painted, frame, spacing_px=20.0)
    rows = expected.rows
    across = (expected.px * expected.normal).sum(axis=0)
    marks = EdgePoints(
        painted.world[:, rows], across, expected.normal, painted.element[rows], expected.run
    )
    before = default_state(vector, field)
    _, by = edge_point_errors(vector[None], marks, frame.half_diagonal, len(before.information))
    # The lines of a given camera are off together: they are worth as much as their number.
    lines = len(np.unique(expected.run))
    from_lines = by[0].T @ by[0] * (lines / max(len(rows), 1)) / _GIVEN_CAMERA_SD_PX**2
    return replace(before, vector=vector, information=before.information + from_lines)
