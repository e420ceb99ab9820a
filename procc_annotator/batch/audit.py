"""Per-frame audit of a method and the arrays behind its plots."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import IntArray
from procc_annotator.camera.base import CameraOrProjections
from procc_annotator.camera.models import FisheyeCamera, PinholeCamera
from procc_annotator.field.landmarks import element_titles
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts
from procc_annotator.metrics.measurement import Measurement, nearest_points
from procc_annotator.metrics.score import display_score, jac_curve

# Every threshold a slider can take, so that moving it computes nothing: 1.2 KB a frame.
TAU_GRID = np.round(np.arange(0.5, 30.05, 0.1), 1)


@dataclass(frozen=True, slots=True)
class Pose:
    """Position and direction of a camera; degrees, metres, px of the evaluation size."""

    pan_deg: float
    tilt_deg: float
    roll_deg: float
    focal_px: float
    position_world: tuple[float, float, float]


@dataclass(frozen=True, eq=False, slots=True)
class FrameAudit:
    """One frame under one camera source.

    n points are those of annotated classes that the camera shows, under the better labelling
    at the threshold the frame was audited at.

    Attributes:
        frame: its name.
        model: the camera's model, for people.
        jac: (T,) float32, JaC at each of `TAU_GRID`.
        class_rows: (n,) place of each point's class, as the annotator labelled it, in
            `element_titles`; -1 for one without geometry.
        points_px: (n, 2) float32 px of the evaluation size.
        residuals_px: (n, 2) float32, nearest projected position minus clicked point; NaN where
            the protocol gives a point no distance.
        pose: None for models without one (homographies, projections alone).
        mirrored: whether the better labelling is a mirrored one; not on a tie.
        fitted: whether the camera was fitted to the annotation it is judged by.
        counted_rows: (n,) as ``class_rows``, of the class that the better labelling counts the
            point for, which its JaC is that of; None where these are all the annotator's.
    """

    frame: str
    model: str
    jac: NDArray[np.float32]
    class_rows: NDArray[np.int16]
    points_px: NDArray[np.float32]
    residuals_px: NDArray[np.float32]
    pose: Pose | None
    mirrored: bool = False
    fitted: FitCounts = NOT_FITTED
    counted_rows: NDArray[np.int16] | None = None

    @property
    def errors_px(self) -> NDArray[np.float32]:
        """(n,) distances, px."""
        return np.hypot(self.residuals_px[:, 0], self.residuals_px[:, 1])

    def jac_at(self, tau: float) -> float:
        """JaC at the threshold of `TAU_GRID` nearest to ``tau``."""
        return float(self.jac[int(np.argmin(np.abs(TAU_GRID - tau)))])


def audit_frame(
    frame: str,
    camera: CameraOrProjections,
    model: str,
    measurement: Measurement,
    tau: float,
    *,
    fitted: FitCounts = NOT_FITTED,
) -> FrameAudit:
    """Keep what plots and reports need of a measured frame.

    The camera is in px of the evaluation size; ``tau`` (px) decides whether mirrored labels count,
    on a tie the labels as they are.
    """
    read = display_score(measurement, tau)
    labelling = read.labelling
    nearest = nearest_points(measurement, labelling)
    counts = np.array(labelling.point_counts, dtype=np.intp)
    starts = np.cumsum(counts) - counts
    kept = [i for i, feet in enumerate(nearest) if feet is not None]
    feet = [f for f in nearest if f is not None]
    points = [measurement.points_px[starts[i] : starts[i] + counts[i]] for i in kept]
    places = {name: i for i, name in enumerate(element_titles(measurement.setup.field))}
    rows, counted = (
        np.repeat(np.array([places.get(names[i], -1) for i in kept], dtype=np.int16), counts[kept])
        for names in (measurement.plain.names, labelling.names)
    )
    residuals = _concatenate_rows([f - p for f, p in zip(feet, points, strict=True)])
    # A foot is found where the protocol knows no distance, too.
    residuals[np.isnan(labelling.all_distances)] = np.nan
    return FrameAudit(
        frame,
        model,
        jac_curve(measurement, TAU_GRID).astype(np.float32),
        rows,
        _concatenate_rows(points),
        residuals,
        pose_in_degrees(camera),
        read.mirrored,
        fitted,
        counted if read.mirrored else None,
    )


def pose_in_degrees(camera: CameraOrProjections) -> Pose | None:
    """A camera's pose, or None for a model that has none."""
    if not isinstance(camera, PinholeCamera | FisheyeCamera):
        return None
    return Pose(
        math.degrees(camera.pan_rad),
        math.degrees(camera.tilt_rad),
        math.degrees(camera.roll_rad),
        camera.focal_px[0],
        camera.position_world,
    )


