"""Compare two camera methods frame by frame, with confidence intervals."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.batch.execution.executor import Executor
from procc_annotator.batch.grouping import Clusters
from procc_annotator.batch.set_run import ReopenableHandle, SetRun
from procc_annotator.camera.base import Camera, ElementProjections
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.diagnostics import found_instead_of_cameras
from procc_annotator.errors import CameraError, UsageError
from procc_annotator.field.load import field_for_frame
from procc_annotator.field.model import Field
from procc_annotator.formats.frame_names import ByFrame
from procc_annotator.metrics.error_maps import (
    OFFSIDE_ACCURACY_M,
    Disagreement,
    DisagreementStatistics,
    MapSummary,
    disagreement,
)
from procc_annotator.metrics.legacy import (
    LegacyMetrics,
    MetricAverage,
    legacy_averages,
    legacy_metrics,
)
from procc_annotator.metrics.statistics.intervals import (
    BootstrapSettings,
    Interval,
    RatioMetrics,
    bootstrap,
    confidence_intervals,
    quantile_confidence_interval,
    with_rule_of_three,
)
from procc_annotator.metrics.statistics.significance import (
    PairedDifference,
    corrected_for,
    paired_differences,
)

_PICTURE_STEP_PX = 2


@dataclass(frozen=True, slots=True)
class CameraPair:
    """The cameras of two sources for one frame, px of the evaluation size, and remarks."""

    a: Camera
    b: Camera
    notices: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ComparedFrame:
    """Result for one frame that both sources have.

    Attributes:
        name: the frame.
        statistics: of the disagreement; None where a camera could not be read (see ``errors``).
        within: share of the compared area where they agree within the accuracy of offside
            technology, in [0, 1]; None where nothing is comparable.
        compared_share: share of the picture that was compared, in [0, 1].
        legacy: b against a as its reference.
        errors: what could not be read.
        notices: remarks on the cameras.
    """

    name: str
    statistics: DisagreementStatistics | None = None
    within: float | None = None
    compared_share: float = 0.0
    legacy: LegacyMetrics | None = None
    errors: tuple[str, ...] = ()
    notices: tuple[str, ...] = ()

    @property
    def median_m(self) -> float | None:
        """Median disagreement, metres; None where nothing is comparable."""
        return None if self.statistics is None else self.statistics.metres.median


@dataclass(frozen=True, slots=True)
class ComparisonSummary:
    """Two sources over a set.

    Attributes:
        frames: frames in which something could be compared.
        blank: names of frames in which nothing could: no pixel shows the field to any of the two
            and the ground to both.
        metres, pixels: least of all frames, median of the frames' medians, largest of all frames.
        within: share of the compared area of all frames within the accuracy of offside technology.
        legacy: mean and median over the frames, by figure.
    """

    frames: int
    blank: tuple[str, ...]
    metres: MapSummary
    pixels: MapSummary
    within: float | None
    legacy: dict[str, MetricAverage]


class ComparisonRun(SetRun[str, ComparedFrame, None]):
    """One pass over the frames that two sources have in common; each starts anew.

    Args:
        a: the reference of the legacy metrics.
        frames: names of the frames of a dataset; None for all that the sources have.

    Attributes:
        only_a, only_b: frames of the dataset that only one of them has.
        neither: frames of the dataset that none of them has.

    Raises:
        UsageError: nothing to compare, or a size that is no picture; while it is iterated, a source
            without ground to compare.
    """

    def __init__(
        self,
        a: CameraSet,
        b: CameraSet,
        field: Field,
        size: tuple[int, int],
        frames: Iterable[str] | None = None,
        executor: Executor | None = None,
    ) -> None:
        if min(size) < 2:
            raise UsageError(f"the evaluation size {size[0]}x{size[1]} is too small")
        self.a, self.b, self.field, self.size = a, b, field, size
        in_a, in_b = a.frames, b.frames
        wanted = dict.fromkeys(_every(in_a, in_b) if frames is None else frames)
        shared = tuple(name for name in wanted if name in in_a and name in in_b)
        self.only_a = tuple(name for name in wanted if name in in_a and name not in in_b)
        self.only_b = tuple(name for name in wanted if name in in_b and name not in in_a)
        self.neither = tuple(name for name in wanted if name not in in_a and name not in in_b)
        if not shared:
            raise UsageError(_no_common_frames(a, b, tuple(wanted), frames is not None))
        base = Path.cwd()
        sources = ReopenableHandle(a.opener(base), a), ReopenableHandle(b.opener(base), b)
        super().__init__(shared, CompareFrames(*sources, field, size), executor)
        self._done: list[ComparedFrame] = []

    def __iter__(self) -> Iterator[ComparedFrame]:
        self._done = []
        return super().__iter__()

    def _take(self, results: Sequence[ComparedFrame], sums: None) -> None:
        self._done += results

    def cameras(self, name: str) -> CameraPair:
        """The cameras of a frame of ``names``.

        Raises:
            CameraError: one of them is damaged.
        """
        return _pair(self.a, self.b, name, self.size)

    def map_for_picture(self, name: str, pair: CameraPair) -> Disagreement:
        """The disagreement of a frame's cameras, sampled finely enough to be drawn."""
        field = field_for_frame(self.field, name)
        return disagreement(pair.a, pair.b, field, self.size, step_px=_PICTURE_STEP_PX)

    def summary(self) -> ComparisonSummary:
        """The figures of the frames compared so far."""
        done = [frame for frame in self._done if frame.median_m is not None]
        spreads = [frame.statistics for frame in done if frame.statistics is not None]
        area = sum(frame.compared_share for frame in done)
        within = sum(frame.compared_share * (frame.within or 0.0) for frame in done)
        return ComparisonSummary(
            frames=len(done),
            blank=tuple(f.name for f in self._done if f.median_m is None and not f.errors),
            metres=_over_frames([s.metres for s in spreads]),
            pixels=_over_frames([s.pixels for s in spreads]),
            within=within / area if area else None,
            legacy=legacy_averages(f.legacy for f in self._done if f.legacy is not None),
        )

    def describe(self) -> str:
        """Return what the numbers depend on, in words."""
        return f"{self.field.described}, {self.size[0]}x{self.size[1]}"


