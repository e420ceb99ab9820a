"""Several sources in order, as far as the data can tell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from procc_annotator.metric.chance.paired import PairedDifference
from procc_annotator.metric.polylines import FloatArray


def significant_ranks(
    count: int, differences: Mapping[tuple[int, int], PairedDifference], better: int
) -> list[int]:
    """The place of each source: one more than those that are better beyond chance.

    Args:
        count: of sources.
        differences: (a, b) -> what a has more than b.
        better: +1 where more is better, -1 where less is.
    """
    beaten = [0] * count
    for (a, b), found in differences.items():
        if found.beyond_chance and found.value is not None:
            beaten[b if found.value * better > 0 else a] += 1
    return [1 + n for n in beaten]


def significantly_best(
    count: int, differences: Mapping[tuple[int, int], PairedDifference], better: int
) -> int | None:
    """The source that is better than every other beyond chance; None if there is none."""
    for one in range(count):
        against = [
            (found, better if a == one else -better)
            for (a, b), found in differences.items()
            if one in (a, b)
        ]
        if len(against) == count - 1 > 0 and all(
            found.beyond_chance and found.value is not None and found.value * sign > 0
            for found, sign in against
        ):
            return one
    return None


def probability_of_best(drawn: Sequence[FloatArray], better: int) -> list[float]:
    """In which share of the sets drawn each source is the best; ties are shared out.

    Args:
        drawn: of each source (B,) its figure in the sets drawn, on the same frames.
        better: as for `ranks`.
    """
    if not drawn:
        return []
    figures = better * np.stack(drawn, axis=1)
    known = figures[np.isfinite(figures).all(axis=1)]
    if not len(known):
        return [0.0] * len(drawn)
    best = known == known.max(axis=1, keepdims=True)
    return [float(share) for share in (best / best.sum(axis=1, keepdims=True)).mean(axis=0)]
