"""How different two colours look."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# sRGB to XYZ under D65 (IEC 61966-2-1).
_XYZ_FROM_RGB = np.array(
    [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
)
_WHITE = np.array([0.9505, 1.0, 1.089])
_EPSILON, _KAPPA = 216 / 24389, 24389 / 27


def difference(one: str, other: str) -> float:
    """The distance of two colours ``#rrggbb`` in CIE L*a*b* (1976): about 2 can just be seen."""
    return float(np.linalg.norm(_lab(one) - _lab(other)))


def _lab(colour: str) -> NDArray[np.float64]:
    rgb = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    xyz = _XYZ_FROM_RGB @ linear / _WHITE
    x, y, z = np.where(xyz > _EPSILON, np.cbrt(xyz), (_KAPPA * xyz + 16) / 116)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])