def _concatenate_rows(parts: list[NDArray[np.float64]]) -> NDArray[np.float32]:
    if not parts:
        return np.empty((0, 2), dtype=np.float32)
    return np.concatenate(parts).astype(np.float32)


FloatArray = NDArray[np.floating[Any]]

_BINS = 40
_WIDTHS = tuple(m * 10.0**e for e in range(-3, 5) for m in (1, 2, 2.5, 5))
_RADIUS_BINS = 20
_MANY = 60  # errors, the largest of which do not decide how far a histogram reaches
_FEWEST = 5  # points a median is taken from
_GRID = (16, 9)  # cells of the picture over which residuals of a set are summed up
_ROBUST = 1.4826  # a median absolute deviation times this is a standard deviation
_JUMP_DEVIATIONS = 8.0

POSE_QUANTITIES = ("pan", "tilt", "roll", "focal", "x", "y", "height")
POSE_UNITS = ("°", "°", "°", "px", "m", "m", "m")
# A change below this is no jump, however still the camera stands otherwise.
_SMALLEST_JUMP = np.array([0.5, 0.5, 0.5, 10.0, 0.5, 0.5, 0.5])


@dataclass(frozen=True, eq=False)
class PlotData:
    """Numbers as columns of equal length, for a file; NaN is undefined."""

    header: tuple[str, ...]
    columns: tuple[Sequence[Any] | NDArray[Any], ...]


@dataclass(frozen=True, eq=False)
class Points:
    """The points of several frames under one source, one after the other.

    Attributes:
        frames: (n,) position in ``names`` of each point's frame.
        names: the frames.
        class_rows, counted_rows: (n,) as in `FrameAudit`.
        points_px, residuals_px: (n, 2).
        errors_px: (n,).
        undefined: how many points had no distance and are left out.
    """

    names: tuple[str, ...]
    frames: IntArray
    class_rows: NDArray[np.int16]
    counted_rows: NDArray[np.int16]
    points_px: FloatArray
    residuals_px: FloatArray
    errors_px: FloatArray
    undefined: int


def gather(audits: Sequence[FrameAudit], class_row: int | None = None) -> Points:
    """The points with a distance of several frames.

    Args:
        audits: of one source.
        class_row: only points of this class of the field; None for all.
    """
    counts = [len(a.class_rows) for a in audits]
    frames = np.repeat(np.arange(len(audits), dtype=np.intp), counts)
    rows = _joined([a.class_rows for a in audits], np.empty(0, np.int16))
    every = [a.class_rows if a.counted_rows is None else a.counted_rows for a in audits]
    counted = _joined(every, np.empty(0, np.int16))
    points = _joined([a.points_px for a in audits], np.empty((0, 2), np.float32))
    residuals = _joined([a.residuals_px for a in audits], np.empty((0, 2), np.float32))
    if class_row is not None:
        chosen = rows == class_row
        frames, rows, counted = frames[chosen], rows[chosen], counted[chosen]
        points, residuals = points[chosen], residuals[chosen]
    errors = np.hypot(residuals[:, 0], residuals[:, 1])
    defined = np.isfinite(errors)
    return Points(
        tuple(a.frame for a in audits),
        frames[defined],
        rows[defined],
        counted[defined],
        points[defined],
        residuals[defined],
        errors[defined],
        int(len(errors) - np.count_nonzero(defined)),
    )


def mean_curve(audits: Sequence[FrameAudit]) -> FloatArray:
    """(T,) JaC over `TAU_GRID`, the mean of the frames; NaN where there are none."""
    if not audits:
        return np.full(len(TAU_GRID), np.nan)
    total = np.zeros(len(TAU_GRID))
    for audit in audits:
        total += audit.jac
    return total / len(audits)


# ------------------------------------------------------------------------------- errors


