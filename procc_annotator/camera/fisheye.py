"""The fisheye camera: OpenCV's model with four coefficients of the angle off the axis."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.base import BoolArray, FloatArray
from procc_annotator.camera.pinhole import NEAREST_DEPTH_M, rotation_cam_from_world


@dataclass(frozen=True)
class FisheyeCamera:
    """A fisheye camera; pixels belong to the picture size the camera is used at.

    A ray at the angle theta off the axis appears at theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6
    + k4 theta^8) focal lengths from the principal point. Source: OpenCV, ``cv::fisheye``.

    Attributes:
        pan_rad, tilt_rad, roll_rad: orientation, see `pinhole.rotation_cam_from_world`.
        position_world: (3,) metres, world frame (z down: a camera above the ground has z < 0).
        focal_px: (fx, fy).
        principal_point_px: (cx, cy), origin at the centre of the top left pixel.
        coefficients: k1..k4.
    """

    pan_rad: float
    tilt_rad: float
    roll_rad: float
    position_world: tuple[float, float, float]
    focal_px: tuple[float, float]
    principal_point_px: tuple[float, float]
    coefficients: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)

    @cached_property
    def rotation_cam_from_world(self) -> FloatArray:
        """(3, 3) world -> camera rotation."""
        return rotation_cam_from_world(self.pan_rad, self.tilt_rad, self.roll_rad)

    @cached_property
    def largest_angle_rad(self) -> float:
        """Up to this angle off the axis the model is monotonic; beyond, it would fold back."""
        # Of the derivative in theta^2; scaled, for coefficients may be as large as a file can say.
        largest = max(1.0, *map(abs, self.coefficients))
        k1, k2, k3, k4 = (k / largest for k in self.coefficients)
        roots = np.roots([9 * k4, 7 * k3, 5 * k2, 3 * k1, 1.0 / largest])
        turning = [math.sqrt(r.real) for r in roots if abs(r.imag) <= 1e-9 * abs(r) and r.real > 0]
        return min([*turning, math.pi / 2])

    def radius_of(self, theta: NDArray[np.float64]) -> NDArray[np.float64]:
        """Distance from the principal point, in focal lengths, of rays at angles off the axis."""
        k1, k2, k3, k4 = self.coefficients
        t2 = theta * theta
        radius: NDArray[np.float64] = theta * (1 + t2 * (k1 + t2 * (k2 + t2 * (k3 + t2 * k4))))
        return radius

    def slope_of(self, theta: NDArray[np.float64]) -> NDArray[np.float64]:
        """Derivative of `radius_of`."""
        k1, k2, k3, k4 = self.coefficients
        t2 = theta * theta
        slope: NDArray[np.float64] = 1 + t2 * (3 * k1 + t2 * (5 * k2 + t2 * (7 * k3 + t2 * 9 * k4)))
        return slope

    def project(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        """Project world points; see `Camera.project`.

        Points at a depth of 1e-3 m or less, and those farther off the axis than the model is
        monotonic, have no projection.
        """
        points_cam = (points_world - np.array(self.position_world)) @ self.rotation_cam_from_world.T
        depth = points_cam[:, 2]
        valid = depth > NEAREST_DEPTH_M
        with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
            radius = np.hypot(points_cam[:, 0], points_cam[:, 1])
            theta = np.arctan2(radius, depth)
            valid &= theta <= self.largest_angle_rad
            # On the axis the ratio's limit is 1 / depth.
            ratio = np.where(
                radius > 0, self.radius_of(theta) / np.where(radius > 0, radius, 1.0), 1.0 / depth
            )
            px = points_cam[:, :2] * ratio[:, None] * np.array(self.focal_px)
            px += np.array(self.principal_point_px)
        return px, valid

    def scaled(self, from_size: tuple[int, int], to_size: tuple[int, int]) -> FisheyeCamera:
        """The same camera for another picture size (pixel centres: factors (W'-1)/(W-1))."""
        sx = (to_size[0] - 1) / (from_size[0] - 1)
        sy = (to_size[1] - 1) / (from_size[1] - 1)
        return replace(
            self,
            focal_px=(self.focal_px[0] * sx, self.focal_px[1] * sy),
            principal_point_px=(self.principal_point_px[0] * sx, self.principal_point_px[1] * sy),
        )
