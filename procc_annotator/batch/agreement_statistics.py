"""Confidence intervals of inter-annotator agreement, and errors against reference frames."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.batch.agreement import ConsensusResult
from procc_annotator.batch.grouping import Clusters
from procc_annotator.metrics.agreement import (
    AgreementAccumulator,
    AgreementSummary,
    FrameAgreement,
    sorted_quantile,
)
from procc_annotator.metrics.statistics.bootstrap import BootstrapSettings, RatioMetrics, bootstrap
from procc_annotator.metrics.statistics.intervals import (
    Interval,
    confidence_intervals,
    critical_value,
    quantile_confidence_interval,
)
from procc_annotator.metrics.statistics.significance import Trend, required_frames, trend_test


@dataclass(frozen=True)
class AgreementIntervals:
    """Intervals of the figures of an agreement; None of fewer than two clusters.

    Attributes:
        jac: tau -> of the mean JaC. median, p95: of the distances, px.
        effective: as many clusters of equal size tell as much.
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
        """How many frames like these make an interval reach so far to either side.

        Args:
            interval: one of `known`.
            half: in its unit, above 0.

        Returns:
            None without an interval, or where it has no width.
        """
        if interval is None or not interval.high > interval.low:
            return None
        reached = critical_value(self.known.effective, interval.level)
        deviation = (interval.high - interval.low) / 2 / reached
        # What is to be known to so much is not to be told from anything: chance of one in two.
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
    """The figures of agreements with their intervals.

    Args:
        frames: F names, as `clusters` has them.
        found: agreements with the frame that each is of; several of one frame are alike.
        thresholds: tau, px. draws: says the level.
    """
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


THIRDS = ("first", "middle", "last")


@dataclass(frozen=True)
class ReferenceFrame:
    """One gold frame as somebody annotated it.

    Attributes:
        agreement: of the annotator with the answer.
        time: when the last of its points came to be, seconds since 1970; None where nothing tells.
    """

    name: str
    agreement: FrameAgreement
    time: float | None

    @property
    def median(self) -> float | None:
        """Of the distances, px; None where there is none."""
        return sorted_quantile(np.sort(self.agreement.distances), 0.5)


@dataclass(frozen=True)
class ReferenceErrors:
    """An annotator against gold.

    Attributes:
        frames: in the order of work; those without a time after the others, by name.
        sure: the figures of all. thirds: those of each third of the frames, in that order.
        trend: of the frames' medians, px from one frame to the next.
    """

    frames: tuple[ReferenceFrame, ...]
    sure: AgreementInference
    thirds: tuple[AgreementInference, ...]
    trend: Trend | None

    @property
    def timed(self) -> bool:
        """Whether the order of work is known of all frames."""
        return all(frame.time is not None for frame in self.frames)


def reference_errors(
    results: Sequence[ConsensusResult],
    times: Mapping[str, float],
    thresholds: Sequence[float],
    clusters: Clusters,
    draws: BootstrapSettings,
) -> ReferenceErrors | None:
    """The errors of one annotator; None where none of the frames can be read.

    Args:
        results: of the gold frames, in the order of `clusters`.
        times: of frames, seconds since 1970.
        thresholds: tau, px.
        clusters: of the frames of ``results``. draws: of trends, and the level of intervals.
    """
    names = [result.name for result in results]
    found = [
        ReferenceFrame(result.name, result.agreement, times.get(result.name))
        for result in results
        if result.agreement is not None
    ]
    if not found:
        return None
    at = {name: place for place, name in enumerate(names)}
    found.sort(key=lambda one: (one.time is None, one.time or 0.0, at[one.name]))

    def sure(frames: Sequence[ReferenceFrame]) -> AgreementInference:
        pairs = [(frame.name, frame.agreement) for frame in frames]
        return agreement_inference(names, pairs, thresholds, clusters, draws)

    timed = all(frame.time is not None for frame in found)
    count = len(found)
    parts = [found[n * count // 3 : (n + 1) * count // 3] for n in range(3)] if timed else []
    medians = [frame.median for frame in found]
    known = np.array([median for median in medians if median is not None])
    return ReferenceErrors(
        tuple(found),
        sure(found),
        tuple(sure(part) for part in parts if part) if count >= len(THIRDS) else (),
        trend_test(known, draws) if timed else None,
    )
