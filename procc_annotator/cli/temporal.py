"""Temporal stability of evaluated methods: measure, write, print."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import Any

from procc_annotator.batch.execution.executor import Executor
from procc_annotator.batch.grouping import (
    FrameOrder,
    NotInOrderError,
    ShotFrames,
    shots_by_name,
    shots_from,
)
from procc_annotator.batch.set_run import annotations_for, frames_of_all
from procc_annotator.cli.console import progress_bar, stdout_console
from procc_annotator.cli.echo import echo
from procc_annotator.cli.remarks import report_remarks
from procc_annotator.dataset.layout import FRAMES_FILE, folder_of_dataset
from procc_annotator.dataset.sequence import find_shots, open_pictures
from procc_annotator.errors import ProccError, UsageError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.report.scores.scoring import EvaluationRequest
from procc_annotator.report.temporal import (
    TemporalMetrics,
    measure_over_time,
    over_time_bytes,
    over_time_entries,
    terminal_tables,
)


@dataclass(frozen=True)
class TemporalRequest:
    """Options of temporal metrics.

    Attributes:
        shots: table of the frames that follow each other.
        pictures: folder or video.
        written_to: files of the metrics.
    """

    shots: Path | None
    pictures: Path | None
    written_to: Sequence[Path]

    def run(
        self, evaluations: Sequence[EvaluationRequest], threshold: float, executor: Executor
    ) -> list[TemporalMetrics]:
        """Look at every source of every set; of several sizes at the first. Of a set whose frames
        do not follow each other there is nothing but a note."""
        found: list[TemporalMetrics] = []
        refused: dict[str, list[str]] = {}
        for name, of_set in groupby(evaluations, key=lambda one: one.set_name):
            own = {one.method: one for one in reversed(list(of_set))}
            sources = list(reversed(own.values()))
            known = self._shots(sources)
            for one in sources:
                try:
                    with progress_bar(f"{one.method} over time") as progress:
                        found.append(measure_over_time(one, known, threshold, executor, progress))
                except NotInOrderError as error:
                    refused.setdefault(f"no metrics over time: {error}", []).append(
                        f"{name}, {one.method}"
                    )
        report_remarks(f"{'; '.join(methods)}: {why}" for why, methods in refused.items())
        return found

    def _shots(
        self, sources: Sequence[EvaluationRequest]
    ) -> tuple[list[ShotFrames], str, Mapping[str, Path]]:
        """The shots of a set, what says so, and its pictures by frame."""
        first = sources[0]
        annotated = annotations_for(first.cameras.frames, first.annotations)
        names = frames_of_all(annotated, (one.cameras.frames for one in sources))
        pictures: dict[str, Path] = {}
        ranges: list[range] = []
        table = self._table(first)
        tracked = next((one.cameras.shots for one in sources if one.cameras.shots), None)
        if self.pictures is not None:
            source = open_pictures(self.pictures)
            pictures = {frame.name: frame.image_path for frame in source.frames}
            if table is None and tracked is None:
                with progress_bar("looking for cuts") as progress:
                    ranges = find_shots(source, progress)
        if table is not None:
            order = FrameOrder.read(table)
            return order.shots_of(names | dict.fromkeys(pictures)), f"by {order.told_by}", pictures
        if tracked is not None:
            order = FrameOrder("the track", tracked, {name: i for i, name in enumerate(tracked)})
            return order.shots_of(names | dict.fromkeys(tracked)), "by the track", pictures
        if ranges:
            return shots_from(ranges, list(pictures)), "by the cuts of the pictures", pictures
        return shots_by_name(names), "by the names of frames", pictures

    def _table(self, first: EvaluationRequest) -> Path | None:
        if self.shots is not None:
            return self.shots
        folder = folder_of_dataset(first.annotations.path)
        beside = None if folder is None else folder / FRAMES_FILE
        return beside if beside is not None and beside.is_file() else None

    def entries(self, found: Sequence[TemporalMetrics]) -> dict[str, Any]:
        """All metrics, for a file."""
        return over_time_entries(found)

    def write(self, found: Sequence[TemporalMetrics], unwritten: dict[Path, ProccError]) -> None:
        """Write the files; what could not be written goes to ``unwritten``."""
        for path in self.written_to:
            if not found:
                unwritten[path] = UsageError(f"{path}: not written, there are no metrics over time")
                continue
            try:
                write_atomic(path, over_time_bytes(found, path))
            except ProccError as error:
                unwritten[path] = error

    def show(self, found: Sequence[TemporalMetrics], unwritten: Collection[Path]) -> None:
        """Print the tables, and the files that were written."""
        console = stdout_console()
        for sheet in terminal_tables(found) if found else ():
            console.print(sheet)
        for path in self.written_to:
            if path not in unwritten:
                echo(f"written: {path}")
