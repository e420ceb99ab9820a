"""Bands about the curves of audits: how surely JaC over tau is known, and its difference."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.metric.chance.bands import CurveBand, curve_band
from procc_annotator.metric.chance.sampling import BootstrapSettings, RatioMetrics, bootstrap
from procc_annotator.metric.polylines import FloatArray
from procc_annotator.session.runs.audit import TAU_GRID, FrameAudit
from procc_annotator.session.runs.clusters import clusters_of
from procc_annotator.session.runs.frame_order import FrameOrder

# Bands are smooth: every 0.5 px is enough, and a few hundredths of a second for a thousand frames.
_EVERY = 5
_DRAWS = BootstrapSettings(1000)


@dataclass(frozen=True, eq=False)
class AuditBand:
    """A curve over `TAU_GRID` with its band.

    Attributes:
        band: the curve.
        frames: how many it is of.
        clustered: what frames are drawn together, in words.
    """

    band: CurveBand
    frames: int
    clustered: str


def mean_band(
    audits: Mapping[str, FrameAudit], frames: Sequence[str], order: FrameOrder | None = None
) -> AuditBand:
    """The mean JaC of a source over the frames that it has.

    Args:
        audits: by frame. frames: all names, in their order.
        order: the dataset's table of frames; without it names tell which ones are of one shot.
    """
    names = [name for name in frames if name in audits]
    return _band([audits[name].jac.astype(np.float64) for name in names], names, 0.0, order)


def difference_band(
    a: Mapping[str, FrameAudit],
    b: Mapping[str, FrameAudit],
    frames: Sequence[str],
    order: FrameOrder | None = None,
) -> AuditBand:
    """What the mean JaC of one source has more than that of another, over the frames of both.

    Args: as of `mean_band`.
    """
    names = [name for name in frames if name in a and name in b]
    off = [a[name].jac.astype(np.float64) - b[name].jac for name in names]
    return _band(off, names, -1.0, order)


def _band(
    curves: Sequence[FloatArray], names: Sequence[str], least: float, order: FrameOrder | None
) -> AuditBand:
    clusters = clusters_of(names, None, {}, order)
    count = len(TAU_GRID)
    if not curves:
        nothing = np.full(count, np.nan)
        return AuditBand(CurveBand(nothing, nothing, nothing), 0, clusters.described)
    every = np.array(curves, dtype=np.float64)
    found = curve_band(bootstrap(RatioMetrics.mean(every[:, ::_EVERY]), clusters.numbers, _DRAWS), _DRAWS)
    values, taus = every.mean(axis=0), TAU_GRID[::_EVERY]
    half = np.interp(TAU_GRID, taus, found.high - found.values)
    low, high = (np.clip(values + sign * half, least, 1.0) for sign in (-1, 1))
    return AuditBand(CurveBand(values, low, high), len(names), clusters.described)