def worst_frames(frames: Iterable[ComparedFrame], count: int | None) -> list[ComparedFrame]:
    """Frames with the largest median disagreement first, those without any left out.

    Args:
        count: how many; None for all.
    """
    compared = [(f.median_m, f) for f in frames if f.median_m is not None]
    return [frame for _, frame in sorted(compared, key=lambda entry: -entry[0])[:count]]


@dataclass(frozen=True)
class CompareFrames:
    """Compares chunks of frames."""

    a: ReopenableHandle[CameraSet]
    b: ReopenableHandle[CameraSet]
    field: Field
    size: tuple[int, int]

    def __call__(self, names: Sequence[str]) -> tuple[list[ComparedFrame], None]:
        a, b = self.a.opened, self.b.opened
        return [
            _compare(a, b, name, field_for_frame(self.field, name), self.size) for name in names
        ], None


def _compare(
    a: CameraSet, b: CameraSet, name: str, field: Field, size: tuple[int, int]
) -> ComparedFrame:
    try:
        pair = _pair(a, b, name, size)
    except CameraError as error:
        return ComparedFrame(name, errors=(str(error),))
    found = disagreement(pair.a, pair.b, field, size)
    return ComparedFrame(
        name,
        found.statistics,
        found.share_within(OFFSIDE_ACCURACY_M),
        found.compared_share,
        legacy_metrics(pair.b, pair.a, field, size),
        notices=pair.notices,
    )


def _pair(a: CameraSet, b: CameraSet, name: str, size: tuple[int, int]) -> CameraPair:
    cameras, notices = [], []
    for source in (a, b):
        found = source.camera(name, size)
        if found is None:
            raise UsageError(f"{source.name} has no camera of frame {name!r}")
        if isinstance(found.camera, ElementProjections):
            raise UsageError(
                f"{source.name} shares only projections, there is no ground to compare"
                f" (frame {name!r}): compare the cameras that they were written from (in Python"
                " compare_cameras takes functions, too), or both methods by JaC on annotations:"
                " evaluate ANNOTATIONS --cameras A --cameras B --intervals"
            )
        cameras.append(found.camera)
        notices += [f"{source.name}: {found.notice}"] if found.notice else []
    return CameraPair(cameras[0], cameras[1], tuple(notices))


def _every(a: ByFrame[str], b: ByFrame[str]) -> list[str]:
    names = [name if name in b else a.called_in(b, name) or name for name in a]
    in_b = {b.name_there(name) for name in names}
    return [*names, *(name for name in b if name not in in_b)]


def _over_frames(spreads: Sequence[MapSummary]) -> MapSummary:
    known = [s for s in spreads if s.median is not None]
    if not known:
        return MapSummary(None, None, None)
    minima, medians, maxima = np.array(
        [(s.minimum, s.median, s.maximum) for s in known], dtype=np.float64
    ).T
    return MapSummary(float(minima.min()), float(np.median(medians)), float(maxima.max()))


def _no_common_frames(a: CameraSet, b: CameraSet, wanted: Sequence[str], of_dataset: bool) -> str:
    for source in (a, b):
        if source.frames and (instead := found_instead_of_cameras(source.path)):
            return f"nothing to do: no camera in {source.path}{instead}"
    examples = [
        f"those of {source.name} are named like {next(iter(source.frames))!r}"
        if source.frames
        else f"{source.name} has no camera (format {source.format}) in {source.path}"
        for source in (a, b)
    ]
    if of_dataset and wanted:
        examples.append(f"the frames of the dataset like {wanted[0]!r}")
    return f"nothing to do: no frame has cameras of both ({', '.join(examples)})"


