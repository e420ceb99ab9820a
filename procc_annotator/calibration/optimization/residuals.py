"""Residuals of annotated points with derivatives, and the click-noise model."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.camera_parameters import POSITION_SLICE
from procc_annotator.calibration.optimization.closest_points import (
    BatchedObservations,
    ClosestPoints,
    find_closest_points,
)
from procc_annotator.calibration.optimization.observations import Observations
from procc_annotator.calibration.optimization.projection import MIN_DEPTH_M, Lens, project

# What a point counts whose element is behind the camera, solver px; no direction is better.
HIDDEN_RESIDUAL_PX = 1000.0
_TINY = 1e-12


@dataclass(frozen=True, eq=False)
class Residuals:
    """Residuals of N points for B cameras, with derivatives by n parameters.

    Attributes:
        values: (B, 2, N) solver px; the second row is 0 but at true ends.
        derivatives: (B, n, 2, N).
        distances: (B, N) solver px, length of each point's residual.
        whole: (B, N) whether both rows count, as of a spot; else the first one alone.
        along: (B, 2, N) the element's direction in the picture, of any length; 0 for a spot.
    """

    values: FloatArray
    derivatives: FloatArray
    distances: FloatArray
    whole: NDArray[np.bool_]
    along: FloatArray


def residual_components(
    values: FloatArray, whole: NDArray[np.bool_], counted: NDArray[np.bool_]
) -> FloatArray:
    """The single numbers (M,), solver px, that the ``counted`` (N,) ones of N residuals are made
    of, one or two each; values (2, N) and whole (N,) are those of one camera's `Residuals`."""
    return np.concatenate([values[0, counted], values[1, counted & whole]])


def pinhole_residuals(
    vectors: FloatArray,
    seen: Observations | BatchedObservations,
    half_diagonal: float,
    free: int,
    *,
    thorough: bool = True,
) -> Residuals:
    """Residuals of pinhole cameras with one radial coefficient.

    Args:
        vectors: (B, 11) parameters, see `models`.
        seen: N points, or those of several frames, each camera of one of them.
        half_diagonal: half the picture's diagonal, solver px.
        free: derivatives by the first so many parameters.
    """
    lens = Lens.of(vectors, half_diagonal)
    bent = seen.shared(lens.bend[:, 0] != 0) if isinstance(seen, BatchedObservations) else None
    undistorted = lens.undistorted(seen.points, bent)
    feet = with_folded_hidden(
        find_closest_points(lens.linear, undistorted, seen, thorough=thorough), lens
    )
    world = feet.world
    if feet.hidden.any():
        # Anything in front of the camera will do: its residual is replaced.
        ahead = (lens.rotation[:, 2] + vectors[:, POSITION_SLICE])[:, :, None]
        world = np.where(feet.hidden[:, None], ahead, world)
    pixels, moved, derivatives = project(lens, world, feet.along, free)
    return project_out_tangent(seen, pixels, moved, derivatives, feet)


def linear_map(vector: FloatArray, basis: FloatArray | None = None) -> FloatArray:
    """(3, 4) world -> undistorted pixels times depth of pinhole parameters (11,), or of
    corrections (8,) of the homography ``basis`` (3, 3)."""
    if basis is None:
        return np.asarray(Lens.of(vector[None], 1.0).linear[0])
    return np.asarray(_ground_linear_maps(homographies_from_corrections(vector[None], basis))[0])


def _ground_linear_maps(matrices: FloatArray) -> FloatArray:
    """(B, 3, 3) ground -> pixels, as linear maps (B, 3, 4) for which height does not matter."""
    linear = np.zeros((len(matrices), 3, 4))
    linear[:, :, :2], linear[:, :, 3] = matrices[:, :, :2], matrices[:, :, 2]
    return linear


def with_folded_hidden(feet: ClosestPoints, lens: Lens) -> ClosestPoints:
    """Feet of which those are hidden too that barrel distortion would fold back: no camera shows
    anything there."""
    beyond = lens.is_beyond_fold(feet.world)
    return feet if beyond is None else replace(feet, hidden=feet.hidden | beyond)


def homography_residuals(vectors: FloatArray, seen: Observations, basis: FloatArray) -> Residuals:
    """Residuals of B homographies, given as corrections (B, 8) of a known one (3, 3), ground ->
    solver px, see `homographies_from_corrections`; all points are on the ground."""
    linear = _ground_linear_maps(homographies_from_corrections(vectors, basis))
    points = np.broadcast_to(seen.points, (len(vectors), *seen.points.shape))
    feet = find_closest_points(linear, points, seen)
    corrected = linear[:, :, :3] @ feet.world + linear[:, :, 3:]
    depth = np.where(feet.hidden, 1.0, corrected[:, 2])[:, None]
    pixels = corrected[:, :2] / depth
    toward = linear[:, :, :3] @ feet.along
    moved = (toward[:, :2] - pixels * toward[:, 2:]) / depth
    derivatives = _correction_derivatives(basis, feet.world, pixels, depth[:, 0])
    return project_out_tangent(seen, pixels, moved, derivatives, feet)


