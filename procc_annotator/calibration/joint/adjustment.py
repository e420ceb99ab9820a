"""Shared parameters of many frames, each frame's camera eliminated; fits at a known position."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.camera_parameters import (
    FISHEYE_FLAG,
    FREE_PARAMETERS,
    KAPPA,
    MIN_KAPPA,
    ROLL,
    X,
    Z,
    is_wide_angle,
    lower_bounded_parameter,
)
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.calibration.optimization.initialization import (
    initial_cameras_at_position,
    prior_near,
)
from procc_annotator.calibration.optimization.observations import (
    ImageFrame,
    Observations,
    build_observations,
)
from procc_annotator.calibration.optimization.residuals import (
    Residuals,
    estimate_click_sd,
    linear_map,
    pinhole_residuals,
    residual_components,
    whitened,
)
from procc_annotator.calibration.optimization.robust_fit import CameraSolution
from procc_annotator.calibration.optimization.solver import (
    FINAL_LOSS,
    ROBUST_LOSS,
    SEARCH_LOSS,
    GaussianPrior,
    Problem,
    RobustLoss,
    solve,
)
from procc_annotator.calibration.result import FitResult, fit_result_from, pose_deviations
from procc_annotator.field.model import Field

_ITERATIONS = 12
_STEP_HALVINGS = 5
_CONVERGED_STEP_SD = 0.02  # a step smaller than this many standard deviations ends the search


@dataclass(frozen=True, eq=False)
class ReducedFrame:
    """A frame with the camera that is best for the shared parameters.

    Attributes:
        vector: (11,) of the camera.
        cost: robust cost, the camera's own prior included.
        gradient: (s,) of that by the shared parameters.
        normal: (s, s) its Gauss-Newton matrix, reduced by the camera's own parameters.
        components: (M,) solver px, what the residuals of the points with a say are made of.
        own: number of the camera's own parameters.
    """

    vector: FloatArray
    cost: float
    gradient: FloatArray
    normal: FloatArray
    components: FloatArray
    own: int


@dataclass(frozen=True, eq=False)
class SharedParameterPrior:
    """Prior and limits of shared parameters: all (s,)."""

    mean: FloatArray
    inverse_sd: FloatArray
    lowest: FloatArray
    highest: FloatArray


@dataclass(frozen=True, eq=False)
class SharedSolution:
    """Shared parameters of F frames.

    Attributes:
        values: (s,).
        covariance: (s, s).
        profiles: of the frames, in their order.
    """

    values: FloatArray
    covariance: FloatArray
    profiles: tuple[ReducedFrame, ...]


def reduce_frame(
    vector: FloatArray,
    residuals: Residuals,
    weights: FloatArray,
    prior: GaussianPrior,
    own: NDArray[np.intp],
) -> ReducedFrame:
    """A frame with its best camera, its own parameters taken out.

    Args:
        vector: (11,) of the camera.
        residuals: of it, with derivatives by the shared parameters first, then by ``own``.
        weights: (N,) of the points; 0 for those that have no say.
        own: (n,) its own parameters, as indices of ``vector``.
    """
    costs, robust = FINAL_LOSS.cost_and_weight(residuals.distances[0])
    inverse = prior.inverse_sd[0, own]
    off = (vector[own] - prior.mean[0, own]) * inverse
    shared = residuals.derivatives.shape[1] - len(own)
    gradient, normal = schur_complement(
        residuals, robust * weights, off * inverse, np.diag(inverse**2), shared
    )
    cost = float(costs @ weights) + float(off @ off) / 2
    own_components = residual_components(residuals.values[0], residuals.whole[0], weights > 0)
    return ReducedFrame(vector, cost, gradient, normal, own_components, len(own))


def unbounded_parameters(vector: FloatArray, free: int) -> NDArray[np.intp]:
    """Free parameters of a camera; a radial coefficient on its bound is none."""
    bound = free > KAPPA and not is_wide_angle(vector) and vector[KAPPA] in (0.0, MIN_KAPPA)
    return np.array([i for i in range(free) if not (bound and i == KAPPA)], dtype=np.intp)


FrameReducer = Callable[[FloatArray, Sequence[FloatArray]], list[ReducedFrame]]


def schur_complement(
    residuals: Residuals,
    weights: FloatArray,
    own_gradient: FloatArray,
    own_normal: FloatArray,
    shared: int,
) -> tuple[FloatArray, FloatArray]:
    """Gradient (s,) and normal matrix (s, s) by shared parameters, a camera's own taken out.

    Args:
        residuals: of one camera, with derivatives by the s shared parameters first, then its own.
        weights: (N,) of the points, that of the robust loss included.
        own_gradient: (n,) of the camera's prior.
        own_normal: (n, n) of the camera's prior.
    """
    rows = residuals.derivatives[0].reshape(len(residuals.derivatives[0]), -1)
    weighted = rows * np.tile(weights, 2)
    normal = weighted @ rows.T
    gradient = weighted @ residuals.values[0].reshape(-1)
    normal[shared:, shared:] += own_normal
    gradient[shared:] += own_gradient
    taken = np.linalg.solve(
        normal[shared:, shared:] + 1e-12 * np.eye(len(own_normal)),
        np.column_stack([normal[shared:, :shared], gradient[shared:]]),
    )
    across = normal[:shared, shared:]
    return (
        gradient[:shared] - across @ taken[:, -1],
        normal[:shared, :shared] - across @ taken[:, :-1],
    )


def solve_shared(
    profiler: FrameReducer,
    start: FloatArray,
    vectors: Sequence[FloatArray],
    prior: SharedParameterPrior,
) -> SharedSolution:
    """Minimise the cost of all frames over the s parameters they share, from a start (s,) and a
    camera (11,) of each frame."""
    values = np.clip(start, prior.lowest, prior.highest)
    profiles = profiler(values, vectors)
    cost = _total_cost(values, profiles, prior)
    for _ in range(_ITERATIONS):
        step, sd = _gauss_newton_step(values, profiles, prior)
        length = float(np.abs(step / sd).max())
        for _ in range(_STEP_HALVINGS):
            tried = np.clip(values + step, prior.lowest, prior.highest)
            found = profiler(tried, [p.vector for p in profiles])
            new = _total_cost(tried, found, prior)
            if new < cost:
                break
            step = step / 2
        else:
            break
        values, profiles, cost = tried, found, new
        if length < _CONVERGED_STEP_SD:
            break
    error_px = _pooled_click_sd(profiles, len(values))
    return SharedSolution(values, _shared_covariance(profiles, prior, error_px), tuple(profiles))


def _total_cost(
    values: FloatArray, profiles: Sequence[ReducedFrame], prior: SharedParameterPrior
) -> float:
    off = (values - prior.mean) * prior.inverse_sd
    return sum(p.cost for p in profiles) + float(off @ off) / 2


def _gauss_newton_step(
    values: FloatArray, profiles: Sequence[ReducedFrame], prior: SharedParameterPrior
) -> tuple[FloatArray, FloatArray]:
    """The Gauss-Newton step, and the standard deviations it is measured by."""
    normal = _summed_normal_matrix(profiles) + np.diag(prior.inverse_sd**2)
    gradient = np.sum([p.gradient for p in profiles], axis=0)
    gradient = gradient + (values - prior.mean) * prior.inverse_sd**2
    # What is on its limit and is pushed through it stays there.
    held = (values <= prior.lowest) & (gradient > 0) | (values >= prior.highest) & (gradient < 0)
    free = ~held
    step = np.zeros(len(values))
    if free.any():
        step[free] = -np.linalg.solve(normal[np.ix_(free, free)], gradient[free])
    return step, 1 / np.sqrt(np.diag(normal))


def _summed_normal_matrix(profiles: Sequence[ReducedFrame]) -> FloatArray:
    return np.asarray(np.sum([p.normal for p in profiles], axis=0))


def _pooled_click_sd(profiles: Sequence[ReducedFrame], shared: int) -> float:
    every = np.concatenate([p.components for p in profiles])
    return estimate_click_sd(every, sum(p.own for p in profiles) + shared)


def _shared_covariance(
    profiles: Sequence[ReducedFrame], prior: SharedParameterPrior, error_px: float
) -> FloatArray:
    """(s, s), from the errors of the points or from how the frames pull, whichever is larger.

    Points of one frame err together where the model is not the whole truth. How differently the
    frames pull at the shared parameters shows that (the sandwich estimator, with frames as its
    clusters; e.g. Cameron and Miller, A Practitioner's Guide to Cluster-Robust Inference, 2015).
    """
    belief = np.diag(prior.inverse_sd**2)
    normal = _summed_normal_matrix(profiles)
    plain = np.linalg.inv(normal / error_px**2 + belief)
    pulls = np.array([p.gradient for p in profiles])
    pulls = pulls - pulls.mean(axis=0)  # on a limit all of them pull through it
    spare = max(len(profiles) - len(prior.mean), 1)
    inverse = np.linalg.inv(normal + belief * error_px**2)
    pulled = inverse @ (pulls.T @ pulls * len(profiles) / spare) @ inverse
    grown = np.sqrt(np.maximum(np.diag(pulled) / np.diag(plain), 1.0))
    covariance = plain * grown[:, None] * grown
    return np.asarray((covariance + covariance.T) / 2)


POSITION_PARAMETERS = np.arange(X, Z + 1)
_FIXED_POSITION_SD_M = 1e-3  # what the position may be off in a fit that is not to move it


@dataclass(frozen=True, eq=False)
class LensAndRollPrior:
    """Priors of a camera's lens and level next to its position: means and standard deviations of
    roll (rad) and kappa."""

    roll: tuple[float, float]
    kappa: tuple[float, float]


@dataclass(frozen=True, eq=False)
class FrameObservations:
    """One frame to be fitted together with others.

    Attributes:
        left_out: (E,) elements taken for mistakes, which have no say.
        model: P, R or R+.
        vector: (11,) its camera, or what to start from.
    """

    seen: Observations
    left_out: NDArray[np.bool_]
    frame: ImageFrame
    model: str
    vector: FloatArray

    @cached_property
    def kept(self) -> Observations:
        """The points, with weight 0 for those that have no say."""
        return self.seen.with_excluded(self.left_out)


def frame_observations(
    annotation: FrameAnnotation, fit: FitResult, field: Field
) -> FrameObservations:
    """A frame as its own fit, which has a pinhole camera, sees it."""
    frame = fit.frame
    seen = build_observations(annotation, field, frame)
    if seen is None or fit.vector is None:
        raise ValueError("a failed fit has no camera")
    out = set(fit.left_out)
    left_out = np.array([element.name in out for element in seen.elements])
    seen = whitened(seen, linear_map(fit.vector))
    return FrameObservations(seen, left_out, frame, fit.model, fit.vector)


def prior_at_position(
    vector: FloatArray, field: Field, free: int, usual: LensAndRollPrior | None = None
) -> GaussianPrior:
    """Weak priors on everything but the position, which is held.

    Args:
        vector: (11,) a camera at that position, nearly right.
        free: number of the model's parameters.
        usual: what is known of the camera besides.
    """
    around = camera_placement_prior(field)
    prior = prior_near(vector, around, free)
    mean, inverse = prior.mean.copy(), prior.inverse_sd.copy()
    mean[:, POSITION_PARAMETERS], inverse[:, POSITION_PARAMETERS] = (
        vector[POSITION_PARAMETERS],
        1 / _FIXED_POSITION_SD_M,
    )
    if usual is not None:
        mean[:, ROLL], inverse[:, ROLL] = usual.roll[0], 1 / usual.roll[1]
        if free > KAPPA and not is_wide_angle(vector):
            mean[:, KAPPA], inverse[:, KAPPA] = usual.kappa[0], 1 / usual.kappa[1]
    return GaussianPrior(mean, inverse)


def fit_at_position(
    sighting: FrameObservations,
    position: FloatArray,
    field: Field,
    *,
    usual: LensAndRollPrior | None = None,
) -> CameraSolution:
    """The camera of a frame at a known position (3,), metres, from one that is nearly right;
    ``usual``: what is known of it besides."""
    start = sighting.vector.copy()
    start[POSITION_PARAMETERS] = position
    prior = prior_at_position(start, field, FREE_PARAMETERS[sighting.model], usual)
    return _fit_at_position(sighting, start[None], position, prior, FINAL_LOSS, 1e-5)


def search_at_position(
    sighting: FrameObservations,
    position: FloatArray,
    field: Field,
    usual: LensAndRollPrior | None = None,
) -> CameraSolution:
    """As `fit_at_position`, without a start: the vector of the frame does not matter."""
    starts = initial_cameras_at_position(position, sighting.seen, field)
    prior = prior_at_position(starts[0], field, FREE_PARAMETERS["P"], usual)
    first = _fit_at_position(
        replace(sighting, model="P"), starts, position, prior, SEARCH_LOSS, 1e-4
    )
    prior = prior_at_position(starts[0], field, FREE_PARAMETERS[sighting.model], usual)
    begin = first.vector[None].copy()
    # Whose other pictures show barrel distortion: only from below 0 is a fit led there.
    begin[:, KAPPA] = 0.0 if usual is None else min(usual.kappa[0], 0.0)
    robust = _fit_at_position(sighting, begin, position, prior, ROBUST_LOSS, 1e-4)
    return _fit_at_position(sighting, robust.vector[None], position, prior, FINAL_LOSS, 1e-5)


def _fit_at_position(
    sighting: FrameObservations,
    starts: FloatArray,
    position: FloatArray,
    prior: GaussianPrior,
    loss: RobustLoss,
    tolerance: float,
) -> CameraSolution:
    free = FREE_PARAMETERS[sighting.model]
    vectors = starts.copy()
    vectors[:, free:FISHEYE_FLAG] = 0.0
    problem = Problem(
        partial(
            pinhole_residuals,
            seen=sighting.kept,
            half_diagonal=sighting.frame.half_diagonal,
            free=free,
        ),
        sighting.kept.weights,
        loss,
        prior,
        bounded=lower_bounded_parameter(vectors),
    )
    found = solve(problem, vectors, iterations=20, tolerance=tolerance)
    best = int(np.argmin(found.costs))
    only = found.chosen(np.array([best]))
    vector = found.vectors[best].copy()
    vector[POSITION_PARAMETERS] = position  # the same to the last digit in all frames
    return CameraSolution(vector, only, prior, sighting.seen, sighting.left_out)


def profile_at_position(
    sighting: FrameObservations, position: FloatArray, field: Field
) -> ReducedFrame:
    """Return what a frame says of a position, once its camera is the best one for it."""
    found = fit_at_position(sighting, position, field)
    free, vector = FREE_PARAMETERS[sighting.model], found.vector
    residuals = pinhole_residuals(vector[None], sighting.seen, sighting.frame.half_diagonal, free)
    # A radial coefficient on its bound is no parameter of the frame.
    own = np.setdiff1d(unbounded_parameters(vector, free), POSITION_PARAMETERS)
    order = np.concatenate([POSITION_PARAMETERS, own])
    ordered = replace(residuals, derivatives=residuals.derivatives[:, order])
    return reduce_frame(vector, ordered, sighting.kept.weights, found.prior, own)


def fit_result_at_position(
    found: CameraSolution, sighting: FrameObservations, field: Field, covariance: FloatArray
) -> FitResult:
    """The result of a fit at a known position, which is itself uncertain: its covariance (3, 3),
    metres squared."""
    result = fit_result_from(found, field, sighting.frame, sighting.model, False)
    if result.covariance is None or result.of_clicks is None or result.if_shared is None:
        return result
    free = FREE_PARAMETERS[sighting.model]
    own = np.setdiff1d(np.arange(free), POSITION_PARAMETERS)
    normal = found.solution.normal[0] + np.diag(found.prior.inverse_sd[0] ** 2)
    # How the camera's own parameters follow the position.
    follow = -np.linalg.solve(normal[np.ix_(own, own)], normal[np.ix_(own, POSITION_PARAMETERS)])
    by_position, kept = np.zeros((free, 3)), np.zeros((free, free))
    by_position[POSITION_PARAMETERS], by_position[own] = np.eye(3), follow
    kept[np.ix_(own, own)] = 1.0
    moved = by_position @ covariance @ by_position.T
    full, of_clicks = kept * result.covariance + moved, kept * result.of_clicks + moved
    return replace(
        result,
        covariance=full,
        of_clicks=of_clicks,
        if_shared=kept * result.if_shared + moved,
        information=np.asarray(np.linalg.inv(of_clicks)),
        deviations=pose_deviations(found.vector, full, sighting.frame),
    )
