"""OpenCV coefficients closest to lenses that other programs describe by other functions."""

from __future__ import annotations

import numpy as np

from procc_annotator.arrays import FloatArray

_SAMPLES = 400
_WIDEST_RAD = 1.5  # from the axis: no lens of a field's camera sees more


def fisheye_of_polynomial(
    coefficients: FloatArray, radius: float
) -> tuple[float, FloatArray, FloatArray]:
    """The fisheye r = f (theta + k1 theta^3 + ... + k4 theta^9) closest to a radius that is any
    polynomial of the angle, in the least squares of all pixels.

    Args:
        coefficients: of the angle from the axis, rad, highest power first.
        radius: of the picture's farthest corner, in the unit of the polynomial.

    Returns:
        f; (4,) k1..k4; (N,) deviations of pixels within the radius, in its unit.

    Raises:
        ValueError: no angle within 1.5 rad reaches a twentieth of the radius.
    """
    theta = np.linspace(0, _WIDEST_RAD, 4 * _SAMPLES)[1:]
    r = np.polyval(coefficients, theta)
    falls = np.flatnonzero((np.diff(r) <= 0) | (r[1:] > radius))
    seen = slice(0, int(falls[0]) + 1 if len(falls) else len(r))
    theta, r = theta[seen], r[seen]
    if not r[-1] > radius / 20:
        raise ValueError("the polynomial of the lens does not grow with the angle")
    powers = theta[:, None] ** np.arange(1, 10, 2)
    weights = np.sqrt(np.maximum(r, 0.0))
    found = np.linalg.lstsq(powers * weights[:, None], r * weights, rcond=None)[0]
    of_pixels = np.sqrt(np.linspace(0, r[-1] ** 2, _SAMPLES))
    return float(found[0]), found[1:] / found[0], np.interp(of_pixels, r, powers @ found - r)


def distortion_of_inverse(
    up: FloatArray, down: FloatArray, radius: float
) -> tuple[FloatArray, FloatArray]:
    """The radial distortion closest to the inverse of r_u = r (1 + n1 r^2 + ...) / (1 + d1 r^2 +
    ...), r being the radius in the picture.

    Args:
        up, down: (3,) n1, n2, n3 and d1, d2, d3, for radii in focal lengths.

    Returns:
        (3,) k1, k2, k3; (N,) deviations within the radius, in focal lengths.
    """
    r = np.linspace(0, radius, _SAMPLES)[1:]
    even = r[:, None] ** np.array([2, 4, 6])
    with np.errstate(all="ignore"):
        undistorted = r * (1 + even @ up) / (1 + even @ down)
    powers = undistorted[:, None] ** np.array([3, 5, 7])
    if not np.isfinite(powers).all():
        raise ValueError("the distortion has no bounds within the picture")
    found = np.linalg.lstsq(powers, r - undistorted, rcond=None)[0]
    return found, powers @ found - (r - undistorted)
