"""Per-frame sums for bootstrap resampling, scores under perturbed clicks, confidence bands."""

from __future__ import annotations

import math
import zlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px, points_px
from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.batch.audit import TAU_GRID, FrameAudit
from procc_annotator.batch.grouping import FrameOrder, clusters_of
from procc_annotator.batch.scoring import Evaluated
from procc_annotator.formats.cameras.fit_record import (
    NOT_FITTED,
    FitCounts,
    LeftOutElement,
    name_with_mark,
)
from procc_annotator.metrics.measurement import Measurement, measure_projected
from procc_annotator.metrics.score import FrameScore, jac_curve
from procc_annotator.metrics.statistics.intervals import (
    BootstrapSettings,
    CurveBand,
    RatioMetrics,
    bootstrap,
    curve_band,
)

REPEATS = 20


@dataclass(frozen=True)
class ClickNoise:
    """Noise that moves points.

    Attributes:
        px: standard deviation along x and along y, px of the evaluation size or of ``of_size``.
        repeats: how often the whole evaluation is repeated.
        seed: the same one moves the same points of a frame alike, for every source.
        of_size: (width, height) of the picture in whose px it was measured.
        told_by: what it was measured by.
    """

    px: float
    repeats: int = REPEATS
    seed: int = 1
    of_size: tuple[int, int] | None = None
    told_by: str = ""

    def at(self, size: tuple[int, int]) -> tuple[float, float]:
        """The deviations along x and y, px of a picture of this (width, height)."""
        if self.of_size is None:
            return self.px, self.px
        along, down = ((n - 1) / (m - 1) for n, m in zip(size, self.of_size, strict=True))
        return self.px * along, self.px * down

    @property
    def described(self) -> str:
        """Return how points are moved, in words."""
        of, told_by = "", ""
        if self.of_size is not None:
            of, told_by = f" of {self.of_size[0]}x{self.of_size[1]}", f", from {self.told_by}"
        return (
            f"Every point moved by {self.px:.3g} px{of} (standard deviation along x and y"
            f"{told_by}), {self.repeats} times, seed {self.seed}."
        )


def perturbed_jac(
    frame: str,
    annotation: FrameAnnotation,
    measurement: Measurement,
    noise: ClickNoise,
    thresholds: Sequence[float],
) -> NDArray[np.float32]:
    """(R, T) JaC of a frame at some thresholds, in each repeat.

    Args:
        frame: its name; it decides, with the seed, how its points are moved.
        annotation: what was clicked. measurement: of it.
    """
    rng = np.random.default_rng((noise.seed, zlib.crc32(frame.encode("utf-8", "surrogatepass"))))
    taus = np.asarray(thresholds, dtype=np.float64)
    size = measurement.setup.size
    found = np.empty((noise.repeats, len(taus)), dtype=np.float32)
    for repeat in range(noise.repeats):
        moved = _perturbed(annotation, size, noise.at(size), rng)
        again = measure_projected(moved, measurement.projected, measurement.setup)
        found[repeat] = jac_curve(again, taus)
    return found


def _perturbed(
    annotation: FrameAnnotation,
    size: tuple[int, int],
    px: tuple[float, float],
    rng: np.random.Generator,
) -> FrameAnnotation:
    return replace(
        annotation,
        polylines=tuple(_perturbed_polyline(p, size, px, rng) for p in annotation.polylines),
    )


def _perturbed_polyline(
    polyline: Polyline, size: tuple[int, int], px: tuple[float, float], rng: np.random.Generator
) -> Polyline:
    points = points_px(polyline, size)
    points += np.array(px) * rng.standard_normal(points.shape)
    return replace(polyline, points=tuple(point_from_px(x, y, size) for x, y in points.tolist()))


# Where a difference is followed over tau with moved clicks: every 0.5 px.
SPARSE = slice(0, None, 5)
SPARSE_TAUS = tuple(TAU_GRID[SPARSE].tolist())


