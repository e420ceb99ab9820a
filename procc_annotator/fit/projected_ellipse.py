"""How surely a view shows a place whose position is uncertain: an ellipse in px."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.base import BoolArray, Camera
from procc_annotator.camera.sight_line import projection_jacobian
from procc_annotator.field.geometry import Covariance, Vector
from procc_annotator.fit.solving.observations import FloatArray

ELLIPSE_SCALE_95 = math.sqrt(-2 * math.log(0.05))
"""Standard deviations that hold 95 % of a normal distribution in the plane."""


@dataclass(frozen=True, eq=False)
class ErrorEllipse:
    """An ellipse in a picture.

    Attributes:
        centre_px: (2,) px.
        semi_axes_px: the longer and the shorter one, px.
        angle_rad: from the picture's x axis towards its y axis (down) to the longer one.
    """

    centre_px: FloatArray
    semi_axes_px: tuple[float, float]
    angle_rad: float

    def outline(self, count: int = 48) -> FloatArray:
        """(count + 1, 2) px, closed."""
        turn = np.linspace(0.0, 2 * math.pi, count + 1)
        a, b = self.semi_axes_px
        cosine, sine = math.cos(self.angle_rad), math.sin(self.angle_rad)
        x, y = a * np.cos(turn), b * np.sin(turn)
        points = np.column_stack((cosine * x - sine * y, sine * x + cosine * y)) + self.centre_px
        points[-1] = points[0]
        return np.asarray(points)


def project_error_ellipses(
    camera: Camera,
    positions: Sequence[Vector],
    covariances: Sequence[Covariance | None],
    *,
    camera_covariances: FloatArray | None = None,
    level: float = ELLIPSE_SCALE_95,
) -> list[ErrorEllipse | None]:
    """Where a view shows places, to first order.

    Args:
        camera: of the view, px.
        positions: N places, metres, world frame.
        covariances: (3, 3) m^2 of each; None for one that is taken as exact.
        camera_covariances: (N, 2, 2) px^2 of the camera's own uncertainty there, where it is known;
            NaN counts as none.
        level: how many standard deviations an ellipse reaches out.

    Returns:
        N ellipses; None for places that the camera does not show.
    """
    if not positions:
        return []
    px, slopes = projection_jacobian(camera, np.array(positions))
    finite = np.isfinite(np.hstack((px, slopes.reshape(-1, 6)))).all(axis=1)
    shown: BoolArray = np.asarray(finite, dtype=bool)
    known = np.array([np.zeros((3, 3)) if c is None else np.array(c) for c in covariances])
    slopes = np.where(shown[:, None, None], slopes, 0.0)
    spread = slopes @ known @ slopes.transpose(0, 2, 1)
    if camera_covariances is not None:
        spread = spread + np.where(np.isfinite(camera_covariances), camera_covariances, 0.0)
    values, vectors = np.linalg.eigh(spread)
    axes = level * np.sqrt(np.maximum(values, 0.0))
    angles = np.arctan2(vectors[:, 1, 1], vectors[:, 0, 1])
    return [
        ErrorEllipse(centre, (float(pair[1]), float(pair[0])), float(angle)) if seen else None
        for centre, pair, angle, seen in zip(px, axes, angles, shown, strict=True)
    ]
