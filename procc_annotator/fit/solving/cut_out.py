"""Pictures cut out of larger ones: the principal point may be anywhere, even outside of them."""

from __future__ import annotations

from functools import partial

import numpy as np

from procc_annotator.field.model import Field
from procc_annotator.fit.solving.final_fit import FoundCamera, final_fit, mistakes
from procc_annotator.fit.solving.models import FREE, KAPPA, LOG_FOCAL, PAN, PRINCIPAL_X, TILT
from procc_annotator.fit.solving.observations import FloatArray, Observations, PictureFrame
from procc_annotator.fit.solving.plausible import objection
from procc_annotator.fit.solving.residual import pinhole_residuals
from procc_annotator.fit.solving.solver import ROBUST_LOSS, Prior, Problem, solve
from procc_annotator.fit.solving.starts import (
    CENTRE_SD,
    CUT_OUT_SD,
    side_of,
    wide_prior,
)
from procc_annotator.fit.solving.surroundings import surroundings_of

_FREE = FREE["R+"]
# Where the principal point is looked for, px from where a whole picture has it.
_CENTRES = ((0.0, 0.0), (-450.0, 0.0), (450.0, 0.0), (0.0, -250.0), (0.0, 250.0))
# A whole picture's camera leaves nothing out, is off by no more, and its principal point lies near.
_GOOD_PX, _NEAR_PX = 1.0, 2 * CENTRE_SD
# What a principal point anywhere must save, px^2: ln(300 / 25) for each of two coordinates, whose
# prior is so much wider, at an error of about 1 px.
_WORTH = 6.0
# The same against barrel distortion, whose coefficient the points have determined as well.
_WORTH_MORE_THAN_BARREL = 3.0


def perhaps_cut_out(found: FoundCamera, field: Field, frame: PictureFrame) -> FoundCamera:
    """The same camera, or one with its principal point elsewhere if that explains the points.

    Only a camera is doubted that leaves elements out, lies off the points, strains for the
    principal point, or has barrel distortion; and only one is taken instead that leaves fewer out
    and costs clearly less.

    Args:
        found: of the model R+.
        field: the elements.
        frame: the picture.
    """
    if is_cut_out(found) or not _is_strained(found):
        return found
    seen, around = found.seen, surroundings_of(field)
    side = np.array([side_of(found.vector, around)])
    prior = wide_prior(side, around, _FREE, centre_sd=CUT_OUT_SD)
    residuals = partial(pinhole_residuals, half_diagonal=frame.half_diagonal, free=_FREE)
    problem = Problem(
        partial(residuals, seen=seen), seen.weights, ROBUST_LOSS, prior, bounded=KAPPA
    )
    robust = solve(problem, _starts(found.vector), iterations=20, tolerance=1e-3, hopeless=3.0)
    best = int(np.argmin(robust.costs))
    saved = _cost(found.vector, found.distances, found.prior, seen) - float(robust.costs[best])
    left_out = mistakes(seen, robust.distances[best])
    worth = _WORTH_MORE_THAN_BARREL if found.vector[KAPPA] < 0 else _WORTH
    if saved < worth or left_out.sum() > found.left_out.sum():
        return found
    other = final_fit(seen, robust.vectors[[best]], left_out, residuals, prior)
    return found if objection(other.vector, around) else other


def is_cut_out(found: FoundCamera) -> bool:
    """Whether a camera of the model R+ was fitted as one of a picture cut out of a larger one."""
    return bool(found.prior.inverse_sd[0, PRINCIPAL_X] < 1 / CENTRE_SD)


def _starts(vector: FloatArray) -> FloatArray:
    """(B, 11) the camera itself, and with its principal point elsewhere, looking the same way."""
    vectors = np.tile(vector, (len(_CENTRES), 1))
    focal = np.exp(vector[LOG_FOCAL])
    moved = np.array(_CENTRES)
    vectors[:, PRINCIPAL_X:] += moved
    # Of barrel distortion and another principal point one is enough.
    vectors[:, KAPPA] = max(float(vector[KAPPA]), 0.0)
    # What appears in the middle of the picture stays there.
    vectors[:, PAN] += np.arctan2(moved[:, 0], focal)
    vectors[:, TILT] -= np.arctan2(moved[:, 1], focal)
    return vectors


def _is_strained(found: FoundCamera) -> bool:
    if found.vector[KAPPA] < 0:
        return True
    if np.abs(found.vector[PRINCIPAL_X:]).max() > _NEAR_PX or found.left_out.any():
        return True
    return float(found.distances.mean()) > _GOOD_PX


def _cost(vector: FloatArray, distances: FloatArray, prior: Prior, seen: Observations) -> float:
    off = (vector[: prior.mean.shape[1]] - prior.mean[0]) * prior.inverse_sd[0]
    return float(ROBUST_LOSS.cost_and_weight(distances)[0] @ seen.weights + off @ off / 2)
