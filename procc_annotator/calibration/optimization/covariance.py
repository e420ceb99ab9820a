"""Covariance of a fit, and of projected points."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.camera_parameters import POSITION_SLICE, rotated_180
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.projection import (
    MIN_DEPTH_M,
    Lens,
    project,
    project_visible,
)
from procc_annotator.calibration.optimization.residuals import (
    homography_derivatives,
    pinhole_residuals,
)
from procc_annotator.calibration.optimization.robust_fit import CameraSolution
from procc_annotator.calibration.optimization.solver import ROBUST_LOSS
from procc_annotator.field.model import Field


def max_direction_sd(covariances: FloatArray) -> FloatArray:
    """(N,) standard deviations in the direction where each is largest.

    Args:
        covariances: (N, 2, 2); the square root of the larger eigenvalue is taken.
    """
    half = (covariances[:, 0, 0] + covariances[:, 1, 1]) / 2
    apart = np.hypot((covariances[:, 0, 0] - covariances[:, 1, 1]) / 2, covariances[:, 0, 1])
    return np.asarray(np.sqrt(half + apart))


def parameter_covariance(found: CameraSolution) -> FloatArray:
    """(n, n) covariance of the free parameters: how the estimate follows the points' noise, each
    point's own and what an element's points share, and the prior (the sandwich estimator)."""
    noise, precision = found.noise, np.diag(found.prior.inverse_sd[0] ** 2)
    inverse = np.linalg.inv(found.solution.normal[0] + found.error_px**2 * precision)
    scatter = noise.scatter + found.error_px**4 * precision
    covariance = inverse @ scatter @ inverse
    return np.asarray((covariance + covariance.T) / 2)


def projected_covariance(
    vector: FloatArray,
    basis: FloatArray | None,
    half_diagonal: float,
    covariance: FloatArray,
    points_world: FloatArray,
) -> FloatArray:
    """Covariance of the places where field points appear.

    Args:
        vector: (11,) pinhole parameters, or (8,) corrections of a homography.
        basis: (3, 3) homography that is corrected; None for a pinhole.
        half_diagonal: half the picture's diagonal, solver px.
        covariance: (n, n) of the free parameters.
        points_world: (N, 3) metres.

    Returns:
        (N, 2, 2) solver px squared; NaN for points that the camera does not show, or off the
        ground for a homography.
    """
    derivatives, shown = projected_jacobian(
        vector, basis, half_diagonal, len(covariance), points_world
    )
    found = derivatives @ covariance @ derivatives.transpose(0, 2, 1)
    return np.where(shown[:, None, None], found, np.nan)


def projected_jacobian(
    vector: FloatArray,
    basis: FloatArray | None,
    half_diagonal: float,
    free: int,
    points_world: FloatArray,
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Return how the places where field points appear change with the free parameters.

    Args:
        vector, basis, half_diagonal: see `projected_covariance`.
        free: n, the number of free parameters.
        points_world: (N, 3) metres.

    Returns:
        (N, 2, n) solver px; (N,) whether the camera shows the point, the others' are meaningless.
    """
    world = np.ascontiguousarray(points_world.T)[None]
    if basis is not None:
        derivatives, depth = homography_derivatives(vector[None], basis, world)
        shown = (depth[0] > MIN_DEPTH_M) & (world[0, 2] == 0)
    else:
        lens = Lens.of(vector[None], half_diagonal)
        shown = project_visible(lens, world[0])[1][0]
        safe = np.where(shown, world, (lens.rotation[:, 2] + vector[POSITION_SLICE])[:, :, None])
        _, _, derivatives = project(lens, safe, np.zeros_like(safe), free)
    return derivatives[0].transpose(2, 1, 0), shown


# On a field that is the same after half a turn, labels go by where the main camera stands. On one
# that is not, such as a running track with its finish line, much of what a picture shows may be the
# same all the same: lanes are, their marks are not. No standard deviation shows that.
# What the end must explain to be known, squares of the error of a point: twenty times as likely.
_OPPOSITE_END_EVIDENCE = 3.0


def is_opposite_end_possible(found: CameraSolution, field: Field, frame: ImageFrame) -> bool:
    """Return whether the points leave open from which end of the field a camera sees it.

    Args:
        found: a fit.
        field: the elements; of one with symmetries the labels say, and the answer is no.
        frame: the picture.
    """
    if found.basis is not None or field.symmetries:
        return False
    here = found.solution.distances[0]
    vectors = rotated_180(found.vector[None])
    free = found.prior.mean.shape[1]
    there = pinhole_residuals(vectors, found.seen, half_diagonal=frame.half_diagonal, free=free)
    costs = [
        float(ROBUST_LOSS.cost_and_weight(distances)[0] @ found.seen.weights)
        for distances in (here, np.asarray(there.distances[0]))
    ]
    return costs[1] - costs[0] < _OPPOSITE_END_EVIDENCE * found.noise.click_px**2
