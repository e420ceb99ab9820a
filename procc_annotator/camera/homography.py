"""A homography as a camera: it knows the ground plane z = 0 and nothing else."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from procc_annotator.camera.base import BoolArray, FloatArray

_ON_GROUND_TOLERANCE_M = 1e-9
_SINGULAR = 1e-12


@dataclass(frozen=True, eq=False)
class HomographyCamera:
    """Maps the ground to the picture.

    Attributes:
        image_from_world: (3, 3), metres (x, y, 1) of the world frame to px, scaled so that the
            third coordinate is positive for ground in front of the camera.
    """

    image_from_world: FloatArray
    ground_only: ClassVar[bool] = True

    @classmethod
    def from_world_from_image(
        cls, world_from_image: FloatArray, size: tuple[int, int]
    ) -> HomographyCamera:
        """From the matrix that annotation files hold, picture to ground.

        A homography has no sign of its own. The ground in front of the camera is the side of the
        horizon on which the lower edge's middle of the picture lies, since cameras at a sports
        field look down on it.

        Args:
            world_from_image: (3, 3), px to metres of the world frame.
            size: (width, height) in px of the picture the pixels belong to.

        Raises:
            ValueError: not (3, 3), not finite, or not invertible.
        """
        matrix = np.asarray(world_from_image, dtype=np.float64)
        if matrix.shape != (3, 3) or not np.isfinite(matrix).all():
            raise ValueError("expected 3 x 3 finite numbers")
        singular_values = np.linalg.svd(matrix, compute_uv=False)
        if singular_values[-1] <= _SINGULAR * singular_values[0]:
            raise ValueError("the matrix cannot be inverted")
        inverse: FloatArray = np.linalg.inv(matrix).astype(np.float64)
        # For a picture point q the ground point is matrix @ q, whose third coordinate's reciprocal
        # is the third coordinate of the way back; both have the sign of the side of the horizon.
        below = matrix[2] @ ((size[0] - 1) / 2, size[1] - 1, 1.0)
        return cls(inverse if below >= 0 else -inverse)

    def project(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        """Project ground points; points off the ground or beyond the horizon have no projection."""
        homogeneous = (
            points_world[:, :2] @ self.image_from_world[:, :2].T + self.image_from_world[:, 2]
        )
        depth = homogeneous[:, 2]
        valid = (depth > 0) & (np.abs(points_world[:, 2]) <= _ON_GROUND_TOLERANCE_M)
        # A point next to the horizon may be infinitely far away in the picture: merely outside.
        with np.errstate(over="ignore"):
            return homogeneous[:, :2] / np.where(valid, depth, 1.0)[:, None], valid

    def scaled(self, from_size: tuple[int, int], to_size: tuple[int, int]) -> HomographyCamera:
        """The same homography for another picture size (factors (W'-1)/(W-1), (H'-1)/(H-1))."""
        factors = np.array(
            [
                (to_size[0] - 1) / (from_size[0] - 1),
                (to_size[1] - 1) / (from_size[1] - 1),
                1.0,
            ]
        )
        return HomographyCamera(factors[:, None] * self.image_from_world)

    def ground_from_px(self, points_px: FloatArray) -> FloatArray:
        """(N, 2) px -> (N, 2) metres on the ground; NaN at and beyond the horizon."""
        world_from_image = np.linalg.inv(self.image_from_world)
        ground = points_px @ world_from_image[:, :2].T + world_from_image[:, 2]
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(ground[:, 2:] > 0, ground[:, :2] / ground[:, 2:], np.nan)
