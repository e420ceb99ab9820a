"""Noise of a fit's points, its covariance, and that of projected points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.camera_parameters import POSITION_SLICE, rotated_180
from procc_annotator.calibration.optimization.noise import posterior_deviations
from procc_annotator.calibration.optimization.observations import ImageFrame, Observations
from procc_annotator.calibration.optimization.projection import (
    MIN_DEPTH_M,
    Lens,
    project,
    project_visible,
)
from procc_annotator.calibration.optimization.residuals import (
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
    """(N,) standard deviations in the direction where each of N covariances (2, 2) is largest."""
    half = (covariances[:, 0, 0] + covariances[:, 1, 1]) / 2
    apart = np.hypot((covariances[:, 0, 0] - covariances[:, 1, 1]) / 2, covariances[:, 0, 1])
    return np.asarray(np.sqrt(half + apart))


def parameter_information(found: CameraSolution, error_px: float) -> FloatArray:
    """(n, n) information of points and prior on the free parameters; ``error_px`` is the standard
    deviation of a point across its element, solver px.

    The n points of an element count as the square root of n independent ones, as they do in the
    fit: what makes an element lie next to the model moves all its points.
    """
    return np.asarray(
        found.solution.normal[0] / error_px**2 + np.diag(found.prior.inverse_sd[0] ** 2)
    )


def parameter_covariance(found: CameraSolution, error_px: float) -> FloatArray:
    """(n, n) inverse of the information of points and prior."""
    covariance = np.linalg.inv(parameter_information(found, error_px))
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
    """Return how the places where N field points appear change with the n free parameters: (N, 2,
    n) solver px; and (N,) whether the camera shows each point, others' values are meaningless.
    Arguments as of `projected_covariance`."""
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
    """Return whether the points leave open from which end of the field a camera sees it. Of a
    field with symmetries the labels say, and the answer is no."""
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


# Usual standard deviations of what all points of an element share: its place on the ground along x
# and y, in widths of the lines, on which clicks are anywhere, and its distance across from the
# model, solver px (lens errors).
PRIOR_OFFSET_WIDTHS, PRIOR_OFFSET_PX = 0.6, 0.5
_LINE_WIDTH_M = 0.12  # where the field says none
_MIN_ROBUST_SD_PX, _MIN_SPARE_ROWS, _HUBER_SD = 0.3, 4, 2.0
DISPLACEMENT_M = 0.01  # for derivatives by differences
_TINY = 1e-12


@dataclass(frozen=True, eq=False)
class PointNoise:
    """Noise of a frame's points, and what it makes of the camera.

    Attributes:
        click_px: standard deviation of a point across its element, solver px.
        offset_px: of what all points of an element share, across, solver px; mean over the points.
        shared_if_any: of the same on the ground, m, and across, solver px, if elements share errors
            at all: drawn ones do not, annotated ones do.
        of_clicks: (n, n) covariance of the free parameters by clicks and prior.
        of_all: (n, n) by clicks, prior and what elements share.
        if_shared: (n, n) the same if elements share errors at all.
    """

    click_px: float
    offset_px: float
    shared_if_any: tuple[float, float]
    of_clicks: FloatArray
    of_all: FloatArray
    if_shared: FloatArray


def estimate_noise(found: CameraSolution, frame: ImageFrame) -> PointNoise:
    """Estimate a frame's noise from the residuals, and how the camera follows it.

    Both variances have the means of their posterior: the marginal likelihood of the residuals, the
    camera integrated out (Laplace's approximation, as in restricted maximum likelihood). Points far
    off count less (Huber), at a scale from the median of the residuals.
    """
    seen, free = found.seen.with_excluded(found.left_out), found.prior.mean.shape[1]
    off, displacements = _residuals_and_displacements(found, seen, frame)
    distances, counted = off.distances[0], seen.weights > 0
    rows = np.stack([counted, counted & off.whole[0]])
    count = int(rows.sum())
    typical = 1.4826 * float(np.median(distances[counted]))
    typical *= np.sqrt(count / max(count - free, _MIN_SPARE_ROWS))
    huber = _HUBER_SD * max(typical, _MIN_ROBUST_SD_PX)
    roots = rows * np.sqrt(np.minimum(1.0, huber / np.maximum(distances, _TINY)))
    widths = [element.line_width for element in seen.elements if element.line_width > 0]
    prior_m = PRIOR_OFFSET_WIDTHS * float(np.median(widths or [_LINE_WIDTH_M]))
    effects = _shared_effects(off, prior_m * displacements)
    axes, squares = _orthonormal(effects * roots, seen)
    values = (off.values[0] * roots).reshape(-1)
    slopes = (off.derivatives[0] * roots).reshape(free, -1)
    mean, precision = found.prior.mean[0] - found.vector[:free], found.prior.inverse_sd[0] ** 2
    click_px, shared, shared_if_any = posterior_deviations(
        values, slopes, axes, squares, mean, precision
    )
    # The estimate's own covariance (sandwich): the fit weighed the points as it did, and the prior
    # as if they were off by 1 px.
    weights = rows * (FINAL_LOSS.cost_and_weight(distances)[1] * seen.weights)
    inverse = np.linalg.inv(found.solution.normal[0] + np.diag(precision))
    gain = inverse @ (off.derivatives[0] * weights).reshape(free, -1)
    by_element = np.add.reduceat(
        np.einsum("prn,irn->pin", gain.reshape(free, 2, -1), effects), seen.starts, axis=2
    ).reshape(free, -1)
    # What the prior pulls the camera by: as it does here, the camera being as uncertain as it is.
    pulled = inverse * precision
    bias = pulled @ mean
    by_prior = np.outer(bias, bias) + pulled @ parameter_covariance(found, click_px) @ pulled.T
    of_clicks = click_px**2 * gain @ gain.T + by_prior
    of_shared = by_element @ by_element.T
    return PointNoise(
        click_px,
        shared * float(np.sqrt((effects[:, rows] ** 2).sum(axis=0)).mean()),
        (shared_if_any * prior_m, shared_if_any * PRIOR_OFFSET_PX),
        of_clicks,
        of_clicks + shared**2 * of_shared,
        of_clicks + shared_if_any**2 * of_shared,
    )


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


def _residuals_and_displacements(
    found: CameraSolution, seen: Observations, frame: ImageFrame
) -> tuple[Residuals, FloatArray]:
    """Residuals, and (2, 2, N) their derivatives by moves of the elements along x and y, px/m."""
    off, moved = residuals_of_fit(found, seen, frame), []
    if found.basis is None:
        # An element that moves is a camera that moves the other way.
        return off, off.derivatives[0, POSITION_SLICE][:2]
    for axis in range(2):
        shift = np.eye(3)
        shift[axis, 2] = DISPLACEMENT_M
        there = homography_residuals(found.vector[None], seen, found.basis @ shift)
        moved.append((there.values[0] - off.values[0]) / DISPLACEMENT_M)
    return off, np.array(moved)


def _shared_effects(found: Residuals, displacements: FloatArray) -> FloatArray:
    """(3, 2, N) what an element's own errors along x, y, m, and across, px, add to its points."""
    along = found.along[0]
    length = np.hypot(along[0], along[1])
    has_side = length > _TINY
    # At a true end both components count, along the picture's axes.
    turned = found.whole[0] & has_side
    unit = np.where(has_side, length, 1.0)
    across = np.stack(
        [np.where(turned, -along[1] / unit, has_side), np.where(turned, along[0] / unit, 0.0)]
    )
    return np.concatenate([displacements, PRIOR_OFFSET_PX * across[None]])


def _orthonormal(effects: FloatArray, seen: Observations) -> tuple[FloatArray, FloatArray]:
    """Effects (3, 2, N) as orthonormal axes of the elements (2 N, 3 E), and squares (3 E,)."""
    products = np.einsum("irn,jrn->ijn", effects, effects)
    gram = np.add.reduceat(products, seen.starts, axis=2).transpose(2, 0, 1)
    squares, turns = np.linalg.eigh(gram)
    squares = np.where(squares > 1e-9 * (squares[:, -1:] + _TINY), squares, 0.0)
    turns = turns / np.sqrt(np.where(squares > 0, squares, np.inf))[:, None]
    points, elements = seen.points.shape[1], len(seen.elements)
    axes = np.zeros((2, points, elements, 3))
    own = np.einsum("irn,nia->rna", effects, turns[seen.element_of_point])
    axes[:, np.arange(points), seen.element_of_point] = own
    return axes.reshape(2 * points, -1), squares.reshape(-1)
