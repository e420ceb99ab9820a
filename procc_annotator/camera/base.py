"""Where an element should appear: the one method a camera model needs."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]


@runtime_checkable
class Camera(Protocol):
    """Anything that projects world points; plug in a model by writing this one method.

    What a model may offer besides, and what is done where it does not:

    - ``scaled(from_size, to_size)``: the same camera for another picture size; else its pixels are
      scaled (`camera.scaling`).
    - ``ground_from_px(points_px)``: the way back to the ground; else it is found numerically
      (`camera.backproject`).
    - ``ground_only = True``: it knows the plane z = 0 only.
    - ``model``: what people call it.
    """

    def project(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        """Project world points to the picture.

        Args:
            points_world: (N, 3) metres, world frame (z down).

        Returns:
            (N, 2) float64 px, origin at the centre of the top left pixel, and (N,) bool: whether
            the point has a projection (in front of the camera, inside the model's domain). Pixels
            of points without a projection are meaningless.
        """
        ...


def projects_only_ground(camera: object) -> bool:
    """Whether the model knows the plane z = 0 only; a homography has ``ground_only = True``."""
    return bool(getattr(camera, "ground_only", False))
