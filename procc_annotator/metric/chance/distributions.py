"""Quantiles of the normal and of Student's distribution, without a library of statistics."""

from __future__ import annotations

import math
from functools import lru_cache
from statistics import NormalDist

import numpy as np

_STANDARD_NORMAL = NormalDist()
_QUADRATURE_NODES, _QUADRATURE_WEIGHTS = np.polynomial.legendre.leggauss(64)
_BISECTIONS = 60


def normal_cdf(z: float) -> float:
    """The share of a normal distribution below ``z`` standard deviations."""
    return _STANDARD_NORMAL.cdf(z)


def normal_ppf(share: float) -> float:
    """The place, in standard deviations, below which a share in (0, 1) of it lies."""
    return _STANDARD_NORMAL.inv_cdf(share)


def student_t_cdf(t: float, freedom: float) -> float:
    """The share of Student's distribution below ``t``.

    Args:
        freedom: degrees of freedom, above 0, not necessarily whole.
    """
    # With t = sqrt(freedom) tan(angle) the density is a power of the cosine.
    half = math.atan(t / math.sqrt(freedom)) / 2
    constant = math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2))
    powers = np.cos(half * (_QUADRATURE_NODES + 1)) ** (freedom - 1)
    return 0.5 + constant / math.sqrt(math.pi) * half * float(_QUADRATURE_WEIGHTS @ powers)


@lru_cache(maxsize=512)
def student_t_ppf(share: float, freedom: float) -> float:
    """The place below which a share in (0, 1) of Student's distribution lies.

    Args:
        freedom: degrees of freedom, at least 1.
    """
    if share < 0.5:
        return -student_t_ppf(1 - share, freedom)
    low, high = 0.0, 1.0
    while student_t_cdf(high, freedom) < share:
        low, high = high, 2 * high
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        low, high = (middle, high) if student_t_cdf(middle, freedom) < share else (low, middle)
    return (low + high) / 2
