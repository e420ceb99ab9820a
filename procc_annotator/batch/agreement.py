"""Compare annotations of two or more annotators frame by frame; confidence intervals."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations
from typing import NamedTuple

import numpy as np
from natsort import natsorted

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.grouping import Clusters
from procc_annotator.batch.set_run import (
    ReopenableHandle,
    SetRun,
    reopenable_source,
    require_annotations,
)
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.file_listing import AnnotationFiles, qualify_by_folder
from procc_annotator.formats.file_source import FileSource
from procc_annotator.metrics.agreement import (
    AgreementAccumulator,
    AgreementSummary,
    FrameAgreement,
    compare_annotations,
)
from procc_annotator.metrics.consensus import Consensus, build_consensus, compare_to_consensus
from procc_annotator.metrics.setup import check_thresholds
from procc_annotator.metrics.statistics.intervals import (
    BootstrapSettings,
    Interval,
    RatioMetrics,
    bootstrap,
    confidence_intervals,
    critical_value,
    quantile_confidence_interval,
)
from procc_annotator.metrics.statistics.significance import required_frames

MAX_ANNOTATORS = 26  # as many as there are letters


class FrameOfAnnotators(NamedTuple):
    """A frame that at least two annotated, with the file of each; None if absent."""

    name: str
    files: tuple[str | None, ...]


@dataclass(frozen=True, slots=True)
class ConsensusResult:
    """Result for one frame; annotators by their places.

    Attributes:
        name: of the frame.
        pairs: every two whose files can be read.
        against_others: each of these against the consensus of all others.
        consensus: of all of them; None where fewer than two can be read, or of pairs alone.
        errors: of the files that cannot.
    """

    name: str
    pairs: Mapping[tuple[int, int], FrameAgreement]
    against_others: Mapping[int, FrameAgreement]
    consensus: Consensus | None
    errors: tuple[str, ...] = ()

    @property
    def agreement(self) -> FrameAgreement | None:
        """The agreement of the first two; None where one of their files cannot be read."""
        return self.pairs.get((0, 1))


@dataclass(frozen=True)
class CompareWithConsensus:
    """Compares chunks of frames; with a consensus, unless pairs alone are asked for."""

    sources: tuple[ReopenableHandle[FileSource], ...]
    field: Field
    size: tuple[int, int]
    pairs_only: bool = False

    def __call__(self, chunk: Sequence[FrameOfAnnotators]) -> tuple[list[ConsensusResult], None]:
        return [self._compare(frame) for frame in chunk], None

    def close(self) -> None:
        """Close what a worker opened."""
        for source in self.sources:
            source.close()

    def _compare(self, frame: FrameOfAnnotators) -> ConsensusResult:
        errors: list[str] = []
        read: dict[int, FrameAnnotation] = {}
        for place, file in enumerate(frame.files):
            if file is None:
                continue
            source = self.sources[place].opened
            try:
                data, shown = source.read(file), source.display(file)
                read[place] = read_annotation(data, path=shown, field=self.field)
            except InputError as error:
                errors.append(str(error))
        if len(read) < 2:
            return ConsensusResult(frame.name, {}, {}, None, tuple(errors))
        compared = partial(compare_annotations, field=self.field, size=self.size)
        pairs = {(a, b): compared(read[a], read[b]) for a, b in combinations(read, 2)}
        if self.pairs_only:
            return ConsensusResult(frame.name, pairs, {}, None, tuple(errors))
        consensus, of_others = build_consensus(list(read.values()), self.field, self.size)
        against_others = {
            place: compare_to_consensus(own, others, self.field, self.size)
            for (place, own), others in zip(read.items(), of_others, strict=True)
        }
        return ConsensusResult(frame.name, pairs, against_others, consensus, tuple(errors))


class ConsensusRun(SetRun[FrameOfAnnotators, ConsensusResult, None]):
    """One pass over the frames that at least two of several annotators have; iterate it first.

    Args:
        sources: folder or archive of annotation files of each annotator, `MOST` at most.
        field: the sports field.
        size: (width, height) in px in which distances are taken.
        thresholds: tau of the JaC, px, at least one.
        pairs_only: whether to compare pairs alone, by the frames' names in each source.

    Attributes:
        alone: for each annotator the frames that no one else has: not compared.

    Raises:
        UsageError: nothing to compare, an invalid threshold or picture size.
        InputError: a folder or archive that cannot be listed.
    """

    def __init__(
        self,
        sources: Sequence[FileSource],
        field: Field,
        size: tuple[int, int],
        thresholds: Sequence[float],
        *,
        pairs_only: bool = False,
    ) -> None:
        if min(size) < 2:
            raise UsageError(f"the size {size[0]}x{size[1]} is too small")
        if not 2 <= len(sources) <= MAX_ANNOTATORS:
            raise UsageError(f"{len(sources)} annotators, expected 2 to {MAX_ANNOTATORS}")
        self.sources, self.field, self.size = tuple(sources), field, size
        self.thresholds = check_thresholds(thresholds)
        files = [require_annotations(source) for source in sources]
        self.files = files if pairs_only else qualify_by_folder(files)
        frames = _frames_of(self.files)
        shared = [frame for frame in frames if len(frame.files) - frame.files.count(None) > 1]
        if not shared:
            named = ", ".join(
                f"{next(iter(own))!r} in {s.path}"
                for own, s in zip(self.files, sources, strict=True)
            )
            raise UsageError(
                f"nothing to do: no frame has annotations of two (names are like {named})"
            )
        kept = tuple(reopenable_source(source) for source in sources)
        super().__init__(shared, CompareWithConsensus(kept, field, size, pairs_only))
        self.alone = tuple(
            tuple(f.name for f in frames if f.files[at] and f.files.count(None) == len(sources) - 1)
            for at in range(len(sources))
        )

    def describe(self) -> str:
        """Return what the numbers depend on, in words."""
        return f"{self.field.described}, {self.size[0]}x{self.size[1]}"


def _frames_of(files: Sequence[AnnotationFiles]) -> list[FrameOfAnnotators]:
    """Every frame once, called as the first has it that has it; in natural order."""
    found = []
    for at, own in enumerate(files):
        for name in own:
            there = [own.called_in(others, name) for others in files]
            if all(called is None for called in there[:at]):
                named = zip(files, there, strict=True)
                paths = (None if called is None else others[called] for others, called in named)
                found.append(FrameOfAnnotators(name, tuple(paths)))
    return natsorted(found, key=lambda frame: frame.name)


class AgreementRun(ConsensusRun):
    """One pass over the frames two annotators have in common; iterate it once.

    Arguments and errors are those of `ConsensusRun`.

    Args:
        among: names of frames of b, where others are not to be compared.
        own: names of frames of a, where nothing is to be reported of others.

    Attributes:
        only_a, only_b: names of the frames only one annotated: reported, not compared.
    """

    def __init__(
        self,
        a: FileSource,
        b: FileSource,
        field: Field,
        size: tuple[int, int],
        thresholds: Sequence[float],
        among: Collection[str] | None = None,
        own: Collection[str] | None = None,
    ) -> None:
        super().__init__((a, b), field, size, thresholds, pairs_only=True)
        self.only_a, self.only_b = self.alone
        if among is not None:
            files = {file for name, file in self.files[1].items() if name in among}
            self.frames = [frame for frame in self.frames if frame.files[1] in files]
        if own is not None:
            self.frames = [frame for frame in self.frames if frame.name in own]
            self.only_a = tuple(name for name in self.only_a if name in own)
        self.alone = self.only_a, self.only_b
        if not self.frames:
            raise UsageError("nothing to do: none of the frames asked for has annotations of both")


def agreement_run(
    sources: Sequence[FileSource], field: Field, size: tuple[int, int], thresholds: Sequence[float]
) -> ConsensusRun:
    """A pass over the frames of two annotators, or of more; as of `ConsensusRun`."""
    if len(sources) == 2:
        return AgreementRun(sources[0], sources[1], field, size, thresholds)
    return ConsensusRun(sources, field, size, thresholds)


@dataclass(frozen=True)
class AgreementIntervals:
    """Intervals of the figures of an agreement; None of fewer than two clusters.

    Attributes:
        jac: tau -> of the mean JaC. median, p95: of the distances, px.
        effective: as many clusters of equal size say as much.
    """

    jac: Mapping[float, Interval | None]
    median: Interval | None
    p95: Interval | None
    effective: float


@dataclass(frozen=True)
class AgreementInference:
    """The figures of an agreement over some frames, and how surely they are known.

    Attributes:
        frames: how many, each counted once.
    """

    summary: AgreementSummary
    known: AgreementIntervals
    frames: int

    def frames_for(self, interval: Interval | None, half: float) -> int | None:
        """Return how many frames like these make an interval, one of `known`, reach ``half`` to
        either side; None without an interval, or where it has no width."""
        if interval is None or not interval.high > interval.low:
            return None
        reached = critical_value(self.known.effective, interval.level)
        deviation = (interval.high - interval.low) / 2 / reached
        # Power 0.5: the interval's half width equals the wanted precision.
        return required_frames(
            half, deviation, self.frames, self.known.effective, level=interval.level, power=0.5
        )


def agreement_inference(
    frames: Sequence[str],
    found: Sequence[tuple[str, FrameAgreement]],
    thresholds: Sequence[float],
    clusters: Clusters,
    draws: BootstrapSettings,
) -> AgreementInference:
    """The figures of agreements of F frames, as ``clusters`` has them, with their intervals;
    several agreements of one frame are alike."""
    sums = AgreementAccumulator(thresholds)
    for name, agreement in found:
        sums.add(name, agreement)
    at = {name: place for place, name in enumerate(frames)}
    places = np.array([at[name] for name, _ in found], dtype=np.intp)
    distances = np.concatenate([np.empty(0), *(one.distances for _, one in found)])
    of_frames = np.repeat(places, [len(one.distances) for _, one in found])
    jacs = {}
    effective = np.nan
    for tau in thresholds:
        own = [one.jac(tau) if one.element_count else np.nan for _, one in found]
        ratios = RatioMetrics.mean(np.array(own, dtype=np.float64))
        sampled = bootstrap(ratios, clusters.numbers[places], None)
        effective = float(sampled.effective[0])
        jacs[float(tau)] = confidence_intervals(sampled, draws)[0]
    median, p95 = (
        quantile_confidence_interval(distances, of_frames, clusters.numbers, share, draws)
        for share in (0.5, 0.95)
    )
    return AgreementInference(
        sums.summary(), AgreementIntervals(jacs, median, p95, effective), len(set(places))
    )
