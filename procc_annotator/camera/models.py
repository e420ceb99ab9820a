"""Camera models: pinhole with OpenCV distortion, fisheye, homography, 3 x 4 projection matrix."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.camera.undistortion import fisheye_rays, pinhole_rays
from procc_annotator.errors import UsageError

NEAREST_DEPTH_M = 1e-3
# Far outside the picture the rational model may blow up; such pixels are merely outside.
_IGNORE_OVERFLOW: dict[str, Any] = {"over": "ignore", "divide": "ignore", "invalid": "ignore"}


def as_pixels(points_px: Any) -> FloatArray:
    """(N, 2) float64 px; a UsageError for anything else. An empty list is (0, 2)."""
    try:
        found = np.asarray(points_px, np.float64)
    except (TypeError, ValueError):
        found = np.empty(1)
    found = found.reshape(0, 2) if found.shape == (0,) else found
    if found.ndim != 2 or found.shape[1] != 2:
        text = " ".join(repr(points_px).split())[:60]
        raise UsageError(f"expected pixels as (N, 2) numbers, [[x, y], ...], found {text}")
    return found


def size_factors(from_size: tuple[int, int], to_size: tuple[int, int]) -> tuple[float, float]:
    """What x and y in px are multiplied by for another picture size: (W'-1)/(W-1), (H'-1)/(H-1),
    of pixel centres."""
    return (to_size[0] - 1) / (from_size[0] - 1), (to_size[1] - 1) / (from_size[1] - 1)


def rotation_cam_from_world(pan_rad: float, tilt_rad: float, roll_rad: float) -> FloatArray:
    """World -> camera rotation (3, 3): the transpose of Rz(pan) @ Rx(tilt) @ Rz(roll). Camera axes
    are x right, y down, z forward."""
    world_from_cam = _rotation_z(pan_rad) @ _rotation_x(tilt_rad) @ _rotation_z(roll_rad)
    return np.ascontiguousarray(world_from_cam.T)


@dataclass(frozen=True)
class _PosedCamera(ABC):
    """Orientation, position, focal lengths and principal point, which both lens models have."""

    pan_rad: float
    tilt_rad: float
    roll_rad: float
    position_world: tuple[float, float, float]
    focal_px: tuple[float, float]
    principal_point_px: tuple[float, float]

    @cached_property
    def rotation_cam_from_world(self) -> FloatArray:
        """(3, 3) world -> camera rotation."""
        return rotation_cam_from_world(self.pan_rad, self.tilt_rad, self.roll_rad)

    def ground_from_px(self, points_px: FloatArray) -> FloatArray:
        """(N, 2) px -> (N, 2) metres on the ground, z = 0; NaN at and beyond the horizon, behind
        the camera and outside the lens model's domain."""
        points_px = as_pixels(points_px)
        rays = self.rays_cam(points_px)
        position = self.position_world
        with np.errstate(all="ignore"):
            along_x, along_y, down = self.rotation_cam_from_world.T @ rays
            distance = -position[2] / down
            # What is nearer than this counts as behind the camera.
            distance[~((distance > 0) & (distance * rays[2] > NEAREST_DEPTH_M))] = np.nan
            ground = np.empty((len(points_px), 2))
            ground[:, 0] = position[0] + distance * along_x
            ground[:, 1] = position[1] + distance * along_y
            ground[~np.isfinite(ground).all(axis=1)] = np.nan
        return ground

    def rays_cam(self, points_px: FloatArray) -> FloatArray:
        """(N, 2) px -> (3, N) directions in the camera frame; NaN outside the model's domain.

        Where a model folds, the part about the axis counts.
        """
        px_x, px_y = points_px.T
        x = (px_x - self.principal_point_px[0]) / self.focal_px[0]
        y = (px_y - self.principal_point_px[1]) / self.focal_px[1]
        with np.errstate(all="ignore"):
            return self._rays(x, y)

    @abstractmethod
    def _rays(self, x: FloatArray, y: FloatArray) -> FloatArray:
        """(3, N) directions of image points at depth 1."""

    def scaled(self, from_size: tuple[int, int], to_size: tuple[int, int]) -> Self:
        """The same camera for another picture size; see `size_factors`."""
        sx, sy = size_factors(from_size, to_size)
        return replace(
            self,
            focal_px=(self.focal_px[0] * sx, self.focal_px[1] * sy),
            principal_point_px=(self.principal_point_px[0] * sx, self.principal_point_px[1] * sy),
        )


