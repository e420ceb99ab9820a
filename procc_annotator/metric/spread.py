"""Figures of a map: its spread, and how much of it is within a limit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.metric.polylines import FloatArray


@dataclass(frozen=True, slots=True)
class MapSummary:
    """Least, median and largest of a map over the area that counts; None where nothing counts."""

    minimum: float | None
    median: float | None
    maximum: float | None


def map_summary(values: FloatArray, areas: FloatArray) -> MapSummary:
    """The spread of a map.

    Args:
        values: any shape; NaN does not count.
        areas: of the same shape, above 0: what each value stands for.
    """
    counts = ~np.isnan(values)
    found, weights = values[counts], areas[counts]
    if not len(found):
        return MapSummary(None, None, None)
    order = np.argsort(found)
    found, weights = found[order], weights[order]
    # Each sample's weight is centred on it; with equal weights this is the usual median.
    position = np.cumsum(weights) - weights / 2
    median = float(np.interp(weights.sum() / 2, position, found))
    return MapSummary(float(found[0]), median, float(found[-1]))


def area_share_within(values: FloatArray, areas: FloatArray, limit: float) -> float | None:
    """The share of the area that counts with values up to a limit, in [0, 1].

    Args:
        values, areas: as for `spread`.
        limit: in the unit of the values.

    Returns:
        None where nothing counts.
    """
    counts = ~np.isnan(values)
    area = float(areas[counts].sum())
    if not area:
        return None
    return float(areas[counts & (values <= limit)].sum()) / area
