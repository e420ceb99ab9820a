"""How far elements lie beside the model as a whole, and what that does to the camera.

What a click is off by is its own; what a line is off by that was not painted where the rules say,
that is clicked along its edge, or that a lens bends otherwise than the model does, all of its
points share. However many they are, they tell the camera no better. So a residual is taken for the
sum of two: the noise of the point, variance s^2, and the offset of its element, variance t^2.

Residuals r = (1 - J K) e are what the fit left of errors e, K = (J'WJ + s0^2 P)^-1 J'W, so that the
sums of their squares, and of the squares of their means over elements, are expected to be
s^2 a + t^2 b and s^2 c + t^2 d with known coefficients: two equations for two variances (the method
of moments; Searle, Casella and McCulloch, Variance Components, 5.2). The camera follows the
offsets by K Z, Z telling which point is of which element.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.final_fit import CameraSolution
from procc_annotator.fit.solving.noise import MAX_NOISE_RESIDUAL_PX
from procc_annotator.fit.solving.observations import FloatArray, Observations, ImageFrame
from procc_annotator.fit.solving.residual import (
    Residuals,
    homography_residuals,
    pinhole_residuals,
)
from procc_annotator.fit.solving.solver import FINAL_LOSS

# What elements and points are off by where the residuals cannot tell, and how many means and
# residuals that belief is worth; as bands of held-out elements ask for (docs/fitting.md).
PRIOR_OFFSET_PX, _OFFSET_PRIOR_WEIGHT = 1.0, 2.0
_PRIOR_NOISE_PX, _NOISE_PRIOR_WEIGHT = 1.0, 4.0
_MIN_NOISE_PX = 0.2
_TINY = 1e-9


@dataclass(frozen=True, eq=False)
class ElementOffsets:
    """What residuals say of elements as a whole.

    Attributes:
        sd_px: standard deviation of an element's offset, solver px.
        pulls: (n, G) how the offset of each element moves the gradient by the n free parameters.
    """

    sd_px: float
    pulls: FloatArray

    def covariance(self, of_clicks: FloatArray) -> FloatArray:
        """(n, n) covariance of the parameters that the offsets cause.

        Args:
            of_clicks: (n, n) covariance that the noise of the clicks causes: the inverse of the
                information.
        """
        moved = of_clicks @ self.pulls
        return np.asarray(self.sd_px**2 * moved @ moved.T)


def estimate_element_offsets(found: CameraSolution, frame: ImageFrame, error_px: float) -> ElementOffsets:
    """How far the elements of a fit lie beside its model.

    Args:
        found: a fit.
        frame: its picture.
        error_px: standard deviation of a point across its element, solver px.
    """
    kept = found.seen.with_excluded(found.left_out)
    free = found.prior.mean.shape[1]
    if found.basis is not None:
        off = homography_residuals(found.vector[None], kept, found.basis)
    else:
        off = pinhole_residuals(found.vector[None], kept, frame.half_diagonal, free)
    values, slopes, weights, member = _residual_rows(off, kept, found.left_out)
    pulls = (slopes * weights) @ member / error_px**2
    gain = np.linalg.inv(
        (slopes * weights) @ slopes.T + error_px**2 * np.diag(found.prior.inverse_sd[0] ** 2)
    ) @ (slopes * weights)
    clipped = np.clip(values, -MAX_NOISE_RESIDUAL_PX, MAX_NOISE_RESIDUAL_PX)
    return ElementOffsets(_offset_sd_by_moments(clipped, slopes, gain, member), pulls)


def _residual_rows(
    off: Residuals, seen: Observations, left_out: NDArray[np.bool_]
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """The single residuals of the elements with a say: (N,) px, (n, N) their derivatives, (N,)
    weights, and (N, G) 1 where one is across an element, which shares its offset."""
    counted = ~left_out[seen.element_of_point]
    weights = FINAL_LOSS.cost_and_weight(off.distances)[1][0] * seen.weights
    along = off.along[0]
    length = np.hypot(along[0], along[1])
    has_side = length > _TINY
    # At a true end both components count, along the picture's axes: they are turned across.
    turn = off.whole[0] & has_side
    x, y = np.where(turn, -along[1], length), np.where(turn, along[0], 0.0)
    both = np.stack([np.where(has_side, x, 1.0), np.where(has_side, y, 0.0)])
    both /= np.where(has_side, length, 1.0)
    across, beside = both, np.stack([-both[1], both[0]])
    rows = [(across, counted), (beside, counted & off.whole[0])]
    values = np.concatenate([(axes * off.values[0]).sum(axis=0)[k] for axes, k in rows])
    slopes = np.concatenate(
        [np.einsum("kn,pkn->pn", axes, off.derivatives[0])[:, k] for axes, k in rows], axis=1
    )
    member = np.zeros((len(values), len(seen.elements)))
    first = np.flatnonzero(counted)
    member[np.flatnonzero(has_side[first]), seen.element_of_point[first[has_side[first]]]] = 1.0
    member = member[:, member.any(axis=0)]
    return values, slopes, np.concatenate([weights[k] for _, k in rows]), member


def _offset_sd_by_moments(
    values: FloatArray, slopes: FloatArray, gain: FloatArray, member: FloatArray
) -> float:
    """Standard deviation of an element's offset, by the moments of N residuals of G elements.

    Args:
        values: (N,) px.
        slopes: (n, N) their derivatives.
        gain: (n, N) how the parameters follow the errors of the points.
        member: (N, G) 1 where a residual is one of an element.
    """
    counts = member.sum(axis=0)
    # Of residuals and of their means over elements: what the fit takes from both.
    sum_slopes, sum_gain = slopes @ member, gain @ member
    mean_slopes, mean_gain = sum_slopes / counts, sum_gain / counts
    across, gains = slopes @ slopes.T, gain @ gain.T
    noise_in_means = (1 / counts).sum() - 2 * (mean_slopes * mean_gain).sum()
    noise_in_means += np.einsum("pg,pq,qg->", mean_slopes, gains, mean_slopes)
    offsets_in_means = ((np.eye(len(counts)) - mean_slopes.T @ sum_gain) ** 2).sum()
    noise_in_all = len(values) - 2 * (slopes * gain).sum() + (gains * across).sum()
    offsets_in_all = len(values) - 2 * (sum_slopes * sum_gain).sum()
    offsets_in_all += ((sum_gain @ sum_gain.T) * across).sum()
    of_means = float((((values @ member) / counts) ** 2).sum())
    of_all = float((values**2).sum())
    of_means += _OFFSET_PRIOR_WEIGHT * PRIOR_OFFSET_PX**2
    offsets_in_means += _OFFSET_PRIOR_WEIGHT
    of_all += _NOISE_PRIOR_WEIGHT * _PRIOR_NOISE_PX**2
    noise_in_all += _NOISE_PRIOR_WEIGHT
    determinant = noise_in_means * offsets_in_all - offsets_in_means * noise_in_all
    noise = (of_means * offsets_in_all - offsets_in_means * of_all) / determinant
    if not noise >= _MIN_NOISE_PX**2:
        noise = _MIN_NOISE_PX**2
    offset = (of_means - noise_in_means * noise) / offsets_in_means
    return float(np.sqrt(max(offset, 0.0)))