@dataclass(frozen=True, eq=False)
class Histogram:
    """Histogram of the errors of points.

    Attributes:
        edges: (b + 1,) px; the last bar holds everything from its lower edge on.
        counts: per source (b,).
        open_ended: whether errors beyond the last edge are in the last bar.
    """

    edges: FloatArray
    counts: tuple[IntArray, ...]
    open_ended: bool


def histogram(errors: Sequence[FloatArray]) -> Histogram:
    """Histograms of several sources' errors over the same round bars.

    Bars reach to what all but the largest fiftieth of the errors of every source stay below (all,
    where they are few); the last one holds the rest, so that every point is in one bar.
    """
    reach = max((_reach(e) for e in errors if len(e)), default=1.0)
    width = next((w for w in _WIDTHS if w * _BINS > reach), _WIDTHS[-1])
    bars = max(1, min(_BINS, math.floor(reach / width) + 1))
    edges = np.arange(bars + 1) * width
    largest = max((float(e.max()) for e in errors if len(e)), default=0.0)
    counts = tuple(
        np.bincount(
            np.minimum(np.searchsorted(edges, e, side="right") - 1, bars - 1), minlength=bars
        )
        for e in errors
    )
    return Histogram(edges, counts, largest >= edges[-1])


def _reach(errors: FloatArray) -> float:
    return float(errors.max() if len(errors) < _MANY else np.percentile(errors, 98))


@dataclass(frozen=True, eq=False)
class RadialErrors:
    """Error against the distance from the picture's centre.

    Attributes:
        radius, errors_px: (n,) every point.
        centres, medians: (m,) of bands of radius with enough points.
    """

    radius: FloatArray
    errors_px: FloatArray
    centres: FloatArray
    medians: FloatArray


def radius_of(points_px: FloatArray, size: tuple[int, int]) -> FloatArray:
    """(n,) distance from the picture's centre over half its diagonal: 1 in the corners."""
    half = np.array([(size[0] - 1) / 2, (size[1] - 1) / 2])
    off = points_px - half
    return np.asarray(np.hypot(off[:, 0], off[:, 1]) / np.hypot(half[0], half[1]), dtype=np.float64)


def radial_errors(points: Points, size: tuple[int, int]) -> RadialErrors:
    """Errors by radius, with the median of every twentieth of the way to the corner."""
    radius = radius_of(points.points_px, size)
    band = np.minimum((radius * _RADIUS_BINS).astype(np.intp), 2 * _RADIUS_BINS)
    order = np.argsort(band, kind="stable")
    bands, starts = np.unique(band[order], return_index=True)
    groups = np.split(points.errors_px[order], starts[1:]) if len(bands) else []
    kept = [i for i, group in enumerate(groups) if len(group) >= _FEWEST]
    return RadialErrors(
        radius,
        points.errors_px,
        (bands[kept] + 0.5) / _RADIUS_BINS,
        np.array([float(np.median(groups[i])) for i in kept]),
    )


# ---------------------------------------------------------------------------- residuals


@dataclass(frozen=True, eq=False)
class Arrows:
    """Residual vectors to draw over the picture.

    Attributes:
        at_px: (n, 2) where they begin: clicked points, or the middle of cells of the picture.
        vectors_px: (n, 2) residuals, or the cells' medians.
        counts: (n,) points each stands for.
    """

    at_px: FloatArray
    vectors_px: FloatArray
    counts: IntArray


def point_arrows(points: Points) -> Arrows:
    """One arrow a point."""
    return Arrows(points.points_px, points.residuals_px, np.ones(len(points.errors_px), np.intp))


