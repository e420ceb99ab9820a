"""Filled bands and level lines of a map, as polygons; for the picture and for the field."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np

from procc_annotator.metric.polylines import FloatArray, IntArray

if TYPE_CHECKING:
    from contourpy import ContourGenerator

Polygon = tuple[FloatArray, ...]
"""A closed outline and its holes, each (n, 2), the last point equal to the first."""

DISAGREEMENT_LEVELS_M = (0.0, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, math.inf)

OFFSIDE_ACCURACY_M = 0.5
"""The accuracy FIFA asks of offside technology, metres."""


@dataclass(frozen=True, eq=False)
class ContourBand:
    """The part of a map with values from ``low`` to ``high``.

    Attributes:
        low, high: levels; the last band's high may be infinite.
        polygons: outlines with their holes, in the coordinates of the map.
    """

    low: float
    high: float
    polygons: tuple[Polygon, ...]


def filled_contours(
    values: FloatArray, x: FloatArray, y: FloatArray, levels: Sequence[float]
) -> tuple[ContourBand, ...]:
    """The map's area between each two neighbouring levels.

    Args:
        values: (h, w); NaN is left blank.
        x, y: the places of the values: (w,) and (h,) for a grid along the axes, or both (h, w) for
            a bent one; they may be NaN where they are blank.
        levels: ascending, at least two; the last may be infinite. Values equal to the first belong
            to the first band.

    Returns:
        A band for each two neighbouring levels, with no polygon where the map has no such value.

    Raises:
        ValueError: levels that do not ascend, or arrays whose shapes do not fit.
    """
    if len(levels) < 2 or any(a >= b for a, b in itertools.pairwise(levels)):
        raise ValueError(f"levels must ascend and be at least two, not {tuple(levels)}")
    generator = _contour_generator(values, x, y)
    bands = []
    for i, (low, high) in enumerate(itertools.pairwise(levels)):
        # A band starts above its lower level, but for the first one, which has it.
        above = math.nextafter(low, -math.inf) if i == 0 else low
        polygons = () if generator is None else _band_polygons(generator, above, high)
        bands.append(ContourBand(float(low), float(high), polygons))
    return tuple(bands)


def contour_lines(
    values: FloatArray, x: FloatArray, y: FloatArray, level: float
) -> tuple[FloatArray, ...]:
    """Where the map has a value.

    Args:
        values, x, y: as for `filled_contours`.
        level: the value.

    Returns:
        Lines, each (n, 2); closed ones repeat their first point at the end.

    Raises:
        ValueError: arrays whose shapes do not fit.
    """
    generator = _contour_generator(values, x, y)
    if generator is None:
        return ()
    return tuple(np.asarray(line, dtype=np.float64) for line in generator.lines(float(level)))


def _contour_generator(values: FloatArray, x: FloatArray, y: FloatArray) -> ContourGenerator | None:
    """A generator over what is not blank; None where a map has no cell."""
    from contourpy import FillType, LineType, contour_generator

    values, x, y = (np.asarray(array, dtype=np.float64) for array in (values, x, y))
    if x.ndim == 1:
        x, y = np.meshgrid(x, y)
    if not values.shape == x.shape == y.shape:
        raise ValueError(f"shapes do not fit: {values.shape}, {x.shape}, {y.shape}")
    if min(values.shape) < 2:
        return None
    blank = ~(np.isfinite(values) & np.isfinite(x) & np.isfinite(y))
    return contour_generator(
        np.where(blank, 0.0, x),
        np.where(blank, 0.0, y),
        np.ma.array(np.where(blank, 0.0, values), mask=blank),
        name="serial",
        corner_mask=True,
        line_type=LineType.Separate,
        fill_type=FillType.OuterOffset,
    )


def _band_polygons(generator: ContourGenerator, low: float, high: float) -> tuple[Polygon, ...]:
    # As the fill type of `_contour_generator` says: the points of each polygon, and where outlines start.
    found = cast("tuple[list[FloatArray], list[IntArray]]", generator.filled(low, high))
    return tuple(
        tuple(np.asarray(outline[a:b], dtype=np.float64) for a, b in itertools.pairwise(cuts))
        for outline, cuts in zip(*found, strict=True)
    )
