"""Score sets once: to files as it goes, and to what the tables need."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import IO, Any

from procc_annotator.batch.evaluation import EvaluationRun, GroupSummary, run_evaluation
from procc_annotator.batch.execution.executor import Executor, Progress
from procc_annotator.batch.frame_sums import FrameSums, SourceSums, frame_sums
from procc_annotator.batch.grouping import MODEL, Grouping
from procc_annotator.batch.scoring import Evaluated, LeftOutMetrics
from procc_annotator.errors import ProccError, UsageError
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts
from procc_annotator.formats.file_source import FileSource
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.outputs import failure_tolerant_output
from procc_annotator.report.scores import score_files
from procc_annotator.report.scores.inference import (
    InferenceSettings,
    StatisticalResult,
    inference_entries,
    statistical_results,
)
from procc_annotator.report.scores.score_files import CsvScores, JsonList, JsonScores, csv_fragment
from procc_annotator.report.scores.score_tables import FrameRow, WorstFrames, left_out_entry


@dataclass(frozen=True, slots=True)
class EncodedFrame:
    """Digest of a scored frame: small, and cheap to send between processes."""

    row: FrameRow | None
    error: str | None
    notices: tuple[str, ...]
    fragments: tuple[bytes, ...]
    sums: FrameSums | None = None


@dataclass(frozen=True, eq=False)
class EvaluationRequest:
    """One evaluation: a set's annotations, a method's cameras, and how both are compared.

    ``camera_size`` is the picture size the cameras refer to, where their files do not say.
    """

    set_name: str
    method: str
    annotations: FileSource
    cameras: CameraCollection
    setup: EvaluationSetup
    grouping: Grouping = field(default_factory=Grouping)
    camera_size: tuple[int, int] | None = None


@dataclass
class Scored:
    """A set's figures and what has to be said about it."""

    summaries: Mapping[float, SetSummary]
    setup: EvaluationSetup
    described: str
    frames: int
    with_camera: int
    worst: list[FrameRow]
    errors: list[str] = field(default_factory=list)
    notices: Counter[str] = field(default_factory=Counter)
    unmatched_cameras: tuple[str, ...] = ()
    set_name: str = ""
    method: str = ""
    groups: tuple[GroupSummary, ...] = ()
    annotation_notes: tuple[str, ...] = ()
    sums: SourceSums | None = None
    fitted: FitCounts = NOT_FITTED
    held_out: LeftOutMetrics = field(default_factory=LeftOutMetrics)
    ground_only: bool = False

    @property
    def first_threshold(self) -> float:
        """The threshold of the tables that show one only."""
        return next(iter(self.summaries))


Step = tuple["_Scoring", EncodedFrame]


def encode_frame(
    evaluated: Evaluated,
    setup: EvaluationSetup,
    thresholds: tuple[float, ...],
    formats: tuple[str, ...],
    names: tuple[str, ...] = (),
    by: tuple[str, ...] = (),
    chance: InferenceSettings | None = None,
) -> EncodedFrame:
    """Encode a frame for each output format and keep its row at the first threshold."""
    result = evaluated.result
    fragments = tuple(
        score_files.json_fragment(result, by)
        if kind == "json"
        else csv_fragment(result, setup, thresholds, names)
        for kind in formats
    )
    row = None
    if result.scores:  # as they are written, also where mirrored labels count on a tie
        row = FrameRow.of(result.name, result.scores[thresholds[0]])
    sums = None if chance is None else frame_sums(evaluated, thresholds, chance.noise)
    return EncodedFrame(row, result.error, result.notices, fragments, sums)