def cell_arrows(points: Points, size: tuple[int, int]) -> Arrows:
    """The median residual, in x and in y, of cells of the picture with five points or more."""
    cells = np.array(_GRID)
    step = np.array([size[0], size[1]]) / cells
    cell = np.clip(((points.points_px + 0.5) // step).astype(np.intp), 0, cells - 1)
    number = cell[:, 1] * cells[0] + cell[:, 0]
    order = np.argsort(number, kind="stable")
    numbers, starts = np.unique(number[order], return_index=True)
    groups = np.split(points.residuals_px[order], starts[1:]) if len(numbers) else []
    kept = [i for i, group in enumerate(groups) if len(group) >= _FEWEST]
    numbers = numbers[kept]
    middle = (np.stack([numbers % cells[0], numbers // cells[0]], axis=1) + 0.5) * step - 0.5
    medians = np.array([np.median(groups[i], axis=0) for i in kept]).reshape(-1, 2)
    return Arrows(middle, medians, np.array([len(groups[i]) for i in kept], dtype=np.intp))


def bias(points: Points) -> tuple[float, float] | None:
    """The median residual in x and in y, px; None without points."""
    if not len(points.residuals_px):
        return None
    dx, dy = np.median(points.residuals_px, axis=0).tolist()
    return dx, dy


# ------------------------------------------------------------------------ over the frames


def timeline(frames: Sequence[str], audits: Mapping[str, FrameAudit], tau: float) -> FloatArray:
    """(F,) JaC at the threshold of `TAU_GRID` nearest to tau, NaN where there is no score."""
    column = int(np.argmin(np.abs(TAU_GRID - tau)))
    found = (audits.get(name) for name in frames)
    return np.array([np.nan if audit is None else audit.jac[column] for audit in found])


@dataclass(frozen=True, eq=False)
class SetPoses:
    """Poses of a source's camera over the frames.

    Attributes:
        values: (F, 7) in the order of `POSE_QUANTITIES`; NaN where there is no pose. Pan goes on
            beyond 180 degrees rather than to begin anew.
        jumps: (F, 7) whether the change from the frame before is far from usual.
        with_pose, without: frames with a pose, and frames with a camera that has none.
    """

    values: FloatArray
    jumps: NDArray[np.bool_]
    with_pose: int
    without: int


def poses(frames: Sequence[str], audits: Mapping[str, FrameAudit]) -> SetPoses:
    """The camera over the frames; the height is positive above the ground."""
    values = np.full((len(frames), len(POSE_QUANTITIES)), np.nan)
    without = 0
    for row, name in enumerate(frames):
        audit = audits.get(name)
        if audit is None:
            continue
        pose = audit.pose
        if pose is None:
            without += 1
            continue
        x, y, z = pose.position_world
        values[row] = pose.pan_deg, pose.tilt_deg, pose.roll_deg, pose.focal_px, x, y, -z
    there = np.isfinite(values[:, 0])
    for column in range(3):
        values[there, column] = np.rad2deg(np.unwrap(np.deg2rad(values[there, column])))
    return SetPoses(values, jumps(values), int(np.count_nonzero(there)), without)


def jumps(values: FloatArray) -> NDArray[np.bool_]:
    """Return where the change from the frame before, of values (F, 7) as in `SetPoses`, is a robust
    outlier among all such changes.

    Eight standard deviations (from the median absolute deviation) off the median change, and never
    less than half a degree, half a metre or ten px.
    """
    found = np.zeros(values.shape, dtype=bool)
    if len(values) < 3:
        return found
    change = np.diff(values, axis=0)
    for column in range(values.shape[1]):
        steps = change[:, column]
        known = steps[np.isfinite(steps)]
        if not len(known):
            continue
        usual = np.median(known)
        spread = _ROBUST * np.median(np.abs(known - usual))
        limit = max(_JUMP_DEVIATIONS * spread, _SMALLEST_JUMP[column])
        with np.errstate(invalid="ignore"):
            found[1:, column] = np.abs(steps - usual) > limit
    return found


def envelope(
    values: FloatArray, first: int, last: int, most: int
) -> tuple[IntArray | FloatArray, FloatArray]:
    """Positions and values between two positions, at most about ``most`` of them.

    Where there are more, every bin gives its lowest and its highest value, so that no outlier is
    lost; gaps as wide as a bin stay gaps.
    """
    first, last = max(0, first), min(len(values), last)
    count = max(0, last - first)
    if count <= most:
        return np.arange(first, first + count), values[first : first + count]
    width = math.ceil(2 * count / most)
    starts = np.arange(first, last, width)
    part = values[first:last]
    low = np.fmin.reduceat(part, starts - first)
    high = np.fmax.reduceat(part, starts - first)
    middle = np.minimum(starts + (width - 1) / 2, last - 1)
    return np.repeat(middle, 2), np.stack([low, high], axis=1).ravel()


def _joined(parts: list[NDArray[Any]], empty: NDArray[Any]) -> NDArray[Any]:
    return np.concatenate(parts) if parts else empty
