"""The pinhole camera with OpenCV's full distortion model (without tilt), as in SoccerNet files."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from procc_annotator.camera.base import BoolArray, FloatArray

NEAREST_DEPTH_M = 1e-3
# Far outside the picture the rational model may blow up; such pixels are merely outside.
_IGNORE_OVERFLOW: dict[str, Any] = {"over": "ignore", "divide": "ignore", "invalid": "ignore"}


def rotation_cam_from_world(pan_rad: float, tilt_rad: float, roll_rad: float) -> FloatArray:
    """World -> camera rotation: the transpose of Rz(pan) @ Rx(tilt) @ Rz(roll).

    Returns:
        (3, 3); camera axes are x right, y down, z forward.
    """
    world_from_cam = _rotation_z(pan_rad) @ _rotation_x(tilt_rad) @ _rotation_z(roll_rad)
    return np.ascontiguousarray(world_from_cam.T)


@dataclass(frozen=True)
class PinholeCamera:
    """A pinhole camera; pixels belong to the picture size the camera is used at.

    Attributes:
        pan_rad, tilt_rad, roll_rad: orientation, see `rotation_cam_from_world`.
        position_world: (3,) metres, world frame (z down: a camera above the ground has z < 0).
        focal_px: (fx, fy).
        principal_point_px: (cx, cy), origin at the centre of the top left pixel.
        radial: k1..k6, as in OpenCV's rational model.
        tangential: p1, p2.
        thin_prism: s1..s4.
    """

    pan_rad: float
    tilt_rad: float
    roll_rad: float
    position_world: tuple[float, float, float]
    focal_px: tuple[float, float]
    principal_point_px: tuple[float, float]
    radial: tuple[float, float, float, float, float, float] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    tangential: tuple[float, float] = (0.0, 0.0)
    thin_prism: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)

    @cached_property
    def rotation_cam_from_world(self) -> FloatArray:
        """(3, 3) world -> camera rotation."""
        return rotation_cam_from_world(self.pan_rad, self.tilt_rad, self.roll_rad)

    @cached_property
    def is_distorted(self) -> bool:
        """Whether any distortion coefficient differs from zero."""
        return any(self.radial) or any(self.tangential) or any(self.thin_prism)

    @cached_property
    def fold_radius(self) -> float:
        """Distance from the axis, at depth 1, where radial distortion stops leading outwards.

        What lies farther out would appear among what lies nearer. Infinite if it never stops.
        """
        k1, k2, k3, k4, k5, k6 = self.radial
        if not any((k2, k3, k4, k5, k6)):
            return math.sqrt(-1 / (3 * k1)) if k1 < 0 else math.inf
        s = Polynomial((0.0, 1.0))  # the square of the radius
        top, under = Polynomial((1.0, k1, k2, k3)), Polynomial((1.0, k4, k5, k6))
        slope = (top + 2 * s * top.deriv()) * under - 2 * s * top * under.deriv()
        if not np.isfinite(slope.coef).all():
            return math.inf
        # Lowest power first: roots of 1 / s, in which both begin with 1, however small the others.
        turns = np.concatenate((np.roots(slope.coef), np.roots(under.coef)))
        nearest = turns[turns.imag == 0].real.max(initial=0.0)
        return 1 / math.sqrt(nearest) if nearest > 0 else math.inf

    def project(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        """Project world points; see `Camera.project`.

        Points at a depth of 1e-3 m or less have no projection, nor do those from beyond where the
        lens folds (`fold_radius`). Source of the model: OpenCV, "Camera Calibration and 3D
        Reconstruction", full model with tau_x = tau_y = 0.
        """
        with np.errstate(**_IGNORE_OVERFLOW):
            x, y, shown = self._normalised(points_world)
            if self.fold_radius < math.inf:
                shown &= x * x + y * y < self.fold_radius**2
            xd, yd = self._distort(x, y)
            px = np.empty((len(x), 2))
            px[:, 0] = self.focal_px[0] * xd + self.principal_point_px[0]
            px[:, 1] = self.focal_px[1] * yd + self.principal_point_px[1]
        return px, shown

    def project_float32(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        """As `project`, with the last step in single precision as the official evaluation does.

        Distorted coordinates and pixels are rounded to float32 there, which moves a pixel by up to
        1.5e-4 px and can decide a comparison. Nor does it know of folds.
        """
        with np.errstate(**_IGNORE_OVERFLOW):
            x, y, in_front = self._normalised(points_world)
            xd, yd = self._distort(x, y)
            distorted = np.empty((len(x), 2), dtype=np.float32)
            distorted[:, 0] = xd
            distorted[:, 1] = yd
            focal = np.array(self.focal_px, dtype=np.float32)
            # Two roundings, after the product and after the sum, in this order.
            px = distorted * focal + np.array(self.principal_point_px, dtype=np.float32)
            return px.astype(np.float64), in_front

    def scaled(self, from_size: tuple[int, int], to_size: tuple[int, int]) -> PinholeCamera:
        """The same camera for another picture size (pixel centres: factors (W'-1)/(W-1))."""
        sx = (to_size[0] - 1) / (from_size[0] - 1)
        sy = (to_size[1] - 1) / (from_size[1] - 1)
        return replace(
            self,
            focal_px=(self.focal_px[0] * sx, self.focal_px[1] * sy),
            principal_point_px=(
                self.principal_point_px[0] * sx,
                self.principal_point_px[1] * sy,
            ),
        )

    def _normalised(
        self, points_world: FloatArray
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], BoolArray]:
        points_cam = (points_world - np.array(self.position_world)) @ self.rotation_cam_from_world.T
        depth = points_cam[:, 2]
        in_front = depth > NEAREST_DEPTH_M
        depth = np.where(in_front, depth, 1.0)
        return points_cam[:, 0] / depth, points_cam[:, 1] / depth, in_front

    def _distort(
        self, x: NDArray[np.float64], y: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        if not self.is_distorted:
            return x, y
        k1, k2, k3, k4, k5, k6 = self.radial
        p1, p2 = self.tangential
        s1, s2, s3, s4 = self.thin_prism
        r2 = x * x + y * y
        r4 = r2 * r2
        r6 = r4 * r2
        f = (1 + k1 * r2 + k2 * r4 + k3 * r6) / (1 + k4 * r2 + k5 * r4 + k6 * r6)
        xd = x * f + 2 * p1 * x * y + p2 * (r2 + 2 * x * x) + s1 * r2 + s2 * r4
        yd = y * f + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y + s3 * r2 + s4 * r4
        return xd, yd


def _rotation_z(angle_rad: float) -> FloatArray:
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def _rotation_x(angle_rad: float) -> FloatArray:
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])