@dataclass(frozen=True)
class PinholeCamera(_PosedCamera):
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

    radial: tuple[float, float, float, float, float, float] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    tangential: tuple[float, float] = (0.0, 0.0)
    thin_prism: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)

    def _rays(self, x: FloatArray, y: FloatArray) -> FloatArray:
        if not self.is_distorted:
            return np.array((x, y, np.ones_like(x)))
        return pinhole_rays(x, y, self.radial, self.tangential, self.thin_prism)

    @cached_property
    def is_distorted(self) -> bool:
        """Return whether any distortion coefficient differs from zero."""
        return any(self.radial) or any(self.tangential) or any(self.thin_prism)

    @cached_property
    def fold_radius(self) -> float:
        """Distance from the axis, at depth 1, where radial distortion stops leading outwards.

        What is farther out would appear among what is nearer. Infinite if it never stops.
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


@dataclass(frozen=True)
class FisheyeCamera(_PosedCamera):
    """A fisheye camera; pixels belong to the picture size the camera is used at.

    A ray at the angle theta off the axis appears at theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6
    + k4 theta^8) focal lengths from the principal point. Source: OpenCV, ``cv::fisheye``.

    Attributes:
        pan_rad, tilt_rad, roll_rad: orientation, see `rotation_cam_from_world`.
        position_world: (3,) metres, world frame (z down: a camera above the ground has z < 0).
        focal_px: (fx, fy).
        principal_point_px: (cx, cy), origin at the centre of the top left pixel.
        coefficients: k1..k4.
    """

    coefficients: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)

    def _rays(self, x: FloatArray, y: FloatArray) -> FloatArray:
        return fisheye_rays(x, y, self.radius_of, self.slope_of, self.largest_angle_rad)

    @cached_property
    def largest_angle_rad(self) -> float:
        """Up to this angle off the axis the model is monotonic; beyond, it would fold back."""
        # The roots of the derivative as a polynomial in 1 / theta^2: it has no leading coefficient
        # that could be next to nothing. Those a file can say may be as large as numbers get.
        k1, k2, k3, k4 = np.clip(self.coefficients, -1e300, 1e300).tolist()
        roots = np.roots([1.0, 3 * k1, 5 * k2, 7 * k3, 9 * k4])
        turning = [
            1 / math.sqrt(r.real) for r in roots if abs(r.imag) <= 1e-9 * abs(r) and r.real > 0
        ]
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
        with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
            points_cam = points_world - np.array(self.position_world)
            points_cam = points_cam @ self.rotation_cam_from_world.T
            depth = points_cam[:, 2]
            radius = np.hypot(points_cam[:, 0], points_cam[:, 1])
            theta = np.arctan2(radius, depth)
            valid = (depth > NEAREST_DEPTH_M) & (theta <= self.largest_angle_rad)
            # On the axis the ratio's limit is 1 / depth.
            ratio = np.where(
                radius > 0, self.radius_of(theta) / np.where(radius > 0, radius, 1.0), 1.0 / depth
            )
            px = points_cam[:, :2] * ratio[:, None] * np.array(self.focal_px)
            px += np.array(self.principal_point_px)
        return px, valid


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
        """The same homography for another picture size; see `size_factors`."""
        factors = np.array([*size_factors(from_size, to_size), 1.0])
        return HomographyCamera(factors[:, None] * self.image_from_world)

    def ground_from_px(self, points_px: FloatArray) -> FloatArray:
        """(N, 2) px -> (N, 2) metres on the ground; NaN at and beyond the horizon."""
        world_from_image = np.linalg.inv(self.image_from_world)
        ground = as_pixels(points_px) @ world_from_image[:, :2].T + world_from_image[:, 2]
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(ground[:, 2:] > 0, ground[:, :2] / ground[:, 2:], np.nan)


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
        """The same camera for another picture size; see `size_factors`."""
        factors = np.array([*size_factors(from_size, to_size), 1.0])
        return MatrixCamera(factors[:, None] * self.image_from_world)

    def ground_from_px(self, points_px: FloatArray) -> FloatArray:
        """(N, 2) px -> (N, 2) metres on the ground; NaN at and beyond the horizon."""
        return self._ground.ground_from_px(points_px)

    @cached_property
    def _ground(self) -> HomographyCamera:
        return HomographyCamera(self.image_from_world[:, [0, 1, 3]])


# Half a pixel is what conventions of a picture's centre differ by.
_CENTRED_TOLERANCE_PX = 1.0
# Sizes whose shapes are not quite the same stretch pixels by less.
_SQUARE_PIXEL_TOLERANCE = 2e-3


def model_name(camera: object, family: str, size: tuple[int, int]) -> str:
    """``pinhole P``, ``R``, ``R+`` or ``R2``, as fits are named; ``pinhole full`` with other
    coefficients than k1 and k2. Of any other model ``family``: what its file or plug-in calls it.

    P has one focal length and its principal point in the centre of the picture, R k1 besides, R+ an
    aspect ratio and a principal point of its own, R2 a second coefficient.
    """
    if not isinstance(camera, PinholeCamera):
        return family
    k1, k2, *others = camera.radial
    if any(others) or any(camera.tangential) or any(camera.thin_prism):
        return f"{family} full"
    if k2:
        return f"{family} R2"
    ratio = camera.focal_px[1] / camera.focal_px[0]
    off = [
        abs(at - (length - 1) / 2)
        for at, length in zip(camera.principal_point_px, size, strict=True)
    ]
    if abs(ratio - 1) > _SQUARE_PIXEL_TOLERANCE or max(off) > _CENTRED_TOLERANCE_PX:
        return f"{family} R+"
    return f"{family} R" if k1 else f"{family} P"
