"""Confidence intervals of inter-annotator agreement, and errors against reference frames."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.batch.grouping import Clusters
from procc_annotator.metrics.agreement import AgreementAccumulator, AgreementSummary, FrameAgreement
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
        """Return how many frames like these make an interval reach so far to either side.

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
