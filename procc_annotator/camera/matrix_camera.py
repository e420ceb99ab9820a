"""A camera that is a 3 x 4 projection matrix, skew and all."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from procc_annotator.camera.base import BoolArray, FloatArray
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.pinhole import NEAREST_DEPTH_M

_SINGULAR = 1e-12


@dataclass(frozen=True, eq=False)
class MatrixCamera:
    """Maps the world to the picture.

    Attributes:
        image_from_world: (3, 4), metres (x, y, z, 1) of the world frame to px, scaled so that the
            third coordinate is the depth in metres, positive in front of the camera.
    """

    image_from_world: FloatArray
    model: ClassVar[str] = "projection matrix"

    @classmethod
    def of(cls, matrix: FloatArray) -> MatrixCamera:
        """From a matrix of any scale and sign; the world frame is taken to be right-handed.

        Args:
            matrix: (3, 4).

        Raises:
            ValueError: not (3, 4), not finite, or the camera is infinitely far away.
        """
        if matrix.shape != (3, 4) or not np.isfinite(matrix).all():
            raise ValueError("expected 3 x 4 finite numbers")
        matrix = matrix / (np.abs(matrix[:, :3]).max() or 1.0)
        singular_values = np.linalg.svd(matrix[:, :3], compute_uv=False)
        if not singular_values[-1] > _SINGULAR * singular_values[0]:
            raise ValueError("its first three columns cannot be inverted")
        scale = np.linalg.norm(matrix[2, :3]) * np.sign(np.linalg.det(matrix[:, :3]))
        return cls(np.asarray(matrix / scale, dtype=np.float64))

    def project(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        """See `Camera.project`; points at a depth of 1e-3 m or less have no projection."""
        homogeneous = points_world @ self.image_from_world[:, :3].T + self.image_from_world[:, 3]
        depth = homogeneous[:, 2]
        valid = depth > NEAREST_DEPTH_M
        return homogeneous[:, :2] / np.where(valid, depth, 1.0)[:, None], valid

    def scaled(self, from_size: tuple[int, int], to_size: tuple[int, int]) -> MatrixCamera:
        """The same camera for another picture size (factors (W'-1)/(W-1), (H'-1)/(H-1))."""
        sx = (to_size[0] - 1) / (from_size[0] - 1)
        sy = (to_size[1] - 1) / (from_size[1] - 1)
        return MatrixCamera(np.array([[sx], [sy], [1.0]]) * self.image_from_world)

    def ground_from_px(self, points_px: FloatArray) -> FloatArray:
        """(N, 2) px -> (N, 2) metres on the ground; NaN at and beyond the horizon."""
        return self._ground.ground_from_px(points_px)

    @cached_property
    def _ground(self) -> HomographyCamera:
        return HomographyCamera(self.image_from_world[:, [0, 1, 3]])
