"""Undistortion of pixels to viewing rays.

Lens models are given forwards only. Backwards, a table of the radial part gives a start that is off
by its linear interpolation, and Newton's method does the rest, to the last digits.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import BoolArray, FloatArray

Values = NDArray[np.float64]

_TABLE_NODES = 2048
_LENS_ITERATIONS = 30
_TABLE_MARGIN = 1.2
# Newton's method squares the error with each step: after one of this size less than 1e-10 is left.
_CONVERGED = 1e-6
# Points handled at once: the arrays of one round stay in the processor's cache.
_BLOCK_PIXELS = 8192


def fisheye_rays(
    x: Values,
    y: Values,
    radius_of: Callable[[Values], Values],
    slope_of: Callable[[Values], Values],
    largest_angle_rad: float,
) -> FloatArray:
    """(3, N) directions of a fisheye's image points at depth 1; NaN outside the model's domain.

    Args:
        x, y: (N,) distorted.
        radius_of: angle from the axis (rad) -> distorted radius. slope_of: its derivative.
        largest_angle_rad: where the model ends.
    """
    radius = np.hypot(x, y)
    table = _MonotonicTable(radius_of, slope_of, largest_angle_rad)
    theta = table.inverse(radius)
    # The step may have left the domain, and beyond it the model folds.
    theta[theta > largest_angle_rad * (1 + 1e-12)] = np.nan
    sine = np.sin(theta) / np.where(radius > 0, radius, 1.0)
    return np.array((x * sine, y * sine, np.cos(theta)))


def pinhole_rays(
    x: Values,
    y: Values,
    radial: Sequence[float],
    tangential: Sequence[float],
    thin_prism: Sequence[float],
) -> FloatArray:
    """(3, N) directions, of depth 1, of OpenCV's lens model without tilt; NaN outside its domain.

    Where the model folds, the part about the axis counts.

    Args:
        x, y: (N,) distorted, at depth 1.
        radial: k1..k6. tangential: p1, p2. thin_prism: s1..s4.
    """
    out = np.ones((3, len(x)))
    lens = _DistortionModel(radial, tangential, thin_prism)
    radius = np.hypot(x, y)
    finite = radius[np.isfinite(radius)]
    table = _MonotonicTable(
        lens.radial, lens.radial_slope, _bracket_radius(lens, float(finite.max(initial=0.0)))
    )
    for start in range(0, len(x), _BLOCK_PIXELS):
        part = slice(start, start + _BLOCK_PIXELS)
        inner = table.inverse(radius[part], polished=lens.only_radial)
        ratio = inner / np.where(radius[part] > 0, radius[part], 1.0)
        guess = x[part] * ratio, y[part] * ratio
        out[0, part], out[1, part] = (
            guess if lens.only_radial else lens.newton(x[part], y[part], *guess, table.limit)
        )
    return out


def _bracket_radius(lens: _DistortionModel, radius: float) -> float:
    """A radius in front of the lens at least as far out as a distorted one, if there is any."""
    reach = max(radius, 1e-6)
    for _ in range(12):
        if float(lens.radial(np.array([reach]))[0]) >= radius:
            break
        reach *= 1.5
    # The other terms of the model may pull a point a little further out.
    return _TABLE_MARGIN * reach


class _MonotonicTable:
    """A function of one variable with g(0) = 0, tabulated up to where it stops growing."""

    def __init__(
        self, function: Callable[[Values], Values], slope: Callable[[Values], Values], top: float
    ) -> None:
        self._function = function
        self._slope = slope
        nodes = np.linspace(0.0, top, _TABLE_NODES)
        values = function(nodes)
        grows = (slope(nodes) > 0) & np.isfinite(values)
        grows[1:] &= values[1:] > values[:-1]
        count = _TABLE_NODES if grows.all() else max(int(np.argmin(grows)), 1)
        self._nodes, self._values = nodes[:count], values[:count]
        self.top = float(self._nodes[-1])
        # Where the function turns, or infinity: beyond, another point would look alike.
        self.limit = float("inf") if count == _TABLE_NODES else float(nodes[count])

    def inverse(self, values: Values, *, polished: bool = True) -> Values:
        """(N,) arguments; NaN where the function has no such value before it turns."""
        # The other terms of a model may still bring a point back that lies a little beyond.
        most = self._values[-1] * (1.0 if polished else _TABLE_MARGIN)
        guess = np.interp(values, self._values, self._nodes)
        guess[~(values <= most)] = np.nan
        if not polished:
            return guess
        for _ in range(_LENS_ITERATIONS):
            step = (self._function(guess) - values) / self._slope(guess)
            guess -= step
            settled = np.abs(step) <= _CONVERGED * (1 + np.abs(guess))
            if (settled | np.isnan(guess)).all():
                break
            # Beyond the turning point nothing converges; those are not waited for.
            lost = ~((guess >= -1e-9) & (guess <= self.limit))
            guess[lost] = np.nan
        guess[~(settled & (guess <= self.limit))] = np.nan
        return np.asarray(guess, dtype=np.float64)


class _DistortionModel:
    """OpenCV's full distortion (without tilt) and its derivatives."""

    def __init__(
        self, radial: Sequence[float], tangential: Sequence[float], thin_prism: Sequence[float]
    ) -> None:
        self._k, self._p, self._s = radial, tangential, thin_prism
        self.only_radial = not (any(tangential) or any(thin_prism))

    def _factor(self, r2: Values) -> tuple[Values, Values]:
        """The radial factor f(r^2) and its derivative by r^2."""
        k1, k2, k3, k4, k5, k6 = self._k
        top = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        top_slope = k1 + r2 * (2 * k2 + r2 * (3 * k3))
        if not (k4 or k5 or k6):
            return np.asarray(top), np.asarray(top_slope)
        under = 1 + r2 * (k4 + r2 * (k5 + r2 * k6))
        under_slope = k4 + r2 * (2 * k5 + r2 * (3 * k6))
        f = top / under
        # Behind a pole the model starts anew; nothing of it counts.
        f = np.where(under > 0, f, np.nan)
        return np.asarray(f), np.asarray((top_slope - f * under_slope) / under)

    def radial(self, r: Values) -> Values:
        """Distorted radius."""
        return np.asarray(r * self._factor(r * r)[0])

    def radial_slope(self, r: Values) -> Values:
        r2 = r * r
        f, slope = self._factor(r2)
        return np.asarray(f + 2 * r2 * slope)

    def newton(
        self, xd: Values, yd: Values, x: Values, y: Values, limit: float
    ) -> tuple[Values, Values]:
        """Undistorted coordinates of distorted ones (xd, yd), from the start (x, y); or NaN."""
        done_x, done_y = np.full(len(x), np.nan), np.full(len(x), np.nan)
        active: NDArray[np.intp] | None = None  # all, at first
        for _ in range(_LENS_ITERATIONS):
            step_x, step_y, grows = self._step(xd, yd, x, y)
            x, y = x - step_x, y - step_y
            size2 = x * x + y * y
            step2 = step_x * step_x + step_y * step_y
            settled = step2 <= _CONVERGED**2 * (1 + size2)
            good = settled & grows & (size2 <= limit * limit)
            if active is None and good.all():
                return x, y
            places = np.arange(len(x)) if active is None else active
            done_x[places[good]], done_y[places[good]] = x[good], y[good]
            going = ~settled & (size2 <= 4 * limit * limit) & (step2 < 1e6)
            if not going.any():
                break
            active, x, y = places[going], x[going], y[going]
            xd, yd = xd[going], yd[going]
        return done_x, done_y

    def _step(
        self, xd: Values, yd: Values, x: Values, y: Values
    ) -> tuple[Values, Values, BoolArray]:
        p1, p2 = self._p
        s1, s2, s3, s4 = self._s
        xx, yy, xy = x * x, y * y, x * y
        r2 = xx + yy
        f, slope = self._factor(r2)
        off_x = x * f + 2 * p1 * xy + p2 * (r2 + 2 * xx) - xd
        off_y = y * f + p1 * (r2 + 2 * yy) + 2 * p2 * xy - yd
        twice = 2 * slope
        cross = twice * xy + 2 * (p1 * x + p2 * y)
        a = f + twice * xx + 2 * p1 * y + 6 * p2 * x
        d = f + twice * yy + 6 * p1 * y + 2 * p2 * x
        b = c = cross
        if s1 or s2:
            off_x += r2 * (s1 + s2 * r2)
            prism = 2 * (s1 + 2 * s2 * r2)
            a, b = a + x * prism, b + y * prism
        if s3 or s4:
            off_y += r2 * (s3 + s4 * r2)
            prism = 2 * (s3 + 2 * s4 * r2)
            c, d = c + x * prism, d + y * prism
        area = a * d - b * c
        grows: BoolArray = area > 0
        return (
            np.asarray((d * off_x - b * off_y) / area),
            np.asarray((a * off_y - c * off_x) / area),
            grows,
        )
