"""What many frames have in common, found with the camera of each frame eliminated.

The cost of a set is a function of the shared parameters alone once every frame has the camera that
is best for them (variable projection). Of each frame only the gradient and the normal matrix by
the shared parameters are left, reduced by what its camera takes up (Schur complement), so that a
step costs as much as the frames one by one, however many there are.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.models import KAPPA, MIN_KAPPA, is_wide_angle
from procc_annotator.fit.solving.noise import estimate_click_sd
from procc_annotator.fit.solving.observations import FloatArray
from procc_annotator.fit.solving.residual import Residuals, residual_components
from procc_annotator.fit.solving.solver import FINAL_LOSS, GaussianPrior

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
    """Where shared parameters are expected, and between which limits they must stay: all (s,)."""

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
        error_px: standard deviation of a point across its element, solver px.
        profiles: of the frames, in their order.
    """

    values: FloatArray
    covariance: FloatArray
    error_px: float
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
        prior: on the camera.
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
        shared: s.
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
    profiler: FrameReducer, start: FloatArray, vectors: Sequence[FloatArray], prior: SharedParameterPrior
) -> SharedSolution:
    """Minimise the cost of all frames over the parameters they share.

    Args:
        profiler: shared parameters (s,) and nearly right cameras -> the frames' profiles.
        start: (s,) shared parameters to start from.
        vectors: (11,) of each frame's camera to start from.
        prior: on the shared parameters.
    """
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
    return SharedSolution(values, _shared_covariance(profiles, prior, error_px), error_px, tuple(profiles))


def _total_cost(values: FloatArray, profiles: Sequence[ReducedFrame], prior: SharedParameterPrior) -> float:
    off = (values - prior.mean) * prior.inverse_sd
    return sum(p.cost for p in profiles) + float(off @ off) / 2


def _gauss_newton_step(
    values: FloatArray, profiles: Sequence[ReducedFrame], prior: SharedParameterPrior
) -> tuple[FloatArray, FloatArray]:
    """The Gauss-Newton step, and the standard deviations it is measured by."""
    normal = _summed_normal_matrix(profiles) + np.diag(prior.inverse_sd**2)
    gradient = np.sum([p.gradient for p in profiles], axis=0)
    gradient = gradient + (values - prior.mean) * prior.inverse_sd**2
    # What lies on its limit and is pushed through it stays there.
    held = (values <= prior.lowest) & (gradient > 0) | (values >= prior.highest) & (gradient < 0)
    free = ~held
    step = np.zeros(len(values))
    if free.any():
        step[free] = -np.linalg.solve(normal[np.ix_(free, free)], gradient[free])
    return step, 1 / np.sqrt(np.diag(normal))


def _summed_normal_matrix(profiles: Sequence[ReducedFrame]) -> FloatArray:
    return np.asarray(np.sum([p.normal for p in profiles], axis=0))


def _pooled_click_sd(profiles: Sequence[ReducedFrame], shared: int) -> float:
    """As for single frames, but with the residuals of all of them."""
    every = np.concatenate([p.components for p in profiles])
    return estimate_click_sd(every, sum(p.own for p in profiles) + shared)


def _shared_covariance(profiles: Sequence[ReducedFrame], prior: SharedParameterPrior, error_px: float) -> FloatArray:
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
