"""Score sets once: to files as it goes, and to what the tables need."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import IO, Any

from procc_annotator.batch.evaluation import EvaluationRun, GroupSummary, run_digested
from procc_annotator.batch.execution.executor import Executor, make_executor
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
from procc_annotator.report.scores.score_files import (
    CsvScores,
    JsonList,
    JsonScores,
    ScoreWriter,
    csv_fragment,
)
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


@dataclass(frozen=True)
class RequestedOutputs:
    """Outputs of an evaluation.

    Attributes:
        outputs: ``.json`` and ``.csv`` files; each appears when it is complete.
        named: whether these say set and method of every evaluation; they have to for several.
        chance: how surely the figures are to be reported; None for not at all.
    """

    outputs: Sequence[Path] = ()
    named: bool = False
    chance: InferenceSettings | None = None

    @property
    def formats(self) -> tuple[str, ...]:
        """Of the outputs."""
        return tuple(score_files.score_format(path) for path in self.outputs)


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
Progress = Callable[[Iterable[Step], int, str], Iterator[Step]]


def _no_progress(items: Iterable[Step], _total: int, _what: str) -> Iterator[Step]:
    return iter(items)


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


def score_set(
    annotations: FileSource,
    cameras: CameraCollection,
    setup: EvaluationSetup,
    thresholds: tuple[float, ...],
    *,
    outputs: Sequence[Path] = (),
    camera_size: tuple[int, int] | None = None,
    executor: Executor | None = None,
    progress: Progress = _no_progress,
) -> Scored:
    """Evaluate a set and write its scores, frame by frame.

    Args:
        outputs: ``.json`` and ``.csv`` files; each appears when it is complete.
        executor: who does the work; unless given, as many processes as suit the set.
        progress: wraps the frames as they come, given their number and a word for the work.

    Raises:
        UsageError: nothing to evaluate, or nothing that can be read.
        SaveError: an output cannot be written.
    """
    asked = EvaluationRequest("", "", annotations, cameras, setup, camera_size=camera_size)
    prepared = Evaluations.prepare([asked], thresholds, RequestedOutputs(outputs))
    if executor is not None:
        return prepared.score(executor, progress=progress)[0]
    with make_executor(frames=prepared.frames) as suitable:
        return prepared.score(suitable, progress=progress)[0]


@dataclass
class Evaluations:
    """Several evaluations, listed and found possible; then scored, one after the other."""

    scorings: list[_Scoring]
    outcome: RequestedOutputs
    told: tuple[StatisticalResult, ...] = ()  # what chance leaves of them, once they are scored

    @classmethod
    def prepare(
        cls,
        asked: Sequence[EvaluationRequest],
        thresholds: tuple[float, ...],
        outcome: RequestedOutputs,
    ) -> Evaluations:
        """List all frames, before any work.

        Raises:
            UsageError: an evaluation has nothing to do.
        """
        prepared = cls([_Scoring(one, thresholds, outcome) for one in asked], outcome)
        prepared._require_tags(asked)
        return prepared

    def _require_tags(self, asked: Sequence[EvaluationRequest]) -> None:
        if all(by == MODEL for one in asked for by in one.grouping.by):
            return
        if any(scoring.run.tagged for scoring in self.scorings):
            return
        tagged = next((repr(frame) for one in asked for frame in one.grouping.values), "none")
        frame = self.scorings[0].run.names[0]
        raise UsageError(
            "no tag belongs to a frame of these sets"
            f" (frames are named like {frame!r}, in the file of tags like {tagged})"
        )

    @property
    def frames(self) -> int:
        """Number of frames to score, over all evaluations."""
        return sum(scoring.run.total for scoring in self.scorings)

    def score(
        self,
        executor: Executor | None = None,
        *,
        progress: Progress = _no_progress,
        unwritten: dict[Path, ProccError] | None = None,
    ) -> list[Scored]:
        """Do the work.

        Args:
            unwritten: takes what went wrong with an output on the way, so that the figures are not
                lost with them; without it the first failure is raised.

        Raises:
            UsageError: no annotation of a set can be read.
            SaveError: an output cannot be written.
        """
        failures: dict[Path, ProccError] = {} if unwritten is None else unwritten
        with ExitStack() as files:
            paths = self.outcome.outputs
            streams = [
                files.enter_context(failure_tolerant_output(path, failures)) for path in paths
            ]
            for scoring, frame in progress(self._steps(streams, executor), self.frames, "scoring"):
                scoring.take(frame)
        if unwritten is None and failures:
            raise next(iter(failures.values()))
        return [scoring.scored for scoring in self.scorings]

    def _steps(self, streams: list[IO[bytes]], executor: Executor | None) -> Iterator[Step]:
        formats = self.outcome.formats
        lists = [
            JsonList(stream)
            for stream, kind in zip(streams, formats, strict=True)
            if kind == "json" and self.outcome.named
        ]
        for i, scoring in enumerate(self.scorings):
            for several in lists:
                several.next()
            scoring.begin(streams, first=i == 0)
            if executor is not None:
                scoring.run.executor = executor
            for frame in scoring.run:
                yield scoring, frame
            scoring.sum_up()
            if scoring is self.scorings[-1] and self.outcome.chance is not None:
                scored = [one.scored for one in self.scorings]
                self.told = tuple(statistical_results(scored, self.outcome.chance))
            # In a file of several, what is reported of all follows behind them.
            scoring.write_end({} if self.outcome.named else inference_entries(self.told))
        for several in lists:
            several.end(inference_entries(self.told))


class _Scoring:
    """One evaluation under way."""

    def __init__(
        self,
        asked: EvaluationRequest,
        thresholds: tuple[float, ...],
        outcome: RequestedOutputs,
    ) -> None:
        self._asked = asked
        self._thresholds = thresholds
        self._outcome = outcome
        self._names = (asked.set_name, asked.method) if outcome.named else ()
        digest = partial(
            encode_frame,
            setup=asked.setup,
            thresholds=thresholds,
            formats=outcome.formats,
            names=self._names,
            by=asked.grouping.by,
            chance=outcome.chance,
        )
        self.run: EvaluationRun[EncodedFrame] = run_digested(
            asked.annotations,
            asked.cameras,
            asked.setup,
            thresholds,
            digest,
            camera_size=asked.camera_size,
            grouping=asked.grouping,
        )
        self._writers: list[ScoreWriter] = []
        self._worst = WorstFrames()
        self._errors: list[str] = []
        self._notices = Counter[str](self.run.notices)
        self._sums: list[FrameSums | None] = []
        self.scored: Scored

    def begin(self, streams: Iterable[IO[bytes]], *, first: bool) -> None:
        """Write the beginning of the outputs."""
        for stream, kind in zip(streams, self._outcome.formats, strict=True):
            self._writers.append(self._writer(stream, kind, first))
            self._writers[-1].begin()

    def _writer(self, stream: IO[bytes], kind: str, first: bool) -> ScoreWriter:
        columns = ("set", "method")[: len(self._names)]
        if kind == "json":
            names = dict(zip(columns, self._names, strict=True))
            return JsonScores(stream, self._asked.setup, self._thresholds, names)
        return CsvScores(stream, columns, self._asked.grouping.by, headless=not first)

    def take(self, frame: EncodedFrame) -> None:
        """Write a frame and note what the tables need of it."""
        if frame.row is not None:
            self._worst.add(frame.row)
        if frame.error is not None:
            self._errors.append(frame.error)
        self._notices.update(frame.notices)
        self._sums.append(frame.sums)
        for writer, fragment in zip(self._writers, frame.fragments, strict=True):
            writer.add(fragment)

    def sum_up(self) -> None:
        """Make the figures; all frames have been taken."""
        run = self.run
        if run.counted == 0:
            raise UsageError(
                f"none of the {run.total} annotations can be read; the first: {self._errors[0]}"
            )
        self.scored = Scored(
            run.summary(),
            run.setup,
            run.describe(),
            run.counted,
            run.with_camera,
            self._worst.rows(),
            self._errors,
            self._notices,
            run.unmatched_cameras,
            self._asked.set_name,
            self._asked.method,
            run.group_summaries(),
            run.annotation_notes,
            SourceSums.of(self._asked.method, self._thresholds, self._sums),
            run.fitted,
            run.held_out,
            run.ground_only,
        )

    def write_end(self, more: Mapping[str, Any]) -> None:
        """Write the end of the outputs, with more entries where they hold any."""
        scored, groups = self.scored, self.scored.groups
        more = {**left_out_entry(scored, self._thresholds), **more}
        for writer in self._writers:
            writer.end(scored.summaries, ground_only=scored.ground_only, groups=groups, more=more)
