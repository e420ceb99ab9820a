"""Sample a field's elements into one flat array of world points."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.geometry import (
    Chain,
    Circle,
    Geometry,
    Line,
    Spot,
    angles_of,
    points_at_angles,
    is_closed,
)
from procc_annotator.field.model import Field

FloatArray = NDArray[np.float64]

STRAIGHT_SPACING_M = 0.9
CURVE_SPACING_M = 0.2
# The official spacing is one for large circles: of a basket's rim it would leave seven points. No
# curve that the official evaluation knows is so small that this reaches it.
_MAX_OFFICIAL_STEP_RAD = 0.1
_MAX_STEP_RAD = math.radians(15.0)


@dataclass(frozen=True, eq=False)
class FieldSamples:
    """Samples of all E elements; element i owns rows ``offsets[i]:offsets[i + 1]``.

    Attributes:
        names: (E,) class names, in the field's order.
        points_world: (N, 3) metres, world frame; read-only.
        offsets: (E + 1,) row at which each element starts; read-only.
        closed: (E,) whether the last sample repeats the first.
    """

    names: tuple[str, ...]
    points_world: FloatArray
    offsets: NDArray[np.intp]
    closed: NDArray[np.bool_]

    def of(self, i: int) -> FloatArray:
        """(n, 3) samples of the i-th element, metres."""
        return self.points_world[self.offsets[i] : self.offsets[i + 1]]


@lru_cache(maxsize=16)
def _official_cached(key: tuple[tuple[str, Geometry], ...]) -> FieldSamples:
    return _collect_samples(key, [_official_samples(geometry) for _, geometry in key], closed_curves=False)


def sample_official(field: Field) -> FieldSamples:
    """Samples at the spacing of the official SoccerNet evaluation, its uneven ends included.

    Straight elements: first end, then ``int(length / 0.9 - 1)`` points 0.9 m apart, then the second
    end. Circles: 0.2 m of arc apart (0.1 rad where that is less), not closed. Arcs: the same, then
    the exact end. Chains: part by part; spots: themselves.

    Args:
        field: E elements.

    Returns:
        N samples, metres; about a thousand for a large field.
    """
    return _official_cached(tuple((e.name, e.geometry) for e in field.elements))


def sample_evenly(field: Field, spacing_m: float) -> FieldSamples:
    """Evenly spaced samples, ends exact, circles closed (the last point equals the first).

    Args:
        field: E elements.
        spacing_m: largest distance between neighbours along the element, metres, positive. Curves
            turn by at most 15 degrees between two.

    Raises:
        ValueError: the spacing is not positive and finite.
    """
    if not (math.isfinite(spacing_m) and spacing_m > 0):
        raise ValueError(f"expected a positive spacing in metres, found {spacing_m!r}")
    key = tuple((e.name, e.geometry) for e in field.elements)
    return _collect_samples(key, [_even_samples(geometry, spacing_m) for _, geometry in key], closed_curves=True)


def _official_samples(geometry: Geometry) -> FloatArray:
    if isinstance(geometry, Chain):
        # Each part as if it stood alone; a joint is one sample.
        parts = [_official_samples(part) for part in geometry.parts]
        return np.concatenate([parts[0], *(part[1:] for part in parts[1:])])
    if isinstance(geometry, Spot):
        return np.array([geometry.position])
    if isinstance(geometry, Line):
        start, end = np.array(geometry.start), np.array(geometry.end)
        length = float(np.linalg.norm(end - start))
        steps = np.arange(1, int(length / STRAIGHT_SPACING_M - 1) + 1) * STRAIGHT_SPACING_M
        between = start + steps[:, None] * ((end - start) / length)
        return np.vstack([start, between, end])
    spacing = min(CURVE_SPACING_M, _MAX_OFFICIAL_STEP_RAD * geometry.radius)
    step = spacing / geometry.radius
    if isinstance(geometry, Circle):
        count = int(2 * math.pi * geometry.radius / spacing)
        angles: FloatArray = np.arange(count, dtype=np.float64) * step
    else:
        arc_length = (geometry.end_rad - geometry.start_rad) * geometry.radius
        inner = (
            geometry.start_rad + np.arange(int(arc_length / spacing) + 1, dtype=np.float64) * step
        )
        angles = np.append(inner, np.float64(geometry.end_rad))
    return points_at_angles(geometry, angles)


def _even_samples(geometry: Geometry, spacing_m: float) -> FloatArray:
    if isinstance(geometry, Chain):
        parts = [_even_samples(part, spacing_m) for part in geometry.parts]
        points = np.concatenate([parts[0], *(part[1:] for part in parts[1:])])
        if is_closed(geometry):
            points[-1] = points[0]
        return points
    if isinstance(geometry, Spot):
        return np.array([geometry.position])
    if isinstance(geometry, Line):
        start, end = np.array(geometry.start), np.array(geometry.end)
        gaps = max(1, math.ceil(float(np.linalg.norm(end - start)) / spacing_m - 1e-9))
        t = np.linspace(0.0, 1.0, gaps + 1)[:, None]
        return np.asarray(start * (1 - t) + end * t)
    first, last = angles_of(geometry)
    # A hoop is smaller than the spacing of long lines, and no triangle.
    fewest = max(3, math.ceil((last - first) / _MAX_STEP_RAD - 1e-9))
    gaps = max(fewest, math.ceil((last - first) * geometry.radius / spacing_m - 1e-9))
    points = points_at_angles(geometry, np.linspace(first, last, gaps + 1))
    if isinstance(geometry, Circle):
        points[-1] = points[0]
    return points


def _collect_samples(
    key: tuple[tuple[str, Geometry], ...], parts: list[FloatArray], *, closed_curves: bool
) -> FieldSamples:
    points = np.concatenate(parts) if parts else np.zeros((0, 3))
    offsets = np.cumsum([0, *(len(part) for part in parts)], dtype=np.intp)
    closed = np.array([closed_curves and is_closed(g) for _, g in key], dtype=bool)
    for array in (points, offsets, closed):
        array.setflags(write=False)
    return FieldSamples(tuple(name for name, _ in key), points, offsets, closed)
