"""What clicks are off by, and what spots are off by whose own place is uncertain.

The residual of a spot whose place has the covariance C has the covariance s^2 I + J C J': s is
what a click is off by, J how the picture of the spot moves with it. Multiplied by
s (s^2 I + J C J')^-1/2 it is as large as that of any other click (whitening; Hartley and Zisserman,
Multiple View Geometry, 5.2), and counts as much. J goes by a camera that is nearly right, not by
the one that is tried: else a camera for which all is uncertain would explain everything.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from procc_annotator.fit.solving.feet import MIN_DEPTH_M
from procc_annotator.fit.solving.observations import FloatArray, Observations

# What a click is off by where the points cannot tell, and how many residuals that belief is worth.
PRIOR_CLICK_SD_PX = 1.5
_CLICK_SD_PRIOR_WEIGHT = 10.0
MAX_NOISE_RESIDUAL_PX = 3 * PRIOR_CLICK_SD_PX  # more is a mistake, and says nothing of what clicks are usually off


def estimate_click_sd(components: FloatArray, parameters: int) -> float:
    """Standard deviation of a point across its element, and of a spot along each axis, solver px.

    The residuals' own, drawn towards 1.5 px where there are few of them: a fit to three elements
    has hardly any residual left, whatever its points are worth.

    Args:
        components: (M,) solver px, of the points that have a say: one of a point across its
            element, two of a spot and of a true end.
        parameters: how many were fitted to them.
    """
    squares = float((np.clip(components, -MAX_NOISE_RESIDUAL_PX, MAX_NOISE_RESIDUAL_PX) ** 2).sum())
    spare = max(len(components) - parameters, 0)
    return float(np.sqrt((_CLICK_SD_PRIOR_WEIGHT * PRIOR_CLICK_SD_PX**2 + squares) / (_CLICK_SD_PRIOR_WEIGHT + spare)))


def whitened(
    seen: Observations, linear: FloatArray, error_px: float = PRIOR_CLICK_SD_PX
) -> Observations:
    """The same points, those on uncertain spots counting as much as these are known.

    Args:
        seen: N points; as they are where none is on such a spot.
        linear: (3, 4) of a camera that is nearly right: world -> undistorted pixels times depth.
        error_px: what a click is off by, solver px.
    """
    if seen.spreads is None:
        return seen
    uncertain = np.flatnonzero(seen.spreads.any(axis=(1, 2)))
    elements = seen.element_of_point[uncertain]
    spots = seen.parts.spots[:, elements - seen.first_spot]
    values, axes = np.linalg.eigh(projected_spot_covariance(spots, seen.spreads[uncertain], linear))
    shares = error_px / np.sqrt(error_px**2 + np.maximum(values, 0.0))
    soft = np.tile(np.eye(2)[:, :, None], seen.points.shape[1])
    soft[:, :, uncertain] = np.einsum("kia,ka,kja->ijk", axes, shares, axes)
    return replace(seen, soft=soft)


def projected_spot_covariance(spots: FloatArray, spreads: FloatArray, linear: FloatArray) -> FloatArray:
    """What uncertain places are off in the picture, to first order.

    Args:
        spots: (3, K) metres, world frame.
        spreads: (K, 3, 3) m^2, covariances of the places.
        linear: (3, 4) world -> undistorted pixels times depth.

    Returns:
        (K, 2, 2) solver px squared; 0 for places behind the camera.
    """
    place = linear[:, :3] @ spots + linear[:, 3:]
    ahead = place[2] >= MIN_DEPTH_M
    depth = np.where(ahead, place[2], 1.0)
    shown = (place[:2] / depth).T
    slopes = (linear[:2, :3] - shown[:, :, None] * linear[2, :3]) / depth[:, None, None]
    spread = slopes @ spreads @ slopes.transpose(0, 2, 1)
    return np.asarray(np.where(ahead[:, None, None], spread, 0.0))


def unwhitened(values: FloatArray, seen: Observations) -> FloatArray:
    """(2, N) solver px: residuals as the picture shows them, of those of softened points."""
    if seen.soft is None:
        return values
    shown = np.linalg.solve(seen.soft.transpose(2, 0, 1), values.T[:, :, None])
    return np.asarray(shown[:, :, 0].T)
