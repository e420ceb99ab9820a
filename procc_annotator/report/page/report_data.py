"""Evaluated methods of a report, collected once for all its files."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.batch.audit import FrameAudit, audit_frame
from procc_annotator.batch.evaluation import run_evaluation
from procc_annotator.batch.execution.executor import Executor, Progress
from procc_annotator.batch.frame_sums import ClickNoise, FrameSums, SourceSums, frame_sums
from procc_annotator.batch.inference import Inference
from procc_annotator.batch.scoring import Evaluated, LeftOutMetrics
from procc_annotator.errors import UsageError
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts, name_with_mark
from procc_annotator.metrics.score import FrameScore
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.scores.inference import (
    InferenceSettings,
    StatisticalResult,
    statistical_result,
)
from procc_annotator.report.scores.scoring import EvaluationRequest

# Colours, dashes and markers distinguish so many lines, and a page holds as many pictures.
MOST_DETAILED = 12


@dataclass(frozen=True, slots=True)
class FrameMetrics:
    """The figures of one frame at one threshold, as `FrameScore` has them."""

    jac: float
    tp: int
    fp: int
    fn: int
    mirrored: bool
    precision: float | None
    recall: float | None
    mean_reprojection_error: float | None
    mean_error: float | None

    @classmethod
    def of(cls, score: FrameScore) -> FrameMetrics:
        return cls(*(getattr(score, one.name) for one in fields(cls)))


@dataclass(frozen=True, slots=True)
class ReportedFrame:
    """Report entry of one annotated frame under one source.

    Attributes:
        figures: by threshold; empty where there is no score.
        audit: for the charts; None where there is no score.
        error: why annotation or camera could not be read.
        counted: False where the annotation could not be read: then it belongs to no figure.
        notices: remarks about the camera.
        sums: what it adds to the figures of the set; None where it belongs to none.
    """

    name: str
    figures: Mapping[float, FrameMetrics]
    audit: FrameAudit | None
    error: str | None
    counted: bool
    notices: tuple[str, ...]
    sums: FrameSums | None = None


@dataclass(frozen=True, eq=False)
class ReportedSource:
    """A source with its figures.

    Attributes:
        name, folder: what the user calls it, and the name of its folder or file.
        format: of its camera files.
        summaries: by threshold, as `evaluate` has them; empty when nothing could be evaluated.
        described: what the numbers depend on, in words.
        ground_only: whether one of its cameras knows only the ground.
        frames: in natural order, all annotated ones.
        notices: remark on cameras -> number of them; 0 where it is about the set.
        annotation_notes: see `AnnotationNotes`. size_doubt: see `Tally`.
        failure: why nothing could be evaluated; empty when something was.
        fitted: its cameras that were fitted to the annotations they are judged by.
        held_out: what is known of elements left out of these fits.
    """

    name: str
    folder: str
    format: str
    summaries: Mapping[float, SetSummary]
    described: str
    ground_only: bool = False
    frames: tuple[ReportedFrame, ...] = ()
    notices: Mapping[str, int] = field(default_factory=dict)
    unmatched: tuple[str, ...] = ()
    failure: str = ""
    annotation_notes: tuple[str, ...] = ()
    size_doubt: str = ""
    fitted: FitCounts = NOT_FITTED
    held_out: LeftOutMetrics = field(default_factory=LeftOutMetrics)

    @property
    def marked_name(self) -> str:
        """Its name as tables and charts give it next to others."""
        return name_with_mark(self.name, self.fitted)

    @cached_property
    def audits(self) -> dict[str, FrameAudit]:
        """Frame name -> audit, for frames that have a score."""
        return {f.name: f.audit for f in self.frames if f.audit is not None}

    @cached_property
    def model(self) -> str:
        """The cameras' models in words, the most frequent first."""
        models = Counter(audit.model for audit in self.audits.values())
        if len(models) < 2:
            return next(iter(models), "")
        return ", ".join(f"{model} ({count})" for model, count in models.most_common())

    def figures(self, frame: str, threshold: float) -> FrameMetrics | None:
        """A frame's figures; None where it has no score."""
        found = self._by_name.get(frame)
        return None if found is None else found.figures.get(threshold)

    @cached_property
    def _by_name(self) -> dict[str, ReportedFrame]:
        return {frame.name: frame for frame in self.frames}