@dataclass(frozen=True, eq=False, slots=True)
class FrameSums:
    """One frame that counts, under one source; T thresholds.

    Attributes:
        frame: its name.
        figures: (T, 5) JaC, precision, recall, sum of distances and their count; NaN where one is
            undefined, all of them without a camera.
        curve: JaC at each of `TAU_GRID`, float32; None without a camera.
        elements: how many elements are annotated.
        spread: the share of the picture that their points enclose; None where there are none.
        model: of the camera; empty without one.
        moved: (R, T + S) JaC with all points moved R times, at each threshold and each of
            `SPARSE_TAUS`; None unless it was asked for.
        fitted: whether the camera was fitted to the annotation it is judged by, or to another
            version of it.
        ground_only: whether the camera knows only the ground.
        held_out: elements left out of the fit, see `Evaluated`.
    """

    frame: str
    figures: FloatArray
    curve: NDArray[np.float32] | None
    elements: int = 0
    model: str = ""
    moved: NDArray[np.float32] | None = None
    fitted: FitCounts = NOT_FITTED
    ground_only: bool = False
    spread: float | None = None
    held_out: tuple[LeftOutElement, ...] = ()


def frame_sums(
    evaluated: Evaluated, thresholds: Sequence[float], noise: ClickNoise | None = None
) -> FrameSums | None:
    """Keep what a frame adds; None for one that belongs to no figure of the set."""
    result = evaluated.result
    if not result.counted:
        return None
    measurement, how_much = evaluated.measurement, result.clicked
    elements = 0 if how_much is None else how_much.annotated_elements
    spread = None if how_much is None else how_much.spread
    if measurement is None or evaluated.camera is None:
        nothing = np.full((len(thresholds), 5), np.nan)
        return FrameSums(result.name, nothing, None, elements=elements, spread=spread)
    moved = None
    if noise is not None and evaluated.annotation is not None:
        taus = (*thresholds, *SPARSE_TAUS)
        moved = perturbed_jac(result.name, evaluated.annotation, measurement, noise, taus)
    return FrameSums(
        result.name,
        np.array([_figures(result.scores[tau]) for tau in thresholds]),
        jac_curve(measurement, TAU_GRID).astype(np.float32),
        elements,
        evaluated.model,
        moved,
        result.fitted,
        result.ground_only,
        spread,
        evaluated.held_out,
    )


def _figures(score: FrameScore) -> tuple[float, ...]:
    precision, recall = score.precision, score.recall
    return (
        score.jac,
        math.nan if precision is None else precision,
        math.nan if recall is None else recall,
        score.read.error_sum,
        float(len(score.read.all_distances)),
    )


@dataclass(frozen=True, eq=False)
class SourceSums:
    """A source over the F frames of a set that count.

    Attributes:
        name: of the source.
        thresholds: T, px.
        frames: in natural order.
    """

    name: str
    thresholds: tuple[float, ...]
    frames: tuple[FrameSums, ...]

    @classmethod
    def of(
        cls, name: str, thresholds: Sequence[float], frames: Iterable[FrameSums | None]
    ) -> SourceSums:
        """The frames that count."""
        return cls(name, tuple(thresholds), tuple(f for f in frames if f is not None))

    @property
    def names(self) -> tuple[str, ...]:
        """The frames."""
        return tuple(frame.frame for frame in self.frames)

    @property
    def with_camera(self) -> BoolArray:
        """(F,) whether the source has a camera."""
        return np.array([frame.curve is not None for frame in self.frames], dtype=bool)

    @cached_property
    def fitted(self) -> FitCounts:
        """Its cameras that were fitted to the annotations they are judged by: no method among
        methods, and never the best of them."""
        return sum((frame.fitted for frame in self.frames), NOT_FITTED)

    @property
    def ground_only(self) -> bool:
        """Return whether some of its cameras know only the ground: their errors are of fewer
        points."""
        return any(frame.ground_only for frame in self.frames)

    @property
    def marked_name(self) -> str:
        """Its name as tables give it next to others."""
        return name_with_mark(self.name, self.fitted)

    def ratios(self, key: str) -> RatioMetrics:
        """A metric of the set at each threshold, by its key in `RATIOS`."""
        figures = np.array([frame.figures for frame in self.frames])
        figures = figures.reshape(len(self.frames), len(self.thresholds), 5)
        there = np.repeat(self.with_camera[:, None], len(self.thresholds), axis=1)
        return RATIOS[key].ratio(figures, there)

    def curves(self) -> RatioMetrics:
        """The mean JaC at each of `TAU_GRID`."""
        nothing = np.full(len(TAU_GRID), np.nan, dtype=np.float32)
        return RatioMetrics.mean(
            np.array([nothing if f.curve is None else f.curve for f in self.frames]).reshape(
                len(self.frames), len(TAU_GRID)
            )
        )


