"""How far out B lenses of two coefficients show what a lens without distortion shows at a distance.

One curve p(t) = t (1 + a t^2 + b t^4) serves two kinds of lens. A radial one shows what lies at t
half diagonals from the principal point at p(t) of them. A fisheye, OpenCV's with k3 = k4 = 0, shows
a ray at the angle t off the axis at p(t) focal lengths.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.observations import FloatArray

# Nearer to a right angle off the axis nothing of a field is seen; farther out than so many half
# diagonals no lens shows anything of the picture.
_MAX_ANGLE_RAD, _MAX_RADII = 1.5, 6.0
_NEWTON_STEPS = 20
_SERIES_RADIUS = 1e-3  # of the unit: nearer to the axis the curve is straight
_TINY = 1e-12


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
        """(B, 1) t up to which the curve rises; what lies beyond it would fold back."""
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
        """How an undistorted place v grows: g and w so that v appears at g v, and a small step dv
        of it at g dv + w v (v . dv).

        Args:
            squares: (B, N) of |v|, solver px squared.
        """
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
        """(B, N) whether what lies there undistorted is too far out to be shown."""
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
