"""How well a fit knows its camera, and where it would show a field point."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.feet import NEAREST_M
from procc_annotator.fit.solving.jacobian import Lens, Shown
from procc_annotator.fit.solving.noise import error_from
from procc_annotator.fit.solving.observations import FloatArray
from procc_annotator.fit.solving.residual import homography_derivatives
from procc_annotator.fit.solving.search import Found


def error_of_points(found: Found) -> float:
    """Standard deviation of a point across its element, solver px; see `error_from`."""
    return error_from(found.components, found.prior.mean.shape[1])


def worst_sd(covariances: FloatArray) -> FloatArray:
    """(N,) standard deviations in the direction where each is largest.

    Args:
        covariances: (N, 2, 2); the square root of the larger eigenvalue is taken.
    """
    half = (covariances[:, 0, 0] + covariances[:, 1, 1]) / 2
    apart = np.hypot((covariances[:, 0, 0] - covariances[:, 1, 1]) / 2, covariances[:, 0, 1])
    return np.asarray(np.sqrt(half + apart))


def covariance_of(found: Found, error_px: float) -> FloatArray:
    """(n, n) covariance of the free parameters.

    The n points of an element count as the square root of n independent ones, as they do in the
    fit: what makes an element lie beside the model moves all its points.

    Args:
        found: a fit.
        error_px: standard deviation of a point across its element, solver px.
    """
    information = found.solution.normal[0] / error_px**2
    information = information + np.diag(found.prior.inverse_sd[0] ** 2)
    covariance = np.linalg.inv(information)
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
    derivatives, shown = projected_derivatives(
        vector, basis, half_diagonal, len(covariance), points_world
    )
    found = derivatives @ covariance @ derivatives.transpose(0, 2, 1)
    return np.where(shown[:, None, None], found, np.nan)


def projected_derivatives(
    vector: FloatArray,
    basis: FloatArray | None,
    half_diagonal: float,
    free: int,
    points_world: FloatArray,
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """How the places where field points appear change with the free parameters.

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
        shown = (depth[0] > NEAREST_M) & (world[0, 2] == 0)
    else:
        lens = Lens.of(vector[None], half_diagonal)
        shown = (lens.linear[:, 2, :3] @ world[0] + lens.linear[:, 2, 3:])[0] > NEAREST_M
        beyond = lens.beyond_fold(world)
        if beyond is not None:
            shown &= ~beyond[0]
        safe = np.where(shown, world, (lens.rotation[:, 2] + vector[3:6])[:, :, None])
        both = np.broadcast_to(np.eye(2)[:, :, None], (1, 2, 2, world.shape[2]))
        derivatives = Shown.by(lens, safe).slopes(both, free)
    return derivatives[0].transpose(2, 1, 0), shown
