"""How surely a view shows a place whose position is uncertain: an ellipse in px."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.base import Camera
from procc_annotator.camera.sight_line import projection_slopes
from procc_annotator.field.geometry import Vector
from procc_annotator.field.landmarks import Covariance
from procc_annotator.fit.solving.observations import FloatArray

LEVEL_95 = math.sqrt(-2 * math.log(0.05))
"""Standard deviations that hold 95 % of a normal distribution in the plane."""


@dataclass(frozen=True, eq=False)
class Ellipse:
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


def projected_ellipse(
    camera: Camera,
    position: Vector,
    covariance: Covariance | None,
    *,
    camera_covariance: FloatArray | None = None,
    level: float = LEVEL_95,
) -> Ellipse | None:
    """Where a view shows a place, to first order.

    Args:
        camera: of the view, px.
        position: metres, world frame.
        covariance: (3, 3) m^2 of it; None for one that is taken as exact.
        camera_covariance: (2, 2) px^2 of the camera's own uncertainty there, if it is known.
        level: how many standard deviations the ellipse reaches out.

    Returns:
        None where the camera does not show the place.
    """
    px, slopes = projection_slopes(camera, np.array([position]))
    if not (np.isfinite(px).all() and np.isfinite(slopes).all()):
        return None
    spread = np.zeros((2, 2))
    if covariance is not None:
        spread = slopes[0] @ np.array(covariance) @ slopes[0].T
    if camera_covariance is not None and np.isfinite(camera_covariance).all():
        spread = spread + camera_covariance
    values, vectors = np.linalg.eigh(spread)
    shorter, longer = np.sqrt(np.maximum(values, 0.0)).tolist()
    angle = math.atan2(vectors[1, 1], vectors[0, 1])
    return Ellipse(px[0], (level * longer, level * shorter), angle)