def _mean_error(figures: FloatArray, there: BoolArray) -> RatioMetrics:
    # A distance that is undefined leaves the set without a mean.
    return RatioMetrics(
        np.where(there, figures[..., 3], 0.0), np.where(there, figures[..., 4], 0.0)
    )


def _final_score(figures: FloatArray, there: BoolArray) -> RatioMetrics:
    # Without any camera there is no mean that the completeness could be multiplied by.
    return RatioMetrics(
        np.where(there, figures[..., 0], 0.0), np.full(there.shape, there.any(), float)
    )


@dataclass(frozen=True)
class SetRatio:
    """A metric of sets that has intervals, as a ratio of sums over frames.

    Attributes:
        ratio: from (F, T, 5) `FrameSums.figures` and (F, T) whether the frame has a camera.
        better: +1 where more is better, -1 where less is.
        compared: whether sources are compared by it; the others follow from these.
        over_all: whether frames without a camera count.
    """

    ratio: Callable[[FloatArray, BoolArray], RatioMetrics]
    better: int = +1
    compared: bool = False
    over_all: bool = False


# By the key of `SetSummary`.
RATIOS = {
    "mean_jac": SetRatio(lambda f, _: RatioMetrics.mean(f[..., 0]), compared=True),
    "completeness": SetRatio(
        lambda _, there: RatioMetrics(there.astype(np.float64), np.ones(there.shape)),
        compared=True, over_all=True,
    ),
    "final_score": SetRatio(_final_score, compared=True, over_all=True),
    "mean_precision": SetRatio(lambda f, _: RatioMetrics.mean(f[..., 1])),
    "mean_recall": SetRatio(lambda f, _: RatioMetrics.mean(f[..., 2])),
    "mean_error": SetRatio(_mean_error, better=-1, compared=True),
}  # fmt: skip
COMPARED = tuple(key for key, one in RATIOS.items() if one.compared)


# Bands are smooth: every 0.5 px is enough, and a few hundredths of a second for a thousand frames.
_EVERY = 5
_DRAWS = BootstrapSettings(1000)


@dataclass(frozen=True, eq=False)
class AuditBand:
    """A curve over `TAU_GRID` with its band.

    Attributes:
        band: the curve.
        frames: how many it is of.
        clustered: what frames are drawn together, in words.
    """

    band: CurveBand
    frames: int
    clustered: str


def mean_band(
    audits: Mapping[str, FrameAudit], frames: Sequence[str], order: FrameOrder | None = None
) -> AuditBand:
    """The mean JaC of a source over the frames that it has.

    Args:
        audits: by frame. frames: all names, in their order.
        order: the dataset's table of frames; without it names show which ones are of one shot.
    """
    names = [name for name in frames if name in audits]
    clusters = clusters_of(names, None, {}, order)
    if not names:
        nothing = np.full(len(TAU_GRID), np.nan)
        return AuditBand(CurveBand(nothing, nothing, nothing), 0, clusters.described)
    every = np.array([audits[name].jac for name in names], dtype=np.float64)
    found = curve_band(
        bootstrap(RatioMetrics.mean(every[:, ::_EVERY]), clusters.numbers, _DRAWS), _DRAWS
    )
    values, taus = every.mean(axis=0), TAU_GRID[::_EVERY]
    half = np.interp(TAU_GRID, taus, found.high - found.values)
    low, high = (np.clip(values + sign * half, 0.0, 1.0) for sign in (-1, 1))
    return AuditBand(CurveBand(values, low, high), len(names), clusters.described)
