"""Uncertainty of ground points seen in the image, and error ellipses of projected points."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.calibration.optimization.covariance import max_direction_sd
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.backprojection import projection_jacobian
from procc_annotator.camera.base import Camera
from procc_annotator.errors import UsageError
from procc_annotator.field.geometry import Covariance, Vector
from procc_annotator.field.model import Field
from procc_annotator.metrics.error_maps import MapSummary, area_share_within, map_summary
from procc_annotator.metrics.ground_plane import GroundRectangle, field_rectangle

ELLIPSE_SCALE_95 = math.sqrt(-2 * math.log(0.05))
"""Standard deviations that hold 95 % of a normal distribution in the plane."""


@dataclass(frozen=True, eq=False)
class ErrorEllipse:
    """An ellipse in a picture.

    Attributes:
        centre_px: (2,) px.
        semi_axes_px: the longer and the shorter one, px.
        angle_rad: from the picture's x axis towards its y axis (down) to the longer one.
    """

    centre_px: FloatArray
    semi_axes_px: tuple[float, float]
    angle_rad: float

    def outline(self, count: int = 48) -> FloatArray:
        """(count + 1, 2) px, closed."""
        turn = np.linspace(0.0, 2 * math.pi, count + 1)
        a, b = self.semi_axes_px
        cosine, sine = math.cos(self.angle_rad), math.sin(self.angle_rad)
        x, y = a * np.cos(turn), b * np.sin(turn)
        points = np.column_stack((cosine * x - sine * y, sine * x + cosine * y)) + self.centre_px
        points[-1] = points[0]
        return np.asarray(points)


def project_error_ellipses(
    camera: Camera,
    positions: Sequence[Vector],
    covariances: Sequence[Covariance | None],
    *,
    camera_covariances: FloatArray | None = None,
) -> list[ErrorEllipse | None]:
    """Return where a view shows places, to first order.

    Args:
        camera: of the view, px.
        positions: N places, metres, world frame.
        covariances: (3, 3) m^2 of each; None for one that is taken as exact.
        camera_covariances: (N, 2, 2) px^2 of the camera's own uncertainty there, where it is known;
            NaN counts as none.

    Returns:
        N ellipses that hold 95 %; None for places that the camera does not show.
    """
    if not positions:
        return []
    px, slopes = projection_jacobian(camera, np.array(positions))
    finite = np.isfinite(np.hstack((px, slopes.reshape(-1, 6)))).all(axis=1)
    shown: BoolArray = np.asarray(finite, dtype=bool)
    known = np.array([np.zeros((3, 3)) if c is None else np.array(c) for c in covariances])
    slopes = np.where(shown[:, None, None], slopes, 0.0)
    spread = slopes @ known @ slopes.transpose(0, 2, 1)
    if camera_covariances is not None:
        spread = spread + np.where(np.isfinite(camera_covariances), camera_covariances, 0.0)
    values, vectors = np.linalg.eigh(spread)
    axes = ELLIPSE_SCALE_95 * np.sqrt(np.maximum(values, 0.0))
    angles = np.arctan2(vectors[:, 1, 1], vectors[:, 0, 1])
    return [
        ErrorEllipse(centre, (float(pair[1]), float(pair[0])), float(angle)) if seen else None
        for centre, pair, angle, seen in zip(px, axes, angles, shown, strict=True)
    ]


ACCURACY_LEVELS_M = (0.1, 0.5, 1.0)
"""Standard deviations on the ground that a map tells apart, metres."""

_GRID_STEP_M = 1.0
_MIN_GRID_STEPS = 60  # across what is in sight, however little of the field that is
_BORDER_TOLERANCE_PX = 0.5  # pixels are unit squares around their centres


@dataclass(frozen=True, eq=False)
class GroundUncertainty:
    """Uncertainty of the ground under a fit, over the part of the field that is in sight.

    A standard deviation is that in the worst direction, from the camera's uncertainty alone: what
    a click or a detection is off by comes on top.

    Attributes:
        fit: what it was taken from.
        xs_m, ys_m: (w,), (h,) metres, world frame: where the map is sampled, evenly.
        points_px: (h, w, 2) px of the fit's picture: where the samples appear; NaN where the camera
            does not show them.
        sd_m: (h, w) metres: standard deviation of the ground point that the pixel there means; also
            of the samples next to those in sight, NaN elsewhere.
        in_sight: (h, w) whether the picture shows the sample.
    """

    fit: FitResult
    xs_m: FloatArray
    ys_m: FloatArray
    points_px: FloatArray
    sd_m: FloatArray
    in_sight: BoolArray

    @cached_property
    def statistics(self) -> MapSummary:
        """Least, median and largest standard deviation over the field in sight, metres."""
        return map_summary(self._counted, self._areas)

    def share_within_m(self, metres: float) -> float | None:
        """The share of the field in sight with a standard deviation up to that, in [0, 1]; None
        where nothing of the field is in sight."""
        return area_share_within(self._counted, self._areas, metres)

    @cached_property
    def distance_to_border_px(self) -> FloatArray:
        """(h, w) px by which a sample is inside the picture's border, below 0 outside."""
        width, height = self.fit.size
        right_bottom = np.array([width, height]) - 1 + _BORDER_TOLERANCE_PX
        margins = np.minimum(self.points_px + _BORDER_TOLERANCE_PX, right_bottom - self.points_px)
        return np.asarray(margins.min(axis=2))

    @cached_property
    def _counted(self) -> FloatArray:
        return np.where(self.in_sight, self.sd_m, np.nan)

    @cached_property
    def _areas(self) -> FloatArray:
        """(h, w) m²: the part of the map nearest to each sample."""
        return np.outer(_sample_lengths(self.ys_m), _sample_lengths(self.xs_m))


