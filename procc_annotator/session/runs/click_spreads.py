"""What other clicks on the same frames would make of the figures of several sources."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.metric.chance.clicks import AnnotationNoiseSensitivity, annotation_noise_sensitivity
from procc_annotator.metric.chance.distributions import normal_ppf
from procc_annotator.metric.chance.sampling import RatioMetrics, bootstrap
from procc_annotator.metric.polylines import BoolArray, FloatArray
from procc_annotator.session.runs.certainty import Inference
from procc_annotator.session.runs.frame_sums import SPARSE, SPARSE_TAUS, SourceSums


@dataclass(frozen=True, eq=False)
class PairUnderClickNoise:
    """Two sources with the same points moved alike for both.

    Attributes:
        a, b: their places.
        spread: of the difference of mean JaC at each threshold.
        told_apart_from: the least tau at which they differ beyond what chance and clicks make of
            them, px; None where they do at none.
    """

    a: int
    b: int
    spread: AnnotationNoiseSensitivity
    distinguishable_from: float | None


def click_noise_spread(certainty: Inference, source: int) -> AnnotationNoiseSensitivity:
    """Of the mean JaC of a source at each threshold; its frames were judged with moved points."""
    sums = certainty.sources[source]
    own = sums.ratios("mean_jac")
    return _spread(certainty, own, _moved(sums, sums.with_camera), len(certainty.thresholds))


def pairs_under_click_noise(certainty: Inference) -> list[PairUnderClickNoise]:
    """Every two sources."""
    count = len(certainty.thresholds)
    found = []
    for pair in certainty.pairs:
        a, b = certainty.sources[pair.a], certainty.sources[pair.b]
        shared = a.with_camera & b.with_camera
        moved = _moved(a, shared) - _moved(b, shared)
        jac_a, jac_b = (s.ratios("mean_jac").of(shared) for s in (a, b))
        off = RatioMetrics(jac_a.parts - jac_b.parts, jac_a.denominators)
        found.append(
            PairUnderClickNoise(
                pair.a,
                pair.b,
                _spread(certainty, off, moved, count),
                _distinguishable_from(certainty, pair.a, pair.b, moved[..., count:]),
            )
        )
    return found


def _moved(sums: SourceSums, chosen: BoolArray) -> FloatArray:
    """(F, R, T + S) JaC of the frames chosen, all of which have a camera."""
    moved = [f.moved for f, own in zip(sums.frames, chosen, strict=True) if own]
    known = [m for m in moved if m is not None]
    shape = known[0].shape if known else (0, len(sums.thresholds) + len(SPARSE_TAUS))
    return np.array(known, dtype=np.float64).reshape(len(known), *shape)


def _spread(certainty: Inference, own: RatioMetrics, moved: FloatArray, count: int) -> AnnotationNoiseSensitivity:
    return annotation_noise_sensitivity(moved[..., :count], bootstrap(own, certainty.clusters.numbers, None).deviation)


def _distinguishable_from(certainty: Inference, a: int, b: int, moved: FloatArray) -> float | None:
    band = certainty.curve_of_difference(a, b)
    sides = band.beyond_chance[SPARSE]
    clicks = annotation_noise_sensitivity(moved, np.full(len(SPARSE_TAUS), np.nan))
    far = normal_ppf((1 + certainty.draws.level) / 2) * clicks.deviations
    apart = (sides * clicks.means > far) & (sides != 0)
    return float(SPARSE_TAUS[int(np.argmax(apart))]) if apart.any() else None
