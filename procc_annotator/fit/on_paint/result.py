"""What marks are worth, and the fit that comes of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.on_paint.belief import COUNTS, Belief, Solved
from procc_annotator.fit.on_paint.marks import PARAMETERS_FREE, Marks
from procc_annotator.fit.on_paint.painted import Painted
from procc_annotator.fit.result import ElementResidual, FitResult, PoseDeviations
from procc_annotator.fit.solving.models import (
    LOG_FOCAL,
    PARAMETERS,
    X,
    Z,
    camera_from_vector,
)
from procc_annotator.fit.solving.observations import FloatArray, PictureFrame

_LEAST_ERROR_PX, _USUAL_ERROR_PX, _BELIEF = 0.08, 0.5, 20.0
_TOGETHER = 12  # neighbouring marks, whose errors may have a part in common
_MOST_TOGETHER = 12.0


@dataclass(frozen=True, slots=True)
class Worth:
    """What marks are off by.

    Attributes:
        error_px: standard deviation of one of them, solver px.
        together: how many of them are worth one, for neighbours err together.
    """

    error_px: float
    together: float

    @property
    def information_px(self) -> float:
        """Standard deviation that marks would have if they were as many independent ones."""
        return self.error_px * float(np.sqrt(self.together))


def worth_of(solved: Solved, marks: Marks) -> Worth:
    """What the marks of a picture are worth, by what remains of them."""
    counted = solved.weights > COUNTS
    off, run = solved.off[counted], marks.run[counted]
    if not len(off):
        return Worth(_USUAL_ERROR_PX, _MOST_TOGETHER)
    squares = float((off * off).sum())
    variance = (squares + _BELIEF * _USUAL_ERROR_PX**2) / (len(off) + _BELIEF)
    # Sums of neighbours: as large as they are independent, or larger.
    place = np.arange(len(run)) - np.searchsorted(run, run)
    group = run * (len(run) // _TOGETHER + 2) + place // _TOGETHER
    _, of = np.unique(group, return_inverse=True)
    sums = np.bincount(of, off)
    together = float((sums * sums).sum()) / max(squares, 1e-9)
    return Worth(
        max(float(np.sqrt(variance)), _LEAST_ERROR_PX), min(max(together, 1.0), _MOST_TOGETHER)
    )


def fit_of(
    solved: Solved,
    marks: Marks,
    belief: Belief,
    worth: Worth,
    painted: Painted,
    frame: PictureFrame,
) -> FitResult:
    """A fit to marks, as any fit is handed back."""
    information = solved.information / worth.information_px**2 + belief.information
    covariance = np.linalg.inv(information)
    covariance = (covariance + covariance.T) / 2
    return fit_result(
        solved.vector, covariance, frame, worth.error_px, _elements(solved, marks, painted, frame)
    )


def fit_result(
    vector: FloatArray,
    covariance: FloatArray,
    frame: PictureFrame,
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
    deviations = PoseDeviations(
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


def _elements(
    solved: Solved, marks: Marks, painted: Painted, frame: PictureFrame
) -> tuple[ElementResidual, ...]:
    away = np.abs(solved.off) / frame.scale
    found = []
    for number in np.unique(marks.element).tolist():
        own = marks.element == number
        counted = own & (solved.weights > COUNTS)
        left_out = not counted.any()
        distances = away[own if left_out else counted]
        found.append(ElementResidual(painted.names[number], tuple(distances.tolist()), left_out))
    return tuple(found)