METRES, PIXELS, WITHIN = "metres", "pixels", "within"
EARLIER = ("iou_part", "iou_whole", "projection_m", "reprojection", "six_point_rmse_cm")
SHARES = ("iou_part", "iou_whole", WITHIN)  # the only ones of which more is nearer
KEYS = (METRES, PIXELS, *EARLIER, WITHIN)


@dataclass(frozen=True)
class MetricWithInterval:
    """A figure of a comparison over a set.

    Attributes:
        value: None where no frame has it; interval: None of fewer than two clusters.
        frames: that it rests on.
    """

    value: float | None
    interval: Interval | None
    frames: int


def metrics_with_intervals(
    frames: Sequence[ComparedFrame], clusters: Clusters, draws: BootstrapSettings
) -> dict[str, MetricWithInterval]:
    """Each of `KEYS`, with its interval.

    Args:
        frames: F of them. clusters: of these. draws: says the level.
    """
    ratios = _ratios(frames)
    sampled = bootstrap(ratios, clusters.numbers, None)
    ends = confidence_intervals(sampled, draws)
    counted = (ratios.denominators > 0).sum(axis=0)
    return {
        key: MetricWithInterval(
            _with_interval(sampled.values[k]),
            _possible(key, ends[k], float(sampled.effective[k])),
            int(counted[k]),
        )
        for k, key in enumerate(KEYS)
    }


def medians_with_intervals(
    frames: Sequence[ComparedFrame], clusters: Clusters, draws: BootstrapSettings
) -> dict[str, MetricWithInterval]:
    """The median over frames of the frames' medians: of `METRES` and of `PIXELS`."""
    found = {}
    for key, values in zip((METRES, PIXELS), _medians(frames).T, strict=True):
        there: IntArray = np.flatnonzero(np.isfinite(values))
        median = float(np.median(values[there])) if len(there) else None
        interval = quantile_confidence_interval(values[there], there, clusters.numbers, 0.5, draws)
        found[key] = MetricWithInterval(median, interval, len(there))
    return found


def closer_source(
    a: Sequence[ComparedFrame],
    b: Sequence[ComparedFrame],
    clusters: Clusters,
    draws: BootstrapSettings,
) -> dict[str, PairedDifference]:
    """Each of `KEYS` of one comparison less that of another, corrected for as many figures.

    Args:
        a, b: two comparisons with one source in common, of the same F frames in the same order.
        clusters: of the frames. draws: of the permutation test; says the level.
    """
    sides = [_ratios(a), _ratios(b)]
    both = (sides[0].denominators > 0) & (sides[1].denominators > 0)
    first, second = (
        RatioMetrics(np.where(both, one.parts, 0.0), np.where(both, one.denominators, 0.0))
        for one in sides
    )
    together = bootstrap(RatioMetrics.beside([first, second]), clusters.numbers, None)
    count = len(KEYS)
    pair = together.at(slice(0, count)), together.at(slice(count, None))
    found = paired_differences(first, second, pair, clusters.numbers, draws)
    return dict(zip(KEYS, corrected_for(found), strict=True))


def _possible(key: str, interval: Interval | None, clusters: float) -> Interval | None:
    """No distance is below 0, and no share above 1."""
    if interval is None:
        return None
    if key in SHARES:
        interval = with_rule_of_three(interval, clusters)
    high = min(1.0, interval.high) if key in SHARES else interval.high
    return replace(interval, low=max(0.0, interval.low), high=high)


def _ratios(frames: Sequence[ComparedFrame]) -> RatioMetrics:
    """(F, K) parts and wholes of `KEYS`."""
    rows = [[getattr(frame.legacy, key, None) for key in EARLIER] for frame in frames]
    earlier = np.array(rows, dtype=np.float64).reshape(-1, len(EARLIER))
    means = np.column_stack((_medians(frames), earlier))
    shares = np.array([[frame.compared_share] for frame in frames]).reshape(-1, 1)
    within = np.array([[frame.within or 0.0] for frame in frames]).reshape(-1, 1)
    return RatioMetrics.beside([RatioMetrics.mean(means), RatioMetrics(shares * within, shares)])


def _medians(frames: Sequence[ComparedFrame]) -> FloatArray:
    """(F, 2) medians in metres and px, NaN where there are none."""
    rows = [
        (s.metres.median, s.pixels.median) if (s := frame.statistics) else (None, None)
        for frame in frames
    ]
    return np.array(rows, dtype=np.float64).reshape(-1, 2)  # None becomes NaN


def _with_interval(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
