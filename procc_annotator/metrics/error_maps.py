"""Maps over the image or the ground: camera disagreement, summary statistics, interpolation,
contours.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, cast

import numpy as np

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.camera.base import Camera, CameraOrProjections
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.metrics.ground_plane import (
    field_rectangle,
    ground_points_seen,
    require_camera_model,
)

if TYPE_CHECKING:
    from contourpy import ContourGenerator


@dataclass(frozen=True, slots=True)
class MapSummary:
    """Least, median and largest of a map over the area that counts; None where nothing counts."""

    minimum: float | None
    median: float | None
    maximum: float | None


def map_summary(values: FloatArray, areas: FloatArray) -> MapSummary:
    """The spread of a map of any shape; its values stand for areas above 0, NaN does not count."""
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
    """The share of the area that counts with values up to a limit, in [0, 1]; None where nothing
    counts. See `map_summary`."""
    counts = ~np.isnan(values)
    area = float(areas[counts].sum())
    if not area:
        return None
    return float(areas[counts & (values <= limit)].sum()) / area


def bilinear_value(
    values: FloatArray, xs: FloatArray, ys: FloatArray, x: float, y: float
) -> float | None:
    """A value at x, y between four samples, in proportion to its distances from them.

    Args:
        values: (h, w); NaN if absent.
        xs, ys: (w,), (h,) places of the samples, ascending, at least two each.

    Returns:
        None off the grid, and where a sample that counts has no value.
    """
    if not (xs[0] <= x <= xs[-1] and ys[0] <= y <= ys[-1]):
        return None
    column = min(int(np.searchsorted(xs, x, side="right")) - 1, len(xs) - 2)
    row = min(int(np.searchsorted(ys, y, side="right")) - 1, len(ys) - 2)
    across = (x - xs[column]) / (xs[column + 1] - xs[column])
    down = (y - ys[row]) / (ys[row + 1] - ys[row])
    corners = values[row : row + 2, column : column + 2]
    weights = np.outer((1 - down, down), (1 - across, across))
    value = float((np.where(weights > 0, corners, 0.0) * weights).sum())
    return None if np.isnan(value) else value


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
    """Return where the map has a value: lines (n, 2), closed ones repeat their first point at the
    end. For the arrays and errors see `filled_contours`."""
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
    # As the fill type of `_contour_generator` says: the points of each polygon, and where
    # outlines start.
    found = cast("tuple[list[FloatArray], list[IntArray]]", generator.filled(low, high))
    return tuple(
        tuple(np.asarray(outline[a:b], dtype=np.float64) for a, b in itertools.pairwise(cuts))
        for outline, cuts in zip(*found, strict=True)
    )


@dataclass(frozen=True, slots=True)
class DisagreementStatistics:
    """The spread of a disagreement in metres on the ground and in pixels of the picture."""

    metres: MapSummary
    pixels: MapSummary


@dataclass(frozen=True, eq=False)
class Disagreement:
    """Disagreement of two cameras, pixel by pixel.

    Attributes:
        size: (width, height) px of the picture.
        xs_px, ys_px: (w,), (h,) px: where the map is sampled, evenly from the first pixel's centre
            to the last one's.
        metres: (h, w) distance of the two ground points a pixel means; NaN where it does not count.
        pixels: (h, w) px: distance of the pixel to where b shows the ground point that a sees
            there; NaN likewise, and where b does not show that point.
        ground_a, ground_b: (h, w, 2) metres, world frame: what the pixel shows to each; NaN where
            it shows no ground.
    """

    size: tuple[int, int]
    xs_px: FloatArray = field(repr=False)
    ys_px: FloatArray = field(repr=False)
    metres: FloatArray = field(repr=False)
    pixels: FloatArray = field(repr=False)
    ground_a: FloatArray = field(repr=False)
    ground_b: FloatArray = field(repr=False)

    @cached_property
    def statistics(self) -> DisagreementStatistics:
        """Least, median and largest disagreement over the area that counts."""
        return DisagreementStatistics(
            map_summary(self.metres, self._areas), map_summary(self.pixels, self._areas)
        )

    def share_within(self, metres: float) -> float | None:
        """The share of the area that counts where they disagree by no more than that, in [0, 1]."""
        return area_share_within(self.metres, self._areas, metres)

    @cached_property
    def compared_share(self) -> float:
        """The share of the picture's area that counts, in [0, 1]."""
        return float(self._areas[~np.isnan(self.metres)].sum() / self._areas.sum())

    @cached_property
    def _areas(self) -> FloatArray:
        """(h, w) px²: the part of the picture nearest to each sample."""
        return np.outer(_sample_widths(self.ys_px), _sample_widths(self.xs_px))


def disagreement(
    a: CameraOrProjections,
    b: CameraOrProjections,
    field: Field,
    size: tuple[int, int],
    *,
    step_px: int = 4,
) -> Disagreement:
    """Compare two cameras over the picture.

    A pixel counts when both cameras see the ground there and at least one of the two ground points
    lies on the field's rectangle; above the horizon and off the field the maps are blank. The map
    in metres does not change when the cameras are exchanged; the one in pixels is taken in b's
    picture.

    Args:
        a, b: cameras of any model, in px of ``size``.
        size: (width, height) px.
        step_px: samples are at most that far apart; the picture's border is always sampled.

    Raises:
        UsageError: a source that shares only projections, a step below one pixel.
    """
    if step_px < 1:
        raise UsageError(f"the step must be at least 1 px, not {step_px}")
    xs, ys = (
        np.linspace(0.0, extent - 1.0, math.ceil((extent - 1) / step_px) + 1) for extent in size
    )
    shape = (len(ys), len(xs))
    points_px = np.empty((*shape, 2))
    points_px[..., 0] = xs
    points_px[..., 1] = ys[:, None]
    flat = points_px.reshape(-1, 2)
    a, b = require_camera_model(a), require_camera_model(b)
    ground_a, ground_b = ground_points_seen(a, flat), ground_points_seen(b, flat)
    rectangle = field_rectangle(field)
    apart = np.hypot(ground_a[:, 0] - ground_b[:, 0], ground_a[:, 1] - ground_b[:, 1])
    counts = np.isfinite(apart) & (rectangle.holds(ground_a) | rectangle.holds(ground_b))
    metres = np.where(counts, apart, np.nan)
    pixels = np.full(len(flat), np.nan)
    pixels[counts] = _transferred_px(b, ground_a[counts], flat[counts])
    return Disagreement(
        size,
        xs,
        ys,
        metres.reshape(shape),
        pixels.reshape(shape),
        ground_a.reshape(*shape, 2),
        ground_b.reshape(*shape, 2),
    )


def _sample_widths(samples: FloatArray) -> FloatArray:
    """Return what each sample stands for, px: pixels are unit squares around their centres."""
    edges = np.concatenate(
        ([samples[0] - 0.5], (samples[1:] + samples[:-1]) / 2, [samples[-1] + 0.5])
    )
    return np.diff(edges)


def _transferred_px(camera: Camera, ground: FloatArray, points_px: FloatArray) -> FloatArray:
    points_world = np.column_stack((ground, np.zeros(len(ground))))
    shown, valid = camera.project(points_world)
    off = shown - points_px
    moved = np.where(valid, np.hypot(off[:, 0], off[:, 1]), np.nan)
    return np.where(np.isfinite(moved), moved, np.nan)
