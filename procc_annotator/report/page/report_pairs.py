"""Pairs of sources in a report: where they disagree, and the metrics of earlier papers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from procc_annotator.errors import ImageError, InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.metric.contours import OFFSIDE_ACCURACY_M
from procc_annotator.metric.legacy import Average
from procc_annotator.report.comparison import (
    LEGACY_ROWS,
    ComparisonScene,
    shown_number,
    spread_cells,
)
from procc_annotator.report.page.report_tables import Cell, ReportColumn, ReportTable
from procc_annotator.report.sheet.figure import DASH
from procc_annotator.session.dataset.camera_set import CameraSet
from procc_annotator.session.runs.comparison_run import (
    ComparedFrame,
    ComparisonRun,
    ComparisonSummary,
    worst_frames,
)
from procc_annotator.session.runs.execution.executor import Executor

PaintPair = Callable[[ComparisonScene], bytes]
"""Turns a scene into an encoded picture."""

Progress = Callable[[Iterable[ComparedFrame], int, str], Iterator[ComparedFrame]]


@dataclass(frozen=True, slots=True)
class PairPainters:
    """Who paints: with a photograph as JPEG, on plain ground as PNG."""

    photograph: PaintPair
    plain: PaintPair


@dataclass(frozen=True, slots=True)
class PairFigure:
    """A disagreement picture (encoded, with its MIME type) with its words."""

    frame: str
    picture: bytes
    kind: str
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
    pictures: tuple[PairFigure, ...] = ()
    failure: str = ""
    problems: tuple[str, ...] = ()


class Pairs:
    """Compares pairs of sources, each once however often it is asked for.

    Args:
        sources: by name.
        field, size: of the evaluation.
        frames: names of the annotated frames.
        executor: shares the work; None does it here.
        progress: wraps the frames as they come.
    """

    def __init__(
        self,
        sources: Sequence[CameraSet],
        field: Field,
        size: tuple[int, int],
        frames: Sequence[str],
        executor: Executor | None,
        progress: Progress,
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
        self, a: str, b: str, count: int, paint: PairPainters, pictures: Mapping[str, Path]
    ) -> tuple[PairFigure, ...]:
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
        paint: PairPainters,
        pictures: Mapping[str, Path],
    ) -> PairFigure | None:
        try:
            cameras = comparison.cameras(frame.name)
            found = comparison.map_for_picture(cameras)
            scene = ComparisonScene(
                frame, pictures.get(frame.name), names, cameras, found, self._field
            )
            picture, kind = _encoded(scene, paint)
        except InputError:  # listed when the set was compared
            return None
        return PairFigure(frame.name, picture, kind, _words(frame))

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


def _encoded(scene: ComparisonScene, paint: PairPainters) -> tuple[bytes, str]:
    if scene.image_path is not None:
        try:
            return paint.photograph(scene), "image/jpeg"
        except ImageError:  # listed with the overlay pictures
            scene = replace(scene, image_path=None)
    return paint.plain(scene), "image/png"


def _words(frame: ComparedFrame) -> str:
    if frame.statistics is None:
        return ""
    metres = frame.statistics.metres
    within = DASH if frame.within is None else f"{100 * frame.within:.1f} %"
    least, median, largest = spread_cells(metres)
    return (
        f"min {least}, median {median}, max {largest} m;"
        f" {within} of the compared area within {OFFSIDE_ACCURACY_M:g} m"
    )


def disagreement_section(pairs: Sequence[ReportedPair]) -> ReportTable:
    """One row a pair: metres on the ground, px in the picture."""
    columns = (
        ReportColumn("Sources", numeric=False),
        ReportColumn("Frames"),
        *(ReportColumn(heading, group="on the ground, m") for heading in ("min", "median", "max")),
        ReportColumn(f"within {OFFSIDE_ACCURACY_M:g} m, %"),
        *(
            ReportColumn(heading, group="in the picture, px")
            for heading in ("min", "median", "max")
        ),
    )
    rows = []
    for pair in pairs:
        texts = [f"{pair.a}, {pair.b}", *[DASH] * 8]
        if pair.summary is not None:
            found = pair.summary
            within = DASH if found.within is None else f"{100 * found.within:.1f}"
            texts = [texts[0], str(found.frames), *spread_cells(found.metres), within]
            texts += spread_cells(found.pixels)
        rows.append(tuple(Cell(text) for text in texts))
    described = next((p.described for p in pairs if p.described), "")
    return ReportTable(f"Disagreement of camera sources ({described})", columns, tuple(rows))


def legacy_section(reference: str, pairs: Sequence[ReportedPair]) -> ReportTable:
    """One row a source: the metrics of earlier papers against the reference, mean and median."""
    columns = [ReportColumn("Source", numeric=False), ReportColumn("Frames")]
    for title, unit, _ in LEGACY_ROWS.values():
        columns += [
            ReportColumn("mean", group=f"{title}, {unit}"),
            ReportColumn("median", group=f"{title}, {unit}"),
        ]
    rows = []
    for pair in pairs:
        legacy = {} if pair.summary is None else pair.summary.legacy
        frames = DASH if pair.summary is None else str(pair.summary.frames)
        cells = [Cell(pair.b), Cell(frames)]
        for name, (_, _, factor) in LEGACY_ROWS.items():
            found = legacy.get(name, Average(None, None, 0))
            cells += [Cell(shown_number(value, factor)) for value in (found.mean, found.median)]
        rows.append(tuple(cells))
    described = next((p.described for p in pairs if p.described), "")
    return ReportTable(
        f"Metrics of earlier papers against {reference} ({described})", tuple(columns), tuple(rows)
    )
