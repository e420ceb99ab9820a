"""Quantiles of the normal and of Student's distribution, without a library of statistics."""

from __future__ import annotations

import math
from functools import lru_cache
from statistics import NormalDist

import numpy as np

_NORMAL = NormalDist()
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(64)
_HALVINGS = 60


def normal_share(z: float) -> float:
    """The share of a normal distribution below ``z`` standard deviations."""
    return _NORMAL.cdf(z)


def normal_quantile(share: float) -> float:
    """The place, in standard deviations, below which a share in (0, 1) of it lies."""
    return _NORMAL.inv_cdf(share)


def student_share(t: float, freedom: float) -> float:
    """The share of Student's distribution below ``t``.

    Args:
        freedom: degrees of freedom, above 0, not necessarily whole.
    """
    # With t = sqrt(freedom) tan(angle) the density is a power of the cosine.
    half = math.atan(t / math.sqrt(freedom)) / 2
    constant = math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2))
    powers = np.cos(half * (_NODES + 1)) ** (freedom - 1)
    return 0.5 + constant / math.sqrt(math.pi) * half * float(_WEIGHTS @ powers)


@lru_cache(maxsize=512)
def student_quantile(share: float, freedom: float) -> float:
    """The place below which a share in (0, 1) of Student's distribution lies.

    Args:
        freedom: degrees of freedom, at least 1.
    """
    if share < 0.5:
        return -student_quantile(1 - share, freedom)
    low, high = 0.0, 1.0
    while student_share(high, freedom) < share:
        low, high = high, 2 * high
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if student_share(middle, freedom) < share else (low, middle)
    return (low + high) / 2
