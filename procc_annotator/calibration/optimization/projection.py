"""Batched projection through a lens, with derivatives by the camera parameters."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.camera_parameters import (
    ASPECT,
    KAPPA,
    LOG_FOCAL,
    PAN,
    POSITION_SLICE,
    PRINCIPAL_X,
    PRINCIPAL_Y,
    ROLL,
    SECOND_KAPPA,
    is_fisheye,
    is_wide_angle,
    rotation_matrices,
)

# Nearer to a right angle off the axis nothing of a field is seen; farther out than so many half
# diagonals no lens shows anything of the picture.
_MAX_ANGLE_RAD, _MAX_RADII = 1.5, 6.0
_NEWTON_STEPS = 20
_SERIES_RADIUS = 1e-3  # of the unit: nearer to the axis the curve is straight
_TINY = 1e-12
# Nearer than this to the camera's plane nothing is projected: its pixels would be anywhere.
MIN_DEPTH_M = 0.5


@dataclass(frozen=True, eq=False)
class RadialLensCurve:
    """B curves of one kind.

    Attributes:
        first, second: (B, 1) coefficients a and b.
        unit: (B, 1) solver px of t = 1: half the picture's diagonal, or a fisheye's focal length.
        fisheye: whether t is an angle.
    """

    first: FloatArray
    second: FloatArray
    unit: FloatArray
    fisheye: bool

    @property
    def reach(self) -> FloatArray:
        """(B, 1) t up to which the curve rises; what is beyond it would fold back."""
        a, b = 3 * self.first, 5 * self.second
        # 1 + a s + b s^2 = 0 with s = t^2, as 1 / s: the largest positive root is the nearest turn.
        inside = a * a - 4 * b
        root = np.where(inside >= 0, (-a + np.sqrt(np.maximum(inside, 0.0))) / 2, 0.0)
        most = _MAX_ANGLE_RAD if self.fisheye else _MAX_RADII
        return np.asarray(np.minimum(1 / np.sqrt(np.maximum(root, 1 / most**2)), most))

    def undistorted(self, distance: FloatArray) -> FloatArray:
        """(B, N) solver px from the principal point -> where a lens without distortion shows it.

        What a lens does not show is taken for lying at the edge of what it does.
        """
        wanted = distance / self.unit
        low, high = np.zeros_like(wanted), np.broadcast_to(self.reach, wanted.shape).copy()
        t = np.minimum(wanted, high)
        for _ in range(_NEWTON_STEPS):
            off = self._shown(t) - wanted
            low, high = np.where(off < 0, t, low), np.where(off > 0, t, high)
            step = t - off / np.maximum(self._slope(t), _TINY)
            t = np.where((step > low) & (step < high), step, (low + high) / 2)
        return np.asarray(self.unit * (np.tan(t) if self.fisheye else t))

    def growth(self, squares: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return how undistorted places v grow, by |v| squared (B, N), solver px: g and w so that v
        appears at g v, and a small step dv of it at g dv + w v (v . dv)."""
        if not self.fisheye:
            s = squares / self.unit**2
            slope = 2 * (self.first + 2 * self.second * s) / self.unit**2
            return 1 + s * (self.first + self.second * s), slope
        radius, angle = self._ray(squares)
        grown = self.unit * self._shown(angle) / radius
        outward = self.unit**2 * self._slope(angle) / (self.unit**2 + radius**2)
        return grown, (outward - grown) / radius**2

    def by_coefficients(self, squares: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(B, N) derivatives of g by both coefficients."""
        if not self.fisheye:
            s = squares / self.unit**2
            return s, s * s
        radius, angle = self._ray(squares)
        first = self.unit * angle**3 / radius
        return first, first * angle**2

    def beyond(self, squares: FloatArray) -> NDArray[np.bool_]:
        """(B, N) whether what is there undistorted is too far out to be shown."""
        if self.fisheye:
            return np.asarray(self._ray(squares)[1] >= self.reach)
        return np.asarray(squares >= (self.unit * self.reach) ** 2)

    def _ray(self, squares: FloatArray) -> tuple[FloatArray, FloatArray]:
        radius = np.maximum(np.sqrt(squares), _SERIES_RADIUS * self.unit)
        return radius, np.arctan2(radius, self.unit)

    def _shown(self, t: FloatArray) -> FloatArray:
        s = t * t
        return np.asarray(t * (1 + s * (self.first + s * self.second)))

    def _slope(self, t: FloatArray) -> FloatArray:
        s = t * t
        return np.asarray(1 + s * (3 * self.first + 5 * self.second * s))


@dataclass(frozen=True, eq=False)
class Lens:
    """B cameras, taken apart.

    Attributes:
        vectors: (B, 11) parameters, or (B, 13) of strong lenses of one kind.
        rotation: (B, 3, 3) world -> camera.
        linear: (B, 3, 4) world -> undistorted pixels times depth.
        focal: (B,) focal length, solver px.
        bend: (B, 1) kappa / h^2.
        distortion_by_kappa: 1 / h^2.
        curve: of strong lenses; None for those of one radial coefficient.
    """

    vectors: FloatArray
    rotation: FloatArray
    linear: FloatArray
    focal: FloatArray
    bend: FloatArray
    distortion_by_kappa: float
    curve: RadialLensCurve | None = None

    @classmethod
    def of(cls, vectors: FloatArray, half_diagonal: float) -> Lens:
        """Take apart vectors (B, 11) or (B, 13); half the picture's diagonal in solver px."""
        rotation = rotation_matrices(vectors)
        linear = np.empty((len(vectors), 3, 4))
        linear[:, :, :3] = rotation
        linear[:, :, 3] = -(rotation @ vectors[:, POSITION_SLICE, None])[:, :, 0]
        focal = np.exp(vectors[:, LOG_FOCAL])
        linear[:, :2] *= focal[:, None, None]
        distortion_by_kappa = 1 / half_diagonal**2
        bend = vectors[:, KAPPA : KAPPA + 1] * distortion_by_kappa
        curve = _lens_curve_of(vectors, half_diagonal) if is_wide_angle(vectors) else None
        return cls(vectors, rotation, linear, focal, bend, distortion_by_kappa, curve)

    def undistorted(self, points: FloatArray, bent: NDArray[np.bool_] | None = None) -> FloatArray:
        """(2, N) or (B, 2, N) solver px -> (B, 2, N) where a lens without distortion would show
        them; of those not in ``bent`` (B,) nothing is to be said but that.

        In closed form: the cubic r (1 + bend r^2) = distance has one real root for bend >= 0; for
        bend < 0 the smallest positive one counts. What such a lens does not show, farther out than
        it reaches, is taken for lying at the edge of what it does.
        """
        around = points - self.vectors[:, PRINCIPAL_X : PRINCIPAL_Y + 1, None]
        around[:, 0] /= 1 + self.vectors[:, ASPECT, None]
        if self.curve is not None:
            distance = np.sqrt(np.maximum((around * around).sum(axis=1), _TINY))
            around *= (self.curve.undistorted(distance) / distance)[:, None]
            return around
        if not self.bend.any():
            return around
        size = np.maximum(np.abs(self.bend), 1e-18)
        squares = np.einsum("bkn,bkn->bn", around, around)
        distance = np.sqrt(np.maximum(squares, _TINY))
        reach = np.sqrt(6.75 * size) * distance
        radius = np.sinh(np.arcsinh(reach) / 3)
        barrel = self.bend[:, 0] < 0
        if barrel.any():
            radius[barrel] = np.sin(np.arcsin(np.minimum(reach[barrel], 1.0)) / 3)
        radius *= 2 / np.sqrt(3 * size)
        radius /= distance
        if bent is not None:
            radius[~bent] = 1.0
        around *= radius[:, None]
        return around

    def is_beyond_fold(self, world: FloatArray) -> NDArray[np.bool_] | None:
        """(B, 3, N) metres, in front of the cameras -> (B, N) whether a point lies so far out that
        barrel distortion would fold it back among others; None if no lens folds."""
        if self.curve is not None:
            place = self.linear[:, :, :3] @ world + self.linear[:, :, 3:]
            depth = np.where(np.abs(place[:, 2]) > _TINY, place[:, 2], _TINY)
            return self.curve.beyond((place[:, :2] ** 2).sum(axis=1) / depth**2)
        if not (self.bend < 0).any():
            return None
        place = self.linear[:, :, :3] @ world + self.linear[:, :, 3:]
        squares = (place[:, :2] ** 2).sum(axis=1)
        return np.asarray(-3 * self.bend * squares >= place[:, 2] ** 2)


def project(
    lens: Lens, world: FloatArray, along: FloatArray, free: int
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Project points and differentiate by the camera's parameters.

    Args:
        world: (B or 1, 3, N) metres, in front of the cameras.
        along: (B or 1, 3, N) a direction at each point, metres.
        free: derivatives by the first so many parameters; 0 for none, else at least those of P.

    Returns:
        (B, 2, N) solver px; (B, 2, N) px that a step of ``along`` moves each point; (B, free, 2, N)
        derivatives.
    """
    linear, vectors, curve = lens.linear, lens.vectors, lens.curve
    place = linear[:, :, :3] @ world
    place += linear[:, :, 3:]
    depth = place[:, 2:]
    v = place[:, :2] / depth
    toward = linear[:, :, :3] @ along
    moved = toward[:, :2] - v * toward[:, 2:]
    moved /= depth
    bends = curve is not None or lens.bend.any()
    bent = v
    if bends or free > KAPPA:
        squares = np.einsum("bkn,bkn->bn", v, v)
    if bends:
        # d(v grown) = grown dv + slope v (v . dv)
        grown, slope = (
            (1 + lens.bend * squares, 2 * lens.bend) if curve is None else curve.growth(squares)
        )
        twice = slope[:, None] * v
        bent = v * grown[:, None]
        moved = moved * grown[:, None] + twice * np.einsum("bkn,bkn->bn", moved, v)[:, None]
    derivatives = np.empty((len(vectors), free, 2, v.shape[2]))
    if free:
        # Derivatives of the undistorted pixel v, then through the lens; in one place if none bends.
        inner = np.empty((len(vectors), 7, 2, v.shape[2])) if bends else derivatives[:, :KAPPA]
        _undistorted_derivatives(lens, v, depth, inner)
        if bends:
            radial = np.einsum("bpkn,bkn->bpn", inner, v)
            np.multiply(inner, grown[:, None, None], out=derivatives[:, :7])
            derivatives[:, :7] += twice[:, None] * radial[:, :, None]
    pixels, stretch = bent, 1 + vectors[:, ASPECT, None]
    if vectors[:, ASPECT : PRINCIPAL_Y + 1].any():
        pixels = bent.copy()
        pixels[:, 0] *= stretch
        pixels += vectors[:, PRINCIPAL_X : PRINCIPAL_Y + 1, None]
        moved[:, 0] *= stretch
    if free and curve is not None and curve.fisheye:
        # A ray's angle is the same at every focal length.
        derivatives[:, LOG_FOCAL] = bent
    if free > KAPPA:
        first, second = (
            (squares * lens.distortion_by_kappa, None)
            if curve is None
            else curve.by_coefficients(squares)
        )
        derivatives[:, KAPPA] = v * first[:, None]
        if free > ASPECT:
            _image_derivatives(derivatives, bent, stretch)
        if free > SECOND_KAPPA and second is not None:
            derivatives[:, SECOND_KAPPA] = v * second[:, None]
            derivatives[:, SECOND_KAPPA, 0] *= stretch
    return pixels, moved, derivatives


def project_visible(lens: Lens, world: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
    """(3, N) metres -> (B, 2, N) solver px, and (B, N) whether each camera shows the point; the
    pixels of others are meaningless."""
    shown = (lens.linear[:, 2, :3] @ world + lens.linear[:, 2, 3:]) > MIN_DEPTH_M
    beyond = lens.is_beyond_fold(world[None])
    if beyond is not None:
        shown &= ~beyond
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        px, _, _ = project(lens, world[None], np.zeros((1, *world.shape)), 0)
    return px, shown


def _undistorted_derivatives(
    lens: Lens, v: FloatArray, depth: FloatArray, found: FloatArray
) -> None:
    """Fill in (B, 7, 2, N) what pose and focal length do to undistorted pixels ``v`` (B, 2, N) of
    points at a ``depth`` (B, 1, N)."""
    _rotation_derivatives(lens, v, found[:, PAN : ROLL + 1])
    by_centre = found[:, POSITION_SLICE]
    np.multiply(lens.linear[:, 2, :3, None, None], v[:, None], out=by_centre)
    by_centre -= lens.linear[:, :2, :3].transpose(0, 2, 1)[:, :, :, None]
    by_centre /= depth[:, None]
    found[:, LOG_FOCAL] = v


def _image_derivatives(derivatives: FloatArray, bent: FloatArray, stretch: FloatArray) -> None:
    """Fill in what aspect ratio and principal point do to pixels, and stretch all else."""
    derivatives[:, :ASPECT, 0] *= stretch[:, None]
    derivatives[:, ASPECT:] = 0.0
    derivatives[:, ASPECT, 0] = bent[:, 0]
    derivatives[:, PRINCIPAL_X, 0] = 1.0
    derivatives[:, PRINCIPAL_Y, 1] = 1.0


def _lens_curve_of(vectors: FloatArray, half_diagonal: float) -> RadialLensCurve:
    fisheye = is_fisheye(vectors)
    unit = np.full((len(vectors), 1), half_diagonal)
    if fisheye:
        unit = np.exp(vectors[:, LOG_FOCAL : LOG_FOCAL + 1])
    first, second = vectors[:, KAPPA : KAPPA + 1], vectors[:, SECOND_KAPPA : SECOND_KAPPA + 1]
    return RadialLensCurve(first, second, unit, fisheye)


def _rotation_derivatives(lens: Lens, v: FloatArray, found: FloatArray) -> None:
    """Fill in (B, 3, 2, N): the undistorted pixel's derivative by pan, tilt and roll.

    Each angle turns the camera about an axis that is fixed in its own frame: pan about the world's
    vertical, tilt about the level to the right, roll about the view. Points turn the other way.
    """
    count, roll, focal = len(v), lens.vectors[:, ROLL], lens.focal[:, None]
    axes = np.zeros((count, 3, 3))  # (B, angle, axis component)
    axes[:, 0] = lens.rotation[:, :, 2]
    axes[:, 1, 0] = np.cos(roll)
    axes[:, 1, 1] = -np.sin(roll)
    axes[:, 2, 2] = 1.0
    by_axis = np.empty((count, 3, 2, v.shape[2]))
    x, y = v[:, 0], v[:, 1]
    np.multiply(x, y, out=by_axis[:, 0, 0])
    by_axis[:, 0, 0] /= focal
    np.negative(by_axis[:, 0, 0], out=by_axis[:, 1, 1])
    squares = v * v
    squares /= focal[:, None]
    squares += focal[:, None]
    by_axis[:, 0, 1] = squares[:, 1]
    np.negative(squares[:, 0], out=by_axis[:, 1, 0])
    by_axis[:, 2, 0] = y
    np.negative(x, out=by_axis[:, 2, 1])
    np.matmul(axes, by_axis.reshape(count, 3, -1), out=found.reshape(count, 3, -1))