def homography_derivatives(
    vectors: FloatArray, basis: FloatArray, world: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Derivatives (B, 8, 2, N) of the pixels of ground points (B, 3, N), metres, by the corrections
    (B, 8) of a homography (3, 3), ground -> solver px; and depths (B, N) in about metres."""
    corrected = homographies_from_corrections(vectors, basis) @ _homogeneous_ground(world)
    depth = np.where(np.abs(corrected[:, 2]) > _TINY, corrected[:, 2], _TINY)
    return _correction_derivatives(basis, world, corrected[:, :2] / depth[:, None], depth), depth


def _correction_derivatives(
    basis: FloatArray, world: FloatArray, pixels: FloatArray, depth: FloatArray
) -> FloatArray:
    # Before the correction.
    plain = _NORMALISATION @ (basis @ _homogeneous_ground(world)) / depth[:, None]
    found = np.zeros((len(world), 9, 2, world.shape[2]))
    for column in range(3):
        found[:, column, 0] = found[:, 3 + column, 1] = plain[:, column] * _NORMAL_PX
        found[:, 6 + column] = -pixels * plain[:, column, None]
    return found[:, :8]


# The solver's pixels made of the size of 1.
_NORMAL_PX = 500.0
_NORMALISATION = np.diag([1 / _NORMAL_PX, 1 / _NORMAL_PX, 1.0])


def homographies_from_corrections(vectors: FloatArray, basis: FloatArray) -> FloatArray:
    """(B, 8) corrections of a homography -> (B, 3, 3) ground -> solver px.

    The correction is 1 plus a matrix whose last entry is 0, in units of 500 px; so eight small
    numbers of one size reach every homography nearby.
    """
    correction = np.zeros((len(vectors), 9))
    correction[:, :8] = vectors
    turned = correction.reshape(-1, 3, 3) + np.eye(3)
    return np.asarray(np.linalg.inv(_NORMALISATION) @ turned @ (_NORMALISATION @ basis))


def _homogeneous_ground(world: FloatArray) -> FloatArray:
    """(B, 3, N) world points -> (B, 3, N) homogeneous ground points."""
    homogeneous = world.copy()
    homogeneous[:, 2] = 1.0
    return homogeneous


def project_out_tangent(
    seen: Observations | BatchedObservations,
    pixels: FloatArray,
    moved: FloatArray,
    derivatives: FloatArray,
    feet: ClosestPoints,
) -> Residuals:
    """The differences to the feet, their part along the curve taken out except at true ends; those
    to spots as much as these are known."""
    apart = seen.points - pixels
    length = np.hypot(moved[:, 0], moved[:, 1])
    length += _TINY
    # Across the curve; at an end: the difference itself, both components.
    one_x = np.where(feet.at_end, 1.0, -moved[:, 1] / length)
    one_y = np.where(feet.at_end, 0.0, moved[:, 0] / length)
    hidden, other = feet.hidden, feet.at_end
    some_hidden = hidden.any()
    if some_hidden:
        one_x[hidden] = one_y[hidden] = 0.0
        other = other & ~hidden
    values = np.empty_like(apart)
    first, found = values[:, 0], np.empty_like(derivatives)
    np.multiply(one_x, apart[:, 0], out=first)
    first += one_y * apart[:, 1]
    np.multiply(other, apart[:, 1], out=values[:, 1])
    across = found[:, :, 0]
    np.multiply(-one_x[:, None], derivatives[:, :, 0], out=across)
    across -= one_y[:, None] * derivatives[:, :, 1]
    np.multiply(derivatives[:, :, 1], np.where(other, -1.0, -0.0)[:, None], out=found[:, :, 1])
    if seen.soft is not None:
        # Of what is not whole the second row is 0, and nothing but whole residuals is softened.
        soft = np.where(other[:, None, None], seen.soft, np.eye(2)[:, :, None])
        values = np.einsum("bijn,bjn->bin", soft, values)
        found = np.einsum("bijn,bpjn->bpin", soft, found)
    if some_hidden:
        values[:, 0][hidden] = HIDDEN_RESIDUAL_PX
    distances = np.hypot(values[:, 0], values[:, 1])
    return Residuals(values, found, distances, other, moved)


# What a click is off by where the points cannot say, and how many residuals that belief is worth.
PRIOR_CLICK_SD_PX = 1.5
_CLICK_SD_PRIOR_WEIGHT = 10.0
# More is a mistake, and says nothing of what clicks are usually off.
MAX_NOISE_RESIDUAL_PX = 3 * PRIOR_CLICK_SD_PX


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
    return float(
        np.sqrt(
            (_CLICK_SD_PRIOR_WEIGHT * PRIOR_CLICK_SD_PX**2 + squares)
            / (_CLICK_SD_PRIOR_WEIGHT + spare)
        )
    )


def whitened(
    seen: Observations, linear: FloatArray, error_px: float = PRIOR_CLICK_SD_PX
) -> Observations:
    """The same points, those on uncertain spots counting as much as these are known; as they are
    where none is on such a spot.

    Args:
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


def projected_spot_covariance(
    spots: FloatArray, spreads: FloatArray, linear: FloatArray
) -> FloatArray:
    """Return what uncertain places are off in the picture, to first order.

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
