"""Barrel distortion: a negative radial coefficient, where the points demand one.

Lenses of a long focal length have none, and negative coefficients explain wrong labels well; so
every search keeps to those that are not negative, and only its result is doubted.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from procc_annotator.field.model import Field
from procc_annotator.fit.solving.covariance import point_error_sd
from procc_annotator.fit.solving.final_fit import CameraSolution, final_fit, outlier_elements
from procc_annotator.fit.solving.models import KAPPA
from procc_annotator.fit.solving.observations import ImageFrame
from procc_annotator.fit.solving.plausible import implausible_reason
from procc_annotator.fit.solving.residual import pinhole_residuals
from procc_annotator.fit.solving.solver import FINAL_LOSS, ROBUST_LOSS, Problem, solve
from procc_annotator.fit.solving.starts import prior_near
from procc_annotator.fit.solving.surroundings import camera_placement_prior

# Where the coefficient is looked for.
_NEGATIVE_K1_STARTS = (-0.01, -0.05)
# What it must explain, squares of the error of a point: 3 for what the prior leaves open, and 3 for
# being twenty times as likely as no distortion.
_NEGATIVE_K1_EVIDENCE = 6.0


def try_negative_k1(found: CameraSolution, field: Field, frame: ImageFrame) -> CameraSolution:
    """The same camera, or one with barrel distortion if that explains the points clearly better.

    Args:
        found: of the model R or R+.
        field: the elements.
        frame: the picture.
    """
    if found.vector[KAPPA] != 0 or _predicted_gain(found, frame) < _NEGATIVE_K1_EVIDENCE / 2:
        return found
    around, seen, free = camera_placement_prior(field), found.seen, found.prior.mean.shape[1]
    prior = prior_near(found.vector, around, free)
    residuals = partial(pinhole_residuals, half_diagonal=frame.half_diagonal, free=free)
    problem = Problem(partial(residuals, seen=seen), seen.weights, ROBUST_LOSS, prior, KAPPA)
    starts = np.tile(found.vector, (len(_NEGATIVE_K1_STARTS), 1))
    starts[:, KAPPA] = _NEGATIVE_K1_STARTS
    robust = solve(problem, starts, iterations=20, tolerance=1e-3)
    best = int(np.argmin(robust.costs))
    left_out = outlier_elements(seen, robust.distances[best])
    if left_out.sum() > found.left_out.sum():
        return found
    other = final_fit(seen, robust.vectors[[best]], left_out, residuals, prior)
    if implausible_reason(other.vector, around) or not _negative_k1_is_better(other, found):
        return found
    return other


def is_negative_k1_supported(found: CameraSolution) -> bool:
    """Whether the points still demand the barrel distortion that a camera was started with, by how
    surely its coefficient is not 0; true of a camera without."""
    if found.vector[KAPPA] >= 0:
        return True
    saved = float(found.vector[KAPPA]) ** 2 / _k1_variance(found) / 2
    return saved > _NEGATIVE_K1_EVIDENCE * point_error_sd(found) ** 2


def _negative_k1_is_better(barrel: CameraSolution, ordinary: CameraSolution) -> bool:
    saved = _negative_k1_cost(ordinary) - _negative_k1_cost(barrel)
    return barrel.vector[KAPPA] < 0 and saved > _NEGATIVE_K1_EVIDENCE * point_error_sd(barrel) ** 2


def _negative_k1_cost(found: CameraSolution) -> float:
    """What a camera costs by all the points, those of the elements it leaves out too."""
    off = (found.vector[: found.prior.mean.shape[1]] - found.prior.mean[0]) * (
        found.prior.inverse_sd[0]
    )
    losses = ROBUST_LOSS.cost_and_weight(found.distances)[0]
    return float(losses @ found.seen.weights + off @ off / 2)


def _predicted_gain(found: CameraSolution, frame: ImageFrame) -> float:
    """What a step of the coefficient below 0 promises to save, squares of the error of a point."""
    free = found.prior.mean.shape[1]
    seen = found.seen.with_excluded(found.left_out)
    at = pinhole_residuals(found.vector[None], seen, half_diagonal=frame.half_diagonal, free=free)
    weights = FINAL_LOSS.cost_and_weight(at.distances)[1][0] * seen.weights
    weighted = at.derivatives[0] * weights
    slope = float((weighted[KAPPA] * at.values[0]).sum())
    if slope <= 0:
        return 0.0
    return slope**2 * _k1_variance(found) / 2 / point_error_sd(found) ** 2


def _k1_variance(found: CameraSolution) -> float:
    """Of the coefficient, the other parameters following it, where points have an error of 1 px."""
    normal = found.solution.normal[0] + np.diag(found.prior.inverse_sd[0] ** 2)
    return float(np.linalg.inv(normal)[KAPPA, KAPPA])
