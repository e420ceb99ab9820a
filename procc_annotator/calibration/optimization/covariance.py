"""Covariance of a fit, of projected points, and from per-element offsets."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.camera_parameters import POSITION_SLICE, rotated_180
from procc_annotator.calibration.optimization.observations import ImageFrame, Observations
from procc_annotator.calibration.optimization.projection import (
    MIN_DEPTH_M,
    Lens,
    project,
    project_visible,
)
from procc_annotator.calibration.optimization.residuals import (
    MAX_NOISE_RESIDUAL_PX,
    Residuals,
    estimate_click_sd,
    homography_derivatives,
    homography_residuals,
    pinhole_residuals,
    unwhitened,
)
from procc_annotator.calibration.optimization.robust_fit import CameraSolution
from procc_annotator.calibration.optimization.solver import FINAL_LOSS, ROBUST_LOSS
from procc_annotator.field.model import Field


def point_error_sd(found: CameraSolution) -> float:
    """Standard deviation of a point across its element, solver px; see `estimate_click_sd`."""
    return estimate_click_sd(found.components, found.prior.mean.shape[1])


def max_direction_sd(covariances: FloatArray) -> FloatArray:
    """(N,) standard deviations in the direction where each is largest.

    Args:
        covariances: (N, 2, 2); the square root of the larger eigenvalue is taken.
    """
    half = (covariances[:, 0, 0] + covariances[:, 1, 1]) / 2
    apart = np.hypot((covariances[:, 0, 0] - covariances[:, 1, 1]) / 2, covariances[:, 0, 1])
    return np.asarray(np.sqrt(half + apart))


def parameter_covariance(found: CameraSolution, error_px: float) -> FloatArray:
    """(n, n) covariance of the free parameters.

    The n points of an element count as the square root of n independent ones, as they do in the
    fit: what makes an element lie next to the model moves all its points.

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
    return costs[1] - costs[0] < _OPPOSITE_END_EVIDENCE * point_error_sd(found) ** 2


# What elements and points are off by where the residuals cannot say, and how many means and
# residuals that belief is worth; as bands of held-out elements ask for (docs/fitting.md).
PRIOR_OFFSET_PX, _OFFSET_PRIOR_WEIGHT = 1.0, 2.0
_PRIOR_NOISE_PX, _NOISE_PRIOR_WEIGHT = 1.0, 4.0
_MIN_NOISE_PX = 0.2
_TINY = 1e-9


@dataclass(frozen=True, eq=False)
class ElementOffsets:
    """Offsets of whole elements from residuals.

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


def estimate_element_offsets(
    found: CameraSolution, frame: ImageFrame, error_px: float
) -> ElementOffsets:
    """Return how far the elements of a fit lie next to its model.

    Args:
        found: a fit.
        frame: its picture.
        error_px: standard deviation of a point across its element, solver px.
    """
    kept = found.seen.with_excluded(found.left_out)
    off = residuals_of_fit(found, kept, frame)
    values, slopes, weights, member = _residual_rows(off, kept, found.left_out)
    pulls = (slopes * weights) @ member / error_px**2
    gain = np.linalg.inv(
        (slopes * weights) @ slopes.T + error_px**2 * np.diag(found.prior.inverse_sd[0] ** 2)
    ) @ (slopes * weights)
    clipped = np.clip(values, -MAX_NOISE_RESIDUAL_PX, MAX_NOISE_RESIDUAL_PX)
    return ElementOffsets(_offset_sd_by_moments(clipped, slopes, gain, member), pulls)


def residuals_of_fit(found: CameraSolution, seen: Observations, frame: ImageFrame) -> Residuals:
    """The residuals of one camera (B = 1), with derivatives by its free parameters."""
    if found.basis is not None:
        return homography_residuals(found.vector[None], seen, found.basis)
    free = found.prior.mean.shape[1]
    return pinhole_residuals(found.vector[None], seen, frame.half_diagonal, free)


def picture_distances(found: CameraSolution, frame: ImageFrame) -> FloatArray:
    """(N,) px of the picture as it is from each point to its element."""
    if frame.pixel_aspect == 1:
        return np.asarray(found.image_distances / frame.scale)
    off = residuals_of_fit(found, found.seen, frame)
    values = unwhitened(off.values[0], found.seen) / frame.scales[:, None]
    # Across an element it is the area that is scaled: of the residual times the direction.
    along = off.along[0] + _TINY
    shrunk = np.hypot(*(along / frame.scales[:, None])) / np.hypot(*along) * frame.scales[1]
    return np.asarray(np.where(off.whole[0], np.hypot(*values), np.abs(values[0]) / shrunk))


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
