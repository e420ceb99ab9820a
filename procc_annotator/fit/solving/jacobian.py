"""Projection with one radial coefficient and its derivatives, for B pinhole cameras at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.models import (
    ASPECT,
    CENTRE,
    KAPPA,
    LOG_FOCAL,
    PAN,
    PRINCIPAL_X,
    PRINCIPAL_Y,
    ROLL,
    TILT,
    X,
    Z,
    rotations,
)
from procc_annotator.fit.solving.observations import FloatArray

_TINY = 1e-12


@dataclass(frozen=True, eq=False)
class Lens:
    """B cameras, taken apart.

    Attributes:
        vectors: (B, 11) parameters.
        rotation: (B, 3, 3) world -> camera.
        linear: (B, 3, 4) world -> undistorted pixels times depth.
        bend: (B, 1) kappa / h^2.
        bend_by_kappa: 1 / h^2.
    """

    vectors: FloatArray
    rotation: FloatArray
    linear: FloatArray
    bend: FloatArray
    bend_by_kappa: float

    @classmethod
    def of(cls, vectors: FloatArray, half_diagonal: float) -> Lens:
        """Take apart.

        Args:
            vectors: (B, 11).
            half_diagonal: half the picture's diagonal, solver px.
        """
        rotation = rotations(vectors)
        linear = np.empty((len(vectors), 3, 4))
        linear[:, :, :3] = rotation
        linear[:, :, 3] = -(rotation @ vectors[:, CENTRE, None])[:, :, 0]
        linear[:, :2] *= np.exp(vectors[:, LOG_FOCAL])[:, None, None]
        bend_by_kappa = 1 / half_diagonal**2
        bend = vectors[:, KAPPA : KAPPA + 1] * bend_by_kappa
        return cls(vectors, rotation, linear, bend, bend_by_kappa)

    def undistorted(self, points: FloatArray) -> FloatArray:
        """(2, N) solver px -> (B, 2, N) where a lens without distortion would show them.

        In closed form: the cubic r (1 + bend r^2) = distance has one real root for bend >= 0; for
        bend < 0 the smallest positive one counts. What such a lens does not show, farther out than
        it reaches, is taken for lying at the edge of what it does.
        """
        around = np.empty((len(self.vectors), 2, points.shape[1]))
        around[:, 0] = points[0] - self.vectors[:, PRINCIPAL_X, None]
        around[:, 0] /= 1 + self.vectors[:, ASPECT, None]
        around[:, 1] = points[1] - self.vectors[:, PRINCIPAL_Y, None]
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
        around *= (radius / distance)[:, None]
        return around

    def beyond_fold(self, world: FloatArray) -> NDArray[np.bool_] | None:
        """(B, 3, N) metres, in front of the cameras -> (B, N) whether a point lies so far out that
        barrel distortion would fold it back among others; None if no lens folds."""
        if not (self.bend < 0).any():
            return None
        place = self.linear[:, :, :3] @ world + self.linear[:, :, 3:]
        squares = (place[:, :2] ** 2).sum(axis=1)
        return np.asarray(-3 * self.bend * squares >= place[:, 2] ** 2)


@dataclass(frozen=True, eq=False)
class Shown:
    """N points as B cameras show them, and how that changes.

    Attributes:
        lens: the cameras.
        plain: (B, 2, N) solver px, as a lens without distortion would show them.
        depth: (B, 1, N) metres.
        squares: (B, 1, N) px^2: those of the distances of ``plain`` from the principal point.
        grown: (B, 1, N) how many times as far out distortion shows them; None where none bends.
        bent: (B, 2, N) solver px from the principal point, before the aspect ratio.
    """

    lens: Lens
    plain: FloatArray
    depth: FloatArray
    squares: FloatArray
    grown: FloatArray | None
    bent: FloatArray

    @classmethod
    def by(cls, lens: Lens, world: FloatArray) -> Shown:
        """Show (B, 3, N) or (1, 3, N) places, metres, in front of the cameras."""
        place = lens.linear[:, :, :3] @ world + lens.linear[:, :, 3:]
        depth = place[:, 2:]
        plain = place[:, :2] / depth
        squares = (plain * plain).sum(axis=1, keepdims=True)
        if not lens.bend.any():
            return cls(lens, plain, depth, squares, None, plain)
        grown = 1 + lens.bend[:, None] * squares
        return cls(lens, plain, depth, squares, grown, plain * grown)

    @property
    def pixels(self) -> FloatArray:
        """(B, 2, N) solver px."""
        vectors = self.lens.vectors
        found = self.bent + vectors[:, PRINCIPAL_X : PRINCIPAL_Y + 1, None]
        found[:, 0] += vectors[:, ASPECT, None] * self.bent[:, 0]
        return np.asarray(found)

    def moved(self, along: FloatArray) -> FloatArray:
        """(B, 2, N) solver px that a step of (B, 3, N) metres moves each point, to first order."""
        toward = self.lens.linear[:, :, :3] @ along
        found = (toward[:, :2] - self.plain * toward[:, 2:]) / self.depth
        if self.grown is not None:
            # d(v grown) = grown dv + 2 bend v (v . dv)
            outward = 2 * self.lens.bend[:, None] * (found * self.plain).sum(axis=1, keepdims=True)
            found = found * self.grown + outward * self.plain
        found[:, 0] *= 1 + self.lens.vectors[:, ASPECT, None]
        return np.asarray(found)

    def slopes(self, rows: FloatArray, free: int) -> FloatArray:
        """How combinations of the pixel's coordinates change with the first parameters.

        The combination goes back through the lens first, and then through what the pose does to a
        pixel, so that nothing is differentiated that does not count.

        Args:
            rows: (B, 2, 2, N) two combinations a point: factors of x and y in the second axis of 2.
            free: n, derivatives by the first so many parameters.

        Returns:
            (B, n, 2, N).
        """
        lens, vectors = self.lens, self.lens.vectors
        count, total = len(vectors), self.plain.shape[2]
        x, y = self.plain[:, 0, None], self.plain[:, 1, None]  # (B, 1, N), as for both rows
        by_x, by_y = rows[:, :, 0] * (1 + vectors[:, ASPECT, None, None]), rows[:, :, 1]
        outward = by_x * x + by_y * y
        found = np.empty((count, free, 2, total))
        if free > KAPPA:
            found[:, KAPPA] = outward * (self.squares * lens.bend_by_kappa)
        if free > ASPECT:
            found[:, ASPECT] = rows[:, :, 0] * self.bent[:, 0, None]
            found[:, PRINCIPAL_X : PRINCIPAL_Y + 1] = rows.transpose(0, 2, 1, 3)
        if self.grown is not None:
            twice = 2 * lens.bend[:, None] * outward
            by_x = by_x * self.grown + twice * x
            by_y = by_y * self.grown + twice * y
            outward = by_x * x + by_y * y
        focal = np.exp(vectors[:, LOG_FOCAL])[:, None, None]
        # By turns about the camera's own axes, and by steps along them but for the focal length.
        of_pose = np.empty((count, 6, 2, total))
        each = outward / focal
        np.add(by_y * focal, y * each, out=of_pose[:, 0])
        np.add(by_x * -focal, -x * each, out=of_pose[:, 1])
        np.subtract(by_x * y, by_y * x, out=of_pose[:, 2])
        of_pose[:, 3], of_pose[:, 4], of_pose[:, 5] = by_x, by_y, outward
        of_pose[:, 3:] /= self.depth[:, None]
        found[:, LOG_FOCAL] = outward
        flat = found.reshape(count, free, -1)
        np.matmul(_pose_axes(lens), of_pose.reshape(count, 6, -1), out=flat[:, : Z + 1])
        return found


def _pose_axes(lens: Lens) -> FloatArray:
    """(B, 6, 6): pan, tilt, roll and the centre, in the terms of `Shown.slopes`.

    Each angle turns the camera about an axis that is fixed in its own frame: pan about the world's
    vertical, tilt about the level to the right, roll about the view. Points turn the other way.
    """
    vectors, linear = lens.vectors, lens.linear
    axes = np.zeros((len(vectors), 6, 6))
    axes[:, PAN, :3] = lens.rotation[:, :, 2]
    axes[:, TILT, 0] = np.cos(vectors[:, ROLL])
    axes[:, TILT, 1] = -np.sin(vectors[:, ROLL])
    axes[:, ROLL, 2] = 1.0
    axes[:, X:, 3:] = linear[:, :, :3].transpose(0, 2, 1)
    axes[:, X:, 3:5] *= -1.0
    return axes
