"""Where two cameras disagree: what each pixel means to them on the ground, metres apart."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from procc_annotator.camera.base import Camera, FloatArray
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.metric.ground import field_rectangle, ground_points_seen, require_camera_model
from procc_annotator.metric.spread import MapSummary, area_share_within, map_summary


@dataclass(frozen=True, slots=True)
class DisagreementStatistics:
    """The spread of a disagreement in metres on the ground and in pixels of the picture."""

    metres: MapSummary
    pixels: MapSummary


@dataclass(frozen=True, eq=False)
class Disagreement:
    """How far two cameras disagree, pixel by pixel.

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
    xs_px: FloatArray
    ys_px: FloatArray
    metres: FloatArray
    pixels: FloatArray
    ground_a: FloatArray
    ground_b: FloatArray

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
        field: the sports field.
        size: (width, height) px.
        step_px: samples are at most that far apart; the picture's border is always sampled.

    Raises:
        UsageError: a source that shares only projections, a step below one pixel.
    """
    if step_px < 1:
        raise UsageError(f"the step must be at least 1 px, not {step_px}")
    xs, ys = (_sample_positions(extent, step_px) for extent in size)
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


def _sample_positions(extent: int, step: int) -> FloatArray:
    return np.linspace(0.0, extent - 1.0, math.ceil((extent - 1) / step) + 1)


def _sample_widths(samples: FloatArray) -> FloatArray:
    """What each sample stands for, px: pixels are unit squares around their centres."""
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
