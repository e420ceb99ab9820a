"""What marks are worth, and the fit that comes of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.on_paint.belief import MIN_WEIGHT, GaussianState, StateUpdate
from procc_annotator.fit.on_paint.marks import PARAMETERS_FREE, EdgePoints
from procc_annotator.fit.on_paint.painted import MarkingPoints
from procc_annotator.fit.result import ElementResidual, FitResult, PoseStandardDeviations
from procc_annotator.fit.solving.models import (
    LOG_FOCAL,
    PARAMETERS,
    X,
    Z,
    camera_from_vector,
)
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame

_MIN_ERROR_PX, _PRIOR_ERROR_PX, _PRIOR_WEIGHT = 0.08, 0.5, 20.0
_CORRELATION_LAGS = 12  # neighbouring marks, whose errors may have a part in common
_MAX_CORRELATED = 12.0


@dataclass(frozen=True, slots=True)
class EdgeNoiseModel:
    """What marks are off by.

    Attributes:
        error_px: standard deviation of one of them, solver px.
        together: how many of them are worth one, for neighbours err together.
    """

    error_px: float
    together: float

    @property
    def independent_error_px(self) -> float:
        """Standard deviation that marks would have if they were as many independent ones."""
        return self.error_px * float(np.sqrt(self.together))


def estimate_edge_noise(solved: StateUpdate, marks: EdgePoints) -> EdgeNoiseModel:
    """What the marks of a picture are worth, by what remains of them."""
    counted = solved.weights > MIN_WEIGHT
    off, run = solved.off[counted], marks.run[counted]
    if not len(off):
        return EdgeNoiseModel(_PRIOR_ERROR_PX, _MAX_CORRELATED)
    squares = float((off * off).sum())
    variance = (squares + _PRIOR_WEIGHT * _PRIOR_ERROR_PX**2) / (len(off) + _PRIOR_WEIGHT)
    # Sums of neighbours: as large as they are independent, or larger.
    place = np.arange(len(run)) - np.searchsorted(run, run)
    group = run * (len(run) // _CORRELATION_LAGS + 2) + place // _CORRELATION_LAGS
    _, of = np.unique(group, return_inverse=True)
    sums = np.bincount(of, off)
    together = float((sums * sums).sum()) / max(squares, 1e-9)
    return EdgeNoiseModel(
        max(float(np.sqrt(variance)), _MIN_ERROR_PX), min(max(together, 1.0), _MAX_CORRELATED)
    )


def fit_from_edge_points(
    solved: StateUpdate,
    marks: EdgePoints,
    belief: GaussianState,
    worth: EdgeNoiseModel,
    painted: MarkingPoints,
    frame: ImageFrame,
) -> FitResult:
    """A fit to marks, as any fit is handed back."""
    information = solved.information / worth.independent_error_px**2 + belief.information
    covariance = np.linalg.inv(information)
    covariance = (covariance + covariance.T) / 2
    return fit_from_covariance(
        solved.vector, covariance, frame, worth.error_px, _element_residuals(solved, marks, painted, frame)
    )


def fit_from_covariance(
    vector: FloatArray,
    covariance: FloatArray,
    frame: ImageFrame,
    error_px: float,
    elements: tuple[ElementResidual, ...] = (),
) -> FitResult:
    """A camera of known covariance as a fit.

    Args:
        vector: (11,) parameters.
        covariance: (8, 8) of the free ones.
        frame: the picture.
        error_px: standard deviation of a mark, solver px.
        elements: what remains of theirs.
    """
    sd = np.sqrt(np.maximum(np.diag(covariance), 0.0)).tolist()
    focal = float(np.exp(vector[LOG_FOCAL])) / frame.scale
    deviations = PoseStandardDeviations(
        sd[0], sd[1], sd[2], (sd[X], sd[X + 1], sd[Z]), focal * sd[LOG_FOCAL]
    )
    return FitResult(
        "R",
        frame.size,
        camera_from_vector(vector, frame),
        None,
        elements,
        deviations,
        error_px / frame.scale,
        PARAMETERS[:PARAMETERS_FREE],
        covariance,
        True,
        vector,
        of_clicks=covariance,
    )


def _element_residuals(
    solved: StateUpdate, marks: EdgePoints, painted: MarkingPoints, frame: ImageFrame
) -> tuple[ElementResidual, ...]:
    away = np.abs(solved.off) / frame.scale
    found = []
    for number in np.unique(marks.element).tolist():
        own = marks.element == number
        counted = own & (solved.weights > MIN_WEIGHT)
        left_out = not counted.any()
        distances = away[own if left_out else counted]
        found.append(ElementResidual(painted.names[number], tuple(distances.tolist()), left_out))
    return tuple(found)
