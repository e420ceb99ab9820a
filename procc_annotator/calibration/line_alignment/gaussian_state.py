"""Camera estimate with information matrix, updated by edge points; their noise model."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.line_alignment.expected_lines import MarkingPoints
from procc_annotator.calibration.optimization.camera_parameters import (
    FREE_PARAMETERS,
    KAPPA,
    MIN_KAPPA,
    PARAMETERS,
    camera_from_vector,
)
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.calibration.optimization.initialization import prior_near
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.projection import Lens, project
from procc_annotator.calibration.result import ElementResidual, FitResult, pose_deviations
from procc_annotator.field.model import Field

PARAMETERS_FREE = FREE_PARAMETERS["R"]

FloatingArray = NDArray[np.floating]
IntegerArray = NDArray[np.integer]


@dataclass(frozen=True, eq=False)
class EdgePoints:
    """n places of paint that were found in a picture.

    A place may slide along its element: only its distance across counts, which a camera that moves
    a little changes as that of the place itself.

    Attributes:
        world: (3, n) metres, in the middle of the paint.
        across: (n,) solver px: where the paint was found, along the normal.
        normal: (2, n) unit vectors in the picture.
        element: (n,) which element each is on.
        run: (n,) which stretch in sight.
    """

    world: FloatingArray
    across: FloatingArray
    normal: FloatingArray
    element: IntegerArray
    run: IntegerArray

    def __len__(self) -> int:
        return len(self.across)

    def small(self) -> EdgePoints:
        """The same in less than half the room, to be kept: places to some micrometres."""
        return EdgePoints(
            self.world.astype(np.float32),
            self.across.astype(np.float32),
            self.normal.astype(np.float32),
            self.element.astype(np.int16),
            self.run.astype(np.int16),
        )

    def chosen(self, rows: np.ndarray) -> EdgePoints:
        """Some of them."""
        return EdgePoints(
            self.world[:, rows],
            self.across[rows],
            self.normal[:, rows],
            self.element[rows],
            self.run[rows],
        )


def edge_point_errors(
    vectors: FloatArray, marks: EdgePoints, half_diagonal: float, free: int = PARAMETERS_FREE
) -> tuple[FloatArray, FloatArray]:
    """Return how far n marks are from where cameras (B, 11) show them, across: (B, n) solver px,
    and (B, n, free) derivatives of where they show them, by the first ``free`` parameters."""
    lens = Lens.of(vectors, half_diagonal)
    places = marks.world.astype(np.float64)
    world = np.broadcast_to(places, (len(vectors), *places.shape))
    px, _, derivatives = project(lens, world, np.zeros_like(world), free)
    shown = (px * marks.normal).sum(axis=1)
    by = (derivatives * marks.normal).sum(axis=2)
    return marks.across - shown, by.transpose(0, 2, 1)


_ITERATIONS = 8
_CONVERGED_PX = 0.05
_MAX_KAPPA = 0.6
# Farther off, a mark is less and less likely to be of the paint it was taken for.
MIN_SCALE_PX = 1.5
MIN_WEIGHT = 0.25  # weight from which on it is


@dataclass(frozen=True, eq=False)
class GaussianState:
    """The (11,) parameters of a camera, and how surely they are known: (8, 8) inverse covariance of
    the free ones; 0 of what no one knows."""

    vector: FloatArray
    information: FloatArray

    @property
    def covariance(self) -> FloatArray:
        """(8, 8)."""
        found = np.linalg.inv(self.information)
        return np.asarray((found + found.T) / 2)


def default_state(vector: FloatArray, field: Field) -> GaussianState:
    """Return what is known of any camera around a field that is on the side of another one
    (11,)."""
    prior = prior_near(vector, camera_placement_prior(field), PARAMETERS_FREE)
    mean = vector.copy()
    mean[:PARAMETERS_FREE] = np.where(
        prior.inverse_sd[0] > 0, prior.mean[0], vector[:PARAMETERS_FREE]
    )
    return GaussianState(mean, np.diag(prior.inverse_sd[0] ** 2))


@dataclass(frozen=True, eq=False)
class StateUpdate:
    """The camera that is best for marks and a belief.

    Attributes:
        vector: (11,) parameters.
        information: (8, 8) of the marks alone, for errors of 1 px, at what they count.
        off: (n,) solver px that remain of each mark.
        weights: (n,) 0 to 1, what each counts.
    """

    vector: FloatArray
    information: FloatArray
    off: FloatArray
    weights: FloatArray


def update_state(
    marks: EdgePoints,
    belief: GaussianState,
    start: FloatArray,
    half_diagonal: float,
    *,
    error_px: float,
    scale_px: float,
) -> StateUpdate:
    """The best camera for n marks of paint and a belief before them, robustly, from a start (11,).

    Args:
        error_px: standard deviation of a mark, solver px; what weighs them against the belief.
        scale_px: marks farther off than this count less and less; halved from step to step until
            it is that of marks on the same paint.
    """
    free = len(belief.information)
    vector, scale = start.copy(), max(scale_px, MIN_SCALE_PX)
    for _ in range(_ITERATIONS):
        off, by = edge_point_errors(vector[None], marks, half_diagonal, free)
        weights = geman_mcclure_weights(off[0], scale)
        weighted = by[0] * weights[:, None]
        information = weighted.T @ by[0]
        before = belief.vector[:free] - vector[:free]
        gradient = weighted.T @ off[0] / error_px**2 + belief.information @ before
        normal = information / error_px**2 + belief.information
        step = np.linalg.solve(normal, gradient)
        vector[:free] += step
        if free > KAPPA:
            vector[KAPPA] = np.clip(vector[KAPPA], MIN_KAPPA, _MAX_KAPPA)
        is_last = scale == MIN_SCALE_PX
        scale = max(scale / 2, MIN_SCALE_PX)
        if is_last and np.abs(by[0] @ step).max(initial=0.0) < _CONVERGED_PX:
            break
    off = off[0] - by[0] @ step
    return StateUpdate(vector, information, off, geman_mcclure_weights(off, scale))


def geman_mcclure_weights(off: FloatArray, scale_px: float = MIN_SCALE_PX) -> FloatArray:
    """Return what marks count that are so far off, solver px (Geman and McClure)."""
    return np.asarray((1 / (1 + (off / scale_px) ** 2)) ** 2)


_MIN_ERROR_PX, _PRIOR_ERROR_PX, _PRIOR_WEIGHT = 0.08, 0.5, 20.0
_CORRELATION_LAGS = 12  # neighbouring marks, whose errors may have a part in common
_MAX_CORRELATED = 12.0


@dataclass(frozen=True, slots=True)
class EdgeNoiseModel:
    """Noise of edge points: standard deviation of one, solver px, and how many ``together`` are
    worth one, for neighbours err together."""

    error_px: float
    together: float

    @property
    def independent_error_px(self) -> float:
        """Standard deviation that marks would have if they were as many independent ones."""
        return self.error_px * float(np.sqrt(self.together))


def estimate_edge_noise(solved: StateUpdate, marks: EdgePoints) -> EdgeNoiseModel:
    """Return what the marks of a picture are worth, by what remains of them."""
    counted = solved.weights > MIN_WEIGHT
    off, run = solved.off[counted], marks.run[counted]
    if not len(off):
        return EdgeNoiseModel(_PRIOR_ERROR_PX, _MAX_CORRELATED)
    squares = float((off * off).sum())
    variance = (squares + _PRIOR_WEIGHT * _PRIOR_ERROR_PX**2) / (len(off) + _PRIOR_WEIGHT)
    # Sums of neighbours: as large as they are independent, or larger.
    place = np.arange(len(run)) - np.searchsorted(run, run)
    group = run * (len(run) // _CORRELATION_LAGS + 2) + place // _CORRELATION_LAGS
    _, of = np.unique(group, return_inverse=True)
    sums = np.bincount(of, off)
    together = float((sums * sums).sum()) / max(squares, 1e-9)
    return EdgeNoiseModel(
        max(float(np.sqrt(variance)), _MIN_ERROR_PX), min(max(together, 1.0), _MAX_CORRELATED)
    )


def fit_from_edge_points(
    solved: StateUpdate,
    marks: EdgePoints,
    belief: GaussianState,
    worth: EdgeNoiseModel,
    painted: MarkingPoints,
    frame: ImageFrame,
) -> FitResult:
    """A fit to marks, as any fit is returned."""
    information = solved.information / worth.independent_error_px**2 + belief.information
    covariance = np.linalg.inv(information)
    covariance = (covariance + covariance.T) / 2
    return fit_from_covariance(
        solved.vector,
        covariance,
        frame,
        worth.error_px,
        _element_residuals(solved, marks, painted, frame),
    )


def fit_from_covariance(
    vector: FloatArray,
    covariance: FloatArray,
    frame: ImageFrame,
    error_px: float,
    elements: tuple[ElementResidual, ...] = (),
) -> FitResult:
    """A camera (11,) as a fit, with the covariance (8, 8) of its free parameters and the standard
    deviation of a mark, solver px."""
    return FitResult(
        "R",
        frame.size,
        camera_from_vector(vector, frame),
        None,
        elements,
        pose_deviations(vector, covariance, frame),
        error_px / frame.scale,
        PARAMETERS[:PARAMETERS_FREE],
        covariance,
        True,
        vector,
        of_clicks=covariance,
        information=np.asarray(np.linalg.inv(covariance)),
    )


def _element_residuals(
    solved: StateUpdate, marks: EdgePoints, painted: MarkingPoints, frame: ImageFrame
) -> tuple[ElementResidual, ...]:
    away = np.abs(solved.off) / frame.scale
    found = []
    for number in np.unique(marks.element).tolist():
        own = marks.element == number
        counted = own & (solved.weights > MIN_WEIGHT)
        left_out = not counted.any()
        distances = away[own if left_out else counted]
        found.append(ElementResidual(painted.names[number], tuple(distances.tolist()), left_out))
    return tuple(found)
