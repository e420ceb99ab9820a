"""Test whether cameras are independent of the clicks that they are judged by.

A camera that was fitted to clicks leaves residuals that no small pan, tilt, roll or zoom would
reduce. Any other camera, even the true one, leaves the errors of the clicks, which such a change
reduces by chance: of n errors of equal variance it takes a share with the distribution
Beta(2, (n - 4) / 2), four directions of n (the F test of a linear model), and more of a camera
that is off itself or of clicks whose errors go together. So the test errs at most as often as its
level says. The p values of frames are combined as Fisher does (Statistical Methods for Research
Workers, 1932). Nothing is assumed about the camera's model or about the size of the errors.
"""

from __future__ import annotations

import math

import numpy as np

from procc_annotator.arrays import FloatArray

LEVEL = 0.001  # of the combined test
_LEAST_P = 0.001  # of a frame: none decides over a set alone
_DIRECTIONS = 4
_NOISE_PX = 0.01  # root mean square; below it points are drawn, not clicked, and have no errors


def independence_evidence(points_px: FloatArray, residuals_px: FloatArray) -> float | None:
    """Return -ln p of the test of one frame, at most 6.9; None if it cannot be tested. Residuals
    (n, 2) are the nearest projected position minus the clicked point; NaN where undefined."""
    distances = np.hypot(residuals_px[:, 0], residuals_px[:, 1])
    known = np.isfinite(distances) & (distances > 0)
    distances, points = distances[known], points_px[known]
    spare = len(distances) - _DIRECTIONS
    square = float(distances @ distances)
    if spare < 1 or square < len(distances) * _NOISE_PX**2:
        return None
    across = residuals_px[known] / distances[:, None]
    off = points - points.mean(axis=0)
    turned = across[:, 1] * off[:, 0] - across[:, 0] * off[:, 1]
    changes = np.column_stack((across, turned, (across * off).sum(axis=1)))
    changes /= np.maximum(np.linalg.norm(changes, axis=0), 1e-12)
    axes, sizes, _ = np.linalg.svd(changes, full_matrices=False)
    if sizes[-1] < 1e-6:
        return None
    share = min(1.0, float(((axes.T @ distances) ** 2).sum()) / square)
    p = 1 - (1 - share) ** (spare / 2) * (1 + share * spare / 2)
    return -math.log(max(p, _LEAST_P))


def are_dependent(frames: int, evidence: float) -> bool:
    """Return whether so many independent cameras would have as much evidence, summed over their
    frames, in less than `LEVEL` of the sets."""
    if evidence <= frames or not frames:
        return False
    # The sum is Gamma distributed: the tail is that of fewer Poisson events than frames.
    counts = np.arange(1, frames)
    logs = np.concatenate(((0.0,), np.cumsum(math.log(evidence) - np.log(counts)))) - evidence
    return float(np.exp(logs).sum()) < LEVEL
