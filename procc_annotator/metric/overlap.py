"""How much of two courses of an element run along each other.

Distances alone cannot tell: of two lines that meet in a corner the clicks at the corner lie close,
and all others may be beyond each other's ends, so nothing that is compared differs. Such lines have
a place in common, but no stretch.
"""

from __future__ import annotations

import numpy as np

from procc_annotator.metric.polylines import FloatArray
from procc_annotator.metric.trace import ClickedCurve

# The shorter course is walked in this many steps.
_OVERLAP_SAMPLES = 100


def curve_overlap(a: ClickedCurve, clicks_a: FloatArray, b: ClickedCurve, clicks_b: FloatArray) -> float:
    """Share of the shorter course's length that runs along the longer one.

    A part runs along as far as its feet on the other advance: a line across another one, or away
    from its end, hardly does, however near it is. Only what lies between clicks counts, not the
    reach beyond them.

    Args:
        a, b: the courses, neither of them a single place.
        clicks_a, clicks_b: (n, 2), (m, 2) px, the clicks they go through.

    Returns:
        0 (at most a place in common) to 1 (the shorter lies all along the longer).
    """
    (own, first, last), (other, low, high) = sorted(
        ((a, *clicked_extent(a, clicks_a)), (b, *clicked_extent(b, clicks_b))), key=lambda c: c[2] - c[1]
    )
    if not last > first:
        return 0.0
    at = _arc_lengths_of(own)
    walked = np.linspace(first, last, _OVERLAP_SAMPLES + 1)
    places = np.column_stack([np.interp(walked, at, own.vertices[:, axis]) for axis in (0, 1)])
    at_other = np.clip(closest_arc_lengths(other, places), low, high)
    advance = np.abs(np.diff(at_other))
    if other.closed:  # past the first vertex they begin anew
        advance = np.minimum(advance, high - low - advance)
    # A foot that jumps to another branch goes no further along than the walk itself.
    advance = np.minimum(advance, (last - first) / _OVERLAP_SAMPLES)
    beside = ~np.isnan(other.distances(places))
    return float(advance[beside[1:] & beside[:-1]].sum() / (last - first))


def clicked_extent(trace: ClickedCurve, clicks: FloatArray) -> tuple[float, float]:
    """Where along a course its first and its last click lie, px from its first vertex."""
    if trace.closed:
        return 0.0, float(_arc_lengths_of(trace)[-1])
    at = closest_arc_lengths(trace, clicks)
    return float(at.min()), float(at.max())


def _arc_lengths_of(trace: ClickedCurve) -> FloatArray:
    """(M,) px along the course to each vertex."""
    return np.concatenate(((0.0,), np.hypot(*np.diff(trace.vertices, axis=0).T).cumsum()))


def closest_arc_lengths(trace: ClickedCurve, points: FloatArray) -> FloatArray:
    """(n,) px along the course to its nearest position to each of (n, 2) points."""
    # Coordinate by coordinate: three times as fast as vectors.
    x, y = trace.vertices.T
    along_x, along_y = np.diff(x), np.diff(y)
    off_x, off_y = points[:, :1] - x[:-1], points[:, 1:] - y[:-1]
    share = (off_x * along_x + off_y * along_y) / (along_x * along_x + along_y * along_y)
    share = np.clip(share, 0.0, 1.0)
    off_x -= share * along_x
    off_y -= share * along_y
    nearest = (off_x * off_x + off_y * off_y).argmin(axis=1)
    at = _arc_lengths_of(trace)
    part = share[np.arange(len(points)), nearest]
    return np.asarray(at[nearest] + part * (at[nearest + 1] - at[nearest]), dtype=np.float64)