@dataclass(frozen=True, eq=False)
class AuditReport:
    """A dataset, its sources, and the terms all figures were computed with.

    Attributes:
        dataset: the name of its folder, no path.
        thresholds: px; the first decides colours, the worst frames and the final score.
        chance: how it is asked what is beyond chance.
    """

    dataset: str
    setup: EvaluationSetup
    thresholds: tuple[float, ...]
    sources: tuple[ReportedSource, ...]
    chance: InferenceSettings = field(default_factory=InferenceSettings)

    @property
    def tau(self) -> float:
        """The threshold that decides colours, the worst frames and the final score, px."""
        return self.thresholds[0]

    @property
    def evaluated(self) -> tuple[ReportedSource, ...]:
        """The sources that have figures."""
        return tuple(source for source in self.sources if source.summaries)

    @cached_property
    def frames(self) -> tuple[str, ...]:
        """All frames whose annotation could be read, in natural order."""
        first = self.evaluated[0].frames if self.evaluated else ()
        return tuple(frame.name for frame in first if frame.counted)

    def jac_of_frames(self, source: ReportedSource) -> FloatArray:
        """(F,) JaC of `frames` under a source at `tau`, NaN where there is no score."""
        figures = (source.figures(frame, self.tau) for frame in self.frames)
        return np.array([np.nan if of_frame is None else of_frame.jac for of_frame in figures])

    @cached_property
    def certainty(self) -> Inference:
        """Statistical inference over the evaluated sources."""
        return self.chance.certainty(
            self.dataset,
            [
                SourceSums.of(s.name, self.thresholds, [frame.sums for frame in s.frames])
                for s in self.evaluated
            ],
        )

    @cached_property
    def detailed(self) -> tuple[ReportedSource, ...]:
        """The sources in charts and pictures: all, or of many those with the highest JaC."""
        if len(self.evaluated) <= MOST_DETAILED:
            return self.evaluated
        return tuple(self.evaluated[at] for at in self.certainty.highest(MOST_DETAILED))

    @cached_property
    def statistics(self) -> StatisticalResult:
        """Intervals, tests and ranks of the evaluated sources."""
        return statistical_result(
            self.certainty,
            [source.summaries for source in self.evaluated],
            self.chance,
            (self.dataset, self.setup.field),
            min((source.described for source in self.evaluated), key=len),
        )

    def failures(self) -> list[str]:
        """One line each: sources, annotations and cameras that could not be used."""
        lines = [f"{s.name}: {s.failure}" for s in self.sources if s.failure]
        for source in self.evaluated:
            # What is wrong with an annotation is said once, not for every source.
            lines += [
                f"{source.name}: {frame.error}" if frame.counted else frame.error
                for frame in source.frames
                if frame.error is not None
            ]
        return list(dict.fromkeys(lines))


@dataclass(frozen=True, slots=True)
class ReportWork:
    """Means of evaluating frames: who shares the work (None: no one), who watches, and how points
    are moved where it is asked what clicks leave open."""

    executor: Executor | None = None
    progress: Progress[Any] = lambda items, _total, _what: iter(items)
    noise: ClickNoise | None = None


def gather_report(
    requests: Sequence[EvaluationRequest],
    thresholds: tuple[float, ...],
    work: ReportWork,
    chance: InferenceSettings,
) -> AuditReport:
    """Evaluate methods on a set, exactly as `evaluate` does; the report says why one cannot be.

    Raises:
        UsageError: no source has anything to evaluate.
        InputError: a folder or archive that cannot be listed.
    """
    dataset, annotations, setup = requests[0].set_name, requests[0].annotations, requests[0].setup
    chance = chance.with_poses({dataset: (annotations, setup)}, work.executor)
    work = replace(work, noise=chance.noise)
    reported = [_gather(request, thresholds, work) for request in requests]
    if not any(source.summaries for source in reported):
        raise UsageError(reported[0].failure)
    shown = without_folders([annotations.path, *(one.cameras.path for one in requests)])
    public = tuple(_public(s, shown) for s in reported)
    return AuditReport(dataset, setup, thresholds, public, chance)


def reported_frame(
    evaluated: Evaluated, thresholds: tuple[float, ...], noise: ClickNoise | None = None
) -> ReportedFrame:
    """Return what a report keeps of a frame, made where the frame was scored."""
    result = evaluated.result
    audit = None
    if evaluated.camera is not None and evaluated.measurement is not None:
        audit = audit_frame(
            result.name,
            evaluated.camera,
            evaluated.model,
            evaluated.measurement,
            max(thresholds),
            fitted=result.fitted,
        )
    return ReportedFrame(
        result.name,
        {tau: FrameMetrics.of(score) for tau, score in result.scores.items()},
        audit,
        result.error,
        result.counted,
        result.notices,
        frame_sums(evaluated, thresholds, noise),
    )


def _gather(
    one: EvaluationRequest, thresholds: tuple[float, ...], work: ReportWork
) -> ReportedSource:
    name, folder, fmt = one.method, one.cameras.path.name, one.cameras.format
    try:
        digest = partial(reported_frame, thresholds=thresholds, noise=work.noise)
        run = run_evaluation(
            one.annotations, one.cameras, one.setup, thresholds, digest,
            camera_size=one.camera_size, executor=work.executor,
        )  # fmt: skip
    except UsageError as error:
        return ReportedSource(name, folder, fmt, {}, one.setup.describe(), failure=str(error))
    frames = tuple(work.progress(run, run.total, f"scoring {name}"))
    tally = run.tally
    notices = Counter(run.notices)
    for frame in frames:
        notices.update(frame.notices)
    notices.update(dict.fromkeys(filter(None, [tally.size_doubt]), 0))
    if tally.counted == 0:
        why = f"none of the {run.total} annotations can be read; the first: {frames[0].error}"
        return ReportedSource(name, folder, fmt, {}, one.setup.describe(), failure=why)
    return ReportedSource(
        name,
        folder,
        fmt,
        run.summary(),
        tally.described,
        tally.ground_only,
        frames,
        notices,
        run.unmatched_cameras,
        annotation_notes=tally.notes.lines(),
        size_doubt=tally.size_doubt,
        fitted=tally.fitted,
        held_out=run.held_out,
    )


def without_folders(paths: Iterable[Path]) -> Callable[[str], str]:
    """Shorten paths in texts to names: a report is sent to people who do not have these folders."""
    known = sorted({str(path) for path in paths}, key=len, reverse=True)

    def shown(text: str) -> str:
        for path in known:
            text = text.replace(path, Path(path).name or ".")
        return text

    return shown


def _public(source: ReportedSource, shown: Callable[[str], str]) -> ReportedSource:
    frames = tuple(
        replace(f, error=None if f.error is None else shown(f.error)) for f in source.frames
    )
    notices = {shown(notice): count for notice, count in source.notices.items()}
    return replace(source, frames=frames, notices=notices, failure=shown(source.failure))