def ground_sd(fit: FitResult, ground: FloatArray, *, click_px: float = 0.0) -> FloatArray:
    """(N,) metres: the standard deviation in the worst direction, the square root of the larger
    eigenvalue of `FitResult.ground_covariance`; NaN likewise."""
    return max_direction_sd(fit.ground_covariance(ground, pixel_sd=click_px))


def map_ground_uncertainty(fit: FitResult, field: Field) -> GroundUncertainty:
    """Map how surely a fit, of any model, knows the field's ground.

    Samples are at most a metre apart, closer where little of the field is in sight. Off the field's
    rectangle there are none, so nothing above the horizon or behind the camera counts.

    Raises:
        UsageError: the fit has no camera, or the field nothing on the ground.
    """
    if fit.camera is None:
        raise UsageError(f"there is no camera: {fit.failure}")
    xs, ys = _visible_grid_axes(fit.camera, fit.size, field_rectangle(field))
    px, shown, in_sight = _project_grid(fit.camera, fit.size, xs, ys)
    counts = _dilate_mask(in_sight) & shown
    x, y = np.meshgrid(xs, ys)
    sd = np.full(counts.shape, np.nan)
    sd[counts] = ground_sd(fit, np.column_stack((x[counts], y[counts])))
    return GroundUncertainty(fit, xs, ys, px, sd, in_sight)


def _visible_grid_axes(
    camera: Camera, size: tuple[int, int], rectangle: GroundRectangle
) -> tuple[FloatArray, FloatArray]:
    """(w,), (h,) metres: an even grid over as much of the rectangle as is in sight."""
    xs = _even_axis(rectangle.left, rectangle.right, 1)
    ys = _even_axis(rectangle.top, rectangle.bottom, 1)
    near = _dilate_mask(_project_grid(camera, size, xs, ys)[2])
    if not near.any():
        return xs, ys
    (top, bottom), (left, right) = (np.flatnonzero(near.any(axis=k))[[0, -1]] for k in (1, 0))
    return (
        _even_axis(xs[left], xs[right], _MIN_GRID_STEPS),
        _even_axis(ys[top], ys[bottom], _MIN_GRID_STEPS),
    )


def _even_axis(low: float, high: float, fewest: int) -> FloatArray:
    return np.linspace(low, high, max(fewest, int(np.ceil((high - low) / _GRID_STEP_M))) + 1)


def _project_grid(
    camera: Camera, size: tuple[int, int], xs: FloatArray, ys: FloatArray
) -> tuple[FloatArray, BoolArray, BoolArray]:
    """(h, w, 2) px of a grid on the ground, NaN where the camera shows none; (h, w) whether it
    does; (h, w) whether inside the picture."""
    x, y = np.meshgrid(xs, ys)
    world = np.column_stack((x.ravel(), y.ravel(), np.zeros(x.size)))
    px, shown = camera.project(world)
    shown = shown & np.isfinite(px).all(axis=1)
    px = np.where(shown[:, None], px, np.nan)
    limits = np.array(size) - 1 + _BORDER_TOLERANCE_PX
    inside = shown & ((px >= -_BORDER_TOLERANCE_PX) & (px <= limits)).all(axis=1)
    return px.reshape(*x.shape, 2), shown.reshape(x.shape), inside.reshape(x.shape)


def _dilate_mask(mask: BoolArray) -> BoolArray:
    padded = np.pad(mask, 1)
    rows = padded[:-2] | padded[1:-1] | padded[2:]
    return np.asarray(rows[:, :-2] | rows[:, 1:-1] | rows[:, 2:])


def _sample_lengths(samples: FloatArray) -> FloatArray:
    """Return what each sample stands for, metres; the first and the last are at the border."""
    middles = (samples[1:] + samples[:-1]) / 2
    return np.diff(np.concatenate((samples[:1], middles, samples[-1:])))
