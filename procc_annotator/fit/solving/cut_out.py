"""Pictures cut out of larger ones: the principal point may be anywhere, even outside of them."""

from __future__ import annotations

from functools import partial

import numpy as np

from procc_annotator.field.model import Field
from procc_annotator.fit.solving.final_fit import CameraSolution, final_fit, outlier_elements
from procc_annotator.fit.solving.models import FREE_PARAMETERS, KAPPA, LOG_FOCAL, PAN, PRINCIPAL_X, TILT
from procc_annotator.fit.solving.observations import FloatArray, Observations, ImageFrame
from procc_annotator.fit.solving.plausible import implausible_reason
from procc_annotator.fit.solving.residual import pinhole_residuals
from procc_annotator.fit.solving.solver import ROBUST_LOSS, GaussianPrior, Problem, solve
from procc_annotator.fit.solving.starts import (
    CENTRE_SD,
    CROPPED_CENTRE_SD,
    camera_side,
    wide_prior,
)
from procc_annotator.fit.solving.surroundings import camera_placement_prior

_CROPPED_FREE = FREE_PARAMETERS["R+"]
# Where the principal point is looked for, px from where a whole picture has it.
_CROPPED_CENTRE_STARTS_PX = ((0.0, 0.0), (-450.0, 0.0), (450.0, 0.0), (0.0, -250.0), (0.0, 250.0))
# A whole picture's camera leaves nothing out, is off by no more, and its principal point lies near.
_GOOD_FIT_PX, _CENTRED_PX = 1.0, 2 * CENTRE_SD
# What a principal point anywhere must save, px^2: ln(300 / 25) for each of two coordinates, whose
# prior is so much wider, at an error of about 1 px.
_CROPPED_EVIDENCE = 6.0
# The same against barrel distortion, whose coefficient the points have determined as well.
_CROPPED_OVER_NEGATIVE_K1_EVIDENCE = 3.0


def try_cropped(found: CameraSolution, field: Field, frame: ImageFrame) -> CameraSolution:
    """The same camera, or one with its principal point elsewhere if that explains the points.

    Only a camera is doubted that leaves elements out, lies off the points, strains for the
    principal point, or has barrel distortion; and only one is taken instead that leaves fewer out
    and costs clearly less.

    Args:
        found: of the model R+.
        field: the elements.
        frame: the picture.
    """
    if is_cropped(found) or not _is_poor_fit(found):
        return found
    seen, around = found.seen, camera_placement_prior(field)
    side = np.array([camera_side(found.vector, around)])
    prior = wide_prior(side, around, _CROPPED_FREE, centre_sd=CROPPED_CENTRE_SD)
    residuals = partial(pinhole_residuals, half_diagonal=frame.half_diagonal, free=_CROPPED_FREE)
    problem = Problem(
        partial(residuals, seen=seen), seen.weights, ROBUST_LOSS, prior, bounded=KAPPA
    )
    robust = solve(problem, _cropped_starts(found.vector), iterations=20, tolerance=1e-3, hopeless=3.0)
    best = int(np.argmin(robust.costs))
    saved = _cropped_cost(found.vector, found.distances, found.prior, seen) - float(robust.costs[best])
    left_out = outlier_elements(seen, robust.distances[best])
    worth = _CROPPED_OVER_NEGATIVE_K1_EVIDENCE if found.vector[KAPPA] < 0 else _CROPPED_EVIDENCE
    if saved < worth or left_out.sum() > found.left_out.sum():
        return found
    other = final_fit(seen, robust.vectors[[best]], left_out, residuals, prior)
    return found if implausible_reason(other.vector, around) else other


def is_cropped(found: CameraSolution) -> bool:
    """Whether a camera of the model R+ was fitted as one of a picture cut out of a larger one."""
    return bool(found.prior.inverse_sd[0, PRINCIPAL_X] < 1 / CENTRE_SD)


def _cropped_starts(vector: FloatArray) -> FloatArray:
    """(B, 11) the camera itself, and with its principal point elsewhere, looking the same way."""
    vectors = np.tile(vector, (len(_CROPPED_CENTRE_STARTS_PX), 1))
    focal = np.exp(vector[LOG_FOCAL])
    moved = np.array(_CROPPED_CENTRE_STARTS_PX)
    vectors[:, PRINCIPAL_X:] += moved
    # Of barrel distortion and another principal point one is enough.
    vectors[:, KAPPA] = max(float(vector[KAPPA]), 0.0)
    # What appears in the middle of the picture stays there.
    vectors[:, PAN] += np.arctan2(moved[:, 0], focal)
    vectors[:, TILT] -= np.arctan2(moved[:, 1], focal)
    return vectors


def _is_poor_fit(found: CameraSolution) -> bool:
    if found.vector[KAPPA] < 0:
        return True
    if np.abs(found.vector[PRINCIPAL_X:]).max() > _CENTRED_PX or found.left_out.any():
        return True
    return float(found.distances.mean()) > _GOOD_FIT_PX


def _cropped_cost(vector: FloatArray, distances: FloatArray, prior: GaussianPrior, seen: Observations) -> float:
    off = (vector[: prior.mean.shape[1]] - prior.mean[0]) * prior.inverse_sd[0]
    return float(ROBUST_LOSS.cost_and_weight(distances)[0] @ seen.weights + off @ off / 2)
