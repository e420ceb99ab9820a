"""What a lens may do to straight lines, without knowing the lens."""

from __future__ import annotations

import numpy as np

from procc_annotator.fit.solving.observations import FloatArray, Frame

# Radial coefficients kappa (see `fit.solving.models`) from a slight pincushion to the strongest
# barrel of a wide-angle camera: its corners would lie a third farther out without it.
PLAUSIBLE_KAPPAS = np.linspace(-0.05, 0.3, 8)


def undistorted(points: FloatArray, kappa: float, frame: Frame) -> FloatArray:
    """Points as a lens of radial coefficient 0 would show them.

    Args:
        points: (n, 2) solver px, origin at the picture's centre.
        kappa: radial coefficient, > -0.1.
        frame: the picture.

    Returns:
        (n, 2) solver px: the solution r of r (1 + kappa r^2 / h^2) = distance by Newton's method;
        points far outside the picture are taken for as far out as the picture's corners.
    """
    distance = np.hypot(*points.T)
    inside = np.minimum(distance, 1.5 * frame.half_diagonal)
    bend = kappa / frame.half_diagonal**2
    radius = inside.copy()
    for _ in range(6):
        radius -= (radius * (1 + bend * radius**2) - inside) / (1 + 3 * bend * radius**2)
    share = np.where(inside > 0, radius / np.maximum(inside, 1e-12), 1.0)
    return np.asarray(points * share[:, None])


def beside_line(points: FloatArray) -> FloatArray:
    """Signed distances of (n, 2) points from the straight line through all of them."""
    centred = points - points.mean(axis=0)
    _, _, axes = np.linalg.svd(centred, full_matrices=False)
    return np.asarray(centred @ axes[-1])


def least_bend(points: FloatArray, frame: Frame) -> float:
    """How far points lie beside a straight line, seen through the lens that helps them most.

    Args:
        points: (n, 2) solver px, origin at the picture's centre; at least 3.
        frame: the picture.

    Returns:
        The largest distance, solver px.
    """
    return min(
        float(np.abs(beside_line(undistorted(points, kappa, frame))).max())
        for kappa in PLAUSIBLE_KAPPAS.tolist()
    )
