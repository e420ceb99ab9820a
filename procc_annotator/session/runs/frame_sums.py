"""What each frame adds to the figures of its set, kept so that sets can be drawn from it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.io.camera_files.fitted_on import NOT_FITTED, FitCounts, name_with_mark
from procc_annotator.metric.chance.sampling import RatioMetrics
from procc_annotator.metric.polylines import BoolArray, FloatArray
from procc_annotator.metric.score import FrameScore, jac_curve
from procc_annotator.session.runs.audit import TAU_GRID, Pose, pose_in_degrees
from procc_annotator.session.runs.moved_clicks import ClickNoise, perturbed_jac
from procc_annotator.session.runs.score_chunk import Evaluated

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
        pose: of the camera; None without one, or where its model has none.
        model: of the camera; empty without one.
        moved: (R, T + S) JaC with all points moved R times, at each threshold and each of
            `SPARSE_TAUS`; None unless it was asked for.
        fitted: whether the camera was fitted to the annotation it is judged by, or to another
            version of it.
        ground_only: whether the camera knows only the ground.
    """

    frame: str
    figures: FloatArray
    curve: NDArray[np.float32] | None
    elements: int = 0
    pose: Pose | None = None
    model: str = ""
    moved: NDArray[np.float32] | None = None
    fitted: FitCounts = NOT_FITTED
    ground_only: bool = False
    spread: float | None = None


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
        pose_in_degrees(evaluated.camera),
        evaluated.model,
        moved,
        result.fitted,
        result.ground_only,
        spread,
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

    @property
    def fitted(self) -> FitCounts:
        """Its cameras that were fitted to the annotations they are judged by: no method among
        methods, and never the best of them."""
        return sum((frame.fitted for frame in self.frames), NOT_FITTED)

    @property
    def ground_only(self) -> bool:
        """Whether some of its cameras know only the ground: their errors are of fewer points."""
        return any(frame.ground_only for frame in self.frames)

    @property
    def marked_name(self) -> str:
        """Its name as tables tell it beside others."""
        return name_with_mark(self.name, self.fitted)

    def ratios(self, key: str) -> RatioMetrics:
        """A figure of the set at each threshold, by its key in `SetSummary`."""
        figures = np.array([frame.figures for frame in self.frames])
        figures = figures.reshape(len(self.frames), len(self.thresholds), 5)
        if key in _MEANS:
            return RatioMetrics.mean(figures[..., _MEANS[key]])
        there = np.repeat(self.with_camera[:, None], len(self.thresholds), axis=1)
        if key == "mean_error":
            # A distance that is undefined leaves the set without a mean.
            counts = np.where(there, figures[..., 4], 0.0)
            return RatioMetrics(np.where(there, figures[..., 3], 0.0), counts)
        every = np.ones(there.shape)
        if key == "completeness":
            return RatioMetrics(there.astype(np.float64), every)
        if key == "final_score":
            if not self.with_camera.any():  # no mean that the completeness could be taken of
                every = np.zeros(there.shape)
            return RatioMetrics(np.where(there, figures[..., 0], 0.0), every)
        raise KeyError(key)

    def curves(self) -> RatioMetrics:
        """The mean JaC at each of `TAU_GRID`."""
        nothing = np.full(len(TAU_GRID), np.nan, dtype=np.float32)
        return RatioMetrics.mean(
            np.array([nothing if f.curve is None else f.curve for f in self.frames]).reshape(
                len(self.frames), len(TAU_GRID)
            )
        )


_MEANS = {"mean_jac": 0, "mean_precision": 1, "mean_recall": 2}
