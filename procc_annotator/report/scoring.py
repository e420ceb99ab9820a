"""Score a set once: to files as it goes, and to what the tables need."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from procc_annotator.errors import UsageError
from procc_annotator.io.camera_collection import CameraCollection
from procc_annotator.io.source import FileSource
from procc_annotator.metric.sets import SetSummary
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.report import score_files
from procc_annotator.report.score_files import CsvScores, JsonScores, ScoreWriter
from procc_annotator.report.tables import FrameRow, WorstFrames
from procc_annotator.session.evaluation_run import Evaluated, EvaluationRun, run_digested


@dataclass(frozen=True, slots=True)
class FrameDigest:
    """What is left of a frame once it is written: small, and cheap to send between processes."""

    row: FrameRow | None
    error: str | None
    notices: tuple[str, ...]
    fragments: tuple[bytes, ...]


@dataclass
class Scored:
    """A set's figures and what has to be said about it."""

    summaries: Mapping[float, SetSummary]
    described: str
    frames: int
    with_camera: int
    worst: list[FrameRow]
    errors: list[str] = field(default_factory=list)
    notices: Counter[str] = field(default_factory=Counter)
    unmatched_cameras: tuple[str, ...] = ()

    @property
    def first_threshold(self) -> float:
        """The threshold of the tables that show one only."""
        return next(iter(self.summaries))


Progress = Callable[[Iterable[FrameDigest], int, str], Iterator[FrameDigest]]


def _no_progress(items: Iterable[FrameDigest], _total: int, _what: str) -> Iterator[FrameDigest]:
    return iter(items)


def digest_frame(
    evaluated: Evaluated,
    setup: EvaluationSetup,
    thresholds: tuple[float, ...],
    formats: tuple[str, ...],
) -> FrameDigest:
    """Encode a frame for each output format and keep its row at the first threshold."""
    result = evaluated.result
    fragments = tuple(
        score_files.json_fragment(result)
        if kind == "json"
        else score_files.csv_fragment(result, setup, thresholds)
        for kind in formats
    )
    score = result.scores.get(thresholds[0])
    row = None if score is None else FrameRow.of(result.name, score)
    return FrameDigest(row, result.error, result.notices, fragments)


def score_set(
    annotations: FileSource,
    cameras: CameraCollection,
    setup: EvaluationSetup,
    thresholds: tuple[float, ...],
    *,
    outputs: Sequence[Path] = (),
    camera_size: tuple[int, int] | None = None,
    workers: int = 0,
    progress: Progress = _no_progress,
) -> Scored:
    """Evaluate a set and write its scores, frame by frame.

    Args:
        outputs: ``.json`` and ``.csv`` files; each appears when it is complete.
        progress: wraps the frames as they come, given their number and a word for the work.

    Raises:
        UsageError: nothing to evaluate, or nothing that can be read.
        SaveError: an output cannot be written.
    """
    formats = tuple(score_files.score_format(path) for path in outputs)
    digest = partial(digest_frame, setup=setup, thresholds=thresholds, formats=formats)
    run = run_digested(
        annotations,
        cameras,
        setup,
        thresholds,
        digest,
        camera_size=camera_size,
        workers=workers,
    )
    worst, errors, notices = WorstFrames(), list[str](), Counter[str](run.notices)
    with ExitStack() as files:
        writers: list[ScoreWriter] = []
        for path, kind in zip(outputs, formats, strict=True):
            stream = files.enter_context(score_files.replacing(path))
            writers.append(
                JsonScores(stream, setup, thresholds) if kind == "json" else CsvScores(stream)
            )
            writers[-1].begin()
        for frame in progress(run, run.total, "scoring"):
            if frame.row is not None:
                worst.add(frame.row)
            if frame.error is not None:
                errors.append(frame.error)
            notices.update(frame.notices)
            for writer, fragment in zip(writers, frame.fragments, strict=True):
                writer.add(fragment)
        return _finish(run, writers, worst, errors, notices)


def _finish(
    run: EvaluationRun[FrameDigest],
    writers: list[ScoreWriter],
    worst: WorstFrames,
    errors: list[str],
    notices: Counter[str],
) -> Scored:
    if run.counted == 0:
        raise UsageError(f"none of the {run.total} annotations can be read; the first: {errors[0]}")
    summaries = run.summary()
    for writer in writers:
        writer.end(summaries, ground_only=run.ground_only)
    return Scored(
        summaries,
        run.describe(),
        run.counted,
        run.with_camera,
        worst.rows(),
        errors,
        notices,
        run.unmatched_cameras,
    )
