"""How far annotators are from gold frames, in the order they worked on them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.metric.agreement import FrameAgreement, sorted_quantile
from procc_annotator.metric.chance.sampling import BootstrapSettings
from procc_annotator.metric.chance.trend import Trend, trend_test
from procc_annotator.session.runs.clusters import Clusters
from procc_annotator.session.runs.consensus_run import ConsensusResult
from procc_annotator.session.runs.sure_agreement import AgreementInference, agreement_inference

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