class Evaluations:
    """Several evaluations; all frames are listed before any work.

    Args:
        thresholds: px.
        outputs: ``.json`` and ``.csv`` files; each appears when it is complete.
        named: whether these name set and method of every evaluation; they have to for several.
        settings: of statistical inference; None for no intervals.

    Attributes:
        results: of statistical inference, once the frames are scored.

    Raises:
        UsageError: an evaluation has nothing to do.
    """

    def __init__(
        self,
        requests: Sequence[EvaluationRequest],
        thresholds: tuple[float, ...],
        outputs: Sequence[Path] = (),
        *,
        named: bool = False,
        settings: InferenceSettings | None = None,
    ) -> None:
        self._outputs, self._named, self._settings = outputs, named, settings
        self._formats = tuple(map(score_files.score_format, outputs))
        self._scorings = [
            _Scoring(one, thresholds, self._formats, named, settings) for one in requests
        ]
        self.results: tuple[StatisticalResult, ...] = ()
        by_tags = any(by != MODEL for one in requests for by in one.grouping.by)
        if by_tags and not any(scoring.run.tagged for scoring in self._scorings):
            tagged = next(
                (repr(frame) for one in requests for frame in one.grouping.values), "none"
            )
            frame = self._scorings[0].run.names[0]
            raise UsageError(
                "no tag belongs to a frame of these sets"
                f" (frames are named like {frame!r}, in the file of tags like {tagged})"
            )

    @property
    def frames(self) -> int:
        """Number of frames to score, over all evaluations."""
        return sum(scoring.run.total for scoring in self._scorings)

    def score(
        self, executor: Executor, progress: Progress[Step], unwritten: dict[Path, ProccError]
    ) -> list[Scored]:
        """Do the work.

        Args:
            unwritten: takes the failures of outputs, so that no metrics are lost with them.

        Raises:
            UsageError: no annotation of a set can be read.
        """
        if self._settings is not None:
            sets = {s.request.set_name: s.request for s in reversed(self._scorings)}
            inputs = {name: (one.annotations, one.setup) for name, one in sets.items()}
            self._settings = self._settings.with_poses(inputs, executor)
        with ExitStack() as files:
            streams = [
                files.enter_context(failure_tolerant_output(path, unwritten))
                for path in self._outputs
            ]
            for scoring, frame in progress(self._steps(streams, executor), self.frames, "scoring"):
                scoring.take(frame)
        return [scoring.scored for scoring in self._scorings]

    def _steps(self, streams: list[IO[bytes]], executor: Executor) -> Iterator[Step]:
        lists = [
            JsonList(stream)
            for stream, kind in zip(streams, self._formats, strict=True)
            if kind == "json" and self._named
        ]
        for i, scoring in enumerate(self._scorings):
            for several in lists:
                several.next()
            scoring.begin(streams, first=i == 0)
            scoring.run.executor = executor
            for frame in scoring.run:
                yield scoring, frame
            scoring.sum_up()
            if scoring is self._scorings[-1] and self._settings is not None:
                scored = [one.scored for one in self._scorings]
                self.results = tuple(statistical_results(scored, self._settings))
            # In a file of several, what is reported of all follows behind them.
            scoring.write_end({} if self._named else inference_entries(self.results))
        for several in lists:
            several.end(inference_entries(self.results))


class _Scoring:
    """One evaluation in progress."""

    def __init__(
        self,
        request: EvaluationRequest,
        thresholds: tuple[float, ...],
        formats: tuple[str, ...],
        named: bool,
        settings: InferenceSettings | None,
    ) -> None:
        self.request = request
        self._thresholds = thresholds
        self._formats = formats
        self._names = {"set": request.set_name, "method": request.method} if named else {}
        digest = partial(
            encode_frame, setup=request.setup, thresholds=thresholds, formats=formats,
            names=tuple(self._names.values()), by=request.grouping.by, chance=settings,
        )  # fmt: skip
        self.run: EvaluationRun[EncodedFrame] = run_evaluation(
            request.annotations, request.cameras, request.setup, thresholds, digest,
            camera_size=request.camera_size, grouping=request.grouping,
        )  # fmt: skip
        self._writers: list[JsonScores | CsvScores] = []
        self._worst = WorstFrames()
        self._errors: list[str] = []
        self._notices = Counter[str](self.run.notices)
        self._sums: list[FrameSums | None] = []
        self.scored: Scored

    def begin(self, streams: Iterable[IO[bytes]], *, first: bool) -> None:
        """Write the beginning of the outputs."""
        for stream, kind in zip(streams, self._formats, strict=True):
            self._writers.append(
                JsonScores(stream, self.request.setup, self._thresholds, self._names)
                if kind == "json"
                else CsvScores(stream, self._names, self.request.grouping.by, headless=not first)
            )
            self._writers[-1].begin()

    def take(self, frame: EncodedFrame) -> None:
        """Write a frame and keep what the tables need of it."""
        if frame.row is not None:
            self._worst.add(frame.row)
        if frame.error is not None:
            self._errors.append(frame.error)
        self._notices.update(frame.notices)
        self._sums.append(frame.sums)
        for writer, fragment in zip(self._writers, frame.fragments, strict=True):
            writer.add(fragment)

    def sum_up(self) -> None:
        """Compute the metrics; all frames have been taken."""
        run, request, tally = self.run, self.request, self.run.tally
        self._notices.update(filter(None, [tally.size_doubt]))
        if tally.counted == 0:
            raise UsageError(
                f"none of the {run.total} annotations can be read; the first: {self._errors[0]}"
            )
        self.scored = Scored(
            run.summary(), run.setup, tally.described, tally.counted, tally.with_camera,
            self._worst.rows(), self._errors, self._notices, run.unmatched_cameras,
            request.set_name, request.method, run.group_summaries(), tally.notes.lines(),
            SourceSums.of(request.method, self._thresholds, self._sums), tally.fitted, run.held_out,
            tally.ground_only,
        )  # fmt: skip

    def write_end(self, more: Mapping[str, Any]) -> None:
        """Write the end of the outputs, with more entries where they have any."""
        scored = self.scored
        more = {**scored.fitted.entry(), **left_out_entry(scored, self._thresholds), **more}
        if scored.annotation_notes:
            more["annotation_notes"] = list(scored.annotation_notes)
        for writer in self._writers:
            writer.end(
                scored.summaries, ground_only=scored.ground_only, groups=scored.groups, more=more
            )
