"""What a lens may do to straight lines, without knowing the lens."""

from __future__ import annotations

import numpy as np

from procc_annotator.fit.solving.jacobian import Lens
from procc_annotator.fit.solving.models import FREE_PARAMETERS, KAPPA, MIN_KAPPA
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame

# Radial coefficients kappa (see `fit.solving.models`) from the strongest barrel that a fit allows,
# below 0, to a pincushion beyond any that cameras have: it shows the picture's corners a third
# farther out than they would lie without it.
PLAUSIBLE_KAPPAS = np.linspace(MIN_KAPPA, 0.3, 8)


def undistort_points(points: FloatArray, kappa: float, frame: ImageFrame) -> FloatArray:
    """Points as a lens of radial coefficient 0 would show them.

    Args:
        points: (n, 2) solver px, origin at the picture's centre.
        kappa: radial coefficient.
        frame: the picture.

    Returns:
        (n, 2) solver px: the solution r of r (1 + kappa r^2 / h^2) = distance. What a lens of
        negative kappa does not show, farther out than it reaches, is taken for lying at the edge
        of what it does.
    """
    vector = np.zeros((1, FREE_PARAMETERS["R+"]))
    vector[0, KAPPA] = kappa
    return np.asarray(Lens.of(vector, frame.half_diagonal).undistorted(points.T)[0].T)


def line_residuals(points: FloatArray) -> FloatArray:
    """Signed distances of (n, 2) points from the straight line through all of them."""
    centred = points - points.mean(axis=0)
    _, _, axes = np.linalg.svd(centred, full_matrices=False)
    return np.asarray(centred @ axes[-1])


def min_line_residuals(points: FloatArray, frame: ImageFrame) -> float:
    """How far points lie beside a straight line, seen through the lens that helps them most.

    Args:
        points: (n, 2) solver px, origin at the picture's centre; at least 3.
        frame: the picture.

    Returns:
        The largest distance, solver px.
    """
    return min(
        float(np.abs(line_residuals(undistort_points(points, kappa, frame))).max())
        for kappa in PLAUSIBLE_KAPPAS.tolist()
    )
