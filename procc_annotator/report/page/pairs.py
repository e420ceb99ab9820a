"""Pairs of methods in a report: disagreement and legacy metrics."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from procc_annotator.batch.comparison import (
    ComparedFrame,
    ComparisonRun,
    ComparisonSummary,
    worst_frames,
)
from procc_annotator.batch.execution.executor import Executor, Progress
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.metrics.error_maps import OFFSIDE_ACCURACY_M
from procc_annotator.metrics.legacy import MetricAverage
from procc_annotator.report.comparison import ComparisonScene, comparison_scene
from procc_annotator.report.page.overlays import paint_scene
from procc_annotator.report.tables.metrics import FRAMES, HAVING, LEGACY, METRES, PIXELS, WITHIN
from procc_annotator.report.tables.table import (
    Column,
    Metric,
    MetricTable,
    Value,
    defined_count_column,
    metric_column,
    metric_values,
)


@dataclass(frozen=True, slots=True)
class PairPicture:
    """A disagreement picture (JPEG) with its words."""

    frame: str
    picture: bytes
    words: str


@dataclass(frozen=True, eq=False)
class ReportedPair:
    """Two sources over the frames they have in common.

    Attributes:
        a, b: their names; a is the reference of the metrics of earlier papers.
        summary: None where nothing could be compared; ``failure`` says why.
        described: what the numbers depend on.
        pictures: the frames that disagree most.
    """

    a: str
    b: str
    summary: ComparisonSummary | None
    described: str = ""
    pictures: tuple[PairPicture, ...] = ()
    failure: str = ""
    problems: tuple[str, ...] = ()


class Pairs:
    """Compares pairs of sources on the annotated frames, each once however often it is asked
    for."""

    def __init__(
        self,
        sources: Sequence[CameraSet],
        field: Field,
        size: tuple[int, int],
        frames: Sequence[str],
        executor: Executor | None,
        progress: Progress[ComparedFrame],
    ) -> None:
        self._sources = {source.name: source for source in sources}
        self._field, self._size = field, size
        self._frames = frames
        self._executor = executor
        self._progress = progress
        self._done: dict[tuple[str, str], tuple[ComparisonRun, list[ComparedFrame]] | str] = {}

    def compared(self, a: str, b: str) -> ReportedPair:
        """The figures of a pair."""
        found = self._run(a, b)
        if isinstance(found, str):
            return ReportedPair(a, b, None, failure=found)
        comparison, frames = found
        problems = tuple(error for frame in frames for error in frame.errors)
        return ReportedPair(a, b, comparison.summary(), comparison.describe(), problems=problems)

    def pictures(
        self,
        a: str,
        b: str,
        count: int,
        paint: Callable[[ComparisonScene], bytes],
        pictures: Mapping[str, Path],
    ) -> tuple[PairPicture, ...]:
        """Pictures of the frames that disagree most, largest median first."""
        found = self._run(a, b)
        if isinstance(found, str):
            return ()
        comparison, frames = found
        return tuple(
            figure
            for frame in worst_frames(frames, count)
            if (figure := self._painted(comparison, frame, (a, b), paint, pictures)) is not None
        )

    def _painted(
        self,
        comparison: ComparisonRun,
        frame: ComparedFrame,
        names: tuple[str, str],
        paint: Callable[[ComparisonScene], bytes],
        pictures: Mapping[str, Path],
    ) -> PairPicture | None:
        try:
            scene = comparison_scene(comparison, frame, names, pictures)
            picture, _ = paint_scene(paint, scene)  # a failure is listed with the overlays
        except InputError:  # listed when the set was compared
            return None
        return PairPicture(frame.name, picture, _words(frame))

    def _run(self, a: str, b: str) -> tuple[ComparisonRun, list[ComparedFrame]] | str:
        if (a, b) not in self._done:
            try:
                comparison = ComparisonRun(
                    self._sources[a],
                    self._sources[b],
                    self._field,
                    self._size,
                    self._frames,
                    self._executor,
                )
                what = f"comparing {a}, {b}"
                frames = list(self._progress(comparison, comparison.total, what))
                self._done[a, b] = comparison, frames
            except UsageError as error:
                self._done[a, b] = str(error)
        return self._done[a, b]


def _words(frame: ComparedFrame) -> str:
    if frame.statistics is None:
        return ""
    metres = frame.statistics.metres
    least, median, largest = (figure.text(figure.of(metres)) for figure in METRES)
    within = WITHIN.text(frame.within)
    return (
        f"min {least}, median {median}, max {largest} m;"
        f" {within} % of the compared area within {OFFSIDE_ACCURACY_M:g} m"
    )


def disagreement_section(pairs: Sequence[ReportedPair]) -> MetricTable:
    """One row a pair: metres on the ground, px in the picture."""
    columns = (
        Column("sources", "Sources"),
        defined_count_column(FRAMES),
        *(_spread_column(f, "metres", "on the ground, m") for f in METRES),
        metric_column(WITHIN),
        *(_spread_column(f, "pixels", "in the picture, px") for f in PIXELS),
    )
    rows = []
    for pair in pairs:
        found = pair.summary
        metres = metric_values(METRES, found and found.metres)
        pixels = metric_values(PIXELS, found and found.pixels)
        within, frames = (found.within, found.frames) if found else (None, None)
        rows.append((f"{pair.a}, {pair.b}", frames, *metres, within, *pixels))
    return MetricTable(
        "disagreement", "Disagreement of camera sources", columns, tuple(rows), _described(pairs)
    )


def _spread_column(figure: Metric, what: str, group: str) -> Column:
    return metric_column(figure, key=f"{what}_{figure.key}", heading=figure.title, group=group)


def legacy_section(reference: str, pairs: Sequence[ReportedPair]) -> MetricTable:
    """One row a source: the metrics of earlier papers against the reference, mean and median; and
    of how many frames, where a figure is not of all of the row."""
    columns = [Column("source", "Source"), defined_count_column(FRAMES)]
    compared = [None if pair.summary is None else pair.summary.frames for pair in pairs]
    rows: list[list[Value]] = [[p.b, frames] for p, frames in zip(pairs, compared, strict=True)]
    for figure in LEGACY:
        group = f"{figure.title}, {figure.unit}"
        for average in ("mean", "median"):
            key = f"{figure.key}_{average}"
            columns.append(metric_column(figure, key=key, heading=average, group=group))
        found = [_average(pair, figure) for pair in pairs]
        fewer = any(f.frames != (n or 0) for f, n in zip(found, compared, strict=True))
        if fewer:
            key = f"{figure.key}_frames"
            columns.append(defined_count_column(HAVING, key=key, heading="frames", group=group))
        for row, one in zip(rows, found, strict=True):
            row += [one.mean, one.median, *([one.frames] if fewer else [])]
    title = f"Metrics of earlier papers against {reference}"
    return MetricTable("legacy", title, tuple(columns), tuple(map(tuple, rows)), _described(pairs))


def _average(pair: ReportedPair, figure: Metric) -> MetricAverage:
    legacy = {} if pair.summary is None else pair.summary.legacy
    return legacy.get(figure.key, MetricAverage(None, None, 0))


def _described(pairs: Sequence[ReportedPair]) -> str:
    return next((p.described for p in pairs if p.described), "")
