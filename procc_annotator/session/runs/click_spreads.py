"""What other clicks on the same frames would make of the figures of several sources."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.metric.chance.clicks import ClickSpread, click_spread
from procc_annotator.metric.chance.distributions import normal_quantile
from procc_annotator.metric.chance.sampling import Ratios, sample
from procc_annotator.metric.polylines import BoolArray, FloatArray
from procc_annotator.session.runs.certainty import Certainty
from procc_annotator.session.runs.frame_sums import SPARSE, SPARSE_TAUS, SourceSums


@dataclass(frozen=True, eq=False)
class PairUnderClicks:
    """Two sources with the same points moved alike for both.

    Attributes:
        a, b: their places.
        spread: of the difference of mean JaC at each threshold.
        told_apart_from: the least tau at which they differ beyond what chance and clicks make of
            them, px; None where they do at none.
    """

    a: int
    b: int
    spread: ClickSpread
    told_apart_from: float | None


def spread_of(certainty: Certainty, source: int) -> ClickSpread:
    """Of the mean JaC of a source at each threshold; its frames were judged with moved points."""
    sums = certainty.sources[source]
    own = sums.ratios("mean_jac")
    return _spread(certainty, own, _moved(sums, sums.with_camera), len(certainty.thresholds))


def pairs_under_clicks(certainty: Certainty) -> list[PairUnderClicks]:
    """Every two sources."""
    count = len(certainty.thresholds)
    found = []
    for pair in certainty.pairs:
        a, b = certainty.sources[pair.a], certainty.sources[pair.b]
        shared = a.with_camera & b.with_camera
        moved = _moved(a, shared) - _moved(b, shared)
        jac_a, jac_b = (s.ratios("mean_jac").of(shared) for s in (a, b))
        off = Ratios(jac_a.parts - jac_b.parts, jac_a.wholes)
        found.append(
            PairUnderClicks(
                pair.a,
                pair.b,
                _spread(certainty, off, moved, count),
                _told_apart_from(certainty, pair.a, pair.b, moved[..., count:]),
            )
        )
    return found


def _moved(sums: SourceSums, chosen: BoolArray) -> FloatArray:
    """(F, R, T + S) JaC of the frames chosen, all of which have a camera."""
    moved = [f.moved for f, own in zip(sums.frames, chosen, strict=True) if own]
    known = [m for m in moved if m is not None]
    shape = known[0].shape if known else (0, len(sums.thresholds) + len(SPARSE_TAUS))
    return np.array(known, dtype=np.float64).reshape(len(known), *shape)


def _spread(certainty: Certainty, own: Ratios, moved: FloatArray, count: int) -> ClickSpread:
    return click_spread(moved[..., :count], sample(own, certainty.clusters.numbers, None).deviation)


def _told_apart_from(certainty: Certainty, a: int, b: int, moved: FloatArray) -> float | None:
    band = certainty.curve_of_difference(a, b)
    sides = band.beyond_chance[SPARSE]
    clicks = click_spread(moved, np.full(len(SPARSE_TAUS), np.nan))
    far = normal_quantile((1 + certainty.draws.level) / 2) * clicks.deviations
    apart = (sides * clicks.means > far) & (sides != 0)
    return float(SPARSE_TAUS[int(np.argmax(apart))]) if apart.any() else None
