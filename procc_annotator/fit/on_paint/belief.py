"""What is believed of a camera: a mean and how surely it is known, to be made surer by marks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.field.model import Field
from procc_annotator.fit.on_paint.marks import PARAMETERS_FREE, EdgePoints, edge_point_errors
from procc_annotator.fit.solving.models import KAPPA, MIN_KAPPA
from procc_annotator.fit.solving.observations import FloatArray
from procc_annotator.fit.solving.starts import prior_near
from procc_annotator.fit.solving.surroundings import camera_placement_prior

_ITERATIONS = 8
_CONVERGED_PX = 0.05
_MAX_KAPPA = 0.6
# Farther off, a mark is less and less likely to be of the paint it was taken for.
MIN_SCALE_PX = 1.5
MIN_WEIGHT = 0.25  # weight from which on it is


@dataclass(frozen=True, eq=False)
class GaussianState:
    """A camera, and how surely it is known.

    Attributes:
        vector: (11,) parameters.
        information: (8, 8) inverse covariance of the free ones; 0 of what nobody knows.
    """

    vector: FloatArray
    information: FloatArray

    @property
    def covariance(self) -> FloatArray:
        """(8, 8)."""
        found = np.linalg.inv(self.information)
        return np.asarray((found + found.T) / 2)


def default_state(vector: FloatArray, field: Field) -> GaussianState:
    """What is known of any camera around a field that is on the side of another one (11,)."""
    prior = prior_near(vector, camera_placement_prior(field), PARAMETERS_FREE)
    mean = vector.copy()
    mean[:PARAMETERS_FREE] = np.where(
        prior.inverse_sd[0] > 0, prior.mean[0], vector[:PARAMETERS_FREE]
    )
    return GaussianState(mean, np.diag(prior.inverse_sd[0] ** 2))


@dataclass(frozen=True, eq=False)
class StateUpdate:
    """The camera that is best for marks and a belief.

    Attributes:
        vector: (11,) parameters.
        information: (8, 8) of the marks alone, for errors of 1 px, at what they count.
        off: (n,) solver px that remain of each mark.
        weights: (n,) 0 to 1, what each counts.
    """

    vector: FloatArray
    information: FloatArray
    off: FloatArray
    weights: FloatArray


def update_state(
    marks: EdgePoints,
    belief: GaussianState,
    start: FloatArray,
    half_diagonal: float,
    *,
    error_px: float,
    scale_px: float,
) -> StateUpdate:
    """The best camera for marks and a belief, robustly.

    Args:
        marks: n places of paint.
        belief: before them.
        start: (11,) parameters to start from.
        half_diagonal: half the picture's diagonal, solver px.
        error_px: standard deviation of a mark, solver px; what weighs them against the belief.
        scale_px: marks farther off than this count less and less; halved from step to step until
            it is that of marks on the same paint.
    """
    free = len(belief.information)
    vector, scale = start.copy(), max(scale_px, MIN_SCALE_PX)
    for _ in range(_ITERATIONS):
        off, by = edge_point_errors(vector[None], marks, half_diagonal, free)
        weights = geman_mcclure_weights(off[0], scale)
        weighted = by[0] * weights[:, None]
        information = weighted.T @ by[0]
        before = belief.vector[:free] - vector[:free]
        gradient = weighted.T @ off[0] / error_px**2 + belief.information @ before
        normal = information / error_px**2 + belief.information
        step = np.linalg.solve(normal, gradient)
        vector[:free] += step
        if free > KAPPA:
            vector[KAPPA] = np.clip(vector[KAPPA], MIN_KAPPA, _MAX_KAPPA)
        is_last = scale == MIN_SCALE_PX
        scale = max(scale / 2, MIN_SCALE_PX)
        if is_last and np.abs(by[0] @ step).max(initial=0.0) < _CONVERGED_PX:
            break
    off = off[0] - by[0] @ step
    return StateUpdate(vector, information, off, geman_mcclure_weights(off, scale))


def geman_mcclure_weights(off: FloatArray, scale_px: float = MIN_SCALE_PX) -> FloatArray:
    """What marks count that are so far off, solver px (Geman and McClure)."""
    return np.asarray((1 / (1 + (off / scale_px) ** 2)) ** 2)
