"""The final fit: which elements to believe, and the best camera for them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.model import Field
from procc_annotator.fit.solving.models import (
    FREE_PARAMETERS,
    KAPPA,
    lower_bounded_parameter,
)
from procc_annotator.fit.solving.noise import unwhitened, estimate_click_sd, whitened
from procc_annotator.fit.solving.observations import (
    FloatArray,
    Observations,
    ImageFrame,
)
from procc_annotator.fit.solving.residual import (
    Residuals,
    residual_components,
    linear_map,
    pinhole_residuals,
)
from procc_annotator.fit.solving.solver import (
    FINAL_LOSS,
    SolveRequest,
    GaussianPrior,
    Problem,
    Solution,
    SolveSteps,
    solve_request,
    run_steps,
)
from procc_annotator.fit.solving.starts import (
    prior_near,
)
from procc_annotator.fit.solving.surroundings import camera_placement_prior

# An element with a point farther off than this is taken for a mistake: no say in the final fit.
OUTLIER_PX = 15.0
MIN_ELEMENTS = 3
# A camera known before is looked for anew when the points no longer fit it.
_STALE_ELEMENT_SHARE, _STALE_PX = 1 / 3, 5.0

# Times that an uncertain spot's say is told anew from the camera that was found with it.
_WHITENING_ROUNDS = 3


@dataclass(frozen=True, eq=False)
class CameraSolution:
    """A fitted camera.

    Attributes:
        vector: (11,) parameters of a pinhole, or (8,) corrections of a homography.
        solution: of the final stage, one camera.
        prior: of the final stage.
        seen: the points it was fitted to.
        left_out: (E,) elements taken for mistakes.
        basis: (3, 3) homography that is corrected; None for a pinhole.
    """

    vector: FloatArray
    solution: Solution
    prior: GaussianPrior
    seen: Observations
    left_out: NDArray[np.bool_]
    basis: FloatArray | None = None

    @property
    def distances(self) -> FloatArray:
        """(N,) solver px from each point to its element, as they count."""
        return np.asarray(self.solution.distances[0])

    @property
    def image_distances(self) -> FloatArray:
        """The same as the picture shows them: uncertain spots in full."""
        x, y = unwhitened(self.solution.values[0], self.seen)
        return np.asarray(np.hypot(x, y))

    @property
    def components(self) -> FloatArray:
        """(M,) solver px: the numbers that the residuals of the points with a say are made of."""
        counted = ~self.left_out[self.seen.element_of_point]
        return residual_components(self.solution.values[0], self.solution.whole[0], counted)

    @property
    def is_consistent(self) -> bool:
        """Whether the elements it leaves out are those that are too far off."""
        return bool((outlier_elements(self.seen, self.distances) == self.left_out).all())

    @property
    def has_stale_start(self) -> bool:
        """Whether the points speak so much against it that another camera may explain them."""
        off = self.seen.max_per_element(self.distances) > OUTLIER_PX
        means = self.seen.mean_per_element(self.distances)
        return bool(off.mean() >= _STALE_ELEMENT_SHARE or np.median(means) > _STALE_PX)


def outlier_elements(seen: Observations, distances: FloatArray) -> NDArray[np.bool_]:
    """(E,) elements to leave out; none when too few would remain to tell who is right."""
    left_out = seen.max_per_element(distances) > OUTLIER_PX
    if len(left_out) - left_out.sum() < MIN_ELEMENTS:
        return np.zeros_like(left_out)
    return np.asarray(left_out)


def final_fit(
    seen: Observations,
    vectors: FloatArray,
    left_out: NDArray[np.bool_],
    residuals: Callable[..., Residuals],
    prior: GaussianPrior,
    basis: FloatArray | None = None,
) -> CameraSolution:
    """The best camera for the elements that are believed, from one (1, n) that is nearly right; see
    `final_fit_steps`."""
    return run_steps(final_fit_steps(seen, vectors, left_out, residuals, prior, basis))


def final_fit_steps(
    seen: Observations,
    vectors: FloatArray,
    left_out: NDArray[np.bool_],
    residuals: Callable[..., Residuals],
    prior: GaussianPrior,
    basis: FloatArray | None = None,
) -> SolveSteps[CameraSolution]:
    """The best camera for the elements that are believed, step by step.

    Args:
        seen: N points.
        vectors: (1, n) parameters to begin with, nearly right.
        left_out: (E,) elements taken for mistakes.
        residuals: (B, n) parameters, observations -> residuals.
        prior: on the free parameters.
        basis: (3, 3) homography that is corrected; None for a pinhole.

    Spots that are not known exactly are softened by the camera that comes out.
    """
    bounded = None if basis is not None else lower_bounded_parameter(vectors)
    for _ in range(_WHITENING_ROUNDS):
        final = yield final_request(seen, vectors, left_out, residuals, prior, bounded=bounded)
        found = CameraSolution(final.vectors[0], final, prior, seen, left_out, basis)
        if seen.spreads is None:
            break
        error_px = estimate_click_sd(found.components, prior.mean.shape[1])
        seen = whitened(seen, linear_map(found.vector, basis), error_px)
        vectors = final.vectors
    return found


def final_request(
    seen: Observations,
    vectors: FloatArray,
    left_out: NDArray[np.bool_],
    residuals: Callable[..., Residuals],
    prior: GaussianPrior,
    *,
    bounded: int | None = KAPPA,
    held: NDArray[np.bool_] | None = None,
    iterations: int = 20,
    tolerance: float = 1e-5,
) -> SolveRequest:
    """One descent of (B, n) parameters on the points of the elements that are believed."""
    kept = seen.with_excluded(left_out)
    look = partial(residuals, seen=kept)
    problem = Problem(look, kept.weights, FINAL_LOSS, prior, bounded=bounded, held=held)
    return SolveRequest(problem, vectors, iterations=iterations, tolerance=tolerance)


def fit_models(
    seen: Observations,
    field: Field,
    frame: ImageFrame,
    vector: FloatArray,
    left_out: NDArray[np.bool_],
    models: Sequence[str],
) -> dict[str, CameraSolution]:
    """The final fits of several pinhole models to the same elements, sharing the work.

    Args:
        seen: N points.
        field: the elements.
        frame: the picture.
        vector: (11,) parameters that are nearly right.
        left_out: (E,) elements taken for mistakes.
        models: P, R, R+ or some of them, the simplest first.

    Returns:
        By model.
    """
    around = camera_placement_prior(field)
    free = np.array([FREE_PARAMETERS[model] for model in models])
    most = int(free.max())
    fixed = np.arange(len(vector)) >= free[:, None]
    vectors = np.where(fixed, 0.0, vector)
    rows = [prior_near(row, around, most) for row in vectors]
    prior = GaussianPrior(
        np.concatenate([one.mean for one in rows]), np.concatenate([one.inverse_sd for one in rows])
    )
    residuals = partial(pinhole_residuals, half_diagonal=frame.half_diagonal, free=most)
    seen = whitened(seen, linear_map(vector))
    asked = final_request(
        seen, vectors, left_out, residuals, prior, held=fixed[:, :most], tolerance=1e-4
    )
    found = solve_request(asked)
    return {
        model: CameraSolution(
            found.vectors[row],
            found.only(row, FREE_PARAMETERS[model]),
            GaussianPrior(prior.mean[[row], : FREE_PARAMETERS[model]], prior.inverse_sd[[row], : FREE_PARAMETERS[model]]),
            seen,
            left_out,
        )
        for row, model in enumerate(models)
    }
